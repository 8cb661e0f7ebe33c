//! Finger places and tilts as planes of wrenches.

use super::directions::{PlanarSet, Run};
use crate::answer::{Arc, ArcSet, EdgeFingers, FingerSet, Interval};
use crate::cone::{Cone, HalfSpaces};
use crate::exact::{Int, Overflow, Q, Z, on_rung, primitive_row};
use crate::geometry::{Polygon, cross, difference};
use crate::model::{Part, Shape};

/// The wrenches of every simple way to push or tilt a part, in integers of any size.
pub(super) struct Pushes {
    /// One plane per edge of a polygon, from the wrench at its first vertex to that at its last; none for a circle.
    pub(super) edges: Vec<[Vec<Z>; 2]>,
    /// For a circle: the plane that maps the direction from the center to the finger to the wrench of its push.
    pub(super) circle: Option<[Vec<Z>; 2]>,
}

impl Pushes {
    pub(super) fn of(part: &Part) -> Self {
        let com = &part.center_of_mass;
        match &part.shape {
            Shape::Polygon(polygon) => {
                let edges = (0..polygon.n_edges()).map(|edge| edge_plane(polygon, edge, com)).collect();
                Self { edges, circle: None }
            }
            Shape::Circle { center, .. } => {
                // the push -u at c + r u has torque (c - com) x (-u), whatever the radius
                let arm = difference(com, center);
                let columns = [-one(), zero(), arm[1].clone(), zero(), -one(), -arm[0].clone()];
                Self { edges: Vec::new(), circle: Some(plane(&columns)) }
            }
        }
    }
}

/// The plane of forces through the center of mass.
pub(super) fn tilt_plane() -> [Vec<Z>; 2] {
    plane(&[one(), zero(), zero(), zero(), one(), zero()])
}

/// Wrench of a push on `edge` at its first and at its last vertex, with one common factor.
fn edge_plane(polygon: &Polygon, edge: usize, com: &[Q; 2]) -> [Vec<Z>; 2] {
    let [a, b] = polygon.edge(edge);
    let normal = polygon.inward_normal(edge);
    let torque = |p: &[Q; 2]| cross(&difference(com, p), &normal);
    let (first, last) = (torque(a), torque(b));
    let [x, y] = normal;
    plane(&[x.clone(), y.clone(), first, x, y, last])
}

fn plane(columns: &[Q; 6]) -> [Vec<Z>; 2] {
    let row = primitive_row(columns);
    [row[..3].to_vec(), row[3..].to_vec()]
}

/// Finger places in a union of cones.
pub(super) fn finger_set<T: Int>(part: &Part, pushes: &Pushes, cells: &[Cone<T>]) -> Result<FingerSet, Overflow> {
    if let Some(plane) = &pushes.circle {
        return arc_set(plane, cells).map(FingerSet::Arcs);
    }
    let Shape::Polygon(polygon) = &part.shape else { return Ok(FingerSet::Edges(Vec::new())) };
    let systems = systems(cells)?;
    let mut edges = Vec::new();
    for (edge, plane) in pushes.edges.iter().enumerate() {
        let runs = seen_from(plane, &systems)?.runs_in_quadrant()?;
        if !runs.is_empty() {
            let intervals = runs.iter().map(|run| interval(polygon, edge, run)).collect();
            edges.push(EdgeFingers { edge, intervals });
        }
    }
    Ok(FingerSet::Edges(edges))
}

/// Directions of a plane whose wrenches are in a union of cones.
pub(super) fn arc_set<T: Int>(plane: &[Vec<Z>; 2], cells: &[Cone<T>]) -> Result<ArcSet, Overflow> {
    let (runs, all) = seen_from(plane, &systems(cells)?)?.runs_around()?;
    let direction = |d: &[T; 2]| [d[0].to_z(), d[1].to_z()];
    let arcs = runs.iter().map(|run| Arc { from: direction(&run.from), to: direction(&run.to), closed: run.closed });
    Ok(ArcSet { all, arcs: arcs.collect() })
}

fn systems<T: Int>(cells: &[Cone<T>]) -> Result<Vec<HalfSpaces<T>>, Overflow> {
    cells.iter().map(Cone::half_spaces).collect()
}

fn seen_from<T: Int>(plane: &[Vec<Z>; 2], cells: &[HalfSpaces<T>]) -> Result<PlanarSet<T>, Overflow> {
    PlanarSet::of(cells, &[on_rung(&plane[0])?, on_rung(&plane[1])?])
}

fn interval<T: Int>(polygon: &Polygon, edge: usize, run: &Run<T>) -> Interval {
    let share = |[first, last]: &[T; 2]| {
        let (first, last) = (first.to_z(), last.to_z());
        Q::new(last.clone(), first + last)
    };
    let s = [share(&run.from), share(&run.to)];
    let points = s.clone().map(|share| polygon.point(&polygon.location(edge, share)));
    Interval { s, closed: run.closed, points }
}

fn one() -> Q {
    Q::from(Z::from(1))
}

fn zero() -> Q {
    Q::from(Z::from(0))
}
