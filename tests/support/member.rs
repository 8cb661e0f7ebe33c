//! Membership of a wrench in the answers.

use super::{Wrench, dot};
use num_traits::{Signed, Zero};
use partplan::answer::{CanonicalCone, Cone, Region};
use partplan::exact::{Q, Z};

pub fn rational(row: &[Z]) -> Vec<Q> {
    row.iter().map(|x| Q::from_integer(x.clone())).collect()
}

pub fn in_cone(cone: &Cone, g: &Wrench) -> bool {
    let Cone::Of(cone) = cone else { return false };
    let side = |normal: &[Z]| dot(&rational(normal), g);
    cone.equalities.iter().all(|row| side(row).is_zero())
        && cone.faces.iter().all(|face| {
            let side = side(&face.normal);
            side.is_negative() || (side.is_zero() && !face.strict)
        })
        && cone.excluded.iter().all(|excluded| side(&excluded.normal).is_negative())
}

/// In exactly one cell; cells are promised to be disjoint.
pub fn in_region(region: &Region, g: &Wrench) -> bool {
    let cells = region.cells.iter().filter(|cell| in_cone(cell, g)).count();
    assert!(cells <= 1, "{cells} cells of one region hold {g:?}");
    cells == 1
}

/// Wrenches where closures and strict faces matter: the generators, and the sums of any two of them.
pub fn landmarks(cone: &CanonicalCone) -> Vec<Wrench> {
    let mut generators: Vec<Wrench> = cone.rays.iter().map(|ray| to_wrench(ray)).collect();
    for line in &cone.lines {
        let line = to_wrench(line);
        generators.push(std::array::from_fn(|i| -&line[i]));
        generators.push(line);
    }
    let mut points = generators.clone();
    for (i, a) in generators.iter().enumerate() {
        points.extend(generators[..i].iter().map(|b| std::array::from_fn(|k| &a[k] + &b[k])));
    }
    points.push(std::array::from_fn(|k| generators.iter().map(|g| &g[k]).sum()));
    points.push(std::array::from_fn(|_| Q::zero()));
    points
}

fn to_wrench(row: &[Z]) -> Wrench {
    std::array::from_fn(|i| Q::from_integer(row[i].clone()))
}
