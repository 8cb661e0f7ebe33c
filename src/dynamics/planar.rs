//! Mechanics in the plane: three velocities a body, contacts of polygons, discs, points and half planes.

use super::collide::{Outline, distance, dot, sub};
use super::contact::Contact;
use super::finger;
use super::mechanics::{Contacts, Mechanics};
use super::planar_follow;
use crate::answer::{ContactName, Feature};
use crate::model::{Body, Finger, Material, Planar, PlanarShape, World};

/// Outlines of bodies and obstacles, piece by piece.
#[derive(Debug)]
pub struct PlanarOutlines {
    pub(super) own: Vec<Vec<Piece>>,
    placed: Vec<Vec<Piece>>,
    pub(super) fixed: Vec<Vec<Piece>>,
}

/// A convex or simple piece of an outline.
#[derive(Debug, Clone)]
pub(super) struct Piece {
    /// Number of its first vertex, edge or surface in the whole outline.
    pub first: u32,
    pub kind: Kind,
}

#[derive(Debug, Clone)]
pub(super) enum Kind {
    Polygon(Outline),
    Disc { center: [f64; 2], radius: f64 },
    HalfPlane { point: [f64; 2], normal: [f64; 2] },
}

impl Mechanics for Planar {
    type Outlines = PlanarOutlines;

    const TANGENTS: usize = 1;

    fn outlines(world: &World<Self>) -> PlanarOutlines {
        let own: Vec<Vec<Piece>> = world.bodies.iter().map(|body| pieces(&body.shape)).collect();
        let fixed = world.fixed.iter().map(|obstacle| pieces(&obstacle.shape)).collect();
        PlanarOutlines { placed: own.clone(), own, fixed }
    }

    fn contacts(
        outlines: &mut PlanarOutlines,
        world: &World<Self>,
        poses: &[[f64; 3]],
        reach: f64,
        out: &mut Contacts<Self>,
    ) {
        out.clear();
        for ((placed, own), pose) in outlines.placed.iter_mut().zip(&outlines.own).zip(poses) {
            place(placed, own, pose);
        }
        let outlines = &*outlines;
        for (body, (pieces, pose)) in outlines.placed.iter().zip(poses).enumerate() {
            let n_bodies = world.bodies.len();
            let is_held = |other: usize| {
                world.bodies[body].is_kinematic && world.bodies.get(other).is_none_or(|b| b.is_kinematic)
            };
            let obstacles = outlines.fixed.iter().enumerate().map(|(i, pieces)| (n_bodies + i, pieces));
            let bodies = outlines.placed.iter().enumerate().skip(body + 1);
            for (other, others) in bodies.chain(obstacles).filter(|(other, _)| !is_held(*other)) {
                let material = *world.material(body, other);
                let surface = other.checked_sub(n_bodies).map(|i| world.fixed[i].surface_velocity);
                let mut pair =
                    Pair { body, other, pose, other_pose: poses.get(other), surface, material, reach, out: &mut *out };
                for a in pieces {
                    for b in others {
                        pair.meet(a, b);
                    }
                }
            }
        }
    }

    fn advanced(pose: &[f64; 3], velocity: &[f64; 3], time: f64) -> [f64; 3] {
        std::array::from_fn(|i| pose[i] + time * velocity[i])
    }

    fn weighed(body: &Body<Self>, _: &[f64; 3], [x, y, torque]: &[f64; 3]) -> [f64; 3] {
        if body.is_kinematic {
            return [0.0; 3];
        }
        [x / body.mass, y / body.mass, torque / body.inertia[0]]
    }

    fn principal(_: &Body<Self>, _: &[f64; 3], row: &[f64; 3]) -> [f64; 3] {
        *row
    }

    fn inverse_mass(body: &Body<Self>) -> [f64; 3] {
        Self::weighed(body, &[0.0; 3], &[1.0; 3])
    }

    fn momentum(body: &Body<Self>, _: &[f64; 3], [x, y, spin]: &[f64; 3]) -> [f64; 3] {
        [x * body.mass, y * body.mass, spin * body.inertia[0]]
    }

    fn own_wrench(gravity: &[f64; 2], body: &Body<Self>, _: &[f64; 3], _: &[f64; 3]) -> [f64; 3] {
        [body.mass * gravity[0], body.mass * gravity[1], 0.0]
    }

    fn push(body: &Body<Self>, finger: &Finger, pose: &[f64; 3]) -> Option<[f64; 3]> {
        finger::push(&body.shape, finger, pose)
    }

    fn potential(gravity: &[f64; 2], pose: &[f64; 3]) -> f64 {
        -(gravity[0] * pose[0] + gravity[1] * pose[1])
    }

    fn displacement(from: &[f64; 3], to: &[f64; 3]) -> [f64; 3] {
        std::array::from_fn(|i| to[i] - from[i])
    }

