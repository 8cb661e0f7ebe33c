//! Exact linear programs over a cone: from one extreme ray to a better one.

use super::describe::Simplex;
use super::linear::{dot_sign, positive_combination};
use crate::exact::{Entries, Int, Matrix, Overflow};

/// A pointed cone `{x : H x ≤ 0}` at one of its extreme rays, from which the simplex method leads to others.
///
/// The ray is a vertex of the bounded section `h · x = 1`, with `h` the negative sum of all normals. Vectors are known up to
/// positive factors. Pivots follow Bland's rule, so that they end.
pub(super) struct Walk<'a, T> {
    normals: &'a Matrix<T>,
    /// Independent normals that are tight on the ray, and together on it alone.
    basis: Vec<usize>,
    /// Row `k` is a direction along `h` and all of the basis but its `k`-th normal, which grows along it.
    directions: Matrix<T>,
    ray: Entries<T>,
}

impl<'a, T: Int> Walk<'a, T> {
    /// The cone at some extreme ray, `start` being that of some of its normals; `None` if it is the origin alone.
    ///
    /// # Errors
    /// [`Overflow`] if a primitive row does not fit `T`.
    pub(super) fn new(normals: &'a Matrix<T>, start: &Simplex<T>) -> Result<Option<Self>, Overflow> {
        let Simplex { rays, basis } = start;
        let sum = positive_combination(normals.columns(), normals.rows())?;
        let heights = rays.rows().map(|ray| T::dot(&sum, ray)).collect::<Result<Vec<_>, _>>()?;
        let Some(first) = heights.iter().position(|height| T::wide_sign(height).is_lt()) else { return Ok(None) };
        let mut directions = Matrix::with_capacity(normals.columns(), rays.len());
        for other in (0..rays.len()).filter(|ray| *ray != first) {
            let turned = T::wide_negated(&heights[other]);
            directions.push_with(|out| T::combine(&heights[first], rays.row(other), &turned, rays.row(first), out))?;
        }
        let mut basis = basis.clone();
        basis.remove(first);
        let ray = rays.row(first).iter().cloned().collect();
        let mut walk = Self { normals, basis, directions, ray };
        Ok(walk.enter()?.then_some(walk))
    }

    /// The ray.
    pub(super) fn ray(&self) -> &[T] {
        &self.ray
    }

    /// About the effort of a linear program, in pairs of rays looked at.
    pub(super) fn cost(&self) -> u64 {
        (self.normals.len() * self.basis.len()) as u64
    }

    /// Moves to an extreme ray with `objective · x > 0`; `false` if there is none.
    pub(super) fn rise(&mut self, objective: &[T]) -> Result<bool, Overflow> {
        while dot_sign(objective, &self.ray)?.is_le() {
            if !self.pivot(objective, self.normals.len(), None)? {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Moves into the half-space of one normal after the other; `false` if there is no way.
    fn enter(&mut self) -> Result<bool, Overflow> {
        for row in 0..self.normals.len() {
            let inward: Entries<T> = self.normals.row(row).iter().map(T::negated).collect();
            while dot_sign(&inward, &self.ray)?.is_lt() {
                if !self.pivot(&inward, row, Some(row))? {
                    return Ok(false);
                }
            }
        }
        Ok(true)
    }

    /// Moves along an edge on which `objective` grows until one of the first `n_rows` normals blocks it, or `entered`, which
    /// the ray violates, is met; `false` if there is no such edge.
    fn pivot(&mut self, objective: &[T], n_rows: usize, entered: Option<usize>) -> Result<bool, Overflow> {
        let mut leaving: Option<usize> = None;
        for slot in 0..self.basis.len() {
            let is_first = leaving.is_none_or(|best| self.basis[slot] < self.basis[best]);
            if is_first && dot_sign(objective, self.directions.row(slot))?.is_lt() {
                leaving = Some(slot);
            }
        }
        let Some(slot) = leaving else { return Ok(false) };
        let mut met: Option<(usize, Entries<T>)> = match entered {
            Some(row) => Some((row, self.on_plane(row, slot, &self.ray)?)),
            None => None,
        };
        for row in 0..n_rows {
            let is_nearer = match &met {
                Some((_, ray)) => dot_sign(self.normals.row(row), ray)?.is_gt(),
                None => dot_sign(self.normals.row(row), self.directions.row(slot))?.is_lt(),
            };
            if is_nearer {
                met = Some((row, self.on_plane(row, slot, &self.ray)?));
            }
        }
        let (row, ray) = met.expect("the section is bounded");
        let mut directions = Matrix::with_capacity(self.directions.columns(), self.directions.len());
        for other in 0..self.basis.len() {
            let direction = self.directions.row(other);
            if other != slot {
                directions.push(&self.on_plane(row, slot, direction)?);
            } else if dot_sign(self.normals.row(row), direction)?.is_gt() {
                directions.push(direction);
            } else {
                directions.push_negated(direction);
            }
        }
        (self.ray, self.directions) = (ray, directions);
        self.basis[slot] = row;
        Ok(true)
    }

    /// A positive multiple of `x` moved along direction `slot` onto the plane of a normal that changes along it.
    fn on_plane(&self, row: usize, slot: usize, x: &[T]) -> Result<Entries<T>, Overflow> {
        let (normal, direction) = (self.normals.row(row), self.directions.row(slot));
        let (mut slope, mut height) = (T::dot(normal, direction)?, T::dot(normal, x)?);
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
