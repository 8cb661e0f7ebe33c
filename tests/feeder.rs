//! Devices designed through dynamics: the published feeder, what a case may say, and searches.

use partplan::answer::{EntryFate, FeederDesign};
use partplan::case::{FeederCase, Limits, read_feeder};
use partplan::design::evaluated;
use partplan::dynamics::ModelKind;
use partplan::model::Feeder;

fn feeder() -> Feeder {
    let path = format!("{}/cases/feeder.json", env!("CARGO_MANIFEST_DIR"));
    let FeederCase { feeder, .. } = read_feeder(&std::fs::read(path).unwrap(), &Limits::default()).unwrap();
    feeder
}

/// The known good design, rounded.
const GOOD: [f64; 12] = [0.04, 0.03, 0.021, 0.08, -0.049, -0.026, 0.0525, 0.023, 0.093, 0.005, 0.56, 0.3];

fn at(feeder: &Feeder, variables: &[f64], step: f64) -> FeederDesign {
    evaluated(feeder, variables, &feeder.nominal(), ModelKind::StewartTrinkle, Some(step))
}

/// Costs, times and places of an independent program, at its step and at half of it.
#[test]
fn the_first_design_gets_stuck_and_the_known_one_passes() {
    let feeder = feeder();
    for (step, stuck, passed) in [(1e-3, 14.788_279, 0.932_125), (5e-4, 14.793_413, 0.932_091)] {
        let first = at(&feeder, &feeder.start(), step);
        assert!((first.cost - stuck).abs() < 0.03, "{first:?}");
        assert!(first.runs.iter().all(|run| run.fate == EntryFate::Rests), "{first:?}");
        assert!((first.runs[0].time - 0.371).abs() < 0.015 && (first.runs[1].time - 0.274).abs() < 0.015, "{first:?}");
        let good = at(&feeder, &GOOD, step);
        assert!(good.passes() && (good.cost - passed).abs() < 0.03, "{good:?}");
        assert!((good.runs[0].time - 0.473).abs() < 0.015 && (good.runs[1].time - 0.428).abs() < 0.015, "{good:?}");
    }
}
