//! Intervals of doubles, rounded outward: they decide what is far from zero and never anything else.

use super::{Q, Z};
use num_traits::ToPrimitive as _;
use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A closed interval of doubles that holds a real number, however operations were rounded; it may be unbounded.
///
/// # Examples
/// ```
/// use partplan::exact::{FloatInterval, ratio};
/// let third = FloatInterval::of_rational(&ratio(1, 3));
/// let x = third + third + third;
/// assert_eq!(x.sign(), Some(std::cmp::Ordering::Greater));
/// assert_eq!((x - FloatInterval::of_rational(&ratio(1, 1))).sign(), None);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FloatInterval {
    /// Never plus infinity.
    low: f64,
    /// Never minus infinity.
    high: f64,
}

impl FloatInterval {
    /// Of an integer; exact up to 2^53.
    #[must_use]
    pub fn of_integer(value: &Z) -> Self {
        let nearest = value.to_f64().unwrap_or(f64::NAN);
        let exact = Self { low: nearest, high: nearest };
        if nearest.abs() <= EXACT { exact } else { exact.widened() }
    }

    /// Of a rational.
    #[must_use]
    pub fn of_rational(value: &Q) -> Self {
        let [numerator, denominator] = within_range(value);
        if denominator.low == 1.0 && denominator.high == 1.0 {
            return numerator;
        }
        // the denominator is at least one
        hull(numerator.pairs(denominator).map(|(a, b)| a / b))
    }

    /// Of all numbers between two rationals, the first of them not greater.
    #[must_use]
    pub fn between(low: &Q, high: &Q) -> Self {
        Self { low: Self::of_rational(low).low, high: Self::of_rational(high).high }
    }

    /// Of all numbers between two doubles, the first of them not greater.
    ///
    /// # Panics
    /// If one of them is not a number.
    #[must_use]
    pub fn from_ends(low: f64, high: f64) -> Self {
        assert!(low <= high, "the ends of an interval are in order");
        Self { low, high }
    }

    /// The ends.
    #[must_use]
    pub fn ends(self) -> [f64; 2] {
        [self.low, self.high]
    }

    /// The sign of every number inside, as a comparison with zero, if it is one.
    #[must_use]
    pub fn sign(self) -> Option<Ordering> {
        match (self.low, self.high) {
            (low, _) if low > 0.0 => Some(Ordering::Greater),
            (_, high) if high < 0.0 => Some(Ordering::Less),
            (low, high) if low == 0.0 && high == 0.0 => Some(Ordering::Equal),
            _ => None,
        }
    }

    fn pairs(self, other: Self) -> [(f64, f64); 4] {
        [(self.low, other.low), (self.low, other.high), (self.high, other.low), (self.high, other.high)]
    }

    /// One double further on both sides, which covers the rounding of one operation to nearest.
    fn widened(self) -> Self {
        Self { low: self.low.next_down(), high: self.high.next_up() }
    }
}

/// Unbounded if the divisor may be zero.
impl Div for FloatInterval {
    type Output = Self;

    fn div(self, divisor: Self) -> Self {
        match divisor.sign() {
            Some(Ordering::Less | Ordering::Greater) => hull(self.pairs(divisor).map(|(a, b)| a / b)),
            _ => Self { low: f64::NEG_INFINITY, high: f64::INFINITY },
        }
    }
}

/// Integers up to 2^53 are doubles.
const EXACT: f64 = 9_007_199_254_740_992.0;

/// The least interval that holds the results of one operation on ends.
///
/// `0 · ∞` and `∞ / ∞` arise from an end that stands for some finite number; zero in their place keeps the hull right.
/// Numerator and denominator. Where doubles do not reach as far, both over the same power of two: what that cuts off is
/// less than the rounding that the intervals allow for.
fn within_range(value: &Q) -> [FloatInterval; 2] {
    const REACH: u64 = 1_000;
    const PRECISE: u64 = 64;
    let parts = [value.numer(), value.denom()];
    let [more, fewer] = [parts[0].bits().max(parts[1].bits()), parts[0].bits().min(parts[1].bits())];
    let cut = more.saturating_sub(REACH).min(fewer.saturating_sub(PRECISE));
    if cut == 0 {
        parts.map(FloatInterval::of_integer)
    } else {
        parts.map(|part| FloatInterval::of_integer(&(part >> cut)))
    }
}

fn hull(results: [f64; 4]) -> FloatInterval {
    let results = results.map(|value| if value.is_nan() { 0.0 } else { value });
    let low = results.into_iter().fold(f64::INFINITY, f64::min);
    let high = results.into_iter().fold(f64::NEG_INFINITY, f64::max);
    FloatInterval { low, high }.widened()
}

impl Add for FloatInterval {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { low: self.low + other.low, high: self.high + other.high }.widened()
    }
}

impl Sub for FloatInterval {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Neg for FloatInterval {
    type Output = Self;

    fn neg(self) -> Self {
        Self { low: -self.high, high: -self.low }
    }
}

impl Mul for FloatInterval {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        hull(self.pairs(other).map(|(a, b)| a * b))
    }
}
