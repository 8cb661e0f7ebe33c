//! The public cases and their independently computed answers.

use partplan::case;
use partplan::exact::{Q, parse_literal, to_f64};
use partplan::mechanics::throwing::{Body, Real, RestingEdge};
use partplan::model::{Part, Shape, Thrower};
use serde_json::Value;
use std::path::{Path, PathBuf};

/// A public case.
pub struct Expected {
    pub name: String,
    pub text: String,
    pub answer: Value,
}

/// All of them.
pub fn all() -> Vec<Expected> {
    let folder = folder();
    let mut names: Vec<String> = std::fs::read_dir(&folder)
        .unwrap()
        .filter_map(|entry| entry.unwrap().file_name().to_str()?.strip_suffix(".expected.json").map(String::from))
        .collect();
    names.sort();
    assert_eq!(names.len(), 10);
    names.iter().map(|name| of(name)).collect()
}

/// One.
pub fn of(name: &str) -> Expected {
    let read = |end: &str| std::fs::read_to_string(folder().join(format!("{name}{end}"))).unwrap();
    let answer = serde_json::from_str(&read(".expected.json")).unwrap();
    Expected { name: name.to_owned(), text: read(".json"), answer }
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/throw/cases")
}

impl Expected {
    pub fn part(&self) -> Part {
        case::read(self.text.as_bytes(), &case::Limits::default()).unwrap().part
    }

    pub fn thrower(&self) -> Thrower {
        case::read(self.text.as_bytes(), &case::Limits::default()).unwrap().thrower.unwrap()
    }

    /// The hull on the arm.
    pub fn body<N: Real>(&self) -> Body<N> {
        body(&self.part(), &self.thrower())
    }
}

/// The hull of a part on an arm.
pub fn body<N: Real>(part: &Part, thrower: &Thrower) -> Body<N> {
    let corners = hull(part);
    let edges = RestingEdge::all(&corners, &part.center_of_mass, &part.gyration2());
    let arm = [&thrower.offset, &thrower.gravity, &thrower.release_deg_per_s];
    Body::new(&corners, &part.center_of_mass, &part.gyration2(), &edges, arm)
}

/// Its corners, counter-clockwise.
pub fn hull(part: &Part) -> Vec<[Q; 2]> {
    let Shape::Polygon(polygon) = &part.shape else { panic!("a polygon") };
    polygon.hull().iter().map(|k| polygon.vertices()[*k].clone()).collect()
}

/// A number written as text.
pub fn number(value: &Value) -> f64 {
    match value {
        Value::String(text) => to_f64(&parse_literal(text).unwrap()),
        other => other.as_f64().unwrap(),
    }
}

/// A small whole number.
pub fn index(value: &Value) -> usize {
    usize::try_from(value.as_u64().unwrap()).unwrap()
}