    fn separation(radius: f64, a: &[f64; 3], b: &[f64; 3]) -> f64 {
        distance([a[0], a[1]], [b[0], b[1]]) + radius * (a[2] - b[2]).abs()
    }

    fn radius(body: &Body<Self>) -> f64 {
        let farthest = |piece: &Piece| match &piece.kind {
            Kind::Polygon(outline) => outline.vertices.iter().map(|v| dot(*v, *v).sqrt()).fold(0.0, f64::max),
            Kind::Disc { center, radius } => dot(*center, *center).sqrt() + radius,
            Kind::HalfPlane { .. } => f64::INFINITY,
        };
        pieces(&body.shape).iter().map(farthest).fold(0.0, f64::max)
    }

    fn fastest(radius: f64, [x, y, spin]: &[f64; 3]) -> f64 {
        (x * x + y * y).sqrt() + radius * spin.abs()
    }

    fn follow(
        outlines: &PlanarOutlines,
        _: &World<Self>,
        contact: &Contact<Self>,
        from: &[[f64; 3]],
        to: &[[f64; 3]],
    ) -> Contact<Self> {
        planar_follow::follow(outlines, contact, from, to)
    }

    fn swing(point: &[f64; 2], pose: &[f64; 3], wrench: &[f64; 3], velocity: &[f64; 3]) -> [f64; 3] {
        planar_follow::swing(point, pose, wrench, velocity)
    }

    fn is_fixed_only(shape: &PlanarShape) -> bool {
        pieces(shape).iter().any(|piece| matches!(piece.kind, Kind::HalfPlane { .. }))
    }

    fn half_thickness(shape: &PlanarShape) -> f64 {
        planar_follow::half_thickness(shape)
    }
}

/// Two outlines that may touch.
struct Pair<'a> {
    body: usize,
    other: usize,
    pose: &'a [f64; 3],
    other_pose: Option<&'a [f64; 3]>,
    surface: Option<[f64; 2]>,
    material: Material,
    reach: f64,
    out: &'a mut Contacts<Planar>,
}

impl Pair<'_> {
    /// Adds the contacts of two pieces.
    fn meet(&mut self, a: &Piece, b: &Piece) {
        match (&a.kind, &b.kind) {
            (Kind::Polygon(_) | Kind::Disc { .. }, Kind::HalfPlane { point, normal }) => {
                self.on_half_plane(a, b, *point, *normal);
            }
            (Kind::HalfPlane { .. }, _) => {}
            (Kind::Polygon(p), Kind::Polygon(q)) => self.polygons(a, b, p, q),
            (Kind::Polygon(p), Kind::Disc { center, radius }) => self.disc_on_polygon(b, a, *center, *radius, p, true),
            (Kind::Disc { center, radius }, Kind::Polygon(q)) => self.disc_on_polygon(a, b, *center, *radius, q, false),
            (Kind::Disc { center, radius }, Kind::Disc { center: other, radius: other_radius }) => {
                let away = sub(*center, *other);
                let distance = dot(away, away).sqrt();
                let normal = if distance > 0.0 { [away[0] / distance, away[1] / distance] } else { [0.0, 1.0] };
                let point = [other[0] + normal[0] * other_radius, other[1] + normal[1] * other_radius];
                let features = [Feature::Surface(a.first), Feature::Surface(b.first)];
                self.push(distance - radius - other_radius, point, normal, features);
            }
        }
    }

    fn on_half_plane(&mut self, a: &Piece, b: &Piece, point: [f64; 2], normal: [f64; 2]) {
        let surface = Feature::Surface(b.first);
        match &a.kind {
            Kind::Polygon(outline) => {
                for (i, v) in (a.first..).zip(&outline.vertices) {
                    self.push(dot(normal, sub(*v, point)), *v, normal, [Feature::Vertex(i), surface]);
                }
            }
            Kind::Disc { center, radius } => {
                let gap = dot(normal, sub(*center, point)) - radius;
                let lowest = [center[0] - radius * normal[0], center[1] - radius * normal[1]];
                self.push(gap, lowest, normal, [Feature::Surface(a.first), surface]);
            }
            Kind::HalfPlane { .. } => {}
        }
    }

    /// Vertices of each against the nearest feature of the other; pairs of vertices once.
    fn polygons(&mut self, a: &Piece, b: &Piece, p: &Outline, q: &Outline) {
        if !p.is_near_box(q.bounds, self.reach) {
            return;
        }
        let (reach, first) = (self.reach, self.out.len());
        for (i, v) in p.vertices.iter().enumerate().filter(|(i, v)| p.convex[*i] && q.is_near(**v, reach)) {
            let closest = q.closest(*v, reach, |normal| p.sees(i, [-normal[0], -normal[1]]));
            if let Some(near) = closest {
                self.push(near.distance, *v, near.normal, [vertex(a, i), shifted(near.feature, b)]);
            }
        }
        for (i, v) in q.vertices.iter().enumerate().filter(|(i, v)| q.convex[*i] && p.is_near(**v, reach)) {
            let closest = p.closest(*v, reach, |normal| q.sees(i, [-normal[0], -normal[1]]));
            let is_edge = |feature| matches!(feature, Feature::Edge(_));
            // corner on corner is one contact, not one for each side
            let rounding = 1e-6 * q.size();
            let is_known = || self.out[first..].iter().any(|contact| distance(contact.point, *v) <= rounding);
            if let Some(near) = closest.filter(|near| is_edge(near.feature) && !is_known()) {
                let into = [-near.normal[0], -near.normal[1]];
                self.push(near.distance, *v, into, [shifted(near.feature, a), vertex(b, i)]);
            }
        }
    }

    /// A disc and a polygon, whichever of the two is the body.
    fn disc_on_polygon(
        &mut self,
        disc: &Piece,
        piece: &Piece,
        center: [f64; 2],
        radius: f64,
        polygon: &Outline,
        is_disc_other: bool,
    ) {
        if !polygon.is_near(center, self.reach + radius) {
            return;
        }
        let Some(near) = polygon.closest(center, self.reach + radius, |_| true) else {
            return;
        };
        let (surface, feature) = (Feature::Surface(disc.first), shifted(near.feature, piece));
        let gap = near.distance - radius;
        if is_disc_other {
            let into = [-near.normal[0], -near.normal[1]];
            let point = [center[0] + radius * into[0], center[1] + radius * into[1]];
            self.push(gap, point, into, [feature, surface]);
        } else {
            self.push(gap, near.point, near.normal, [surface, feature]);
        }
    }

    fn push(&mut self, gap: f64, point: [f64; 2], n: [f64; 2], [feature, other_feature]: [Feature; 2]) {
        if gap > self.reach {
            return;
        }
        self.out.push(Contact {
            name: ContactName { body: self.body, feature, other: self.other, other_feature },
            gap,
            point,
            normal: n,
            rows: rows(point, n, self.pose, 1.0),
            other_rows: self.other_pose.map(|pose| rows(point, n, pose, -1.0)),
            surface: self.surface.unwrap_or_default(),
            material: self.material,
        });
    }
}

