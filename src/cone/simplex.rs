//! Points as non-negative combinations of columns, by the simplex method in exact rationals.

use crate::exact::Q;
use num_traits::{One as _, Signed as _, Zero as _};

/// A basic solution `z ≥ 0` of `Σ z_k column_k = point`, ready to be moved to others.
pub(super) struct Simplex {
    columns: usize,
    /// Basic rows: an entry for each column, then the basic variable's value.
    rows: Vec<Vec<Q>>,
    /// The basic variable of each row; from `columns` on, the defects that the first phase drives to zero.
    basis: Vec<usize>,
}

/// What a pivot towards a larger objective met.
enum Outcome {
    Moved,
    /// The variable that may grow without end.
    Unbounded(usize),
    Optimal,
}

impl Simplex {
    /// A basic solution, or `None` if there is no solution.
    pub(super) fn feasible(columns: &[Vec<Q>], point: &[Q]) -> Option<Self> {
        let count = columns.len();
        let rows = point.iter().enumerate().map(|(axis, value)| {
            let side = |entry: &Q| if value.is_negative() { -entry } else { entry.clone() };
            columns.iter().map(|column| &column[axis]).chain([value]).map(side).collect()
        });
        let mut simplex = Self { columns: count, rows: rows.collect(), basis: (count..count + point.len()).collect() };
        let defect = |variable: usize| if variable < count { Q::zero() } else { -Q::one() };
        while matches!(simplex.improve(&defect), Outcome::Moved) {}
        simplex.drop_defects().then_some(simplex)
    }

    /// The value of each column's variable.
    pub(super) fn values(&self) -> Vec<Q> {
        let mut values = vec![Q::zero(); self.columns];
        for (variable, row) in self.basis.iter().zip(&self.rows) {
            values[*variable] = row[self.columns].clone();
        }
        values
    }

    /// A solution, not necessarily basic, in which one of the variables `group` is positive; `None` if there is none.
    pub(super) fn with_one_of(&mut self, group: &[usize]) -> Option<Vec<Q>> {
        let chosen = |variable: usize| if group.contains(&variable) { Q::one() } else { Q::zero() };
        loop {
            let values = self.values();
            if group.iter().any(|variable| values[*variable].is_positive()) {
                return Some(values);
            }
            match self.improve(&chosen) {
                Outcome::Moved => {}
                Outcome::Unbounded(column) => return Some(self.grown(column, values)),
                Outcome::Optimal => return None,
            }
        }
    }

    /// Bland's rule, which cannot cycle: the first variable that raises Σ weight z enters, and of those that bound it the
    /// first leaves.
    fn improve(&mut self, weight: &dyn Fn(usize) -> Q) -> Outcome {
        let gain = |column: usize| {
            let lost = self.basis.iter().zip(&self.rows).map(|(basic, row)| weight(*basic) * &row[column]);
            weight(column) - lost.sum::<Q>()
        };
        let Some(column) = (0..self.columns).find(|column| gain(*column).is_positive()) else {
            return Outcome::Optimal;
        };
        let bounding = (0..self.rows.len()).filter(|row| self.rows[*row][column].is_positive());
        let ratio = |row: &usize| &self.rows[*row][self.columns] / &self.rows[*row][column];
        let Some(row) = bounding.min_by_key(|row| (ratio(row), self.basis[*row])) else {
            return Outcome::Unbounded(column);
        };
        self.pivot(row, column);
        Outcome::Moved
    }

    fn pivot(&mut self, row: usize, column: usize) {
        let scale = self.rows[row][column].recip();
        self.rows[row].iter_mut().for_each(|value| *value *= &scale);
        let pivot_row = self.rows[row].clone();
        for other in self.rows.iter_mut().enumerate().filter(|(index, _)| *index != row).map(|(_, other)| other) {
            let factor = other[column].clone();
            if factor.is_zero() {
                continue;
            }
            for (value, by) in other.iter_mut().zip(&pivot_row).filter(|(_, by)| !by.is_zero()) {
                *value -= &factor * by;
            }
        }
        self.basis[row] = column;
    }

    /// Takes the defects out of the basis, with the equations that follow from others; `false` if one is not zero.
    fn drop_defects(&mut self) -> bool {
        let mut row = 0;
        while row < self.rows.len() {
            if self.basis[row] < self.columns {
                row += 1;
            } else if !self.rows[row][self.columns].is_zero() {
                return false;
            } else if let Some(column) = (0..self.columns).find(|column| !self.rows[row][*column].is_zero()) {
                self.pivot(row, column);
            } else {
                self.rows.swap_remove(row);
                self.basis.swap_remove(row);
            }
        }
        true
    }

    /// `values` after variable `column`, which nothing bounds, has grown by one.
    fn grown(&self, column: usize, mut values: Vec<Q>) -> Vec<Q> {
        values[column] += Q::one();
        for (variable, row) in self.basis.iter().zip(&self.rows) {
            values[*variable] -= &row[column];
        }
        values
    }
}
