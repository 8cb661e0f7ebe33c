//! Exact volumes of cones inside boxes.

use super::bits::{BitRows, all, has};
use super::lattice::{incidence, subfaces};
use super::nnc::Cone;
use super::pair::Pair;
use crate::exact::{Int, Matrix, Overflow, Q, Z, fraction, on_rung, primitive_row, sum};
use num_traits::{One, Signed, Zero};
use smallvec::SmallVec;
use std::cmp::Ordering;

/// Volume of `cone` inside `|x_i| ≤ reach_i`, as a fraction of the box.
///
/// With the box scaled to the cube, the cone's part of it is the union of the pyramids from the apex over the cone's
/// sections with the cube's facets, which are triangulated from their face lattices.
///
/// # Errors
/// [`Overflow`] if a primitive row does not fit `T`.
///
/// # Panics
/// If `reach` is not one positive number for each coordinate.
pub fn volume_in_box<T: Int>(cone: &Cone<T>, reach: &[Q]) -> Result<Q, Overflow> {
    let dim = cone.closure().ambient();
    assert!(reach.len() == dim && reach.iter().all(Signed::is_positive), "a box has a positive half-width each way");
    if dim == 0 {
        return Ok(Q::one());
    }
    if cone.closure().dim() < dim {
        return Ok(Q::zero());
    }
    let facets = cone.closure().facets();
    let sides: Vec<_> = (0..dim)
        .flat_map(|axis| [(axis, Ordering::Greater), (axis, Ordering::Less)])
        .filter(|(axis, side)| reaches(cone.closure(), *axis, *side))
        .collect();
    let pyramids = pyramids(facets, reach, &sides).or_else(|Overflow| pyramids(&facets.to_long(), reach, &sides))?;
    let scale = (1..=dim).fold(Z::one() << dim, |product, factor| product * factor);
    let (numerator, denominator) = sum(pyramids).into_raw();
    Ok(fraction(numerator, denominator * scale))
}

/// The pyramids over the sections with these facets of the cube, as [`pyramid`] has them.
fn pyramids<T: Int>(facets: &Matrix<T>, reach: &[Q], sides: &[(usize, Ordering)]) -> Result<Vec<Q>, Overflow> {
    let normals = in_cube(facets, reach)?;
    let mut pyramids = Vec::with_capacity(sides.len());
    for (axis, side) in sides {
        pyramids.extend(pyramid(&section(&normals, *axis, *side)?, *axis)?);
    }
    Ok(pyramids)
}

/// The facet normals in the coordinates `y_i = x_i / reach_i`.
fn in_cube<T: Int>(facets: &Matrix<T>, reach: &[Q]) -> Result<Matrix<T>, Overflow> {
    let scale = on_rung::<T>(&primitive_row(reach))?;
    let mut normals = Matrix::with_capacity(reach.len(), facets.len());
    for facet in facets.rows() {
        let product = |axis: usize| T::dot(&facet[axis..=axis], &scale[axis..=axis]);
        let scaled = (0..reach.len()).map(product).collect::<Result<SmallVec<[_; 4]>, _>>()?;
        normals.push_with(|entries| T::primitive(&scaled, entries))?;
    }
    Ok(normals)
}

/// Whether some point of the cone has coordinate `axis` on this side of zero.
fn reaches<T: Int>(cone: &Pair<T>, axis: usize, side: Ordering) -> bool {
    cone.rays().rows().any(|ray| ray[axis].sign() == side) || cone.lines().rows().any(|line| line[axis].sign().is_ne())
}

/// The section with the cube's facet `y_axis = ±1`, homogenised: coordinate `axis` becomes the common denominator.
fn section<T: Int>(normals: &Matrix<T>, axis: usize, side: Ordering) -> Result<Pair<T>, Overflow> {
    let dim = normals.columns();
    let mut sectioned = Matrix::with_capacity(dim, normals.len() + 2 * dim);
    for normal in normals.rows() {
        sectioned.push(normal);
        if side.is_lt() {
            let last = sectioned.len() - 1;
            sectioned.row_mut(last)[axis] = normal[axis].negated();
        }
    }
    let mut row = vec![T::default(); dim];
    row[axis] = T::unit().negated();
    sectioned.push(&row);
    for other in (0..dim).filter(|other| *other != axis) {
        for bound in [T::unit(), T::unit().negated()] {
            row[other] = bound;
            sectioned.push(&row);
        }
        row[other] = T::default();
    }
    Pair::from_normals(&Matrix::new(dim), &sectioned)
}

/// The pyramid from the apex over a section, as a fraction of `1 / dim!`; `None` over a section without area.
///
/// It is the sum of the simplices' `|det|` over the product of their weights; here over the weights of all vertices, each
/// taken once, so that the fraction stays short.
fn pyramid<T: Int>(section: &Pair<T>, axis: usize) -> Result<Option<Q>, Overflow> {
    if section.dim() < section.ambient() {
        return Ok(None);
    }
    let rays = section.rays();
    let weights: Vec<Z> = rays.rows().map(|ray| ray[axis].to_z()).collect();
    let on = incidence(section.facets(), rays)?;
    let mut numerator = Z::zero();
    let mut add = |simplex: &[usize]| {
        let others = (0..weights.len()).filter(|vertex| !simplex.contains(vertex));
        let weight: Z = others.map(|vertex| &weights[vertex]).product();
        numerator += determinant(rays, simplex).abs() * weight;
    };
    triangulate(&on, &all(weights.len()), &mut Vec::new(), &mut add);
    Ok(Some(fraction(numerator, weights.iter().product())))
}

/// Calls `emit` with the vertices of each simplex of a triangulation of `face`: its first vertex joined to each of its
/// facets that misses that vertex.
fn triangulate(on: &BitRows, face: &[u64], apexes: &mut Vec<usize>, emit: &mut impl FnMut(&[usize])) {
    let Some(apex) = first(face) else { return };
    apexes.push(apex);
    let below = subfaces(on, face);
    if below.iter().all(|facet| first(facet).is_none()) {
        emit(apexes);
    }
    for facet in below.iter().filter(|facet| !has(facet, apex)) {
        triangulate(on, facet, apexes, emit);
    }
    apexes.pop();
}

fn first(set: &[u64]) -> Option<usize> {
    set.iter().enumerate().find(|(_, word)| **word != 0).map(|(at, word)| at * 64 + word.trailing_zeros() as usize)
}

fn determinant<T: Int>(rays: &Matrix<T>, simplex: &[usize]) -> Z {
    let ray = |vertex: usize| rays.row(vertex);
    if let [a, b, c] = *simplex
        && let (Ok(a), Ok(b), Ok(c)) = (ray(a).try_into(), ray(b).try_into(), ray(c).try_into())
    {
        return T::determinant(a, b, c);
    }
    bareiss(simplex.iter().map(|vertex| ray(*vertex).iter().map(T::to_z).collect()).collect())
}

/// The determinant by Bareiss' fraction-free elimination.
fn bareiss(mut matrix: Vec<Vec<Z>>) -> Z {
    let size = matrix.len();
    let mut previous = Z::one();
    let mut sign = Z::one();
    for step in 0..size {
        let Some(pivot) = (step..size).find(|row| !matrix[*row][step].is_zero()) else { return Z::zero() };
        if pivot != step {
            matrix.swap(pivot, step);
            sign = -sign;
        }
        for row in step + 1..size {
            for column in step + 1..size {
                let value = &matrix[row][column] * &matrix[step][step] - &matrix[row][step] * &matrix[step][column];
                matrix[row][column] = value / &previous;
            }
        }
        previous = matrix[step][step].clone();
    }
    sign * previous
}
