//! The public cases of pins over a conveyor and what independent exact implementations answered.

use super::cases::{number, numbers};
use super::topple::Conveyed;
use partplan::answer::PinAction;
use partplan::exact::{Q, to_f64};
use partplan::geometry::Polygon;
use partplan::model::{Conveyor, LengthUnit, Part, Range, Shape};
use serde_json::Value;

pub const NAMES: [&str; 15] = [
    "com_exactly_over_left_vertex",
    "hexagon_order_2",
    "kite",
    "paper_fit_free_friction",
    "paper_fit_stated_friction",
    "paper_fit_within_2_degrees",
    "parallelogram_left",
    "pentagon",
    "pentagon_no_pin_friction",
    "pentagon_pin_rougher_than_belt",
    "rectangle_offset_com",
    "square",
    "three_pins",
    "triangle_345",
    "triangle_obtuse_unstable_edge",
];

/// A part, a conveyor, and what is expected of them.
pub struct Public {
    pub name: &'static str,
    pub part: Part,
    pub conveyor: Conveyor,
    pub oracle: Conveyed,
    pub expected: Value,
}

pub fn all() -> impl Iterator<Item = Public> {
    NAMES.into_iter().map(public)
}

pub fn text(file: &str) -> String {
    let path = format!("{}/tests/topple/{file}.json", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"))
}

pub fn json(file: &str) -> Value {
    serde_json::from_str(&text(file)).unwrap_or_else(|error| panic!("{file}: {error}"))
}

pub fn public(name: &'static str) -> Public {
    let expected = json(&format!("{name}.expected"));
    let outline: Vec<[Q; 2]> =
        json(name)["part"]["shape"]["polygon"].as_array().expect("a polygon").iter().map(point).collect();
    let center = point(&expected["center_of_mass"]);
    let [belt, pin] = ["belt_friction", "pin_friction"].map(|key| number(&expected[key]));
    let oracle = Conveyed::new(&outline, &center, &belt, &pin);
    let conveyor = Conveyor { belt_friction: Range::exactly(belt), pin_friction: Range::exactly(pin) };
    Public { name, part: part(&outline, &center), conveyor, oracle, expected }
}

pub fn part(outline: &[[Q; 2]], center: &[Q; 2]) -> Part {
    let [one, none] = [1, 0].map(super::int);
    Part {
        unit: LengthUnit::Metre,
        shape: Shape::Polygon(Polygon::new(outline.to_vec()).expect("a simple polygon")),
        center_of_mass: center.clone(),
        center_of_mass_tolerance: none,
        mass: one.clone(),
        inertia: one,
    }
}

pub fn point(value: &Value) -> [Q; 2] {
    numbers(value).try_into().expect("two numbers")
}

pub fn list(value: &Value) -> &[Value] {
    value.as_array().unwrap_or_else(|| panic!("{value} is not a list"))
}

/// A list that cases leave out where it has no members.
pub fn optional(value: &Value) -> &[Value] {
    if value.is_null() { &[] } else { list(value) }
}

pub fn edge(value: &Value) -> usize {
    value.as_u64().and_then(|edge| edge.try_into().ok()).expect("an edge")
}

pub fn edges(value: &Value) -> Vec<usize> {
    list(value).iter().map(edge).collect()
}

pub fn action(value: &Value) -> PinAction {
    let actions = [PinAction::PassUnder, PinAction::FallBack, PinAction::Jam, PinAction::Repeat, PinAction::Pass];
    actions.into_iter().find(|action| Some(action.name()) == value.as_str()).expect("an action")
}

/// A height that is enclosed, to nearest.
pub fn height(value: &Value) -> f64 {
    to_f64(&number(&value[0]))
}
