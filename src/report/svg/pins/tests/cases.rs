//! Public cases with the answers of an independent exact implementation, as answers to be drawn.

use super::curves::curves;
use crate::answer::{ActionInterval, Obstacle, Orientation, Pin, PinAction, PinPlan, Pins, Symmetry, ToppleInterval};
use crate::exact::{Algebraic, Q, Z, parse_literal, to_f64};
use crate::geometry::Polygon;
use crate::model::{Conveyor, LengthUnit, Part, Range, Shape};
use crate::report::Ride;
use serde_json::Value;
use std::collections::BTreeMap;

/// What there is to draw, with what it is about.
pub(super) struct Drawn {
    pub(super) name: String,
    pub(super) part: Part,
    pub(super) conveyor: Conveyor,
    pub(super) answer: Pins,
}

impl Drawn {
    pub(super) fn svg(&self) -> String {
        let Self { name, part, conveyor, answer } = self;
        let ride = Ride { name, part, conveyor, warnings: &[], end: None, max_pins: None };
        super::super::pins(&ride, answer)
    }

    pub(super) fn edges(&self) -> Vec<usize> {
        self.answer.stable.clone()
    }
}

macro_rules! case {
    ($name:literal) => {
        build(
            $name,
            include_str!(concat!("../../../../../tests/topple/", $name, ".json")),
            include_str!(concat!("../../../../../tests/topple/", $name, ".expected.json")),
        )
    };
}

pub(super) fn three_pins() -> Drawn {
    case!("three_pins")
}

pub(super) fn all() -> [Drawn; 4] {
    [three_pins(), case!("pentagon"), case!("hexagon_order_2"), case!("paper_fit_free_friction")]
}

pub(super) fn part(unit: LengthUnit, vertices: Vec<[Q; 2]>, center_of_mass: [Q; 2]) -> Part {
    Part {
        unit,
        shape: Shape::Polygon(Polygon::new(vertices).expect("a polygon")),
        center_of_mass,
        center_of_mass_tolerance: q("0"),
        mass: q("1"),
        inertia: q("1"),
    }
}

pub(super) fn conveyor(belt: Q, pin: Q) -> Conveyor {
    Conveyor { belt_friction: Range::exactly(belt), pin_friction: Range::exactly(pin) }
}

pub(super) fn q(text: &str) -> Q {
    parse_literal(text).expect("a number")
}

fn build(name: &str, case: &str, expected: &str) -> Drawn {
    let [case, expected]: [Value; 2] = [case, expected].map(|text| serde_json::from_str(text).expect("JSON"));
    let unit = if case["length_unit"] == "cm" { LengthUnit::Centimetre } else { LengthUnit::Metre };
    let hull: Vec<[Q; 2]> = list(&expected["hull"]).map(point).collect();
    let com = point(&expected["center_of_mass"]);
    let conveyor = conveyor(number(&expected["belt_friction"]), number(&expected["pin_friction"]));
    let orientations: Vec<Orientation> =
        list(&expected["orientations"]).map(|value| orientation(value, &hull, &com)).collect();
    let answer = Pins {
        stable: edges(&expected["stable"]),
        symmetry: Symmetry {
            shift: index(&expected["symmetry"]["shift"]),
            classes: list(&expected["symmetry"]["classes"]).map(edges).collect(),
        },
        plan: plan(&expected["plan"], &orientations),
        queries: Vec::new(),
        decisions: crate::answer::Decisions::default(),
        hull: hull.clone(),
        orientations,
    };
    Drawn { name: name.to_owned(), part: part(unit, hull, com), conveyor, answer }
}

fn orientation(value: &Value, hull: &[[Q; 2]], com: &[Q; 2]) -> Orientation {
    let (edge, theta_1_deg) = (index(&value["edge"]), value["theta_1_deg"].as_f64().expect("degrees"));
    let near = |point: &[Q; 2]| point.each_ref().map(to_f64);
    Orientation {
        edge,
        next: index(&value["next"]),
        pivots: edges(&value["pivots"]),
        theta_t_deg: value["theta_t_deg"].as_f64().expect("degrees"),
        theta_1_deg,
        height: height(&value["height"]),
        intervals: list(&value["intervals"])
            .map(|value| ActionInterval {
                from: height(&value["from"]),
                to: (!value["to"].is_null()).then(|| height(&value["to"])),
                action: Some(action(value["action"].as_str().expect("an action"))),
            })
            .collect(),
        topple: list(&value["topple"])
            .map(|value| ToppleInterval {
                edge: index(&value["edge"]),
                from: height(&value["from"]),
                to: height(&value["to"]),
            })
            .collect(),
        repeat_over_dip: value["repeat_over_dip"].as_array().map(|ends| [height(&ends[0]), height(&ends[1])]),
        curves: curves(&hull.iter().map(near).collect::<Vec<_>>(), near(com), edge, theta_1_deg),
    }
}

fn plan(value: &Value, orientations: &[Orientation]) -> PinPlan {
    let sequence = value["sequence"].as_array().map(|pins| pins.iter().map(|value| pin(value, orientations)).collect());
    let end = sequence.as_ref().and_then(|pins: &Vec<Pin>| pins.last()).map(|pin| pin.after.clone());
    let obstacle = sequence.is_none().then(|| Obstacle {
        smallest_sets: list(&value["smallest_sets"]).map(edges).collect(),
        never_moved: edges(&value["never_moved"]),
        ..Obstacle::default()
    });
    PinPlan { sequence, end: end.unwrap_or_default(), obstacle, ..PinPlan::default() }
}

fn pin(value: &Value, orientations: &[Orientation]) -> Pin {
    let (low, high, height) = (number(&value["from"][1]), number(&value["to"][0]), number(&value["height"]));
    let room = (&height - &low).min(&high - &height);
    let tolerance = (room * Q::from(Z::from(1000))).floor() / Q::from(Z::from(1000));
    let outcome: BTreeMap<usize, usize> =
        orientations.iter().filter_map(|from| Some((from.edge, outcome(from, &height, orientations)?))).collect();
    Pin { height, low: low.into(), high: high.into(), tolerance, outcome, after: edges(&value["after"]) }
}

/// Where the part ends after a pin; `None` if it jams.
fn outcome(from: &Orientation, height: &Q, orientations: &[Orientation]) -> Option<usize> {
    let mut here = from;
    for _ in orientations {
        let next = orientations.iter().find(|other| other.edge == here.next).expect("the next is stable");
        match here.action_at(height).0? {
            PinAction::PassUnder | PinAction::FallBack => return Some(here.edge),
            PinAction::Pass => return Some(next.edge),
            PinAction::Repeat => here = next,
            PinAction::Jam => return None,
        }
    }
    None
}

fn action(name: &str) -> PinAction {
    let all = [PinAction::PassUnder, PinAction::FallBack, PinAction::Jam, PinAction::Repeat, PinAction::Pass];
    all.into_iter().find(|action| action.name() == name).expect("one of the actions")
}

fn height(value: &Value) -> Algebraic {
    number(&value[0]).into()
}

fn number(value: &Value) -> Q {
    q(value.as_str().expect("exact numbers are texts"))
}

fn point(value: &Value) -> [Q; 2] {
    [number(&value[0]), number(&value[1])]
}

fn index(value: &Value) -> usize {
    value.as_u64().and_then(|value| usize::try_from(value).ok()).expect("an index")
}

fn edges(value: &Value) -> Vec<usize> {
    list(value).map(index).collect()
}

fn list(value: &Value) -> impl Iterator<Item = &Value> {
    value.as_array().into_iter().flatten()
}
