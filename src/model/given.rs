//! Plans that a case brings along, to be put to the test.

use crate::exact::Q;

/// How a part is to be seated.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum GivenPush {
    /// A frictionless finger pushes on an edge along its inward normal.
    Edge {
        /// Edge from vertex `edge` to the next.
        edge: usize,
        /// Share of the edge's length from its first vertex.
        s: Q,
    },
    /// A frictionless finger pushes on a circle towards its center, from this direction.
    Circle([Q; 2]),
    /// Gravity pulls this way in the plane of the tray.
    Tilt([Q; 2]),
    /// A wrench at the center of mass.
    Wrench([Q; 3]),
}
