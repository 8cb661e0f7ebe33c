//! The planners: which wrenches, finger places and tilts do what is asked, decided exactly.

mod critical;
mod directions;
mod fingers;
mod insert;
mod recommend;
mod robust;
mod sets;
mod stability;
mod to_answer;
mod transitions;
mod witness;

pub use insert::insertion;
pub use sets::{Question, mode_cones};
pub use stability::stability;
