//! Numbers a + b √n in JSON: exact parts as strings, and thirty digits for those who need no more.

use crate::answer::SurdRatio;
use crate::exact::{Q, Surd, Z};
use num_traits::Signed as _;
use serde_json::{Value, json};

/// Significant digits of a decimal.
const DIGITS: i32 = 30;

/// `{"exact", "decimal"}` for a rational number, else `{"a", "b", "sqrt_of", "decimal"}`.
pub(super) fn surd(value: &Surd) -> Value {
    let decimal = decimal(value.to_f64(), |width| {
        let [low, high] = value.between(width);
        (low + high) / Q::from(Z::from(2))
    });
    match value.rational() {
        Some(exact) => json!({ "exact": exact.to_string(), "decimal": decimal }),
        None => {
            let [a, b, n] = value.parts().map(Q::to_string);
            json!({ "a": a, "b": b, "sqrt_of": n, "decimal": decimal })
        }
    }
}

/// As [`surd`], or `{"num", "den", "decimal"}` for a quotient of two fields.
pub(super) fn surd_ratio(value: &SurdRatio) -> Value {
    match value {
        SurdRatio::Number(number) => surd(number),
        SurdRatio::Quotient(above, below) => {
            let near = above.to_f64() / below.to_f64();
            let of = |width: &Q| {
                // digits to spare for the sizes of both
                let fine = width / Q::from(Z::from(10).pow(20));
                let [above, below] = [above, below].map(|number| {
                    let [low, high] = number.between(&fine);
                    (low + high) / Q::from(Z::from(2))
                });
                above / below
            };
            json!({ "num": surd(above), "den": surd(below), "decimal": decimal(near, of) })
        }
    }
}

/// Digits of a number near `near`, of which `number` gives a rational within a width.
fn decimal(near: f64, number: impl Fn(&Q) -> Q) -> String {
    if near == 0.0 || !near.is_finite() {
        return "0".to_owned();
    }
    let ten = |power: i32| {
        let whole = Q::from(Z::from(10).pow(power.unsigned_abs()));
        if power < 0 { whole.recip() } else { whole }
    };
    let first = near.abs().log10().floor() as i32;
    let value = number(&ten(first - DIGITS - 3));
    let places = DIGITS - 1 - first;
    let scaled = (value.abs() * ten(places)).round().to_integer();
    let mut text = scaled.to_string();
    let sign = if value.is_negative() { "-" } else { "" };
    if places <= 0 {
        return format!("{sign}{text}{}", "0".repeat(places.unsigned_abs() as usize));
    }
    let places = places as usize;
    if text.len() <= places {
        text.insert_str(0, &"0".repeat(places + 1 - text.len()));
    }
    text.insert(text.len() - places, '.');
    let text = text.trim_end_matches('0').trim_end_matches('.');
    format!("{sign}{text}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::ratio;
    use num_traits::Zero as _;

    #[test]
    fn decimals_have_thirty_digits() {
        let shown = |a, b, n| surd(&Surd::new(ratio(a, 3), ratio(b, 7), ratio(n, 5)));
        assert_eq!(shown(-8, 0, 0), json!({"exact": "-8/3", "decimal": "-2.66666666666666666666666666667"}));
        assert_eq!(shown(6, 0, 0), json!({"exact": "2", "decimal": "2"}));
        assert_eq!(
            shown(0, 7, 10),
            json!({"a": "0", "b": "1", "sqrt_of": "2", "decimal": "1.41421356237309504880168872421"})
        );
        assert_eq!(shown(1, 0, 0)["decimal"], "0.333333333333333333333333333333");
        assert_eq!(surd(&Surd::from(Q::zero()))["decimal"], "0");
        assert_eq!(surd(&Surd::from(ratio(12_345, 1)))["decimal"], "12345");
    }
}
