//! Greatest common divisors: binary on words, Lehmer's method on longer integers.

use super::Z;
use super::limbs::{Divisor, Limbs, compare, to_z, trim};

/// Of two integers of any size, not negative.
pub(super) fn gcd(a: &Z, b: &Z) -> Z {
    if let (Ok(a), Ok(b)) = (u64::try_from(a.magnitude()), u64::try_from(b.magnitude())) {
        return word_gcd(a, b).into();
    }
    let words = |value: &Z| value.iter_u64_digits().collect::<Limbs>();
    to_z(&words_gcd(words(a), words(b)))
}

/// Of two words; binary, with a subtraction and a shift for each step and no branch but the loop's.
pub(super) fn word_gcd(a: u64, b: u64) -> u64 {
    if a == 0 || b == 0 {
        return a | b;
    }
    if a == 1 || b == 1 {
        return 1;
    }
    let twos = (a | b).trailing_zeros();
    let (mut a, mut b) = (a >> a.trailing_zeros(), b >> b.trailing_zeros());
    while a != b {
        let difference = a.abs_diff(b);
        a = a.min(b);
        b = difference >> difference.trailing_zeros();
    }
    a << twos
}

/// Of two double words, by the same method.
pub(super) fn gcd128(a: u128, b: u128) -> u128 {
    if let (Ok(a), Ok(b)) = (u64::try_from(a), u64::try_from(b)) {
        return word_gcd(a, b).into();
    }
    if a == 0 || b == 0 {
        return a | b;
    }
    let (mut a, mut b) = if a.ilog2().abs_diff(b.ilog2()) > 8 { (a.min(b), a.max(b) % a.min(b)) } else { (a, b) };
    if b == 0 {
        return a;
    }
    let twos = (a | b).trailing_zeros();
    (a, b) = (a >> a.trailing_zeros(), b >> b.trailing_zeros());
    while a != b {
        if let (Ok(a), Ok(b)) = (u64::try_from(a), u64::try_from(b)) {
            return u128::from(word_gcd(a, b)) << twos;
        }
        let difference = a.abs_diff(b);
        a = a.min(b);
        b = difference >> difference.trailing_zeros();
    }
    a << twos
}

/// Of two magnitudes, by Lehmer's method: the first quotients of Euclid's follow from the leading words alone, and their
/// product is applied to the whole numbers at once.
///
/// # Source
/// Knuth (1997), The Art of Computer Programming 2, §4.5.2, Algorithm L, with the exit condition of Collins that Jebelean
/// (1993), "A generalization of the binary GCD algorithm", §4.2, recalls: it takes one division a quotient.
pub(super) fn words_gcd(mut a: Limbs, mut b: Limbs) -> Limbs {
    trim(&mut a);
    trim(&mut b);
    if compare(&a, &b).is_lt() {
        std::mem::swap(&mut a, &mut b);
    }
    while b.len() > 1 {
        let quotients = leading_quotients(&a, &b);
        if quotients.b_in_a == 0 {
            let rest = remainder(&a, &b);
            a = std::mem::replace(&mut b, rest);
        } else {
            quotients.apply(&mut a, &mut b);
        }
    }
    let Some(&short) = b.first() else { return a };
    let mut divisor = Limbs::new();
    divisor.push(word_gcd(short, short_remainder(&a, short)));
    divisor
}

/// Several steps of Euclid's method: `a` becomes ±(`a_in_a` a - `b_in_a` b) and `b` becomes ∓(`a_in_b` a - `b_in_b` b).
struct Quotients {
    a_in_a: u64,
    b_in_a: u64,
    a_in_b: u64,
    b_in_b: u64,
    is_even: bool,
}

/// The quotients that the leading words of `a ≥ b` make sure of; `b` has two words at least.
fn leading_quotients(a: &[u64], b: &[u64]) -> Quotients {
    let top = a.len() - 1;
    let shift = a[top].leading_zeros();
    let leading = |words: &[u64]| {
        let word = |at: usize| words.get(at).copied().unwrap_or(0);
        let pair = u128::from(word(top)) << 64 | u128::from(word(top - 1));
        (pair << shift >> 64) as u64
    };
    let (mut high, mut low) = (leading(a), leading(b));
    let (mut in_a, mut in_b, mut next) = ([0, 0], [1, 0], [0, 1]);
    let mut is_even = false;
    while low >= next[1] && high - low >= in_b[1] + next[1] {
        let quotient = high / low;
        (high, low) = (low, high % low);
        let after = [in_b[0] + quotient * next[0], in_b[1] + quotient * next[1]];
        (in_a, in_b, next) = (in_b, next, after);
        is_even = !is_even;
    }
    let ([a_in_a, b_in_a], [a_in_b, b_in_b]) = (in_a, in_b);
    Quotients { a_in_a, b_in_a, a_in_b, b_in_b, is_even }
}

