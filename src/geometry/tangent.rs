//! Tangents of angles in degrees, enclosed between rationals.

use crate::exact::{Q, Z, approximate, ratio};
use num_traits::{One as _, Signed as _, Zero as _};

/// Rational bounds of a tangent.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TangentEnclosure {
    /// At most the tangent, not negative.
    pub lower: Q,
    /// At least the tangent, and at most 1e-12 above [`TangentEnclosure::lower`].
    pub upper: Q,
}

/// Bounds of the tangent of `degrees`, short rationals at most 1e-12 apart; exact at 0 and 45 degrees.
///
/// π by Machin's formula and sine and cosine by their series in fixed-point integers with counted rounding errors,
/// at doubled precision until the bounds are close enough. `None` unless 0 <= `degrees` < 90.
///
/// # Examples
/// ```
/// use partplan::{exact::ratio, geometry::tangent_of_degrees};
/// let sixty = tangent_of_degrees(&ratio(60, 1)).unwrap();
/// assert!(&sixty.lower * &sixty.lower < ratio(3, 1) && ratio(3, 1) < &sixty.upper * &sixty.upper);
/// ```
#[must_use]
pub fn tangent_of_degrees(degrees: &Q) -> Option<TangentEnclosure> {
    let (right_angle, half) = (ratio(90, 1), ratio(45, 1));
    if degrees.is_negative() || *degrees >= right_angle {
        return None;
    }
    if degrees.is_zero() || *degrees == half {
        let value = if degrees.is_zero() { Q::zero() } else { Q::one() };
        return Some(TangentEnclosure { lower: value.clone(), upper: value });
    }
    let is_steep = *degrees > half;
    let acute = if is_steep { right_angle - degrees } else { degrees.clone() };
    let mut bits = 128;
    let [lower, upper] = loop {
        let bounds = small_tangent(&acute, bits);
        let bounds = if is_steep { reciprocals(bounds) } else { Some(bounds) };
        if let Some(bounds) = bounds
            && &bounds[1] - &bounds[0] <= ratio(1, 10_000_000_000_000)
        {
            break bounds;
        }
        bits *= 2;
    };
    // twice 4e-13 of rounding and 1e-13 of doubt stay within 1e-12
    let slack = ratio(1, 5_000_000_000_000);
    let lower = approximate(&(lower - &slack), &slack).max(Q::zero());
    let upper = approximate(&(upper + &slack), &slack);
    Some(TangentEnclosure { lower, upper })
}

/// Bounds of the tangent of `degrees` in (0, 45) from fixed-point numbers with `bits` places.
fn small_tangent(degrees: &Q, bits: usize) -> [Q; 2] {
    let unit = Z::one() << bits;
    let [pi_low, pi_high] = pi(bits);
    let angle_low = (degrees * Q::from(pi_low)).floor().to_integer() / 180;
    let angle_high = (degrees * Q::from(pi_high)).ceil().to_integer() / 180 + 1;
    let (low, high) = (Series::new(&angle_low, bits), Series::new(&angle_high, bits));
    let lower = Q::new((low.sine - &low.error).max(Z::zero()), low.cosine + low.error);
    // the cosine of at most 45 degrees is far above the error
    let upper = Q::new(high.sine + &high.error, (high.cosine - high.error).max(unit >> 1));
    [lower, upper]
}

fn reciprocals([lower, upper]: [Q; 2]) -> Option<[Q; 2]> {
    lower.is_positive().then(|| [upper.recip(), lower.recip()])
}

/// Sine and cosine of one fixed-point angle in [0, 1), each within `error` units.
pub(super) struct Series {
    pub(super) sine: Z,
    pub(super) cosine: Z,
    pub(super) error: Z,
}

impl Series {
    pub(super) fn new(angle: &Z, bits: usize) -> Self {
        let square: Z = (angle * angle) >> bits;
        let (mut sums, mut n_terms) = ([Z::zero(), Z::zero()], 0_u32);
        for (sum, first, start) in [(0, Z::one() << bits, 1_u32), (1, angle.clone(), 2)] {
            let (mut term, mut factor) = (first, start);
            let mut is_negative = false;
            while !term.is_zero() {
                if is_negative {
                    sums[sum] -= &term
                } else {
                    sums[sum] += &term
                }
                term = ((term * &square) >> bits) / (Z::from(factor) * (factor + 1));
                factor += 2;
                is_negative = !is_negative;
                n_terms += 1;
            }
        }
        let [cosine, sine] = sums;
        // the error of a term is at most e / 2 + 2 where e is its predecessor's: never above 4 units; the first
        // omitted term, which bounds the alternating rest, is below 4 + 1
        Self { sine, cosine, error: Z::from(4 * n_terms + 8) }
    }
}

/// Fixed-point bounds of π: 16 arctan(1/5) - 4 arctan(1/239) (Machin 1706).
pub(super) fn pi(bits: usize) -> [Z; 2] {
    let (fifth, fifth_terms) = arctangent_of_reciprocal(5, bits);
    let (other, other_terms) = arctangent_of_reciprocal(239, bits);
    let value = 16 * fifth - 4 * other;
    let error = 16 * fifth_terms + 4 * other_terms;
    [&value - error, &value + error]
}

/// arctan(1/n) by its series, and how many units the sum may be off.
fn arctangent_of_reciprocal(n: u32, bits: usize) -> (Z, u32) {
    let (mut sum, mut power) = (Z::zero(), (Z::one() << bits) / n);
    let (mut odd, mut error) = (1_u32, 2_u32);
    while !power.is_zero() {
        let term = &power / odd;
        if odd % 4 == 1 {
            sum += term
        } else {
            sum -= term
        }
        power /= n * n;
        odd += 2;
        // floor of the power (off by less than 2 units in all) and of the quotient
        error += 3;
    }
    (sum, error)
}
