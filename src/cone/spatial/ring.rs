//! Pointed cones of full dimension: facets and rays in cyclic order, clipped by one half-space after the other.

use super::{Shape, row};
use crate::exact::{Int, Matrix};
use smallvec::SmallVec;
use std::cmp::Ordering;

/// Facets and rays around an apex: ray `i` is a positive multiple of the cross product of facets `i` and `i + 1`.
pub(in crate::cone) struct Ring<T: Int> {
    pub(in crate::cone) facets: SmallVec<[usize; 8]>,
    pub(in crate::cone) rays: SmallVec<[[T::Minor; 3]; 8]>,
}

impl<T: Int> Ring<T> {
    /// The cone of all `normals`, started from three with a negative determinant; `Err` is a normal that vanishes on all
    /// that is left.
    pub(super) fn clipped(normals: &Matrix<T>, corners: [usize; 3]) -> Result<Shape<T>, usize> {
        let mut ring = Self::corner(normals, corners);
        let mut next = Self { facets: SmallVec::new(), rays: SmallVec::new() };
        for index in (0..normals.len()).filter(|index| !corners.contains(index)) {
            match ring.cut(normals, index, &mut next) {
                Side::Inside => {}
                Side::Across => std::mem::swap(&mut ring, &mut next),
                Side::Touching => return Err(index),
                Side::Outside => return Ok(Shape::Apex),
            }
        }
        Ok(Shape::Pointed(ring))
    }

    fn corner(normals: &Matrix<T>, corners: [usize; 3]) -> Self {
        let [a, b, c] = corners.map(|index| row(normals.row(index)));
        let rays = [T::minors(a, b), T::minors(b, c), T::minors(c, a)];
        Self { facets: SmallVec::from_slice(&corners), rays: rays.into_iter().collect() }
    }

    /// Writes what the half-space of normal `index` leaves to `out`, if it leaves less and the apex is not all.
    fn cut(&self, normals: &Matrix<T>, index: usize, out: &mut Self) -> Side {
        let normal = row(normals.row(index));
        let count = self.rays.len();
        let side = |ray: usize| T::side(normal, &self.rays[ray % count]);
        let mut previous = None;
        let Some(found) = (0..count).find(|ray| {
            let here = side(*ray);
            if here.is_le() {
                previous = Some(here);
            }
            here.is_gt()
        }) else {
            return Side::Inside;
        };
        // the rays outside follow one another: the first after them, and the last before them
        let later = |ray: usize| (ray, side(ray));
        let Some((end, after)) = (found + 1..found + count).map(later).find(|(_, side)| side.is_le()) else {
            return Side::Outside;
        };
        let (start, before) = match previous {
            Some(before) => (found + count, before),
            None => {
                let back = (end..count).rev().map(later).find(|(_, side)| side.is_le());
                back.map(|(ray, before)| (ray + 1, before)).expect("a ray is not outside")
            }
        };
        // those not outside are `end` to `last`, modulo the count
        let last = start - 1;
        if before.is_eq() && after.is_eq() && last <= end + 1 {
            return Side::Touching;
        }
        self.copy_between(normals, index, (end, after), (last, before), out);
        Side::Across
    }

    fn copy_between(
        &self,
        normals: &Matrix<T>,
        index: usize,
        (first, after): (usize, Ordering),
        (last, before): (usize, Ordering),
        out: &mut Self,
    ) {
        let count = self.rays.len();
        let normal = row(normals.row(index));
        out.facets.clear();
        out.rays.clear();
        out.facets.push(index);
        if after.is_lt() {
            // the facet between the last ray outside and this one is cut
            let facet = self.facets[first % count];
            out.rays.push(T::minors(normal, row(normals.row(facet))));
            out.facets.push(facet);
        }
        for ray in first..=last {
            out.rays.push(self.rays[ray % count].clone());
            if ray < last || before.is_lt() {
                out.facets.push(self.facets[(ray + 1) % count]);
            }
        }
        if before.is_lt() {
            let facet = self.facets[(last + 1) % count];
            out.rays.push(T::minors(row(normals.row(facet)), normal));
        }
    }
}

/// How a half-space meets a cone.
enum Side {
    /// It holds all of the cone.
    Inside,
    /// It cuts the cone.
    Across,
    /// It holds a facet or a ray only.
    Touching,
    /// It holds the apex only.
    Outside,
}
