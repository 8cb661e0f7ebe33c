//! Insertion against fixels: the wrenches that seat the part whatever the contacts do.

use super::critical::{critical_friction, nearest_change};
use super::fingers::{arc_set, finger_set, tilt_plane};
use super::robust::robust;
use super::seating::Seating;
use super::sets::{Question, Sets, Task};
use super::to_answer::region_answer;
use crate::answer::{EmptyReason, Insertion};
use crate::cone::{Cone, Pair, complement, subtract};
use crate::exact::{Int, Ladder, Matrix, Overflow, Rung, climb};
use crate::mechanics::{ContactRows, Mode, ModeError};
use crate::model::{Fixture, Part};

/// The wrenches guaranteed to seat the part from every state, and the best simple way to apply one.
///
/// Two sets guarantee that: `goal`, under which every possible transition adds a contact, and the larger `acyclic`, under
/// which no sequence of possible transitions goes on for ever. The plan is the best of the larger.
///
/// # Source
/// Balkcom & Trinkle (2002), §8 and §9: the complement of all transitions that do not add a contact, formula (21) and
/// the twelve sets of Table 5, for any number of fixels; `acyclic` answers the question left open at the end of §9.
///
/// # Errors
/// [`ModeError::Length`] for a mode asked for with another number of letters than fixels.
pub fn insertion(part: &Part, fixture: &Fixture, question: &Question) -> Result<Insertion, ModeError> {
    let mut answer = climb(&Inserting(Task::of(part, fixture, question)?), Rung::Word).0;
    if question.critical {
        let critical = critical_friction(part, fixture, &answer);
        answer.nearest_change = answer.acyclic.is_empty().then(|| nearest_change(part, fixture, &critical));
        answer.critical_friction = Some(critical);
    }
    Ok(answer)
}

struct Inserting<'a>(Task<'a>);

impl Ladder for Inserting<'_> {
    type Output = Insertion;

    fn run<T: Int>(&self) -> Result<Insertion, Overflow> {
        let task = &self.0;
        let sets = Sets::<T>::of(task)?;
        let (modes, holes): (Vec<Mode>, Vec<Cone<T>>) = sets.goal_holes.clone().unwrap_or_default().into_iter().unzip();
        let goal = if sets.goal_holes.is_some() { complement(3, &holes)? } else { Vec::new() };
        let Seating { acyclic, cyclic, fingers: acyclic_fingers, tilt: acyclic_tilt, plan } =
            Seating::of(task.part, &task.pushes, sets.transitions.as_ref())?;
        let region = |cells: &[Cone<T>]| region_answer(cells, &task.reach);
        let [robust, robust_acyclic] = if task.question.robust {
            let rho2 = task.part.gyration2();
            let loops = sets.transitions.iter().flat_map(|transitions| &transitions.loops);
            let acyclic_holes: Vec<&Cone<T>> = loops.chain(&cyclic).collect();
            let of_goal = robust(&holes.iter().collect::<Vec<_>>(), &goal, &rho2, None)?;
            let of_acyclic = robust(&acyclic_holes, &acyclic, &rho2, of_goal.as_ref())?;
            [of_goal, of_acyclic]
        } else {
            [None, None]
        };
        Ok(Insertion {
            goal: region(&goal)?,
            acyclic: region(&acyclic)?,
            hold: region(&without(&goal, &sets.strong_holes)?)?,
            unrefuted: region(&complement(3, &sets.refuting)?)?,
            empty_because: if acyclic.is_empty() { Some(empty_because(&sets.contacts, &modes, &holes)?) } else { None },
            plan,
            goal_fingers: finger_set(task.part, &task.pushes, &goal)?,
            acyclic_fingers,
            goal_tilt: arc_set(&tilt_plane(), &goal)?,
            acyclic_tilt,
            wrenches: sets.verdicts(task)?,
            modes: sets.asked_cones(),
            robust,
            robust_acyclic,
            critical_friction: None,
            nearest_change: None,
        })
    }
}

fn without<T: Int>(cells: &[Cone<T>], holes: &[Cone<T>]) -> Result<Vec<Cone<T>>, Overflow> {
    let mut cells = cells.to_vec();
    for hole in holes {
        cells = cells.iter().map(|cell| subtract(cell, hole)).collect::<Result<Vec<_>, _>>()?.concat();
    }
    Ok(cells)
}

/// Why the complement of `holes` is empty.
fn empty_because<T: Int>(
    contacts: &[ContactRows<T>],
    modes: &[Mode],
    holes: &[Cone<T>],
) -> Result<EmptyReason, Overflow> {
    if holes.is_empty() {
        return Ok(EmptyReason::DependentNormals);
    }
    for second in 0..contacts.len() {
        for first in 0..second {
            let forces = [&contacts[first].static_forces, &contacts[second].static_forces];
            let rays = Matrix::from_rows(3, forces.into_iter().flatten());
            let balanced = Pair::from_rays(rays)?;
            if balanced.lines().len() == 3 {
                return Ok(EmptyReason::PairForceClosure { fixels: [first, second] });
            }
        }
    }
    let mut needed: Vec<usize> = (0..holes.len()).collect();
    for hole in 0..holes.len() {
        let rest: Vec<Cone<T>> = needed.iter().filter(|n| **n != hole).map(|n| holes[*n].clone()).collect();
        if complement(3, &rest)?.is_empty() {
            needed.retain(|n| *n != hole);
        }
    }
    Ok(EmptyReason::BlockingModes { modes: needed.iter().map(|hole| modes[*hole].to_string()).collect() })
}
