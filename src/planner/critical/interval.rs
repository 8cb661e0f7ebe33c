//! Enclosures in floating point, rounded outward: they only tell which polynomials need no exact look.

use crate::exact::{Q, to_f64};
use std::ops::{Add, Mul, Sub};

/// A closed interval that holds the number meant, however it was rounded.
#[derive(Debug, Clone, Copy)]
pub(super) struct Interval {
    low: f64,
    high: f64,
}

impl Interval {
    pub(super) fn between(low: &Q, high: &Q) -> Self {
        // a conversion may be off by a unit in the last place
        Self { low: to_f64(low), high: to_f64(high) }.wider().wider()
    }

    pub(super) fn of(value: &Q) -> Self {
        Self::between(value, value)
    }

    /// Whether zero may be meant; true for whatever overflowed.
    pub(super) fn may_be_zero(self) -> bool {
        !(self.low > 0.0 || self.high < 0.0)
    }

    /// One unit in the last place more on both sides, which covers the rounding of the operation just done.
    fn wider(self) -> Self {
        Self { low: self.low.next_down(), high: self.high.next_up() }
    }
}

impl Add for Interval {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { low: self.low + other.low, high: self.high + other.high }.wider()
    }
}

impl Sub for Interval {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self { low: self.low - other.high, high: self.high - other.low }.wider()
    }
}

impl Mul for Interval {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let ends = [self.low * other.low, self.low * other.high, self.high * other.low, self.high * other.high];
        if ends.iter().any(|end| end.is_nan()) {
            return Self { low: f64::NEG_INFINITY, high: f64::INFINITY };
        }
        let low = ends.into_iter().fold(f64::INFINITY, f64::min);
        let high = ends.into_iter().fold(f64::NEG_INFINITY, f64::max);
        Self { low, high }.wider()
    }
}

/// `[a b c] = det(a, b, c)` of any three of a list of vectors.
pub(super) struct Determinants {
    vectors: Vec<[Interval; 3]>,
    /// By `a`, `b` and `c` in turn, where they ascend.
    values: Vec<Interval>,
}

impl Determinants {
    pub(super) fn of(vectors: Vec<[Interval; 3]>) -> Self {
        let zero = Interval { low: 0.0, high: 0.0 };
        let n = vectors.len();
        let mut found = Self { vectors, values: vec![zero; n * n * n] };
        for (a, b, c) in (0..n).flat_map(|a| (a + 1..n).flat_map(move |b| (b + 1..n).map(move |c| (a, b, c)))) {
            let [p, q, r] = [a, b, c].map(|index| found.vectors[index]);
            let minor = |i: usize, j: usize| q[i] * r[j] - q[j] * r[i];
            let place = found.place(a, b, c);
            found.values[place] = p[0] * minor(1, 2) + p[1] * minor(2, 0) + p[2] * minor(0, 1);
        }
        found
    }

    pub(super) fn at(&self, [a, b, c]: [usize; 3]) -> Interval {
        let swaps = usize::from(a > b) + usize::from(a > c) + usize::from(b > c);
        let mut sorted = [a, b, c];
        sorted.sort_unstable();
        let value = self.values[self.place(sorted[0], sorted[1], sorted[2])];
        if swaps % 2 == 0 { value } else { Interval { low: -value.high, high: -value.low } }
    }

    fn place(&self, a: usize, b: usize, c: usize) -> usize {
        (a * self.vectors.len() + b) * self.vectors.len() + c
    }
}
