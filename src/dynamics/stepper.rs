//! What the run asks of a time-stepping scheme.

use super::contact::Contact;
use super::impulses::{Refused, Solved};
use super::mechanics::Mechanics;
use super::state::State;

/// A time-stepping scheme.
pub(super) trait Stepper<S: Mechanics> {
    /// One step of length `h` (s); the state is unchanged when it is refused.
    fn step(&mut self, state: &mut State<S>, h: f64) -> Result<Solved, Refused>;

    /// Contacts that the last step pressed on, with their impulses along n, t and o (N s).
    fn touches(&self) -> impl Iterator<Item = (&Contact<S>, [f64; 3])>;

    /// Deepest overlap at the start of the last step (m), not negative.
    fn deepest(&self) -> f64;
}
