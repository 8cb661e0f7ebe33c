//! The margin of a plan in floating point: proposes what is worth planning exactly, decides nothing.

use super::super::robust::dot;
use crate::exact::{Q, to_f64};
use crate::geometry::Polygon;
use crate::model::{Fixture, Part};

/// Places per edge at which a push is tried.
const PUSHES: usize = 8;
/// Directions in which a tilt is tried.
const TILTS: usize = 24;
/// Steps to either side of the best sample, each half the one before; the first is a quarter of the way to the next.
const HALVINGS: i32 = 5;
/// Below this a product of unit vectors counts as zero.
const ERROR: f64 = 1e-9;

type Vector = [f64; 3];

/// A part and the friction of its fixels, in units of the part's reach and in coordinates (fx, fy, torque / ρ), where
/// accelerations, forces and distances are Euclidean.
pub(super) struct Estimator {
    rho: f64,
    edges: Vec<Edge>,
    friction: Vec<f64>,
    /// Pushes and tilts to try first.
    samples: Vec<(Choice, Action)>,
}

/// A push at a share of an edge, or a tilt at a share of a turn.
#[derive(Clone, Copy)]
enum Choice {
    Push(usize, f64),
    Tilt(f64),
}

/// The unit wrench of a choice, and the most that its margin can be.
type Action = (Vector, f64);

struct Edge {
    from: [f64; 2],
    along: [f64; 2],
    inward: [f64; 2],
}

impl Estimator {
    pub(super) fn of(part: &Part, polygon: &Polygon, fixture: &Fixture) -> Self {
        let (unit, com) = (part.torque_reach(), &part.center_of_mass);
        let near = |point: &[Q; 2]| [0, 1].map(|axis| to_f64(&((&point[axis] - &com[axis]) / &unit)));
        let edges: Vec<Edge> = (0..polygon.n_edges())
            .map(|edge| {
                let [from, to] = polygon.edge(edge).map(near);
                let along = [to[0] - from[0], to[1] - from[1]];
                let length = along[0].hypot(along[1]);
                Edge { from, along, inward: [-along[1] / length, along[0] / length] }
            })
            .collect();
        let friction = fixture.fixels.iter().map(|fixel| to_f64(&fixel.friction.static_.max)).collect();
        let rho = to_f64(&(part.gyration2() / (&unit * &unit))).sqrt();
        let mut estimator = Self { rho, edges, friction, samples: Vec::new() };
        let places = |edge| (0..PUSHES).map(move |k| Choice::Push(edge, (k as f64 + 0.5) / PUSHES as f64));
        let tilts = (0..TILTS).map(|k| Choice::Tilt(k as f64 / TILTS as f64));
        let choices = (0..estimator.edges.len()).flat_map(places).chain(tilts);
        estimator.samples = choices.map(|choice| (choice, estimator.action(choice))).collect();
        estimator
    }

    fn action(&self, choice: Choice) -> Action {
        match choice {
            Choice::Push(edge, s) => {
                let [x, y] = self.edges[edge].along;
                let [push, _] = self.contact(edge, s);
                (unit(push), s.min(1.0 - s) * x.hypot(y) / self.rho)
            }
            Choice::Tilt(turn) => {
                let (sin, cos) = (turn * std::f64::consts::TAU).sin_cos();
                ([cos, sin, 0.0], 1.0)
            }
        }
    }

    /// Wrenches of the unit normal and tangent at share `s` of an edge.
    fn contact(&self, edge: usize, s: f64) -> [Vector; 2] {
        let Edge { from, along, inward: [x, y] } = &self.edges[edge];
        let arm = [from[0] + s * along[0], from[1] + s * along[1]];
        let wrench = |[x, y]: [f64; 2]| [x, y, (arm[0] * y - arm[1] * x) / self.rho];
        [wrench([*x, *y]), wrench([-*y, *x])]
    }

    /// About the margin of the best push or tilt onto fixels at these edges and shares, or no more than `least` if it is
    /// not above that.
    ///
    /// Of the cones that a plan must avoid it knows those under which an unseated state persists (`m` on some contacts, `s`
    /// on the others) and those under which contacts can both break and be added again while others are maintained.
    pub(super) fn margin(&self, places: &[(usize, f64)], least: f64) -> f64 {
        let contacts: Vec<[Vector; 2]> = places.iter().map(|(edge, s)| self.contact(*edge, *s)).collect();
        let Some(duals) = duals(&contacts) else { return 0.0 };
        let cones = Cones { contacts: &contacts, duals, friction: &self.friction };
        let all = (1_usize << contacts.len()) - 1;
        let mut holes: Vec<Vec<Vector>> = (0..all).map(|kept| cones.facets(kept, all & !kept, 1.0)).collect();
        let most = self.best_action(&holes, least);
        if most <= least {
            return most;
        }
        for kept in (1..all).filter(|kept| cones.has_friction(*kept)) {
            for apart in (1..=all).filter(|apart| apart & kept == 0) {
                holes.push([cones.facets(kept, apart, 1.0), cones.facets(kept, apart, -1.0)].concat());
            }
        }
        self.best_action(&holes, least)
    }

