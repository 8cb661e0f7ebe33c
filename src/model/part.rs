//! The rigid planar part that every task moves.

use crate::exact::Q;
use crate::geometry::Polygon;
use num_traits::{Signed, Zero};

/// A rigid planar part; lengths in [`Part::unit`], any unit of mass.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Part {
    /// Unit of every length in the case.
    pub unit: LengthUnit,
    /// Outline.
    pub shape: Shape,
    /// Center of mass `[x, y]`.
    pub center_of_mass: [Q; 2],
    /// Half-width of the square in which the center of mass may lie; zero when it is known.
    pub center_of_mass_tolerance: Q,
    /// Mass, positive.
    pub mass: Q,
    /// Moment of inertia about the center of mass (mass · length²), positive.
    pub inertia: Q,
}

impl Part {
    /// Squared radius of gyration, inertia / mass (length²): the only inertia that wrench cones depend on.
    #[must_use]
    pub fn gyration2(&self) -> Q {
        &self.inertia / &self.mass
    }

    /// Largest coordinate distance of the outline from the center of mass (length): volumes of wrench sets are measured
    /// in the box `|fx| ≤ 1, |fy| ≤ 1, |torque| ≤ reach`.
    #[must_use]
    pub fn torque_reach(&self) -> Q {
        let com = &self.center_of_mass;
        let distance = |point: &[Q; 2], axis: usize| (&point[axis] - &com[axis]).abs();
        let farthest = |point: &[Q; 2]| distance(point, 0).max(distance(point, 1));
        match &self.shape {
            Shape::Polygon(polygon) => polygon.vertices().iter().map(farthest).max().unwrap_or_else(Q::zero),
            Shape::Circle { center, radius } => farthest(center) + radius,
        }
    }
}

/// Outline of a part.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Shape {
    /// A simple polygon, counter-clockwise.
    Polygon(Polygon),
    /// A disc.
    Circle {
        /// Center `[x, y]`.
        center: [Q; 2],
        /// Radius, positive.
        radius: Q,
    },
}

/// Unit of length of a case: sets labels and the default gravity, nothing else.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum LengthUnit {
    /// Metre.
    #[default]
    Metre,
    /// Centimetre.
    Centimetre,
    /// Millimetre.
    Millimetre,
}

impl LengthUnit {
    /// Metres to the unit.
    #[must_use]
    pub fn metres(self) -> Q {
        let parts = match self {
            Self::Metre => 1,
            Self::Centimetre => 100,
            Self::Millimetre => 1000,
        };
        Q::new(1.into(), parts.into())
    }

    /// The symbol as case files write it.
    #[must_use]
    pub fn symbol(self) -> &'static str {
        match self {
            Self::Metre => "m",
            Self::Centimetre => "cm",
            Self::Millimetre => "mm",
        }
    }
}
