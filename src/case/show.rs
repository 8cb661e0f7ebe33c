//! Short views of values for messages; never read back.

use crate::exact::{Q, to_f64};

const MAX_SHOWN: usize = 40;

/// `text` with control characters escaped, cut where it is long.
pub(super) fn clipped(text: &str) -> String {
    let mut shown: String = text.chars().take(MAX_SHOWN).flat_map(char::escape_debug).collect();
    if text.chars().nth(MAX_SHOWN).is_some() {
        shown.push('…');
    }
    shown
}

/// `value` exactly where that is short, else in decimal.
pub(super) fn number(value: &Q) -> String {
    let bits = value.numer().bits() + value.denom().bits();
    if bits > 96 {
        return decimal(value);
    }
    terminating(value).unwrap_or_else(|| {
        let text = value.to_string();
        if text.len() <= 16 { text } else { decimal(value) }
    })
}

/// A point or vector, as [`number`].
pub(super) fn point([x, y]: &[Q; 2]) -> String {
    format!("[{}, {}]", number(x), number(y))
}

/// The square root of `value`, rounded.
pub(super) fn distance(squared: &Q) -> String {
    significant(to_f64(squared).sqrt(), 3)
}

fn decimal(value: &Q) -> String {
    let bits = i128::from(value.numer().bits()) - i128::from(value.denom().bits());
    if bits.abs() < 1000 {
        return significant(to_f64(value), 12);
    }
    // beyond doubles: a factor that brings the value near 1, then its decimal view
    let power = i32::try_from(bits * 30103 / 100_000).unwrap_or(i32::MAX);
    let near_one = to_f64(&(value / Q::from_integer(10.into()).pow(power)));
    let text = format!("{near_one:.5e}");
    let (mantissa, rest) = text.split_once('e').unwrap_or((&text, "0"));
    format!("{}e{}", trimmed(mantissa), i64::from(power) + rest.parse::<i64>().unwrap_or(0))
}

fn significant(value: f64, digits: usize) -> String {
    if value == 0.0 {
        return "0".into();
    }
    let exponent = value.abs().log10().floor();
    if !(-5.0..15.0).contains(&exponent) {
        let text = format!("{value:.*e}", digits - 1);
        let (mantissa, power) = text.split_once('e').unwrap_or((&text, "0"));
        return format!("{}e{power}", trimmed(mantissa));
    }
    #[expect(clippy::cast_possible_truncation, reason = "the exponent lies in -5..15")]
    let places = (digits as i64 - 1 - exponent as i64).max(0).unsigned_abs() as usize;
    trimmed(&format!("{value:.places$}")).into()
}

fn trimmed(text: &str) -> &str {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text }
}

/// The decimal digits of a short terminating fraction.
fn terminating(value: &Q) -> Option<String> {
    let mut scaled = value.clone();
    for places in 0_usize..=9 {
        if scaled.is_integer() {
            let digits = scaled.to_integer().to_string();
            if digits.len() > 15 {
                return None;
            }
            if places == 0 {
                return Some(digits);
            }
            let (sign, digits) = digits.strip_prefix('-').map_or(("", digits.as_str()), |rest| ("-", rest));
            let padded = format!("{digits:0>width$}", width = places + 1);
            let (whole, fraction) = padded.split_at(padded.len() - places);
            return Some(format!("{sign}{whole}.{fraction}"));
        }
        scaled *= Q::from_integer(10.into());
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::{parse, ratio};

    #[test]
    fn short_values_are_shown_exactly_and_long_ones_in_decimal() {
        let shown = |text: &str| number(&parse(text).unwrap());
        assert_eq!(shown("-3"), "-3");
        assert_eq!(shown("-0.05"), "-0.05");
        assert_eq!(shown("1/3"), "1/3");
        assert_eq!(shown("1000000000000000000000/3"), "3.33333333333e20");
        assert_eq!(shown("123456789/1000000007"), "0.123456788136");
        assert_eq!(shown("-1e400"), "-1e400");
        assert_eq!(shown("1e-400"), "1e-400");
    }

    #[test]
    fn distances_are_rounded_roots() {
        assert_eq!(distance(&ratio(2, 1)), "1.41");
        assert_eq!(distance(&ratio(1, 10_000_000_000_000)), "3.16e-7");
    }
}
