//! Weak and strong stability of the seated part.

use super::fingers::{arc_set, finger_set, tilt_plane};
use super::sets::{Question, Sets, Task};
use super::to_answer::{cone_answer, region_answer};
use crate::answer::Stability;
use crate::cone::{Cone, HalfSpaces, complement};
use crate::exact::{Int, Ladder, Overflow, Rung, climb};
use crate::mechanics::ModeError;
use crate::model::{Fixture, Part};

/// Which wrenches the seated part resists: weakly (some solution is at rest) and strongly (every solution is).
///
/// # Source
/// Balkcom & Trinkle (2002), §7, formula (19); strong stability takes `s` as breaking contact (`a_n > 0`).
///
/// # Errors
/// [`ModeError::Length`] for a mode asked for with another number of letters than fixels.
pub fn stability(part: &Part, fixture: &Fixture, question: &Question) -> Result<Stability, ModeError> {
    Ok(climb(&Resting(Task::of(part, fixture, question)?), Rung::Word).0)
}

struct Resting<'a>(Task<'a>);

impl Ladder for Resting<'_> {
    type Output = Stability;

    fn run<T: Int>(&self) -> Result<Stability, Overflow> {
        let task = &self.0;
        let sets = Sets::<T>::of(task)?;
        let cells = complement(3, &sets.strong_holes)?;
        let interior = interior(&sets.weak)?;
        let weak = std::slice::from_ref(&sets.weak);
        let fingers = |cells: &[Cone<T>]| finger_set(task.part, &task.pushes, cells);
        Ok(Stability {
            weak: cone_answer(Some(&sets.weak)),
            force_closure: sets.weak.is_everything(),
            strong: region_answer(&cells, &task.reach)?,
            feasible_modes: sets.feasible.iter().map(ToString::to_string).collect(),
            closure_fingers: fingers(interior.as_slice())?,
            weak_fingers: fingers(weak)?,
            strong_fingers: fingers(&cells)?,
            weak_tilt: arc_set(&tilt_plane(), weak)?,
            strong_tilt: arc_set(&tilt_plane(), &cells)?,
            wrenches: sets.verdicts(task)?,
            modes: sets.asked_cones(),
        })
    }
}

/// The interior of a closed cone, `None` if it has none.
fn interior<T: Int>(cone: &Cone<T>) -> Result<Option<Cone<T>>, Overflow> {
    if cone.closure().dim() < cone.closure().ambient() {
        return Ok(None);
    }
    let mut open = HalfSpaces::none(cone.closure().ambient());
    open.strict = cone.closure().facets().clone();
    Cone::from_half_spaces(&open)
}
