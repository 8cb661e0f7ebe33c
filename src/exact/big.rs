//! The rung of entries of any size.

use super::gcd::gcd;
use super::limbs::{Divisor, Limbs, add_product, compare, subtract};
use super::{Entries, Int, Overflow, Z};
use num_bigint::{BigUint, Sign};
use num_traits::{One as _, Zero as _};
use smallvec::SmallVec;
use std::cmp::Ordering;

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
        value.sign().cmp(&Sign::NoSign)
    }
    fn wide_negated(value: &Z) -> Z {
        -value
    }

    fn dot(a: &[Self], b: &[Self]) -> Result<Z, Overflow> {
        debug_assert_eq!(a.len(), b.len(), "rows of equal length have a dot product");
        let mut sum = Signed::default();
        for (x, y) in a.iter().zip(b).filter(|(x, y)| !x.is_zero() && !y.is_zero()) {
            sum.add_product(x.sign(), &words(x), y.sign(), &words(y));
        }
        Ok(sum.to_z())
    }

    fn combine(p: &Z, a: &[Self], q: &Z, b: &[Self], out: &mut Entries<Self>) -> Result<(), Overflow> {
        let (p_words, q_words) = (words(p), words(q));
        let mut row: SmallVec<[Signed; 16]> = SmallVec::with_capacity(a.len());
        for (x, y) in a.iter().zip(b) {
            let mut value = Signed::default();
            value.add_product(p.sign(), &p_words, x.sign(), &words(x));
            value.add_product(q.sign(), &q_words, y.sign(), &words(y));
            row.push(value);
        }
        divide_common(&mut row);
        out.extend(row.iter().map(Signed::to_z));
        Ok(())
    }

    fn primitive(wide: &[Z], out: &mut Entries<Self>) -> Result<(), Overflow> {
        let start = out.len();
        out.extend(wide.iter().cloned());
        Self::make_primitive(&mut out[start..]);
        Ok(())
    }

    fn make_primitive(row: &mut [Self]) {
        if row.iter().any(|value| value.magnitude().is_one()) {
            return;
        }
        let mut values: SmallVec<[Signed; 16]> = row.iter().map(Signed::of).collect();
        if divide_common(&mut values) {
            row.iter_mut().zip(&values).for_each(|(value, quotient)| *value = quotient.to_z());
        }
    }
}

fn words(value: &Z) -> Limbs {
    value.iter_u64_digits().collect()
}

/// A sign and the words of a magnitude.
#[derive(Default, Clone)]
struct Signed {
    is_negative: bool,
    magnitude: Limbs,
}

impl Signed {
    fn of(value: &Z) -> Self {
        Self { is_negative: value.sign() == Sign::Minus, magnitude: words(value) }
    }

    fn to_z(&self) -> Z {
        let halves = self.magnitude.iter().flat_map(|word| [*word as u32, (word >> 32) as u32]);
        let magnitude = BigUint::new(halves.collect());
        Z::from_biguint(if self.is_negative { Sign::Minus } else { Sign::Plus }, magnitude)
    }

    /// Adds the product of two numbers given by sign and magnitude.
    fn add_product(&mut self, a: Sign, a_words: &[u64], b: Sign, b_words: &[u64]) {
        let is_negative = (a == Sign::Minus) != (b == Sign::Minus);
        if self.magnitude.is_empty() || self.is_negative == is_negative {
            add_product(&mut self.magnitude, a_words, b_words);
            self.is_negative = is_negative;
            return;
        }
        let mut product = Limbs::new();
        add_product(&mut product, a_words, b_words);
        if subtract(&mut self.magnitude, &product).is_lt() {
            self.is_negative = is_negative;
        }
    }
}

/// Divides all values by their greatest common divisor; whether that is more than one.
fn divide_common(row: &mut [Signed]) -> bool {
    // from the smallest entry, so that all others are reduced by a remainder before the costly divisor
    let nonzero = row.iter().filter(|value| !value.magnitude.is_empty());
    let Some(smallest) = nonzero.min_by(|a, b| compare(&a.magnitude, &b.magnitude)) else { return false };
    let mut common = smallest.magnitude.clone();
    let mut divisor = Divisor::new(&common);
    for value in row.iter() {
        if common.as_slice() == [1] {
            return false;
        }
        let mut rest = value.magnitude.clone();
        divisor.reduce(&mut rest);
        if !rest.is_empty() {
            common = gcd(&common, &rest);
            divisor = Divisor::new(&common);
        }
    }
    if common.as_slice() == [1] {
        return false;
    }
    let mut quotient = Limbs::new();
    for value in row {
        divisor.divide_into(&mut value.magnitude, &mut quotient);
        std::mem::swap(&mut value.magnitude, &mut quotient);
    }
    true
}
