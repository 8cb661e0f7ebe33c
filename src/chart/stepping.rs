//! Time-steppers at fixed steps: the error of the final pose against the time of a run.

use super::measure::{Curve, Measure, Outcome};
use super::scenes::{self, Known};
use crate::answer::{ChartFamily, Status};
use crate::dynamics::{Mechanics, ModelKind, Options, simulate};
use crate::model::World;

/// Steps (s) of a quick and of a whole chart.
const QUICK: [f64; 3] = [1e-2, 2e-3, 5e-4];
const WHOLE: [f64; 8] = [2e-2, 1e-2, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4];

/// Stiffness (N/m) that stands for rigid contacts in the compliant model.
const STIFF: f64 = 1e6;

/// Step of the reference over the least step of the curves.
const FINER: f64 = 0.05;

/// Steps of a run between two looks at whether to go on: so many that they do not count.
const SELDOM: u32 = 1 << 12;

/// The models, by name.
const MODELS: [(&str, ModelKind, bool); 4] = [
    ("Stewart-Trinkle", ModelKind::StewartTrinkle, false),
    ("Moreau", ModelKind::Moreau, false),
    ("Song-Pang-Kumar", ModelKind::SongPangKumar, false),
    ("Song-Pang-Kumar, 2nd order", ModelKind::SongPangKumar, true),
];

/// Scenes with closed forms.
pub(super) fn built_in(measure: &mut Measure) {
    let known = [scenes::slide(), scenes::incline(0.5), scenes::backspin(), scenes::bounce(), scenes::landing(1e4)];
    for Known { name, world, end } in known {
        let is_compliant = world.materials.iter().any(|material| material.compliance.is_some());
        let restitutes = world.materials.iter().any(|material| material.restitution.coefficient() > 0.0);
        let mut soft = world.clone();
        if !is_compliant {
            scenes::comply(&mut soft, STIFF, 0.2 * STIFF.sqrt());
        }
        for (method, model, second_order) in MODELS {
            // the compliant model has a restitution of its own
            let is_left_out = model == ModelKind::SongPangKumar && restitutes;
            if !is_left_out {
                let world = if model == ModelKind::SongPangKumar { &soft } else { &world };
                let options = Options { model, second_order, ..Options::default() };
                steps(measure, Curve { family: ChartFamily::Stepping, work: name, method }, world, &options, &end);
            }
        }
    }
}

/// A scene of which no closed form is known: against a run at a much smaller step by the best model that it allows.
pub(super) fn scene<S: Mechanics>(measure: &mut Measure, name: &str, world: &World<S>) {
    let least = settings(measure).last().copied().unwrap_or(1e-3);
    let watch = measure.watch(ChartFamily::Stepping.name());
    let finest = |model: ModelKind| {
        let (second_order, step) = (model == ModelKind::SongPangKumar, Some(FINER * least));
        let options = Options { model, second_order, step, frames: 2, ..Options::default() };
        simulate(world, &options, &mut seldom(&watch)).ok()
    };
    // without compliance for every pair that can touch there is no compliant run
    let compliant = finest(ModelKind::SongPangKumar);
    let is_compliant = compliant.is_some();
    let Some(reference) = compliant.or_else(|| finest(ModelKind::Moreau)) else { return };
    if !measure.goes_on(ChartFamily::Stepping.name()) {
        return;
    }
    let end: Vec<S::Pose> = reference.last.poses;
    for (method, model, second_order) in MODELS {
        if model != ModelKind::SongPangKumar || is_compliant {
            let options = Options { model, second_order, ..Options::default() };
            steps(measure, Curve { family: ChartFamily::Stepping, work: name, method }, world, &options, &end);
        }
    }
    super::ladder::automatic(measure, name, world, &end);
}

/// A point for each step.
fn steps<S: Mechanics, P: AsRef<[f64]>>(
    measure: &mut Measure,
    curve: Curve,
    world: &World<S>,
    options: &Options,
    end: &[P],
) {
    for step in settings(measure) {
        let options = Options { step: Some(step), frames: 2, ..options.clone() };
        measure.point(curve, &format!("h = {step}"), 1, |watch| ended(world, &options, end, watch));
    }
}

fn settings(measure: &Measure) -> Vec<f64> {
    measure.pick(QUICK.to_vec(), WHOLE.to_vec())
}

/// A run, and how far it ends from where it should. It has failed if it is no nearer than the start was, and not within the
/// tolerance.
pub(super) fn ended<S: Mechanics, P: AsRef<[f64]>>(
    world: &World<S>,
    options: &Options,
    end: &[P],
    watch: &dyn Fn() -> bool,
) -> Outcome {
    let Ok(run) = simulate(world, options, &mut seldom(watch)) else {
        return Outcome { error: None, failed: 1, of: 1 };
    };
    let error = distance::<S, P>(&run.last.poses, end);
    let start: Vec<S::Pose> = world.bodies.iter().map(|body| body.pose).collect();
    let is_right = error <= distance::<S, P>(&start, end).max(options.tolerance);
    let is_through = matches!(run.status, Status::Complete | Status::Ambiguous);
    Outcome { error: is_through.then_some(error), failed: u64::from(!is_through || !is_right), of: 1 }
}

/// Asks once in so many steps.
pub(super) fn seldom(watch: &dyn Fn() -> bool) -> impl FnMut(f64) -> bool {
    let mut steps = 0_u32;
    move |_| {
        steps = steps.wrapping_add(1);
        !steps.is_multiple_of(SELDOM) || watch()
    }
}

/// Largest distance of a center of mass from its place (m).
pub(super) fn distance<S: Mechanics, P: AsRef<[f64]>>(poses: &[S::Pose], end: &[P]) -> f64 {
    let dimension = S::TANGENTS + 1;
    let of = |found: &S::Pose, wanted: &P| {
        let pairs = found.as_ref().iter().zip(wanted.as_ref()).take(dimension);
        pairs.map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
    };
    poses.iter().zip(end).map(|(found, wanted)| of(found, wanted)).fold(0.0, f64::max)
}
