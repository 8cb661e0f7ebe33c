//! The document of `plan simulate`.

use super::super::motion::{Run, Shown, contact};
use crate::answer::{ContactName, ContactState, Energy, Event, Feature, ModelChoice, Simulation, Status};
use serde_json::{Map, Value, json};

/// Schema of `plan simulate`.
pub const SIMULATE: &str = "plan.simulate/1";

/// The document of `plan simulate`; SI units, angles in radians, floats with all their digits.
#[must_use]
pub fn simulation<S: Shown>(run: &Run<S>, answer: &Simulation<S>) -> Value {
    let mut result = context(run);
    let entries = |list: Vec<&[f64]>| json!(list);
    result.insert("status".into(), status(answer.status).into());
    result.insert("time".into(), json!(answer.time));
    result.insert(
        "final".into(),
        json!({
            "time": answer.last.time,
            "poses": entries(answer.last.poses.iter().map(AsRef::as_ref).collect()),
            "velocities": entries(answer.last.velocities.iter().map(AsRef::as_ref).collect()),
        }),
    );
    result.insert("events".into(), answer.events.iter().map(|event| change(run, event)).collect());
    let deformation = |(contact, parts): &(ContactName, [f64; 3])| json!({ "contact": name(run, contact), "deformation": parts, "pair": pair(run, contact) });
    result.insert("deformations".into(), answer.deformations.iter().map(deformation).collect());
    result.insert("energy".into(), energy(&answer.energy));
    let (depth, time) = answer.penetration;
    result.insert("penetration".into(), json!({ "depth": depth, "time": time }));
    let solver = &answer.solver;
    let rungs = solver.rungs.iter().map(|(name, count)| json!({ "rung": name, "problems": count }));
    result.insert(
        "solver".into(),
        json!({
            "steps": solver.steps,
            "problems": solver.problems,
            "pivots": solver.pivots,
            "rungs": rungs.collect::<Value>(),
            "residual": solver.residual,
            "impacts": solver.impacts,
            "fastest_impact": solver.fastest_impact,
            "subdivided": solver.subdivided,
        }),
    );
    result.insert("model".into(), model(&answer.model));
    result.insert("notes".into(), json!(answer.notes));
    let status = if answer.status == Status::Partial { "undecided" } else { "report" };
    envelope(run.name, status, result)
}

fn envelope(name: &str, status: &str, result: Map<String, Value>) -> Value {
    json!({
        "schema": SIMULATE,
        "version": env!("CARGO_PKG_VERSION"),
        "case": name,
        "status": status,
        "units": { "length": "m", "angle": "rad", "time": "s", "mass": "kg", "force": "N", "energy": "J" },
        "result": result,
    })
}

/// What every result says about the scene itself: poses follow the order of `bodies`.
fn context<S: Shown>(run: &Run<S>) -> Map<String, Value> {
    let world = run.world;
    let columns = |names: &[[&str; 2]]| names.iter().map(|[name, _]| Value::from(*name)).collect::<Value>();
    let mut result = Map::new();
    result.insert("dimension".into(), S::DIMENSION.into());
    result.insert("duration".into(), json!(world.duration));
    result.insert("bodies".into(), world.bodies.iter().map(|body| body.name.as_str()).collect());
    result.insert("fixed".into(), world.fixed.iter().map(|fixed| fixed.name.as_str()).collect());
    result.insert("pose".into(), columns(S::POSE));
    result.insert("velocity".into(), columns(S::VELOCITY));
    result.insert("warnings".into(), json!(run.warnings));
    result
}

fn status(status: Status) -> &'static str {
    match status {
        Status::Complete => "complete",
        Status::Ambiguous => "ambiguous",
        Status::Inconsistent => "inconsistent",
        Status::Partial => "partial",
    }
}

fn change<S: Shown>(run: &Run<S>, event: &Event) -> Value {
    json!({
        "time": event.time,
        "contact": name(run, &event.contact),
        "from": state(event.from),
        "to": state(event.to),
        "pair": pair(run, &event.contact),
    })
}

/// A contact by the names of its parties as they are.
fn name<S: Shown>(run: &Run<S>, name: &ContactName) -> String {
    contact(run, name, str::to_owned)
}

/// The pair by numbers: `body`, and the number of either another `body` or what is `fixed`.
fn pair<S: Shown>(run: &Run<S>, contact: &ContactName) -> Value {
    let n_bodies = run.world.bodies.len();
    let other = match contact.other.checked_sub(n_bodies) {
        Some(fixed) => json!({ "fixed": fixed, "feature": feature(contact.other_feature) }),
        None => json!({ "body": contact.other, "feature": feature(contact.other_feature) }),
    };
    json!([{ "body": contact.body, "feature": feature(contact.feature) }, other])
}

fn feature(feature: Feature) -> Value {
    let (kind, number) = match feature {
        Feature::Vertex(number) => ("vertex", number),
        Feature::Edge(number) => ("edge", number),
        Feature::Surface(number) => ("surface", number),
    };
    json!([kind, number])
}

fn state(state: ContactState) -> &'static str {
    match state {
        ContactState::Open => "open",
        ContactState::Stick => "stick",
        ContactState::Slip => "slip",
    }
}

fn energy(energy: &Energy) -> Value {
    json!({
        "start": energy.start,
        "end": energy.end,
        "work": energy.work,
        "dissipated": energy.dissipated,
        "largest_gain": energy.largest_gain,
    })
}

fn model(model: &ModelChoice) -> Value {
    json!({ "chosen": model.chosen, "why": model.why, "step": model.step, "error": model.error })
}
