//! Pointed cones of full dimension: facets and rays in cyclic order, clipped by one half-space after the other.

use super::{Row, row};
use crate::exact::{Int, Matrix, Overflow};
use smallvec::SmallVec;
use std::cmp::Ordering;
use std::ops::Range;

/// Facets and rays around an apex: ray `i` is a positive multiple of the cross product of facets `i` and `i + 1`.
pub(in crate::cone) struct Ring<T: Int> {
    pub(in crate::cone) facets: SmallVec<[usize; 8]>,
    pub(in crate::cone) rays: SmallVec<[[T::Minor; 3]; 8]>,
}

/// What all half-spaces leave.
pub(super) enum Left {
    /// The cone that the ring holds.
    Cone,
    /// The apex.
    Apex,
}

impl<T: Int> Ring<T> {
    pub(in crate::cone) fn new() -> Self {
        Self { facets: SmallVec::new(), rays: SmallVec::new() }
    }

    /// The rays, primitive.
    ///
    /// # Errors
    /// [`Overflow`] if one does not fit `T`.
    pub(super) fn primitive_rays(&self) -> Result<Matrix<T>, Overflow> {
        let mut rays = Matrix::with_capacity(3, self.rays.len());
        for ray in &self.rays {
            rays.push(&T::on_ray(ray)?);
        }
        Ok(rays)
    }

    /// Becomes the cone of all `normals`, started from three with a negative determinant; `Err` is a normal that vanishes
    /// on all that is left.
    pub(super) fn clip(&mut self, normals: &Matrix<T>, corners: [usize; 3]) -> Result<Left, usize> {
        let [a, b, c] = corners.map(|index| row(normals.row(index)));
        self.facets.clear();
        self.facets.extend(corners);
        self.rays.clear();
        self.rays.extend([T::minors(a, b), T::minors(b, c), T::minors(c, a)]);
        for index in (0..normals.len()).filter(|index| !corners.contains(index)) {
            match self.run_outside(row(normals.row(index))) {
                Side::Inside => {}
                Side::Across(run) => self.cut_off(run, normals, index),
                Side::Touching => return Err(index),
                Side::Outside => return Ok(Left::Apex),
            }
        }
        Ok(Left::Cone)
    }

    /// Which rays the half-space of `normal` leaves outside.
    fn run_outside(&self, normal: &Row<T>) -> Side {
        let rays = self.rays.as_slice();
        let count = rays.len();
        let side = |ray: usize| T::side(normal, &rays[ray]);
        let Some(found) = (0..count).find(|ray| side(*ray).is_gt()) else { return Side::Inside };
        let next = |ray: usize| if ray + 1 == count { 0 } else { ray + 1 };
        let last = |ray: usize| if ray == 0 { count - 1 } else { ray - 1 };
        // the rays outside follow one another
        let (mut start, mut end) = (found, next(found));
        let after = loop {
            match side(end) {
                _ if end == found => return Side::Outside,
                Ordering::Greater => end = next(end),
                after => break after,
            }
        };
        let before = loop {
            match side(last(start)) {
                Ordering::Greater => start = last(start),
                before => break before,
            }
        };
        let left = last(start);
        if before.is_eq() && after.is_eq() && (left == end || left == next(end)) {
            return Side::Touching;
        }
        Side::Across(Run { start, end, is_first_cut: before.is_lt(), is_last_cut: after.is_lt() })
    }

    /// Puts facet `index` in the place of what lies outside.
    fn cut_off(&mut self, run: Run, normals: &Matrix<T>, index: usize) {
        let Run { mut start, mut end, .. } = run;
        if start == 0 || end <= start {
            // one ray before the run, so that nothing wraps around
            let before = if start == 0 { self.rays.len() - 1 } else { start - 1 };
            self.rays.rotate_left(before);
            self.facets.rotate_left(before);
            (start, end) = (1, (end + self.rays.len() - before - 1) % self.rays.len() + 1);
        }
        let at = |facet: usize| row(normals.row(facet));
        let first = self.facets[start];
        let last = self.facets[if end == self.facets.len() { 0 } else { end }];
        let first = run.is_first_cut.then(|| T::minors(at(first), at(index)));
        let last = run.is_last_cut.then(|| T::minors(at(index), at(last)));
        replace(&mut self.rays, start..end, first.into_iter().chain(last));
        let facets = start + usize::from(run.is_first_cut)..end + usize::from(!run.is_last_cut);
        replace(&mut self.facets, facets, [index]);
    }
}

/// How a half-space meets a cone.
enum Side {
    /// It holds all of the cone.
    Inside,
    /// It cuts the cone.
    Across(Run),
    /// It holds a facet or a ray only.
    Touching,
    /// It holds the apex only.
    Outside,
}

/// Rays outside of a half-space, from `start` to before `end`, around the cone.
struct Run {
    start: usize,
    end: usize,
    /// Whether the facet before ray `start` has points inside.
    is_first_cut: bool,
    /// Whether the facet before ray `end` has points inside.
    is_last_cut: bool,
}

fn replace<A: smallvec::Array>(list: &mut SmallVec<A>, range: Range<usize>, by: impl IntoIterator<Item = A::Item>) {
    let Range { mut start, end } = range;
    for item in by {
        if start < end {
            list[start] = item;
        } else {
            list.insert(start, item);
        }
        start += 1;
    }
    if start < end {
        list.drain(start..end);
    }
}
