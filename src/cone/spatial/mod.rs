//! Cones in three dimensions: face normals to generators by cross products alone.
//!
//! Every ray is the cross product of two of the given normals and every decision the sign of a determinant of three, so
//! numbers never grow on the way and nothing is divided before the end.

mod fan;
mod forms;
mod missing;
mod ring;

use super::describe::Faces;
use super::lattice::{flat_and_facets, incidence};
use crate::exact::{Int, Matrix, Overflow};
use fan::Fan;
pub(super) use missing::{Part, is_small, masks, maximal_missing};
use ring::Left;
pub(super) use ring::Ring;
use std::cmp::Ordering;

/// A vector or normal of three-dimensional space.
pub(super) type Row<T> = [T; 3];

/// A closed cone by the fewest vectors that determine it.
pub(super) enum Shape<T: Int> {
    /// The whole space.
    Space,
    /// `a · x ≤ 0`.
    HalfSpace(Row<T>),
    /// `a · x ≤ 0` and `b · x ≤ 0`; the line `axis` is on both planes.
    Wedge { axis: Row<T>, sides: [Row<T>; 2] },
    /// At least three facets around an apex: those of the ring.
    Pointed,
    /// A plane by its normal.
    Plane(Row<T>),
    /// `a · x ≤ 0` in the plane with normal `normal`.
    HalfPlane { normal: Row<T>, side: Row<T> },
    /// What two rays span, in the plane with normal `normal`.
    Angle { normal: Row<T>, rays: [Row<T>; 2] },
    /// A line.
    Line(Row<T>),
    /// A ray.
    Ray(Row<T>),
    /// The origin.
    Apex,
}

/// What some equalities leave of the space.
enum Span<T> {
    Space,
    Plane(Row<T>),
    Line(Row<T>),
    Apex,
}

impl<T: Int> Shape<T> {
    /// The cone `{x : equalities · x = 0, normals · x ≤ 0}`; `ring` takes its facets and rays if it is pointed and full.
    ///
    /// # Cost
    /// O(m k) determinants for m normals and k rays.
    ///
    /// # Errors
    /// [`Overflow`] if a primitive vector that determines the cone does not fit `T`.
    pub(super) fn of(equalities: &Matrix<T>, normals: &Matrix<T>, ring: &mut Ring<T>) -> Result<Self, Overflow> {
        let mut span = Span::Space;
        for equality in equalities.rows() {
            span = span.within(row(equality))?;
        }
        loop {
            match span.cut(normals, ring)? {
                Ok(shape) => return Ok(shape),
                Err(implied) => span = span.within(row(normals.row(implied)))?,
            }
        }
    }
}

impl<T: Int> Span<T> {
    /// The part of it on the plane with this normal.
    fn within(self, normal: &Row<T>) -> Result<Self, Overflow> {
        Ok(match self {
            Self::Space if is_zero(normal) => Self::Space,
            Self::Space => Self::Plane(normal.clone()),
            Self::Plane(own) => {
                let line = T::minors(&own, normal);
                if vanishes::<T>(&line) { Self::Plane(own) } else { Self::Line(T::on_ray(&line)?) }
            }
            Self::Line(line) if T::side_of(&line, normal).is_eq() => Self::Line(line),
            Self::Line(_) | Self::Apex => Self::Apex,
        })
    }

    /// Cuts it by all normals; `Err` is one that vanishes on all that is left but not on the span.
    fn cut(&self, normals: &Matrix<T>, ring: &mut Ring<T>) -> Result<Result<Shape<T>, usize>, Overflow> {
        match self {
            Self::Space => cut_space(normals, ring),
            Self::Plane(normal) => cut_plane(normal, normals),
            Self::Line(line) => Ok(Ok(cut_line(line, normals))),
            Self::Apex => Ok(Ok(Shape::Apex)),
        }
    }
}

