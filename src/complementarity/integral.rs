//! A problem in short integers.

use super::ExactLcp;
use crate::exact::{Q, Z, fraction, make_primitive};
use num_integer::Integer as _;
use num_traits::{One as _, Zero as _};

/// `w' = M' z' + q'` with integer rows, `w'_i = r_i w_i` and `z_j = c_j z'_j`, all `r`, `c` positive.
///
/// The columns are scaled by powers of two such that the exponents of dyadic entries, which depend on the masses and
/// lengths on both sides, mostly cancel; then each row is made primitive.
#[derive(Debug, Clone)]
pub(super) struct Integral {
    /// n rows of `q'_i`, then of the n entries of `M'`.
    pub(super) rows: Vec<Vec<Z>>,
    /// `r`, up to one common factor.
    pub(super) row_factors: Vec<Q>,
    /// `c`.
    pub(super) column_factors: Vec<Q>,
}

impl Integral {
    pub(super) fn new(lcp: &ExactLcp) -> Self {
        let n = lcp.size();
        let given = |i: usize| std::iter::once(&lcp.q()[i]).chain(&lcp.m()[i]);
        let exponents: Vec<Vec<Option<i64>>> = (0..n).map(|i| given(i).map(exponent).collect()).collect();
        let columns = column_exponents(&exponents, n + 1);
        let mut rows = Vec::with_capacity(n);
        let mut row_factors = Vec::with_capacity(n);
        for (i, exponents) in exponents.iter().enumerate() {
            let scaled = exponents.iter().zip(&columns).filter_map(|(entry, column)| entry.map(|e| e + column));
            let least = scaled.min().unwrap_or(0);
            let odd = given(i).fold(Z::one(), |lcm, entry| lcm.lcm(&odd_part(entry.denom())));
            let integer = |(entry, column): (&Q, &i64)| {
                // what is left of the exponent is not negative, because `least` is the row's smallest
                let shift = column - least - twos(entry.denom());
                let value = entry.numer() * (&odd / odd_part(entry.denom()));
                if shift < 0 { value >> shift.unsigned_abs() } else { value << shift.unsigned_abs() }
            };
            let mut row: Vec<Z> = given(i).zip(&columns).map(integer).collect();
            let first = row.iter().position(|entry| !entry.is_zero());
            let before = first.map(|at| row[at].clone());
            make_primitive(&mut row);
            let divided = match (first, before) {
                (Some(at), Some(before)) => before / &row[at],
                _ => Z::one(),
            };
            row_factors.push(fraction(odd, divided) * power_of_two(-least));
            rows.push(row);
        }
        // the column of q only makes q' = q times a power of two: z' shrinks with it
        let column_factors = columns[1..].iter().map(|column| power_of_two(column - columns[0])).collect();
        Self { rows, row_factors, column_factors }
    }

    /// From `z'` to `z`.
    pub(super) fn restore(&self, z: &[Q]) -> Vec<Q> {
        z.iter().zip(&self.column_factors).map(|(value, factor)| value * factor).collect()
    }

    /// From multipliers of the integer rows to those of the given rows.
    pub(super) fn restore_multipliers(&self, y: &[Q]) -> Vec<Q> {
        y.iter().zip(&self.row_factors).map(|(value, factor)| value * factor).collect()
    }
}

/// Exponents of the column factors: rows and columns take turns in moving their smallest exponent to zero.
fn column_exponents(exponents: &[Vec<Option<i64>>], count: usize) -> Vec<i64> {
    let mut rows = vec![0_i64; exponents.len()];
    let mut columns = vec![0_i64; count];
    for _ in 0..2 {
        for (column, factor) in columns.iter_mut().enumerate() {
            let least = exponents.iter().zip(&rows).filter_map(|(row, factor)| Some(row[column]? + factor)).min();
            *factor = -least.unwrap_or(0);
        }
        for (row, factor) in exponents.iter().zip(&mut rows) {
            let least = row.iter().zip(&columns).filter_map(|(entry, factor)| Some((*entry)? + factor)).min();
            *factor = -least.unwrap_or(0);
        }
    }
    columns
}

/// The power of two in a number; none in zero.
fn exponent(value: &Q) -> Option<i64> {
    (!value.is_zero()).then(|| twos(value.numer()) - twos(value.denom()))
}

fn twos(value: &Z) -> i64 {
    value.trailing_zeros().unwrap_or(0) as i64
}

fn odd_part(value: &Z) -> Z {
    value >> value.trailing_zeros().unwrap_or(0)
}

fn power_of_two(exponent: i64) -> Q {
    let power = Z::one() << exponent.unsigned_abs();
    if exponent < 0 { Q::new_raw(Z::one(), power) } else { Q::from(power) }
}
