//! The ladder of methods behind one function.

use super::decide::{Decision, decide};
use super::dense::Dense;
use super::lemke::{Dictionary, End, Ties};
use super::newton::Newton;
use super::scaling::Scaled;
use super::{Basis, ExactLcp, Lcp, LcpError, Limits, Rung, Solution, Verdict};
use crate::exact::{Q, to_f64};

/// A solver with its room, to be kept from step to step: in doubles it allocates only when a problem is larger than all
/// before it.
///
/// Every answer in doubles has passed [`Lcp::residual`]; whatever fails climbs to the next [`Rung`], and the last ones
/// are exact.
///
/// # Examples
/// ```
/// use partplan::complementarity::{ExactLcp, Lcp, Solver, Verdict};
/// let lcp = Lcp { m: &[2.0, 1.0, 1.0, 2.0], q: &[-5.0, -6.0] };
/// let mut solver = Solver::default();
/// let Verdict::Solved(solution) = solver.solve(lcp, None, &|| ExactLcp::from_floats(lcp))? else { panic!() };
/// assert!((solution.z[0] - 4.0 / 3.0).abs() < 1e-12 && (solution.z[1] - 7.0 / 3.0).abs() < 1e-12);
/// # Ok::<(), partplan::complementarity::LcpError>(())
/// ```
#[derive(Debug, Clone, Default)]
pub struct Solver {
    limits: Limits,
    dictionary: Dictionary,
    dense: Dense,
    newton: Newton,
    scaled: Scaled,
    cover: Vec<f64>,
    z: Vec<f64>,
    basis: Basis,
    /// Of the bases that failed, the one with the least violation.
    best_basis: Basis,
    best: f64,
    exact: Vec<Q>,
}

/// An answer that passed its check.
struct Found {
    rung: Rung,
    residual: f64,
}

impl Solver {
    /// A solver with other limits than the default ones.
    #[must_use]
    pub fn with_limits(limits: Limits) -> Self {
        Self { limits, ..Self::default() }
    }

