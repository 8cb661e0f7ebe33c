//! Points as non-negative combinations of columns, by the simplex method without fractions.

use crate::exact::{Q, Z, primitive_row};
use num_traits::{One as _, Signed as _, Zero as _};

/// A basic solution `z ≥ 0` of `Σ z_k column_k = point`, ready to be moved to others.
///
/// A basic variable has the value of its row's last entry over `scale`, which is positive. All divisions are exact
/// (Bareiss).
pub(super) struct Simplex {
    columns: usize,
    /// Basic rows: an entry for each column, then the right side.
    rows: Vec<Vec<Z>>,
    /// The basic variable of each row; from `columns` on, the defects that the first phase drives to zero.
    basis: Vec<usize>,
    scale: Z,
}

/// What the sum of some variables is to do.
#[derive(Clone, Copy)]
enum Aim<'a> {
    /// The sum of the defects is to fall.
    NoDefects,
    /// The sum of these variables is to grow.
    More(&'a [usize]),
}

/// What a pivot towards the aim met.
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
            let row: Vec<Q> = columns.iter().map(|column| &column[axis]).chain([value]).map(side).collect();
            primitive_row(&row)
        });
        let basis = (count..count + point.len()).collect();
        let mut simplex = Self { columns: count, rows: rows.collect(), basis, scale: Z::one() };
        while matches!(simplex.improve(Aim::NoDefects), Outcome::Moved) {}
        simplex.drop_defects().then_some(simplex)
    }

    /// The value of each column's variable.
    pub(super) fn values(&self) -> Vec<Q> {
        let mut values = vec![Q::zero(); self.columns];
        for (variable, row) in self.basis.iter().zip(&self.rows) {
            values[*variable] = Q::new(row[self.columns].clone(), self.scale.clone());
        }
        values
    }

    /// A solution, not necessarily basic, in which one of the variables `group` is positive; `None` if there is none.
    pub(super) fn with_one_of(&mut self, group: &[usize]) -> Option<Vec<Q>> {
        loop {
            let mut basic = self.basis.iter().zip(&self.rows);
            if basic.any(|(variable, row)| group.contains(variable) && row[self.columns].is_positive()) {
                return Some(self.values());
            }
            match self.improve(Aim::More(group)) {
                Outcome::Moved => {}
                Outcome::Unbounded(column) => return Some(self.grown(column)),
                Outcome::Optimal => return None,
            }
        }
    }

    /// Bland's rule, which cannot cycle: the first variable that helps enters, and of those that bound it the first leaves.
    fn improve(&mut self, aim: Aim) -> Outcome {
        let Some(column) = (0..self.columns).find(|column| self.helps(aim, *column)) else {
            return Outcome::Optimal;
        };
        let right = self.columns;
        let bounding = (0..self.rows.len()).filter(|row| self.rows[*row][column].is_positive());
        let first = bounding.min_by(|a, b| {
            let [ours, theirs] = [&self.rows[*a], &self.rows[*b]];
            let bounds = (&ours[right] * &theirs[column]).cmp(&(&theirs[right] * &ours[column]));
            bounds.then(self.basis[*a].cmp(&self.basis[*b]))
        });
        let Some(row) = first else { return Outcome::Unbounded(column) };
        self.pivot(row, column);
        Outcome::Moved
    }

    /// Whether the aim gains by a larger variable `column`.
    fn helps(&self, aim: Aim, column: usize) -> bool {
        let lost = |counts: &dyn Fn(usize) -> bool| -> Z {
            let rows = self.basis.iter().zip(&self.rows).filter(|(variable, _)| counts(**variable));
            rows.map(|(_, row)| &row[column]).sum()
        };
        match aim {
            Aim::NoDefects => lost(&|variable| variable >= self.columns).is_positive(),
            Aim::More(group) if group.contains(&column) => lost(&|variable| group.contains(&variable)) < self.scale,
            Aim::More(group) => lost(&|variable| group.contains(&variable)).is_negative(),
        }
    }

    /// Brings `column` into the basis at `row`, where its entry is positive.
    fn pivot(&mut self, row: usize, column: usize) {
        let pivot_row = self.rows[row].clone();
        let pivot = &pivot_row[column];
        for other in self.rows.iter_mut().enumerate().filter(|(index, _)| *index != row).map(|(_, other)| other) {
            let factor = other[column].clone();
            for (value, by) in other.iter_mut().zip(&pivot_row) {
                *value = (&*value * pivot - &factor * by) / &self.scale;
            }
        }
        self.scale = pivot.clone();
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
                if self.rows[row][column].is_negative() {
                    self.rows[row].iter_mut().for_each(|value| *value = -&*value); // its right side is zero
                }
                self.pivot(row, column);
            } else {
                self.rows.swap_remove(row);
                self.basis.swap_remove(row);
            }
        }
        true
    }

    /// The values after variable `column`, which is zero and which nothing bounds, has grown by one.
    fn grown(&self, column: usize) -> Vec<Q> {
        let mut values = self.values();
        values[column] += Q::one();
        for (variable, row) in self.basis.iter().zip(&self.rows) {
            values[*variable] -= Q::new(row[column].clone(), self.scale.clone());
        }
        values
    }
}
