//! Area, centroid and polar second moment of a polygon by exact area integrals.

use super::polygon::Polygon;
use super::scaled::{self, Scaled};
use crate::exact::{Q, Z};
use num_traits::Zero as _;

/// Integrals over a plane figure.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Moments {
    /// Area (length²), positive.
    pub area: Q,
    /// Centroid `[x, y]`.
    pub centroid: [Q; 2],
    /// Polar second moment of area about the centroid (length⁴), positive.
    pub polar: Q,
}

impl Polygon {
    /// Area, centroid and polar second moment about the centroid.
    #[must_use]
    pub fn moments(&self) -> Moments {
        let Scaled { denominator, points } = self.scaled();
        let (mut area2, mut first, mut polar12) = (Z::zero(), [Z::zero(), Z::zero()], Z::zero());
        for i in 0..points.len() {
            let (a, b) = (&points[i], &points[(i + 1) % points.len()]);
            let wedge = scaled::cross(a, b);
            for axis in 0..2 {
                first[axis] += (&a[axis] + &b[axis]) * &wedge;
                polar12 += (&a[axis] * &a[axis] + &a[axis] * &b[axis] + &b[axis] * &b[axis]) * &wedge;
            }
            area2 += wedge;
        }
        let area = Q::new(area2.clone(), 2 * &denominator * &denominator);
        let centroid = first.map(|sum| Q::new(sum, 3 * &area2 * &denominator));
        let about_origin = Q::new(polar12, 12 * denominator.pow(4));
        let offset2 = &centroid[0] * &centroid[0] + &centroid[1] * &centroid[1];
        let polar = about_origin - &area * offset2;
        Moments { area, centroid, polar }
    }
}
