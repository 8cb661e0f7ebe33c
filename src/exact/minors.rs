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
        Z::determinant(&a, &b, &c)
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

impl Minors for Z {
    type Minor = Z;

    fn minors(a: &[Z; 3], b: &[Z; 3]) -> [Z; 3] {
        let minor = |i: usize, j: usize| &a[i] * &b[j] - &a[j] * &b[i];
        [minor(1, 2), minor(2, 0), minor(0, 1)]
    }

    fn product(a: &[Z; 3], b: &[Z; 3]) -> Result<Z, Overflow> {
        Self::dot(a, b)
    }

    fn determinant(a: &[Z; 3], b: &[Z; 3], c: &[Z; 3]) -> Z {
        a.iter().zip(&Self::minors(b, c)).map(|(x, y)| x * y).sum()
    }

    fn minor_sign(minor: &Z) -> Ordering {
        minor.sign().cmp(&num_bigint::Sign::NoSign)
    }

    fn side(row: &[Z; 3], minors: &[Z; 3]) -> Ordering {
        Self::minor_sign(&row.iter().zip(minors).map(|(x, y)| x * y).sum())
    }

    fn side_of(a: &[Z; 3], b: &[Z; 3]) -> Ordering {
        Self::side(a, b)
    }

    fn on_ray(minors: &[Z; 3]) -> Result<[Z; 3], Overflow> {
        Ok(Self::shortest(minors.clone()))
    }

    fn shortest(mut row: [Z; 3]) -> [Z; 3] {
        Self::make_primitive(&mut row);
        row
    }
}

#[cfg(test)]
mod tests {
    use super::*;
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
        for (index, a) in rows.iter().enumerate() {
            let b = &rows[(7 * index + 3) % rows.len()];
            let (minors, expected) = (T::minors(a, b), Z::minors(&exact(a), &exact(b)));
            assert_eq!([0, 1, 2].map(|axis| T::minor_sign(&minors[axis])), expected.each_ref().map(Z::minor_sign));
            match (T::on_ray(&minors), Z::on_ray(&expected).map(|row| row.map(|value| T::from_z(&value)))) {
                (Ok(ray), Ok(row)) => assert_eq!(ray.map(Some), row),
                (ray, Ok(row)) => assert!(ray.is_err() && row.contains(&None), "{a:?} {b:?}"),
                (_, Err(_)) => unreachable!("integers of any size do not overflow"),
            }
            for c in rows {
                assert_eq!(T::side(c, &minors), Z::side(&exact(c), &expected), "{c:?} {a:?} {b:?}");
                assert_eq!(T::determinant(c, a, b), Z::determinant(&exact(c), &exact(a), &exact(b)));
                assert_eq!(T::side_of(c, a), Z::side_of(&exact(c), &exact(a)), "{c:?} {a:?}");
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
