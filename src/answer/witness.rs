//! Solutions of the rigid-body model that show why a wrench is in a set or outside of it.

use crate::exact::Q;

/// What the part may do under one wrench.
///
/// Each entry is `None` where nothing is to be shown: where the wrench is outside of `weak`, inside of the other sets.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Witness {
    /// Contact forces that hold the seated part still at the least static friction.
    pub weak: Option<Motion>,
    /// A motion of the seated part.
    pub strong: Option<Motion>,
    /// A step that does not add a contact, in the letters of formula (21): from the contacts `m` and `s` to those `m`.
    /// The contact `s` breaks, or carries no force and does not approach.
    pub goal: Option<Step>,
    /// Steps that lead from a state back to it, so that they may go on for ever; one step if a state may persist.
    pub acyclic: Option<Vec<Step>>,
    /// A rest short of the seat, or the break of a contact of the seated part.
    pub unrefuted: Option<Step>,
    /// For each contact mode over `s l r n` (`s` strict) that is consistent with the wrench in the seated state, in the
    /// order of the letters, one of its motions. Which of several modes happens, the model does not determine; there is
    /// always one, because kinetic friction is at most static friction.
    pub consistent: Vec<Motion>,
}

/// A solution of Newton's law `M v' = g + Σ (J_n c_n + J_t c_t)` in a contact mode, for a wrench `g`.
///
/// `M = diag(mass, mass, inertia)`; `J` takes moments about the center of mass. The unit of force is that of `g`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Motion {
    /// Letters of the contacts.
    pub mode: String,
    /// `v'`: acceleration of the center of mass and angular acceleration.
    pub acceleration: [Q; 3],
    /// What happens at each contact, in file order.
    pub contacts: Vec<ContactMotion>,
}

/// Acceleration and force at one contact, in its frame `(n, t)`.
///
/// `n` is the normal as the fixture has it, of any length, and `t` is `n` turned by +90 degrees: the force is
/// `c_n n + c_t t`, and accelerations are dot products with `n` and `t`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ContactMotion {
    /// `[a_n, a_t]`.
    pub acceleration: [Q; 2],
    /// `[c_n, c_t]`.
    pub force: [Q; 2],
    /// The coefficient in the range of the case that bears the force: where the contact slides, `|c_t| / c_n`; else the
    /// least that holds. `None` without a force.
    pub friction: Option<Q>,
}

/// A change of the set of achieved contacts, or its persistence, and a motion that makes it possible.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Step {
    /// Contacts before.
    pub from: Vec<usize>,
    /// Contacts after; those of `from` if the state persists.
    pub to: Vec<usize>,
    /// The motion.
    pub motion: Motion,
}
