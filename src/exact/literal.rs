//! Numeric literals read as the rationals that they denote, digit for digit.

use super::{Q, Z};
use num_integer::Integer as _;
use num_traits::{Num, Zero};

/// Largest accepted power of ten, so that `1e999999999` cannot fill memory.
pub const MAX_EXPONENT: u32 = 10_000;

/// Reads `3`, `-0.25`, `1e-3` or `1/3` as an exact rational.
///
/// `0.2` is one fifth: the digits count, never the nearest double.
///
/// # Errors
/// [`LiteralError`] says what is wrong with the text.
///
/// # Examples
/// ```
/// use partplan::exact::{parse_literal, ratio};
/// assert_eq!(parse_literal("0.2"), Ok(ratio(1, 5)));
/// assert_eq!(parse_literal("-2/6"), Ok(ratio(-1, 3)));
/// ```
pub fn parse_literal(text: &str) -> Result<Q, LiteralError> {
    match text.split_once('/') {
        Some((numerator, denominator)) => {
            let numerator = integer(numerator)?;
            let denominator = integer(denominator)?;
            if denominator.is_zero() {
                return Err(LiteralError::ZeroDenominator);
            }
            Ok(Q::new(numerator, denominator))
        }
        None => decimal(text),
    }
}

fn integer(text: &str) -> Result<Z, LiteralError> {
    let digits = text.strip_prefix('-').unwrap_or(text);
    if digits.is_empty() || !digits.bytes().all(|b| b.is_ascii_digit()) {
        return Err(LiteralError::NotANumber);
    }
    Z::from_str_radix(text, 10).map_err(|_| LiteralError::NotANumber)
}

fn decimal(text: &str) -> Result<Q, LiteralError> {
    let (mantissa, exponent) = match text.find(['e', 'E']) {
        Some(at) => (&text[..at], exponent(&text[at + 1..])?),
        None => (text, 0),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    if mantissa.contains('.') && fraction.is_empty() {
        return Err(LiteralError::NotANumber);
    }
    let digits = integer(&format!("{whole}{fraction}"))?;
    if whole.is_empty() || whole == "-" {
        return Err(LiteralError::NotANumber);
    }
    let places = i64::try_from(fraction.len()).map_err(|_| LiteralError::ExponentTooLarge)?;
    let power = exponent - places;
    let places = u32::try_from(power.unsigned_abs()).map_err(|_| LiteralError::ExponentTooLarge)?;
    Ok(if power < 0 { over_power_of_ten(digits, places) } else { Q::from(digits * Z::from(10).pow(places)) })
}

/// `digits / 10^places` reduced; only twos and fives can be common, which is far cheaper to see than a full divisor.
fn over_power_of_ten(mut digits: Z, places: u32) -> Q {
    if digits.is_zero() {
        return Q::zero();
    }
    let (mut twos, mut fives) = (places, places);
    let even = digits.trailing_zeros().map_or(0, |zeros| zeros.min(twos.into()));
    digits >>= even;
    twos -= even as u32;
    while fives > 0 {
        let (quotient, remainder) = digits.div_rem(&Z::from(5));
        if !remainder.is_zero() {
            break;
        }
        digits = quotient;
        fives -= 1;
    }
    Q::new_raw(digits, Z::from(5).pow(fives) << twos)
}

fn exponent(text: &str) -> Result<i64, LiteralError> {
    let digits = text.strip_prefix(['+', '-']).unwrap_or(text);
    if digits.is_empty() || !digits.bytes().all(|b| b.is_ascii_digit()) {
        return Err(LiteralError::NotANumber);
    }
    match digits.trim_start_matches('0').parse::<u32>() {
        _ if digits.bytes().all(|b| b == b'0') => Ok(0),
        Ok(value) if value <= MAX_EXPONENT => Ok(if text.starts_with('-') { -i64::from(value) } else { value.into() }),
        _ => Err(LiteralError::ExponentTooLarge),
    }
}

/// Why a numeric literal could not be read.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum LiteralError {
    /// Neither a decimal number nor `p/q`.
    #[error("expected a decimal number or a fraction \"p/q\"")]
    NotANumber,
    /// `p/0`.
    #[error("the denominator is zero")]
    ZeroDenominator,
    /// The exponent is beyond [`MAX_EXPONENT`].
    #[error("decimal exponents beyond ±{MAX_EXPONENT} are not accepted")]
    ExponentTooLarge,
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `new_raw` trusts its caller: the value must be the one that a full reduction gives.
    #[test]
    fn decimals_are_reduced() {
        for (digits, places) in [(0, 3), (5, 1), (-125, 3), (1024, 10), (7_000, 2), (390_625, 8), (-3, 0), (12, 20)] {
            let scale = Z::from(10).pow(places);
            assert_eq!(over_power_of_ten(Z::from(digits), places), Q::new(Z::from(digits), scale));
        }
    }
}
