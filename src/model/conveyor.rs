//! A conveyor that carries parts past fixed pins.

use super::Range;

/// What a `pins` section says.
///
/// Parts ride in +x with a hull edge flat on the belt, and every value in the ranges is possible.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Conveyor {
    /// Coulomb coefficient μ_t between part and belt.
    pub belt_friction: Range,
    /// Coulomb coefficient μ_p between part and pin.
    pub pin_friction: Range,
}
