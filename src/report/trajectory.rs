//! Trajectories: a row for each frame.

use super::motion::{Run, Shown, energy};
use crate::answer::{Frame, Simulation};
use serde_json::{Value, json};

/// Comma-separated values: time, pose and velocity of each body, energy; the first row names them with their units.
#[must_use]
pub fn csv<S: Shown>(run: &Run<S>, answer: &Simulation<S>) -> String {
    let mut text = header(run).iter().map(|name| quoted(name)).collect::<Vec<_>>().join(",");
    text.push('\n');
    for frame in &answer.frames {
        let row: Vec<String> = numbers(run, frame).map(|number| format!("{number:?}")).collect();
        text.push_str(&row.join(","));
        text.push('\n');
    }
    text
}

/// A JSON document a line: what the columns are, then a list of numbers for each frame.
#[must_use]
pub fn jsonl<S: Shown>(run: &Run<S>, answer: &Simulation<S>) -> String {
    let head = json!({ "schema": "plan.trajectory/1", "case": run.name, "columns": header(run) });
    let rows = answer.frames.iter().map(|frame| numbers(run, frame).map(Value::from).collect::<Value>());
    std::iter::once(head).chain(rows).map(|line| format!("{line}\n")).collect()
}

/// Name and unit of every column.
fn header<S: Shown>(run: &Run<S>) -> Vec<String> {
    let entries = || S::POSE.iter().chain(S::VELOCITY);
    let of =
        |name: &str| -> Vec<String> { entries().map(|[entry, unit]| format!("{name} {entry} [{unit}]")).collect() };
    let columns = run.world.bodies.iter().flat_map(|body| of(&body.name));
    std::iter::once("time [s]".to_owned()).chain(columns).chain(["energy [J]".to_owned()]).collect()
}

fn numbers<S: Shown>(run: &Run<S>, frame: &Frame<S>) -> impl Iterator<Item = f64> {
    let state = |(pose, velocity): (&S::Pose, &S::Velocity)| [pose.as_ref(), velocity.as_ref()].concat();
    let states = frame.poses.iter().zip(&frame.velocities).flat_map(state).collect::<Vec<_>>();
    std::iter::once(frame.time).chain(states).chain([energy(run, frame)])
}

/// A field in quotes where it needs them.
fn quoted(field: &str) -> String {
    if field.contains(['"', ',', '\n', '\r']) {
        format!("\"{}\"", field.replace('"', "\"\""))
    } else {
        field.to_owned()
    }
}
