//! How much friction a guarantee bears.

use crate::exact::Algebraic;

/// Up to which common factor on all friction coefficients of a case there is a guarantee.
///
/// More friction allows more ways to get stuck: what holds at a factor holds at every smaller one.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CriticalFriction {
    /// Up to which factor `goal` holds some wrench.
    pub goal: FrictionLimit,
    /// Up to which factor `acyclic` does.
    pub acyclic: FrictionLimit,
    /// Up to which factor the plan is in `acyclic`; `None` without a plan.
    pub plan: Option<FrictionLimit>,
}

/// Where a guarantee ends as friction grows.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum FrictionLimit {
    /// There is none even without friction.
    Always,
    /// It holds whatever the friction.
    Never,
    /// It ends at a factor.
    Finite(CriticalFactor),
}

/// The factor at which a guarantee ends.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CriticalFactor {
    /// The least upper bound of the factors with a guarantee: a rational, or a root of a polynomial.
    pub factor: Algebraic,
    /// Whether the guarantee holds at the factor itself; `None` where that was not decided, which takes an irrational
    /// factor.
    pub is_attained: Option<bool>,
    /// How the set ends; `None` for a plan, and where it was not decided.
    pub end: Option<End>,
    /// Two fixels that balance every wrench beyond the factor.
    pub jam: Option<[usize; 2]>,
}

/// How a set ends as friction grows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum End {
    /// What the sets below the factor have in common has no interior.
    Shrinks,
    /// Some wrench is in the set at every smaller factor, and none at any larger one.
    Jumps,
}

/// Which changes of friction, or which fixel left out, would open an empty `acyclic`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NearestChange {
    /// Below this factor on all coefficients it is not empty.
    pub all: Option<CriticalFactor>,
    /// Fixels of which each would do alone, and below which factor on its coefficient; least change first.
    pub single: Vec<(usize, CriticalFactor)>,
    /// Fixels of which each could be left out.
    pub without: Vec<usize>,
}
