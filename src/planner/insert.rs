//! Insertion against fixels: the wrenches that seat the part whatever the contacts do.

use super::fingers::{Wrenches, arc_set, finger_set, tilt_plane};
use super::recommend::{Margins, recommend};
use super::sets::{Question, Sets, Task};
use super::to_answer::region_answer;
use crate::answer::{EmptyReason, Insertion};
use crate::cone::{Cone, Generators, Pair, complement, subtract};
use crate::exact::{Int, Ladder, Matrix, Overflow, Rung, climb};
use crate::mechanics::{ContactRows, Mode, ModeError};
use crate::model::{Fixture, Part};

/// The wrenches guaranteed to seat the part from every state, and the best simple way to apply one.
///
/// # Source
/// Balkcom & Trinkle (2002), §8 and §9: the complement of all transitions that do not add a contact, formula (21) and
/// the twelve sets of Table 5, for any number of fixels.
///
/// # Errors
/// [`ModeError::Length`] for a mode asked for with another number of letters than fixels.
pub fn insertion(part: &Part, fixture: &Fixture, question: &Question) -> Result<Insertion, ModeError> {
    Ok(climb(&Inserting(Task::of(part, fixture, question)?), Rung::Word).0)
}

struct Inserting<'a>(Task<'a>);

impl Ladder for Inserting<'_> {
    type Output = Insertion;

    fn run<T: Int>(&self) -> Result<Insertion, Overflow> {
        let task = &self.0;
        let sets = Sets::<T>::of(task)?;
        let (modes, holes): (Vec<Mode>, Vec<Cone<T>>) = sets.goal_holes.clone().unwrap_or_default().into_iter().unzip();
        let is_known_empty = sets.goal_holes.is_none();
        let cells = if is_known_empty { Vec::new() } else { complement(3, &holes)? };
        let wrenches = if is_known_empty { Wrenches::Nothing } else { Wrenches::Outside(&holes) };
        let hold = without(&cells, &sets.strong_holes)?;
        let fingers = finger_set(task.part, &task.pushes, &wrenches)?;
        let tilt = arc_set(&tilt_plane(), &wrenches)?;
        let margins = Margins::of(&holes, task.part.gyration2());
        let inner = cells.iter().map(Cone::inner_point).collect::<Result<Vec<_>, _>>()?;
        Ok(Insertion {
            goal: region_answer(&cells, holes.is_empty() && !is_known_empty, &task.reach)?,
            hold: region_answer(
                &hold,
                holes.is_empty() && !is_known_empty && sets.strong_holes.is_empty(),
                &task.reach,
            )?,
            empty_because: if cells.is_empty() { Some(empty_because(&sets.contacts, &modes, &holes)?) } else { None },
            plan: recommend(task.part, &task.pushes, &fingers, &tilt, &inner, &margins),
            fingers,
            tilt,
            wrenches: sets.verdicts(task.question)?,
            modes: sets.asked_cones(),
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
            let balanced = Pair::from_generators(&Generators { lines: Matrix::new(3), rays })?;
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
