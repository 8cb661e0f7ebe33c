//! Where methods fail: runs over two stresses.

use super::complementarity::{Method, answered, problems};
use super::contacts::Family;
use super::measure::Measure;
use super::scenes::{self, Known};
use super::stepping::distance;
use crate::answer::{ChartMap, Status};
use crate::dynamics::{ModelKind, Options, simulate};
use crate::model::{Planar, World};
use std::cell::LazyCell;

/// Coefficients of friction about the slope 0.15, and mass ratios.
const FRICTIONS: [f64; 7] = [0.0, 0.05, 0.1, 0.14, 0.16, 0.5, 1.0];
const RATIOS: [f64; 6] = [1.0, 1e2, 1e4, 1e6, 1e9, 1e12];

/// Steps (s) and stiffnesses (N/m).
const STEPS: [f64; 6] = [1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5];
const STIFFNESSES: [f64; 6] = [1e3, 1e4, 1e5, 1e6, 1e7, 1e8];

/// Shares of doubled contacts.
const SHARES: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];

/// Error of a successful run of blocks that rest or slide, and of one that bounces from 5 cm (m).
const GOOD: f64 = 1e-3;
const GOOD_BOUNCE: f64 = 5e-3;

/// Problems of a tile.
const PROBLEMS: [usize; 2] = [20, 100];

pub(super) fn measure(measure: &mut Measure) {
    friction_and_mass(measure);
    step_and_stiffness(measure);
    degeneracy_and_conditioning(measure);
}

fn friction_and_mass(measure: &mut Measure) {
    for (method, model) in [("Stewart-Trinkle", ModelKind::StewartTrinkle), ("Moreau", ModelKind::Moreau)] {
        for ratio in RATIOS.into_iter().step_by(measure.pick(2, 1)) {
            for mu in FRICTIONS.into_iter().step_by(measure.pick(2, 1)) {
                measure.tile(ChartMap::FrictionMass, method, [mu, ratio], || {
                    let Known { world, end, .. } = scenes::stack(mu, ratio);
                    run(&world, &Options { model, step: Some(2e-3), frames: 2, ..Options::default() }, &end, GOOD)
                });
            }
        }
    }
}

fn step_and_stiffness(measure: &mut Measure) {
    let methods = [("Song-Pang-Kumar", false), ("Song-Pang-Kumar, 2nd order", true)];
    for stiffness in STIFFNESSES.into_iter().step_by(measure.pick(2, 1)) {
        let world = scenes::drop(stiffness);
        let options = |step: f64, second_order| Options {
            model: ModelKind::SongPangKumar,
            second_order,
            step: Some(step),
            frames: 2,
            ..Options::default()
        };
        // of tiles that are wanted only
        let reference = LazyCell::new(|| simulate(&world, &options(2e-6, true), &mut |_| true));
        for (method, second_order) in methods {
            for step in STEPS.into_iter().step_by(measure.pick(2, 1)) {
                measure.tile(ChartMap::StepStiffness, method, [step, stiffness], || match &*reference {
                    Ok(reference) => run(&world, &options(step, second_order), &reference.last.poses, GOOD_BOUNCE),
                    Err(_) => [0, 0, 1],
                });
            }
        }
    }
}

fn degeneracy_and_conditioning(measure: &mut Measure) {
    let methods = [
        ("Lemke, doubles", Method::Lemke),
        ("ladder, doubles", Method::Doubles),
        ("ladder to integers", Method::Ladder),
        ("Gauss-Seidel, 1000 sweeps", Method::GaussSeidel(1_000)),
    ];
    let (count, seed) = (measure.pick(PROBLEMS[0], PROBLEMS[1]), measure.question.seed);
    for (method, how) in methods {
        for ratio in RATIOS.into_iter().step_by(measure.pick(2, 1)) {
            for share in SHARES.into_iter().step_by(measure.pick(2, 1)) {
                measure.tile(ChartMap::DegeneracyConditioning, method, [share, ratio], || {
                    let found = answered(how, &problems(Family::Doubled { ratio, share }, count, seed));
                    [found.of - found.failed, 0, found.failed]
                });
            }
        }
    }
}

/// One run: near enough, ambiguous by its own account, or neither.
fn run<P: AsRef<[f64]>>(world: &World<Planar>, options: &Options, end: &[P], good: f64) -> [u64; 3] {
    match simulate(world, options, &mut |_| true) {
        Ok(run) if run.status == Status::Ambiguous || run.status == Status::Inconsistent => [0, 1, 0],
        Ok(run) if run.status == Status::Complete && distance::<Planar, P>(&run.last.poses, end) <= good => [1, 0, 0],
        _ => [0, 0, 1],
    }
}
