//! The solution in a given basis, without rounding.

use super::Basis;
use super::integral::Integral;
use crate::exact::{Entries, Int, Ladder, Overflow, Q, Rung, Z, climb};
use num_traits::Zero as _;

/// The `z` of the basis, if the basis is regular and `z` a solution.
///
/// What doubles propose is mostly right even where they cannot tell; this is then a small part of the work of a path.
pub(super) fn solution_of(integral: &Integral, basis: &Basis) -> Option<Vec<Q>> {
    let z = climb(&Elimination { rows: &integral.rows, basis }, Rung::Word).0?;
    Some(integral.restore(&z))
}

struct Elimination<'a> {
    rows: &'a [Vec<Z>],
    basis: &'a Basis,
}

impl Ladder for Elimination<'_> {
    type Output = Option<Vec<Q>>;

    /// Rows `own · basic = constant + Σ entry · z` for the `z` of the basis that are still nonbasic; columns of variables
    /// that have left the basis are zero and dropped.
    fn run<T: Int>(&self) -> Result<Self::Output, Overflow> {
        let support: Vec<usize> = self.basis.iter().collect();
        let mut rows = Vec::with_capacity(self.rows.len());
        for row in self.rows {
            let mut entries = Entries::<T>::with_capacity(support.len() + 2);
            entries.push(T::unit());
            for at in std::iter::once(0).chain(support.iter().map(|index| index + 1)) {
                entries.push(T::from_z(&row[at]).ok_or(Overflow)?);
            }
            rows.push(entries);
        }
        // the variable of each row of the support, once it is basic
        let mut entered: Vec<Option<usize>> = vec![None; self.rows.len()];
        for (at, variable) in support.iter().enumerate().rev() {
            let column = at + 2;
            let free = support.iter().find(|row| entered[**row].is_none() && rows[**row][column].sign().is_ne());
            let Some(chosen) = free else { return Ok(None) };
            eliminate(&mut rows, *chosen, column)?;
            entered[*chosen] = Some(*variable);
        }
        let mut z = vec![Q::zero(); self.rows.len()];
        for (row, variable) in rows.iter().zip(entered) {
            if row[1].sign().is_lt() {
                return Ok(None);
            }
            if let Some(variable) = variable {
                z[variable] = Q::new(row[1].to_z(), row[0].to_z());
            }
        }
        Ok(Some(z))
    }
}

/// Makes the variable of the last `column` basic in the row `chosen`, and drops the column.
fn eliminate<T: Int>(rows: &mut [Entries<T>], chosen: usize, column: usize) -> Result<(), Overflow> {
    let mut pivot_row = std::mem::take(&mut rows[chosen]);
    let entry = pivot_row.pop().unwrap_or_default();
    let is_positive = entry.sign().is_gt();
    let multiplier = if is_positive { entry } else { entry.negated() };
    pivot_row[0] = T::default();
    for row in rows.iter_mut().filter(|row| !row.is_empty()) {
        let by = row.pop().unwrap_or_default();
        debug_assert_eq!(row.len(), column, "the column is the last one");
        if by.sign().is_ne() {
            let by = if is_positive { by.negated() } else { by };
            let mut next = Entries::with_capacity(row.len());
            T::combine(&multiplier.widen(), row, &by.widen(), &pivot_row, &mut next)?;
            *row = next;
        }
    }
    if is_positive {
        pivot_row.iter_mut().for_each(|value| *value = value.negated());
    }
    pivot_row[0] = multiplier;
    rows[chosen] = pivot_row;
    Ok(())
}
