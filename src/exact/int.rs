//! The integers that the cone kernel runs on: checked `i64`, then `i128`, then [`Z`].
//!
//! A computation is written once for [`Int`] and run by [`climb`]: whatever does not fit its rung is an [`Overflow`], and
//! the computation starts again one rung higher. Nothing wraps. On the machine rungs a row is stored in the rung's
//! type and combined in 128 bits or more, so a rung overflows when a primitive result does not fit it or a dot product
//! does not fit 127 bits, hardly ever because of an intermediate.

use super::{Entries, Minors, Z};
use num_integer::Integer as _;
use num_traits::{One as _, Signed as _, Zero as _};
use std::cmp::Ordering;
use std::fmt::Debug;
use std::hash::Hash;

/// A result does not fit the integer type in use; run again one rung higher.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("the result does not fit the integer type in use")]
pub struct Overflow;

/// The integer types, from fast to unbounded.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Rung {
    /// `i64` entries.
    Word,
    /// `i128` entries.
    DoubleWord,
    /// [`Z`] entries.
    Big,
}

/// A computation that can run on every rung.
pub trait Ladder {
    /// What it returns, the same on every rung.
    type Output;

    /// Runs on the integers `T`.
    ///
    /// # Errors
    /// [`Overflow`] if a result does not fit `T`; never for [`Z`].
    fn run<T: Int>(&self) -> Result<Self::Output, Overflow>;
}

/// Runs `job` on the lowest rung from `lowest` up that holds all of its results, and says which that was.
pub fn climb<J: Ladder>(job: &J, lowest: Rung) -> (J::Output, Rung) {
    if lowest == Rung::Word
        && let Ok(output) = job.run::<i64>()
    {
        return (output, Rung::Word);
    }
    if lowest <= Rung::DoubleWord
        && let Ok(output) = job.run::<i128>()
    {
        return (output, Rung::DoubleWord);
    }
    (job.run::<Z>().expect("integers of any size do not overflow"), Rung::Big)
}

/// Integer entries of primitive rows; the least value of a machine type (`i64::MIN`) is not one of them.
pub trait Int: Minors + Clone + Ord + Hash + Debug + Default + Send + Sync + 'static {
    /// Holds a dot product of two rows.
    type Wide: Clone + Debug;

    /// The value, if it fits.
    fn from_z(value: &Z) -> Option<Self>;
    /// The value.
    fn to_z(&self) -> Z;
    /// One.
    fn unit() -> Self;
    /// Its sign, as a comparison with zero.
    fn sign(&self) -> Ordering;
    /// Its negative; machine rungs never hold their type's minimum, so this cannot overflow.
    fn negated(&self) -> Self;
    /// The wide form.
    fn widen(&self) -> Self::Wide;
    /// Sign of a wide value.
    fn wide_sign(value: &Self::Wide) -> Ordering;
    /// Negative of a wide value.
    fn wide_negated(value: &Self::Wide) -> Self::Wide;

    /// `a · b` of rows of equal length.
    ///
    /// # Errors
    /// [`Overflow`] if the sum does not fit [`Int::Wide`].
    fn dot(a: &[Self], b: &[Self]) -> Result<Self::Wide, Overflow>;

    /// Appends the primitive form of `p a + q b` to `out`.
    ///
    /// # Errors
    /// [`Overflow`] if the primitive row does not fit.
    fn combine(p: &Self::Wide, a: &[Self], q: &Self::Wide, b: &[Self], out: &mut Entries<Self>)
    -> Result<(), Overflow>;

    /// Appends the primitive form of a wide row to `out`.
    ///
    /// # Errors
    /// [`Overflow`] if the primitive row does not fit.
    fn primitive(wide: &[Self::Wide], out: &mut Entries<Self>) -> Result<(), Overflow>;

    /// Divides `row` by the greatest common divisor of its entries.
    fn make_primitive(row: &mut [Self]);
}

/// What the machine rungs share.
macro_rules! machine_entries {
    () => {
        type Wide = i128;

        fn from_z(value: &Z) -> Option<Self> {
            Self::try_from(value).ok().filter(|v| *v != Self::MIN)
        }
        fn to_z(&self) -> Z {
            Z::from(*self)
        }
        fn unit() -> Self {
            1
        }
        fn sign(&self) -> Ordering {
            self.cmp(&0)
        }
        fn negated(&self) -> Self {
            -self
        }
        fn widen(&self) -> i128 {
            i128::from(*self)
        }
        fn wide_sign(value: &i128) -> Ordering {
            value.cmp(&0)
        }
        fn wide_negated(value: &i128) -> i128 {
            -value
        }

        fn make_primitive(row: &mut [Self]) {
            let divisor = row.iter().fold(0_u128, |g, v| gcd(g, v.unsigned_abs().into()));
            if divisor > 1 {
                let divisor = Self::try_from(divisor).expect("a divisor of entries above the least one fits");
                row.iter_mut().for_each(|v| *v /= divisor);
            }
        }
    };
}

impl Int for i64 {
    machine_entries!();

