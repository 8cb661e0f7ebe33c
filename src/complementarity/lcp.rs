//! A dense problem in doubles and the bound that an answer to it must meet.

/// The linear complementarity problem `w = M z + q`, `0 ≤ w ⊥ z ≥ 0`, as a view of the caller's numbers.
///
/// | field | shape | unit for contacts |
/// |---|---|---|
/// | `m` | n × n, row-major | velocity over impulse, `mu` and 1 in the rows of the cones |
/// | `q` | n | velocity, 0 in the rows of the cones |
#[derive(Debug, Clone, Copy)]
pub struct Lcp<'a> {
    /// **M**, row after row.
    pub m: &'a [f64],
    /// The right side.
    pub q: &'a [f64],
}

/// The largest violation, relative to `‖q‖∞` and beyond what rounding explains, with which an answer in doubles is accepted.
pub const ACCEPTED_VIOLATION: f64 = 1e-9;

/// The largest residual, relative to `‖q‖∞` and with what rounding can hide, with which an answer in doubles is accepted.
pub const ACCEPTED_RESIDUAL: f64 = 1e-7;

/// How well a vector solves a problem, relative to `‖q‖∞`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Residual {
    /// The largest violation less what rounding explains.
    pub violation: f64,
    /// The largest violation and what rounding can hide.
    pub bound: f64,
}

impl Residual {
    /// Whether an answer with this residual leaves the solver.
    #[must_use]
    pub fn is_accepted(&self) -> bool {
        self.violation <= ACCEPTED_VIOLATION && self.bound <= ACCEPTED_RESIDUAL
    }
}

impl Lcp<'_> {
    /// Number of variables `z`.
    #[must_use]
    pub fn size(&self) -> usize {
        self.q.len()
    }

    /// Whether the problem has a shape and finite entries.
    ///
    /// # Errors
    /// [`LcpError`] says what is wrong.
    pub fn check(&self) -> Result<(), LcpError> {
        let n = self.q.len();
        if n.checked_mul(n) != Some(self.m.len()) {
            return Err(LcpError::Shape { entries: self.m.len(), size: n });
        }
        // no early exit: the loops are a few wide instructions
        let finite = |values: &[f64]| values.iter().fold(true, |all, value| all & value.is_finite());
        if finite(self.m) && finite(self.q) { Ok(()) } else { Err(LcpError::NotFinite) }
    }

    /// The residual of `z ≥ 0`; infinite if `z` is negative somewhere, not finite, or of another length.
    ///
    /// The violation of row `i` is `|w_i|` where `z_i > 0` and `max(0, -w_i)` elsewhere. Rounding of the sum and of an
    /// assembled **M** hides at most about `(n/4 + 8) u s_i`, `s_i = |q_i| + Σ |m_ij| z_j`, `u = 2^-53`. Impulses may be
    /// 10^6 times larger than `‖q‖`; then this term grows with them, and from about `s_i = 10^7 ‖q‖` on no answer in
    /// doubles can be accepted, because doubles cannot tell.
    ///
    /// All rows are compared in units of `q`, velocities for contacts. A row without diagonal and right side bounds one
    /// impulse by others (`mu p_n - Σ p_f`); its violation is multiplied by the largest diagonal entry of the variables
    /// in it, which makes it the velocity that the missing impulse would cause. The residual is therefore invariant under
    /// changes of the units of mass, length and time.
    #[must_use]
    pub fn residual(&self, z: &[f64]) -> Residual {
        const REFUSED: Residual = Residual { violation: f64::INFINITY, bound: f64::INFINITY };
        let n = self.size();
        if z.len() != n || !z.iter().all(|value| *value >= 0.0 && value.is_finite()) {
            return REFUSED;
        }
        let rounding = (n / 4 + 8) as f64 * (f64::EPSILON / 2.0);
        let (mut violation, mut bound) = (0.0_f64, 0.0_f64);
        for ((row, (i, q)), z_i) in self.m.chunks_exact(n.max(1)).zip(self.q.iter().enumerate()).zip(z) {
            let (product, size) = product_and_size(row, z);
            let w = product + q;
            let mut here = if *z_i > 0.0 { w.abs() } else { (-w).max(0.0) };
            let mut hidden = rounding * (size + q.abs());
            if row[i] == 0.0 && *q == 0.0 {
                let unit = self.cone_row_unit(row);
                here *= unit;
                hidden *= unit;
            }
            if !(here + hidden).is_finite() {
                return REFUSED;
            }
            violation = violation.max(here - hidden);
            bound = bound.max(here + hidden);
        }
        let norm = self.norm();
        let relative = |value: f64| if value == 0.0 { 0.0 } else { value / norm };
        Residual { violation: relative(violation), bound: relative(bound) }
    }

    /// The largest diagonal entry of the variables that occur in the row.
    fn cone_row_unit(&self, row: &[f64]) -> f64 {
        let n = self.size();
        let diagonal = self.m.iter().step_by(n + 1);
        row.iter().zip(diagonal).filter(|(entry, _)| **entry != 0.0).fold(0.0, |most, (_, d)| d.abs().max(most))
    }

    /// `‖q‖∞`.
    pub(super) fn norm(&self) -> f64 {
        self.q.iter().fold(0.0, |most, value| value.abs().max(most))
    }
}

/// `Σ m_j z_j` and `Σ |m_j z_j|`, added in four lanes so that the order is the same everywhere.
#[inline]
fn product_and_size(row: &[f64], z: &[f64]) -> (f64, f64) {
    let (mut sums, mut sizes) = ([0.0; 4], [0.0; 4]);
    let (mut row, mut z) = (row.chunks_exact(4), z.chunks_exact(4));
    for (m, z) in (&mut row).zip(&mut z) {
        for lane in 0..4 {
            let term = m[lane] * z[lane];
            sums[lane] += term;
            sizes[lane] += term.abs();
        }
    }
    for (m, z) in row.remainder().iter().zip(z.remainder()) {
        sums[0] += m * z;
        sizes[0] += (m * z).abs();
    }
    ((sums[0] + sums[1]) + (sums[2] + sums[3]), (sizes[0] + sizes[1]) + (sizes[2] + sizes[3]))
}

/// What makes a problem unusable.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum LcpError {
    /// **M** is not square with as many rows as `q`.
    #[error("{entries} matrix entries do not make a square of the {size} entries of q")]
    Shape {
        /// Entries of **M**.
        entries: usize,
        /// Entries of `q`.
        size: usize,
    },
    /// NaN or infinity.
    #[error("an entry is not a finite number")]
    NotFinite,
    /// A slice of [`Factors`](super::Factors) has another length than the others imply.
    #[error("{found} entries of {what}, but {expected} are needed")]
    Factor {
        /// Which slice.
        what: &'static str,
        /// Its length.
        found: usize,
        /// The length that fits the others.
        expected: usize,
    },
    /// The problem given for the exact rungs has another size than the one in doubles.
    #[error("the exact problem has {exact} variables and the one in doubles {doubles}")]
    Sizes {
        /// Variables of the exact problem.
        exact: usize,
        /// Variables of the problem in doubles.
        doubles: usize,
    },
}
