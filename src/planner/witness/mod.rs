//! Why a wrench is outside of a set: the motions, steps and cycles that it makes possible.

mod motion;

use super::sets::{Sets, Task, pivoting_systems};
use super::transitions;
use crate::answer::{Motion, Step, Witness, WrenchVerdict};
use crate::cone::{Pair, nearest, summands};
use crate::exact::{Int, Matrix, Overflow, Q, on_rung, primitive_row};
use crate::mechanics::{Frame, Interaction};
use motion::{Pushed, still};
use num_traits::{One as _, Signed as _, Zero as _};

/// What shows that `verdict` is right, and all modes that are consistent with its wrench.
///
/// # Source
/// Balkcom & Trinkle (2002), §7: weak and strong stability; §8, 9: transitions; Fig. 4(c, d): indeterminacy.
pub(super) fn witness<T: Int>(sets: &Sets<T>, task: &Task, verdict: &WrenchVerdict) -> Result<Witness, Overflow> {
    let frames = Frame::of(task.part, task.fixture);
    let pushed = Pushed { part: task.part, frames, contacts: &sets.contacts, wrench: &verdict.wrench };
    let row = on_rung::<T>(&primitive_row(&verdict.wrench))?;
    let mut consistent = Vec::new();
    for mode in &sets.feasible {
        consistent.extend(pushed.motion(&mode.0, true)?);
    }
    let persisting = if sets.transitions.is_none() { unpressed(&pushed)? } else { None };
    Ok(Witness {
        weak: if verdict.weak { pushed.balance()? } else { None },
        strong: if verdict.strong { None } else { moving(&pushed, &consistent)? },
        goal: match &sets.goal_holes {
            Some(_) if verdict.goal => None,
            Some(holes) => {
                let mut step = None;
                for (mode, hole) in holes {
                    if hole.contains(&row)? {
                        step = not_adding(&pushed, &mode.0)?;
                        break;
                    }
                }
                step
            }
            None => match &persisting {
                Some(mode) => not_adding(&pushed, &one_separating(mode))?,
                None => None,
            },
        },
        acyclic: match &sets.transitions {
            Some(_) if verdict.acyclic => None,
            Some(graph) => cycle(&pushed, &graph.cycle(&row)?)?,
            None => match &persisting {
                Some(mode) => persistence(&pushed, mode)?.map(|step| vec![step]),
                None => None,
            },
        },
        unrefuted: if verdict.unrefuted { None } else { refuting(&pushed, &consistent)? },
        consistent,
    })
}

/// A motion of the seated part that is not rest.
fn moving<T: Int>(pushed: &Pushed<T>, consistent: &[Motion]) -> Result<Option<Motion>, Overflow> {
    let moves = |motion: &&Motion| motion.acceleration.iter().any(|value| !value.is_zero());
    if let Some(motion) = consistent.iter().find(moves) {
        return Ok(Some(motion.clone()));
    }
    let rolling = vec![Interaction::Roll; pushed.frames.len()];
    for system in pivoting_systems(pushed.contacts)? {
        if let Some(motion) = pushed.within(&system, &rolling)? {
            return Ok(Some(motion));
        }
    }
    Ok(None)
}

/// The step of a mode of formula (21): the contact `s` is lost.
fn not_adding<T: Int>(pushed: &Pushed<T>, mode: &[Interaction]) -> Result<Option<Step>, Overflow> {
    let state = |letters: &[Interaction]| state(mode, |interaction| letters.contains(&interaction));
    let (from, to) = (state(&[Interaction::Maintain, Interaction::Separate]), state(&[Interaction::Maintain]));
    Ok(pushed.motion(mode, false)?.map(|motion| Step { from, to, motion }))
}

