//! Throws: where the pattern lies, how orbits come to it, and its poses.

use super::super::Toss;
use super::canvas::Canvas;
use crate::answer::Throw;

/// The drawing of `plan throw`.
#[must_use]
pub fn throw(toss: &Toss, _answer: &Throw) -> String {
    Canvas::new().finish(10.0, 10.0, toss.name, "")
}
