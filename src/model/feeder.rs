//! A device that turns parts as they fall through it, its dimensions open.

use super::{Planar, World};
use std::fmt;

/// A device with open dimensions, the ways in which a part enters it, and how it is to leave; SI units.
pub struct Feeder {
    /// The dimensions to be chosen, the design space of (19).
    pub variables: Vec<Variable>,
    /// What is only known within limits.
    pub uncertain: Vec<Uncertain>,
    /// Names of the entries.
    pub entries: Vec<String>,
    /// How the part is to leave.
    pub goal: Goal,
    /// When a part is at rest.
    pub rest: Rest,
    /// The scenes at given dimensions.
    pub device: Box<dyn Device>,
}

/// A dimension to be chosen between bounds.
#[derive(Debug, Clone, PartialEq)]
pub struct Variable {
    /// Its name.
    pub name: String,
    /// What it is, for reports.
    pub meaning: Option<String>,
    /// Least value.
    pub low: f64,
    /// Largest value, above the least one.
    pub high: f64,
    /// Where the search starts, in the bounds.
    pub start: f64,
}

/// A number that is only known within limits: friction, a dimension of the part, a place of its entry.
#[derive(Debug, Clone, PartialEq)]
pub struct Uncertain {
    /// Its name.
    pub name: String,
    /// The nominal value.
    pub value: f64,
    /// How far it may be off, not negative.
    pub off: f64,
}

/// The pose in which a part is to pass a height.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Goal {
    /// q_goal (m, m, rad); a run ends when the center of mass falls below it.
    pub pose: [f64; 3],
    /// How far the part may be off there, in x (m) and in turn (rad).
    pub within: [f64; 2],
    /// w of (18): seconds for each unit of distance.
    pub weight: f64,
}

/// Rest: a speed, half of the part's diameter times its spin included, that is not exceeded for a time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rest {
    /// (m/s).
    pub speed: f64,
    /// (s).
    pub time: f64,
}

/// A dimension as a drawing shows it: a distance, or where it has a corner, an angle.
#[derive(Debug, Clone, PartialEq)]
pub struct Dimension {
    /// What is measured.
    pub name: String,
    /// The ends (m); of an angle, points on its sides.
    pub ends: [[f64; 2]; 2],
    /// Where the sides of an angle meet (m).
    pub corner: Option<[f64; 2]>,
}

/// Builds the scenes of a device.
pub trait Device: Send + Sync {
    /// One scene for each entry, its first body the part, with the dimensions `variables` and with `uncertain` as given.
    ///
    /// # Errors
    /// Why there is no such device.
    fn scenes(&self, variables: &[f64], uncertain: &[f64]) -> Result<Vec<World<Planar>>, String>;

    /// What a drawing of the device measures.
    fn dimensions(&self, variables: &[f64], uncertain: &[f64]) -> Vec<Dimension>;
}

impl Feeder {
    /// Where the search starts.
    #[must_use]
    pub fn start(&self) -> Vec<f64> {
        self.variables.iter().map(|variable| variable.start).collect()
    }

    /// The nominal values of what is uncertain.
    #[must_use]
    pub fn nominal(&self) -> Vec<f64> {
        self.uncertain.iter().map(|uncertain| uncertain.value).collect()
    }
}

impl fmt::Debug for Feeder {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { variables, uncertain, entries, goal, rest, device: _ } = self;
        f.debug_struct("Feeder")
            .field("variables", variables)
            .field("uncertain", uncertain)
            .field("entries", entries)
            .field("goal", goal)
            .field("rest", rest)
            .finish_non_exhaustive()
    }
}
