//! The canonical form of a cone in wrench space, from inequalities of which some are strict.

use super::hull::{Generators, echelon, integers, negated, polar, product, reduced};
use num_traits::{Signed, Zero};
use partplan::answer::{CanonicalCone, Cone, Excluded, Face};
use partplan::exact::{Q, Z};

/// `row . g <= 0`, or `< 0` when strict.
#[derive(Debug, Clone)]
pub struct Inequality {
    pub row: Vec<Q>,
    pub strict: bool,
}

/// Canonical form of the wrenches that satisfy all `inequalities`.
pub fn canonical(inequalities: &[Inequality]) -> Cone {
    let rows = integers(&inequalities.iter().map(|i| i.row.clone()).collect::<Vec<_>>());
    let Generators { lines, rays } = polar(3, &rows);
    let lines = echelon(&lines);
    let mut rays: Vec<Vec<Z>> = rays.iter().map(|ray| reduced(ray, &lines)).collect();
    rays.sort();
    rays.dedup();

    let mut both_ways = rays.clone();
    both_ways.extend(lines.iter().flat_map(|line| [line.clone(), negated(line)]));
    let normals = polar(3, &both_ways);
    let equalities = echelon(&normals.lines);
    let mut normals: Vec<Vec<Z>> = normals.rays.iter().map(|normal| reduced(normal, &equalities)).collect();
    normals.sort();
    normals.dedup();

    // a strict row forbids the face of the closure on which it vanishes: it lies in the facets listed here
    let mut missing: Vec<Vec<usize>> = Vec::new();
    for (row, _) in rows.iter().zip(inequalities).filter(|(_, inequality)| inequality.strict) {
        if rays.iter().all(|ray| !product(row, ray).is_negative()) {
            return Cone::Empty;
        }
        let face: Vec<&Vec<Z>> = rays.iter().filter(|ray| product(row, ray).is_zero()).collect();
        let holds_face = |f: &usize| face.iter().all(|ray| product(&normals[*f], ray).is_zero());
        missing.push((0..normals.len()).filter(holds_face).collect());
    }
    missing.sort();
    missing.dedup();
    let smaller = |a: &[usize], b: &[usize]| a != b && a.iter().all(|f| b.contains(f));
    let maximal: Vec<&Vec<usize>> = missing.iter().filter(|m| !missing.iter().any(|other| smaller(other, m))).collect();

    let faces = normals
        .iter()
        .enumerate()
        .map(|(f, normal)| Face { normal: normal.clone(), strict: maximal.contains(&&vec![f]) });
    let excluded = maximal.iter().filter(|tight| tight.len() > 1).map(|tight| Excluded {
        normal: (0..3).map(|i| tight.iter().map(|f| &normals[*f][i]).sum()).collect(),
        tight: tight.to_vec(),
    });
    Cone::Of(CanonicalCone {
        dim: 3 - equalities.len(),
        faces: faces.collect(),
        excluded: excluded.collect(),
        equalities,
        lines,
        rays,
    })
}
