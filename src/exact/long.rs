//! The rung of entries of any size: signed integers whose words stay in place while they are few.

use super::gcd::words_gcd;
use super::limbs::{Divisor, Limbs, add_product, compare, negate, significant, subtract_product, to_z};
use super::{Entries, Int, Minors, Overflow, Z};
use num_bigint::Sign;
use smallvec::SmallVec;
use std::cmp::Ordering;

/// An integer of any size, in a place of its own only beyond 384 bits.
#[derive(Debug, Default, PartialEq, Eq, Hash)]
pub struct Long {
    /// Not for zero.
    is_negative: bool,
    magnitude: Limbs,
}

impl Clone for Long {
    fn clone(&self) -> Self {
        Self { is_negative: self.is_negative, magnitude: Limbs::from_slice(&self.magnitude) }
    }

    fn clone_from(&mut self, source: &Self) {
        self.is_negative = source.is_negative;
        self.magnitude.clear();
        self.magnitude.extend_from_slice(&source.magnitude);
    }
}

impl Ord for Long {
    fn cmp(&self, other: &Self) -> Ordering {
        match (self.is_negative, other.is_negative) {
            (false, false) => compare(&self.magnitude, &other.magnitude),
            (true, true) => compare(&other.magnitude, &self.magnitude),
            (one, other) => other.cmp(&one),
        }
    }
}

impl PartialOrd for Long {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Int for Long {
    type Wide = Self;

    fn from_z(value: &Z) -> Option<Self> {
        Some(Self { is_negative: value.sign() == Sign::Minus, magnitude: value.iter_u64_digits().collect() })
    }
    fn to_z(&self) -> Z {
        let magnitude = to_z(&self.magnitude);
        if self.is_negative { -magnitude } else { magnitude }
    }
    fn unit() -> Self {
        Self { is_negative: false, magnitude: Limbs::from_slice(&[1]) }
    }
    fn sign(&self) -> Ordering {
        match (self.magnitude.is_empty(), self.is_negative) {
            (true, _) => Ordering::Equal,
            (false, true) => Ordering::Less,
            (false, false) => Ordering::Greater,
        }
    }
    fn negated(&self) -> Self {
        let mut negated = self.clone();
        negated.is_negative = !self.is_negative && !self.magnitude.is_empty();
        negated
    }
    fn widen(&self) -> Self {
        self.clone()
    }
    fn wide_sign(value: &Self) -> Ordering {
        value.sign()
    }
    fn wide_negated(value: &Self) -> Self {
        value.negated()
    }

    fn dot(a: &[Self], b: &[Self]) -> Result<Self, Overflow> {
        debug_assert_eq!(a.len(), b.len(), "rows of equal length have a dot product");
        Ok(sum(a.iter().zip(b)))
    }

    fn combine(p: &Self, a: &[Self], q: &Self, b: &[Self], out: &mut Entries<Self>) -> Result<(), Overflow> {
        let longest = |row: &[Self]| row.iter().map(|value| value.magnitude.len()).max().unwrap_or(0);
        let size = (p.magnitude.len() + longest(a)).max(q.magnitude.len() + longest(b)) + 1;
        let mut row = Row::new(size);
        for (x, y) in a.iter().zip(b) {
            row.push(|words| {
                add(words, p, x);
                add(words, q, y);
                settle(words)
            });
        }
        row.divide_common();
        row.append_to(out);
        Ok(())
    }

    fn primitive(wide: &[Self], out: &mut Entries<Self>) -> Result<(), Overflow> {
        let start = out.len();
        out.extend(wide.iter().cloned());
        Self::make_primitive(&mut out[start..]);
        Ok(())
    }

    fn make_primitive(entries: &mut [Self]) {
        if entries.iter().any(|value| value.magnitude.as_slice() == [1]) {
            return;
        }
        let mut row = Row::new(entries.iter().map(|value| value.magnitude.len()).max().unwrap_or(0));
        for value in entries.iter() {
            row.push(|words| {
                words[..value.magnitude.len()].copy_from_slice(&value.magnitude);
                value.is_negative
            });
        }
        if row.divide_common() {
            for (index, value) in entries.iter_mut().enumerate() {
                *value = row.entry(index);
            }
        }
    }
}

impl Minors for Long {
    type Minor = Self;

    fn minors(a: &[Self; 3], b: &[Self; 3]) -> [Self; 3] {
        let less = a.each_ref().map(Self::negated);
        let minor = |i: usize, j: usize| sum([(&a[i], &b[j]), (&less[j], &b[i])].into_iter());
        [minor(1, 2), minor(2, 0), minor(0, 1)]
    }