    fn dot(a: &[Self], b: &[Self]) -> Result<i128, Overflow> {
        debug_assert_eq!(a.len(), b.len(), "rows of equal length have a dot product");
        let mut sum = 0_i128;
        for (x, y) in a.iter().zip(b) {
            sum = sum.checked_add(i128::from(*x) * i128::from(*y)).ok_or(Overflow)?;
        }
        if sum == i128::MIN { Err(Overflow) } else { Ok(sum) }
    }

    fn combine(p: &i128, a: &[Self], q: &i128, b: &[Self], out: &mut Entries<Self>) -> Result<(), Overflow> {
        match (i64::try_from(*p), i64::try_from(*q)) {
            // |p|, |q| ≤ 2^63 and entries below 2^63: sums stay below 2^127
            (Ok(p), Ok(q)) => {
                let entry = |x: i64, y: i64| Some(i128::from(p) * i128::from(x) + i128::from(q) * i128::from(y));
                narrowed(a, b, entry, out)
            }
            _ => {
                let (p, q) = coprime(*p, *q);
                narrowed(a, b, |x, y| wide_combination(p, x.into(), q, y.into()), out)
            }
        }
    }

    fn primitive(wide: &[i128], out: &mut Entries<Self>) -> Result<(), Overflow> {
        let divisor = wide.iter().fold(0_u128, |g, v| gcd(g, v.unsigned_abs())).max(1);
        for value in wide {
            out.push(narrow(*value, divisor).ok_or(Overflow)?);
        }
        Ok(())
    }
}

impl Int for i128 {
    machine_entries!();

    fn dot(a: &[Self], b: &[Self]) -> Result<i128, Overflow> {
        debug_assert_eq!(a.len(), b.len(), "rows of equal length have a dot product");
        let mut sum = 0_i128;
        for (x, y) in a.iter().zip(b) {
            sum = x.checked_mul(*y).and_then(|product| sum.checked_add(product)).ok_or(Overflow)?;
        }
        if sum == i128::MIN { Err(Overflow) } else { Ok(sum) }
    }

    fn combine(p: &i128, a: &[Self], q: &i128, b: &[Self], out: &mut Entries<Self>) -> Result<(), Overflow> {
        let (p, q) = coprime(*p, *q);
        let start = out.len();
        for (x, y) in a.iter().zip(b) {
            match wide_combination(p, *x, q, *y) {
                Some(value) => out.push(value),
                None => {
                    out.truncate(start);
                    return combine_through_big(p, a, q, b, out);
                }
            }
        }
        Self::make_primitive(&mut out[start..]);
        Ok(())
    }

    fn primitive(wide: &[i128], out: &mut Entries<Self>) -> Result<(), Overflow> {
        let start = out.len();
        out.extend_from_slice(wide);
        Self::make_primitive(&mut out[start..]);
        Ok(())
    }
}

impl Int for Z {
    type Wide = Z;

    fn from_z(value: &Z) -> Option<Self> {
        Some(value.clone())
    }
    fn to_z(&self) -> Z {
        self.clone()
    }
    fn unit() -> Self {
        Z::one()
    }
    fn sign(&self) -> Ordering {
        Self::wide_sign(self)
    }
    fn negated(&self) -> Self {
        -self
    }
    fn widen(&self) -> Z {
        self.clone()
    }
    fn wide_sign(value: &Z) -> Ordering {
        value.sign().cmp(&num_bigint::Sign::NoSign)
    }
    fn wide_negated(value: &Z) -> Z {
        -value
    }

    fn dot(a: &[Self], b: &[Self]) -> Result<Z, Overflow> {
        debug_assert_eq!(a.len(), b.len(), "rows of equal length have a dot product");
        Ok(a.iter().zip(b).map(|(x, y)| x * y).sum())
    }

    fn combine(p: &Z, a: &[Self], q: &Z, b: &[Self], out: &mut Entries<Self>) -> Result<(), Overflow> {
        let start = out.len();
        out.extend(a.iter().zip(b).map(|(x, y)| p * x + q * y));
        Self::make_primitive(&mut out[start..]);
        Ok(())
    }

    fn primitive(wide: &[Z], out: &mut Entries<Self>) -> Result<(), Overflow> {
        let start = out.len();
        out.extend(wide.iter().cloned());
        Self::make_primitive(&mut out[start..]);
        Ok(())
    }

    fn make_primitive(row: &mut [Self]) {
        // from the smallest entry, so that all others are reduced by a remainder before the costly divisor
        let nonzero = row.iter().filter(|value| !value.is_zero());
        let Some(mut divisor) = nonzero.min_by_key(|value| value.magnitude()).map(|value| value.abs()) else { return };
        for value in row.iter() {
            if divisor.is_one() {
                return;
            }
            let remainder = value % &divisor;
            if !remainder.is_zero() {
                divisor = super::gcd::gcd(&divisor, &remainder);
            }
        }
        if !divisor.is_one() {
            row.iter_mut().for_each(|value| *value /= &divisor);
        }
    }
}

