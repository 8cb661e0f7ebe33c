//! Fixels that touch the seated part, and their friction.

use crate::exact::Q;

/// The fixels of an `insert` section, in file order.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fixture {
    /// At least one.
    pub fixels: Vec<Fixel>,
}

/// One point contact of the seated part with the fixture.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fixel {
    /// Where on the outline the fixel touches.
    pub place: Place,
    /// Contact point `[x, y]` on the outline.
    pub point: [Q; 2],
    /// Contact normal `n` into the part, of any length; the tangent `t` is `n` turned by +90 degrees.
    pub normal: [Q; 2],
    /// Coulomb friction.
    pub friction: Friction,
}

/// Where on the outline a fixel touches.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Place {
    /// Strictly inside edge `edge`, at parameter `s` in (0, 1).
    Edge {
        /// Edge from vertex `edge` to the next.
        edge: usize,
        /// Share of the edge's length from its first vertex.
        s: Q,
    },
    /// At a vertex.
    Vertex {
        /// Vertex number.
        vertex: usize,
    },
    /// On a circle.
    Arc,
}

/// Coulomb friction with uncertain coefficients; every value in the ranges is possible at each contact.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Friction {
    /// Static coefficient μ_s.
    pub static_: Range,
    /// Kinetic coefficient μ_k, never above the static one.
    pub kinetic: Range,
}

/// A closed interval of non-negative rationals.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Range {
    /// Least value.
    pub min: Q,
    /// Largest value.
    pub max: Q,
}

impl Range {
    /// The range that holds one value.
    #[must_use]
    pub fn exactly(value: Q) -> Self {
        Self { min: value.clone(), max: value }
    }
}
