//! The sets of wrenches that stability and insertion are made of.

use super::fingers::Pushes;
use super::to_answer::cone_answer;
use super::transitions::Transitions;
use super::witness::witness;
use crate::answer::{Cone as ConeAnswer, Witness, WrenchVerdict};
use crate::cone::{Cone, HalfSpaces, Pair};
use crate::exact::{Int, Ladder, Matrix, Overflow, Q, Rung, climb, on_rung, primitive_row};
use crate::mechanics::{
    Contact, ContactRows, Interaction, Mode, ModeError, acceleration_system, balanced_cone, feasible_modes, force_rays,
    mode_cone,
};
use crate::model::{Fixture, Part};

/// What is asked besides the sets themselves.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Question {
    /// Wrenches to judge, `[fx, fy, torque about the center of mass]`.
    pub wrenches: Vec<[Q; 3]>,
    /// Modes whose cones are wanted.
    pub modes: Vec<Mode>,
    /// Whether the letter `s` of those modes means `a_n > 0` rather than `a_n ≥ 0`.
    pub strict_s: bool,
    /// Whether the most robust wrench is wanted: a search that costs as much as all the rest of a plan.
    pub robust: bool,
    /// Whether it is wanted how much friction the sets and the plan bear, and what would open an empty one.
    pub critical: bool,
}

/// The cones of the modes asked for, in the order asked.
///
/// # Errors
/// [`ModeError::Length`] for a mode with another number of letters than fixels.
pub fn mode_cones(part: &Part, fixture: &Fixture, question: &Question) -> Result<Vec<(String, ConeAnswer)>, ModeError> {
    check_modes(fixture, question)?;
    let job = ModeCones { contacts: Contact::of(part, fixture), question };
    Ok(climb(&job, Rung::Word).0)
}

struct ModeCones<'a> {
    contacts: Vec<Contact>,
    question: &'a Question,
}

impl Ladder for ModeCones<'_> {
    type Output = Vec<(String, ConeAnswer)>;

    fn run<T: Int>(&self) -> Result<Self::Output, Overflow> {
        let contacts = contacts_on_rung::<T>(&self.contacts)?;
        let asked = asked_modes(&contacts, self.question)?;
        Ok(asked.iter().map(|(name, cone)| (name.clone(), cone_answer(cone.as_ref()))).collect())
    }
}

/// What every planner works from, in integers of any size.
pub(super) struct Task<'a> {
    pub(super) part: &'a Part,
    pub(super) fixture: &'a Fixture,
    pub(super) question: &'a Question,
    pub(super) contacts: Vec<Contact>,
    pub(super) pushes: Pushes,
    /// Half-width of the torque axis of the box that measures volumes.
    pub(super) reach: Q,
}

impl<'a> Task<'a> {
    pub(super) fn of(part: &'a Part, fixture: &'a Fixture, question: &'a Question) -> Result<Self, ModeError> {
        check_modes(fixture, question)?;
        let contacts = Contact::of(part, fixture);
        Ok(Self { part, fixture, question, contacts, pushes: Pushes::of(part), reach: part.torque_reach() })
    }
}

/// Everything that decides where a wrench belongs.
pub(super) struct Sets<T> {
    pub(super) contacts: Vec<ContactRows<T>>,
    /// Balanced at the least static friction.
    pub(super) weak: Cone<T>,
    /// Kinematically feasible modes.
    pub(super) feasible: Vec<Mode>,
    /// Cones outside of which the seated part cannot move.
    pub(super) strong_holes: Vec<Cone<T>>,
    /// Cones outside of which the part seats from every state, with their modes; `None` if together they are known to
    /// cover everything because the normals' wrenches are dependent.
    pub(super) goal_holes: Option<Vec<ModeCone<T>>>,
    /// The transition graph; `None` as for `goal_holes`, for then some unseated state can always persist.
    pub(super) transitions: Option<Transitions<T>>,
    /// Cones outside of which insertion from rest is not refuted.
    pub(super) refuting: Vec<Cone<T>>,
    asked: Vec<AskedCone<T>>,
}

/// A mode and its wrenches.
type ModeCone<T> = (Mode, Cone<T>);

