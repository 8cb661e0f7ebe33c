//! Vertices as integers over one common denominator.

use super::polygon::MAX_COORDINATE_BITS;
use crate::exact::{Q, Z};
use num_integer::Integer as _;
use num_traits::One as _;

/// Bits of all coordinates together, so that ten thousand vertices of a thousand digits each still fit in memory.
const MAX_TOTAL_BITS: u64 = 64 << 20;

/// Points `[x, y] / denominator`.
pub(super) struct Scaled {
    pub denominator: Z,
    pub points: Vec<[Z; 2]>,
}

/// Clears the denominators of `points`; the error is the number of bits that an integer would need at least.
pub(super) fn scale(points: &[[Q; 2]]) -> Result<Scaled, u64> {
    let n_coordinates = 2 * points.len() as u64;
    let limit = MAX_COORDINATE_BITS.min(MAX_TOTAL_BITS / n_coordinates.max(1));
    let mut denominator = Z::one();
    for value in points.iter().flatten() {
        if !value.is_integer() {
            denominator = denominator.lcm(value.denom());
            check(denominator.bits(), limit)?;
        }
    }
    let mut scaled = Vec::with_capacity(points.len());
    for [x, y] in points {
        let point = [x, y].map(|value| value.numer() * (&denominator / value.denom()));
        check(point[0].bits().max(point[1].bits()), limit)?;
        scaled.push(point);
    }
    Ok(Scaled { denominator, points: scaled })
}

fn check(bits: u64, limit: u64) -> Result<(), u64> {
    if bits > limit { Err(bits) } else { Ok(()) }
}

/// Twice the signed area of the closed chain `points`.
pub(super) fn doubled_area(points: &[[Z; 2]]) -> Z {
    (0..points.len()).map(|i| cross(&points[i], &points[(i + 1) % points.len()])).sum()
}

/// `a × b`.
pub(super) fn cross(a: &[Z; 2], b: &[Z; 2]) -> Z {
    &a[0] * &b[1] - &a[1] * &b[0]
}

/// `(b - a) × (c - a)`: positive when `a`, `b`, `c` turn left.
pub(super) fn turn(a: &[Z; 2], b: &[Z; 2], c: &[Z; 2]) -> Z {
    (&b[0] - &a[0]) * (&c[1] - &a[1]) - (&b[1] - &a[1]) * (&c[0] - &a[0])
}
