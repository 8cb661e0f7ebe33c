//! Answer of `plan feeder`.

use super::{Limit, Simulation};
use crate::model::{Planar, World};

/// A device whose dimensions were searched, and what parts do in it.
#[derive(Debug, Clone, PartialEq)]
pub struct FeederPlan {
    /// As the search began.
    pub start: FeederDesign,
    /// The best design that passes at every step checked, and if there is one, by every model; `None` if none was found.
    pub best: Option<FeederDesign>,
    /// The checks of the best design, at smaller steps and by another model.
    pub checks: Vec<DesignCheck>,
    /// Cost of each evaluation, in order: of all at the worst step looked at.
    pub trace: Vec<Evaluation>,
    /// Designs of a lower cost that passed, but not at every step checked.
    pub fragile: usize,
    /// How far dimensions and what is uncertain may be off, if it was asked for.
    pub robust: Option<Robustness>,
    /// The limit that ended the search.
    pub limit: Option<Limit>,
}

/// A device with chosen dimensions.
#[derive(Debug, Clone, PartialEq)]
pub struct FeederDesign {
    /// A value for each variable.
    pub variables: Vec<f64>,
    /// 𝒢 of (18).
    pub cost: f64,
    /// A run for each entry.
    pub runs: Vec<EntryRun>,
}

impl FeederDesign {
    /// Whether the part leaves as it is to, however it enters.
    #[must_use]
    pub fn passes(&self) -> bool {
        !self.runs.is_empty() && self.runs.iter().all(|run| run.fate == EntryFate::Passes)
    }
}

/// A part that enters a device.
#[derive(Debug, Clone, PartialEq)]
pub struct EntryRun {
    /// How it ends.
    pub fate: EntryFate,
    /// T: when it passes the goal's height, or comes to rest (s).
    pub time: f64,
    /// q(T) (m, m, rad).
    pub pose: [f64; 3],
    /// w ‖q(T) - q_goal‖ + T (s).
    pub cost: f64,
}

/// How a part fares.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EntryFate {
    /// It passes the goal's height, near enough to the goal.
    Passes,
    /// It passes that height in another pose.
    Astray,
    /// It comes to rest before.
    Rests,
    /// It does neither in the time allowed.
    TimesOut,
    /// A contact problem was not solved.
    Unsolved,
    /// There is no such device.
    NoDevice,
}

impl EntryFate {
    /// In words.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Passes => "passes",
            Self::Astray => "leaves in another pose",
            Self::Rests => "comes to rest",
            Self::TimesOut => "is not through in time",
            Self::Unsolved => "meets a contact problem without solution",
            Self::NoDevice => "finds no device",
        }
    }
}

/// A run of a design, to be shown.
#[derive(Debug, Clone, PartialEq)]
pub struct Film {
    /// Which design: `at first` or `designed`.
    pub design: &'static str,
    /// Number of the entry.
    pub entry: usize,
    /// The scene, which ends soon after the run is decided.
    pub world: World<Planar>,
    /// What moved.
    pub simulation: Simulation<Planar>,
}

/// An evaluation of the objective.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Evaluation {
    /// What the search saw: the largest cost of the steps looked at.
    pub cost: f64,
    /// Whether all entries passed at all steps.
    pub passes: bool,
}

/// The runs of a design by other means.
#[derive(Debug, Clone, PartialEq)]
pub struct DesignCheck {
    /// The model: `st` or `spk`.
    pub model: &'static str,
    /// The step (s).
    pub step: f64,
    /// The design as this sees it.
    pub design: FeederDesign,
}

/// How much may be off.
#[derive(Debug, Clone, PartialEq)]
pub struct Robustness {
    /// Draws of what is uncertain in which all entries pass, and all draws.
    pub passed: [u64; 2],
    /// Wilson's interval for the yield, at 95 %.
    pub wilson: [f64; 2],
    /// An interval for each variable in which all entries pass, the others as chosen: no gap was met on the way to its ends.
    pub tolerances: Vec<[f64; 2]>,
}