    fn product(a: &[Self; 3], b: &[Self; 3]) -> Result<Self, Overflow> {
        Self::dot(a, b)
    }

    fn determinant(a: &[Self; 3], b: &[Self; 3], c: &[Self; 3]) -> Z {
        sum(a.iter().zip(&Self::minors(b, c))).to_z()
    }

    fn minor_sign(minor: &Self) -> Ordering {
        minor.sign()
    }

    fn side(row: &[Self; 3], minors: &[Self; 3]) -> Ordering {
        sum(row.iter().zip(minors)).sign()
    }

    fn side_of(a: &[Self; 3], b: &[Self; 3]) -> Ordering {
        Self::side(a, b)
    }

    fn on_ray(minors: &[Self; 3]) -> Result<[Self; 3], Overflow> {
        Ok(Self::shortest(minors.clone()))
    }

    fn shortest(mut row: [Self; 3]) -> [Self; 3] {
        Self::make_primitive(&mut row);
        row
    }
}

/// Sum of products; fewer than 2^63 of them.
fn sum<'a>(products: impl Iterator<Item = (&'a Long, &'a Long)> + Clone) -> Long {
    let size = products.clone().map(|(x, y)| x.magnitude.len() + y.magnitude.len()).max().unwrap_or(0);
    let mut magnitude = Limbs::from_elem(0, size + 1);
    products.for_each(|(x, y)| add(&mut magnitude, x, y));
    let is_negative = settle(&mut magnitude);
    magnitude.truncate(significant(&magnitude));
    Long { is_negative, magnitude }
}

/// Adds `x y` in two's complement.
fn add(words: &mut [u64], x: &Long, y: &Long) {
    if x.is_negative == y.is_negative {
        add_product(words, &x.magnitude, &y.magnitude);
    } else {
        subtract_product(words, &x.magnitude, &y.magnitude);
    }
}

/// From two's complement to the magnitude; whether the number is negative.
fn settle(words: &mut [u64]) -> bool {
    let is_negative = words.last().is_some_and(|top| top >> 63 == 1);
    if is_negative {
        negate(words);
    }
    is_negative
}

/// Entries of a row by their signs and magnitudes, all in one place.
struct Row {
    /// Words an entry.
    size: usize,
    words: SmallVec<[u64; 128]>,
    is_negative: SmallVec<[bool; 16]>,
}

impl Row {
    fn new(size: usize) -> Self {
        Self { size: size.max(1), words: SmallVec::new(), is_negative: SmallVec::new() }
    }

    /// Appends the entry of which `write` puts the magnitude into a place of zeros and returns whether it is negative.
    fn push(&mut self, write: impl FnOnce(&mut [u64]) -> bool) {
        let start = self.words.len();
        self.words.resize(start + self.size, 0);
        self.is_negative.push(write(&mut self.words[start..]));
    }

    fn magnitudes(&self) -> impl Iterator<Item = &[u64]> {
        self.words.chunks_exact(self.size).map(|words| &words[..significant(words)])
    }

    fn entry(&self, index: usize) -> Long {
        let words = &self.words[index * self.size..(index + 1) * self.size];
        let magnitude = Limbs::from_slice(&words[..significant(words)]);
        Long { is_negative: self.is_negative[index] && !magnitude.is_empty(), magnitude }
    }

    fn append_to(&self, out: &mut Entries<Long>) {
        out.extend((0..self.is_negative.len()).map(|index| self.entry(index)));
    }

    /// Divides all entries by their greatest common divisor; whether that is more than one.
    fn divide_common(&mut self) -> bool {
        // from the smallest entry, so that all others are reduced by a remainder before the costly divisor
        let nonzero = self.magnitudes().filter(|words| !words.is_empty());
        let Some(smallest) = nonzero.min_by(|a, b| compare(a, b)) else { return false };
        let mut common = Limbs::from_slice(smallest);
        let mut quotients = SmallVec::<[u64; 128]>::new();
        let mut value = Limbs::new();
        'divisor: loop {
            if common.as_slice() == [1] {
                return false;
            }
            let divisor = Divisor::new(&common);
            quotients.clear();
            quotients.resize(self.words.len(), 0);
            for (words, quotient) in self.magnitudes().zip(quotients.chunks_exact_mut(self.size)) {
                value.clear();
                value.extend_from_slice(words);
                divisor.divide_into(&mut value, quotient);
                if !value.is_empty() {
                    common = words_gcd(common, value.clone());
                    continue 'divisor;
                }
            }
            self.words = quotients;
            return true;
        }
    }
}
