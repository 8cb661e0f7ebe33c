//! Time-steppers for rigid bodies with friction: floats, verified step by step.

mod options;

pub use options::{ModelKind, Options};

use crate::answer::Simulation;
use crate::model::{Space, World};

/// Runs a scene.
///
/// `watch` is told the time reached after every step and ends the run, marked partial, by answering `false`.
pub fn simulate<S: Space>(_world: &World<S>, _options: &Options, _watch: &mut dyn FnMut(f64) -> bool) -> Simulation<S> {
    todo!("the steppers")
}