impl Quotients {
    fn apply(&self, a: &mut Limbs, b: &mut Limbs) {
        b.resize(a.len(), 0);
        let mut carries = [0_i128; 2];
        for (x, y) in a.iter_mut().zip(b.iter_mut()) {
            let product = |factor: u64, word: u64| u128::from(factor) * u128::from(word);
            let difference = |p: u128, q: u128, carry: i128| {
                // factors are below 2^63, so products are below 2^127
                let total = p.cast_signed() - q.cast_signed() + carry;
                (total as u64, total >> 64)
            };
            let pairs = [
                (product(self.a_in_a, *x), product(self.b_in_a, *y)),
                (product(self.b_in_b, *y), product(self.a_in_b, *x)),
            ];
            for (out, ((p, q), carry)) in [x, y].into_iter().zip(pairs.into_iter().zip(&mut carries)) {
                let (p, q) = if self.is_even { (p, q) } else { (q, p) };
                (*out, *carry) = difference(p, q, *carry);
            }
        }
        debug_assert_eq!(carries, [0, 0], "remainders are not negative");
        trim(a);
        trim(b);
    }
}

fn remainder(a: &[u64], b: &[u64]) -> Limbs {
    let mut rest = Limbs::from_slice(a);
    Divisor::new(b).reduce(&mut rest);
    rest
}

fn short_remainder(a: &[u64], b: u64) -> u64 {
    a.iter().rev().fold(0, |rest, word| ((u128::from(rest) << 64 | u128::from(*word)) % u128::from(b)) as u64)
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_integer::Integer as _;
    use proptest::prelude::*;

    /// Numbers of all lengths up to twelve words, with planted common factors, and Fibonacci numbers, whose quotients
    /// are all one.
    fn numbers() -> Vec<Z> {
        let mut state = 1_u64;
        let mut word = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            state ^ state >> 29
        };
        let mut numbers: Vec<Z> = [0_u64, 1, 2, 3, 1 << 63, u64::MAX].map(Z::from).into();
        for words in 1..=6 {
            let mut long = |words: usize| (0..words).fold(Z::from(1), |value, _| (value << 64) + word());
            let common = long(words);
            numbers.extend([long(1) * &common, long(words) * &common, long(2 * words), &common << 100, common]);
        }
        numbers.push((Z::from(1) << 320) - 1);
        numbers.push((Z::from(1) << 256) + 1);
        let mut pair = (Z::from(0), Z::from(1));
        for index in 0..700 {
            pair = (pair.1.clone(), pair.0 + pair.1);
            if index > 85 && index % 60 < 2 {
                numbers.push(pair.1.clone());
            }
        }
        numbers
    }

    #[test]
    fn divisors_are_those_of_another_method() {
        let numbers = numbers();
        for a in &numbers {
            for b in &numbers {
                assert_eq!(gcd(a, b), a.gcd(b), "{a} {b}");
            }
        }
    }

    fn natural(max_words: usize) -> impl Strategy<Value = Z> {
        // runs of zeros and ones, where carries and estimates of quotients go wrong if they do
        let word = prop_oneof![Just(0), Just(u32::MAX), Just(1), Just(1 << 31), any::<u32>()];
        proptest::collection::vec(word, 0..=2 * max_words).prop_map(|words| Z::new(num_bigint::Sign::Plus, words))
    }

    proptest! {
        #[test]
        fn divisors_of_double_words_are_those_of_num_integer(a: u128, b: u128, shift in 0_u32..128, other in 0_u32..128) {
            let (a, b) = (a >> shift, b >> other);
            prop_assert_eq!(gcd128(a, b), a.gcd(&b));
            prop_assert_eq!(word_gcd(a as u64, b as u64), (a as u64).gcd(&(b as u64)));
        }

        #[test]
        fn planted_divisors_are_found(a in natural(9), b in natural(9), common in natural(6)) {
            prop_assert_eq!(gcd(&a, &b), a.gcd(&b));
            let (a, b) = (a * &common, b * &common);
            prop_assert_eq!(gcd(&a, &b), a.gcd(&b));
            prop_assert_eq!(gcd(&a, &common), a.gcd(&common));
        }
    }

    #[test]
    fn divisors_around_the_ends_of_words_are_found() {
        for bits in [1_u32, 62, 63, 64, 65, 127, 128, 129, 191, 192, 193, 256] {
            for other in [1_u32, 63, 64, 128, 129, 192, 255] {
                let (a, b) = (Z::from(2).pow(bits), Z::from(2).pow(other));
                for (x, y) in [(&a - 1, &b - 1), (&a + 1, &b - 1), (&a * &b, &b + 1), (&a * (&b - 1), &b - 1)] {
                    assert_eq!(gcd(&x, &y), x.gcd(&y), "{x} {y}");
                }
            }
        }
    }
}
