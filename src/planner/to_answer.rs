//! Cones of the kernel as answers.

use crate::answer::{CanonicalCone, Cone as ConeAnswer, Excluded, Face, Region};
use crate::cone::{Cone, volume_in_box};
use crate::exact::{Int, Matrix, Overflow, Q, Z, sum};

/// A cone in the canonical form of the answers.
pub(super) fn cone_answer<T: Int>(cone: Option<&Cone<T>>) -> ConeAnswer {
    let Some(cone) = cone else { return ConeAnswer::Empty };
    let pair = cone.closure();
    let facets = rows(pair.facets());
    let excluded = cone.missing().iter().filter(|tight| tight.len() > 1).map(|tight| {
        let normal = (0..pair.ambient()).map(|axis| tight.iter().map(|facet| &facets[*facet][axis]).sum()).collect();
        Excluded { normal, tight: tight.to_vec() }
    });
    ConeAnswer::Of(CanonicalCone {
        dim: pair.dim(),
        equalities: rows(pair.equalities()),
        excluded: excluded.collect(),
        lines: rows(pair.lines()),
        rays: rows(pair.rays()),
        faces: facets
            .into_iter()
            .enumerate()
            .map(|(facet, normal)| Face { normal, strict: cone.is_strict(facet) })
            .collect(),
    })
}

/// A union of disjoint cones as an answer; `reach` is the half-width of the torque axis of the box.
pub(super) fn region_answer<T: Int>(cells: &[Cone<T>], reach: &Q) -> Result<Region, Overflow> {
    let half_widths = [Q::from(Z::from(1)), Q::from(Z::from(1)), reach.clone()];
    let volumes = cells.iter().map(|cell| volume_in_box(cell, &half_widths)).collect::<Result<_, _>>()?;
    Ok(Region {
        dim: cells.iter().map(|cell| cell.closure().dim()).max(),
        everything: cells.iter().any(Cone::is_everything),
        volume_in_box: sum(volumes),
        cells: cells.iter().map(|cell| cone_answer(Some(cell))).collect(),
    })
}

fn rows<T: Int>(matrix: &Matrix<T>) -> Vec<Vec<Z>> {
    matrix.rows().map(|row| row.iter().map(T::to_z).collect()).collect()
}