    /// Solves `lcp`, first with the basis `warm` of a similar problem if there is one.
    ///
    /// `exact` is asked for the problem without rounding, once, if doubles fail. For contacts it is
    /// [`Factors::to_exact`](super::Factors::to_exact).
    ///
    /// The exact rungs take `q` at its word. A part that is held from all sides at gaps of zero has no solution if rounding
    /// has made one entry of `q` too small by 10^-17; doubles accept it, within their residual.
    ///
    /// # Errors
    /// [`LcpError`] if the problem has no shape or an entry is not finite, and what `exact` returns.
    pub fn solve(
        &mut self,
        lcp: Lcp<'_>,
        warm: Option<&Basis>,
        exact: &dyn Fn() -> Result<ExactLcp, LcpError>,
    ) -> Result<Verdict<'_>, LcpError> {
        lcp.check()?;
        self.best = f64::INFINITY;
        let mut pivots = 0;
        let found = match self.quick(lcp, warm) {
            None => self.in_doubles(lcp, &mut pivots),
            found => found,
        };
        if let Some(Found { rung, residual }) = found {
            let Self { z, basis, .. } = self;
            return Ok(Verdict::Solved(Solution { z, residual, pivots, rung, basis, exact: None }));
        }
        let exact = exact()?;
        if exact.size() != lcp.size() {
            return Err(LcpError::Sizes { exact: exact.size(), doubles: lcp.size() });
        }
        let proposed = self.best.is_finite().then_some(&self.best_basis);
        let (decision, more) = decide(&exact, proposed, self.limits);
        pivots += more;
        Ok(match decision {
            Decision::None(proof) => Verdict::NoSolution(proof),
            Decision::Undecided(why) => Verdict::Undecided(why),
            Decision::Solved { z, basis, rung } => {
                self.z.clear();
                self.z.extend(z.iter().map(to_f64));
                (self.basis, self.exact) = (basis, z);
                let Self { z, basis, exact, .. } = self;
                Verdict::Solved(Solution {
                    z,
                    residual: lcp.residual(z).bound,
                    pivots,
                    rung,
                    basis,
                    exact: Some(exact),
                })
            }
        })
    }

    /// No contact, or those of the last step.
    fn quick(&mut self, lcp: Lcp<'_>, warm: Option<&Basis>) -> Option<Found> {
        let n = lcp.size();
        if self.limits.first <= Rung::Free && lcp.q.iter().fold(true, |all, q| all & (*q >= 0.0)) {
            self.z.clear();
            self.z.resize(n, 0.0);
            self.basis.reset(n);
            return Some(Found { rung: Rung::Free, residual: 0.0 });
        }
        let basis = warm.filter(|basis| self.limits.first <= Rung::Warm && basis.size() == n)?;
        self.basis.copy_from(basis);
        self.of_basis(lcp, Rung::Warm)
    }

    /// Lemke's method as it is, then with other ties, scales and starts, then Newton's.
    fn in_doubles(&mut self, lcp: Lcp<'_>, pivots: &mut usize) -> Option<Found> {
        let first = self.limits.first;
        let limit = self.limits.pivots_per_variable * lcp.size();
        if first <= Rung::Refined {
            let end = self.dictionary.follow(lcp.m, lcp.q, &[], Ties::LargestPivot, limit);
            *pivots += self.dictionary.pivots;
            self.dictionary.read(&mut self.basis, &mut self.z);
            if end == End::Complementary {
                let found = if first <= Rung::Lemke { self.accepted(lcp, Rung::Lemke) } else { None };
                let found = found.or_else(|| self.of_basis(lcp, Rung::Refined));
                if found.is_some() {
                    return found;
                }
            }
        }
        if first > Rung::Newton {
            return None;
        }
        self.scaled.load(lcp);
        if first <= Rung::Covers {
            let starts = if first == Rung::Covers { 1..5 } else { 0..5 };
            for start in starts {
                cover(start, lcp.size(), &mut self.cover);
                let scaled = self.scaled.lcp();
                let end = self.dictionary.follow(scaled.m, scaled.q, &self.cover, Ties::Lexicographic, limit);
                *pivots += self.dictionary.pivots;
                self.dictionary.read(&mut self.basis, &mut self.z);
                self.scaled.restore(&mut self.z);
                if end == End::Complementary {
                    let rung = if start == 0 { Rung::Scaled } else { Rung::Covers };
                    let found = self.accepted(lcp, rung).or_else(|| self.of_basis(lcp, rung));
                    if found.is_some() {
                        return found;
                    }
                }
            }
        }
        self.z.clear();
        self.z.resize(lcp.size(), 0.0);
        self.newton.iterate(self.scaled.lcp(), &mut self.dense, &mut self.z, &mut self.basis);
        self.of_basis(lcp, Rung::Newton)
    }

    /// The solution in `self.basis`, computed from the given numbers, if it passes.
    fn of_basis(&mut self, lcp: Lcp<'_>, rung: Rung) -> Option<Found> {
        if !self.dense.basic_solution(lcp, &self.basis, &mut self.z) {
            return None;
        }
        let found = self.accepted(lcp, rung);
        if found.is_some() || rung == Rung::Warm {
            return found;
        }
        self.dense.refine(lcp, &mut self.z);
        self.accepted(lcp, rung)
    }

    /// Whether `self.z` passes its check.
    fn accepted(&mut self, lcp: Lcp<'_>, rung: Rung) -> Option<Found> {
        let residual = lcp.residual(&self.z);
        if !residual.is_accepted() && residual.violation < self.best {
            self.best = residual.violation;
            self.best_basis.copy_from(&self.basis);
        }
        residual.is_accepted().then_some(Found { rung, residual: residual.bound })
    }
}

/// Covering vectors: all ones, then others between 1/2 and 5/2, the same at each call.
fn cover(start: u64, size: usize, out: &mut Vec<f64>) {
    let mut state = start;
    let next = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        if start == 0 { 1.0 } else { 0.5 + (state >> 40) as f64 / f64::from(1_u32 << 23) }
    };
    out.clear();
    out.extend(std::iter::repeat_with(next).take(size));
}
