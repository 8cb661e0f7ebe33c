//! The rung of `i128` entries, whose products have 256 bits.

use super::gcd::{gcd128, words_gcd};
use super::int::machine_entries;
use super::limbs::{Divisor, Limbs, trim};
use super::quad::Quad;
use super::{Entries, Int, Overflow, Z};
use smallvec::SmallVec;
use std::cmp::Ordering;

impl Int for i128 {
    type Wide = Quad;

    machine_entries!();
    fn wide_sign(value: &Quad) -> Ordering {
        value.sign()
    }
    fn wide_negated(value: &Quad) -> Quad {
        value.negated()
    }

    fn dot(a: &[Self], b: &[Self]) -> Result<Quad, Overflow> {
        debug_assert_eq!(a.len(), b.len(), "rows of equal length have a dot product");
        Quad::dot(a, b).ok_or(Overflow)
    }

    fn combine(p: &Quad, a: &[Self], q: &Quad, b: &[Self], out: &mut Entries<Self>) -> Result<(), Overflow> {
        let (p, q) = coprime(p, q)?;
        let start = out.len();
        for (x, y) in a.iter().zip(b) {
            let Some(value) = Quad::combination(p, *x, q, *y).narrow() else {
                out.truncate(start);
                let wide = a.iter().zip(b).map(|(x, y)| Quad::combination(p, *x, q, *y));
                return narrowed(&wide.collect::<SmallVec<[Quad; 16]>>(), out);
            };
            out.push(value);
        }
        Self::make_primitive(&mut out[start..]);
        Ok(())
    }

    fn primitive(wide: &[Quad], out: &mut Entries<Self>) -> Result<(), Overflow> {
        let start = out.len();
        for value in wide {
            let Some(value) = value.narrow() else {
                out.truncate(start);
                return narrowed(wide, out);
            };
            out.push(value);
        }
        Self::make_primitive(&mut out[start..]);
        Ok(())
    }

    fn make_primitive(row: &mut [Self]) {
        // from the smallest entry, so that all others are reduced by a remainder before the costly divisor
        let Some(mut divisor) = row.iter().map(|v| v.unsigned_abs()).filter(|v| *v != 0).min() else { return };
        for value in row.iter() {
            if divisor == 1 {
                return;
            }
            divisor = common(divisor, value.unsigned_abs());
        }
        if divisor == 1 {
            return;
        }
        if let Ok(divisor) = i64::try_from(divisor) {
            row.iter_mut().for_each(|v| match i64::try_from(*v) {
                Ok(value) => *v = (value / divisor).into(),
                Err(_) => *v /= i128::from(divisor),
            });
            return;
        }
        let exact = ExactDivisor::new(divisor);
        row.iter_mut().for_each(|v| *v = exact.quotient(v.cast_unsigned()).cast_signed());
    }
}

fn common(divisor: u128, value: u128) -> u128 {
    let rest = match (u64::try_from(divisor), u64::try_from(value)) {
        (Ok(divisor), Ok(value)) => u128::from(value % divisor),
        _ => value % divisor,
    };
    if rest == 0 { divisor } else { gcd128(divisor, rest) }
}

/// Divides without remainder, by multiplication.
///
/// # Source
/// Jebelean, An algorithm for exact division (1993).
struct ExactDivisor {
    twos: u32,
    inverse: u128,
}

impl ExactDivisor {
    /// `divisor` is not zero.
    fn new(divisor: u128) -> Self {
        let twos = divisor.trailing_zeros();
        let odd = divisor >> twos;
        // right to 3 bits, then to twice as many with each step
        let mut inverse = odd;
        for _ in 0..6 {
            inverse = inverse.wrapping_mul(2_u128.wrapping_sub(odd.wrapping_mul(inverse)));
        }
        Self { twos, inverse }
    }

    /// The quotient of a multiple of the divisor, in two's complement.
    fn quotient(&self, multiple: u128) -> u128 {
        (multiple.cast_signed() >> self.twos).cast_unsigned().wrapping_mul(self.inverse)
    }
}

/// Both without their common divisor if they do not fit otherwise.
fn coprime(p: &Quad, q: &Quad) -> Result<(i128, i128), Overflow> {
    if let (Some(p), Some(q)) = (p.narrow(), q.narrow()) {
        return Ok((p, q));
    }
    let mut pair = Entries::new();
    narrowed(&[*p, *q], &mut pair)?;
    Ok((pair[0], pair[1]))
}

/// Appends the primitive form of a row of which some entry has more than 127 bits.
fn narrowed(wide: &[Quad], out: &mut Entries<i128>) -> Result<(), Overflow> {
    let magnitudes: SmallVec<[[u64; 4]; 16]> = wide.iter().map(Quad::magnitude).collect();
    let nonzero = magnitudes.iter().filter(|words| **words != [0; 4]);
    let Some(smallest) = nonzero.min_by(|a, b| a.iter().rev().cmp(b.iter().rev())) else { return Err(Overflow) };
    let trimmed = |words: &[u64; 4]| {
        let mut words = Limbs::from_slice(words);
        trim(&mut words);
        words
    };
    let mut common = trimmed(smallest);
    let mut divisor = Divisor::new(&common);
    for words in &magnitudes {
        if common.as_slice() == [1] {
            return Err(Overflow);
        }
        let mut rest = trimmed(words);
        divisor.reduce(&mut rest);
        if !rest.is_empty() {
            common = words_gcd(common, rest);
            divisor = Divisor::new(&common);
        }
    }
    common.resize(4, 0);
    let common = [common[0], common[1], common[2], common[3]];
    let (twos, n_bits) = (twos(&common), bits(&common));
    let exact = ExactDivisor::new(low_bits_from(&common, twos));
    for (words, value) in magnitudes.iter().zip(wide) {
        // what is divisible has its quotient modulo 2^128 from the low words alone
        let quotient = exact.quotient(low_bits_from(words, twos));
        let entry = i128::try_from(quotient).ok().filter(|_| bits(words) <= n_bits + 127).ok_or(Overflow)?;
        out.push(if value.sign().is_lt() { -entry } else { entry });
    }
    Ok(())
}

fn bits(words: &[u64; 4]) -> u32 {
    let top = words.iter().rposition(|word| *word != 0);
    top.map_or(0, |top| 64 * (top as u32 + 1) - words[top].leading_zeros())
}

/// Trailing zeros of a number that is not zero.
fn twos(words: &[u64; 4]) -> u32 {
    let first = words.iter().take_while(|word| **word == 0).count();
    64 * first as u32 + words.get(first).map_or(0, |word| word.trailing_zeros())
}

/// 128 bits from bit `start` on.
fn low_bits_from(words: &[u64; 4], start: u32) -> u128 {
    let word = |index: usize| u128::from(words.get(index).copied().unwrap_or(0));
    let first = start as usize / 64;
    let (low, shift) = (word(first) | word(first + 1) << 64, start % 64);
    if shift == 0 { low } else { low >> shift | word(first + 2) << (128 - shift) }
}
