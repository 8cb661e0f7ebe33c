//! An arm that throws parts and catches them.

use super::Range;
use crate::exact::Q;

/// What a `throw` section says.
///
/// The arm pivots about the origin; at rest its surface is the ray x ≥ 0 at the height `offset`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Thrower {
    /// Offset h of the surface from the pivot (length), of either sign.
    pub offset: Q,
    /// Speed of the arm at release (degrees per second), positive.
    pub release_deg_per_s: Q,
    /// Gravity |g| (length/s²), positive.
    pub gravity: Q,
    /// Coulomb coefficient μ between part and arm, if it is known.
    pub friction: Option<Range>,
}
