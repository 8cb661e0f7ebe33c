//! The push or tilt with the largest margin.

use super::fingers::{Pushes, tilt_plane};
use crate::answer::{Action, Arc, ArcSet, FingerSet, Interval, Recommendation};
use crate::cone::Cone;
use crate::exact::{Int, Q, Z, approximate, from_float_exact, primitive_row, ratio, to_f64};
use crate::geometry::{difference, dot};
use crate::model::{Part, Shape};
use num_traits::{Signed, Zero};
use std::cmp::Ordering;

/// Certified lower bounds on the distance of a wrench from the cones it must avoid.
///
/// In the norm fx² + fy² + torque²/ρ² a cone that satisfies `{h · g ≤ 0}` is at least as far from `g` as each of these
/// half-spaces, whose distance is `h · g` over the dual norm of `h`.
pub(super) struct Margins {
    holes: Vec<Vec<Condition>>,
    pub(super) rho2: Q,
}

/// A normal `h` and its squared dual norm hx² + hy² + ρ² ht², times the denominator of ρ².
struct Condition {
    normal: Vec<Z>,
    norm2: Z,
}

/// A fraction with a positive denominator, compared without being reduced.
#[derive(Clone)]
struct Fraction {
    numerator: Z,
    denominator: Z,
}

impl Margins {
    pub(super) fn of<T: Int>(holes: &[&Cone<T>], rho2: Q) -> Self {
        let exact = |row: &[T]| row.iter().map(T::to_z).collect::<Vec<Z>>();
        let condition = |normal: Vec<Z>| {
            let square = |axis: usize| &normal[axis] * &normal[axis];
            let norm2 = (square(0) + square(1)) * rho2.denom() + square(2) * rho2.numer();
            Condition { normal, norm2 }
        };
        let conditions = |cone: &&Cone<T>| {
            let pair = cone.closure();
            let sides = pair.equalities().rows().map(exact).flat_map(|row| {
                let opposite = row.iter().map(|value| -value).collect();
                [row, opposite]
            });
            pair.facets().rows().map(exact).chain(sides).map(condition).collect()
        };
        Self { holes: holes.iter().map(conditions).collect(), rho2 }
    }

    /// Lower bound on the squared distance of the integer wrench `row` from cone number `hole`.
    pub(super) fn distance2(&self, hole: usize, row: &[Z]) -> Q {
        let Fraction { numerator, denominator } = farthest(&self.holes[hole], row);
        Q::new(numerator * self.rho2.denom(), denominator)
    }

    /// Lower bound on the squared distance of `wrench` from the nearest cone, over its squared length.
    fn margin2(&self, wrench: &[Q]) -> Q {
        let row = primitive_row(wrench);
        let nearest = self.holes.iter().map(|conditions| farthest(conditions, &row)).min_by(Fraction::order);
        let square = |axis: usize| &row[axis] * &row[axis];
        let length2 = (square(0) + square(1)) * self.rho2.numer() + square(2) * self.rho2.denom();
        nearest.map_or_else(Q::zero, |distance2| {
            let scale = self.rho2.denom() * self.rho2.numer();
            Q::new(distance2.numerator * scale, distance2.denominator * length2)
        })
    }
}

/// Squared distance of `wrench` from the farthest of the half-spaces, over the denominator of ρ²; zero inside all.
fn farthest(conditions: &[Condition], wrench: &[Z]) -> Fraction {
    let none = Fraction { numerator: Z::zero(), denominator: Z::from(1) };
    conditions.iter().fold(none, |best, Condition { normal, norm2 }| {
        let height: Z = normal.iter().zip(wrench).map(|(h, g)| h * g).sum();
        if !height.is_positive() {
            return best;
        }
        let distance2 = Fraction { numerator: &height * &height, denominator: norm2.clone() };
        if distance2.order(&best).is_gt() { distance2 } else { best }
    })
}

impl Fraction {
    fn order(&self, other: &Self) -> Ordering {
        (&self.numerator * &other.denominator).cmp(&(&other.numerator * &self.denominator))
    }
}

/// The candidate with the largest margin, one from each interval and arc; a bare wrench if nothing simpler is in the set.
pub(super) fn recommend<T: Int>(
    part: &Part,
    pushes: &Pushes,
    fingers: &FingerSet,
    tilt: &ArcSet,
    inner: &[Vec<T>],
    margins: &Margins,
) -> Option<Recommendation> {
    let mut candidates = Vec::new();
    match (fingers, &part.shape) {
        (FingerSet::Edges(edges), Shape::Polygon(_)) => {
            for fingers in edges {
                for interval in &fingers.intervals {
                    candidates.push(best_in_interval(part, pushes, fingers.edge, interval, margins));
                }
            }
        }
        (FingerSet::Arcs(arcs), _) => {
            let plane = pushes.circle.as_ref()?;
            for (arc, direction) in middles(arcs) {
                let wrench = along(plane, &direction);
                candidates.push((margins.margin2(&wrench), Action::PushArc { arc, direction }, wrench));
            }
        }
        (FingerSet::Edges(_), Shape::Circle { .. }) => {}
    }
    for (arc, direction) in middles(tilt) {
        let wrench = along(&tilt_plane(), &direction);
        candidates.push((margins.margin2(&wrench), Action::Tilt { arc, direction }, wrench));
    }
    if candidates.is_empty() {
        candidates.extend(inner.iter().map(|point| {
            let wrench: Vec<Q> = point.iter().map(|value| Q::from(value.to_z())).collect();
            let wrench = <[Q; 3]>::try_from(wrench).expect("wrenches have three components");
            (margins.margin2(&wrench), Action::Wrench, wrench)
        }));
    }
    // the first of equals: fingers before tilts, edges in order
    let best = candidates.into_iter().rev().max_by(|a, b| a.0.cmp(&b.0))?;
    Some(Recommendation { margin2: best.0, action: best.1, wrench: best.2 })
}