/// A mode that was asked for, by name, and its wrenches if it has any.
type AskedCone<T> = (String, Option<Cone<T>>);

impl<T: Int> Sets<T> {
    pub(super) fn of(task: &Task) -> Result<Self, Overflow> {
        let contacts = contacts_on_rung::<T>(&task.contacts)?;
        let feasible = feasible_modes(&contacts)?;
        let moving = moving_cones(&contacts, &feasible)?;
        let is_independent = are_independent(&contacts)?;
        Ok(Self {
            weak: balanced_cone(&contacts)?,
            refuting: refuting_cones(&contacts, &moving)?,
            strong_holes: moving.into_iter().map(|(_, cone)| cone).collect(),
            goal_holes: is_independent.then(|| transition_cones(&contacts)).transpose()?,
            transitions: is_independent.then(|| Transitions::of(&contacts)).transpose()?,
            feasible: feasible.into_iter().map(Mode).collect(),
            asked: asked_modes(&contacts, task.question)?,
            contacts,
        })
    }

    /// Verdicts on the wrenches that are asked about, each with what shows it.
    pub(super) fn verdicts(&self, task: &Task) -> Result<Vec<WrenchVerdict>, Overflow> {
        let judged = |wrench| {
            let verdict = self.verdict(wrench)?;
            Ok(WrenchVerdict { witness: witness(self, task, &verdict)?, ..verdict })
        };
        task.question.wrenches.iter().map(judged).collect()
    }

    fn verdict(&self, wrench: &[Q; 3]) -> Result<WrenchVerdict, Overflow> {
        let row = on_rung::<T>(&primitive_row(wrench))?;
        let is_outside = |holes: &mut dyn Iterator<Item = &Cone<T>>| {
            holes.map(|hole| hole.contains(&row)).try_fold(true, |outside, inside| Ok(outside && !inside?))
        };
        let (goal_holes, transitions) = (self.goal_holes.as_ref(), self.transitions.as_ref());
        let goal = goal_holes.map(|holes| is_outside(&mut holes.iter().map(|(_, cone)| cone))).transpose()?;
        let acyclic = transitions.map(|transitions| transitions.is_acyclic(&row)).transpose()?;
        let mut modes = Vec::new();
        for (name, cone) in &self.asked {
            if let Some(cone) = cone
                && cone.contains(&row)?
            {
                modes.push(name.clone());
            }
        }
        Ok(WrenchVerdict {
            wrench: wrench.clone(),
            weak: self.weak.contains(&row)?,
            strong: is_outside(&mut self.strong_holes.iter())?,
            goal: goal == Some(true),
            acyclic: acyclic == Some(true),
            unrefuted: is_outside(&mut self.refuting.iter())?,
            modes,
            witness: Witness::default(),
        })
    }

    pub(super) fn asked_cones(&self) -> Vec<(String, ConeAnswer)> {
        self.asked.iter().map(|(name, cone)| (name.clone(), cone_answer(cone.as_ref()))).collect()
    }
}

/// Checks that every mode asked for has one letter per fixel.
fn check_modes(fixture: &Fixture, question: &Question) -> Result<(), ModeError> {
    let fixels = fixture.fixels.len();
    match question.modes.iter().find(|mode| mode.0.len() != fixels) {
        Some(mode) => Err(ModeError::Length { letters: mode.0.len(), fixels }),
        None => Ok(()),
    }
}

pub(super) fn contacts_on_rung<T: Int>(contacts: &[Contact]) -> Result<Vec<ContactRows<T>>, Overflow> {
    contacts.iter().map(Contact::on_rung).collect()
}

fn asked_modes<T: Int>(contacts: &[ContactRows<T>], question: &Question) -> Result<Vec<AskedCone<T>>, Overflow> {
    let cone = |mode: &Mode| Ok((mode.to_string(), mode_cone(contacts, &mode.0, question.strict_s)?));
    question.modes.iter().map(cone).collect()
}

