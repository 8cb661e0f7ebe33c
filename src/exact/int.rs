//! The integers that the cone kernel runs on: checked `i64`, then `i128`, then [`Long`].
//!
//! A computation is written once for [`Int`] and run by [`climb`]: whatever does not fit its rung is an [`Overflow`], and
//! the computation starts again one rung higher. Nothing wraps. On the machine rungs a row is stored in the rung's
//! type and combined in twice as many bits or more, so a rung overflows when a primitive result does not fit it, hardly
//! ever because of an intermediate.

use super::gcd::word_gcd;
use super::{Entries, Long, Minors, Z};
use smallvec::SmallVec;
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
    /// [`Long`] entries.
    Big,
}

/// A computation that can run on every rung.
pub trait Ladder {
    /// What it returns, the same on every rung.
    type Output;

    /// Runs on the integers `T`.
    ///
    /// # Errors
    /// [`Overflow`] if a result does not fit `T`; never for [`Long`].
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
    (job.run::<Long>().expect("integers of any size do not overflow"), Rung::Big)
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
        fn widen(&self) -> Self::Wide {
            Self::Wide::from(*self)
        }
    };
}
pub(super) use machine_entries;

impl Int for i64 {
    type Wide = i128;

    machine_entries!();
    fn wide_sign(value: &i128) -> Ordering {
        value.cmp(&0)
    }
    fn wide_negated(value: &i128) -> i128 {
        -value
    }

    fn dot(a: &[Self], b: &[Self]) -> Result<i128, Overflow> {
        debug_assert_eq!(a.len(), b.len(), "rows of equal length have a dot product");
        let mut sum = 0_i128;
        for (x, y) in a.iter().zip(b) {
            sum = sum.checked_add(i128::from(*x) * i128::from(*y)).ok_or(Overflow)?;
        }
        if sum == i128::MIN { Err(Overflow) } else { Ok(sum) }
    }

    fn combine(p: &i128, a: &[Self], q: &i128, b: &[Self], out: &mut Entries<Self>) -> Result<(), Overflow> {
        let start = out.len();
        if let (Ok(p), Ok(q)) = (i64::try_from(*p), i64::try_from(*q)) {
            let mut is_over = false;
            out.extend(a.iter().zip(b).map(|(x, y)| {
                let ((left, first), (right, second)) = (p.overflowing_mul(*x), q.overflowing_mul(*y));
                let (sum, third) = left.overflowing_add(right);
                is_over |= first || second || third || sum == i64::MIN;
                sum
            }));
            if !is_over {
                Self::make_primitive(&mut out[start..]);
                return Ok(());
            }
            out.truncate(start);
            // |p|, |q| ≤ 2^63 and entries below 2^63: sums stay below 2^127
            let entry = |(x, y): (&i64, &i64)| i128::from(p) * i128::from(*x) + i128::from(q) * i128::from(*y);
            let wide: SmallVec<[i128; 16]> = a.iter().zip(b).map(entry).collect();
            return Self::primitive(&wide, out);
        }
        let wide = |row: &[i64]| row.iter().map(|value| i128::from(*value)).collect::<Entries<i128>>();
        let mut sum = Entries::new();
        i128::combine(&(*p).into(), &wide(a), &(*q).into(), &wide(b), &mut sum)?;
        for value in sum {
            out.push(i64::try_from(value).ok().filter(|v| *v != i64::MIN).ok_or(Overflow)?);
        }
        Ok(())
    }

    fn primitive(wide: &[i128], out: &mut Entries<Self>) -> Result<(), Overflow> {
        let mut row: SmallVec<[i128; 16]> = SmallVec::from_slice(wide);
        i128::make_primitive(&mut row);
        for value in row {
            out.push(i64::try_from(value).ok().filter(|v| *v != i64::MIN).ok_or(Overflow)?);
        }
        Ok(())
    }

    fn make_primitive(row: &mut [Self]) {
        // from the smallest entry, so that all others are reduced by a remainder before the costly divisor
        let smallest = row.iter().map(|value| value.unsigned_abs().wrapping_sub(1)).min();
        let Some(mut divisor) = smallest.map(|least| least.wrapping_add(1)) else { return };
        if divisor == 0 || divisor == 1 {
            return;
        }
        for value in row.iter() {
            let rest = value.unsigned_abs() % divisor;
            if rest != 0 {
                divisor = word_gcd(divisor, rest);
                if divisor == 1 {
                    return;
                }
            }
        }
        let divisor = divisor.cast_signed();
        row.iter_mut().for_each(|value| *value /= divisor);
    }
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
        i128::combine(&big.into(), &[big, 0], &1.into(), &[0, 0], &mut out).unwrap();
        assert_eq!(out.as_slice(), [1, 0]);
        let mut out = Entries::new();
        assert_eq!(i128::combine(&5.into(), &[big, 1], &6.into(), &[big, 0], &mut out), Err(Overflow));
    }

    #[test]
    fn the_least_machine_integer_is_never_stored() {
        assert_eq!(<i64 as Int>::from_z(&Z::from(i64::MIN)), None);
        assert_eq!(<i128 as Int>::from_z(&Z::from(i128::MIN)), None);
        let mut out = Entries::new();
        assert_eq!(i64::combine(&1, &[i64::MIN + 1, 1], &1, &[-1, 0], &mut out), Err(Overflow));
        assert_eq!(i128::dot(&[i128::MAX; 3], &[i128::MAX; 3]), Err(Overflow));
        assert_eq!(i64::dot(&[i64::MAX; 3], &[i64::MAX; 3]), Err(Overflow));
    }
}
