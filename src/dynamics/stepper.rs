//! What the run asks of a time-stepping scheme.

use super::contact::Contact;
use super::forces::Forces;
use super::mechanics::Mechanics;
use super::run::contact_state;
use super::solved::{Refused, Solved};
use super::state::State;
use crate::answer::{ContactName, ContactState};
use crate::model::World;

/// A time-stepping scheme.
pub(super) trait Stepper<S: Mechanics> {
    /// One step of length `h` (s); the state is unchanged when it is refused.
    fn step(&mut self, state: &mut State<S>, h: f64) -> Result<Solved, Refused>;

    /// Contacts that the last step pressed on, with their impulses along n, t and o (N s).
    fn touches(&self) -> impl Iterator<Item = (&Contact<S>, [f64; 3])>;

    /// Deepest overlap at the start of the last step (m), not negative.
    fn deepest(&self) -> f64;

    /// Whether the forces of the last step may not exist or not be unique, by the sign of A_nn - μ |A_nt| at a contact.
    fn is_suspect(&self) -> bool {
        false
    }

    /// Energy that undoing overlaps added in the last step (J).
    fn corrected(&self) -> f64 {
        0.0
    }

    /// When the contact began to press in the last step (s), where the scheme knows better than the step.
    fn touched_at(&self, _: &ContactName) -> Option<f64> {
        None
    }

    /// All forces that the last step allows, where contacts are rigid and few enough.
    fn forces(&self, _: &World<S>, _: &State<S>) -> Option<Forces> {
        None
    }

    /// Energy of local deformation after the last step (J).
    fn stored(&self) -> f64 {
        0.0
    }

    /// Local deformations after the last step along n, t and o (m).
    fn deformations(&self) -> Vec<(ContactName, [f64; 3])> {
        Vec::new()
    }

    /// State of a contact in the last step, which ended at these velocities.
    fn contact_state(&self, contact: &Contact<S>, impulse: [f64; 3], velocities: &[S::Velocity]) -> ContactState {
        contact_state(contact, impulse, velocities)
    }
}