/// The cones of all feasible modes in which the seated part moves, formula (19).
///
/// Contacts at a single point let `n..n` pivot about it, which is motion too.
fn moving_cones<T: Int>(
    contacts: &[ContactRows<T>],
    feasible: &[Vec<Interaction>],
) -> Result<Vec<ModeCone<T>>, Overflow> {
    let rest = vec![Interaction::Roll; contacts.len()];
    let mut cones = Vec::new();
    for mode in feasible.iter().filter(|mode| **mode != rest) {
        cones.extend(mode_cone(contacts, mode, true)?.map(|cone| (Mode(mode.clone()), cone)));
    }
    for system in pivoting_systems(contacts)? {
        let turning = Cone::from_half_spaces_plus(&system, &force_rays(contacts, &rest))?;
        cones.extend(turning.map(|cone| (Mode(rest.clone()), cone)));
    }
    Ok(cones)
}

/// The accelerations that turn the part, either way, while it rolls on every contact; none unless all are at one point.
pub(super) fn pivoting_systems<T: Int>(contacts: &[ContactRows<T>]) -> Result<Vec<HalfSpaces<T>>, Overflow> {
    let fixed = acceleration_system(contacts, &vec![Interaction::Roll; contacts.len()], true);
    let still = Pair::from_normals(&fixed.equalities, &fixed.closed)?;
    let ways = still.lines().rows().flat_map(|pivot| [pivot.to_vec(), pivot.iter().map(T::negated).collect()]);
    Ok(ways.map(|way| HalfSpaces { strict: Matrix::from_rows(3, [way]), ..fixed.clone() }).collect())
}

/// The cones of the n 2^(n-1) transitions that do not add a contact: `s` at one fixel, `m` on any of the others, `u` on
/// the rest, formula (21) and Table 5.
pub(super) fn transition_cones<T: Int>(contacts: &[ContactRows<T>]) -> Result<Vec<ModeCone<T>>, Overflow> {
    let n = contacts.len();
    let mut modes = Vec::new();
    for separating in 0..n {
        for maintained in (0..1_u32 << n).filter(|set| set >> separating & 1 == 0) {
            let letter = |contact: usize| match contact {
                _ if contact == separating => Interaction::Separate,
                _ if maintained >> contact & 1 == 1 => Interaction::Maintain,
                _ => Interaction::Unconstrained,
            };
            modes.push((maintained.count_ones(), (0..n).map(letter).collect::<Vec<_>>()));
        }
    }
    // half-spaces first: what they leave is small and simple
    modes.sort();
    let mut cones = Vec::new();
    for (_, mode) in modes {
        if let Some(cone) = mode_cone(contacts, &mode, false)? {
            cones.push((Mode(mode), cone));
        }
    }
    Ok(cones)
}

/// Whether the normals' wrenches are linearly independent.
///
/// If they are not, no wrench is sure to seat the part: whatever it is, the frictionless least-constraint problem has a
/// solution whose forces act on independent contacts only, so some contact carries none and does not approach while
/// those that carry force are maintained. That state persists.
pub(super) fn are_independent<T: Int>(contacts: &[ContactRows<T>]) -> Result<bool, Overflow> {
    let normals = Matrix::from_rows(3, contacts.iter().map(|contact| &contact.normal_acceleration));
    Ok(contacts.len() <= 3 && 3 - Pair::from_normals(&normals, &Matrix::new(3))?.dim() == contacts.len())
}

/// The cones of the wrenches under which an unseated part can rest on the contacts that it has (all but one at the most,
/// at the largest static friction), or a contact of the seated part can break.
fn refuting_cones<T: Int>(contacts: &[ContactRows<T>], moving: &[ModeCone<T>]) -> Result<Vec<Cone<T>>, Overflow> {
    let mut cones = Vec::new();
    for free in 0..contacts.len() {
        let others = contacts.iter().enumerate().filter(|(index, _)| *index != free);
        let rays = Matrix::from_rows(3, others.flat_map(|(_, contact)| &contact.static_forces));
        cones.push(Pair::from_rays(rays)?.into());
    }
    let breaking = moving.iter().filter(|(mode, _)| mode.0.contains(&Interaction::Separate));
    cones.extend(breaking.map(|(_, cone)| cone.clone()));
    Ok(cones)
}
