//! Why a point belongs to a sum of cones: its summands.

use super::bits::has;
use super::cut::cut_space;
use super::lattice::incidence;
use super::nnc::HalfSpaces;
use super::simplex::Simplex;
use crate::exact::{Int, Matrix, Overflow, Q};
use num_traits::{Signed as _, Zero as _};

/// A point as the sum of one that satisfies a system and of a non-negative combination of rays.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Summands {
    /// The summand that satisfies the system.
    pub within: Vec<Q>,
    /// What each ray contributes, non-negative; `point = within + Σ weight · ray`.
    pub weights: Vec<Q>,
}

/// Writes `point` as in [`Summands`], or `None` if it is outside of the sum that
/// [`Cone::from_half_spaces_plus`](super::Cone::from_half_spaces_plus) describes.
///
/// The rays that contribute are linearly independent if the system has no strict rows. A strict row needs a generator
/// of the system off its hyperplane: the mean of one solution for each such row satisfies all of them, by convexity.
///
/// # Cost
/// The generators of the system, and a simplex method with as many rows as coordinates.
///
/// # Errors
/// [`Overflow`] if a generator of the system does not fit `T`.
///
/// # Panics
/// If a ray or `point` has another number of coordinates than the system.
///
/// # Examples
/// ```
/// use partplan::cone::{HalfSpaces, summands};
/// use partplan::exact::{Matrix, ratio};
/// // x = 0, y < 0 and the ray (1, 1)
/// let mut system = HalfSpaces::<i64>::none(2);
/// system.equalities.push(&[1, 0]);
/// system.strict.push(&[0, 1]);
/// let ray = vec![ratio(1, 1), ratio(1, 1)];
/// let found = summands(&system, &[ray.clone()], &[ratio(2, 1), ratio(1, 1)])?.unwrap();
/// assert_eq!((found.within, found.weights), (vec![ratio(0, 1), ratio(-1, 1)], vec![ratio(2, 1)]));
/// assert_eq!(summands(&system, &[ray], &[ratio(2, 1), ratio(2, 1)])?, None);
/// # Ok::<(), partplan::exact::Overflow>(())
/// ```
pub fn summands<T: Int>(system: &HalfSpaces<T>, rays: &[Vec<Q>], point: &[Q]) -> Result<Option<Summands>, Overflow> {
    let dim = system.closed.columns();
    assert!(point.len() == dim && rays.iter().all(|ray| ray.len() == dim), "all vectors have as many coordinates");
    let cut = cut_space(&system.equalities, &system.normals())?;
    let lines = exact(&cut.lines);
    let mut columns = exact(&cut.rays);
    columns.extend(lines.iter().map(|line| line.iter().map(|value| -value).collect()));
    columns.extend(lines);
    let own = columns.len();
    columns.extend_from_slice(rays);
    let Some(mut simplex) = Simplex::feasible(&columns, point) else { return Ok(None) };
    let mut solutions = vec![simplex.values()];
    for face in incidence(&system.strict, &cut.rays)?.rows() {
        let off: Vec<usize> = (0..cut.rays.len()).filter(|ray| !has(face, *ray)).collect();
        if solutions.iter().any(|solution| off.iter().any(|ray| solution[*ray].is_positive())) {
            continue;
        }
        let Some(solution) = simplex.with_one_of(&off) else { return Ok(None) };
        solutions.push(solution);
    }
    let mut mean = mean(&solutions);
    let weights = mean.split_off(own);
    let within = (0..dim).map(|axis| mean.iter().zip(&columns).map(|(z, column)| z * &column[axis]).sum()).collect();
    Ok(Some(Summands { within, weights }))
}

fn exact<T: Int>(rows: &Matrix<T>) -> Vec<Vec<Q>> {
    rows.rows().map(|row| row.iter().map(|value| Q::from(value.to_z())).collect()).collect()
}

fn mean(solutions: &[Vec<Q>]) -> Vec<Q> {
    let count = Q::from_integer(solutions.len().into());
    let entry = |index: usize| solutions.iter().fold(Q::zero(), |sum, solution| sum + &solution[index]) / &count;
    (0..solutions[0].len()).map(entry).collect()
}
