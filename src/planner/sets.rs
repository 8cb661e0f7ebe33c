//! The sets of wrenches that stability and insertion are made of.

use super::fingers::Pushes;
use super::to_answer::cone_answer;
use crate::answer::{Cone as ConeAnswer, WrenchVerdict};
use crate::cone::{Cone, HalfSpaces, Pair};
use crate::exact::{Int, Ladder, Matrix, Overflow, Q, Rung, climb, primitive_row};
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
        let contacts = on_rung::<T>(&self.contacts)?;
        let asked = asked_modes(&contacts, self.question)?;
        Ok(asked.iter().map(|(name, cone)| (name.clone(), cone_answer(cone.as_ref()))).collect())
    }
}

/// What every planner works from, in integers of any size.
pub(super) struct Task<'a> {
    pub(super) part: &'a Part,
    pub(super) question: &'a Question,
    pub(super) contacts: Vec<Contact>,
    pub(super) pushes: Pushes,
    /// Half-width of the torque axis of the box that measures volumes.
    pub(super) reach: Q,
}

impl<'a> Task<'a> {
    pub(super) fn of(part: &'a Part, fixture: &Fixture, question: &'a Question) -> Result<Self, ModeError> {
        check_modes(fixture, question)?;
        let contacts = Contact::of(part, fixture);
        Ok(Self { part, question, contacts, pushes: Pushes::of(part), reach: part.torque_reach() })
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
    asked: Vec<AskedCone<T>>,
}

/// A mode and its wrenches.
type ModeCone<T> = (Mode, Cone<T>);

/// A mode that was asked for, by name, and its wrenches if it has any.
type AskedCone<T> = (String, Option<Cone<T>>);

impl<T: Int> Sets<T> {
    pub(super) fn of(task: &Task) -> Result<Self, Overflow> {
        let contacts = on_rung::<T>(&task.contacts)?;
        let feasible = feasible_modes(&contacts)?;
        Ok(Self {
            weak: balanced_cone(&contacts)?,
            strong_holes: moving_cones(&contacts, &feasible)?,
            feasible: feasible.into_iter().map(Mode).collect(),
            goal_holes: transition_cones(&contacts)?,
            asked: asked_modes(&contacts, task.question)?,
            contacts,
        })
    }

    pub(super) fn verdicts(&self, question: &Question) -> Result<Vec<WrenchVerdict>, Overflow> {
        question.wrenches.iter().map(|wrench| self.verdict(wrench)).collect()
    }

    fn verdict(&self, wrench: &[Q; 3]) -> Result<WrenchVerdict, Overflow> {
        let row = primitive_row(wrench).iter().map(T::from_z).collect::<Option<Vec<T>>>().ok_or(Overflow)?;
        let mut strong = true;
        for hole in &self.strong_holes {
            strong &= !hole.contains(&row)?;
        }
        let mut goal = self.goal_holes.is_some();
        for (_, hole) in self.goal_holes.iter().flatten() {
            goal &= !hole.contains(&row)?;
        }
        let mut modes = Vec::new();
        for (name, cone) in &self.asked {
            if let Some(cone) = cone
                && cone.contains(&row)?
            {
                modes.push(name.clone());
            }
        }
        Ok(WrenchVerdict { wrench: wrench.clone(), weak: self.weak.contains(&row)?, strong, goal, modes })
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

fn on_rung<T: Int>(contacts: &[Contact]) -> Result<Vec<ContactRows<T>>, Overflow> {
    contacts.iter().map(Contact::on_rung).collect()
}

fn asked_modes<T: Int>(contacts: &[ContactRows<T>], question: &Question) -> Result<Vec<AskedCone<T>>, Overflow> {
    let cone = |mode: &Mode| Ok((mode.to_string(), mode_cone(contacts, &mode.0, question.strict_s)?));
    question.modes.iter().map(cone).collect()
}

/// The cones of all feasible modes in which the seated part moves, formula (19).
///
/// Contacts at a single point let `n..n` pivot about it, which is motion too.
fn moving_cones<T: Int>(contacts: &[ContactRows<T>], feasible: &[Vec<Interaction>]) -> Result<Vec<Cone<T>>, Overflow> {
    let rest = vec![Interaction::Roll; contacts.len()];
    let mut cones = Vec::new();
    for mode in feasible.iter().filter(|mode| **mode != rest) {
        cones.extend(mode_cone(contacts, mode, true)?);
    }
    let fixed = acceleration_system(contacts, &rest, true);
    let still = Pair::from_normals(&fixed.equalities, &fixed.closed)?;
    for pivot in still.lines().rows() {
        let opposite: Vec<T> = pivot.iter().map(T::negated).collect();
        for strict in [pivot.to_vec(), opposite] {
            let system = HalfSpaces { strict: Matrix::from_rows(3, [strict]), ..fixed.clone() };
            cones.extend(Cone::from_half_spaces_plus(&system, &force_rays(contacts, &rest))?);
        }
    }
    Ok(cones)
}

/// The cones of the n 2^(n-1) transitions that do not add a contact: `s` at one fixel, `m` on any of the others, `u` on
/// the rest, formula (21) and Table 5.
///
/// `None` if the normals' wrenches are linearly dependent, for then the cones cover everything: for any wrench, the
/// frictionless least-constraint problem has a solution whose forces act on independent contacts only, so some contact
/// carries none, does not approach, and the rest of them are maintained.
fn transition_cones<T: Int>(contacts: &[ContactRows<T>]) -> Result<Option<Vec<ModeCone<T>>>, Overflow> {
    let n = contacts.len();
    let normals = Matrix::from_rows(3, contacts.iter().map(|contact| &contact.normal_acceleration));
    if n > 3 || 3 - Pair::from_normals(&normals, &Matrix::new(3))?.dim() < n {
        return Ok(None);
    }
    let mut cones = Vec::new();
    for separating in 0..n {
        for maintained in (0..1_u32 << n).filter(|set| set >> separating & 1 == 0) {
            let letter = |contact: usize| match contact {
                _ if contact == separating => Interaction::Separate,
                _ if maintained >> contact & 1 == 1 => Interaction::Maintain,
                _ => Interaction::Unconstrained,
            };
            let mode: Vec<Interaction> = (0..n).map(letter).collect();
            if let Some(cone) = mode_cone(contacts, &mode, false)? {
                cones.push((Mode(mode), cone));
            }
        }
    }
    Ok(Some(cones))
}
