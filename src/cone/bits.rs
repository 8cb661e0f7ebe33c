//! Rows of bits in one allocation.

/// A list of bit sets over the same universe, stored flat.
#[derive(Debug, Clone)]
pub(super) struct BitRows {
    words: usize,
    bits: Vec<u64>,
}

impl BitRows {
    /// No rows yet; each will hold `universe` bits.
    pub(super) fn new(universe: usize) -> Self {
        Self { words: universe.div_ceil(64).max(1), bits: Vec::new() }
    }

    /// Appends the set of the members for which `holds`, and returns its words.
    pub(super) fn push(&mut self, universe: usize, mut holds: impl FnMut(usize) -> bool) {
        let start = self.bits.len();
        self.bits.resize(start + self.words, 0);
        for member in (0..universe).filter(|m| holds(*m)) {
            self.bits[start + member / 64] |= 1 << (member % 64);
        }
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

pub(super) fn count(set: &[u64]) -> usize {
    set.iter().map(|word| word.count_ones() as usize).sum()
}

pub(super) fn is_subset(a: &[u64], b: &[u64]) -> bool {
    a.iter().zip(b).all(|(x, y)| x & !y == 0)
}

pub(super) fn has(set: &[u64], member: usize) -> bool {
    set[member / 64] >> (member % 64) & 1 == 1
}
