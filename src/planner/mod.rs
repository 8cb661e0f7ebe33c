//! The planners: which wrenches, finger places and tilts do what is asked, decided exactly.

mod insert;

pub use insert::{Question, insertion, mode_cones, stability};
