//! Both canonical forms of a cone in three dimensions.

use super::{Ring, Row, Shape, is_zero, negated, row};
use crate::cone::pair::{Generators, Pair};
use crate::exact::{Int, Matrix, Overflow};
use smallvec::SmallVec;
use std::cmp::Ordering;

impl<T: Int> Shape<T> {
    /// Both forms; `normals` and `ring` are those that the shape was cut by and on.
    ///
    /// # Errors
    /// [`Overflow`] if a primitive row does not fit `T`.
    pub(in crate::cone) fn pair(self, normals: &Matrix<T>, ring: &Ring<T>) -> Result<Pair<T>, Overflow> {
        Ok(match self {
            Self::Space => space(),
            Self::HalfSpace(normal) => half_space(normal),
            Self::Wedge { axis, sides } => wedge(axis, sides)?,
            Self::Pointed => pointed(ring, normals)?,
            Self::HalfPlane { normal, side } => half_plane(normal, &side)?,
            Self::Line(line) => along(line),
            // the polars of some of the others
            Self::Plane(normal) => along(normal).into_polar(),
            Self::Angle { normal, rays } => wedge(normal, rays)?.into_polar(),
            Self::Ray(ray) => half_space(ray).into_polar(),
            Self::Apex => space().into_polar(),
        })
    }

    /// Lines and rays that span the cone, primitive but not canonical; arguments as for [`Shape::pair`].
    ///
    /// # Errors
    /// [`Overflow`] if a primitive row does not fit `T`.
    pub(in crate::cone) fn generators(self, normals: &Matrix<T>, ring: &Ring<T>) -> Result<Generators<T>, Overflow> {
        let (lines, rays) = (Matrix::new(3), Matrix::new(3));
        Ok(match self {
            Self::Pointed => Generators { lines, rays: ring.primitive_rays()? },
            Self::Angle { rays, .. } => Generators { lines, rays: Matrix::from_rows(3, rays) },
            Self::Line(line) => Generators { lines: Matrix::from_rows(3, [line]), rays },
            Self::Ray(ray) => Generators { lines, rays: Matrix::from_rows(3, [ray]) },
            Self::Apex => Generators { lines, rays },
            other => other.pair(normals, ring)?.into_generators(),
        })
    }
}

fn space<T: Int>() -> Pair<T> {
    Pair::of_parts(Matrix::new(3), Matrix::new(3), Matrix::identity(3), Matrix::new(3))
}

fn along<T: Int>(line: Row<T>) -> Pair<T> {
    let line = oriented(line);
    let across = plane(&line);
    Pair::of_parts(across, Matrix::new(3), rows([line]), Matrix::new(3))
}

fn half_space<T: Int>(normal: Row<T>) -> Pair<T> {
    let normal = T::shortest(normal);
    // zero in the pivots of the plane
    let last = normal.iter().rposition(|entry| entry.sign().is_ne()).expect("a normal is not zero");
    let mut ray: Row<T> = unit(last);
    if normal[last].sign().is_gt() {
        ray[last] = ray[last].negated();
    }
    let lines = plane(&normal);
    Pair::of_parts(Matrix::new(3), rows([normal]), lines, rows([ray]))
}

fn wedge<T: Int>(axis: Row<T>, sides: [Row<T>; 2]) -> Result<Pair<T>, Overflow> {
    let axis = oriented(axis);
    let pivot = unit(first(&axis));
    let mut sides = sides.map(T::shortest);
    sides.sort_unstable();
    let [a, b] = &sides;
    let mut rays = [on_side(a, &pivot, b)?, on_side(b, &pivot, a)?];
    rays.sort_unstable();
    Ok(Pair::of_parts(Matrix::new(3), rows(sides), rows([axis]), rows(rays)))
}

fn half_plane<T: Int>(normal: Row<T>, side: &Row<T>) -> Result<Pair<T>, Overflow> {
    let normal = oriented(normal);
    let line = oriented(T::on_ray(&T::minors(&normal, side))?);
    let ray = on_side(&normal, &unit(first(&line)), side)?;
    let facet = on_side(&line, &unit(first(&normal)), &ray)?;
    Ok(Pair::of_parts(rows([normal]), rows([facet]), rows([line]), rows([ray])))
}

fn pointed<T: Int>(ring: &Ring<T>, normals: &Matrix<T>) -> Result<Pair<T>, Overflow> {
    let facet = |index: &usize| T::shortest(row(normals.row(*index)).clone());
    let mut facets: SmallVec<[Row<T>; 8]> = ring.facets.iter().map(facet).collect();
    facets.sort_unstable();
    let mut rays = SmallVec::<[Row<T>; 8]>::with_capacity(ring.rays.len());
    for ray in &ring.rays {
        rays.push(T::on_ray(ray)?);
    }
    rays.sort_unstable();
    Ok(Pair::of_parts(Matrix::new(3), rows(facets), Matrix::new(3), rows(rays)))
}

/// The primitive vector across `a` and `b` with a negative product with `inside`.
fn on_side<T: Int>(a: &Row<T>, b: &Row<T>, inside: &Row<T>) -> Result<Row<T>, Overflow> {
    let ray = T::on_ray(&T::minors(a, b))?;
    Ok(if T::side_of(&ray, inside).is_gt() { negated(&ray) } else { ray })
}

/// The reduced row echelon form of the plane with this normal.
fn plane<T: Int>(normal: &Row<T>) -> Matrix<T> {
    let last = normal.iter().rposition(|entry| entry.sign().is_ne()).expect("a normal is not zero");
    let mut basis = Matrix::with_capacity(3, 2);
    for pivot in (0..3).filter(|pivot| *pivot != last) {
        let mut row = unit(pivot);
        (row[pivot], row[last]) = (normal[last].clone(), normal[pivot].negated());
        basis.push(&oriented(row));
    }
    basis
}

/// The primitive multiple of `row` with a positive first entry.
fn oriented<T: Int>(row: Row<T>) -> Row<T> {
    debug_assert!(!is_zero(&row), "a line has a direction");
    let row = T::shortest(row);
    if row[first(&row)].sign() == Ordering::Less { negated(&row) } else { row }
}

/// Where the first entry that is not zero stands.
fn first<T: Int>(row: &Row<T>) -> usize {
    row.iter().position(|entry| entry.sign().is_ne()).unwrap_or(0)
}

fn unit<T: Int>(axis: usize) -> Row<T> {
    std::array::from_fn(|entry| if entry == axis { T::unit() } else { T::default() })
}

fn rows<T: Int>(rows: impl IntoIterator<Item = Row<T>>) -> Matrix<T> {
    Matrix::from_rows(3, rows)
}
