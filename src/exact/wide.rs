//! Integers of a fixed number of words, for what products of double words need.

use super::gcd::words_gcd;
use smallvec::SmallVec;
use std::cmp::Ordering;

/// A sign and `N` words of magnitude, least first.
#[derive(Debug, Clone, Copy)]
pub struct Wide<const N: usize> {
    negative: bool,
    words: [u64; N],
}

impl<const N: usize> Wide<N> {
    pub(super) fn sign(&self) -> Ordering {
        match (self.words.iter().all(|word| *word == 0), self.negative) {
            (true, _) => Ordering::Equal,
            (false, true) => Ordering::Less,
            (false, false) => Ordering::Greater,
        }
    }

    /// The value if it fits two words and is not their least.
    pub(super) fn narrow(&self) -> Option<i128> {
        let is_short = self.words[2..].iter().all(|word| *word == 0);
        let magnitude = i128::try_from(two_words(self.words[0], self.words[1])).ok().filter(|_| is_short)?;
        Some(if self.negative { -magnitude } else { magnitude })
    }

    fn bits(&self) -> u32 {
        let top = self.words.iter().rposition(|word| *word != 0);
        top.map_or(0, |top| 64 * (top as u32 + 1) - self.words[top].leading_zeros())
    }
}

impl Wide<4> {
    fn trailing_zeros(&self) -> u32 {
        let low = self.words.iter().position(|word| *word != 0);
        low.map_or(0, |low| 64 * low as u32 + self.words[low].trailing_zeros())
    }

    /// The 128 bits from bit `shift` up.
    fn low_bits_from(&self, shift: u32) -> u128 {
        let word = |at: usize| self.words.get(at).copied().unwrap_or(0);
        let (at, shift) = ((shift / 64) as usize, shift % 64);
        let low = two_words(word(at), word(at + 1)) >> shift;
        if shift == 0 { low } else { low | u128::from(word(at + 2)) << (128 - shift) }
    }

    pub(super) fn product(a: i128, b: i128) -> Self {
        let mut words = [0; 4];
        add_product(&mut words, &halves(a.unsigned_abs()), &halves(b.unsigned_abs()));
        Self { negative: (a < 0) != (b < 0), words }
    }

    /// The difference of two products of entries; three such products fit.
    pub(super) fn minus(&self, other: &Self) -> Self {
        self.plus(&Self { negative: !other.negative, ..*other })
    }

    /// The sum of products of entries; three of them fit.
    pub(super) fn plus(&self, other: &Self) -> Self {
        if self.negative == other.negative {
            let mut words = self.words;
            add(&mut words, &other.words);
            return Self { negative: self.negative, words };
        }
        let is_less = order(&self.words, &other.words).is_lt();
        let (mut words, less) = if is_less { (other.words, &self.words) } else { (self.words, &other.words) };
        subtract(&mut words, less);
        Self { negative: self.negative != is_less, words }
    }
}

impl Default for Wide<4> {
    fn default() -> Self {
        Self { negative: false, words: [0; 4] }
    }
}

impl From<i128> for Wide<2> {
    fn from(value: i128) -> Self {
        Self { negative: value < 0, words: halves(value.unsigned_abs()) }
    }
}

/// Sign of the sum of three products, whose magnitudes must add up to less than `M` words hold.
pub(super) fn sum_sign<const N: usize, const M: usize>(terms: [(i128, Wide<N>); 3]) -> Ordering {
    let (mut positive, mut negative) = ([0; M], [0; M]);
    for (factor, value) in terms {
        let total = if (factor < 0) == value.negative { &mut positive } else { &mut negative };
        add_product(total, &halves(factor.unsigned_abs()), &value.words);
    }
    order(&positive, &negative)
}

/// The primitive row on the same ray, unless an entry does not fit.
pub(super) fn primitive(row: &[Wide<4>; 3]) -> Option<[i128; 3]> {
    let mut sorted: SmallVec<[&Wide<4>; 3]> = row.iter().filter(|value| value.sign().is_ne()).collect();
    sorted.sort_unstable_by_key(|value| value.bits());
    let divisors = sorted.iter().map(|value| value.words.into_iter().collect());
    let divisor = divisors.reduce(words_gcd)?;
    let mut words = [0; 4];
    words[..divisor.len()].copy_from_slice(&divisor);
    let divisor = Wide { negative: false, words };
    let twos = divisor.trailing_zeros();
    let (bits, inverse) = (divisor.bits(), inverse(divisor.low_bits_from(twos)));
    let mut out = [0; 3];
    for (entry, value) in out.iter_mut().zip(row) {
        // what is divisible has its quotient modulo 2^128 from the low words alone
        let quotient = value.low_bits_from(twos).wrapping_mul(inverse);
        let magnitude = i128::try_from(quotient).ok().filter(|_| value.bits() <= bits + 127)?;
        *entry = if value.negative { -magnitude } else { magnitude };
    }
    Some(out)
}

/// Inverse of an odd number modulo 2^128 by Newton's method, which doubles the five bits that are right at first.
fn inverse(odd: u128) -> u128 {
    let start = odd.wrapping_mul(3) ^ 2;
    (0..5).fold(start, |inverse, _| inverse.wrapping_mul(2_u128.wrapping_sub(odd.wrapping_mul(inverse))))
}

fn halves(value: u128) -> [u64; 2] {
    [value as u64, (value >> 64) as u64]
}

fn two_words(low: u64, high: u64) -> u128 {
    u128::from(high) << 64 | u128::from(low)
}

fn order(a: &[u64], b: &[u64]) -> Ordering {
    a.iter().rev().cmp(b.iter().rev())
}

/// Adds `a b`; the sum must fit.
fn add_product<const M: usize>(total: &mut [u64; M], a: &[u64; 2], b: &[u64]) {
    for (shift, factor) in a.iter().enumerate().filter(|(_, factor)| **factor != 0) {
        let mut carry = 0;
        for (at, word) in b.iter().enumerate() {
            let sum = u128::from(*factor) * u128::from(*word) + u128::from(total[shift + at]) + u128::from(carry);
            (total[shift + at], carry) = (sum as u64, (sum >> 64) as u64);
        }
        for word in &mut total[shift + b.len()..] {
            let (sum, is_over) = word.overflowing_add(carry);
            (*word, carry) = (sum, u64::from(is_over));
        }
        debug_assert_eq!(carry, 0, "the words hold the sum");
    }
}

fn add<const N: usize>(total: &mut [u64; N], other: &[u64; N]) {
    let mut carry = 0;
    for (word, more) in total.iter_mut().zip(other) {
        let sum = u128::from(*word) + u128::from(*more) + carry;
        (*word, carry) = (sum as u64, sum >> 64);
    }
    debug_assert_eq!(carry, 0, "the words hold the sum");
}

fn subtract<const N: usize>(total: &mut [u64; N], less: &[u64; N]) {
    let mut borrow = false;
    for (word, less) in total.iter_mut().zip(less) {
        let (difference, first) = word.overflowing_sub(*less);
        let (difference, second) = difference.overflowing_sub(u64::from(borrow));
        (*word, borrow) = (difference, first || second);
    }
    debug_assert!(!borrow, "the larger magnitude is on the left");
}
