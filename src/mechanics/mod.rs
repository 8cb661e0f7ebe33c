//! Contact modes and the wrenches that are consistent with them.

mod mode;

pub use mode::{Interaction, Mode, ModeError};
