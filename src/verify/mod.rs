//! Plans put to the test of dynamics: scenes drawn from what a case leaves uncertain, run by the time-steppers.
//!
//! Nothing here knows how a plan was found: it sees the part, the plan and what the plan promises. A planner that erred
//! and its verifier would have to err alike.

mod draw;
mod experiment;
mod insert;
mod pins;
mod seat;
mod throw;

pub use draw::Draw;
pub use experiment::{Ending, Experiment, Trial, tally, verification};
pub use insert::{InsertTrials, Push};
pub use pins::PinTrials;
pub use throw::{Surface, ThrowTrials};
