//! Greatest common divisors: binary for one and two words, Lehmer's for more.

use super::limbs::{Divisor, Limbs, compare, trim, two_words};

/// One subtraction and one shift for each step, and no branch but the loop's.
pub(super) fn gcd64(a: u64, b: u64) -> u64 {
    if a == 0 || b == 0 {
        return a | b;
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

pub(super) fn gcd128(a: u128, b: u128) -> u128 {
    if let (Ok(a), Ok(b)) = (u64::try_from(a), u64::try_from(b)) {
        return gcd64(a, b).into();
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
            return u128::from(gcd64(a, b)) << twos;
        }
        let difference = a.abs_diff(b);
        a = a.min(b);
        b = difference >> difference.trailing_zeros();
    }
    a << twos
}

/// Greatest common divisor of numbers of any size, without leading zeros.
///
/// Lehmer's method: the leading 62 bits of both decide several quotients of Euclid's method at once.
///
/// # Source
/// Knuth, The Art of Computer Programming 2, section 4.5.2, algorithm L.
pub(super) fn gcd(a: &[u64], b: &[u64]) -> Limbs {
    let (mut a, mut b) = (Limbs::from_slice(a), Limbs::from_slice(b));
    if compare(&a, &b).is_lt() {
        std::mem::swap(&mut a, &mut b);
    }
    let mut next = Limbs::new();
    while b.len() > 2 {
        match cofactors(&a, &b) {
            Some([p, q, r, s]) => {
                next.clear();
                let (mut carry, mut next_carry) = (0_i128, 0_i128);
                for (index, word) in a.iter_mut().enumerate() {
                    let (x, y) = (i128::from(*word), i128::from(b.get(index).copied().unwrap_or(0)));
                    // cofactors below 2^62: sums stay below 2^127
                    carry += i128::from(p) * x + i128::from(q) * y;
                    next_carry += i128::from(r) * x + i128::from(s) * y;
                    *word = carry as u64;
                    next.push(next_carry as u64);
                    (carry, next_carry) = (carry >> 64, next_carry >> 64);
                }
                trim(&mut a);
                trim(&mut next);
                std::mem::swap(&mut b, &mut next);
            }
            None => {
                Divisor::new(&b).reduce(&mut a);
                std::mem::swap(&mut a, &mut b);
            }
        }
    }
    if b.is_empty() {
        return a;
    }
    if a.len() > 2 {
        Divisor::new(&b).reduce(&mut a);
    }
    let found = gcd128(two_words(&a), two_words(&b));
    let mut words = Limbs::from_slice(&[found as u64, (found >> 64) as u64]);
    trim(&mut words);
    words
}

/// `p, q, r, s` such that `p a + q b > r a + s b ≥ 0` are two consecutive remainders of Euclid's method; `None` if the
/// leading bits do not decide a single quotient.
fn cofactors(a: &[u64], b: &[u64]) -> Option<[i64; 4]> {
    let shift = a[a.len() - 1].leading_zeros();
    let leading = |words: &[u64]| {
        let word = |index: usize| words.get(index).copied().unwrap_or(0);
        let top = u128::from(word(a.len() - 1)) << 64 | u128::from(word(a.len() - 2));
        // 62 bits, so that nothing below overflows
        ((top << shift) >> 66) as i64
    };
    let (mut x, mut y) = (leading(a), leading(b));
    let [mut p, mut q, mut r, mut s] = [1_i64, 0, 0, 1];
    while y + r != 0 && y + s != 0 {
        let quotient = (x + p) / (y + r);
        let rest = (x + q) - quotient.checked_mul(y + s)?;
        if rest < 0 || rest >= y + s {
            break;
        }
        (p, r) = (r, p - quotient * r);
        (q, s) = (s, q - quotient * s);
        (x, y) = (y, x - quotient * y);
    }
    (q != 0).then_some([p, q, r, s])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Z;
    use num_integer::Integer as _;
    use num_traits::One as _;
    use proptest::prelude::*;

    fn words(value: &Z) -> Vec<u64> {
        value.magnitude().iter_u64_digits().collect()
    }

    fn natural(max_words: usize) -> impl Strategy<Value = Z> {
        // runs of zeros and ones, where carries and quotient estimates go wrong if they do
        let word = prop_oneof![Just(0), Just(u32::MAX), Just(1), Just(1 << 31), any::<u32>()];
        proptest::collection::vec(word, 0..=2 * max_words).prop_map(|words| Z::new(num_bigint::Sign::Plus, words))
    }

    fn check(a: &Z, b: &Z) {
        assert_eq!(gcd(&words(a), &words(b)).as_slice(), words(&a.gcd(b)), "{a}, {b}");
    }

    proptest! {
        #[test]
        fn short_divisors_are_those_of_num_integer(a: u128, b: u128, shift in 0_u32..128, other in 0_u32..128) {
            let (a, b) = (a >> shift, b >> other);
            prop_assert_eq!(gcd128(a, b), a.gcd(&b));
            prop_assert_eq!(gcd64(a as u64, b as u64), (a as u64).gcd(&(b as u64)));
        }

        #[test]
        fn lehmer_finds_planted_divisors(a in natural(9), b in natural(9), common in natural(6)) {
            check(&a, &b);
            check(&(&a * &common), &(&b * &common));
            check(&(&a * &common), &common);
        }
    }

    /// Every quotient is one: the longest run of steps for the size.
    #[test]
    fn lehmer_finds_that_fibonacci_numbers_are_coprime() {
        let (mut a, mut b) = (Z::one(), Z::one());
        for _ in 0..2000 {
            (a, b) = (&a + &b, a);
            check(&a, &b);
        }
    }

    #[test]
    fn lehmer_finds_divisors_around_the_ends_of_words() {
        for bits in [1_u32, 62, 63, 64, 65, 127, 128, 129, 191, 192, 193, 256] {
            for other in [1_u32, 63, 64, 128, 129, 192, 255] {
                let (a, b) = (Z::from(2).pow(bits), Z::from(2).pow(other));
                for (x, y) in [(&a - 1, &b - 1), (&a + 1, &b - 1), (&a * &b, &b + 1), (&a * (&b - 1), &b - 1)] {
                    check(&x, &y);
                }
            }
        }
    }
}