/// W_n and W_t of a body at `pose`, times `sign`.
pub(super) fn rows(point: [f64; 2], n: [f64; 2], pose: &[f64; 3], sign: f64) -> [[f64; 3]; 2] {
    let t = [n[1], -n[0]];
    let r = [point[0] - pose[0], point[1] - pose[1]];
    [n, t].map(|d| [sign * d[0], sign * d[1], sign * (r[0] * d[1] - r[1] * d[0])])
}

pub(super) fn pieces(shape: &PlanarShape) -> Vec<Piece> {
    let mut pieces = Vec::new();
    let mut first = 0;
    let mut add = |shape: &PlanarShape| {
        let (kind, count) = match shape {
            PlanarShape::Polygon(vertices) => (Kind::Polygon(Outline::new(vertices.clone())), vertices.len()),
            PlanarShape::Circle { center, radius } => (Kind::Disc { center: *center, radius: *radius }, 1),
            PlanarShape::HalfPlane { point, normal } => (Kind::HalfPlane { point: *point, normal: *normal }, 1),
            PlanarShape::Compound(_) => return,
        };
        pieces.push(Piece { first, kind });
        first += u32::try_from(count).unwrap_or(u32::MAX);
    };
    match shape {
        PlanarShape::Compound(parts) => parts.iter().for_each(add),
        single => add(single),
    }
    pieces
}

fn place(placed: &mut [Piece], own: &[Piece], [x, y, angle]: &[f64; 3]) {
    let (sine, cosine) = libm::sincos(*angle);
    for (placed, own) in placed.iter_mut().zip(own) {
        match (&mut placed.kind, &own.kind) {
            (Kind::Polygon(outline), Kind::Polygon(own)) => outline.place(own, [cosine, sine], [*x, *y]),
            (Kind::Disc { center, .. }, Kind::Disc { center: own, .. }) => {
                *center = [x + cosine * own[0] - sine * own[1], y + sine * own[0] + cosine * own[1]];
            }
            _ => {}
        }
    }
}

fn vertex(piece: &Piece, index: usize) -> Feature {
    Feature::Vertex(piece.first.saturating_add(u32::try_from(index).unwrap_or(u32::MAX)))
}

fn shifted(feature: Feature, piece: &Piece) -> Feature {
    match feature {
        Feature::Vertex(i) => Feature::Vertex(i + piece.first),
        Feature::Edge(i) => Feature::Edge(i + piece.first),
        Feature::Surface(i) => Feature::Surface(i + piece.first),
    }
}
