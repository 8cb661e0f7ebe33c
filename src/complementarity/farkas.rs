//! Multipliers that prove that some complementary choices have no solution.

use super::integral::Integral;
use super::{ExactLcp, ExcludedCase};
use crate::cone::{HalfSpaces, summands};
use crate::exact::{Matrix, Q, dot};
use num_traits::{One as _, Signed as _, Zero as _};

/// The case with multipliers as [`ExcludedCase`] wants them, or `None` if the system of the case has a solution.
///
/// The system is `z ≥ 0`, `w = M z + q ≥ 0` with the given zeros, and without the complementarity of the other pairs.
pub(super) fn excluded(integral: &Integral, zero_z: &[usize], zero_w: &[usize]) -> Option<ExcludedCase> {
    let n = integral.rows.len();
    let bounded: Vec<usize> = (0..n).filter(|column| !zero_z.contains(column)).collect();
    let dim = bounded.len() + 1;
    // (Mᵀ y)_j + s_j = 0 for the other z_j, q · y = -1; y and s not negative
    let column = |row: usize, sign: i32| -> Vec<Q> {
        let row = &integral.rows[row];
        let entries = bounded.iter().map(|j| &row[j + 1]).chain([&row[0]]);
        entries.map(|entry| Q::from(entry * sign)).collect()
    };
    let mut columns: Vec<Vec<Q>> = (0..n).map(|row| column(row, 1)).collect();
    columns.extend(zero_w.iter().map(|row| column(*row, -1)));
    columns.extend((0..bounded.len()).map(|at| unit(dim, at)));
    let point = unit(dim, dim - 1).iter().map(|entry| -entry).collect::<Vec<_>>();
    let origin = HalfSpaces { equalities: Matrix::identity(dim), ..HalfSpaces::<i64>::none(dim) };
    let weights = summands(&origin, &columns, &point).ok().flatten()?.weights;
    let mut y = weights[..n].to_vec();
    for (row, weight) in zero_w.iter().zip(&weights[n..]) {
        y[*row] -= weight;
    }
    let multipliers = integral.restore_multipliers(&y);
    Some(ExcludedCase { zero_z: zero_z.to_vec(), zero_w: zero_w.to_vec(), multipliers })
}

/// Whether `y ≥ 0`, `Mᵀ y ≤ 0` and `q · y < 0`.
pub(super) fn is_farkas(lcp: &ExactLcp, y: &[Q]) -> bool {
    let mut columns = vec![Q::zero(); lcp.size()];
    for (row, multiplier) in lcp.m().iter().zip(y).filter(|(_, multiplier)| !multiplier.is_zero()) {
        columns.iter_mut().zip(row).for_each(|(sum, entry)| *sum += entry * multiplier);
    }
    !y.iter().any(Q::is_negative) && !columns.iter().any(Q::is_positive) && dot(lcp.q(), y).is_negative()
}

fn unit(dim: usize, at: usize) -> Vec<Q> {
    (0..dim).map(|index| if index == at { Q::one() } else { Q::zero() }).collect()
}
