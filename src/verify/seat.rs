//! The part and its fixels in doubles: gaps, and poses with given gaps.

use crate::exact::{Q, to_f64};
use crate::model::{Fixture, LengthUnit, Part, Place, PlanarShape, Shape};
use nalgebra::{Matrix3, Vector3};

/// Corrections of a pose after which its gaps are those asked for.
const CORRECTIONS: usize = 8;

/// A part over its fixels, in metres; the body's frame has its origin at the center of mass.
#[derive(Debug, Clone)]
pub(super) struct Seat {
    pub shape: PlanarShape,
    /// Center of mass of the seated part (world).
    pub com: [f64; 2],
    pub mass: f64,
    pub inertia: f64,
    /// Largest distance of the outline from the center of mass.
    pub size: f64,
    /// Radius of gyration.
    pub rho: f64,
    /// Least distance of a fixel from the next end of an edge.
    pub room: f64,
    pub fixels: Vec<Spot>,
}

/// A fixel of the seated part.
#[derive(Debug, Clone)]
pub(super) struct Spot {
    /// Where it is (world).
    pub at: [f64; 2],
    /// Unit normal into the seated part.
    pub normal: [f64; 2],
    /// Coefficients of friction that it may have: from the least kinetic to the largest static one.
    pub friction: [f64; 2],
    pub kind: Kind,
}

/// What of the part meets the fixel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Kind {
    /// An edge: a point of it and its unit inward normal, in the body's frame.
    Edge([f64; 2], [f64; 2]),
    /// A vertex, in the body's frame; the fixel is flat.
    Vertex([f64; 2]),
    /// A circle: its center in the body's frame, and its radius.
    Arc([f64; 2], f64),
}

impl Seat {
    pub fn new(part: &Part, fixture: &Fixture) -> Self {
        let unit = metres(part.unit);
        let point = |[x, y]: &[Q; 2]| [unit * to_f64(x), unit * to_f64(y)];
        let com = point(&part.center_of_mass);
        let own = |at: &[Q; 2]| sub(point(at), com);
        let spot = |fixel: &crate::model::Fixel| {
            let at = point(&fixel.point);
            let normal = unit_vector([to_f64(&fixel.normal[0]), to_f64(&fixel.normal[1])]);
            let kind = match (&fixel.place, &part.shape) {
                (Place::Arc, Shape::Circle { center, radius }) => Kind::Arc(own(center), unit * to_f64(radius)),
                (Place::Vertex { .. }, _) => Kind::Vertex(sub(at, com)),
                (Place::Edge { .. } | Place::Arc, _) => Kind::Edge(sub(at, com), normal),
            };
            let friction = [to_f64(&fixel.friction.kinetic.min), to_f64(&fixel.friction.static_.max)];
            Spot { at, normal, friction, kind }
        };
        let (mass, inertia) = (to_f64(&part.mass), unit * unit * to_f64(&part.inertia));
        let shape = match &part.shape {
            Shape::Polygon(polygon) => PlanarShape::Polygon(polygon.vertices().iter().map(own).collect()),
            Shape::Circle { center, radius } => {
                PlanarShape::Circle { center: own(center), radius: unit * to_f64(radius) }
            }
        };
        let size = match &shape {
            PlanarShape::Polygon(vertices) => vertices.iter().map(|v| length(*v)).fold(0.0, f64::max),
            PlanarShape::Circle { center, radius } => length(*center) + radius,
            PlanarShape::HalfPlane { .. } | PlanarShape::Compound(_) => unreachable!("parts are polygons and discs"),
        };
        let room = |fixel: &crate::model::Fixel| match &shape {
            PlanarShape::Polygon(vertices) => {
                let away = vertices.iter().map(|vertex| length(sub(sub(point(&fixel.point), com), *vertex)));
                away.filter(|away| *away > 0.0).fold(f64::INFINITY, f64::min)
            }
            _ => size,
        };
        let room = fixture.fixels.iter().map(room).fold(size, f64::min);
        let rho = (inertia / mass).sqrt();
        Self { com, mass, inertia, size, rho, room, fixels: fixture.fixels.iter().map(spot).collect(), shape }
    }

    /// Gap at a fixel (m).
    pub fn gap(&self, fixel: usize, pose: &[f64; 3]) -> f64 {
        let spot = &self.fixels[fixel];
        let (sine, cosine) = libm::sincos(pose[2]);
        let turn = |v: [f64; 2]| [cosine * v[0] - sine * v[1], sine * v[0] + cosine * v[1]];
        let place = |v: [f64; 2]| add(turn(v), [pose[0], pose[1]]);
        match spot.kind {
            Kind::Edge(point, normal) => dot(turn(normal), sub(place(point), spot.at)),
            Kind::Vertex(vertex) => dot(spot.normal, sub(place(vertex), spot.at)),
            Kind::Arc(center, radius) => length(sub(spot.at, place(center))) - radius,
        }
    }

    /// Largest gap at a fixel (m), not negative.
    pub fn widest(&self, pose: &[f64; 3]) -> f64 {
        (0..self.fixels.len()).map(|fixel| self.gap(fixel, pose)).fold(0.0, f64::max)
    }

    /// The pose with these gaps (m) that is nearest to the seated one, moved by `drift` where gaps do not tell.
    ///
    /// Gauss and Newton's method in (x, y, ρ θ), with the rows of W_n at the seated pose.
    pub fn pose(&self, gaps: &[f64], drift: [f64; 3]) -> [f64; 3] {
        let mut rows = Matrix3::zeros();
        for (index, spot) in self.fixels.iter().take(3).enumerate() {
            let arm = sub(spot.at, self.com);
            let turn = arm[0] * spot.normal[1] - arm[1] * spot.normal[0];
            rows.set_row(index, &Vector3::new(spot.normal[0], spot.normal[1], turn / self.rho).transpose());
        }
        let back = rows.pseudo_inverse(1e-9 * rows.norm()).unwrap_or_else(|_| Matrix3::zeros());
        let mut q = Vector3::new(drift[0], drift[1], self.rho * drift[2]);
        let pose = |q: &Vector3<f64>| [self.com[0] + q.x, self.com[1] + q.y, q.z / self.rho];
        for _ in 0..CORRECTIONS {
            let mut off = Vector3::zeros();
            for (index, gap) in gaps.iter().take(3).enumerate() {
                off[index] = gap - self.gap(index, &pose(&q));
            }
            q += back * off;
        }
        pose(&q)
    }
}

/// Metres to a unit.
pub(super) fn metres(unit: LengthUnit) -> f64 {
    to_f64(&unit.metres())
}

pub(super) fn add(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] + b[0], a[1] + b[1]]
}

pub(super) fn sub(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

pub(super) fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

pub(super) fn length(v: [f64; 2]) -> f64 {
    dot(v, v).sqrt()
}

pub(super) fn unit_vector(v: [f64; 2]) -> [f64; 2] {
    let length = length(v);
    [v[0] / length, v[1] / length]
}
