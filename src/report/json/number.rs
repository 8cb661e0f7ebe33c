//! Exact numbers in JSON: an integer below 2^53, else a string.

use crate::exact::{Q, Z};
use num_traits::ToPrimitive as _;
use serde_json::Value;

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

pub(super) fn integers(row: &[Z]) -> Value {
    row.iter().map(integer).collect()
}

pub(super) fn rationals(row: &[Q]) -> Value {
    row.iter().map(rational).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::ratio;
    use serde_json::json;

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
}