    /// About the largest margin of an action outside of `holes`, each by facets of which a point of it exceeds none, if
    /// it is above `least`.
    fn best_action(&self, holes: &[Vec<Vector>], least: f64) -> f64 {
        let mut best = least;
        let mut chosen = None;
        for (choice, action) in &self.samples {
            let margin = margin(action, holes, best);
            if margin > best {
                (best, chosen) = (margin, Some(*choice));
            }
        }
        let Some(mut chosen) = chosen else { return best };
        for halving in 2..2 + HALVINGS {
            let step = 0.5_f64.powi(halving);
            let near = |sign: f64| match chosen {
                Choice::Push(edge, s) => Choice::Push(edge, s + sign * step / PUSHES as f64),
                Choice::Tilt(turn) => Choice::Tilt(turn + sign * step / TILTS as f64),
            };
            for choice in [near(-1.0), near(1.0)] {
                let margin = margin(&self.action(choice), holes, best);
                if margin > best {
                    (best, chosen) = (margin, choice);
                }
            }
        }
        best
    }
}

/// Distance of a unit wrench from the nearest hole, at most what its action allows; no more than `least` if it is not
/// above that.
fn margin((wrench, most): &Action, holes: &[Vec<Vector>], least: f64) -> f64 {
    let mut margin = *most;
    for facets in holes {
        if margin <= least {
            break;
        }
        margin = margin.min(facets.iter().map(|facet| dot(facet, wrench)).fold(0.0, f64::max));
    }
    margin
}

/// Cones of modes by their generators: with e_j the basis dual to the normals' rows, e_j for a contact that separates,
/// both ways if it is free, and both edges of the friction cone for one that is maintained.
struct Cones<'a> {
    contacts: &'a [[Vector; 2]],
    duals: [Vector; 3],
    friction: &'a [f64],
}

impl Cones<'_> {
    /// Outward facet normals of the cone with `m` on the contacts `kept`, `s` (with `sign` -1: `a`) on those `apart`, `u`
    /// elsewhere; none if it is everything.
    fn facets(&self, kept: usize, apart: usize, sign: f64) -> Vec<Vector> {
        let mut generators = Vec::new();
        for (index, dual) in self.duals.iter().enumerate() {
            let is_among = |set: usize| index < self.contacts.len() && set >> index & 1 == 1;
            if is_among(kept) {
                let ([normal, tangent], friction) = (&self.contacts[index], self.friction[index]);
                generators.extend([friction, -friction].map(|share| unit(minus(&scaled(tangent, share), normal))));
            } else if is_among(apart) {
                generators.push(scaled(dual, sign));
            } else {
                generators.extend([*dual, scaled(dual, -1.0)]);
            }
        }
        facets(&generators)
    }

    fn has_friction(&self, kept: usize) -> bool {
        (0..self.contacts.len()).any(|index| kept >> index & 1 == 1 && self.friction[index] > 0.0)
    }
}

/// The basis dual to the normals, completed by unit vectors square to all of them; `None` if they are dependent.
fn duals(contacts: &[[Vector; 2]]) -> Option<[Vector; 3]> {
    let mut rows: Vec<Vector> = contacts.iter().map(|[normal, _]| unit(*normal)).collect();
    if rows.len() == 1 {
        let axis = if rows[0][2].abs() < 0.5 { [0.0, 0.0, 1.0] } else { [1.0, 0.0, 0.0] };
        rows.push(unit(cross(&rows[0], &axis)));
    }
    if rows.len() == 2 {
        rows.push(unit(cross(&rows[0], &rows[1])));
    }
    let [a, b, c] = <[Vector; 3]>::try_from(rows).ok()?;
    let [of_a, of_b, of_c] = [cross(&b, &c), cross(&c, &a), cross(&a, &b)];
    let determinant = dot(&a, &of_a);
    (determinant.abs() > ERROR).then(|| [of_a, of_b, of_c].map(|dual| unit(scaled(&dual, determinant.signum()))))
}

/// Unit outward normals of the facets of a cone; none if it is everything.
fn facets(generators: &[Vector]) -> Vec<Vector> {
    let mut facets = Vec::new();
    for (index, a) in generators.iter().enumerate() {
        for b in &generators[..index] {
            let normal = cross(a, b);
            if dot(&normal, &normal) < ERROR * ERROR {
                continue;
            }
            let normal = unit(normal);
            let sides = generators.iter().map(|generator| dot(&normal, generator));
            let (low, high) = sides.fold((0.0_f64, 0.0_f64), |(low, high), side| (low.min(side), high.max(side)));
            if high <= ERROR {
                facets.push(normal);
            }
            if low >= -ERROR {
                facets.push(scaled(&normal, -1.0));
            }
        }
    }
    facets
}

fn cross(a: &Vector, b: &Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn scaled(a: &Vector, by: f64) -> Vector {
    a.map(|value| value * by)
}

fn minus(a: &Vector, b: &Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn unit(a: Vector) -> Vector {
    scaled(&a, dot(&a, &a).sqrt().recip())
}
