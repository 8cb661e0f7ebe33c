//! Numbers that the throw map is computed in: doubles, and intervals that enclose what doubles round.

use crate::exact::{FloatInterval, Q, Surd, to_f64};
use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number that may not be known well enough to be compared.
pub trait Real:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// Of a rational.
    fn of(value: &Q) -> Self;

    /// Of a number a + b √n.
    fn of_surd(value: &Surd) -> Self;

    /// Of a double.
    fn double(value: f64) -> Self;

    /// The circle number.
    fn pi() -> Self;

    /// The square root of what is not negative.
    fn sqrt(self) -> Self;

    /// Sine and cosine.
    fn sin_cos(self) -> [Self; 2];

    /// The sign, if it is known.
    fn sign(self) -> Option<Ordering>;

    /// Whether it is above the other, if that is known.
    fn exceeds(self, other: Self) -> Option<bool> {
        (self - other).is_positive()
    }

    /// Whether it is above zero, if that is known.
    fn is_positive(self) -> Option<bool>;
}

impl Real for f64 {
    fn of(value: &Q) -> Self {
        to_f64(value)
    }

    fn of_surd(value: &Surd) -> Self {
        value.to_f64()
    }

    fn double(value: f64) -> Self {
        value
    }

    fn pi() -> Self {
        std::f64::consts::PI
    }

    fn sqrt(self) -> Self {
        Self::sqrt(self)
    }

    fn sin_cos(self) -> [Self; 2] {
        libm::sincos(self).into()
    }

    fn sign(self) -> Option<Ordering> {
        self.partial_cmp(&0.0)
    }

    fn is_positive(self) -> Option<bool> {
        Some(self > 0.0)
    }
}

impl Real for FloatInterval {
    fn of(value: &Q) -> Self {
        Self::of_rational(value)
    }

    fn of_surd(value: &Surd) -> Self {
        value.enclosure()
    }

    fn double(value: f64) -> Self {
        Self::of_double(value)
    }

    fn pi() -> Self {
        Self::pi()
    }

    fn sqrt(self) -> Self {
        self.sqrt()
    }

    fn sin_cos(self) -> [Self; 2] {
        self.sin_cos()
    }

    fn sign(self) -> Option<Ordering> {
        self.sign()
    }

    fn is_positive(self) -> Option<bool> {
        match self.ends() {
            [low, _] if low > 0.0 => Some(true),
            [_, high] if high <= 0.0 => Some(false),
            _ => None,
        }
    }
}
