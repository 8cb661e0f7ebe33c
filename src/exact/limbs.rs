//! Natural numbers as words, least first and without leading zeros.

use super::Z;
use smallvec::SmallVec;
use std::cmp::Ordering;

/// Words of one number.
pub(super) type Limbs = SmallVec<[u64; 6]>;

/// The number of words without leading zeros.
pub(super) fn significant(words: &[u64]) -> usize {
    words.iter().rposition(|word| *word != 0).map_or(0, |top| top + 1)
}

pub(super) fn trim(words: &mut Limbs) {
    words.truncate(significant(words));
}

pub(super) fn compare(a: &[u64], b: &[u64]) -> Ordering {
    a.len().cmp(&b.len()).then_with(|| a.iter().rev().cmp(b.iter().rev()))
}

pub(super) fn to_z(words: &[u64]) -> Z {
    let halves = words.iter().flat_map(|word| [*word as u32, (word >> 32) as u32]).collect();
    Z::new(num_bigint::Sign::Plus, halves)
}

/// Adds `a b`, which have no more words than `total` has, modulo its range.
pub(super) fn add_product(total: &mut [u64], a: &[u64], b: &[u64]) {
    let (short, long) = if a.len() < b.len() { (a, b) } else { (b, a) };
    for (shift, factor) in short.iter().enumerate() {
        let (low, high) = total[shift..].split_at_mut(long.len());
        let mut carry = 0_u64;
        for (word, other) in low.iter_mut().zip(long) {
            let sum = u128::from(*factor) * u128::from(*other) + u128::from(*word) + u128::from(carry);
            (*word, carry) = (sum as u64, (sum >> 64) as u64);
        }
        for word in high {
            if carry == 0 {
                break;
            }
            let (sum, is_over) = word.overflowing_add(carry);
            (*word, carry) = (sum, u64::from(is_over));
        }
    }
}

/// Subtracts `a b`, which have no more words than `total` has, modulo its range.
pub(super) fn subtract_product(total: &mut [u64], a: &[u64], b: &[u64]) {
    let (short, long) = if a.len() < b.len() { (a, b) } else { (b, a) };
    for (shift, factor) in short.iter().enumerate() {
        let (low, high) = total[shift..].split_at_mut(long.len());
        let mut borrow = subtract_multiple(low, long, *factor);
        for word in high {
            if borrow == 0 {
                break;
            }
            let (difference, is_under) = word.overflowing_sub(borrow);
            (*word, borrow) = (difference, u64::from(is_under));
        }
    }
}

/// Negates in two's complement.
pub(super) fn negate(words: &mut [u64]) {
    let mut carry = true;
    for word in words {
        (*word, carry) = (!*word).overflowing_add(u64::from(carry));
    }
}

/// A number to divide by, prepared once for many divisions.
///
/// # Source
/// Knuth, The Art of Computer Programming 2, section 4.3.1, algorithm D; the quotient digits by the reciprocal of
/// Möller & Granlund, Improved division by invariant integers (2011), algorithm 4.
pub(super) struct Divisor {
    /// Shifted until the highest bit is set.
    words: Limbs,
    shift: u32,
    reciprocal: u64,
}

impl Divisor {
    /// `words` is not zero.
    pub(super) fn new(words: &[u64]) -> Self {
        let top = words[words.len() - 1];
        let shift = top.leading_zeros();
        let mut shifted = Limbs::from_slice(words);
        shift_left(&mut shifted, shift);
        let top = shifted[shifted.len() - 1];
        let reciprocal = (u128::MAX / u128::from(top)) as u64;
        Self { words: shifted, shift, reciprocal }
    }

    /// Replaces `value` by the remainder.
    pub(super) fn reduce(&self, value: &mut Limbs) {
        self.divide(value, |_, _| ());
    }

    /// Replaces `value` by the remainder and the zeros of `quotient`, as long as `value` at least, by the quotient.
    pub(super) fn divide_into(&self, value: &mut Limbs, quotient: &mut [u64]) {
        self.divide(value, |index, digit| {
            if digit != 0 {
                quotient[index] = digit;
            }
        });
    }

    #[inline(always)]
    fn divide(&self, value: &mut Limbs, mut set: impl FnMut(usize, u64)) {
        let size = self.words.len();
        if value.len() < size {
            return;
        }
        let carry = shift_left(value, self.shift);
        value.push(carry);
        let top = self.words[size - 1];
        let second = if size > 1 { self.words[size - 2] } else { 0 };
        for index in (0..value.len() - size).rev() {
            let part = &mut value[index..=index + size];
            let mut digit = if part[size] >= top {
                u64::MAX
            } else {
                let (mut digit, mut rest) = self.digit(part[size], part[size - 1]);
                if size > 1 {
                    // at most twice
                    while u128::from(digit) * u128::from(second) > (u128::from(rest) << 64 | u128::from(part[size - 2]))
                    {
                        digit -= 1;
                        let (sum, is_over) = rest.overflowing_add(top);
                        rest = sum;
                        if is_over {
                            break;
                        }
                    }
                }
                digit
            };
            if digit != 0 && subtract_once(part, &self.words, digit) {
                digit -= 1;
                while !add_back(part, &self.words) {
                    digit -= 1;
                }
            }
            set(index, digit);
        }
        value.truncate(size);
        shift_right(value, self.shift);
        trim(value);
    }

