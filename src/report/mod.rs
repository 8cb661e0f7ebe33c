//! Answers as text, JSON and pictures: pure functions of the answer and of what was asked.

pub mod csv;
pub mod html;
pub mod json;
pub mod markdown;
pub mod svg;
pub mod text;
pub mod trajectory;

mod decimal;
mod height;
mod ladder;
mod motion;
mod phrase;

pub use motion::{Run, Shown};

use crate::model::{Conveyor, Feeder, Fixture, Part, Range, Thrower};
use num_traits::Zero as _;

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

/// What an answer about pins is about.
#[derive(Debug, Clone, Copy)]
pub struct Ride<'a> {
    /// Name of the case, or of its file.
    pub name: &'a str,
    /// The part.
    pub part: &'a Part,
    /// What carries it.
    pub conveyor: &'a Conveyor,
    /// Warnings of the reader.
    pub warnings: &'a [String],
    /// The edge of the hull on which it was asked to end.
    pub end: Option<usize>,
    /// How many pins were allowed.
    pub max_pins: Option<usize>,
}

/// What an answer about a device is about.
#[derive(Debug, Clone, Copy)]
pub struct Chute<'a> {
    /// Name of the case, or of its file.
    pub name: &'a str,
    /// The device.
    pub feeder: &'a Feeder,
    /// Seed of the search.
    pub seed: u64,
    /// Warnings of the reader.
    pub warnings: &'a [String],
}

/// What an answer about throws is about.
#[derive(Debug, Clone, Copy)]
pub struct Toss<'a> {
    /// Name of the case, or of its file.
    pub name: &'a str,
    /// The part.
    pub part: &'a Part,
    /// What throws it.
    pub thrower: &'a Thrower,
    /// Warnings of the reader.
    pub warnings: &'a [String],
    /// Whether a part comes to rest on the first stable edge that it lands on.
    pub settles_first: bool,
}

impl Ride<'_> {
    /// Whether friction or center of mass are ranges.
    fn is_uncertain(&self) -> bool {
        let Conveyor { belt_friction, pin_friction } = self.conveyor;
        let is_range = |range: &Range| range.min != range.max;
        is_range(belt_friction) || is_range(pin_friction) || !self.part.center_of_mass_tolerance.is_zero()
    }
}
