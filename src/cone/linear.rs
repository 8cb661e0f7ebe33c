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
    let mut echelon = Echelon { rows: Matrix::new(rows.columns()), pivots: Vec::new() };
    for row in rows.rows() {
        if echelon.pivots.len() == rows.columns() {
            break;
        }
        echelon.insert(row)?;
    }
    Ok(echelon)
}

impl<T: Int> Echelon<T> {
    /// Adds `row` to the span; whether it was not in there.
    pub(super) fn insert(&mut self, row: &[T]) -> Result<bool, Overflow> {
        let mut fresh: Entries<T> = row.iter().cloned().collect();
        self.reduce(&mut fresh)?;
        let Some(pivot) = fresh.iter().position(|entry| entry.sign().is_ne()) else { return Ok(false) };
        if fresh[pivot].sign().is_lt() {
            negate(&mut fresh);
        }
        for index in 0..self.rows.len() {
            let row = self.rows.row_mut(index);
            if row[pivot].sign().is_ne() {
                row.clone_from_slice(&eliminated(row, &fresh, pivot)?);
            }
        }
        let place = self.pivots.partition_point(|other| *other < pivot);
        self.pivots.insert(place, pivot);
        self.rows.insert(place, &fresh);
        Ok(true)
    }

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
