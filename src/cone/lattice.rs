//! Which rays lie on which facets, and the face lattice that follows from it.

use super::bits::{BitRows, Set, all, count, intersect, is_subset};
use super::faces::Face;
use crate::exact::{Int, Matrix, Overflow};
use std::collections::BTreeSet;

/// For each normal the set of rays on its hyperplane.
pub(super) fn incidence<T: Int>(normals: &Matrix<T>, rays: &Matrix<T>) -> Result<BitRows, Overflow> {
    let mut on = BitRows::new(rays.len());
    for normal in normals.rows() {
        on.push_zeros(normal, rays)?;
    }
    Ok(on)
}

/// The normals that vanish on all rays, and one normal for each facet: those whose ray sets are proper and maximal.
pub(super) fn flat_and_facets(on: &BitRows, n_rays: usize) -> (Vec<usize>, Vec<usize>) {
    let sets: Vec<&[u64]> = on.rows().collect();
    let (mut flat, mut facets) = (Vec::new(), Vec::<usize>::new());
    for (row, set) in sets.iter().enumerate() {
        if count(set) == n_rays {
            flat.push(row);
        } else if !facets.iter().any(|kept| is_subset(set, sets[*kept])) {
            facets.retain(|kept| !is_subset(sets[*kept], set));
            facets.push(row);
        }
    }
    (flat, facets)
}

/// Every face as a ray set, larger before smaller along each chain.
pub(super) fn all_faces(on: &BitRows, n_rays: usize) -> Vec<Set> {
    let mut faces = vec![all(n_rays)];
    let mut seen: BTreeSet<Set> = faces.iter().cloned().collect();
    let mut next = 0;
    while next < faces.len() {
        for below in subfaces(on, &faces[next]) {
            if seen.insert(below.clone()) {
                faces.push(below);
            }
        }
        next += 1;
    }
    faces
}

/// Facets of a face, as ray sets: its maximal proper intersections with facets of the cone.
pub(super) fn subfaces(on: &BitRows, face: &[u64]) -> Vec<Set> {
    let mut maximal: Vec<Set> = Vec::new();
    for facet in on.rows() {
        let below = intersect(face, facet);
        if below.as_slice() == face || maximal.iter().any(|kept| is_subset(&below, kept)) {
            continue;
        }
        maximal.retain(|kept| !is_subset(kept, &below));
        maximal.push(below);
    }
    maximal
}

/// Rays on all `facets`.
pub(super) fn common(on: &BitRows, facets: &[usize], n_rays: usize) -> Set {
    facets.iter().fold(all(n_rays), |rays, facet| intersect(&rays, on.row(*facet)))
}

/// Facets that contain all rays of `face`.
pub(super) fn tight_facets(on: &BitRows, face: &[u64], n_facets: usize) -> Face {
    (0..n_facets).filter(|facet| is_subset(face, on.row(*facet))).collect()
}
