//! Fraction-free linear algebra on primitive integer rows.

use crate::exact::{Int, Matrix, Overflow};
use std::cmp::Ordering;

/// A basis in reduced row echelon form: primitive rows, positive pivots, zeros above and below each pivot.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Echelon<T> {
    pub(super) rows: Matrix<T>,
    pub(super) pivots: Vec<usize>,
}

/// Reduced row echelon form of the span of `rows`.
pub(super) fn echelon<T: Int>(rows: &Matrix<T>) -> Result<Echelon<T>, Overflow> {
    let columns = rows.columns();
    let mut pivots = Vec::new();
    if rows.is_empty() {
        return Ok(Echelon { rows: Matrix::new(columns), pivots });
    }
    let mut work: Vec<Vec<T>> = rows.rows().map(<[T]>::to_vec).collect();
    for column in 0..columns {
        let rank = pivots.len();
        let Some(found) = (rank..work.len()).find(|row| work[*row][column].sign().is_ne()) else { continue };
        work.swap(rank, found);
        if work[rank][column].sign().is_lt() {
            work[rank].iter_mut().for_each(|value| *value = value.negated());
        }
        T::make_primitive(&mut work[rank]);
        let pivot_row = work[rank].clone();
        for (index, row) in work.iter_mut().enumerate() {
            if index != rank {
                *row = eliminated(row, &pivot_row, column)?;
            }
        }
        pivots.push(column);
    }
    Ok(Echelon { rows: Matrix::from_rows(columns, &work[..pivots.len()]), pivots })
}

impl<T: Int> Echelon<T> {
    /// The primitive row equal to `row` modulo the basis with zeros in the pivot columns; zero if `row` is in the span.
    pub(super) fn reduce(&self, row: &[T]) -> Result<Vec<T>, Overflow> {
        let mut reduced = row.to_vec();
        for (basis_row, pivot) in self.rows.rows().zip(&self.pivots) {
            reduced = eliminated(&reduced, basis_row, *pivot)?;
        }
        T::make_primitive(&mut reduced);
        Ok(reduced)
    }
}

/// `row` with `column` cleared by a positive multiple of itself plus a multiple of `pivot_row` (positive pivot).
fn eliminated<T: Int>(row: &[T], pivot_row: &[T], column: usize) -> Result<Vec<T>, Overflow> {
    if row[column].sign() == Ordering::Equal {
        return Ok(row.to_vec());
    }
    let mut out = Vec::with_capacity(row.len());
    T::combine(&pivot_row[column].widen(), row, &row[column].negated().widen(), pivot_row, &mut out)?;
    Ok(out)
}

pub(super) fn is_zero<T: Int>(row: &[T]) -> bool {
    row.iter().all(|value| value.sign() == Ordering::Equal)
}

pub(super) fn dot_sign<T: Int>(a: &[T], b: &[T]) -> Result<Ordering, Overflow> {
    T::dot(a, b).map(|value| T::wide_sign(&value))
}

/// A positive combination of `rows`, primitive; which one is of no account.
pub(super) fn positive_combination<'a, T: Int + 'a>(
    columns: usize,
    rows: impl IntoIterator<Item = &'a [T]>,
) -> Result<Vec<T>, Overflow> {
    let one = T::unit().widen();
    rows.into_iter().try_fold(vec![T::default(); columns], |total, row| {
        let mut out = Vec::with_capacity(columns);
        T::combine(&one, &total, &one, row, &mut out)?;
        Ok(out)
    })
}
