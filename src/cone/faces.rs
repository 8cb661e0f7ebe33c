//! Missing faces of images and sums.

use super::bits::{BitRows, Set, all, count, has, is_subset};
use super::lattice::{common, incidence, subfaces, tight_facets};
use super::pair::Pair;
use super::spatial::{Part, is_small, masks, maximal_missing};
use crate::exact::{Int, Matrix, Overflow};
use smallvec::SmallVec;
use std::collections::BTreeSet;

/// A face as the sorted set of the facets that contain it.
pub type Face = SmallVec<[usize; 2]>;

/// A summand whose missing faces may be missing from the sum: its rays mapped into the sum's space, and for each of its
/// missing faces the rays that span it (with the lineality space).
pub(super) struct Summand<T> {
    pub(super) rays: Matrix<T>,
    pub(super) missing: BitRows,
}

/// The maximal missing faces of `sum`, each as the set of its tight facets.
///
/// A relatively open face of a sum is the sum of one relatively open face of each summand, those on which its tight
/// facets vanish; it is missing iff one of those is. Faces are visited from the top down and only below present ones.
///
/// `None` if the sum itself is missing, that is, a summand is empty.
pub(super) fn missing_faces<T: Int>(sum: &Pair<T>, summands: &[Summand<T>]) -> Result<Option<Vec<Face>>, Overflow> {
    let n_rays = sum.rays().len();
    let n_facets = sum.facets().len();
    if is_small(sum) && summands.iter().all(|part| part.rays.len() <= 64) {
        let missing = |part: &Summand<T>| part.missing.rows().map(|face| face[0]).collect();
        let parts: SmallVec<[Part; 2]> = summands.iter().map(|part| Part::of(sum, &part.rays, missing(part))).collect();
        let is_empty = parts.iter().any(|part| part.is_missing(0));
        return Ok((!is_empty).then(|| maximal_missing(sum, &parts)));
    }
    let on = incidence(sum.facets(), sum.rays())?;
    let mapped = summands.iter().map(|part| incidence(sum.facets(), &part.rays)).collect::<Result<Vec<_>, _>>()?;
    let is_missing = |tight: &[usize]| {
        summands.iter().zip(&mapped).any(|(part, on)| {
            let face = common(on, tight, part.rays.len());
            part.missing.rows().any(|gone| is_subset(&face, gone))
        })
    };
    if is_missing(&[]) {
        return Ok(None);
    }
    let mut missing: Vec<Set> = Vec::new();
    let mut seen = BTreeSet::new();
    let mut open = vec![all(n_rays)];
    while let Some(face) = open.pop() {
        for below in subfaces(&on, &face) {
            if missing.iter().any(|gone| is_subset(&below, gone)) || !seen.insert(below.clone()) {
                continue;
            }
            if is_missing(&tight_facets(&on, &below, n_facets)) {
                missing.retain(|gone| !is_subset(gone, &below));
                missing.push(below);
            } else {
                open.push(below);
            }
        }
    }
    let mut tight: Vec<Face> = missing.iter().map(|face| tight_facets(&on, face, n_facets)).collect();
    tight.sort();
    Ok(Some(tight))
}

/// The maximal faces cut off by strict normals that are valid for the closure; `None` if one cuts off everything.
pub(super) fn faces_of_strict_normals<T: Int>(
    pair: &Pair<T>,
    strict: &Matrix<T>,
) -> Result<Option<Vec<Face>>, Overflow> {
    let n_rays = pair.rays().len();
    if strict.is_empty() {
        return Ok(Some(Vec::new()));
    }
    if is_small(pair) {
        let part = Part::of(pair, pair.rays(), masks(strict, pair.rays()));
        return Ok((!part.is_missing(0)).then(|| maximal_missing(pair, &[part])));
    }
    let mut maximal: Vec<Set> = Vec::new();
    for normal in strict.rows() {
        let mut face = BitRows::new(n_rays);
        face.push_zeros(normal, pair.rays())?;
        let face = face.row(0);
        if count(face) == n_rays {
            return Ok(None);
        }
        if maximal.iter().any(|kept| is_subset(face, kept)) {
            continue;
        }
        maximal.retain(|kept| !is_subset(kept, face));
        maximal.push(face.into());
    }
    let on = incidence(pair.facets(), pair.rays())?;
    let mut tight: Vec<Face> = maximal.iter().map(|face| tight_facets(&on, face, pair.facets().len())).collect();
    tight.sort();
    Ok(Some(tight))
}

/// For each missing face (a set of tight facets) the rays on it.
pub(super) fn rays_of_missing<T: Int>(pair: &Pair<T>, missing: &[Face]) -> Result<BitRows, Overflow> {
    let n_rays = pair.rays().len();
    let on = incidence(pair.facets(), pair.rays())?;
    let mut rows = BitRows::new(n_rays);
    for tight in missing {
        let face = common(&on, tight, n_rays);
        rows.push(n_rays, |ray| has(&face, ray));
    }
    Ok(rows)
}
