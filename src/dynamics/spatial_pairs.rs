//! Contacts in space: of balls, boxes and half spaces, found and carried along.
//!
//! A contact lies on a vertex where there is one, else on a ball above a half space, else on the other; of two vertices,
//! balls or edges on the other's, on the body's, on the body's. A box that lies on another has a contact at every corner
//! of the common patch: vertices of either on a face of the other, and edges that cross.

use super::collide_spatial::{Crossing, Cuboid, Near, crossing, crossings, separation};
use super::contact::Contact;
use super::mechanics::Contacts;
use super::turning::{UPRIGHT, along, cross, dot, length, own, placed, sub};
use crate::answer::{ContactName, Feature};
use crate::model::{Space, Spatial, SpatialShape, World, tangents};

/// Contacts as close as this part of the size of the smaller box are one.
const ROUNDING: f64 = 1e-6;

/// Features that overlap by more than so many times the least overlap of their boxes do not meet.
const DEEPEST: f64 = 4.0;

/// Where boxes overlap, cosine of the angle to the direction of the least overlap up to which normals push them apart.
const APART: f64 = 0.7;

/// Gap, point and normal of a pair of features.
type Meeting = (f64, [f64; 3], [f64; 3]);

/// A shape in the world.
#[derive(Debug, Clone, Copy)]
enum Solid {
    Ball([f64; 3], f64),
    Box(Cuboid),
    /// A point of the plane, and its normal.
    Half([f64; 3], [f64; 3]),
}

impl Solid {
    fn new(shape: &SpatialShape, pose: Option<&[f64; 7]>) -> Self {
        match shape {
            SpatialShape::Sphere { center, radius } => Self::Ball(placed(pose.unwrap_or(&UPRIGHT), *center), *radius),
            SpatialShape::Box { half } => Self::Box(Cuboid::new(pose, *half)),
            SpatialShape::HalfSpace { point, normal } => Self::Half(*point, *normal),
        }
    }

    /// A body, or an obstacle.
    fn of(world: &World<Spatial>, poses: &[[f64; 7]], at: usize) -> Option<Self> {
        match at.checked_sub(world.bodies.len()) {
            None => Some(Self::new(&world.bodies[at].shape, poses.get(at))),
            Some(fixed) => Some(Self::new(&world.fixed.get(fixed)?.shape, None)),
        }
    }
}

/// Every contact with a gap of at most `reach`, body by body, then obstacle by obstacle.
pub(super) fn find(world: &World<Spatial>, poses: &[[f64; 7]], reach: f64, out: &mut Contacts<Spatial>) {
    out.clear();
    let n_bodies = world.bodies.len();
    for body in 0..n_bodies.min(poses.len()) {
        let Some(solid) = Solid::of(world, poses, body) else { continue };
        for other in (n_bodies..n_bodies + world.fixed.len()).chain(body + 1..n_bodies) {
            let is_held = |at: usize| world.bodies.get(at).is_none_or(|body| body.is_kinematic);
            if is_held(body) && is_held(other) {
                continue;
            }
            if let Some(other_solid) = Solid::of(world, poses, other) {
                Pair { world, body, other, poses, reach, out: &mut *out }.meet(&solid, &other_solid);
            }
        }
    }
}

/// The same pair of features after the bodies moved from the poses `from`, where `found` was found, to `to`.
///
/// Faces count as whole planes, edges as whole lines. A vertex and an edge, or two vertices, keep the normal that they had.
pub(super) fn follow(
    world: &World<Spatial>,
    found: &Contact<Spatial>,
    from: &[[f64; 7]],
    to: &[[f64; 7]],
) -> Contact<Spatial> {
    let name = found.name;
    let solids = Solid::of(world, to, name.body).zip(Solid::of(world, to, name.other));
    let meeting = solids.and_then(|(a, b)| again(&a, &b, name)).or_else(|| carried(found, from, to));
    meeting.map_or(*found, |meeting| contact(world, to, name, meeting))
}

