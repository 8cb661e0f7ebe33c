//! Fraction-free linear algebra on primitive integer rows.

use crate::exact::{Entries, Int, Matrix, Overflow};
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
    let mut work: Vec<Entries<T>> = rows.rows().map(|row| row.iter().cloned().collect()).collect();
    for column in 0..columns {
        let rank = pivots.len();
        let Some(found) = (rank..work.len()).find(|row| work[*row][column].sign().is_ne()) else { continue };
        work.swap(rank, found);
        if work[rank][column].sign().is_lt() {
            negate(&mut work[rank]);
        }
        T::make_primitive(&mut work[rank]);
        let pivot_row = work[rank].clone();
        for (index, row) in work.iter_mut().enumerate() {
            if index != rank && row[column].sign().is_ne() {
                *row = eliminated(row, &pivot_row, column)?;
            }
        }
        pivots.push(column);
    }
    Ok(Echelon { rows: Matrix::from_rows(columns, &work[..pivots.len()]), pivots })
}

impl<T: Int> Echelon<T> {
    /// Replaces `row` by the primitive row equal to it modulo the basis with zeros in the pivot columns, which is zero
    /// if `row` is in the span.
    pub(super) fn reduce(&self, row: &mut [T]) -> Result<(), Overflow> {
        for (basis_row, pivot) in self.rows.rows().zip(&self.pivots) {
            if row[*pivot].sign().is_ne() {
                row.clone_from_slice(&eliminated(row, basis_row, *pivot)?);
            }
        }
        T::make_primitive(row);
        Ok(())
    }

    /// [`Echelon::reduce`] for each of `rows`.
    pub(super) fn reduce_all(&self, rows: &mut Matrix<T>) -> Result<(), Overflow> {
        (0..rows.len()).try_for_each(|row| self.reduce(rows.row_mut(row)))
    }
}

/// `row` with `column` cleared by a positive multiple of itself plus a multiple of `pivot_row` (positive pivot).
fn eliminated<T: Int>(row: &[T], pivot_row: &[T], column: usize) -> Result<Entries<T>, Overflow> {
    let mut out = Entries::new();
    T::combine(&pivot_row[column].widen(), row, &row[column].negated().widen(), pivot_row, &mut out)?;
    Ok(out)
}

/// Turns `row` around.
pub(super) fn negate<T: Int>(row: &mut [T]) {
    row.iter_mut().for_each(|value| *value = value.negated());
}

pub(super) fn is_zero<T: Int>(row: &[T]) -> bool {
    row.iter().all(|value| value.sign() == Ordering::Equal)
}

/// Sign of `a · b`; in three dimensions it is known whatever the size of the entries.
pub(super) fn dot_sign<T: Int>(a: &[T], b: &[T]) -> Result<Ordering, Overflow> {
    if let (Ok(a), Ok(b)) = (a.try_into(), b.try_into()) {
        return Ok(T::side_of(a, b));
    }
    T::dot(a, b).map(|value| T::wide_sign(&value))
}

/// A positive combination of `rows`, primitive; which one is of no account.
pub(super) fn positive_combination<'a, T: Int + 'a>(
    columns: usize,
    rows: impl IntoIterator<Item = &'a [T]>,
) -> Result<Entries<T>, Overflow> {
    let one = T::unit().widen();
    let zero = Entries::from_elem(T::default(), columns);
    rows.into_iter().try_fold(zero, |total, row| {
        let mut out = Entries::new();
        T::combine(&one, &total, &one, row, &mut out)?;
        Ok(out)
    })
}

/// Appends the ray between ray `inside` (negative product) and ray `outside` (positive product) on the hyperplane.
pub(super) fn crossing<T: Int>(
    rays: &Matrix<T>,
    inside: usize,
    depth: &T::Wide,
    outside: usize,
    height: &T::Wide,
    out: &mut Matrix<T>,
) -> Result<(), Overflow> {
    let (inside, outside) = (rays.row(inside), rays.row(outside));
    out.push_with(|entries| T::combine(height, inside, &T::wide_negated(depth), outside, entries))
}
