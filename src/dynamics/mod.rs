//! Time-steppers for rigid bodies with friction: floats, verified step by step.

mod adverse;
mod collide;
mod collide_spatial;
mod contact;
mod finger;
mod forces;
mod impact;
mod impulses;
mod judge;
mod ladder;
mod mechanics;
mod moreau;
mod nearby;
mod options;
mod paradox;
mod planar;
mod planar_follow;
mod project;
mod routh;
mod run;
mod single;
mod solved;
mod song_pang_kumar;
mod spatial;
mod spatial_pairs;
mod state;
mod stepper;
mod stewart_trinkle;
mod stopped;
mod touches;
mod turning;

pub use mechanics::Mechanics;
pub use options::{ModelKind, Options, Policy};
pub use song_pang_kumar::SimulationError;

use crate::answer::{ModelChoice, Simulation};
use crate::model::World;
use moreau::Moreau;
use song_pang_kumar::SongPangKumar;
use stewart_trinkle::StewartTrinkle;
use stopped::Stopped;

/// Runs a scene.
///
/// `watch` is told the time reached before every step and ends the run, marked partial, by answering `false`.
///
/// # Errors
/// [`SimulationError`] if a body has a shape that only fixed things have, or if Song, Pang and Kumar's model is asked for and
/// a pair that can touch has no usable compliance.
pub fn simulate<S: Mechanics>(
    world: &World<S>,
    options: &Options,
    watch: &mut dyn FnMut(f64) -> bool,
) -> Result<Simulation<S>, SimulationError> {
    observe(world, options, &mut |moment| watch(moment.time))
}

/// What is known of a run before a step.
#[derive(Debug, Clone, Copy)]
pub struct Moment<'a, S: Mechanics> {
    /// Time reached (s).
    pub time: f64,
    /// A pose a body.
    pub poses: &'a [S::Pose],
    /// A velocity a body.
    pub velocities: &'a [S::Velocity],
}

/// Runs a scene as [`simulate`] does, for one who sees where the bodies are before every step.
///
/// # Errors
/// As [`simulate`].
pub fn observe<S: Mechanics>(
    world: &World<S>,
    options: &Options,
    watch: &mut dyn FnMut(Moment<S>) -> bool,
) -> Result<Simulation<S>, SimulationError> {
    song_pang_kumar::check_shapes(world)?;
    let step = options.step.or(world.step).unwrap_or(1e-3);
    let choice = |chosen| ModelChoice { chosen, step, ..ModelChoice::default() };
    let is_adverse = options.policy == Policy::Adverse;
    if is_adverse && !adverse::is_known_for(world, options.model) {
        return Err(SimulationError::Adverse);
    }
    match options.model {
        ModelKind::SongPangKumar => {
            song_pang_kumar::check(world)?;
            let mut stepper = SongPangKumar::new(world, options.second_order);
            let mut simulation = run::run(world, options, choice("spk"), &mut stepper, watch);
            simulation.notes.splice(0..0, song_pang_kumar::notes(world, step, options.second_order));
            Ok(simulation)
        }
        ModelKind::Auto | ModelKind::StewartTrinkle if is_adverse => {
            let mut stepper = StewartTrinkle::new(world, options.recovery_speed.unwrap_or(f64::INFINITY));
            stepper.is_adverse = true;
            Ok(run::run(world, options, choice("st"), &mut stepper, watch))
        }
        ModelKind::StewartTrinkle => {
            let recovery_speed = options.recovery_speed.unwrap_or(f64::INFINITY);
            let restitutes = world.materials.iter().any(|material| material.restitution.coefficient() > 0.0);
            Ok(if restitutes {
                run::run(world, options, choice("st"), &mut Stopped::new(world, recovery_speed), watch)
            } else {
                run::run(world, options, choice("st"), &mut StewartTrinkle::new(world, recovery_speed), watch)
            })
        }
        ModelKind::Auto => ladder::climb(world, options, watch),
        ModelKind::Moreau => Ok(run::run(world, options, choice("moreau"), &mut Moreau::new(world), watch)),
    }
}
