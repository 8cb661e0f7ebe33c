//! What a solver says about a problem.

use super::Basis;
use crate::exact::Q;

/// The end of a solve.
#[derive(Debug, Clone, PartialEq)]
pub enum Verdict<'a> {
    /// A solution, with the evidence for it.
    Solved(Solution<'a>),
    /// Proved: there is none.
    NoSolution(Proof),
    /// Neither, at a limit.
    Undecided(Undecided),
}

/// A solution and how it was found; it borrows from the solver.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Solution<'a> {
    /// The variables; on [`Rung::Exact`] and after it the doubles nearest to `exact`.
    pub z: &'a [f64],
    /// The bound of [`Lcp::residual`](super::Lcp::residual) for `z`, at most
    /// [`ACCEPTED_RESIDUAL`](super::ACCEPTED_RESIDUAL) on the rungs in doubles.
    pub residual: f64,
    /// Pivots on all rungs together.
    pub pivots: usize,
    /// Where it was found.
    pub rung: Rung,
    /// The final basis, from which the next step may start.
    pub basis: &'a Basis,
    /// The solution without rounding, if an exact rung found it.
    pub exact: Option<&'a [Q]>,
}

/// The methods, in the order in which they are tried.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Rung {
    /// `q ≥ 0`, so `z = 0`.
    Free,
    /// The basis that the caller supplied.
    Warm,
    /// Lemke's method in doubles.
    Lemke,
    /// The basis that Lemke's method ended in, solved again from the given numbers.
    Refined,
    /// Lemke's method with lexicographic ties on rows and columns scaled by powers of two.
    Scaled,
    /// The same from other covering vectors.
    Covers,
    /// Semismooth Newton on the Fischer-Burmeister function.
    Newton,
    /// Lemke's method in integers.
    Exact,
    /// All complementary cases in integers.
    Cases,
}

impl Rung {
    /// All rungs, in order.
    pub const ALL: [Self; 9] = [
        Self::Free,
        Self::Warm,
        Self::Lemke,
        Self::Refined,
        Self::Scaled,
        Self::Covers,
        Self::Newton,
        Self::Exact,
        Self::Cases,
    ];

    /// Its name in reports.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Free => "free",
            Self::Warm => "warm",
            Self::Lemke => "lemke",
            Self::Refined => "refined",
            Self::Scaled => "scaled",
            Self::Covers => "covers",
            Self::Newton => "newton",
            Self::Exact => "exact",
            Self::Cases => "cases",
        }
    }
}

/// Why a problem has no solution; a reader can check it with sums and signs alone.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Proof {
    /// `y ≥ 0` with `Mᵀ y ≤ 0` and `q · y < 0`: not even `z ≥ 0`, `M z + q ≥ 0` has a solution.
    Farkas(Vec<Q>),
    /// Complementary cases that together are all of them, each without a solution.
    Cases(Vec<ExcludedCase>),
}

/// A set of complementary choices that no solution makes.
///
/// `y_i ≥ 0` where `w_i` is not in `zero_w`; `(Mᵀ y)_j ≤ 0` where `z_j` is not in `zero_z`; and `q · y < 0`. Then
/// `0 ≤ y · w = y · M z + y · q < 0` for every solution with these zeros.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ExcludedCase {
    /// Indices with `z = 0`.
    pub zero_z: Vec<usize>,
    /// Indices with `w = 0`.
    pub zero_w: Vec<usize>,
    /// The multipliers `y` of the rows.
    pub multipliers: Vec<Q>,
}

/// Where the search for an answer was given up.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum Undecided {
    /// The pivots in integers ran out.
    Pivots(usize),
    /// A secondary ray, which proves nothing by itself, and too many cases to decide.
    Ray {
        /// Direction of `z`.
        direction: Vec<Q>,
        /// Cases looked at.
        cases: usize,
    },
}

/// What a [`Solver`](super::Solver) may spend and where it starts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Limits {
    /// The first rung; those before it are skipped. [`Rung::Free`] by default.
    pub first: Rung,
    /// Pivots for each variable in doubles, after which Lemke's method counts as cycling. 60 by default.
    pub pivots_per_variable: usize,
    /// Pivots in integers. 10,000 by default.
    pub exact_pivots: usize,
    /// Complementary cases to look at after a ray without proof. 4096 by default.
    pub cases: usize,
    /// Variables up to which complementary cases are looked at; their number and cost grow exponentially. 20 by default.
    pub case_variables: usize,
}

impl Default for Limits {
    fn default() -> Self {
        Self { first: Rung::Free, pivots_per_variable: 60, exact_pivots: 10_000, cases: 4096, case_variables: 20 }
    }
}
