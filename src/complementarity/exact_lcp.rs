//! A problem in rational numbers.

use super::factors::exact;
use super::{Lcp, LcpError};
use crate::exact::{Q, dot};
use num_traits::{Signed as _, Zero as _};

/// `w = M z + q`, `0 ≤ w ⊥ z ≥ 0` without rounding.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ExactLcp {
    m: Vec<Vec<Q>>,
    q: Vec<Q>,
}

impl ExactLcp {
    /// The problem with the rows `m` and the right side `q`.
    ///
    /// # Errors
    /// [`LcpError::Shape`] if `m` is not square with as many rows as `q`.
    pub fn new(m: Vec<Vec<Q>>, q: Vec<Q>) -> Result<Self, LcpError> {
        let size = q.len();
        if m.len() != size || m.iter().any(|row| row.len() != size) {
            return Err(LcpError::Shape { entries: m.iter().map(Vec::len).sum(), size });
        }
        Ok(Self { m, q })
    }

    /// The problem whose entries are exactly the doubles of `lcp`.
    ///
    /// For contacts [`Factors::to_exact`](super::Factors::to_exact) is the right one: a rounded **M** has lost its rank.
    ///
    /// # Errors
    /// [`LcpError`] if the shape is wrong or an entry is not finite.
    pub fn from_floats(lcp: Lcp<'_>) -> Result<Self, LcpError> {
        lcp.check()?;
        let m = lcp.m.chunks_exact(lcp.size().max(1)).map(exact).collect::<Result<_, _>>()?;
        Self::new(m, exact(lcp.q)?)
    }

    /// Number of variables `z`.
    #[must_use]
    pub fn size(&self) -> usize {
        self.q.len()
    }

    /// The rows of **M**.
    #[must_use]
    pub fn m(&self) -> &[Vec<Q>] {
        &self.m
    }

    /// The right side.
    #[must_use]
    pub fn q(&self) -> &[Q] {
        &self.q
    }

    /// `w = M z + q`.
    #[must_use]
    pub fn w(&self, z: &[Q]) -> Vec<Q> {
        self.m.iter().zip(&self.q).map(|(row, q)| dot(row, z) + q).collect()
    }

    /// Whether `z` is a solution: `z ≥ 0`, `w ≥ 0`, and of each pair one is zero.
    #[must_use]
    pub fn is_solution(&self, z: &[Q]) -> bool {
        let is_pair = |(z, w): (&Q, &Q)| !z.is_negative() && !w.is_negative() && (z.is_zero() || w.is_zero());
        z.len() == self.size() && z.iter().zip(&self.w(z)).all(is_pair)
    }
}
