//! Checks of answers that share no code with the solver.

use crate::contacts::Problem;
use num_traits::Signed as _;
use partplan::complementarity::{ExactLcp, Proof};
use partplan::exact::Q;

/// A sum of doubles with about twice their digits.
#[derive(Clone, Copy, Default)]
pub struct Sum {
    high: f64,
    low: f64,
}

impl Sum {
    pub fn add(&mut self, value: f64) {
        let sum = self.high + value;
        let part = sum - self.high;
        self.low += (self.high - (sum - part)) + (value - part);
        self.high = sum;
    }

    pub fn add_product(&mut self, a: f64, b: f64) {
        let (product, error) = exact_product(a, b);
        self.add(product);
        self.add(error);
    }

    pub fn value(self) -> f64 {
        self.high + self.low
    }
}

/// `a b` and what rounding took from it, by Dekker's splitting.
fn exact_product(a: f64, b: f64) -> (f64, f64) {
    let split = |x: f64| {
        let c = 134_217_729.0 * x;
        let high = c - (c - x);
        (high, x - high)
    };
    let product = a * b;
    let ((a_high, a_low), (b_high, b_low)) = (split(a), split(b));
    (product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low)
}

/// The largest violation of the laws of contact over the largest velocity, from the factors, not from **M**.
///
/// Velocities after the impulses, then gaps and slips from these; a missing friction impulse counts as the velocity that
/// it would cause at its contact.
pub fn violation(problem: &Problem, z: &[f64]) -> f64 {
    let (contacts, velocities, n_l) = (problem.mu.len(), problem.inverse_mass.len(), problem.directions);
    let impulses = contacts * (1 + n_l);
    let row = |index: usize| &problem.jacobian[index * velocities..(index + 1) * velocities];
    let mut change = vec![Sum::default(); velocities];
    for (impulse, size) in z[..impulses].iter().enumerate() {
        for (sum, entry) in change.iter_mut().zip(row(impulse)) {
            sum.add_product(*entry, *size);
        }
    }
    let mut worst = 0.0_f64;
    let mut pair = |w: f64, z: f64, unit: f64| {
        assert!(z >= 0.0 && z.is_finite(), "impulses are not negative");
        worst = worst.max(unit * if z > 0.0 { w.abs() } else { (-w).max(0.0) });
    };
    let mut mobility = vec![0.0_f64; impulses];
    for impulse in 0..impulses {
        let mut w = Sum::default();
        w.add(problem.q[impulse]);
        for ((entry, inverse), change) in row(impulse).iter().zip(&problem.inverse_mass).zip(&change) {
            // the entry times the inverse mass, with its error, times the impulse on this axis
            let (weight, error) = exact_product(*entry, *inverse);
            w.add_product(weight, change.high);
            w.add(weight * change.low + error * change.high);
            mobility[impulse] += weight * entry;
        }
        if impulse >= contacts {
            w.add(z[impulses + (impulse - contacts) / n_l]);
        }
        pair(w.value(), z[impulse], 1.0);
    }
    for (contact, mu) in problem.mu.iter().enumerate() {
        let mut w = Sum::default();
        w.add_product(*mu, z[contact]);
        let frictions = contacts + contact * n_l..contacts + (contact + 1) * n_l;
        frictions.clone().for_each(|friction| w.add(-z[friction]));
        let unit = frictions.fold(mobility[contact], |most, friction| mobility[friction].max(most));
        pair(w.value(), z[impulses + contact], unit);
    }
    worst / problem.q.iter().fold(0.0_f64, |most, value| value.abs().max(most))
}

/// Whether a proof that there is no solution holds: signs and sums only.
pub fn proof_holds(lcp: &ExactLcp, proof: &Proof) -> bool {
    let n = lcp.size();
    let holds = |zero_z: &[usize], zero_w: &[usize], y: &[Q]| {
        let column = |j: usize| (0..n).map(|i| &lcp.m()[i][j] * &y[i]).sum::<Q>();
        (0..n).all(|i| zero_w.contains(&i) || !y[i].is_negative())
            && (0..n).all(|j| zero_z.contains(&j) || !column(j).is_positive())
            && (0..n).map(|i| &lcp.q()[i] * &y[i]).sum::<Q>().is_negative()
    };
    match proof {
        Proof::Farkas(y) => holds(&[], &[], y),
        Proof::Cases(cases) => {
            // each choice is in exactly one case: no two cases share one, and their numbers add up
            let clash = |a: &[usize], b: &[usize]| a.iter().any(|index| b.contains(index));
            let apart = cases.iter().enumerate().all(|(at, a)| {
                let others = &cases[..at];
                others.iter().all(|b| clash(&a.zero_z, &b.zero_w) || clash(&a.zero_w, &b.zero_z))
            });
            let choices = cases.iter().map(|case| 1_u128 << (n - case.zero_z.len() - case.zero_w.len())).sum::<u128>();
            apart && choices == 1 << n && cases.iter().all(|c| holds(&c.zero_z, &c.zero_w, &c.multipliers))
        }
    }
}
