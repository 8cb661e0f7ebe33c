//! Cross products and determinants of rows with three entries, exact on every rung whatever their size.

use super::gcd::word_gcd;
use super::quad::Quad;
use super::wide::{Term, sum_sign};
use super::{Entries, Int, Overflow, Z};
use std::cmp::Ordering;
use std::fmt::Debug;

/// Arithmetic of three-dimensional rows that never overflows, except where a result has to fit the rung again.
pub trait Minors: Sized {
    /// Holds a 2×2 minor of any two rows.
    type Minor: Clone + Debug + Default;

    /// `a × b`.
    fn minors(a: &[Self; 3], b: &[Self; 3]) -> [Self::Minor; 3];

    /// `a · b`.
    ///
    /// # Errors
    /// [`Overflow`] if it does not fit what holds minors.
    fn product(a: &[Self; 3], b: &[Self; 3]) -> Result<Self::Minor, Overflow>;

    /// The determinant of three rows.
    fn determinant(a: &[Self; 3], b: &[Self; 3], c: &[Self; 3]) -> Z;

    /// Sign of a minor.
    fn minor_sign(minor: &Self::Minor) -> Ordering;

    /// Sign of `row · minors`; with `minors` of two rows, of the determinant of all three.
    fn side(row: &[Self; 3], minors: &[Self::Minor; 3]) -> Ordering;

    /// Sign of `a · b`.
    fn side_of(a: &[Self; 3], b: &[Self; 3]) -> Ordering;

    /// The primitive row on the same ray.
    ///
    /// # Errors
    /// [`Overflow`] if it does not fit.
    fn on_ray(minors: &[Self::Minor; 3]) -> Result<[Self; 3], Overflow>;

    /// The primitive row on the same ray.
    fn shortest(row: [Self; 3]) -> [Self; 3];
}

impl Minors for i64 {
    type Minor = i128;

    #[inline]
    fn minors(a: &[i64; 3], b: &[i64; 3]) -> [i128; 3] {
        let product = |i: usize, j: usize| i128::from(a[i]) * i128::from(b[j]);
        // entries below 2^63: products below 2^126
        [product(1, 2) - product(2, 1), product(2, 0) - product(0, 2), product(0, 1) - product(1, 0)]
    }

    fn product(a: &[i64; 3], b: &[i64; 3]) -> Result<i128, Overflow> {
        Self::dot(a, b)
    }

    fn determinant(a: &[i64; 3], b: &[i64; 3], c: &[i64; 3]) -> Z {
        let minors = Self::minors(b, c);
        let product = |axis: usize| minors[axis].checked_mul(a[axis].into());
        let total = || product(0)?.checked_add(product(1)?)?.checked_add(product(2)?);
        total().map_or_else(|| a.iter().zip(minors).map(|(x, y)| Z::from(y) * x).sum(), Z::from)
    }

    #[inline]
    fn minor_sign(minor: &i128) -> Ordering {
        minor.cmp(&0)
    }

    #[inline]
    fn side(row: &[i64; 3], minors: &[i128; 3]) -> Ordering {
        let short = minors.map(|minor| minor as i64);
        let is_short =
            (0..3).all(|axis| i128::from(short[axis]) == minors[axis] && short[axis].unsigned_abs() < 1 << 62);
        if is_short {
            // below 3 · 2^63 · 2^62
            let product = |axis: usize| i128::from(row[axis]) * i128::from(short[axis]);
            return (product(0) + product(1) + product(2)).cmp(&0);
        }
        wide_side(row, minors)
    }

    #[inline]
    fn side_of(a: &[i64; 3], b: &[i64; 3]) -> Ordering {
        Self::side(a, &b.map(i128::from))
    }

    fn on_ray(minors: &[i128; 3]) -> Result<[i64; 3], Overflow> {
        if let [Ok(x), Ok(y), Ok(z)] = minors.map(i64::try_from)
            && x.min(y).min(z) > i64::MIN
        {
            return Ok(Self::shortest([x, y, z]));
        }
        let mut out = Entries::new();
        Self::primitive(minors, &mut out)?;
        Ok([out[0], out[1], out[2]])
    }

    fn shortest(row: [i64; 3]) -> [i64; 3] {
        let [x, y, z] = row.map(i64::unsigned_abs);
        // entries above the least one have a divisor below 2^63
        match divisor(x, y, z).cast_signed() {
            0 | 1 => row,
            divisor => row.map(|entry| entry / divisor),
        }
    }
}

fn wide_side(row: &[i64; 3], minors: &[i128; 3]) -> Ordering {
    side_in_192_bits(row, minors)
        .unwrap_or_else(|| sum_sign::<2, 4>([0, 1, 2].map(|axis| Term::of(row[axis].into(), minors[axis]))))
}

/// The sign unless the sum is within a bit or two of what 192 bits hold.
fn side_in_192_bits(row: &[i64; 3], minors: &[i128; 3]) -> Option<Ordering> {
    let (mut high, mut low) = (0_i128, 0_u128);
    for (entry, minor) in row.iter().zip(minors) {
        let entry = i128::from(*entry);
        // minor = upper 2^64 + lower with 0 ≤ lower < 2^64
        let (upper, lower) = (minor >> 64, (minor.cast_unsigned() & u128::from(u64::MAX)).cast_signed());
        let below = entry * lower;
        high = high.checked_add(entry * upper)?.checked_add(below >> 64)?;
        low += below.cast_unsigned() & u128::from(u64::MAX);
    }
    high = high.checked_add((low >> 64).cast_signed())?;
    Some(high.cmp(&0).then(if low & u128::from(u64::MAX) == 0 { Ordering::Equal } else { Ordering::Greater }))
}

