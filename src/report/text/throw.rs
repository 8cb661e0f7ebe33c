//! `plan throw` in words.

use super::super::Toss;
use crate::answer::Throw;

/// The sensor, the pattern and what of it is proved, then the grasp of each edge.
#[must_use]
pub fn throw(toss: &Toss, answer: &Throw) -> String {
    format!("{} {}\n", toss.name, answer.status())
}
