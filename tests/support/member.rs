//! Membership of a wrench in the answers.

use super::{Wrench, cross, dot};
use num_traits::{Signed, Zero};
use partplan::answer::{Arc, ArcSet, CanonicalCone, Cone, FingerSet, Region};
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

/// In one of the arcs of directions.
pub fn in_arcs(set: &ArcSet, direction: &[Q; 2]) -> bool {
    set.all || set.arcs.iter().any(|arc| in_arc(arc, direction))
}

fn in_arc(arc: &Arc, direction: &[Q; 2]) -> bool {
    let [from, to] = [&arc.from, &arc.to].map(|d| [0, 1].map(|i| Q::from_integer(d[i].clone())));
    if angle(&from, direction) == Angle::Zero {
        return arc.closed[0];
    }
    if angle(&to, direction) == Angle::Zero {
        return arc.closed[1];
    }
    if angle(&from, &to) == Angle::Zero {
        return !(arc.closed[0] && arc.closed[1]);
    }
    angle(&from, direction).is_less(&angle(&from, &to))
}

/// The counter-clockwise angle between two directions, by its half turn and the second direction seen from the first.
#[derive(Debug, PartialEq)]
enum Angle {
    Zero,
    UpToHalf([Q; 2]),
    BeyondHalf([Q; 2]),
}

impl Angle {
    fn is_less(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::UpToHalf(a), Self::UpToHalf(b)) | (Self::BeyondHalf(a), Self::BeyondHalf(b)) => {
                cross(a, b).is_positive()
            }
            (Self::UpToHalf(_), Self::BeyondHalf(_)) => true,
            (Self::Zero, other) => *other != Self::Zero,
            _ => false,
        }
    }
}

fn angle(from: &[Q; 2], to: &[Q; 2]) -> Angle {
    let seen = [dot(from, to), cross(from, to)];
    if seen[1].is_positive() || (seen[1].is_zero() && seen[0].is_negative()) {
        Angle::UpToHalf(seen)
    } else if seen[1].is_zero() {
        Angle::Zero
    } else {
        Angle::BeyondHalf(seen)
    }
}

/// In one of the intervals of edge `edge`.
pub fn on_edge(set: &FingerSet, edge: usize, s: &Q) -> bool {
    let FingerSet::Edges(edges) = set else { panic!("a polygon's finger places are on edges") };
    let intervals = edges.iter().filter(|e| e.edge == edge).flat_map(|e| &e.intervals);
    let holding = intervals.filter(|interval| {
        let [from, to] = &interval.s;
        (from < s && s < to) || (s == from && interval.closed[0]) || (s == to && interval.closed[1])
    });
    let count = holding.count();
    assert!(count <= 1, "intervals of edge {edge} overlap at {s}");
    count == 1
}
