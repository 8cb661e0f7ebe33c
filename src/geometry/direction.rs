//! Cosines and sines of angles in degrees, enclosed between rationals.

use super::tangent::{Series, pi};
use crate::exact::{Q, Z, ratio};
use num_integer::Integer as _;
use num_traits::{One as _, Zero as _};

/// Rational bounds of the cosine, then of the sine, of `degrees`; exact at multiples of 90 degrees.
///
/// Bounds come from series in fixed-point integers with `bits` places and counted rounding errors: their width is some
/// hundred units of the last place.
///
/// # Examples
/// ```
/// use partplan::{exact::ratio, geometry::direction_of_degrees};
/// let [[cosine, _], [sine, _]] = direction_of_degrees(&ratio(-450, 1), 64);
/// assert_eq!((cosine, sine), (ratio(0, 1), ratio(-1, 1)));
/// ```
#[must_use]
pub fn direction_of_degrees(degrees: &Q, bits: usize) -> [[Q; 2]; 2] {
    let right_angle = ratio(90, 1);
    let quarters = (degrees / &right_angle).floor();
    let acute = degrees - &quarters * &right_angle;
    let [cosine, sine] = acute_direction(&acute, bits);
    // turned by right angles
    match quarters.to_integer().mod_floor(&Z::from(4)) {
        turns if turns.is_zero() => [cosine, sine],
        turns if turns.is_one() => [opposite(sine), cosine],
        turns if turns == Z::from(2) => [opposite(cosine), opposite(sine)],
        _ => [sine, opposite(cosine)],
    }
}

fn opposite([low, high]: [Q; 2]) -> [Q; 2] {
    [-high, -low]
}

/// Bounds of cosine and sine of an angle in [0, 90).
fn acute_direction(degrees: &Q, bits: usize) -> [[Q; 2]; 2] {
    if degrees.is_zero() {
        return [[Q::one(), Q::one()], [Q::zero(), Q::zero()]];
    }
    if *degrees > ratio(45, 1) {
        let [cosine, sine] = acute_direction(&(ratio(90, 1) - degrees), bits);
        return [sine, cosine];
    }
    let [pi_low, pi_high] = pi(bits);
    let low = (degrees * Q::from(pi_low)).floor().to_integer() / 180;
    let high = (degrees * Q::from(pi_high)).ceil().to_integer() / 180 + 1;
    let (low, high) = (Series::new(&low, bits), Series::new(&high, bits));
    let unit = Z::one() << bits;
    let bounds =
        |from: Z, to: Z| [Q::new(from.max(Z::zero()), unit.clone()), Q::new(to.min(unit.clone()), unit.clone())];
    [bounds(high.cosine - &high.error, low.cosine + &low.error), bounds(low.sine - low.error, high.sine + high.error)]
}
