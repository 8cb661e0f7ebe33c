//! Rows of bits in one allocation.

use crate::exact::{Int, Matrix, Overflow};
use smallvec::{SmallVec, smallvec};

/// One bit set, on the stack up to 128 members.
pub(crate) type Set = SmallVec<[u64; 2]>;

/// A list of bit sets over the same universe, stored flat.
#[derive(Debug, Clone)]
pub(super) struct BitRows {
    words: usize,
    bits: SmallVec<[u64; 8]>,
}

impl BitRows {
    /// No rows yet; each will hold `universe` bits.
    pub(super) fn new(universe: usize) -> Self {
        Self { words: universe.div_ceil(64).max(1), bits: SmallVec::new() }
    }

    /// Words a row.
    #[inline(always)]
    pub(super) fn words(&self) -> usize {
        self.words
    }

    /// Number of rows.
    pub(super) fn len(&self) -> usize {
        self.bits.len() / self.words
    }

    /// All rows, one after the other.
    #[inline(always)]
    pub(super) fn flat(&self) -> &[u64] {
        &self.bits
    }

    /// Makes room for more members in every row.
    pub(super) fn widen(&mut self, universe: usize) {
        let words = universe.div_ceil(64);
        if words <= self.words {
            return;
        }
        let mut wide = Self { words, bits: SmallVec::with_capacity(self.len() * words) };
        for row in self.rows() {
            wide.push_words(row.iter().copied().chain(std::iter::repeat_n(0, words - self.words)));
        }
        *self = wide;
    }

    /// Overwrites row `index`.
    pub(super) fn set_row(&mut self, index: usize, words: &[u64]) {
        self.bits[index * self.words..(index + 1) * self.words].copy_from_slice(words);
    }

    /// Drops row `index`; the last row takes its place.
    pub(super) fn swap_remove(&mut self, index: usize) {
        let last = self.bits.len() - self.words;
        self.bits.copy_within(last.., index * self.words);
        self.bits.truncate(last);
    }

    /// Drops all rows.
    pub(super) fn clear(&mut self) {
        self.bits.clear();
    }

    /// For each of `universe` members the set of the rows that contain it.
    pub(super) fn transposed(&self, universe: usize) -> Self {
        let n_rows = self.len();
        let mut columns = Self::new(n_rows);
        columns.bits.resize(universe * columns.words, 0);
        for (index, row) in self.rows().enumerate() {
            for member in members(row) {
                columns.insert(member, index);
            }
        }
        columns
    }

    /// Appends the set of the members for which `holds`, and returns its words.
    pub(super) fn push(&mut self, universe: usize, mut holds: impl FnMut(usize) -> bool) {
        let start = self.bits.len();
        self.bits.resize(start + self.words, 0);
        for member in (0..universe).filter(|m| holds(*m)) {
            self.bits[start + member / 64] |= 1 << (member % 64);
        }
    }

    /// Appends the set of the rows of `vectors` on the hyperplane of `normal`.
    pub(super) fn push_zeros<T: Int>(&mut self, normal: &[T], vectors: &Matrix<T>) -> Result<(), Overflow> {
        let start = self.bits.len();
        self.bits.resize(start + self.words, 0);
        for (member, vector) in vectors.rows().enumerate() {
            if T::wide_sign(&T::dot(normal, vector)?).is_eq() {
                self.bits[start + member / 64] |= 1 << (member % 64);
            }
        }
        Ok(())
    }

    /// Appends a copy of `words`.
    pub(super) fn push_words(&mut self, words: impl IntoIterator<Item = u64>) {
        self.bits.extend(words);
    }

    pub(super) fn row(&self, index: usize) -> &[u64] {
        &self.bits[index * self.words..(index + 1) * self.words]
    }

    pub(super) fn rows(&self) -> impl ExactSizeIterator<Item = &[u64]> + Clone {
        self.bits.chunks_exact(self.words)
    }

    pub(super) fn insert(&mut self, row: usize, member: usize) {
        self.bits[row * self.words + member / 64] |= 1 << (member % 64);
    }
}

/// The set of all members of a universe.
pub(crate) fn all(universe: usize) -> Set {
    let mut words: Set = smallvec![u64::MAX; universe.div_ceil(64).max(1)];
    let unused = words.len() * 64 - universe;
    let last = words.len() - 1;
    words[last] = words[last].checked_shr(unused as u32).unwrap_or(0);
    words
}

pub(crate) fn intersect(a: &[u64], b: &[u64]) -> Set {
    a.iter().zip(b).map(|(x, y)| x & y).collect()
}

pub(crate) fn union(a: &[u64], b: &[u64]) -> Set {
    a.iter().zip(b).map(|(x, y)| x | y).collect()
}

#[inline(always)]
pub(crate) fn count(set: &[u64]) -> usize {
    set.iter().map(|word| word.count_ones() as usize).sum()
}

pub(crate) fn is_subset(a: &[u64], b: &[u64]) -> bool {
    a.iter().zip(b).all(|(x, y)| x & !y == 0)
}

/// Members of the set in increasing order.
pub(crate) fn members(set: &[u64]) -> impl Iterator<Item = usize> {
    set.iter().enumerate().flat_map(|(index, word)| {
        let mut rest = *word;
        std::iter::from_fn(move || {
            let bit = rest.trailing_zeros() as usize;
            rest &= rest.wrapping_sub(1);
            (bit < 64).then_some(64 * index + bit)
        })
    })
}

pub(super) fn has(set: &[u64], member: usize) -> bool {
    set[member / 64] >> (member % 64) & 1 == 1
}
