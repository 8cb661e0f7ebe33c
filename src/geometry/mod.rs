//! Exact planar geometry: polygons, their moments, hulls, points on their outline, and directions and tangents of angles.

mod circle;
mod direction;
mod hull;
mod moments;
mod outline;
mod polygon;
mod resting;
mod scaled;
mod simple;
mod tangent;

pub use circle::rational_point_on_circle;
pub use direction::direction_of_degrees;
pub use moments::Moments;
pub use outline::{Location, shortened};
pub use polygon::{MAX_COORDINATE_BITS, MAX_REPORTED_FAULTS, Polygon, PolygonFault};
pub use resting::{rests_on, symmetry_shift};
pub use tangent::{TangentEnclosure, tangent_of_degrees};

use crate::exact::Q;

/// `a × b`, positive when `b` is to the left of `a`.
#[must_use]
pub fn cross(a: &[Q; 2], b: &[Q; 2]) -> Q {
    &a[0] * &b[1] - &a[1] * &b[0]
}

/// `a · b`.
#[must_use]
pub fn dot(a: &[Q; 2], b: &[Q; 2]) -> Q {
    &a[0] * &b[0] + &a[1] * &b[1]
}

/// The vector from `a` to `b`.
#[must_use]
pub fn difference(a: &[Q; 2], b: &[Q; 2]) -> [Q; 2] {
    [&b[0] - &a[0], &b[1] - &a[1]]
}
