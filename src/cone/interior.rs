//! A point inside of a cone, by an exact linear program.

use super::cut::{Start, absorb_lines};
use super::linear::dot_sign;
use crate::exact::{Entries, Int, Matrix, Overflow};

/// Some `x` with `H x < 0` for normals of full rank; `None` if there is none.
///
/// One inequality `h · x + s ≤ 0` after the other is entered at `s = 1` by pivots to neighboring vertices. They follow
/// Bland's rule, so that they end.
///
/// # Errors
/// [`Overflow`] if a primitive row does not fit `T`.
pub(super) fn interior_point<T: Int>(normals: &Matrix<T>) -> Result<Option<Entries<T>>, Overflow> {
    let dim = normals.columns();
    let mut lifted = Matrix::with_capacity(dim + 1, normals.len());
    for normal in normals.rows() {
        lifted.push_from(normal.iter().cloned().chain([T::unit()]));
    }
    let start = absorb_lines(&lifted)?;
    let mut point: Entries<T> = if start.lines.pivots.is_empty() {
        let Some(mut vertex) = Vertex::new(&lifted, start)? else { return Ok(None) };
        if !vertex.enter_all()? {
            return Ok(None);
        }
        vertex.point
    } else {
        // the normals have full rank, so that they all lie in a plane off the origin
        let line = start.lines.rows.row(0);
        let is_up = line[dim].sign().is_gt();
        line.iter().map(|entry| if is_up { entry.clone() } else { entry.negated() }).collect()
    };
    point.truncate(dim);
    T::make_primitive(&mut point);
    Ok(Some(point))
}

/// A vertex of the polyhedron of some rows `h · x + s ≤ 0` in the plane `s = 1`; vectors are known up to positive factors.
struct Vertex<'a, T> {
    rows: &'a Matrix<T>,
    /// Independent rows that are tight at the vertex.
    basis: Vec<usize>,
    /// Row `k` is a direction in the plane and along all of the basis but its `k`-th row, which grows along it.
    directions: Matrix<T>,
    point: Entries<T>,
}

impl<'a, T: Int> Vertex<'a, T> {
    fn new(rows: &'a Matrix<T>, start: Start<T>) -> Result<Option<Self>, Overflow> {
        let plane = rows.columns() - 1;
        let Some(first) = start.rays.rows().position(|ray| ray[plane].sign().is_gt()) else { return Ok(None) };
        let top = start.rays.row(first);
        let (height, mut directions) = (top[plane].negated().widen(), Matrix::new(rows.columns()));
        for other in (0..start.rays.len()).filter(|ray| *ray != first) {
            let ray = start.rays.row(other);
            directions.push_with(|out| T::combine(&height, ray, &ray[plane].widen(), top, out))?;
        }
        let mut basis = start.basis;
        basis.remove(first);
        Ok(Some(Self { rows, basis, directions, point: top.iter().cloned().collect() }))
    }

    /// `false` if there is no way into one of the rows.
    fn enter_all(&mut self) -> Result<bool, Overflow> {
        for row in 0..self.rows.len() {
            while dot_sign(self.rows.row(row), &self.point)?.is_gt() {
                let Some(slot) = self.leaving(row)? else { return Ok(false) };
                self.pivot(slot, row)?;
            }
        }
        Ok(true)
    }

    /// The place in the basis of its first row that can be left to come nearer to `entered`.
    fn leaving(&self, entered: usize) -> Result<Option<usize>, Overflow> {
        let mut first: Option<usize> = None;
        for slot in 0..self.basis.len() {
            let is_first = first.is_none_or(|first| self.basis[slot] < self.basis[first]);
            if is_first && dot_sign(self.rows.row(entered), self.directions.row(slot))?.is_gt() {
                first = Some(slot);
            }
        }
        Ok(first)
    }

    /// Moves against direction `slot` until one of the rows before `entered` blocks it or `entered` is met.
    fn pivot(&mut self, slot: usize, entered: usize) -> Result<(), Overflow> {
        let mut met = (entered, self.on_plane(entered, slot, &self.point)?);
        for row in 0..entered {
            if dot_sign(self.rows.row(row), &met.1)?.is_gt() {
                met = (row, self.on_plane(row, slot, &self.point)?);
            }
        }
        let (row, point) = met;
        let mut directions = Matrix::with_capacity(self.directions.columns(), self.directions.len());
        for other in 0..self.basis.len() {
            let direction = self.directions.row(other);
            if other != slot {
                directions.push(&self.on_plane(row, slot, direction)?);
            } else if dot_sign(self.rows.row(row), direction)?.is_gt() {
                directions.push(direction);
            } else {
                directions.push_negated(direction);
            }
        }
        (self.point, self.directions) = (point, directions);
        self.basis[slot] = row;
        Ok(())
    }

    /// A positive multiple of `x` moved along direction `slot` onto the plane of a row that changes along it.
    fn on_plane(&self, row: usize, slot: usize, x: &[T]) -> Result<Entries<T>, Overflow> {
        let (row, direction) = (self.rows.row(row), self.directions.row(slot));
        let (mut slope, mut height) = (T::dot(row, direction)?, T::dot(row, x)?);
        if T::wide_sign(&slope).is_lt() {
            slope = T::wide_negated(&slope);
        } else {
            height = T::wide_negated(&height);
        }
        let mut out = Entries::new();
        T::combine(&slope, x, &height, direction, &mut out)?;
        Ok(out)
    }
}