/// The features of `name`, wherever they are.
fn again(a: &Solid, b: &Solid, name: ContactName) -> Option<Meeting> {
    match (a, b, name.feature, name.other_feature) {
        (Solid::Ball(center, radius), Solid::Half(point, normal), ..) => {
            Some(ball_on(*center, *radius, *point, *normal))
        }
        (Solid::Ball(a, radius), Solid::Ball(b, other_radius), ..) => Some(balls(*a, *radius, *b, *other_radius)),
        (Solid::Ball(center, radius), Solid::Box(cuboid), _, feature) => {
            Some(ball_at(*radius, cuboid.nearest_on(feature, *center)))
        }
        (Solid::Box(cuboid), Solid::Ball(center, radius), feature, _) => {
            Some(at_ball(*center, *radius, cuboid.nearest_on(feature, *center)))
        }
        (Solid::Box(cuboid), Solid::Half(point, normal), Feature::Vertex(vertex), _) => {
            Some(vertex_on(cuboid.vertex(vertex), *point, *normal))
        }
        (Solid::Box(a), Solid::Box(b), Feature::Vertex(vertex), face @ Feature::Surface(_)) => {
            let vertex = a.vertex(vertex);
            Some(vertex_at(vertex, b.nearest_on(face, vertex)))
        }
        (Solid::Box(a), Solid::Box(b), face @ Feature::Surface(_), Feature::Vertex(vertex)) => {
            let vertex = b.vertex(vertex);
            Some(at_vertex(vertex, a.nearest_on(face, vertex)))
        }
        (Solid::Box(a), Solid::Box(b), Feature::Edge(on_a), Feature::Edge(on_b)) => {
            crossing(a, on_a, b, on_b).map(|Crossing { gap, points, normal, .. }| (gap, points[0], normal))
        }
        _ => None,
    }
}

/// The points that met, carried by their bodies, along the normal that they had.
fn carried(found: &Contact<Spatial>, from: &[[f64; 7]], to: &[[f64; 7]]) -> Option<Meeting> {
    let Contact { name, gap, point, normal, .. } = *found;
    let is_on_body = matches!(name.feature, Feature::Vertex(_));
    let on_body = if is_on_body { point } else { along(point, gap, normal) };
    let on_other = if is_on_body { along(point, -gap, normal) } else { point };
    let moved = |body: usize, point: [f64; 3]| match (from.get(body), to.get(body)) {
        (Some(from), Some(to)) => placed(to, own(from, point)),
        _ => point,
    };
    let (body_now, other_now) = (moved(name.body, on_body), moved(name.other, on_other));
    let gap = gap + dot(normal, sub(sub(body_now, on_body), sub(other_now, on_other)));
    Some((gap, if is_on_body { body_now } else { other_now }, normal))
}

/// A body and what it may touch.
struct Pair<'a> {
    world: &'a World<Spatial>,
    body: usize,
    other: usize,
    poses: &'a [[f64; 7]],
    reach: f64,
    out: &'a mut Contacts<Spatial>,
}

impl Pair<'_> {
    fn meet(&mut self, a: &Solid, b: &Solid) {
        let plain = Feature::Surface(0);
        match (a, b) {
            (Solid::Ball(center, radius), Solid::Half(point, normal)) => {
                self.push(ball_on(*center, *radius, *point, *normal), [plain, plain]);
            }
            (Solid::Ball(a, radius), Solid::Ball(b, other_radius)) => {
                self.push(balls(*a, *radius, *b, *other_radius), [plain, plain]);
            }
            (Solid::Ball(center, radius), Solid::Box(cuboid)) if !cuboid.is_far(*center, *radius, self.reach) => {
                let near = cuboid.closest(*center);
                self.push(ball_at(*radius, near), [plain, near.feature]);
            }
            (Solid::Box(cuboid), Solid::Ball(center, radius)) if !cuboid.is_far(*center, *radius, self.reach) => {
                let near = cuboid.closest(*center);
                self.push(at_ball(*center, *radius, near), [near.feature, plain]);
            }
            (Solid::Box(cuboid), Solid::Half(point, normal)) => {
                for vertex in 0..8 {
                    let meeting = vertex_on(cuboid.vertex(vertex), *point, *normal);
                    self.push(meeting, [Feature::Vertex(vertex), plain]);
                }
            }
            (Solid::Box(a), Solid::Box(b)) => self.boxes(a, b),
            (Solid::Ball(..), Solid::Box(_)) | (Solid::Box(_), Solid::Ball(..)) => {}
            // no body is a half space, which is seen to before a run
            (Solid::Half(..), _) => {}
        }
    }

    /// Vertices of each against the closest feature of the other, then edges; what coincides, once.
    fn boxes(&mut self, a: &Cuboid, b: &Cuboid) {
        if a.is_far_from(b, self.reach) {
            return;
        }
        let (apart, direction) = separation(a, b);
        if apart > self.reach {
            return;
        }
        let rounding = ROUNDING * a.size().min(b.size());
        let deepest = DEEPEST * apart.min(0.0) - rounding;
        // two convex bodies overlap in one place, and come apart in one direction
        let parts =
            |gap: f64, normal: [f64; 3]| gap >= deepest && (apart > -rounding || dot(normal, direction) >= APART);
        let first = self.out.len();
        for vertex in 0..8 {
            if let Some(near) = b.closest_to_vertex(a, vertex, rounding) {
                let meeting = vertex_at(a.vertex(vertex), near);
                if parts(meeting.0, meeting.2) {
                    self.push(meeting, [Feature::Vertex(vertex), near.feature]);
                }
            }
        }
        for vertex in 0..8 {
            let Some(near) = a.closest_to_vertex(b, vertex, rounding) else { continue };
            let meeting = at_vertex(b.vertex(vertex), near);
            let is_once = !matches!(near.feature, Feature::Vertex(_));
            if is_once && parts(meeting.0, meeting.2) && !self.is_known(first, meeting.1, meeting.2, rounding) {
                self.push(meeting, [near.feature, Feature::Vertex(vertex)]);
            }
        }
        crossings(a, b, |[on_a, on_b], Crossing { gap, points, normal, .. }| {
            if parts(gap, normal) && gap <= self.reach && !self.is_known(first, points[0], normal, rounding) {
                self.push((gap, points[0], normal), [Feature::Edge(on_a), Feature::Edge(on_b)]);
            }
        });
    }

    /// Whether a contact of this pair, from the one numbered `first` on, coincides with one at `point` as seen along `normal`.
    fn is_known(&self, first: usize, point: [f64; 3], normal: [f64; 3], rounding: f64) -> bool {
        self.out[first..].iter().any(|known| {
            let away = sub(known.point, point);
            let beside = along(away, -dot(away, normal), normal);
            dot(known.normal, normal) > 0.9 && length(beside) <= rounding
        })
    }

    fn push(&mut self, meeting: Meeting, [feature, other_feature]: [Feature; 2]) {
        if meeting.0 <= self.reach {
            let name = ContactName { body: self.body, feature, other: self.other, other_feature };
            self.out.push(contact(self.world, self.poses, name, meeting));
        }
    }
}