/// The place with the largest margin among quarters of the interval, then eighths and sixteenths about the best so far.
///
/// The margin of a place is that of its wrench, but no more than its distance from the ends of the edge over the radius
/// of gyration: a finger must not slip off a corner either.
fn best_in_interval(
    part: &Part,
    pushes: &Pushes,
    edge: usize,
    interval: &Interval,
    margins: &Margins,
) -> (Q, Action, [Q; 3]) {
    let Shape::Polygon(polygon) = &part.shape else { unreachable!("only polygons have edges") };
    let [a, b] = polygon.edge(edge);
    let along = difference(a, b);
    let length2 = dot(&along, &along) / &margins.rho2;
    let [low, high] = &interval.s;
    let place = |sixteenth: i64| {
        let s = low + (high - low) * ratio(sixteenth, 16);
        let wrench = between(&pushes.edges[edge], &s);
        let to_end = s.clone().min(ratio(1, 1) - &s);
        let margin2 = margins.margin2(&wrench).min(&to_end * &to_end * &length2);
        (margin2, sixteenth, s, wrench)
    };
    let better = |best: (Q, i64, Q, [Q; 3]), other: (Q, i64, Q, [Q; 3])| if other.0 > best.0 { other } else { best };
    let best = [4, 12].into_iter().map(place).fold(place(8), better);
    let best = [best.1 - 2, best.1 + 2].into_iter().map(place).fold(best, better);
    let (margin2, _, s, wrench) = [best.1 - 1, best.1 + 1].into_iter().map(place).fold(best, better);
    let point = polygon.point(&polygon.location(edge, s.clone()));
    let direction = polygon.inward_normal(edge);
    (margin2, Action::PushEdge { edge, interval: interval.clone(), s, point, direction }, wrench)
}

fn between(plane: &[Vec<Z>; 2], s: &Q) -> [Q; 3] {
    [0, 1, 2].map(|axis| Q::from(plane[0][axis].clone()) + Q::from(&plane[1][axis] - &plane[0][axis]) * s)
}

fn along(plane: &[Vec<Z>; 2], direction: &[Z; 2]) -> [Q; 3] {
    [0, 1, 2].map(|axis| Q::from(&plane[0][axis] * &direction[0] + &plane[1][axis] * &direction[1]))
}

/// A direction about the middle of each arc; any direction does where all are in the set.
fn middles(arcs: &ArcSet) -> Vec<(Option<Arc>, [Z; 2])> {
    if arcs.all {
        return vec![(None, [Z::from(0), Z::from(-1)])];
    }
    arcs.arcs.iter().map(|arc| (Some(arc.clone()), middle(arc))).collect()
}

/// A short exact direction near the bisector of an arc, strictly inside unless the arc is a single direction.
fn middle(arc: &Arc) -> [Z; 2] {
    let [from, to] = [&arc.from, &arc.to];
    let cross = &from[0] * &to[1] - &from[1] * &to[0];
    let dot = &from[0] * &to[0] + &from[1] * &to[1];
    if cross.is_zero() && dot.is_positive() {
        let opposite = [-&from[0], -&from[1]];
        return if arc.closed[0] { from.clone() } else { opposite };
    }
    if !cross.is_positive() {
        // half a turn or more: the opposite of the middle of the gap, or square to both ends
        let gap = middle_of_wedge(to, from);
        return if cross.is_zero() { [-&from[1], from[0].clone()] } else { [-&gap[0], -&gap[1]] };
    }
    middle_of_wedge(from, to)
}

/// For a wedge of less than half a turn: the sum of its ends at about equal lengths, in short integers.
fn middle_of_wedge(from: &[Z; 2], to: &[Z; 2]) -> [Z; 2] {
    let length = |d: &[Z; 2]| to_f64(&Q::from(&d[0] * &d[0] + &d[1] * &d[1])).sqrt();
    let share = from_float_exact(length(from) / length(to)).filter(Signed::is_positive).unwrap_or_else(|| ratio(1, 1));
    let sum = |share: &Q| {
        let row = [0, 1].map(|axis| Q::from(from[axis].clone()) + Q::from(to[axis].clone()) * share);
        let row = primitive_row(&row);
        [row[0].clone(), row[1].clone()]
    };
    let tolerance = &share * ratio(1, 1_000);
    sum(&approximate(&share, &tolerance))
}
