//! Wrenches in coordinates where the norm is Euclidean, in floating point.

use crate::exact::{Int, Q, Z, primitive_row, to_f64};
use num_traits::{Signed, ToPrimitive as _, Zero};

/// The coordinates (fx, fy, torque / ρ).
///
/// Torques are first counted in a power of ten near ρ, so that no length is too large or small for a double.
pub(super) struct Frame {
    unit: Q,
    /// ρ in that unit, between 1/2 and 20, so that a largest coordinate does not round to zero.
    rho: f64,
}

impl Frame {
    pub(super) fn of(rho2: &Q) -> Self {
        let bits = |z: &Z| i32::try_from(z.bits()).expect("literals have a bounded exponent");
        let decades = f64::from(bits(rho2.numer()) - bits(rho2.denom())) * (2.0_f64.log10() / 2.0);
        let decades = decades.floor() as i32;
        let power = Q::from(Z::from(10).pow(decades.unsigned_abs()));
        let unit = if decades < 0 { power.recip() } else { power };
        let rho = to_f64(&(rho2 / (&unit * &unit))).sqrt();
        Self { unit, rho }
    }

    /// The direction of a wrench as a unit vector, each entry off by a few ulp of 1 at most.
    pub(super) fn unit(&self, wrench: &[Z; 3]) -> [f64; 3] {
        let exact = |axis: usize| Q::from(wrench[axis].clone());
        let [x, y, torque] = shares([exact(0), exact(1), exact(2) / &self.unit]);
        normalized([x, y, torque / self.rho])
    }

    /// The direction of a face normal `h`, `h · g ≤ 0`, in the dual coordinates.
    pub(super) fn dual(&self, normal: &[Z; 3]) -> [f64; 3] {
        let exact = |axis: usize| Q::from(normal[axis].clone());
        let [x, y, torque] = shares([exact(0), exact(1), exact(2) * &self.unit]);
        normalized([x, y, torque * self.rho])
    }

    /// A rational wrench near `direction`, its coordinates rounded to `digits` decimals: coprime integers.
    pub(super) fn wrench(&self, direction: &[f64; 3], digits: u32) -> [Z; 3] {
        let [x, y, torque] = direction;
        let largest = direction.iter().fold(0.0_f64, |most, v| most.max(v.abs()));
        let scale = 10.0_f64.powi(digits as i32) / largest;
        let rounded = |value: f64| Q::from(Z::from((value * scale).round().to_i64().unwrap_or(0)));
        let row = primitive_row(&[rounded(*x), rounded(*y), rounded(torque * self.rho) * &self.unit]);
        <[Z; 3]>::try_from(row).expect("wrenches have three components")
    }
}

/// A row of wrench space in integers of any size.
pub(super) fn exact<T: Int>(row: &[T]) -> [Z; 3] {
    [0, 1, 2].map(|axis| row[axis].to_z())
}

/// Entries over the largest of them.
fn shares(row: [Q; 3]) -> [f64; 3] {
    let largest = row.iter().map(Signed::abs).max().unwrap_or_else(Q::zero);
    if largest.is_zero() {
        return [0.0; 3];
    }
    row.map(|value| to_f64(&(value / &largest)))
}

pub(super) fn normalized(v: [f64; 3]) -> [f64; 3] {
    let length = dot(&v, &v).sqrt();
    if length > 0.0 { v.map(|value| value / length) } else { v }
}

pub(in crate::planner) fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