    /// Quotient and remainder of two words, the higher one less than the divisor's highest word.
    #[inline(always)]
    fn digit(&self, high: u64, low: u64) -> (u64, u64) {
        let top = self.words[self.words.len() - 1];
        let product = u128::from(self.reciprocal) * u128::from(high);
        let estimate = product.wrapping_add(u128::from(high) << 64 | u128::from(low));
        let (mut digit, fraction) = (((estimate >> 64) as u64).wrapping_add(1), estimate as u64);
        let mut rest = low.wrapping_sub(digit.wrapping_mul(top));
        if rest > fraction {
            digit = digit.wrapping_sub(1);
            rest = rest.wrapping_add(top);
        }
        if rest >= top {
            digit = digit.wrapping_add(1);
            rest -= top;
        }
        (digit, rest)
    }
}

/// Subtracts `digit words` from a part that is one word longer, and says whether that went below zero.
fn subtract_once(part: &mut [u64], words: &[u64], digit: u64) -> bool {
    let (last, part) = part.split_last_mut().expect("the part has a word more");
    let borrow = subtract_multiple(part, words, digit);
    let (difference, is_under) = last.overflowing_sub(borrow);
    *last = difference;
    is_under
}

/// Subtracts `factor words` from a part of the same length, and returns what is to be subtracted from the next word.
fn subtract_multiple(part: &mut [u64], words: &[u64], factor: u64) -> u64 {
    let mut carry = 0_u64;
    for (word, other) in part.iter_mut().zip(words) {
        let product = u128::from(factor) * u128::from(*other) + u128::from(carry);
        let (difference, is_under) = word.overflowing_sub(product as u64);
        *word = difference;
        carry = (product >> 64) as u64 + u64::from(is_under);
    }
    carry
}

/// Adds `words` to a part that is one word longer, and says whether that brought it back above zero.
fn add_back(part: &mut [u64], words: &[u64]) -> bool {
    let mut carry = false;
    for (word, more) in part.iter_mut().zip(words) {
        let (sum, first) = word.overflowing_add(*more);
        let (sum, second) = sum.overflowing_add(u64::from(carry));
        (*word, carry) = (sum, first || second);
    }
    let last = &mut part[words.len()];
    let (sum, is_over) = last.overflowing_add(u64::from(carry));
    *last = sum;
    is_over
}

/// Shifts by less than a word and returns the bits that leave it.
fn shift_left(words: &mut [u64], shift: u32) -> u64 {
    let mut carry = 0;
    if shift > 0 {
        for word in words {
            (*word, carry) = (*word << shift | carry, *word >> (64 - shift));
        }
    }
    carry
}

fn shift_right(words: &mut [u64], shift: u32) {
    let mut carry = 0;
    if shift > 0 {
        for word in words.iter_mut().rev() {
            (*word, carry) = (*word >> shift | carry, *word << (64 - shift));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_integer::Integer as _;
    use num_traits::Zero as _;
    use proptest::prelude::*;

    fn words(value: &Z) -> Limbs {
        value.magnitude().iter_u64_digits().collect()
    }

    fn natural() -> impl Strategy<Value = Z> {
        let word = prop_oneof![Just(0), Just(u32::MAX), Just(1), Just(1 << 31), any::<u32>()];
        proptest::collection::vec(word, 0..=16).prop_map(|words| Z::new(num_bigint::Sign::Plus, words))
    }

    proptest! {
        #[test]
        fn words_compute_as_num_bigint_does(a in natural(), b in natural(), c in natural()) {
            let sum = &a * &b + &c;
            let size = a.iter_u64_digits().len() + b.iter_u64_digits().len().max(c.iter_u64_digits().len()) + 1;
            let mut total = words(&c);
            total.resize(size, 0);
            add_product(&mut total, &words(&a), &words(&b));
            prop_assert_eq!(to_z(&total), sum.clone());
            subtract_product(&mut total, &words(&b), &words(&a));
            prop_assert_eq!(to_z(&total), c.clone());
            subtract_product(&mut total, &words(&a), &words(&b));
            let is_negative = &a * &b > c;
            prop_assert_eq!(total.last().is_some_and(|top| top >> 63 == 1), is_negative);
            if is_negative {
                negate(&mut total);
            }
            prop_assert_eq!(to_z(&total), (&a * &b - &c).magnitude().clone().into());
            if !b.is_zero() {
                let mut value = words(&sum);
                let mut quotient = vec![0; value.len()];
                Divisor::new(&words(&b)).divide_into(&mut value, &mut quotient);
                let (expected, rest) = sum.div_rem(&b);
                prop_assert_eq!((to_z(&quotient), value), (expected, words(&rest)));
            }
        }
    }
}
