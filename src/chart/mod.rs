//! Error against time for every method of the crate, and where methods fail.

pub mod contacts;

mod complementarity;
mod cone;
#[cfg(feature = "float-cone")]
mod float_cone;
mod gauss_seidel;
mod ladder;
mod maps;
mod measure;
mod scenes;
mod stepping;
mod throw;
mod toppling;

use crate::answer::{Chart, ChartFamily};
use crate::model::Scene;
use measure::Measure;

/// What is to be measured.
#[derive(Debug, Clone, Default)]
pub struct ChartQuestion {
    /// Fewer points, fewer runs.
    pub quick: bool,
    /// From which random work is drawn.
    pub seed: u64,
    /// Only points and tiles whose ids begin like this, if given.
    pub only: Option<String>,
    /// Scenes to be measured instead of the built-in work, with their names.
    pub scenes: Vec<(String, Scene)>,
}

/// Where the measurements are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ChartProgress {
    /// Points and tiles measured.
    pub done: usize,
    /// What is measured.
    pub part: &'static str,
}

/// Measures methods against each other, each on the same work; `watch` says before each point, and on the way of long ones,
/// whether to go on.
///
/// Errors and failures are the same for a seed; times are CPU times of this thread, quartiles over repeated runs.
#[must_use]
pub fn chart(question: &ChartQuestion, watch: &dyn Fn(ChartProgress) -> bool) -> Chart {
    let mut measure = Measure::new(question, watch);
    if question.scenes.is_empty() {
        stepping::built_in(&mut measure);
        ladder::built_in(&mut measure);
        complementarity::measure(&mut measure);
        cone::measure(&mut measure);
        toppling::measure(&mut measure);
        throw::measure(&mut measure);
        maps::measure(&mut measure);
    } else {
        for (name, scene) in &question.scenes {
            match scene {
                Scene::Planar(world) => stepping::scene(&mut measure, name, world),
                Scene::Spatial(world) => stepping::scene(&mut measure, name, world),
            }
        }
    }
    measure.into_chart()
}

/// Names of what may be asked for by [`ChartQuestion::only`]: families and maps.
#[must_use]
pub fn parts() -> Vec<&'static str> {
    let families = ChartFamily::ALL.into_iter().map(ChartFamily::name);
    families.chain(crate::answer::ChartMap::ALL.into_iter().map(crate::answer::ChartMap::name)).collect()
}
