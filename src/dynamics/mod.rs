//! Time-steppers for rigid bodies with friction: floats, verified step by step.

mod collide;
mod contact;
mod impact;
mod impulses;
mod mechanics;
mod moreau;
mod nearby;
mod options;
mod planar;
mod project;
mod run;
mod spatial;
mod state;
mod stepper;
mod stewart_trinkle;

pub use mechanics::Mechanics;
pub use options::{ModelKind, Options};

use crate::answer::{ModelChoice, Simulation};
use crate::model::World;
use moreau::Moreau;
use stewart_trinkle::StewartTrinkle;

/// Runs a scene.
///
/// `watch` is told the time reached before every step and ends the run, marked partial, by answering `false`.
pub fn simulate<S: Mechanics>(
    world: &World<S>,
    options: &Options,
    watch: &mut dyn FnMut(f64) -> bool,
) -> Simulation<S> {
    let step = options.step.or(world.step).unwrap_or(1e-3);
    let model = |chosen| ModelChoice { chosen, step, ..ModelChoice::default() };
    match options.model {
        ModelKind::Auto | ModelKind::Moreau => {
            run::run(world, options, model("moreau"), &mut Moreau::new(world), watch)
        }
        _ => {
            let mut stepper = StewartTrinkle::new(world, options.recovery_speed.unwrap_or(f64::INFINITY));
            run::run(world, options, model("st"), &mut stepper, watch)
        }
    }
}
