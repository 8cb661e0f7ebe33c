//! Complementary bases: which of each pair `(w_i, z_i)` is basic.

use smallvec::SmallVec;

/// The set of indices `i` with `z_i` basic; `w_i` is basic for all others.
#[derive(Debug, Clone, PartialEq, Eq, Hash, Default)]
pub struct Basis {
    size: usize,
    words: SmallVec<[u64; 2]>,
}

impl Basis {
    /// All of `w` basic, for `size` pairs.
    #[must_use]
    pub fn new(size: usize) -> Self {
        let mut basis = Self::default();
        basis.reset(size);
        basis
    }

    /// The basis with exactly these `z` basic; indices from `size` on are ignored.
    #[must_use]
    pub fn with(size: usize, basic: impl IntoIterator<Item = usize>) -> Self {
        let mut basis = Self::new(size);
        basic.into_iter().for_each(|index| basis.insert(index));
        basis
    }

    /// Number of pairs.
    #[must_use]
    pub fn size(&self) -> usize {
        self.size
    }

    /// Whether `z_index` is basic.
    #[must_use]
    pub fn contains(&self, index: usize) -> bool {
        index < self.size && self.words[index / 64] >> (index % 64) & 1 == 1
    }

    /// Makes `z_index` basic.
    pub fn insert(&mut self, index: usize) {
        if index < self.size {
            self.words[index / 64] |= 1 << (index % 64);
        }
    }

    /// The indices of the basic `z`, increasing.
    pub fn iter(&self) -> impl Iterator<Item = usize> {
        self.words.iter().enumerate().flat_map(|(at, word)| {
            let mut rest = *word;
            std::iter::from_fn(move || {
                let bit = rest.trailing_zeros() as usize;
                (rest != 0).then(|| {
                    rest &= rest - 1;
                    64 * at + bit
                })
            })
        })
    }

    /// Empties it and gives it `size` pairs, in its place.
    pub(super) fn reset(&mut self, size: usize) {
        self.size = size;
        self.words.clear();
        self.words.resize(size.div_ceil(64), 0);
    }

    /// Copies in place.
    pub(super) fn copy_from(&mut self, other: &Self) {
        self.size = other.size;
        self.words.clear();
        self.words.extend_from_slice(&other.words);
    }
}