/// The i128 rung's way out when a product needs more than 128 bits but the primitive row may not.
fn combine_through_big(p: i128, a: &[i128], q: i128, b: &[i128], out: &mut Entries<i128>) -> Result<(), Overflow> {
    let mut row: Vec<Z> = a.iter().zip(b).map(|(x, y)| Z::from(p) * Z::from(*x) + Z::from(q) * Z::from(*y)).collect();
    Z::make_primitive(&mut row);
    for value in &row {
        out.push(i128::from_z(value).ok_or(Overflow)?);
    }
    Ok(())
}

fn coprime(p: i128, q: i128) -> (i128, i128) {
    match gcd(p.unsigned_abs(), q.unsigned_abs()) {
        0 | 1 => (p, q),
        divisor => match i128::try_from(divisor) {
            Ok(divisor) => (p / divisor, q / divisor),
            Err(_) => (p, q),
        },
    }
}

fn wide_combination(p: i128, x: i128, q: i128, y: i128) -> Option<i128> {
    p.checked_mul(x)?.checked_add(q.checked_mul(y)?).filter(|v| *v != i128::MIN)
}

/// Appends the entries made primitive; computing them twice is cheaper than keeping them.
fn narrowed(
    a: &[i64],
    b: &[i64],
    entry: impl Fn(i64, i64) -> Option<i128>,
    out: &mut Entries<i64>,
) -> Result<(), Overflow> {
    let mut divisor = 0_u128;
    for (x, y) in a.iter().zip(b) {
        divisor = gcd(divisor, entry(*x, *y).ok_or(Overflow)?.unsigned_abs());
        if divisor == 1 {
            break;
        }
    }
    let divisor = divisor.max(1);
    for (x, y) in a.iter().zip(b) {
        out.push(narrow(entry(*x, *y).ok_or(Overflow)?, divisor).ok_or(Overflow)?);
    }
    Ok(())
}

fn narrow(value: i128, divisor: u128) -> Option<i64> {
    let value = match (i64::try_from(value), i64::try_from(divisor)) {
        (Ok(value), Ok(divisor)) => value / divisor,
        _ => i64::try_from(value / i128::try_from(divisor).ok()?).ok()?,
    };
    Some(value).filter(|v| *v != i64::MIN)
}

fn gcd(a: u128, b: u128) -> u128 {
    let (mut a, mut b) = (a, b);
    if a == 1 || b == 1 {
        return 1;
    }
    while b != 0 {
        if let (Ok(a), Ok(b)) = (u64::try_from(a), u64::try_from(b)) {
            return a.gcd(&b).into();
        }
        (a, b) = (b, a % b);
    }
    a
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Doubles until the rung is too small; the answer must not depend on where that happens.
    struct PowerOfTwo(u32);

    impl Ladder for PowerOfTwo {
        type Output = Z;

        fn run<T: Int>(&self) -> Result<Z, Overflow> {
            let mut row: Entries<T> = [T::unit(), T::unit()].into_iter().collect();
            for _ in 0..self.0 {
                let mut next = Entries::new();
                // (2 a, 1) stays primitive
                let one = T::unit().widen();
                T::combine(&one, &[row[0].clone(), T::default()], &one, &[row[0].clone(), T::unit()], &mut next)?;
                row = next;
            }
            Ok(row[0].to_z())
        }
    }

    #[test]
    fn each_rung_is_left_exactly_when_its_type_is_full() {
        let two = Z::from(2);
        assert_eq!(climb(&PowerOfTwo(62), Rung::Word), (two.pow(62), Rung::Word));
        assert_eq!(climb(&PowerOfTwo(63), Rung::Word), (two.pow(63), Rung::DoubleWord));
        assert_eq!(climb(&PowerOfTwo(126), Rung::Word), (two.pow(126), Rung::DoubleWord));
        assert_eq!(climb(&PowerOfTwo(127), Rung::Word), (two.pow(127), Rung::Big));
        assert_eq!(climb(&PowerOfTwo(3), Rung::Big), (Z::from(8), Rung::Big));
    }

    #[test]
    fn a_product_beyond_128_bits_is_kept_when_the_primitive_row_fits() {
        let big = i128::MAX / 3;
        let mut out = Entries::new();
        i128::combine(&big, &[big, 0], &1, &[0, 0], &mut out).unwrap();
        assert_eq!(out.as_slice(), [1, 0]);
        let mut out = Entries::new();
        assert_eq!(i128::combine(&5, &[big, 1], &6, &[big, 0], &mut out), Err(Overflow));
    }

    #[test]
    fn the_least_machine_integer_is_never_stored() {
        assert_eq!(<i64 as Int>::from_z(&Z::from(i64::MIN)), None);
        assert_eq!(<i128 as Int>::from_z(&Z::from(i128::MIN)), None);
        let mut out = Entries::new();
        assert_eq!(i64::combine(&1, &[i64::MIN + 1, 1], &1, &[-1, 0], &mut out), Err(Overflow));
        assert_eq!(i128::dot(&[i128::MAX], &[2]), Err(Overflow));
        assert_eq!(i64::dot(&[i64::MAX; 3], &[i64::MAX; 3]), Err(Overflow));
    }
}
