//! Coordinates of a subspace: those of the space that are not pivots of its equalities.

use super::linear::Echelon;
use crate::exact::{Entries, Int, Matrix, Overflow};

/// The subspace on which the rows of an echelon form vanish, in the coordinates that are free there.
pub(super) struct Frame<'a, T> {
    equalities: &'a Echelon<T>,
    free: Vec<usize>,
}

impl<'a, T: Int> Frame<'a, T> {
    pub(super) fn without_pivots(equalities: &'a Echelon<T>) -> Self {
        let columns = 0..equalities.rows.columns();
        Self { equalities, free: columns.filter(|column| !equalities.pivots.contains(column)).collect() }
    }

    /// The free coordinates of each row.
    pub(super) fn restricted(&self, rows: &Matrix<T>) -> Matrix<T> {
        if self.equalities.pivots.is_empty() {
            return rows.clone();
        }
        let mut out = Matrix::with_capacity(self.free.len(), rows.len());
        for row in rows.rows() {
            out.push_from(self.free.iter().map(|column| row[*column].clone()));
        }
        out
    }

    /// Each row with zeros for the pivots.
    pub(super) fn padded(&self, rows: &Matrix<T>) -> Matrix<T> {
        let mut out = Matrix::with_capacity(self.equalities.rows.columns(), rows.len());
        for row in rows.rows() {
            let mut free = self.free.iter().copied().zip(row).peekable();
            let value = |column| free.next_if(|(next, _)| *next == column).map_or(T::default(), |(_, v)| v.clone());
            out.push_from((0..self.equalities.rows.columns()).map(value));
        }
        out
    }

    /// The vector of the subspace on the ray of each row, primitive.
    pub(super) fn lifted(&self, rows: &Matrix<T>) -> Result<Matrix<T>, Overflow> {
        if self.equalities.pivots.is_empty() {
            return Ok(rows.clone());
        }
        let mut lifted = self.padded(rows);
        let mut scratch = Entries::new();
        let units = Matrix::<T>::identity(lifted.columns());
        for (equality, pivot) in self.equalities.rows.rows().zip(&self.equalities.pivots) {
            for index in 0..lifted.len() {
                let row = lifted.row_mut(index);
                let rest = T::dot(equality, row)?;
                if T::wide_sign(&rest).is_ne() {
                    // a row of an echelon form has zeros for the pivots of the others, so that none is undone
                    scratch.clear();
                    let scale = equality[*pivot].widen();
                    T::combine(&scale, row, &T::wide_negated(&rest), units.row(*pivot), &mut scratch)?;
                    row.clone_from_slice(&scratch);
                }
            }
        }
        Ok(lifted)
    }
}
