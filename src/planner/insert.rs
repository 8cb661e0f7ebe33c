//! Insertion against fixels.

use crate::answer::{Cone, Insertion, Stability};
use crate::exact::Q;
use crate::mechanics::{Mode, ModeError};
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
pub fn mode_cones(part: &Part, fixture: &Fixture, question: &Question) -> Result<Vec<(String, Cone)>, ModeError> {
    let _ = (part, fixture, question);
    todo!()
}

/// Weak and strong stability of the seated part.
///
/// # Errors
/// As [`mode_cones`].
pub fn stability(part: &Part, fixture: &Fixture, question: &Question) -> Result<Stability, ModeError> {
    let _ = (part, fixture, question);
    todo!()
}

/// The wrenches guaranteed to seat the part, and the best way to apply one.
///
/// # Errors
/// As [`mode_cones`].
pub fn insertion(part: &Part, fixture: &Fixture, question: &Question) -> Result<Insertion, ModeError> {
    let _ = (part, fixture, question);
    todo!()
}
