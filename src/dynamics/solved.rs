//! How the contact problems of a step came out.

use crate::answer::ContactName;
use crate::complementarity::{LcpError, Proof, Rung, Undecided};

/// How the contact problems of a step were solved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Solved {
    pub residual: f64,
    pub pivots: usize,
    pub rung: Rung,
    pub problems: usize,
    /// Problems of them that were solved in closed form.
    pub closed: usize,
    pub impacts: usize,
    pub fastest_impact: f64,
    /// Most contacts that met in one impact of which something restitutes.
    pub together: usize,
    /// A contact whose slip reversed inside an impact, with its slip after it by the step and by Routh's law (m/s).
    pub reversal: Option<(ContactName, [f64; 2])>,
    pub fallbacks: Fallbacks,
}

/// What a step needed besides its first attempt.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Fallbacks {
    /// Problems that the answers for shorter steps led to.
    pub continued: usize,
    /// Steps that were halved.
    pub divided: usize,
}

impl Solved {
    pub fn nothing() -> Self {
        let fallbacks = Fallbacks::default();
        Self {
            residual: 0.0,
            pivots: 0,
            rung: Rung::Free,
            problems: 0,
            closed: 0,
            impacts: 0,
            fastest_impact: 0.0,
            together: 0,
            reversal: None,
            fallbacks,
        }
    }

    /// Adds the work of another problem of the same step.
    pub fn add(&mut self, other: Self) {
        self.residual = self.residual.max(other.residual);
        self.pivots += other.pivots;
        self.rung = self.rung.max(other.rung);
        self.problems += other.problems;
        self.closed += other.closed;
        self.impacts += other.impacts;
        self.reversal = self.reversal.or(other.reversal);
        self.together = self.together.max(other.together);
        self.fastest_impact = self.fastest_impact.max(other.fastest_impact);
        self.fallbacks.continued += other.fallbacks.continued;
        self.fallbacks.divided += other.fallbacks.divided;
    }
}

/// Why a contact problem was not solved.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Refused {
    /// Proved: no impulses are admissible.
    NoSolution(Proof),
    /// Given up at a limit.
    Undecided(Undecided),
    /// The numbers are no problem at all: something overflowed.
    Broken(LcpError),
    /// Bodies overlap by this much and cannot be moved apart (m).
    Overlap { depth: f64 },
    /// The equation of a compliant step was not solved, however short the step.
    Unsolved,
    /// A contact so soft that a body would be `depth` deep in another, beyond `half` its thickness (m).
    TooSoft { depth: f64, half: f64 },
}

impl From<LcpError> for Refused {
    fn from(error: LcpError) -> Self {
        Self::Broken(error)
    }
}
