//! Enclosures of determinants: they only tell which polynomials need no exact look.

use super::events::triples;
use crate::exact::{FloatInterval, Z};

/// `[a b c] = det(a, b, c)` of any three of a list of vectors.
pub(super) struct Determinants {
    vectors: Vec<[FloatInterval; 3]>,
    /// By `a`, `b` and `c` in turn, where they ascend.
    values: Vec<FloatInterval>,
}

impl Determinants {
    pub(super) fn of(vectors: Vec<[FloatInterval; 3]>) -> Self {
        let zero = FloatInterval::of_integer(&Z::ZERO);
        let n = vectors.len();
        let mut found = Self { vectors, values: vec![zero; n * n * n] };
        for [a, b, c] in triples(n) {
            let [p, q, r] = [a, b, c].map(|index| found.vectors[index]);
            let minor = |i: usize, j: usize| q[i] * r[j] - q[j] * r[i];
            let place = found.place(a, b, c);
            found.values[place] = p[0] * minor(1, 2) + p[1] * minor(2, 0) + p[2] * minor(0, 1);
        }
        found
    }

    pub(super) fn at(&self, [a, b, c]: [usize; 3]) -> FloatInterval {
        let swaps = usize::from(a > b) + usize::from(a > c) + usize::from(b > c);
        let mut sorted = [a, b, c];
        sorted.sort_unstable();
        let value = self.values[self.place(sorted[0], sorted[1], sorted[2])];
        if swaps % 2 == 0 { value } else { -value }
    }

    fn place(&self, a: usize, b: usize, c: usize) -> usize {
        (a * self.vectors.len() + b) * self.vectors.len() + c
    }
}
