//! JSON documents as FORMATS.md names them.

mod chart;
mod feeder;
mod friction;
mod layout;
mod number;
mod pins;
mod polyhedron;
mod scene;
mod sets;
mod simulation;
mod suggest;
mod surd;
mod throw;
mod verification;
mod witness;

pub use chart::{CHART, chart};
pub use feeder::{FEEDER, feeder};
pub use layout::document;
pub use pins::{PINS, pins, undecided_pins};
pub use polyhedron::{CONVERT, polyhedron, undecided_polyhedron};
pub use scene::scene;
pub use simulation::{SIMULATE, simulation};
pub use suggest::{SUGGEST, suggestion};
pub use throw::{THROW, throw};
pub use verification::{VERIFY, verification, verified, verified_alone};

use super::Subject;
use crate::answer::{Action, Cone, EmptyReason, Insertion, Limit, Recommendation, Robust, Stability, WrenchVerdict};
use crate::exact::to_f64;
use crate::model::Part;
use number::{integers, rational, rationals};
use serde_json::{Map, Value, json};

/// Schema of `plan insert`.
pub const INSERT: &str = "plan.insert/1";
/// Schema of `plan stable`.
pub const STABLE: &str = "plan.stable/1";
/// Schema of `plan cone`.
pub const CONE: &str = "plan.cone/1";

/// The document of `plan insert`; `cells` adds the cells of every region.
#[must_use]
pub fn insertion(subject: &Subject, answer: &Insertion, cells: bool) -> Value {
    let mut result = context(subject);
    let regions = [
        ("goal", &answer.goal),
        ("acyclic", &answer.acyclic),
        ("hold", &answer.hold),
        ("unrefuted", &answer.unrefuted),
    ];
    for (name, region) in regions {
        result.insert(name.into(), sets::region(region, cells).into());
    }
    result.insert(
        "fingers".into(),
        json!({
            "goal": sets::fingers(subject.part, &answer.goal_fingers),
            "acyclic": sets::fingers(subject.part, &answer.acyclic_fingers),
        }),
    );
    result.insert(
        "tilt".into(),
        json!({ "goal": sets::arc_set(&answer.goal_tilt), "acyclic": sets::arc_set(&answer.acyclic_tilt) }),
    );
    result.insert("robust".into(), answer.robust.as_ref().map_or(Value::Null, robust));
    result.insert("robust_acyclic".into(), answer.robust_acyclic.as_ref().map_or(Value::Null, robust));
    let critical = answer.critical_friction.as_ref().map(friction::critical_friction);
    result.insert("critical_friction".into(), critical.unwrap_or(Value::Null));
    let change = answer.nearest_change.as_ref().map(friction::nearest_change);
    result.insert("nearest_change".into(), change.unwrap_or(Value::Null));
    result.insert("plan".into(), answer.plan.as_ref().map_or(Value::Null, plan));
    if let Some(reason) = &answer.empty_because {
        result.insert("empty_because".into(), empty_because(reason));
    }
    insert_asked(&mut result, &answer.modes, &answer.wrenches);
    let status = if answer.acyclic.is_empty() { "no-plan" } else { "plan" };
    envelope(subject, INSERT, status, result)
}

/// The document of `plan stable`; `cells` adds the cells of every region.
#[must_use]
pub fn stability(subject: &Subject, answer: &Stability, cells: bool) -> Value {
    let part = subject.part;
    let mut strong = sets::region(&answer.strong, cells);
    strong.insert("feasible_modes".into(), json!(answer.feasible_modes));
    let mut result = context(subject);
    result.insert("weak".into(), json!({ "cone": sets::cone(&answer.weak), "force_closure": answer.force_closure }));
    result.insert("strong".into(), strong.into());
    result.insert("feasible_modes".into(), json!(answer.feasible_modes));
    result.insert(
        "fingers".into(),
        json!({
            "closure": sets::fingers(part, &answer.closure_fingers),
            "weak": sets::fingers(part, &answer.weak_fingers),
            "strong": sets::fingers(part, &answer.strong_fingers),
        }),
    );
    result.insert(
        "tilt".into(),
        json!({ "weak": sets::arc_set(&answer.weak_tilt), "strong": sets::arc_set(&answer.strong_tilt) }),
    );
    insert_asked(&mut result, &answer.modes, &answer.wrenches);
    envelope(subject, STABLE, "report", result)
}

/// The document of `plan cone`.
#[must_use]
pub fn cones(subject: &Subject, modes: &[(String, Cone)]) -> Value {
    judged_cones(subject, modes, &[])
}

