//! Small helpers around rationals: construction, decimal views, short approximations.

use super::gcd::gcd;
use super::{Q, Z};
use num_traits::{One, Signed, ToPrimitive, Zero};

/// The rational `numerator / denominator`.
///
/// # Panics
/// If `denominator` is zero.
#[must_use]
pub fn ratio(numerator: i64, denominator: i64) -> Q {
    Q::new(Z::from(numerator), Z::from(denominator))
}

/// `a · b`.
#[must_use]
pub fn dot(a: &[Q], b: &[Q]) -> Q {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// The nearest double, for pictures and decimal views only; huge values saturate.
#[must_use]
pub fn to_f64(value: &Q) -> f64 {
    if let Some(near) = value.to_f64().filter(|v| v.is_finite()) {
        return near;
    }
    if value.is_negative() { f64::MIN } else { f64::MAX }
}

/// The rational that a finite double denotes exactly; `None` for NaN and infinities.
#[must_use]
pub fn from_float_exact(value: f64) -> Option<Q> {
    Q::from_float(value)
}

/// A rational within `tolerance` of `value` with the smallest denominator (a walk down the Stern-Brocot tree).
///
/// # Panics
/// If `tolerance` is not positive.
#[must_use]
pub fn approximate(value: &Q, tolerance: &Q) -> Q {
    assert!(tolerance.is_positive(), "an approximation needs a positive tolerance");
    simplest_between(&(value - tolerance), &(value + tolerance))
}

fn simplest_between(low: &Q, high: &Q) -> Q {
    if !low.is_positive() {
        return if high.is_negative() { -simplest_between(&-high, &-low) } else { Q::zero() };
    }
    let mut whole_parts = Vec::new();
    let (mut low, mut high) = (low.clone(), high.clone());
    let mut value = loop {
        let ceiling = low.ceil();
        if ceiling <= high {
            break ceiling;
        }
        let whole = low.floor();
        let (next_low, next_high) = ((high - &whole).recip(), (low - &whole).recip());
        whole_parts.push(whole);
        (low, high) = (next_low, next_high);
    };
    while let Some(whole) = whole_parts.pop() {
        value = whole + value.recip();
    }
    value
}

/// `numerator / denominator`, reduced.
///
/// # Panics
/// If the denominator is not positive.
#[must_use]
pub fn fraction(numerator: Z, denominator: Z) -> Q {
    assert!(denominator.is_positive(), "a fraction has a positive denominator");
    let divisor = gcd(&numerator.abs(), &denominator);
    if divisor.is_one() {
        return Q::new_raw(numerator, denominator);
    }
    Q::new_raw(numerator / &divisor, denominator / divisor)
}

/// The sum, by halves: what is added has about the same length.
#[must_use]
pub fn sum(mut values: Vec<Q>) -> Q {
    while values.len() > 1 {
        values = values.chunks(2).map(|pair| if let [a, b] = pair { added(a, b) } else { pair[0].clone() }).collect();
    }
    values.pop().unwrap_or_else(Q::zero)
}

fn added(a: &Q, b: &Q) -> Q {
    let common = gcd(a.denom(), b.denom());
    let (left, right) = (a.denom() / &common, b.denom() / &common);
    let numerator = a.numer() * &right + b.numer() * &left;
    // reduced fractions: what divides the sum and both denominators' multiple divides their common divisor
    let divisor = gcd(&numerator.abs(), &common);
    Q::new_raw(numerator / &divisor, left * (b.denom() / divisor))
}
