//! Cones of wrenches, unions of them, and the finger places and tilt directions that fall inside.

use crate::exact::{Q, Z};

/// A convex cone of wrenches, not necessarily closed, in canonical form.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Cone {
    /// No wrench at all, not even zero.
    Empty,
    /// At least one wrench.
    Of(CanonicalCone),
}

/// The canonical form: equal sets have equal forms.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CanonicalCone {
    /// Dimension of the span.
    pub dim: usize,
    /// RREF basis of the orthogonal complement of the span; coprime rows, positive pivots.
    pub equalities: Vec<Vec<Z>>,
    /// Facets of the closure, sorted by normal.
    pub faces: Vec<Face>,
    /// Missing faces of lower dimension that lie in no missing facet.
    pub excluded: Vec<Excluded>,
    /// RREF basis of the lineality space.
    pub lines: Vec<Vec<Z>>,
    /// Extreme rays of the closure modulo `lines`, coprime, sorted.
    pub rays: Vec<Vec<Z>>,
}

/// A facet `normal · g ≤ 0`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Face {
    /// Outward normal, reduced modulo the equalities, coprime.
    pub normal: Vec<Z>,
    /// Whether the whole facet is missing: `normal · g < 0`.
    pub strict: bool,
}

/// A missing face of lower dimension than a facet: the cone also needs `normal · g < 0`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Excluded {
    /// Sum of the normals of the tight facets.
    pub normal: Vec<Z>,
    /// Facets (indices into `faces`) that contain the missing face.
    pub tight: Vec<usize>,
}

/// A set of wrenches: a finite union of convex cones.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Region {
    /// Largest dimension of a cell; `None` for the empty set.
    pub dim: Option<usize>,
    /// Whether every wrench belongs to the set.
    pub everything: bool,
    /// Exact volume inside `|fx| ≤ 1, |fy| ≤ 1, |torque| ≤ reach` as a fraction of that box.
    pub volume_in_box: Q,
    /// Disjoint convex cells whose union is the set.
    pub cells: Vec<Cone>,
}

impl Region {
    /// Whether no wrench belongs to the set.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.dim.is_none()
    }

    /// Whether some ball of wrenches belongs to the set.
    #[must_use]
    pub fn has_interior(&self) -> bool {
        self.dim == Some(3)
    }
}

/// Places on the outline where a frictionless finger may push along the inward normal.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum FingerSet {
    /// On a polygon: edges with at least one place, in order.
    Edges(Vec<EdgeFingers>),
    /// On a circle: directions from the center to the finger.
    Arcs(ArcSet),
}

/// Finger places on one edge.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct EdgeFingers {
    /// Edge number.
    pub edge: usize,
    /// Maximal intervals, in order along the edge.
    pub intervals: Vec<Interval>,
}

/// A maximal interval of an edge; a single place has equal ends.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Interval {
    /// Ends as shares of the edge, in [0, 1].
    pub s: [Q; 2],
    /// Whether each end belongs to the interval.
    pub closed: [bool; 2],
    /// The ends as points.
    pub points: [[Q; 2]; 2],
}

/// A set of directions in the plane.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ArcSet {
    /// Whether every direction belongs to the set; `arcs` is then empty.
    pub all: bool,
    /// Maximal arcs, counter-clockwise order.
    pub arcs: Vec<Arc>,
}

/// The arc counter-clockwise from `from` to `to`.
///
/// Equal ends mean one direction when both are closed, and all directions but that one when both are open.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Arc {
    /// First direction, coprime.
    pub from: [Z; 2],
    /// Last direction, coprime.
    pub to: [Z; 2],
    /// Whether each end belongs to the arc.
    pub closed: [bool; 2],
}
