//! Points and normals on the outline of a polygon.

use super::polygon::Polygon;
use super::{cross, difference, dot};
use crate::exact::{Q, primitive_row};
use num_traits::{One as _, Signed as _, Zero as _};

/// Where on an outline a point lies.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Location {
    /// At a vertex.
    Vertex(usize),
    /// Strictly inside an edge.
    Edge {
        /// Edge from vertex `edge` to the next one.
        edge: usize,
        /// Share of the edge's length from its first vertex, in (0, 1).
        s: Q,
    },
}

impl Polygon {
    /// Where `point` lies on the outline; `None` elsewhere.
    #[must_use]
    pub fn locate(&self, point: &[Q; 2]) -> Option<Location> {
        (0..self.n_edges()).find_map(|edge| {
            let [a, b] = self.edge(edge);
            let (along, to_point) = (difference(a, b), difference(a, point));
            if !cross(&along, &to_point).is_zero() {
                return None;
            }
            let s = dot(&along, &to_point) / dot(&along, &along);
            (!s.is_negative() && s <= Q::one()).then(|| self.location(edge, s))
        })
    }

    /// The point of the outline nearest to `point`, its location and its squared distance.
    ///
    /// Among equally near points the one on the edge with the smallest number.
    #[must_use]
    pub fn nearest(&self, point: &[Q; 2]) -> (Location, [Q; 2], Q) {
        let candidates = (0..self.n_edges()).map(|edge| {
            let [a, b] = self.edge(edge);
            let (along, to_point) = (difference(a, b), difference(a, point));
            let s = (dot(&along, &to_point) / dot(&along, &along)).clamp(Q::zero(), Q::one());
            let gap = [&to_point[0] - &along[0] * &s, &to_point[1] - &along[1] * &s];
            (dot(&gap, &gap), edge, s)
        });
        let (distance2, edge, s) = candidates.min_by(|a, b| a.0.cmp(&b.0)).expect("a polygon has at least three edges");
        let location = self.location(edge, s);
        (location.clone(), self.point(&location), distance2)
    }

    /// The location at share `s` in [0, 1] of edge `edge`.
    ///
    /// # Panics
    /// If there is no such edge.
    #[must_use]
    pub fn location(&self, edge: usize, s: Q) -> Location {
        assert!(edge < self.n_edges(), "there is no edge {edge}");
        if s.is_zero() {
            Location::Vertex(edge)
        } else if s.is_one() {
            Location::Vertex((edge + 1) % self.n_edges())
        } else {
            Location::Edge { edge, s }
        }
    }

    /// The point at `location`.
    #[must_use]
    pub fn point(&self, location: &Location) -> [Q; 2] {
        match location {
            Location::Vertex(vertex) => self.vertices()[*vertex].clone(),
            Location::Edge { edge, s } => {
                let [a, b] = self.edge(*edge);
                [0, 1].map(|axis| &a[axis] + (&b[axis] - &a[axis]) * s)
            }
        }
    }

    /// The inward normal of edge `edge`, scaled to coprime integers.
    #[must_use]
    pub fn inward_normal(&self, edge: usize) -> [Q; 2] {
        let [a, b] = self.edge(edge);
        let [x, y] = difference(a, b);
        shortened(&[-y, x])
    }

    /// Inward normals of the edges before and after `vertex`.
    #[must_use]
    pub fn normals_at(&self, vertex: usize) -> [[Q; 2]; 2] {
        let before = (vertex + self.n_edges() - 1) % self.n_edges();
        [self.inward_normal(before), self.inward_normal(vertex)]
    }

    /// Whether `normal` is a non-negative combination, not zero, of the two inward normals at `vertex`.
    ///
    /// At a reflex vertex a point touches both edges, and pushes along any such combination.
    #[must_use]
    pub fn admits_normal(&self, vertex: usize, normal: &[Q; 2]) -> bool {
        let [before, after] = self.normals_at(vertex);
        let opening = cross(&before, &after);
        if opening.is_zero() {
            return cross(&before, normal).is_zero() && dot(&before, normal).is_positive();
        }
        let shares = [cross(normal, &after) / &opening, cross(&before, normal) / &opening];
        shares.iter().all(|share| !share.is_negative()) && shares.iter().any(|share| share.is_positive())
    }
}

/// The vector of coprime integers that points the same way; zero stays zero.
#[must_use]
pub fn shortened(vector: &[Q; 2]) -> [Q; 2] {
    let row = primitive_row(vector);
    [0, 1].map(|axis| Q::from(row[axis].clone()))
}
