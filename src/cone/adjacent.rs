//! Which rays of a cone span a two-dimensional face, told by the facets that they lie on.

use super::bits::{BitRows, count};
use pulp::{Simd, WithSimd};

/// Appends all adjacent pairs of a ray in `ones` and a ray in `others`.
///
/// `on` says for each ray of the cone which normals it lies on; the facets must be among them. `needed` is the dimension
/// of the cone, modulo its lines, less two. Two rays are adjacent iff no third lies on all normals that both lie on;
/// that takes at least `needed` normals, and all but one of those of either ray are enough.
///
/// # Cost
/// O(a b) for the pairs, and O(a k) more for those rays of the smaller list whose pairs leave doubt.
pub(super) fn adjacent_pairs(
    on: &BitRows,
    ones: &[usize],
    others: &[usize],
    needed: usize,
    found: &mut Vec<(usize, usize)>,
) {
    let is_swapped = ones.len() > others.len();
    let (few, many) = if is_swapped { (others, ones) } else { (ones, others) };
    let start = found.len();
    // counting bits is most of the work and takes an instruction that the oldest processors lack
    pulp::Arch::new().dispatch(Scan { on, few, many, needed, found });
    if is_swapped {
        found[start..].iter_mut().for_each(|(one, other)| std::mem::swap(one, other));
    }
}

struct Scan<'a> {
    on: &'a BitRows,
    few: &'a [usize],
    many: &'a [usize],
    needed: usize,
    found: &'a mut Vec<(usize, usize)>,
}

impl WithSimd for Scan<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        match self.on.words() {
            1 => self.run::<1>(),
            2 => self.run::<2>(),
            3 => self.run::<3>(),
            4 => self.run::<4>(),
            _ => self.run::<0>(),
        }
    }
}

impl Scan<'_> {
    /// For sets of `WORDS` words, or of any number if that is zero.
    #[inline(always)]
    fn run<const WORDS: usize>(self) {
        let Self { on, few, many, needed, found } = self;
        let words = if WORDS == 0 { on.words() } else { WORDS };
        let set = |ray: usize| &on.flat()[ray * words..(ray + 1) * words];
        let mut gathered = Vec::with_capacity(many.len() * words);
        let mut sizes = Vec::with_capacity(many.len());
        for ray in many {
            gathered.extend_from_slice(set(*ray));
            sizes.push(count(set(*ray)));
        }
        let mut doubtful = Vec::new();
        let mut near = Near { rays: Vec::new(), sets: Vec::new() };
        for one in few.iter().copied() {
            let own = set(one);
            let own_size = count(own);
            doubtful.clear();
            for (index, other) in gathered.chunks_exact(words).enumerate() {
                let size = count_common(own, other);
                if size < needed {
                    continue;
                }
                if size + 1 == own_size || size + 1 == sizes[index] {
                    found.push((one, many[index]));
                } else {
                    doubtful.push(index);
                }
            }
            if doubtful.is_empty() {
                continue;
            }
            near.gather(own, on.flat().chunks_exact(words), needed, one);
            for index in doubtful.iter().copied() {
                if near.is_edge(own, &gathered[index * words..(index + 1) * words], many[index]) {
                    found.push((one, many[index]));
                }
            }
        }
    }
}

/// The rays with enough normals in common with one ray: no other can come between it and a third.
struct Near {
    rays: Vec<usize>,
    sets: Vec<u64>,
}

impl Near {
    #[inline(always)]
    fn gather<'a>(&mut self, own: &[u64], sets: impl Iterator<Item = &'a [u64]>, needed: usize, one: usize) {
        self.rays.clear();
        self.sets.clear();
        for (ray, set) in sets.enumerate() {
            if count_common(own, set) >= needed && ray != one {
                self.rays.push(ray);
                self.sets.extend_from_slice(set);
            }
        }
    }

    /// Whether no third ray lies on all that the one ray and `other` lie on.
    #[inline(always)]
    fn is_edge(&mut self, own: &[u64], set: &[u64], other: usize) -> bool {
        let words = own.len();
        let is_between = |between: &[u64]| own.iter().zip(set).zip(between).all(|((a, b), c)| a & b & !c == 0);
        let found = self.sets.chunks_exact(words).position(is_between);
        let Some(first) = found else { return true };
        if self.rays[first] != other {
            self.bring_forward(first, words);
            return false;
        }
        let rest = self.sets.chunks_exact(words).skip(first + 1).position(is_between);
        if let Some(second) = rest {
            self.bring_forward(first + 1 + second, words);
        }
        rest.is_none()
    }

    /// What came between once is likely to do so again.
    #[inline(always)]
    fn bring_forward(&mut self, index: usize, words: usize) {
        let to = index / 2;
        self.rays.swap(index, to);
        for word in 0..words {
            self.sets.swap(index * words + word, to * words + word);
        }
    }
}

#[inline(always)]
fn count_common(a: &[u64], b: &[u64]) -> usize {
    a.iter().zip(b).map(|(x, y)| (x & y).count_ones() as usize).sum()
}
