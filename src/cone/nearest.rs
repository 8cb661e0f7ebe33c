//! The point of a closed cone nearest to a given point.

use super::pair::Pair;
use crate::exact::{Int, Overflow, Q, dot};
use num_traits::{Signed, Zero};

/// The point of `cone` nearest to `point` in the norm |x|² = Σ weight_i x_i².
///
/// The nearest point lies in the relative interior of one face, where it is the projection onto the span of the face.
/// By the Karush-Kuhn-Tucker conditions a projection p is the nearest point exactly if p is in the cone and x − p makes
/// no acute angle with any generator (Moreau's decomposition into the cone and its polar).
///
/// # Cost
/// One Gram system for each face, the cone itself excepted if it is solid.
///
/// # Errors
/// [`Overflow`] if a dot product of a facet and a ray does not fit.
///
/// # Panics
/// If `weights` are not positive or do not have one entry for each coordinate, as `point` must.
///
/// # Examples
/// ```
/// use partplan::cone::{Pair, nearest};
/// use partplan::exact::{Matrix, ratio};
/// let quadrant = Pair::from_normals(&Matrix::<i64>::new(2), &Matrix::from_rows(2, [[-1, 0], [0, -1]]))?;
/// let unit = [ratio(1, 1), ratio(1, 1)];
/// assert_eq!(nearest(&quadrant, &unit, &[ratio(3, 1), ratio(-2, 1)])?, [ratio(3, 1), ratio(0, 1)]);
/// # Ok::<(), partplan::exact::Overflow>(())
/// ```
pub fn nearest<T: Int>(cone: &Pair<T>, weights: &[Q], point: &[Q]) -> Result<Vec<Q>, Overflow> {
    let dim = cone.ambient();
    assert!(weights.len() == dim && weights.iter().all(Signed::is_positive), "a norm has a positive weight each way");
    assert_eq!(point.len(), dim, "a point has as many coordinates as the space");
    let exact = |row: &[T]| row.iter().map(|value| Q::from(value.to_z())).collect::<Vec<Q>>();
    let [lines, rays, facets] = [cone.lines(), cone.rays(), cone.facets()].map(|m| m.rows().map(exact).collect());
    let (lines, rays, facets): (Vec<_>, Vec<_>, Vec<_>) = (lines, rays, facets);
    if cone.dim() == dim && facets.iter().all(|facet| !dot(facet, point).is_positive()) {
        return Ok(point.to_vec());
    }
    for face in cone.faces()?.into_iter().skip(usize::from(cone.dim() == dim)) {
        let span: Vec<&[Q]> = lines.iter().chain(face.iter().map(|ray| &rays[*ray])).map(Vec::as_slice).collect();
        let foot = projection(&span, weights, point);
        let apart: Vec<Q> = (0..dim).map(|axis| (&point[axis] - &foot[axis]) * &weights[axis]).collect();
        let is_inside = facets.iter().all(|facet| !dot(facet, &foot).is_positive());
        if is_inside && rays.iter().all(|ray| !dot(ray, &apart).is_positive()) {
            return Ok(foot);
        }
    }
    unreachable!("the nearest point of a closed cone lies on one of its faces")
}

/// The point of the span of `vectors`, independent or not, nearest to `point`.
fn projection(vectors: &[&[Q]], weights: &[Q], point: &[Q]) -> Vec<Q> {
    let product = |a: &[Q], b: &[Q]| a.iter().zip(b).zip(weights).map(|((x, y), weight)| x * y * weight).sum::<Q>();
    let mut gram: Vec<Vec<Q>> = vectors
        .iter()
        .map(|row| vectors.iter().copied().chain([point]).map(|column| product(row, column)).collect())
        .collect();
    // of a Gram matrix what is left of a row is zero with its diagonal: the vector depends on those before it
    let size = vectors.len();
    for pivot in 0..size {
        if gram[pivot][pivot].is_zero() {
            continue;
        }
        let row = gram[pivot].clone();
        for other in (0..size).filter(|other| *other != pivot) {
            let factor = &gram[other][pivot] / &row[pivot];
            if !factor.is_zero() {
                gram[other].iter_mut().zip(&row).for_each(|(value, by)| *value -= &factor * by);
            }
        }
    }
    let mut foot = vec![Q::zero(); point.len()];
    for (index, vector) in vectors.iter().enumerate().filter(|(index, _)| !gram[*index][*index].is_zero()) {
        let share = &gram[index][size] / &gram[index][index];
        foot.iter_mut().zip(*vector).for_each(|(sum, value)| *sum += &share * value);
    }
    foot
}