fn ball_on(center: [f64; 3], radius: f64, point: [f64; 3], normal: [f64; 3]) -> Meeting {
    (dot(normal, sub(center, point)) - radius, along(center, -radius, normal), normal)
}

fn vertex_on(vertex: [f64; 3], point: [f64; 3], normal: [f64; 3]) -> Meeting {
    (dot(normal, sub(vertex, point)), vertex, normal)
}

fn balls(a: [f64; 3], radius: f64, b: [f64; 3], other_radius: f64) -> Meeting {
    let away = sub(a, b);
    let distance = length(away);
    let normal = if distance > 0.0 { away.map(|x| x / distance) } else { [0.0, 0.0, 1.0] };
    (distance - radius - other_radius, along(b, other_radius, normal), normal)
}

/// A ball at what of a box is nearest to its center.
fn ball_at(radius: f64, near: Near) -> Meeting {
    (near.distance - radius, near.point, near.normal)
}

/// A box at a ball, by what of the box is nearest to the ball's center.
fn at_ball(center: [f64; 3], radius: f64, near: Near) -> Meeting {
    (near.distance - radius, along(center, -radius, near.normal), near.normal.map(|x| -x))
}

/// A vertex at what of the other box is nearest to it.
fn vertex_at(vertex: [f64; 3], near: Near) -> Meeting {
    (near.distance, vertex, near.normal)
}

/// A box at a vertex of the other, by what of it is nearest to the vertex.
fn at_vertex(vertex: [f64; 3], near: Near) -> Meeting {
    (near.distance, vertex, near.normal.map(|x| -x))
}

fn contact(
    world: &World<Spatial>,
    poses: &[[f64; 7]],
    name: ContactName,
    (gap, point, n): Meeting,
) -> Contact<Spatial> {
    let [t, o] = tangents(n);
    let rows = |pose: &[f64; 7], sign: f64| -> <Spatial as Space>::Rows {
        let r = sub(point, [pose[0], pose[1], pose[2]]);
        [n, t, o].map(|d| {
            let m = cross(r, d);
            [d[0], d[1], d[2], m[0], m[1], m[2]].map(|x| sign * x)
        })
    };
    let surface = name.other.checked_sub(world.bodies.len()).map(|i| world.fixed[i].surface_velocity);
    Contact {
        name,
        gap,
        point,
        normal: n,
        rows: rows(&poses[name.body], 1.0),
        other_rows: poses.get(name.other).map(|pose| rows(pose, -1.0)),
        surface: surface.unwrap_or_default(),
        material: *world.material(name.body, name.other),
    }
}
