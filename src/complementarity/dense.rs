//! The linear systems of complementary bases, in doubles.

use super::{Basis, Lcp};

/// Room for a factorization, kept from solve to solve.
#[derive(Debug, Clone, Default)]
pub(super) struct Dense {
    /// Indices of the basic `z`.
    support: Vec<usize>,
    /// `L` below the diagonal, `U` from it on, k × k.
    factors: Vec<f64>,
    /// Row exchanges.
    exchanges: Vec<usize>,
    /// Reciprocals of the pivots.
    inverses: Vec<f64>,
    right: Vec<f64>,
}

impl Dense {
    /// Solves `M_αα z_α = -q_α` for the basis α and writes `z`, with negative values as zeros; `false` if `M_αα` is singular.
    pub(super) fn basic_solution(&mut self, lcp: Lcp<'_>, basis: &Basis, z: &mut Vec<f64>) -> bool {
        let n = lcp.size();
        self.support.clear();
        self.support.extend(basis.iter());
        z.clear();
        z.resize(n, 0.0);
        let support = &self.support;
        self.factors.clear();
        for row in support {
            let row = &lcp.m[row * n..(row + 1) * n];
            self.factors.extend(support.iter().map(|column| row[*column]));
        }
        self.right.clear();
        self.right.extend(support.iter().map(|row| -lcp.q[*row]));
        if !self.factorize(support.len()) {
            return false;
        }
        self.substitute();
        self.add_to(z);
        true
    }

    /// One step of refinement with the factors of the last [`Dense::basic_solution`].
    pub(super) fn refine(&mut self, lcp: Lcp<'_>, z: &mut [f64]) {
        let n = lcp.size();
        self.right.clear();
        for row in &self.support {
            let entries = &lcp.m[row * n..(row + 1) * n];
            let w = self.support.iter().fold(lcp.q[*row], |sum, column| sum + entries[*column] * z[*column]);
            self.right.push(-w);
        }
        self.substitute();
        self.add_to(z);
    }

    /// Solves `A x = b` for a k × k matrix; `None` if it is singular.
    pub(super) fn solve(&mut self, a: &[f64], b: &[f64]) -> Option<&[f64]> {
        self.factors.clear();
        self.factors.extend_from_slice(a);
        self.right.clear();
        self.right.extend_from_slice(b);
        if !self.factorize(b.len()) {
            return None;
        }
        self.substitute();
        Some(&self.right)
    }

    fn add_to(&self, z: &mut [f64]) {
        for (index, value) in self.support.iter().zip(&self.right) {
            let sum = z[*index] + value;
            z[*index] = if sum > 0.0 { sum } else { 0.0 }; // not max, which hides NaN as well but may keep -0
        }
    }

    /// Gaussian elimination with row exchanges; `false` if a column has no pivot.
    fn factorize(&mut self, k: usize) -> bool {
        self.exchanges.clear();
        self.inverses.clear();
        let a = &mut self.factors;
        for step in 0..k {
            let size = |row: usize| a[row * k + step].abs();
            let pivot_row = (step + 1..k).fold(step, |best, row| if size(row) > size(best) { row } else { best });
            let pivot = a[pivot_row * k + step];
            if pivot == 0.0 || !pivot.is_finite() {
                return false;
            }
            self.exchanges.push(pivot_row);
            if pivot_row != step {
                for column in 0..k {
                    a.swap(step * k + column, pivot_row * k + column);
                }
            }
            let (above, below) = a.split_at_mut((step + 1) * k);
            let pivot_row = &above[step * k + step + 1..];
            let inverse = 1.0 / pivot;
            self.inverses.push(inverse);
            for row in below.chunks_exact_mut(k) {
                let factor = row[step] * inverse;
                row[step] = factor;
                if factor != 0.0 {
                    for (value, by) in row[step + 1..].iter_mut().zip(pivot_row) {
                        *value -= factor * by;
                    }
                }
            }
        }
        true
    }

    /// `right` becomes the solution for it.
    fn substitute(&mut self) {
        let (a, b) = (&self.factors, &mut self.right);
        let k = b.len();
        // all exchanges first: those of later steps have moved the factors of earlier ones
        for (step, with) in self.exchanges.iter().enumerate() {
            b.swap(step, *with);
        }
        for step in 0..k {
            for row in step + 1..k {
                b[row] -= a[row * k + step] * b[step];
            }
        }
        for step in (0..k).rev() {
            let row = &a[step * k..(step + 1) * k];
            let rest = row[step + 1..].iter().zip(&b[step + 1..]).fold(b[step], |sum, (u, x)| sum - u * x);
            b[step] = rest * self.inverses[step];
        }
    }
}
