//! Few extreme rays behind many normals: the primal-dual method.

use super::cut::cut_within;
use super::describe::{Simplex, Stop};
use super::linear::{dot_sign, is_zero};
use super::walk::Walk;
use crate::exact::{Entries, Int, Matrix, Overflow};
use std::collections::HashMap;

/// A search for the extreme rays of a pointed cone by the facets of those found so far.
///
/// A facet of the rays found is a facet of the cone, or some extreme ray lies beyond it, which a linear program finds. There
/// are no more programs than extreme rays and dimensions. Where double description meets far more rays on its way than
/// there are at the end, this meets only the facets of some of them.
///
/// # Source
/// Bremner, Fukuda & Marzetta (1998), Primal-dual methods for vertex and facet enumeration.
pub(super) struct PrimalDual<'a, T> {
    normals: &'a Matrix<T>,
    /// Which normal a primitive row is.
    known: HashMap<Entries<T>, usize>,
    walk: Option<Walk<'a, T>>,
    rays: Matrix<T>,
}

impl<'a, T: Int> PrimalDual<'a, T> {
    /// For the cone of `normals`, distinct and none of them zero; `start` is that of some of them.
    ///
    /// # Errors
    /// [`Overflow`] if a primitive row does not fit `T`.
    pub(super) fn new(normals: &'a Matrix<T>, start: &Simplex<T>) -> Result<Self, Overflow> {
        let primitive = |row: &[T]| {
            let mut row: Entries<T> = row.iter().cloned().collect();
            T::make_primitive(&mut row);
            row
        };
        let known = normals.rows().enumerate().map(|(index, row)| (primitive(row), index)).collect();
        let walk = Walk::new(normals, start)?;
        let mut rays = Matrix::new(normals.columns());
        walk.iter().for_each(|walk| rays.push(walk.ray()));
        Ok(Self { normals, known, walk, rays })
    }

    /// Indices of the facets and the extreme rays, if `allowed` is effort enough and there are no more rays than normals.
    ///
    /// # Errors
    /// [`Stop::Flat`] if the cone does not have full dimension, [`Stop::Overflow`] if a primitive row does not fit `T`.
    pub(super) fn run(&mut self, mut allowed: u64) -> Result<Option<(Vec<usize>, Matrix<T>)>, Stop> {
        let Some(walk) = &mut self.walk else { return Err(Stop::Flat(0)) };
        while self.rays.len() <= self.normals.len() {
            let polar = match cut_within(&self.rays, &mut allowed) {
                Err(Stop::Effort) => return Ok(None),
                polar => polar?,
            };
            let is_flat = !polar.lines.is_empty();
            let mut objectives = polar.lines;
            for index in 0..objectives.len() {
                let opposite: Entries<T> = objectives.row(index).iter().map(T::negated).collect();
                objectives.push(&opposite);
            }
            if !is_flat {
                objectives = polar.rays;
            }
            let n_before = self.rays.len();
            for objective in objectives.rows() {
                if self.known.contains_key(objective) || is_beyond(&self.rays, n_before, objective)? {
                    continue;
                }
                let Some(left) = allowed.checked_sub(walk.cost()) else { return Ok(None) };
                allowed = left;
                if walk.rise(objective)? {
                    self.rays.push(walk.ray());
                }
            }
            if self.rays.len() == n_before {
                return if is_flat { Err(Stop::Flat(self.implied()?)) } else { self.answer(&objectives).map(Some) };
            }
        }
        Ok(None)
    }

    fn answer(&self, facets: &Matrix<T>) -> Result<(Vec<usize>, Matrix<T>), Stop> {
        let facets = facets.rows().map(|facet| self.known.get(facet).copied());
        let facets = facets.collect::<Option<Vec<_>>>().expect("a facet has the direction of one of the normals");
        Ok((facets, self.rays.clone()))
    }

    /// A normal that all rays lie on, which span the cone but not the space.
    fn implied(&self) -> Result<usize, Overflow> {
        for (row, normal) in self.normals.rows().enumerate() {
            let mut is_implied = true;
            for ray in self.rays.rows() {
                is_implied = is_implied && dot_sign(normal, ray)?.is_eq();
            }
            if is_implied && !is_zero(normal) {
                return Ok(row);
            }
        }
        unreachable!("a cone that is flat lies in the hyperplane of one of its normals")
    }
}

/// Whether one of the rays from `first` on is beyond a hyperplane.
fn is_beyond<T: Int>(rays: &Matrix<T>, first: usize, normal: &[T]) -> Result<bool, Overflow> {
    for ray in first..rays.len() {
        if dot_sign(normal, rays.row(ray))?.is_gt() {
            return Ok(true);
        }
    }
    Ok(false)
}
