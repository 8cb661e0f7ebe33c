//! Simple polygons with exact vertices.

use super::scaled::{self, Scaled};
use super::simple;
use crate::exact::{Q, Z};
use num_traits::{Signed as _, Zero as _};

/// Bits that a coordinate may need over the common denominator of all of them (room for `1e-10000`).
pub const MAX_COORDINATE_BITS: u64 = 80_000;

/// Faults that [`Polygon::new`] lists before it stops looking.
pub const MAX_REPORTED_FAULTS: usize = 64;

/// A simple polygon, vertices counter-clockwise.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Polygon {
    vertices: Vec<[Q; 2]>,
}

impl Polygon {
    /// Checks exactly that `vertices` bound a simple polygon; a clockwise list is reversed keeping vertex 0 first.
    ///
    /// Collinear vertices are allowed; edges that touch anywhere but at their common vertex are not.
    ///
    /// # Errors
    /// Every fault found, up to [`MAX_REPORTED_FAULTS`]; indices are those of the list as given.
    ///
    /// # Cost
    /// A sweep over the edges by x with bounding boxes; O(n²) comparisons of boxes in the worst case.
    ///
    /// # Examples
    /// ```
    /// use partplan::{exact::ratio, geometry::Polygon};
    /// let square = [[0, 0], [0, 1], [1, 1], [1, 0]].map(|p| p.map(|x| ratio(x, 1)));
    /// let polygon = Polygon::new(square.to_vec()).unwrap();
    /// assert_eq!(polygon.vertices()[1], square[3]);
    /// ```
    pub fn new(vertices: Vec<[Q; 2]>) -> Result<Self, Vec<PolygonFault>> {
        if vertices.len() < 3 {
            return Err(vec![PolygonFault::TooFewVertices { vertices: vertices.len() }]);
        }
        let scaled = scaled::scale(&vertices).map_err(|bits| vec![PolygonFault::TooManyDigits { bits }])?;
        let zero_length = zero_length_edges(&vertices);
        if !zero_length.is_empty() {
            return Err(zero_length);
        }
        let area = scaled::doubled_area(&scaled.points);
        if area.is_zero() && collinear(&scaled) {
            return Err(vec![PolygonFault::ZeroArea]);
        }
        let faults = simple::faults(&vertices, &scaled);
        if !faults.is_empty() {
            return Err(faults);
        }
        Ok(Self { vertices: if area.is_negative() { reversed(vertices) } else { vertices } })
    }

    /// Vertices, counter-clockwise.
    #[must_use]
    pub fn vertices(&self) -> &[[Q; 2]] {
        &self.vertices
    }

    /// Number of edges, which is the number of vertices.
    #[must_use]
    pub fn n_edges(&self) -> usize {
        self.vertices.len()
    }

    /// End points of edge `edge`, which runs from vertex `edge` to the next one.
    #[must_use]
    pub fn edge(&self, edge: usize) -> [&[Q; 2]; 2] {
        [&self.vertices[edge], &self.vertices[(edge + 1) % self.vertices.len()]]
    }

    /// The larger side of the bounding box.
    #[must_use]
    pub fn extent(&self) -> Q {
        let side = |axis: usize| {
            let values = || self.vertices.iter().map(|vertex| &vertex[axis]);
            let (min, max) = (values().min(), values().max());
            min.zip(max).map(|(min, max)| max - min).expect("a polygon has vertices")
        };
        side(0).max(side(1))
    }

    pub(super) fn scaled(&self) -> Scaled {
        scaled::scale(&self.vertices).expect("the constructor has bounded the digits")
    }
}

fn zero_length_edges(vertices: &[[Q; 2]]) -> Vec<PolygonFault> {
    let n = vertices.len();
    (0..n)
        .map(|first| (first, (first + 1) % n))
        .filter(|(first, second)| vertices[*first] == vertices[*second])
        .map(|(first, second)| PolygonFault::RepeatedVertex { first: first.min(second), second: first.max(second) })
        .take(MAX_REPORTED_FAULTS)
        .collect()
}

fn collinear(scaled: &Scaled) -> bool {
    let [a, b] = [&scaled.points[0], &scaled.points[1]];
    scaled.points.iter().all(|c| scaled::turn(a, b, c) == Z::zero())
}

fn reversed(mut vertices: Vec<[Q; 2]>) -> Vec<[Q; 2]> {
    vertices[1..].reverse();
    vertices
}

/// Why a list of vertices does not bound a simple polygon; edge `i` runs from vertex `i` of the list to the next one.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum PolygonFault {
    /// Two vertices or fewer.
    #[error("a polygon needs at least three vertices, not {vertices}")]
    TooFewVertices {
        /// How many there are.
        vertices: usize,
    },
    /// The coordinates are too long for exact geometry in bounded memory.
    #[error("the coordinates need integers of {bits} bits over their common denominator, which is too long")]
    TooManyDigits {
        /// Bits of the longest integer met.
        bits: u64,
    },
    /// All vertices on one line.
    #[error("the polygon has no area: all of its vertices lie on one line")]
    ZeroArea,
    /// Two equal vertices, `first < second`.
    #[error("vertices {first} and {second} are the same point")]
    RepeatedVertex {
        /// The earlier one.
        first: usize,
        /// The later one.
        second: usize,
    },
    /// The outline runs back over itself.
    #[error("the outline turns back on itself at vertex {vertex}")]
    Spike {
        /// Where it turns.
        vertex: usize,
    },
    /// Two edges meet that are not neighbours.
    #[error("edges {first} and {second} cross or touch")]
    Crossing {
        /// The edge with the smaller number.
        first: usize,
        /// The other edge.
        second: usize,
        /// A common point.
        at: [Q; 2],
    },
}