/// The steps around a cycle of states, each a set of contacts as bits.
fn cycle<T: Int>(pushed: &Pushed<T>, states: &[usize]) -> Result<Option<Vec<Step>>, Overflow> {
    let n = pushed.frames.len();
    let contacts = |state: usize| (0..n).filter(|contact| state >> contact & 1 == 1).collect::<Vec<_>>();
    let mut steps = Vec::new();
    for (from, to) in states.iter().zip(states.iter().cycle().skip(1)) {
        let Some(step) = transitions::Step::between(*from, *to, n) else { return Ok(None) };
        let Some(motion) = pushed.motion(&step.mode, step.strict_s)? else { return Ok(None) };
        steps.push(Step { from: contacts(*from), to: contacts(*to), motion });
    }
    Ok(Some(steps))
}

/// A rest on all contacts but one, else a break of the seated part's contacts.
fn refuting<T: Int>(pushed: &Pushed<T>, consistent: &[Motion]) -> Result<Option<Step>, Overflow> {
    let n = pushed.frames.len();
    for free in 0..n {
        let letter = |contact| if contact == free { Interaction::Separate } else { Interaction::Roll };
        let mode: Vec<Interaction> = (0..n).map(letter).collect();
        if let Some(motion) = pushed.rest(&mode)? {
            let on = state(&mode, |interaction| interaction == Interaction::Roll);
            return Ok(Some(Step { from: on.clone(), to: on, motion }));
        }
    }
    let breaks = Interaction::Separate.letter();
    Ok(consistent.iter().find(|motion| motion.mode.contains(breaks)).map(|motion| Step {
        from: (0..n).collect(),
        to: motion.mode.char_indices().filter(|(_, letter)| *letter != breaks).map(|(contact, _)| contact).collect(),
        motion: motion.clone(),
    }))
}

/// The mode in which a state persists if the normals are dependent: `m` on its contacts, `s` elsewhere.
///
/// The accelerations nearest to those of the free part, in the metric of kinetic energy, among those that penetrate no
/// fixel (Gauss) solve the model without friction. Their forces are a basic solution, so they act on independent
/// contacts only: not on all. Those keep their contact, the others do not approach.
fn unpressed<T: Int>(pushed: &Pushed<T>) -> Result<Option<Vec<Interaction>>, Overflow> {
    let mut separating = Matrix::new(3);
    pushed.contacts.iter().for_each(|contact| separating.push_negated(&contact.normal_acceleration));
    let allowed = Pair::from_normals(&Matrix::new(3), &separating)?;
    let weights = [Q::one(), Q::one(), pushed.part.gyration2().recip()];
    let least = nearest(&allowed, &weights, pushed.wrench)?;
    let borne: Vec<Q> = pushed.wrench.iter().zip(&least).map(|(all, rest)| all - rest).collect();
    let presses: Vec<Vec<Q>> = pushed.frames.iter().map(|frame| frame.balanced(&Q::zero()).to_vec()).collect();
    let letter = |weight: &Q| if weight.is_positive() { Interaction::Maintain } else { Interaction::Separate };
    let found = summands(&still::<T>(), &presses, &borne)?;
    Ok(found.map(|found| found.weights.iter().map(letter).collect()))
}

/// The step from the state of [`unpressed`] to itself.
fn persistence<T: Int>(pushed: &Pushed<T>, mode: &[Interaction]) -> Result<Option<Step>, Overflow> {
    let on = state(mode, |interaction| interaction == Interaction::Maintain);
    Ok(pushed.motion(mode, false)?.map(|motion| Step { from: on.clone(), to: on, motion }))
}

/// The mode with its first `s` only, the others `u`: one of formula (21), and weaker.
fn one_separating(mode: &[Interaction]) -> Vec<Interaction> {
    let first = mode.iter().position(|interaction| *interaction == Interaction::Separate);
    let weaker = |(contact, interaction): (usize, &Interaction)| match interaction {
        Interaction::Separate if Some(contact) != first => Interaction::Unconstrained,
        other => *other,
    };
    mode.iter().enumerate().map(weaker).collect()
}

/// The contacts whose interaction satisfies `is_on`.
fn state(mode: &[Interaction], is_on: impl Fn(Interaction) -> bool) -> Vec<usize> {
    (0..mode.len()).filter(|contact| is_on(mode[*contact])).collect()
}
