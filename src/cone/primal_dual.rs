//! Few extreme rays behind many normals: the primal-dual method.

use super::cut::{absorb, cut_within, flatten};
use super::describe::{Faces, Stop};
use super::interior::interior_point;
use super::linear::{dot_sign, negate, positive_combination};
use crate::exact::{Entries, Int, Matrix, Overflow};
use std::cmp::Ordering;
use std::collections::HashMap;

/// How many times more normals than rays there are where this is worth its effort.
const FEWER: usize = 4;

/// A search for the extreme rays of a pointed cone of full dimension by the facets of those found so far.
///
/// A facet of the rays found has one of the normals, or the points amid it are inside of the cone: then shots from there,
/// each along the face that stopped the last, end at an extreme ray beyond it. Where double description
/// meets far more rays on its way than there are at the end, this meets only the facets of some of them.
///
/// # Source
/// Bremner, Fukuda & Marzetta (1998), Primal-dual methods for vertex and facet enumeration.
pub(super) struct PrimalDual<'a, T> {
    normals: &'a Matrix<T>,
    /// Which normal a primitive row is.
    known: HashMap<Entries<T>, usize>,
    inside: Entries<T>,
    /// A basis of the directions along which the sum of the normals is constant.
    level: Matrix<T>,
    rays: Matrix<T>,
}

impl<'a, T: Int> PrimalDual<'a, T> {
    /// For the cone of `normals`, distinct and none of them zero; `None` if it has no inside.
    ///
    /// # Errors
    /// [`Overflow`] if a primitive row does not fit `T`.
    pub(super) fn new(normals: &'a Matrix<T>) -> Result<Option<Self>, Overflow> {
        let Some(inside) = interior_point(normals)? else { return Ok(None) };
        let mut level = Matrix::identity(normals.columns());
        absorb(&mut level, &positive_combination(normals.columns(), normals.rows())?, &mut Entries::new())?;
        let primitive = |row: &[T]| {
            let mut row: Entries<T> = row.iter().cloned().collect();
            T::make_primitive(&mut row);
            row
        };
        let known = normals.rows().enumerate().map(|(index, row)| (primitive(row), index)).collect();
        let rays = Matrix::new(normals.columns());
        Ok(Some(Self { normals, known, inside, level, rays }))
    }

    /// The facets and extreme rays, if `allowed` is effort enough and the rays are few.
    ///
    /// # Errors
    /// [`Stop::Overflow`] if a primitive row does not fit `T`.
    pub(super) fn run(&mut self, mut allowed: u64) -> Result<Option<Faces<T>>, Stop> {
        let cost = (self.normals.len() * self.level.len()) as u64;
        while FEWER * self.rays.len() <= self.normals.len() {
            let polar = match cut_within(&self.rays, &mut allowed) {
                Err(Stop::Effort) => return Ok(None),
                polar => polar?,
            };
            let is_flat = !polar.lines.is_empty();
            let mut objectives = if is_flat { polar.lines } else { polar.rays };
            for line in (0..objectives.len()).filter(|_| is_flat) {
                if dot_sign(objectives.row(line), &self.inside)?.is_lt() {
                    negate(objectives.row_mut(line));
                }
            }
            let n_before = self.rays.len();
            for objective in objectives.rows() {
                let is_facet = !is_flat && self.known.contains_key(objective);
                if is_facet || self.is_passed(objective, n_before)? {
                    continue;
                }
                let Some(left) = allowed.checked_sub(cost) else { return Ok(None) };
                allowed = left;
                let origin = if is_flat { self.inside.clone() } else { self.amid(objective, n_before)? };
                let ray = self.ray_beyond(objective, origin)?;
                self.rays.push(&ray);
            }
            if self.rays.len() == n_before {
                let facets = objectives.rows().map(|facet| self.known[facet]).collect();
                return Ok(Some(Faces { flat: Vec::new(), facets, rays: self.rays.clone() }));
            }
        }
        Ok(None)
    }

