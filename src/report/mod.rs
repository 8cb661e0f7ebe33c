//! Answers as text, JSON and pictures: pure functions of the answer and of what was asked.

pub mod json;
pub mod svg;
pub mod text;

mod decimal;
mod phrase;

use crate::model::{Fixture, Part};

/// What an answer is about.
#[derive(Debug, Clone, Copy)]
pub struct Subject<'a> {
    /// Name of the case, or of its file.
    pub name: &'a str,
    /// The part.
    pub part: &'a Part,
    /// Its fixture.
    pub fixture: &'a Fixture,
    /// Warnings of the reader.
    pub warnings: &'a [String],
}
