//! Semismooth Newton on the Fischer-Burmeister equations.

use super::dense::Dense;
use super::{Basis, Lcp};

/// Steps at most.
const STEPS: usize = 60;
/// Halvings of a step at most.
const HALVINGS: usize = 25;

/// Room for the method, kept from solve to solve.
#[derive(Debug, Clone, Default)]
pub(super) struct Newton {
    w: Vec<f64>,
    next: Vec<f64>,
    step: Vec<f64>,
    values: Vec<f64>,
    jacobian: Vec<f64>,
}

impl Newton {
    /// Drives `φ_i = √(z_i² + w_i²) - z_i - w_i` to zero from `z` on, and reads the basis off: `z_i` where it exceeds `w_i`.
    ///
    /// # Source
    /// De Luca, Facchinei and Kanzow (1996), with the Newton step only and Armijo's rule for `½ |φ|²`.
    pub(super) fn iterate(&mut self, lcp: Lcp<'_>, dense: &mut Dense, z: &mut [f64], basis: &mut Basis) {
        let n = lcp.size();
        let mut merit = self.evaluate(lcp, z);
        let enough = (1e-14 * lcp.norm()).powi(2);
        for _ in 0..STEPS {
            if merit <= enough || !merit.is_finite() {
                break;
            }
            self.linearize(lcp, z);
            let Some(step) = dense.solve(&self.jacobian, &self.values) else { break };
            self.step.clear();
            self.step.extend_from_slice(step);
            let mut length = 1.0;
            let mut fell = None;
            for _ in 0..HALVINGS {
                self.next.clear();
                self.next.extend(z.iter().zip(&self.step).map(|(z, step)| z - length * step));
                let next = std::mem::take(&mut self.next);
                let reached = self.evaluate(lcp, &next);
                self.next = next;
                if reached <= (1.0 - 2e-4 * length) * merit {
                    fell = Some(reached);
                    break;
                }
                length *= 0.5;
            }
            let Some(reached) = fell else { break };
            z.copy_from_slice(&self.next);
            merit = reached;
        }
        self.evaluate(lcp, z);
        basis.reset(n);
        (0..n).filter(|i| z[*i] > self.w[*i]).for_each(|i| basis.insert(i));
    }

    /// Half the squared norm of `φ` at `z`.
    fn evaluate(&mut self, lcp: Lcp<'_>, z: &[f64]) -> f64 {
        self.w.clear();
        let rows = lcp.m.chunks_exact(z.len().max(1)).zip(lcp.q);
        self.w.extend(rows.map(|(row, q)| row.iter().zip(z).fold(*q, |sum, (m, z)| sum + m * z)));
        self.values.clear();
        self.values.extend(z.iter().zip(&self.w).map(|(z, w)| {
            let root = (z * z + w * w).sqrt();
            // -2 z w / (root + z + w) where the difference would cancel
            if z + w > 0.0 { -2.0 * z * w / (root + (z + w)) } else { root - (z + w) }
        }));
        self.values.iter().fold(0.0, |sum, value| sum + value * value) * 0.5
    }

    /// An element of the generalized Jacobian of `φ`.
    fn linearize(&mut self, lcp: Lcp<'_>, z: &[f64]) {
        let n = z.len();
        self.evaluate(lcp, z);
        self.jacobian.clear();
        for (i, row) in lcp.m.chunks_exact(n.max(1)).enumerate() {
            let root = (z[i] * z[i] + self.w[i] * self.w[i]).sqrt();
            let half = std::f64::consts::FRAC_1_SQRT_2;
            let (a, b) =
                if root > 0.0 { (z[i] / root - 1.0, self.w[i] / root - 1.0) } else { (half - 1.0, half - 1.0) };
            self.jacobian.extend(row.iter().map(|m| b * m));
            self.jacobian[i * n + i] += a;
        }
    }
}
