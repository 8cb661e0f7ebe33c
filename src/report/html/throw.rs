//! The page that plays some throws of the pattern.

use super::super::decimal::near;
use super::super::{Toss, phrase};
use super::page;
use crate::answer::{Pose, Throw};
use crate::exact::to_f64;
use crate::model::Shape;
use serde_json::{Value, json};

/// The page of `plan throw`: plays throws of the pattern, with the radius over time.
///
/// The arm is shown as it is when it waits for the part, which is thrown at once.
#[must_use]
pub fn throw(toss: &Toss, answer: &Throw) -> String {
    let remark = "The arm turns about the dot, and throws at once when the part has come to rest; it is shown at rest. The small \
                  block in it is the sensor.";
    page(toss.name, &phrase::throw(toss, answer), remark, &data(toss, answer))
}

/// What the script plays.
fn data(toss: &Toss, answer: &Throw) -> Value {
    let poses = &answer.replay;
    let graph: Vec<f64> = poses.iter().map(|pose| pose.x).collect();
    json!({
        "dimension": 2,
        "views": [{ "name": "", "right": 0, "up": 1 }],
        "bodies": [{ "name": "part", "pieces": [{ "polygon": outline(toss) }] }],
        "fixed": fixed(toss, answer),
        "times": poses.iter().map(|pose| pose.time).collect::<Vec<_>>(),
        "poses": poses.iter().map(|pose| json!([[pose.x, pose.y, pose.angle]])).collect::<Value>(),
        "graph": { "name": "x of the center of mass", "unit": toss.part.unit.symbol(), "values": graph },
        "touches": [],
        "events": events(toss, answer),
    })
}

/// The outline about the center of mass.
fn outline(toss: &Toss) -> Vec<[f64; 2]> {
    let Shape::Polygon(polygon) = &toss.part.shape else { return Vec::new() };
    let [x, y] = &toss.part.center_of_mass;
    polygon.vertices().iter().map(|[u, v]| [to_f64(&(u - x)), to_f64(&(v - y))]).collect()
}

/// The arm, its pivot and the sensor.
fn fixed(toss: &Toss, answer: &Throw) -> Value {
    let (size, height) = (answer.part_radius, to_f64(&toss.thrower.offset));
    let far = answer.replay.iter().map(|pose| pose.x).fold(0.0, f64::max) + 2.0 * size;
    let block = |from: f64, to: f64, deep: f64| {
        let low = height - deep * size;
        json!({ "polygon": [[from, low], [to, low], [to, height], [from, height]] })
    };
    let mut fixed = vec![
        json!({ "name": "arm", "pieces": [block(0.0, far, 0.12)] }),
        json!({ "name": "pivot", "pieces": [{ "disc": [0.0, 0.0, 0.0] }] }),
    ];
    if let Some(window) = answer.window() {
        let half = 0.06 * size;
        fixed.push(json!({ "name": "sensor", "pieces": [block(window.at - half, window.at + half, 0.24)] }));
    }
    fixed.into()
}

/// When each throw begins, and from where.
fn events(toss: &Toss, answer: &Throw) -> Value {
    let unit = toss.part.unit.symbol();
    let starts = |pose: &Pose| answer.limit.sets.first()?.orbit.get(pose.throw).copied();
    let mut events: Vec<Value> = Vec::new();
    for pose in &answer.replay {
        if let (true, Some((edge, radius))) = (pose.throw == events.len(), starts(pose)) {
            let text = format!("throw {} from edge {edge} at {} {unit}", pose.throw + 1, near(radius, 5));
            events.push(json!({ "time": pose.time, "text": text }));
        }
    }
    events.into()
}
