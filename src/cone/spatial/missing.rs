//! Missing faces of cones in three dimensions: facets, then edges, then the lineality space.

use super::row;
use crate::cone::faces::Face;
use crate::cone::pair::Pair;
use crate::exact::{Int, Matrix};
use smallvec::{SmallVec, smallvec};

/// Sets of at most 64 vectors, one for each normal: those on its plane.
pub(in crate::cone) type Masks = SmallVec<[u64; 8]>;

/// The vectors on the plane of each normal.
///
/// # Panics
/// If there are more than 64 vectors.
pub(in crate::cone) fn masks<T: Int>(normals: &Matrix<T>, vectors: &Matrix<T>) -> Masks {
    assert!(vectors.len() <= 64, "a word has one bit for each vector");
    let on = |normal: &[T]| {
        let bits = vectors.rows().enumerate();
        bits.map(|(bit, vector)| u64::from(T::side_of(row(normal), row(vector)).is_eq()) << bit).sum()
    };
    normals.rows().map(on).collect()
}

/// A set whose missing faces may be missing from a cone that it is a part of, by its vectors.
pub(in crate::cone) struct Part {
    /// For each facet of the cone the part's vectors on it.
    on: Masks,
    /// The part's missing faces, each by its vectors.
    missing: Masks,
    all: u64,
}

impl Part {
    /// The part that `vectors` span; each word of `missing` is the set of those on a missing face.
    pub(in crate::cone) fn of<T: Int>(pair: &Pair<T>, vectors: &Matrix<T>, missing: Masks) -> Self {
        Self { on: masks(pair.facets(), vectors), missing, all: first(vectors.len()) }
    }

    /// Whether the face of the cone with these tight facets lacks this part.
    pub(in crate::cone) fn is_missing(&self, tight: u64) -> bool {
        let facets = self.on.iter().enumerate().filter(|(facet, _)| tight >> facet & 1 == 1);
        let face = facets.fold(self.all, |face, (_, on)| face & on);
        self.missing.iter().any(|missing| face & !missing == 0)
    }
}

/// Whether one word holds every set of facets and of rays.
pub(in crate::cone) fn is_small<T: Int>(pair: &Pair<T>) -> bool {
    pair.ambient() == 3 && pair.facets().len() <= 64 && pair.rays().len() <= 64
}

/// The maximal ones among the proper faces of `pair` that lack a part, each as the set of its tight facets, sorted.
pub(in crate::cone) fn maximal_missing<T: Int>(pair: &Pair<T>, parts: &[Part]) -> Vec<Face> {
    let count = pair.facets().len();
    let is_missing = |tight: u64| parts.iter().any(|part| part.is_missing(tight));
    let mut missing: Vec<Face> = Vec::new();
    let mut gone = 0;
    for facet in (0..count).filter(|facet| is_missing(1 << facet)) {
        gone |= 1 << facet;
        missing.push(smallvec![facet]);
    }
    if count >= 3 && missing.len() < count {
        // every ray lies on two facets
        for tight in masks(pair.rays(), pair.facets()) {
            if tight & gone == 0 && is_missing(tight) {
                missing.push((0..count).filter(|facet| tight >> facet & 1 == 1).collect());
            }
        }
    }
    if missing.is_empty() && count >= 2 && is_missing(first(count)) {
        missing.push((0..count).collect());
    }
    missing.sort_unstable();
    missing
}

/// The set of the first `count` vectors.
fn first(count: usize) -> u64 {
    u64::MAX.checked_shr(64 - count as u32).unwrap_or(0)
}
