//! The public wrench cases and what independent exact implementations answered.

use super::modes::{Contact, Contacts};
use super::{Wrench, q};
use jsonc_parser::{JsonArray, JsonObject, JsonValue};
use partplan::exact::{Q, Z};
use partplan::geometry::{Location, Polygon};
use partplan::model::{Fixel, Fixture, Friction, LengthUnit, Part, Place, Range, Shape};
use serde_json::Value;

pub const NAMES: [&str; 15] = [
    "n1_edge",
    "n1_vertex",
    "n2_corner",
    "n2_disc_fig5",
    "n2_disc_paper",
    "n2_mixed_zero",
    "n2_peg_walls",
    "n2_static_kinetic",
    "n3_321",
    "n3_acyclic_only",
    "n3_concurrent",
    "n3_huge_rationals",
    "n3_pawlB_range",
    "n3_pawl_02",
    "n3_peg_jam",
];

/// The one case of four fixels.
pub const FOUR: &str = "n4_form_closure";

pub fn text(name: &str) -> String {
    let path = format!("{}/tests/wrench/{name}.json", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"))
}

pub fn expected(name: &str) -> Value {
    serde_json::from_str(&text(&format!("{name}.expected"))).expect("expected results are JSON")
}

/// An exact number of a result: an integer, or a string.
pub fn number(value: &Value) -> Q {
    match value {
        Value::Number(number) => q(&number.to_string()),
        Value::String(text) => q(text),
        other => panic!("{other} is not a number"),
    }
}

pub fn numbers(value: &Value) -> Vec<Q> {
    value.as_array().expect("a list").iter().map(number).collect()
}

pub fn wrench_of(value: &Value) -> Wrench {
    numbers(value).try_into().expect("three numbers")
}

pub fn strings(value: &Value) -> Vec<String> {
    value.as_array().expect("a list").iter().map(|s| s.as_str().expect("a text").to_owned()).collect()
}

/// Integer rows of a canonical cone.
pub fn rows(value: &Value) -> Vec<Vec<Z>> {
    value.as_array().expect("a list").iter().map(|row| numbers(row).iter().map(|x| x.to_integer()).collect()).collect()
}

/// The fixels as the expected results repeat them, with the case's friction, without the crate's own reader.
pub fn contacts(name: &str) -> Contacts {
    let expected = expected(name);
    let center: [Q; 2] = numbers(&expected["center_of_mass"]).try_into().expect("two numbers");
    let fixels = expected["fixels"].as_array().expect("a list").iter().zip(frictions(name)).map(|(fixel, friction)| {
        let at = numbers(&fixel["at"]);
        let normal = numbers(&fixel["normal"]).try_into().expect("two numbers");
        Contact::new([&at[0] - &center[0], &at[1] - &center[1]], normal, friction)
    });
    Contacts { list: fixels.collect(), rho2: number(&expected["rho2"]) }
}

/// Part and fixture of a case, built from the expected results without the crate's own reader.
pub fn seated(name: &str) -> (Part, Fixture) {
    let expected = expected(name);
    let shape = shape(&parsed(&text(name)));
    let fixels = expected["fixels"].as_array().expect("a list").iter().zip(frictions(name)).map(|(fixel, friction)| {
        let point: [Q; 2] = numbers(&fixel["at"]).try_into().expect("two numbers");
        let place = match &shape {
            Shape::Circle { .. } => Place::Arc,
            Shape::Polygon(polygon) => match polygon.locate(&point).expect("fixels are on the outline") {
                Location::Edge { edge, s } => Place::Edge { edge, s },
                Location::Vertex(vertex) => Place::Vertex { vertex },
            },
        };
        Fixel { place, point, normal: numbers(&fixel["normal"]).try_into().expect("two numbers"), friction }
    });
    let fixture = Fixture { fixels: fixels.collect() };
    let part = Part {
        unit: LengthUnit::Metre,
        center_of_mass: numbers(&expected["center_of_mass"]).try_into().expect("two numbers"),
        center_of_mass_tolerance: q("0"),
        mass: q("1"),
        inertia: number(&expected["rho2"]),
        shape,
    };
    (part, fixture)
}

fn shape(case: &JsonObject) -> Shape {
    let shape = case.get_object("part").and_then(|part| part.get_object("shape")).expect("a shape");
    if let Some(circle) = shape.get_object("circle") {
        let center = literals(circle.get_array("center").expect("a center"));
        return Shape::Circle {
            center: center.try_into().expect("two numbers"),
            radius: literal(circle.get("radius").expect("a radius")),
        };
    }
    let vertices = shape.get_array("polygon").expect("a polygon").iter().map(|vertex| match vertex {
        JsonValue::Array(vertex) => literals(vertex).try_into().expect("two numbers"),
        other => panic!("{other:?} is not a vertex"),
    });
    Shape::Polygon(Polygon::new(vertices.collect()).expect("the cases' polygons are simple"))
}

fn literals(list: &JsonArray) -> Vec<Q> {
    list.iter().map(literal).collect()
}

fn literal(value: &JsonValue) -> Q {
    match value {
        JsonValue::Number(text) => q(text),
        JsonValue::String(text) => q(text),
        other => panic!("{other:?} is not a number"),
    }
}

fn parsed(text: &str) -> JsonObject<'_> {
    match jsonc_parser::parse_to_value(text, &jsonc_parser::ParseOptions::default()) {
        Ok(Some(JsonValue::Object(case))) => case,
        other => panic!("{other:?} is not an object"),
    }
}

fn frictions(name: &str) -> Vec<Friction> {
    let text = text(name);
    let case = parsed(&text);
    let fixels = case.get_object("insert").and_then(|insert| insert.get_array("fixels")).expect("fixels");
    fixels
        .iter()
        .map(|fixel| {
            let JsonValue::Object(fixel) = fixel else { panic!("a fixel of {name} is not an object") };
            friction(fixel.get("friction").expect("friction"))
        })
        .collect()
}

fn friction(value: &JsonValue) -> Friction {
    let both = |range: Range| Friction { static_: range.clone(), kinetic: range };
    match value {
        JsonValue::Object(object) => match object.get("static") {
            Some(largest) => Friction {
                static_: range(largest),
                kinetic: range(object.get("kinetic").expect("kinetic beside static")),
            },
            None => both(range(value)),
        },
        _ => both(range(value)),
    }
}

fn range(value: &JsonValue) -> Range {
    match value {
        JsonValue::Object(object) => {
            let end = |key| range(object.get(key).expect("both ends of a range")).min;
            Range { min: end("min"), max: end("max") }
        }
        value => Range::exactly(literal(value)),
    }
}
