//! Exact numbers in JSON: an integer below 2^53, else a string.

use crate::exact::{Algebraic, Q, Z, from_float_exact};
use crate::model::Range;
use num_traits::{Signed as _, ToPrimitive as _};
use serde_json::{Value, json};

/// From here on not every integer is a double, so readers of JSON may round.
const FIRST_UNSAFE: u64 = 1 << 53;

/// An integer: a number below 2^53 in absolute value, else its digits.
pub(super) fn integer(value: &Z) -> Value {
    match value.to_i64() {
        Some(small) if small.unsigned_abs() < FIRST_UNSAFE => small.into(),
        _ => value.to_string().into(),
    }
}

/// A rational: as [`integer`] if it is one, else `"p/q"`.
pub(super) fn rational(value: &Q) -> Value {
    if value.is_integer() { integer(value.numer()) } else { value.to_string().into() }
}

/// A range: its value if it holds one only, else its ends.
pub(super) fn range(range: &Range) -> Value {
    if range.min == range.max {
        return rational(&range.min);
    }
    json!({ "min": rational(&range.min), "max": rational(&range.max) })
}

/// A real algebraic number: as [`rational`] if it is one, else as [`root`] with bounds that are less than `1e-20` of it
/// apart.
pub(super) fn algebraic(value: &Algebraic) -> Value {
    value.rational().as_ref().map_or_else(
        || {
            let near = from_float_exact(value.to_f64()).unwrap_or_default();
            root(value, &(near.abs() / Q::from(Z::from(1) << 68_u32)))
        },
        rational,
    )
}

/// A root of a polynomial, isolated by bounds at most `width` apart.
///
/// `value` is a decimal for those who need no more: a number, the double nearest to the root or next to that; what is
/// exact is the root of `polynomial`, coefficients from the constant on, between `lower` and `upper`.
pub(super) fn root(value: &Algebraic, width: &Q) -> Value {
    let [lower, upper] = short_bounds(value, width);
    json!({
        "value": value.to_f64(),
        "lower": rational(&lower),
        "upper": rational(&upper),
        "polynomial": integers(value.polynomial().coefficients()),
    })
}

/// Decimals about the root where these isolate it as well as bounds with any denominator.
fn short_bounds(value: &Algebraic, width: &Q) -> [Q; 2] {
    let bounds = value.enclosure(&(width / Q::from(Z::from(2))));
    let mut step = Q::from(Z::from(1));
    while &step * Q::from(Z::from(4)) > *width {
        step /= Q::from(Z::from(10));
    }
    let [lower, upper] = &bounds;
    let short = [(lower / &step).floor() * &step, (upper / &step).ceil() * &step];
    let [lower, upper] = short.each_ref();
    let roots = value.polynomial().real_roots(lower.clone()..=upper.clone()).unwrap_or_default();
    if roots.len() == 1 && roots[0] > *lower && roots[0] < *upper { short } else { bounds }
}

pub(super) fn integers(row: &[Z]) -> Value {
    row.iter().map(integer).collect()
}

pub(super) fn rationals(row: &[Q]) -> Value {
    row.iter().map(rational).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::{Polynomial, parse_literal, ratio};

    #[test]
    fn integers_turn_into_strings_where_doubles_end() {
        let limit = Z::from(1_i64 << 53);
        assert_eq!(integer(&(limit.clone() - 1)), json!(9_007_199_254_740_991_i64));
        assert_eq!(integer(&limit), json!("9007199254740992"));
        assert_eq!(integer(&(1 - limit.clone())), json!(-9_007_199_254_740_991_i64));
        assert_eq!(integer(&-limit), json!("-9007199254740992"));
        assert_eq!(integer(&Z::from(10).pow(30)), json!("1000000000000000000000000000000"));
    }

    #[test]
    fn rationals_keep_their_value() {
        assert_eq!(rational(&ratio(-5, 2)), json!("-5/2"));
        assert_eq!(rational(&ratio(6, 3)), json!(2));
        assert_eq!(rational(&ratio(0, 7)), json!(0));
    }

    #[test]
    fn roots_are_isolated_by_close_bounds_and_rational_ones_are_rationals() {
        let square = Polynomial::from([-2, 0, 1]).real_roots(ratio(0, 1)..).unwrap().remove(0);
        let shown = algebraic(&square);
        assert_eq!(shown["polynomial"], json!([-2, 0, 1]));
        assert!((shown["value"].as_f64().unwrap() - 2_f64.sqrt()).abs() <= f64::EPSILON);
        let [lower, upper] = ["lower", "upper"].map(|end| parse_literal(shown[end].as_str().unwrap()).unwrap());
        assert!(&lower * &lower < ratio(2, 1) && &upper * &upper > ratio(2, 1));
        assert!((&upper - &lower) * Q::from(Z::from(10).pow(20)) <= lower);
        // 2 x³ - 3 x² - 4 x + 6 = (x² - 2) (2 x - 3)
        let roots = Polynomial::from([6, -4, -3, 2]).real_roots(..).unwrap();
        assert_eq!(roots.iter().map(algebraic).filter(|shown| *shown == json!("3/2")).count(), 1);
        assert_eq!(algebraic(&ratio(0, 1).into()), json!(0));
    }
}
