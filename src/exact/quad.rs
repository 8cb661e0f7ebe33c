//! Signed integers of 256 bits: what dot products and combinations of `i128` rows need.

use super::Z;
use std::cmp::Ordering;

/// Two's complement; the least value does not occur.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Quad {
    high: i128,
    low: u128,
}

impl From<i128> for Quad {
    fn from(value: i128) -> Self {
        Self { high: value >> 127, low: value.cast_unsigned() }
    }
}

impl From<Quad> for Z {
    fn from(value: Quad) -> Self {
        (Self::from(value.high) << 128_u32) + value.low
    }
}

impl Quad {
    pub(super) fn sign(&self) -> Ordering {
        self.high.cmp(&0).then(if self.low == 0 { Ordering::Equal } else { Ordering::Greater })
    }

    pub(super) fn negated(&self) -> Self {
        let (low, carry) = (!self.low).overflowing_add(1);
        Self { high: (!self.high).wrapping_add(i128::from(carry)), low }
    }

    /// `upper 2^64 + lower`.
    fn of_parts(upper: i128, lower: u128) -> Self {
        let (low, carry) = (upper.cast_unsigned() << 64).overflowing_add(lower);
        Self { high: (upper >> 64) + i128::from(carry), low }
    }

    /// `a · b`, if it fits.
    pub(super) fn dot(a: &[i128], b: &[i128]) -> Option<Self> {
        const HALF: i128 = 1 << 62;
        let is_short = |value: &i128| (-HALF..HALF).contains(value);
        if !a.iter().all(is_short) {
            let mut sum = Self::from(0);
            for (x, y) in a.iter().zip(b) {
                sum = sum.plus(&Self::product(*x, *y))?;
            }
            return Some(sum);
        }
        let (mut upper, mut lower) = (0_i128, 0_u128);
        for (x, y) in a.iter().zip(b) {
            let below = x * (y.cast_unsigned() & u128::from(u64::MAX)).cast_signed();
            upper = upper.checked_add(x * (y >> 64))?.checked_add(below >> 64)?;
            lower += below.cast_unsigned() & u128::from(u64::MAX);
        }
        Some(Self::of_parts(upper, lower))
    }

    /// `p x + q y`; entries above the least one leave room for the sum.
    pub(super) fn combination(p: i128, x: i128, q: i128, y: i128) -> Self {
        if let (Some(left), Some(right)) = (p.checked_mul(x), q.checked_mul(y))
            && let Some(sum) = left.checked_add(right)
        {
            return sum.into();
        }
        Self::product(p, x).wrapping_plus(&Self::product(q, y)).0
    }

    pub(super) fn product(a: i128, b: i128) -> Self {
        if let Some(product) = a.checked_mul(b) {
            return product.into();
        }
        let (x, y) = (a.unsigned_abs(), b.unsigned_abs());
        let halves = |value: u128| (value >> 64, value & u128::from(u64::MAX));
        let ((x1, x0), (y1, y0)) = (halves(x), halves(y));
        let (cross, carry) = (x1 * y0).overflowing_add(x0 * y1);
        let (low, low_carry) = (x0 * y0).overflowing_add(cross << 64);
        let high = x1 * y1 + (cross >> 64) + (u128::from(carry) << 64) + u128::from(low_carry);
        let magnitude = Self { high: high.cast_signed(), low };
        if (a < 0) == (b < 0) { magnitude } else { magnitude.negated() }
    }

    fn wrapping_plus(&self, other: &Self) -> (Self, bool) {
        let (low, carry) = self.low.overflowing_add(other.low);
        let (high, first) = self.high.overflowing_add(other.high);
        let (high, second) = high.overflowing_add(i128::from(carry));
        (Self { high, low }, first != second)
    }

    fn plus(&self, other: &Self) -> Option<Self> {
        let (sum, is_over) = self.wrapping_plus(other);
        (!is_over && (sum.high, sum.low) != (i128::MIN, 0)).then_some(sum)
    }

    /// The value if it fits and is not the least `i128`.
    pub(super) fn narrow(&self) -> Option<i128> {
        let low = self.low.cast_signed();
        (self.high == low >> 127 && low != i128::MIN).then_some(low)
    }

    /// The words of the magnitude, least first.
    pub(super) fn magnitude(&self) -> [u64; 4] {
        let Self { high, low } = if self.high < 0 { self.negated() } else { *self };
        [low as u64, (low >> 64) as u64, high as u64, (high >> 64) as u64]
    }
}
