//! Numbers a + b √n with rational a, b and n: lengths and heights over an edge of a polygon.

use super::{Q, to_f64};
use num_traits::Zero as _;

/// The number a + b √n, with n ≥ 0.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Surd {
    a: Q,
    b: Q,
    n: Q,
}

impl Surd {
    /// a + b √n.
    #[must_use]
    pub fn new(a: Q, b: Q, n: Q) -> Self {
        Self { a, b, n }
    }

    /// The nearest double, for pictures and decimal views only.
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        if self.b.is_zero() { to_f64(&self.a) } else { to_f64(&self.a) + to_f64(&self.b) * to_f64(&self.n).sqrt() }
    }
}
