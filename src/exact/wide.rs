//! Signs of sums of three products that no machine type holds.

use super::quad::Quad;
use std::cmp::Ordering;

/// A product of two numbers, by its sign and the words of both magnitudes, least first.
pub(super) struct Term<const N: usize> {
    is_negative: bool,
    factor: [u64; 2],
    value: [u64; N],
}

impl Term<2> {
    pub(super) fn of(factor: i128, value: i128) -> Self {
        Self { is_negative: (factor < 0) != (value < 0), factor: words(factor), value: words(value) }
    }
}

impl Term<4> {
    pub(super) fn of_quad(factor: i128, value: &Quad) -> Self {
        let is_negative = (factor < 0) != value.sign().is_lt();
        Self { is_negative, factor: words(factor), value: value.magnitude() }
    }
}

/// Sign of the sum of three products, whose magnitudes must add up to less than `M` words hold.
pub(super) fn sum_sign<const N: usize, const M: usize>(terms: [Term<N>; 3]) -> Ordering {
    let (mut positive, mut negative) = ([0; M], [0; M]);
    for Term { is_negative, factor, value } in terms {
        add_product(if is_negative { &mut negative } else { &mut positive }, &factor, &value);
    }
    positive.iter().rev().cmp(negative.iter().rev())
}

fn words(value: i128) -> [u64; 2] {
    let magnitude = value.unsigned_abs();
    [magnitude as u64, (magnitude >> 64) as u64]
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
