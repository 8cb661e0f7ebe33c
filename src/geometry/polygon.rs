//! Simple polygons with exact vertices.

use crate::exact::Q;

/// A simple polygon, vertices counter-clockwise.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Polygon {
    vertices: Vec<[Q; 2]>,
}

impl Polygon {
    /// Vertices, counter-clockwise.
    #[must_use]
    pub fn vertices(&self) -> &[[Q; 2]] {
        &self.vertices
    }

    /// End points of edge `edge`, which runs from vertex `edge` to the next one.
    #[must_use]
    pub fn edge(&self, edge: usize) -> [&[Q; 2]; 2] {
        [&self.vertices[edge], &self.vertices[(edge + 1) % self.vertices.len()]]
    }
}