fn divisor(x: u64, y: u64, z: u64) -> u64 {
    match word_gcd(x, y) {
        0 => z,
        1 => 1,
        both => word_gcd(both, z % both),
    }
}

impl Minors for i128 {
    type Minor = Quad;

    fn minors(a: &[i128; 3], b: &[i128; 3]) -> [Quad; 3] {
        let minor = |i: usize, j: usize| Quad::combination(a[i], b[j], -a[j], b[i]);
        [minor(1, 2), minor(2, 0), minor(0, 1)]
    }

    fn product(a: &[i128; 3], b: &[i128; 3]) -> Result<Quad, Overflow> {
        Self::dot(a, b)
    }

    fn determinant(a: &[i128; 3], b: &[i128; 3], c: &[i128; 3]) -> Z {
        let [a, b, c] = [a, b, c].map(|row| row.map(Z::from));
        a.iter().zip(&cross(&b, &c)).map(|(x, y)| x * y).sum()
    }

    fn minor_sign(minor: &Quad) -> Ordering {
        minor.sign()
    }

    fn side(row: &[i128; 3], minors: &[Quad; 3]) -> Ordering {
        sum_sign::<4, 6>([0, 1, 2].map(|axis| Term::of_quad(row[axis], &minors[axis])))
    }

    fn side_of(a: &[i128; 3], b: &[i128; 3]) -> Ordering {
        sum_sign::<2, 4>([0, 1, 2].map(|axis| Term::of(a[axis], b[axis])))
    }

    fn on_ray(minors: &[Quad; 3]) -> Result<[i128; 3], Overflow> {
        if let [Some(x), Some(y), Some(z)] = minors.map(|minor| minor.narrow()) {
            return Ok(Self::shortest([x, y, z]));
        }
        let mut out = Entries::new();
        Self::primitive(minors, &mut out)?;
        Ok([out[0], out[1], out[2]])
    }

    fn shortest(mut row: [i128; 3]) -> [i128; 3] {
        if let [Ok(x), Ok(y), Ok(z)] = row.map(i64::try_from)
            && x.min(y).min(z) > i64::MIN
        {
            return i64::shortest([x, y, z]).map(i128::from);
        }
        Self::make_primitive(&mut row);
        row
    }
}

/// `a × b`.
#[must_use]
pub fn cross(a: &[Z; 3], b: &[Z; 3]) -> [Z; 3] {
    let minor = |i: usize, j: usize| &a[i] * &b[j] - &a[j] * &b[i];
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::{Long, primitive_row};
    use std::ops::{Neg, Sub};

    const MOST: i64 = i64::MAX;
    const MOST_OF_ALL: i128 = i128::MAX;

    /// Rows with entries at the limits of the type, and differences of determinants that only the last bit decides.
    fn rows<T: Copy + Default + Sub<Output = T> + Neg<Output = T>>(most: T, one: T) -> Vec<[T; 3]> {
        let entries = [most, most - one, -most, one - most, one, T::default()];
        let triple = |k: usize| [entries[k % 6], entries[k / 6 % 6], entries[k / 36]];
        (0..216).step_by(5).map(triple).collect()
    }

    fn agree<T: Int>(rows: &[[T; 3]]) {
        let exact = |row: &[T; 3]| [0, 1, 2].map(|axis| row[axis].to_z());
        let product = |a: &[Z; 3], b: &[Z; 3]| a.iter().zip(b).map(|(x, y)| x * y).sum::<Z>();
        for (index, a) in rows.iter().enumerate() {
            let b = &rows[(7 * index + 3) % rows.len()];
            let (minors, expected) = (T::minors(a, b), cross(&exact(a), &exact(b)));
            let signs = expected.each_ref().map(|minor| minor.cmp(&Z::from(0)));
            assert_eq!([0, 1, 2].map(|axis| T::minor_sign(&minors[axis])), signs);
            let row = primitive_row(&expected.each_ref().map(|minor| minor.clone().into()));
            let row: Option<Vec<T>> = row.iter().map(T::from_z).collect();
            assert_eq!(T::on_ray(&minors).map(Vec::from).ok(), row, "{a:?} {b:?}");
            for c in rows {
                let volume = product(&exact(c), &expected);
                assert_eq!(T::side(c, &minors), volume.cmp(&Z::from(0)), "{c:?} {a:?} {b:?}");
                assert_eq!(T::determinant(c, a, b), volume);
                assert_eq!(T::side_of(c, a), product(&exact(c), &exact(a)).cmp(&Z::from(0)), "{c:?} {a:?}");
            }
        }
    }

    #[test]
    fn entries_of_any_size_have_the_signs_of_big_integers() {
        agree(&rows(MOST, 1_i64));
        agree(&rows(1_i64 << 40, 1));
        agree(&rows(1_i64 << 30, 1));
        agree(&rows(MOST_OF_ALL, 1_i128));
        agree(&rows(1_i128 << 90, 1));
        agree(&rows(1_i128 << 40, 1));
        let long = |row: [i128; 3]| row.map(|entry| Long::from_z(&(Z::from(entry) << 50)).expect("any size fits"));
        agree(&rows(MOST_OF_ALL, 1_i128).into_iter().map(long).collect::<Vec<_>>());
    }

    #[test]
    fn more_than_192_bits_are_told_apart() {
        let row = [MOST; 3];
        let minors = [i128::from(MOST) * i128::from(MOST) * 2 - 1; 3];
        assert_eq!(side_in_192_bits(&row, &minors), None);
        assert_eq!(i64::side(&row, &minors), Ordering::Greater);
        assert_eq!(i64::side(&row.map(|entry| -entry), &minors), Ordering::Less);
    }
}
