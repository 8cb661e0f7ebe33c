//! Pins: the plans of the public cases are confirmed, wrong ones refuted.

use partplan::answer::Tally;
use partplan::case::{Limits, read};
use partplan::planner::{PinQuestion, pins};
use partplan::verify::{PinTrials, tally};

/// What the trials of a case come to, each orientation sent through `rounds` times.
fn verified(path: &str, rounds: u64) -> Option<(PinTrials, Tally)> {
    let path = format!("{}/{path}.json", env!("CARGO_MANIFEST_DIR"));
    let case = read(&std::fs::read(&path).unwrap(), &Limits::default()).unwrap();
    let conveyor = case.conveyor.unwrap();
    let found = pins(&case.part, &conveyor, &PinQuestion::default()).unwrap();
    let trials = PinTrials::new(&case.part, &conveyor, &found, &case.given_pins, 0)?;
    let all = tally(&trials, 0..rounds * trials.n_orientations(), &|| true).unwrap();
    Some((trials, all))
}

/// All public cases with pins: two, besides the hexagon.
#[test]
fn plans_of_the_public_cases_are_confirmed() {
    for name in ["three_pins", "parallelogram_left"] {
        let (trials, found) = verified(&format!("tests/topple/{name}"), 6).unwrap();
        assert_eq!((found.confirmed, found.runs()), (6 * trials.n_orientations(), found.confirmed), "{name} {found:?}");
    }
    for name in ["square", "kite", "triangle_345", "pentagon", "paper_fit_stated_friction", "rectangle_offset_com"] {
        assert!(verified(&format!("tests/topple/{name}"), 1).is_none(), "{name}");
    }
}

/// The toppling graph is quasi-static: a part comes to rest on the edge that it topples onto. This hexagon falls so far that it
/// keeps enough of its energy to roll on, whatever the speed of the belt.
#[test]
fn a_part_that_rolls_on_after_toppling_refutes_its_plan() {
    let (_, found) = verified("cases/refuted/rolling_hexagon", 2).unwrap();
    assert!(!found.refuted.is_empty() && found.confirmed >= 4, "{found:?}");
    assert!(found.reasons.iter().any(|(why, _)| why.contains("rolls on and on at pin 1")), "{found:?}");
}

#[test]
fn pins_in_the_wrong_order_are_refuted() {
    let (trials, found) = verified("cases/refuted/three_pins_wrong_order", 1).unwrap();
    assert!(!found.refuted.is_empty(), "{found:?}");
    assert_eq!(trials.n_orientations(), 4);
}

/// A faster belt leaves what is quasi-static: the plan holds up to a speed, and no longer at twice that.
#[test]
fn plans_hold_up_to_a_belt_speed() {
    let (trials, _) = verified("tests/topple/parallelogram_left", 1).unwrap();
    let limit = trials.fastest(&|| true).unwrap();
    let confirmed = |speed: f64| {
        let runs = trials.n_orientations();
        tally(&trials.at_speed(speed), 0..runs, &|| true).unwrap().confirmed == runs
    };
    assert!(confirmed(limit.low) && !confirmed(2.0 * limit.low), "{limit:?}");
}
