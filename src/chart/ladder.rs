//! What each rung of the model ladder costs, and whether the automatic choice is worth it.

use super::measure::{Curve, Measure};
use super::scenes::{self, Known};
use super::stepping::{ended, seldom};
use crate::answer::ChartFamily;
use crate::dynamics::{Mechanics, ModelKind, Options, simulate};
use crate::model::{Planar, World};

/// Tolerances (m) of a quick and of a whole chart.
const QUICK: [f64; 1] = [1e-3];
const WHOLE: [f64; 3] = [1e-2, 1e-3, 1e-4];

/// Steps of the rungs at fixed steps, in powers of two.
const FEW: [i32; 4] = [4, 6, 7, 9];
const MANY: [i32; 8] = [4, 5, 6, 7, 8, 9, 11, 13];

/// Scenes that need no friction, no compliance, or both.
pub(super) fn built_in(measure: &mut Measure) {
    let mut stiff = scenes::incline(0.5);
    scenes::comply(&mut stiff.world, 1e8, 1e3);
    let hard = Known { name: "box slips on a hard floor", ..stiff };
    for known in [scenes::incline(0.0), scenes::slide(), hard, scenes::landing(1e4)] {
        rungs(measure, &known);
    }
}

fn rungs(measure: &mut Measure, known: &Known) {
    let Known { name, world, end } = known;
    let mut ice = world.clone();
    ice.materials.iter_mut().for_each(|material| (material.friction, material.compliance) = (0.0, None));
    let mut rigid = world.clone();
    rigid.materials.iter_mut().for_each(|material| material.compliance = None);
    let is_compliant = world.materials.iter().any(|material| material.compliance.is_some());
    let rungs: [(&str, ModelKind, Option<&World<Planar>>); 3] = [
        ("frictionless", ModelKind::Moreau, Some(&ice)),
        ("rigid", ModelKind::Moreau, Some(&rigid)),
        ("compliant", ModelKind::SongPangKumar, is_compliant.then_some(world)),
    ];
    for (method, model, world) in rungs {
        let Some(world) = world else { continue };
        for power in measure.pick(FEW.to_vec(), MANY.to_vec()) {
            let step = Some(world.duration / 2_f64.powi(power));
            let options = Options { model, step, second_order: true, frames: 2, ..Options::default() };
            let curve = Curve { family: ChartFamily::Ladder, work: name, method };
            measure.point(curve, &format!("{} steps", 1 << power), 1, |watch| ended(world, &options, end, watch));
        }
    }
    automatic(measure, name, world, end);
}

/// The automatic choice at some tolerances, the time for choosing included.
pub(super) fn automatic<S: Mechanics, P: AsRef<[f64]>>(measure: &mut Measure, name: &str, world: &World<S>, end: &[P]) {
    for tolerance in measure.pick(QUICK.to_vec(), WHOLE.to_vec()) {
        let options = Options { tolerance, frames: 2, ..Options::default() };
        let curve = Curve { family: ChartFamily::Ladder, work: name, method: "auto" };
        if !measure.wants(&[curve.family.name(), name, curve.method]) {
            return;
        }
        let watch = measure.watch(curve.family.name());
        let Ok(run) = simulate(world, &options, &mut seldom(&watch)) else { continue };
        let setting = format!("tolerance {tolerance}: {} at h = {:.1e}", run.model.chosen, run.model.step);
        measure.point(curve, &setting, 1, |watch| ended(world, &options, end, watch));
    }
}
