//! The set of all solutions: how many, where, and what a linear map makes of them.

use super::ExactLcp;
use super::cases::search;
use super::integral::Integral;
use crate::exact::{Q, Z, dot};
use num_traits::{Signed as _, Zero as _};

/// All solutions of a problem, as a union of polyhedra.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Solutions {
    /// The polyhedra, none within another; empty if there is no solution.
    pub pieces: Vec<Piece>,
}

/// A polyhedron of solutions: all `z ≥ 0`, `w ≥ 0` with these zeros, which are complementary.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Piece {
    /// Indices with `z = 0` throughout.
    pub zero_z: Vec<usize>,
    /// Indices with `w = 0` throughout; with `zero_z` all indices.
    pub zero_w: Vec<usize>,
    /// Its vertices, at least one.
    pub vertices: Vec<Vec<Q>>,
    /// Its directions of recession.
    pub rays: Vec<Vec<Q>>,
}

/// What [`enumerate`] came to.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Enumeration {
    /// All solutions.
    Complete(Solutions),
    /// The limit was met after so many cases; nothing is known about the others.
    Unfinished {
        /// Cases looked at.
        cases: usize,
    },
}

/// How many solutions there are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Count {
    /// None.
    None,
    /// One.
    Unique,
    /// This many, isolated from each other.
    Finite(usize),
    /// Infinitely many.
    Continuum,
}

/// The images of all solutions under a linear map.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Images {
    /// No solution.
    None,
    /// All solutions have this one.
    Unique(Vec<Q>),
    /// These, at least two.
    Several(Vec<Vec<Q>>),
    /// Infinitely many.
    Continuum,
}

/// The values of a variable over all solutions; both ends are attained.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Range {
    /// The least.
    pub min: Q,
    /// The greatest, or `None` if there is none.
    pub max: Option<Q>,
}

/// Finds all solutions, looking at no more than `limit` complementary cases.
///
/// # Cost
/// Exponential in the number of pairs that are free to go both ways; each case costs a double description of a
/// polyhedron with at most 2 n facets.
///
/// # Examples
/// A wedge: two opposed contacts, whose forces are one and the same number, any number.
/// ```
/// use partplan::complementarity::{Count, Enumeration, Factors, Images, enumerate};
/// use partplan::exact::ratio;
/// let factors = Factors { jacobian: &[1.0, -1.0], inverse_mass: &[1.0], mu: &[], directions: 0, q: &[0.0, 0.0] };
/// let Enumeration::Complete(all) = enumerate(&factors.to_exact()?, 100) else { panic!() };
/// assert_eq!(all.count(), Count::Continuum);
/// assert_eq!(all.range(0).unwrap().max, None);
/// assert_eq!(all.images(&factors.velocity_map()?), Images::Unique(vec![ratio(0, 1)]));
/// # Ok::<(), partplan::complementarity::LcpError>(())
/// ```
#[must_use]
pub fn enumerate(lcp: &ExactLcp, limit: usize) -> Enumeration {
    let integral = Integral::new(lcp);
    let cases = search(&integral, limit);
    if !cases.is_complete {
        return Enumeration::Unfinished { cases: cases.visited };
    }
    let pieces = cases.pieces.into_iter().map(|choice| {
        let [zero_z, zero_w] = choice.zeros;
        let (points, directions): (Vec<_>, Vec<_>) = choice.generators.iter().partition(|row| row[0].is_positive());
        let scaled = |row: &Vec<Z>| {
            let scale = if row[0].is_zero() { Z::from(1) } else { row[0].clone() };
            let values: Vec<Q> = row[1..].iter().map(|value| Q::new(value.clone(), scale.clone())).collect();
            integral.restore(&values)
        };
        Piece {
            zero_z,
            zero_w,
            vertices: points.into_iter().map(scaled).collect(),
            rays: directions.into_iter().map(scaled).collect(),
        }
    });
    Enumeration::Complete(Solutions { pieces: pieces.collect() })
}

impl Solutions {
    /// How many there are.
    #[must_use]
    pub fn count(&self) -> Count {
        let is_point = |piece: &Piece| piece.vertices.len() == 1 && piece.rays.is_empty();
        match self.pieces.len() {
            0 => Count::None,
            _ if !self.pieces.iter().all(is_point) => Count::Continuum,
            1 => Count::Unique,
            several => Count::Finite(several),
        }
    }

    /// The images `map · z`, for contacts with [`Factors::velocity_map`](super::Factors::velocity_map) the changes of the
    /// velocities: forces may be a continuum where velocities are unique.
    #[must_use]
    pub fn images(&self, map: &[Vec<Q>]) -> Images {
        let image = |z: &Vec<Q>| map.iter().map(|row| dot(row, z)).collect::<Vec<Q>>();
        let mut found: Vec<Vec<Q>> = Vec::new();
        for piece in &self.pieces {
            let moves = |ray: &Vec<Q>| image(ray).iter().any(|entry| !entry.is_zero());
            let mut images = piece.vertices.iter().map(image);
            let Some(first) = images.next() else { continue };
            if piece.rays.iter().any(moves) || images.any(|other| other != first) {
                return Images::Continuum;
            }
            if !found.contains(&first) {
                found.push(first);
            }
        }
        match found.len() {
            0 => Images::None,
            1 => Images::Unique(found.swap_remove(0)),
            _ => Images::Several(found),
        }
    }

    /// The values of `z_index`, or `None` if there is no solution or no such variable.
    #[must_use]
    pub fn range(&self, index: usize) -> Option<Range> {
        let values = || self.pieces.iter().flat_map(|piece| &piece.vertices).filter_map(|vertex| vertex.get(index));
        let min = values().min()?.clone();
        let grows = |ray: &Vec<Q>| ray.get(index).is_some_and(Q::is_positive);
        let is_bounded = !self.pieces.iter().flat_map(|piece| &piece.rays).any(grows);
        let max = if is_bounded { values().max().cloned() } else { None };
        Some(Range { min, max })
    }

    /// Whether `z` is one of them.
    #[must_use]
    pub fn contains(&self, lcp: &ExactLcp, z: &[Q]) -> bool {
        let w = lcp.w(z);
        let has_zeros = |piece: &Piece| {
            piece.zero_z.iter().all(|i| z[*i].is_zero()) && piece.zero_w.iter().all(|i| w[*i].is_zero())
        };
        lcp.is_solution(z) && self.pieces.iter().any(has_zeros)
    }
}
