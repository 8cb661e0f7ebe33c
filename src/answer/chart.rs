//! What `plan chart` measures: error against time for every method, and where methods fail.

use super::Limit;

/// Measurements of methods on the same work.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Chart {
    /// Where and with what it was measured: name and value, in order.
    pub conditions: Vec<(String, String)>,
    /// Points of curves, those of a curve together.
    pub points: Vec<ChartPoint>,
    /// Tiles of stability maps, those of a map and method together, row by row.
    pub tiles: Vec<ChartTile>,
    /// The limit that ended the measurements.
    pub limit: Option<Limit>,
}

/// A method with a setting, on a piece of work.
#[derive(Debug, Clone, PartialEq)]
pub struct ChartPoint {
    /// Which methods compete.
    pub family: ChartFamily,
    /// What they do: one figure each.
    pub work: String,
    /// The method: one curve each.
    pub method: String,
    /// Its setting: one point each.
    pub setting: String,
    /// Error in the unit of the family; `None` if no run gave an answer.
    pub error: Option<f64>,
    /// Runs that gave no answer or a wrong one.
    pub failed: u64,
    /// All runs.
    pub of: u64,
    /// CPU time in the unit of the family (s): lower quartile, median and upper quartile.
    pub time: [f64; 3],
    /// The command that measures it again, where another program than this measured.
    pub command: Option<String>,
}

impl ChartPoint {
    /// Name by which the point can be measured again.
    #[must_use]
    pub fn id(&self) -> String {
        [self.family.name(), &self.work, &self.method, &self.setting].join("/")
    }
}

/// Methods that do the same work.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum ChartFamily {
    /// Time-steppers at fixed steps.
    Stepping,
    /// Each rung of the model ladder and the automatic choice.
    Ladder,
    /// Linear complementarity problems.
    Complementarity,
    /// Cones from their normals to their rays.
    Cone,
    /// Places on the curve of a toppling height.
    Toppling,
    /// The pattern of a throw.
    Throw,
}

impl ChartFamily {
    /// All of them, in the order of reports.
    pub const ALL: [Self; 6] =
        [Self::Stepping, Self::Ladder, Self::Complementarity, Self::Cone, Self::Toppling, Self::Throw];

    /// A word for ids.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Stepping => "stepping",
            Self::Ladder => "ladder",
            Self::Complementarity => "lcp",
            Self::Cone => "cone",
            Self::Toppling => "toppling",
            Self::Throw => "throw",
        }
    }

    /// What a figure is called.
    #[must_use]
    pub fn title(self) -> &'static str {
        match self {
            Self::Stepping => "Time-steppers",
            Self::Ladder => "Model ladder",
            Self::Complementarity => "Contact problems",
            Self::Cone => "Cones from normals to rays",
            Self::Toppling => "Pins near critical heights",
            Self::Throw => "Long run of throws",
        }
    }

    /// What the error is, with its unit.
    #[must_use]
    pub fn error(self) -> &'static str {
        match self {
            Self::Stepping | Self::Ladder => "error of the final pose (m)",
            Self::Complementarity => "median residual over the largest velocity",
            Self::Cone => "share of cones with wrong faces",
            Self::Toppling => "share of heights on the wrong side",
            Self::Throw => "error of the ends of bands over the part's radius",
        }
    }

    /// What the time is that of.
    #[must_use]
    pub fn time(self) -> &'static str {
        match self {
            Self::Stepping | Self::Ladder => "CPU time of a run",
            Self::Complementarity => "CPU time of a problem",
            Self::Cone => "CPU time of a cone",
            Self::Toppling => "CPU time of a comparison",
            Self::Throw => "CPU time of a pattern",
        }
    }
}

/// Runs of a method at a place of a stability map.
#[derive(Debug, Clone, PartialEq)]
pub struct ChartTile {
    /// Which map.
    pub map: ChartMap,
    /// The method.
    pub method: String,
    /// The stress along x.
    pub x: f64,
    /// The stress along y.
    pub y: f64,
    /// Runs that succeeded.
    pub succeeded: u64,
    /// Runs whose problem has several answers, or none, and which say so.
    pub ambiguous: u64,
    /// Runs that failed.
    pub failed: u64,
}

impl ChartTile {
    /// Name by which the tile can be measured again.
    #[must_use]
    pub fn id(&self) -> String {
        format!("{}/{}/{:e}/{:e}", self.map.name(), self.method, self.x, self.y)
    }
}

/// Two stresses under which methods are watched.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum ChartMap {
    /// Friction and mass ratio, in stacks.
    FrictionMass,
    /// Step and stiffness, in compliant contacts.
    StepStiffness,
    /// Doubled contacts and masses, in contact problems.
    DegeneracyConditioning,
}

impl ChartMap {
    /// All of them, in the order of reports.
    pub const ALL: [Self; 3] = [Self::FrictionMass, Self::StepStiffness, Self::DegeneracyConditioning];

    /// A word for ids.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::FrictionMass => "friction-mass",
            Self::StepStiffness => "step-stiffness",
            Self::DegeneracyConditioning => "degeneracy-conditioning",
        }
    }

    /// Its title.
    #[must_use]
    pub fn title(self) -> &'static str {
        match self {
            Self::FrictionMass => "a heavy block on light ones",
            Self::StepStiffness => "a ball that bounces on a compliant floor",
            Self::DegeneracyConditioning => "contact problems with doubled contacts and unequal masses",
        }
    }

    /// What x and y are, with their units.
    #[must_use]
    pub fn axes(self) -> [&'static str; 2] {
        match self {
            Self::FrictionMass => ["coefficient of friction", "mass ratio"],
            Self::StepStiffness => ["step (s)", "stiffness (N/m)"],
            Self::DegeneracyConditioning => ["share of contacts that are doubled", "ratio of masses"],
        }
    }
}