    /// Whether a ray found after the first `n_rays` is off the hyperplane of `normal` on its positive side.
    fn is_passed(&self, normal: &[T], n_rays: usize) -> Result<bool, Overflow> {
        for ray in n_rays..self.rays.len() {
            if dot_sign(normal, self.rays.row(ray))?.is_gt() {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// A point inside of the facet `normal` of the first `n_rays` rays.
    fn amid(&self, normal: &[T], n_rays: usize) -> Result<Entries<T>, Overflow> {
        let mut on_facet = Vec::new();
        for ray in (0..n_rays).map(|ray| self.rays.row(ray)) {
            if dot_sign(normal, ray)?.is_eq() {
                on_facet.push(ray);
            }
        }
        positive_combination(normal.len(), on_facet)
    }

    /// The extreme ray that shots from a point inside of the cone end at, `objective` growing on the first and falling on
    /// none.
    fn ray_beyond(&self, objective: &[T], mut point: Entries<T>) -> Result<Entries<T>, Overflow> {
        let mut directions = self.level.clone();
        let mut scratch = Entries::new();
        while !directions.is_empty() {
            let (mut chosen, mut growth) = (directions.len(), Ordering::Equal);
            while growth.is_eq() && chosen > 0 {
                chosen -= 1;
                growth = dot_sign(objective, directions.row(chosen))?;
            }
            let mut shot = directions.swap_remove(chosen);
            if growth.is_lt() {
                negate(&mut shot);
            }
            let (normal, met) = self.first_met(&shot, &point)?;
            point = met;
            negate(&mut shot);
            flatten(&mut directions, &shot, normal, &mut scratch)?;
        }
        Ok(point)
    }

    /// The first normal that stops a shot, and where.
    fn first_met(&self, shot: &[T], origin: &[T]) -> Result<(&'a [T], Entries<T>), Overflow> {
        let mut first: Option<(&[T], Entries<T>)> = None;
        for normal in self.normals.rows() {
            let is_nearer = match &first {
                Some((_, met)) => dot_sign(normal, met)?.is_gt(),
                None => dot_sign(normal, shot)?.is_gt(),
            };
            if is_nearer {
                let mut met = Entries::new();
                let height = T::wide_negated(&T::dot(normal, origin)?);
                T::combine(&T::dot(normal, shot)?, origin, &height, shot, &mut met)?;
                first = Some((normal, met));
            }
        }
        Ok(first.expect("no direction of the bounded section stays in the cone"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cone::Pair;
    use proptest::collection::vec;
    use proptest::prelude::*;
    use std::collections::BTreeSet;

    fn drawn(dim: usize, n_rows: usize) -> impl Strategy<Value = Matrix<i128>> {
        vec(vec(-4..=4_i128, dim), n_rows).prop_map(move |rows| Matrix::from_rows(dim, rows))
    }

    fn set(rows: &Matrix<i128>) -> BTreeSet<Vec<i128>> {
        rows.rows().map(<[i128]>::to_vec).collect()
    }

    /// Normals of a cone with few rays: its facets and sums of two of them, which are redundant.
    fn few_rays() -> impl Strategy<Value = (Pair<i128>, Matrix<i128>)> {
        let cone = (4..=6_usize).prop_flat_map(|dim| drawn(dim, dim + 2)).prop_filter_map("full and pointed", |rays| {
            let pair = Pair::from_rays(rays).expect("small entries");
            (pair.lines().is_empty() && pair.equalities().is_empty()).then_some(pair)
        });
        (cone, vec((any::<prop::sample::Index>(), any::<prop::sample::Index>()), 60)).prop_map(|(pair, picked)| {
            let mut normals = set(pair.facets());
            for (one, other) in picked {
                let [one, other] = [one, other].map(|index| pair.facets().row(index.index(pair.facets().len())));
                let mut sum: Vec<i128> = one.iter().zip(other).map(|(x, y)| x + y).collect();
                i128::make_primitive(&mut sum);
                normals.insert(sum);
            }
            let normals = Matrix::from_rows(pair.ambient(), normals);
            (pair, normals)
        })
    }

    proptest! {
        #[test]
        fn the_rays_that_generate_a_cone_are_found((pair, normals) in few_rays()) {
            let mut search = PrimalDual::new(&normals).unwrap().expect("a full cone has an inside");
            let Ok(found) = search.run(u64::MAX) else { panic!("effort is not limited") };
            let is_few = |rays: usize| FEWER * rays <= normals.len();
            match found {
                Some(Faces { flat, facets, rays }) => {
                    prop_assert!(flat.is_empty());
                    prop_assert_eq!(set(&rays), set(pair.rays()));
                    let facets = Matrix::from_rows(pair.ambient(), facets.into_iter().map(|row| normals.row(row)));
                    prop_assert_eq!(set(&facets), set(pair.facets()));
                }
                None => prop_assert!(!is_few(pair.rays().len())),
            }
        }

        #[test]
        fn effort_that_is_not_enough_ends_it((pair, normals) in few_rays(), allowed in 0..400_u64) {
            let mut search = PrimalDual::new(&normals).unwrap().expect("a full cone has an inside");
            let Ok(found) = search.run(allowed) else { panic!("numbers are small") };
            if let Some(found) = found {
                prop_assert_eq!(set(&found.rays), set(pair.rays()));
            }
        }

        #[test]
        fn there_is_a_point_inside_iff_the_cone_has_full_dimension(normals in (2..=5_usize).prop_flat_map(|dim| drawn(dim, 2 * dim))) {
            let pair = Pair::from_normals(&Matrix::new(normals.columns()), &normals).unwrap();
            prop_assume!(pair.lines().is_empty() && normals.rows().all(|row| row.iter().any(|entry| *entry != 0)));
            let point = interior_point(&normals).unwrap();
            prop_assert_eq!(point.is_some(), pair.equalities().is_empty());
            if let Some(point) = point {
                for normal in normals.rows() {
                    prop_assert!(dot_sign(normal, &point).unwrap().is_lt());
                }
            }
        }
    }
}
