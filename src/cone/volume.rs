//! Exact volumes of cones inside boxes.

use super::bits::BitRows;
use super::lattice::{common, incidence, subfaces};
use super::nnc::Cone;
use super::pair::Pair;
use crate::exact::{Int, Matrix, Overflow, Q, Z, primitive_row};
use num_traits::{One, Signed, Zero};

/// Volume of `cone` inside `|x_i| ≤ reach_i`, as a fraction of the box.
///
/// With the box scaled to the cube, the cone's part of it is the union of the pyramids from the apex over the cone's
/// part of each of the cube's facets, which is triangulated from its face lattice.
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
    let polytope = in_cube(cone.closure(), reach)?;
    let vertices: Vec<Vec<Z>> = polytope.rays().rows().map(|ray| ray.iter().map(T::to_z).collect()).collect();
    let on = incidence(polytope.facets(), polytope.rays())?;
    let mut pyramids = Vec::new();
    for (facet, normal) in polytope.facets().rows().enumerate() {
        if normal[dim].sign().is_ne() {
            let face = common(&on, &[facet], vertices.len());
            triangulate(&on, &face, &mut Vec::new(), &mut |simplex| pyramids.push(pyramid(&vertices, simplex)));
        }
    }
    let (numerator, denominator) = sum(&pyramids);
    let scale = (1..=dim).fold(Z::one() << dim, |product, factor| product * factor);
    Ok(Q::new(numerator, denominator * scale))
}

/// The cone's part of the cube `|y_i| ≤ 1`, `y_i = x_i / reach_i`, homogenised by a last coordinate.
fn in_cube<T: Int>(cone: &Pair<T>, reach: &[Q]) -> Result<Pair<T>, Overflow> {
    let dim = reach.len();
    let mut normals = Matrix::new(dim + 1);
    for facet in cone.facets().rows() {
        let mut scaled: Vec<Q> = facet.iter().zip(reach).map(|(value, reach)| reach * value.to_z()).collect();
        scaled.push(Q::zero());
        let row = primitive_row(&scaled).iter().map(T::from_z).collect::<Option<Vec<T>>>().ok_or(Overflow)?;
        normals.push(&row);
    }
    for axis in 0..dim {
        for side in [T::unit(), T::unit().negated()] {
            let mut row = vec![T::default(); dim + 1];
            row[axis] = side;
            row[dim] = T::unit().negated();
            normals.push(&row);
        }
    }
    Pair::from_normals(&Matrix::new(dim + 1), &normals)
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
    for facet in below.iter().filter(|facet| !super::bits::has(facet, apex)) {
        triangulate(on, facet, apexes, emit);
    }
    apexes.pop();
}

fn first(set: &[u64]) -> Option<usize> {
    set.iter().enumerate().find(|(_, word)| **word != 0).map(|(at, word)| at * 64 + word.trailing_zeros() as usize)
}

/// `|det|` of homogeneous vertices over the product of their last coordinates.
fn pyramid(vertices: &[Vec<Z>], simplex: &[usize]) -> (Z, Z) {
    let dim = simplex.len();
    let matrix: Vec<Vec<Z>> = simplex.iter().map(|vertex| vertices[*vertex][..dim].to_vec()).collect();
    let weight = simplex.iter().map(|vertex| &vertices[*vertex][dim]).product();
    (determinant(matrix).abs(), weight)
}

/// Bareiss' fraction-free elimination.
fn determinant(mut matrix: Vec<Vec<Z>>) -> Z {
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

/// Sum of fractions by halves, reduced nowhere.
fn sum(fractions: &[(Z, Z)]) -> (Z, Z) {
    match fractions {
        [] => (Z::zero(), Z::one()),
        [one] => one.clone(),
        _ => {
            let (left, right) = fractions.split_at(fractions.len() / 2);
            let ((a, b), (c, d)) = (sum(left), sum(right));
            if b == d { (a + c, b) } else { (a * &d + c * &b, b * d) }
        }
    }
}
