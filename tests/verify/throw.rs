//! Throws: the patterns of public cases on real surfaces.

use partplan::case::{Limits, read};
use partplan::planner::{ThrowQuestion, throw};
use partplan::verify::{Surface, ThrowTrials, tally};

fn trials(name: &str) -> ThrowTrials {
    let path = format!("{}/tests/throw/cases/{name}.json", env!("CARGO_MANIFEST_DIR"));
    let case = read(&std::fs::read(&path).unwrap(), &Limits::default()).unwrap();
    let thrower = case.thrower.unwrap();
    let question = ThrowQuestion { starts: 4, ..ThrowQuestion::default() };
    let found = throw(&case.part, &thrower, &question, &mut |_| true).unwrap();
    ThrowTrials::new(&case.part, &thrower, &found, None, 0).unwrap()
}

fn landed(trials: &ThrowTrials, friction: f64, restitution: f64, is_compliant: bool) -> u64 {
    let surface = Surface { friction: [friction; 2], restitution: [restitution; 2], is_compliant };
    tally(&trials.on(surface), 0..60, &|| true).unwrap().confirmed
}

/// Stewart and Trinkle's contacts, and compliant ones, know nothing of sticking catches and of the algebra of rolling: where
/// friction is high and nothing bounces they must come to the same edges.
#[test]
fn rough_surfaces_catch_as_the_sticking_model_says() {
    for name in ["triangle_6_8_10", "pentagon", "rectangle", "triangle_friction"] {
        let trials = trials(name);
        assert_eq!((landed(&trials, 2.0, 0.0, false), landed(&trials, 1e3, 0.0, false)), (60, 60), "{name}");
    }
    let triangle = trials("triangle_friction");
    assert!(landed(&triangle, 2.0, 0.0, true) >= 59);
}

/// On smooth or bouncing surfaces some throws end on other edges, and the limits say from where on.
#[test]
fn smooth_and_elastic_surfaces_change_the_pattern() {
    let pentagon = trials("pentagon");
    assert!(landed(&pentagon, 0.2, 0.0, false) < 60);
    assert!(landed(&pentagon, 0.05, 0.8, false) < 55);
}
