//! JSON documents as FORMATS.md names them.

use super::Subject;
use crate::answer::{Cone, Insertion, Stability};
use serde_json::Value;

/// The document of `plan insert`; `cells` adds the cells of every region.
#[must_use]
pub fn insertion(subject: &Subject, answer: &Insertion, cells: bool) -> Value {
    let _ = (subject, answer, cells);
    todo!()
}

/// The document of `plan stable`.
#[must_use]
pub fn stability(subject: &Subject, answer: &Stability, cells: bool) -> Value {
    let _ = (subject, answer, cells);
    todo!()
}

/// The document of `plan cone`.
#[must_use]
pub fn cones(subject: &Subject, modes: &[(String, Cone)]) -> Value {
    let _ = (subject, modes);
    todo!()
}