/// The document of `plan cone` with verdicts on wrenches.
#[must_use]
pub fn judged_cones(subject: &Subject, modes: &[(String, Cone)], wrenches: &[WrenchVerdict]) -> Value {
    let mut result = context(subject);
    insert_asked(&mut result, modes, wrenches);
    envelope(subject, CONE, "report", result)
}

/// The document of a command that reached its limit before an answer.
#[must_use]
pub fn undecided(subject: &Subject, schema: &str, reached: Limit) -> Value {
    let mut result = context(subject);
    result.insert("limit".to_owned(), reached.name().into());
    envelope(subject, schema, "undecided", result)
}

fn envelope(subject: &Subject, schema: &str, status: &str, result: Map<String, Value>) -> Value {
    envelope_of(subject.name, subject.part, schema, status, result)
}

fn envelope_of(name: &str, part: &Part, schema: &str, status: &str, result: Map<String, Value>) -> Value {
    json!({
        "schema": schema,
        "version": env!("CARGO_PKG_VERSION"),
        "case": name,
        "status": status,
        "units": { "length": part.unit.symbol() },
        "result": result,
    })
}

/// What every result says about the task itself: without it the wrenches have no meaning.
fn context(subject: &Subject) -> Map<String, Value> {
    let fixels = subject
        .fixture
        .fixels
        .iter()
        .map(|fixel| json!({ "at": rationals(&fixel.point), "normal": rationals(&fixel.normal) }));
    let mut result = Map::new();
    result.insert("center_of_mass".into(), rationals(&subject.part.center_of_mass));
    result.insert("rho2".into(), rational(&subject.part.gyration2()));
    result.insert("box".into(), json!([1, 1, rational(&subject.part.torque_reach())]));
    result.insert("fixels".into(), fixels.collect());
    result.insert("warnings".into(), json!(subject.warnings));
    result
}

fn insert_asked(result: &mut Map<String, Value>, modes: &[(String, Cone)], wrenches: &[WrenchVerdict]) {
    if !modes.is_empty() {
        let cones: Map<String, Value> = modes.iter().map(|(mode, cone)| (mode.clone(), sets::cone(cone))).collect();
        result.insert("modes".into(), cones.into());
    }
    if !wrenches.is_empty() {
        result.insert("wrenches".into(), wrenches.iter().map(verdict).collect());
    }
}

fn verdict(verdict: &WrenchVerdict) -> Value {
    json!({
        "g": rationals(&verdict.wrench),
        "weak": verdict.weak,
        "strong": verdict.strong,
        "goal": verdict.goal,
        "acyclic": verdict.acyclic,
        "unrefuted": verdict.unrefuted,
        "modes": verdict.modes,
        "witness": witness::witness(&verdict.witness),
        "consistent": verdict.witness.consistent.iter().map(|motion| motion.mode.as_str()).collect::<Value>(),
        "motions": witness::motions(&verdict.witness),
        "states": witness::states(&verdict.witness),
    })
}

fn plan(plan: &Recommendation) -> Value {
    let mut value = match &plan.action {
        Action::PushEdge { edge, interval, s, point, direction } => json!({
            "action": "push-edge",
            "edge": edge,
            "interval": sets::interval(interval),
            "s": rational(s),
            "point": rationals(point),
            "direction": rationals(direction),
        }),
        Action::PushArc { arc, direction } => json!({
            "action": "push-arc",
            "arc": arc.as_ref().map(sets::arc),
            "direction": integers(direction),
        }),
        Action::Tilt { arc, direction } => json!({
            "action": "tilt",
            "arc": arc.as_ref().map(sets::arc),
            "direction": integers(direction),
        }),
        Action::Wrench => json!({ "action": "wrench" }),
    };
    value["set"] = json!("acyclic");
    value["wrench"] = rationals(&plan.wrench);
    value["margin2"] = rational(&plan.margin2);
    value["margin_approx"] = json!(to_f64(&plan.margin2).sqrt());
    value
}

fn robust(robust: &Robust) -> Value {
    json!({
        "w": rationals(&robust.wrench),
        "radius2": rational(&robust.radius2),
        "radius": to_f64(&robust.radius2).sqrt(),
        "radius_upper": to_f64(&robust.radius_upper),
    })
}

fn empty_because(reason: &EmptyReason) -> Value {
    match reason {
        EmptyReason::DependentNormals => json!({ "reason": "dependent-normals" }),
        EmptyReason::PairForceClosure { fixels } => json!({ "reason": "pair-force-closure", "fixels": fixels }),
        EmptyReason::BlockingModes { modes } => json!({ "reason": "blocking-modes", "modes": modes }),
    }
}