fn cut_space<T: Int>(normals: &Matrix<T>, ring: &mut Ring<T>) -> Result<Result<Shape<T>, usize>, Overflow> {
    let at = |index: usize| row(normals.row(index));
    let Some(first) = (0..normals.len()).find(|index| !is_zero(at(*index))) else { return Ok(Ok(Shape::Space)) };
    let a = at(first);
    let mut second = None;
    for index in first + 1..normals.len() {
        let edge = T::minors(a, at(index));
        if !vanishes::<T>(&edge) {
            second = Some((index, edge));
            break;
        }
        if is_opposite(a, at(index)) {
            return Ok(Err(first));
        }
    }
    let Some((second, edge)) = second else { return Ok(Ok(Shape::HalfSpace(a.clone()))) };
    for third in second + 1..normals.len() {
        let corners = match T::side(at(third), &edge) {
            Ordering::Equal => continue,
            Ordering::Less => [first, second, third],
            Ordering::Greater => [second, first, third],
        };
        return Ok(ring.clip(normals, corners).map(|left| match left {
            Left::Cone => Shape::Pointed,
            Left::Apex => Shape::Apex,
        }));
    }
    let axis = T::on_ray(&edge)?;
    Ok(Fan::about(&axis, normals).map(|fan| {
        let Fan::Two(sides) = fan else { unreachable!("two normals that are not parallel are sides or imply one") };
        Shape::Wedge { sides: sides.map(|side| at(side).clone()), axis }
    }))
}

fn cut_plane<T: Int>(normal: &Row<T>, normals: &Matrix<T>) -> Result<Result<Shape<T>, usize>, Overflow> {
    let at = |index: usize| row(normals.row(index));
    Ok(Ok(match Fan::about(normal, normals) {
        Err(implied) => return Ok(Err(implied)),
        Ok(Fan::All) => Shape::Plane(normal.clone()),
        Ok(Fan::One(side)) => Shape::HalfPlane { normal: normal.clone(), side: at(side).clone() },
        Ok(Fan::Two([a, b])) => {
            let rays = [T::on_ray(&T::minors(at(a), normal))?, T::on_ray(&T::minors(normal, at(b)))?];
            Shape::Angle { normal: normal.clone(), rays }
        }
    }))
}

fn cut_line<T: Int>(line: &Row<T>, normals: &Matrix<T>) -> Shape<T> {
    let meets = |side: Ordering| normals.rows().any(|normal| T::side_of(row(normal), line) == side);
    match (meets(Ordering::Greater), meets(Ordering::Less)) {
        (true, true) => Shape::Apex,
        (true, false) => Shape::Ray(negated(line)),
        (false, true) => Shape::Ray(line.clone()),
        (false, false) => Shape::Line(line.clone()),
    }
}

/// Facets and rays of the pointed cone of normals of full rank, none of them zero.
///
/// # Errors
/// [`Overflow`] if a primitive ray does not fit `T`.
pub(super) fn faces<T: Int>(normals: &Matrix<T>) -> Result<Faces<T>, Overflow> {
    let mut ring = Ring::new();
    let shape = Shape::of(&Matrix::new(3), normals, &mut ring)?;
    if matches!(shape, Shape::Pointed) {
        return Ok(Faces { flat: Vec::new(), facets: ring.facets.to_vec(), rays: ring.primitive_rays()? });
    }
    let rays = shape.generators(normals, &ring)?.rays;
    let on = incidence(normals, &rays)?;
    let (flat, facets) = flat_and_facets(&on, rays.len());
    Ok(Faces { flat, facets, rays })
}

/// A row of a matrix with three columns.
pub(super) fn row<T>(row: &[T]) -> &Row<T> {
    row.first_chunk().expect("rows of three-dimensional space have three entries")
}

fn is_zero<T: Int>(row: &Row<T>) -> bool {
    row.iter().all(|entry| entry.sign().is_eq())
}

fn vanishes<T: Int>(minors: &[T::Minor; 3]) -> bool {
    minors.iter().all(|minor| T::minor_sign(minor).is_eq())
}

/// Whether one of two parallel rows is a negative multiple of the other.
fn is_opposite<T: Int>(a: &Row<T>, b: &Row<T>) -> bool {
    a.iter().zip(b).any(|(x, y)| x.sign().is_ne() && x.sign() == y.sign().reverse())
}

fn negated<T: Int>(row: &Row<T>) -> Row<T> {
    row.each_ref().map(T::negated)
}
