//! Integers of a fixed number of words, for what products of double words need.

use super::Z;
use num_bigint::Sign;
use std::cmp::Ordering;

/// A sign and `N` words of magnitude, least first.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
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

    pub(super) fn to_z(self) -> Z {
        let halves = self.words.iter().flat_map(|word| [*word as u32, (word >> 32) as u32]).collect();
        Z::new(if self.negative { Sign::Minus } else { Sign::Plus }, halves)
    }
}

impl Wide<4> {
    pub(super) fn product(a: i128, b: i128) -> Self {
        let mut words = [0; 4];
        add_product(&mut words, &halves(a.unsigned_abs()), &halves(b.unsigned_abs()));
        Self { negative: (a < 0) != (b < 0), words }
    }

    /// The difference of two products of entries, which cannot overflow.
    pub(super) fn minus(&self, other: &Self) -> Self {
        if self.negative != other.negative {
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
