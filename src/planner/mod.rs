//! The planners: which wrenches, finger places and tilts do what is asked, decided exactly.

mod critical;
mod directions;
mod fingers;
mod insert;
mod pins;
mod recommend;
mod robust;
mod seating;
mod sets;
mod stability;
mod suggest;
mod throw;
mod to_answer;
mod transitions;
mod witness;

pub use insert::insertion;
pub use pins::{PinQuestion, PinsError, pins};
pub use sets::{Question, mode_cones};
pub use stability::stability;
pub use suggest::{Progress, Stage, SuggestError, suggest};
pub use throw::{CarryQuestion, Sweep, ThrowError, ThrowProgress, ThrowQuestion, ThrowStage, throw};
