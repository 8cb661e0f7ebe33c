//! Text and JSON.

use super::{AWKWARD, peg, sphere, two};
use partplan::answer::{Simulation, Status};
use partplan::model::Planar;
use partplan::report::{self, Run};
use serde_json::{Value, json};

fn text_of(status: Status, change: impl FnOnce(&mut Simulation<Planar>)) -> String {
    let (world, mut answer) = peg();
    answer.status = status;
    change(&mut answer);
    report::text::simulation(&Run { name: "peg drop", world: &world, warnings: &[] }, &answer)
}

#[test]
fn the_final_state_comes_first() {
    let text = text_of(Status::Complete, |_| {});
    assert!(text.starts_with("peg is at rest at (0.224, 0.02498) m, angle -180 deg, after 1 s\n"), "{text}");
    for said in [
        "model       spk, step 0.0002 s, final poses within about 0.000024 m",
        "the case gives stiffness and damping of the contacts",
        "contacts    0.1732 s  peg vertex 0 / floor touches and slips",
        "more changes (--format json lists all)",
        "energy      0.3924 J at the start, 0.049 J at the end; work 0 J, dissipated 0.3434 J",
        "overlap     0.00031 m at most, at 0.1725 s",
        "solver      5000 steps, 1234 contact problems, 2468 pivots, residual 3.2e-14, 1 step cut",
        "answered by lemke 1230, enumeration 4",
    ] {
        assert!(text.contains(said), "{said:?} is not in\n{text}");
    }
}

#[test]
fn how_a_run_ended_is_said_at_once() {
    let first = |status| text_of(status, |_| {}).lines().next().unwrap_or_default().to_owned();
    assert!(first(Status::Partial).starts_with("stopped before the 1 s asked for: peg "));
    assert!(first(Status::Inconsistent).starts_with("no finite force is consistent with some step of it: peg "));
    let early = text_of(Status::Inconsistent, |answer| answer.time = 0.5);
    assert!(early.starts_with("no motion is possible at some step: peg "));
    assert!(first(Status::Ambiguous).ends_with(", by one of several motions that the model allows"));
}

#[test]
fn a_screen_is_enough() {
    let text = text_of(Status::Partial, |answer| {
        answer.notes = (0..50).map(|k| format!("note {k}")).collect();
        answer.model.why = (0..50).map(|k| format!("reason {k}")).collect();
        answer.events = answer.events.iter().cycle().take(5_000).cloned().collect();
    });
    assert!(text.lines().count() <= 25, "{text}");
    assert!(text.contains("and 4995 more changes"), "{text}");
}

#[test]
fn many_bodies_are_counted() {
    let (mut world, mut answer) = peg();
    world.bodies = (0..30).map(|_| world.bodies[0].clone()).collect();
    answer.last.poses = vec![answer.last.poses[0]; 30];
    answer.last.velocities = vec![answer.last.velocities[0]; 30];
    let text = report::text::simulation(&Run { name: "many", world: &world, warnings: &[] }, &answer);
    assert!(text.starts_with("after 1 s 30 of 30 bodies are at rest\n"), "{text}");
    assert!(text.contains("and 25 more (--format json lists all)"), "{text}");
}

#[test]
fn names_do_not_reach_the_terminal_as_they_are() {
    let (world, answer) = two();
    let text = report::text::simulation(&Run { name: "two", world: &world, warnings: &[] }, &answer);
    assert!(!text.contains('\u{1b}') && text.contains("a\"b'<i>"), "{text}");
}

#[test]
fn the_document_has_what_the_format_promises() {
    let (world, mut answer) = peg();
    answer.deformations = vec![(answer.events[0].contact, [1e-5, -2e-6, 0.0])];
    let run = Run { name: "peg drop", world: &world, warnings: &["odd".to_owned()] };
    let text = report::json::document(&report::json::simulation(&run, &answer));
    let value: Value = serde_json::from_str(&text).unwrap();
    assert_eq!(
        (&value["schema"], &value["case"], &value["status"]),
        (&json!("plan.simulate/1"), &json!("peg drop"), &json!("report"))
    );
    let result = &value["result"];
    assert_eq!(result["status"], "complete");
    assert_eq!(
        (&result["bodies"], &result["fixed"], &result["warnings"]),
        (&json!(["peg"]), &json!(["floor"]), &json!(["odd"]))
    );
    let event = &result["events"][0];
    assert_eq!(
        (&event["contact"], &event["from"], &event["to"]),
        (&json!("peg vertex 0 / floor"), &json!("open"), &json!("slip"))
    );
    assert_eq!(event["pair"], json!([{"body": 0, "feature": ["vertex", 0]}, {"fixed": 0, "feature": ["surface", 0]}]));
    assert_eq!(result["events"].as_array().map(Vec::len), Some(answer.events.len()));
    assert_eq!(result["energy"]["dissipated"], json!(answer.energy.dissipated));
    let deformation = &result["deformations"][0];
    assert_eq!((&deformation["contact"], &deformation["deformation"]), (&event["contact"], &json!([1e-5, -2e-6, 0.0])));
    assert_eq!(result["penetration"], json!({ "depth": 3.1e-4, "time": 0.1725 }));
    assert_eq!(result["solver"]["rungs"][1], json!({ "rung": "enumeration", "problems": 4 }));
    assert_eq!(result["model"]["chosen"], "spk");
    // floats are written so that they read back the same to the last bit
    for number in answer.last.poses[0] {
        let written = json!(number).to_string();
        assert_eq!(written.parse::<f64>().unwrap().to_bits(), number.to_bits());
        assert!(text.contains(&written), "{written}");
    }
}

#[test]
fn a_run_stopped_early_is_undecided() {
    let (world, mut answer) = sphere();
    answer.status = Status::Partial;
    let value = report::json::simulation(&Run { name: "x", world: &world, warnings: &[] }, &answer);
    assert_eq!((&value["status"], &value["result"]["status"]), (&json!("undecided"), &json!("partial")));
    assert_eq!(value["result"]["final"]["poses"][0].as_array().map(Vec::len), Some(7));
}

#[test]
fn names_are_kept_in_the_document() {
    let (world, answer) = two();
    let value = report::json::simulation(&Run { name: AWKWARD, world: &world, warnings: &[] }, &answer);
    let back: Value = serde_json::from_str(&report::json::document(&value)).unwrap();
    assert_eq!((&back["case"], &back["result"]["bodies"][0]), (&json!(AWKWARD), &json!(AWKWARD)));
}
