//! Mechanics in space: six velocities a body, contacts of balls and boxes with half spaces, and of balls.

use super::contact::Contact;
use super::mechanics::{Contacts, Mechanics};
use crate::answer::{ContactName, Feature};
use crate::model::{Body, Spatial, SpatialShape, World};

impl Mechanics for Spatial {
    type Outlines = ();

    const TANGENTS: usize = 2;

    fn outlines(_: &World<Self>) {}

    fn contacts((): &mut (), world: &World<Self>, poses: &[[f64; 7]], reach: f64, out: &mut Contacts<Self>) {
        out.clear();
        let n_bodies = world.bodies.len();
        for (body, pose) in poses.iter().enumerate() {
            for (i, obstacle) in world.fixed.iter().enumerate() {
                if let (false, SpatialShape::HalfSpace { point, normal }) =
                    (world.bodies[body].is_kinematic, &obstacle.shape)
                {
                    let mut pair = Pair { world, body, other: n_bodies + i, poses, reach, out: &mut *out };
                    pair.on_half_space(pose, *point, *normal);
                }
            }
            for other in body + 1..n_bodies {
                if !(world.bodies[body].is_kinematic && world.bodies[other].is_kinematic) {
                    Pair { world, body, other, poses, reach, out: &mut *out }.balls();
                }
            }
        }
    }

    fn advanced(pose: &[f64; 7], velocity: &[f64; 6], time: f64) -> [f64; 7] {
        let [x, y, z, e0, e1, e2, e3] = *pose;
        let [vx, vy, vz, wx, wy, wz] = velocity.map(|v| v * time);
        // e' = e + h/2 (0, ω) e, of unit length again: the plain map shrinks it
        let (e0, e1, e2, e3) = (
            e0 - 0.5 * (wx * e1 + wy * e2 + wz * e3),
            e1 + 0.5 * (wx * e0 + wy * e3 - wz * e2),
            e2 + 0.5 * (wy * e0 + wz * e1 - wx * e3),
            e3 + 0.5 * (wz * e0 + wx * e2 - wy * e1),
        );
        let length = (e0 * e0 + e1 * e1 + e2 * e2 + e3 * e3).sqrt();
        [x + vx, y + vy, z + vz, e0 / length, e1 / length, e2 / length, e3 / length]
    }

    fn weighed(body: &Body<Self>, pose: &[f64; 7], wrench: &[f64; 6]) -> [f64; 6] {
        if body.is_kinematic {
            return [0.0; 6];
        }
        let [fx, fy, fz, ..] = wrench.map(|f| f / body.mass);
        let [x, y, z] = scaled_in_body(body.inertia.map(f64::recip), pose, [wrench[3], wrench[4], wrench[5]]);
        [fx, fy, fz, x, y, z]
    }

    fn principal(body: &Body<Self>, pose: &[f64; 7], row: &[f64; 6]) -> [f64; 6] {
        if is_isotropic(body.inertia) {
            return *row;
        }
        let [x, y, z] = turned(&conjugate(pose), [row[3], row[4], row[5]]);
        [row[0], row[1], row[2], x, y, z]
    }

    fn inverse_mass(body: &Body<Self>) -> [f64; 6] {
        if body.is_kinematic {
            return [0.0; 6];
        }
        let ([x, y, z], m) = (body.inertia.map(f64::recip), body.mass.recip());
        [m, m, m, x, y, z]
    }

    fn momentum(body: &Body<Self>, pose: &[f64; 7], velocity: &[f64; 6]) -> [f64; 6] {
        let [px, py, pz, ..] = velocity.map(|v| v * body.mass);
        let [x, y, z] = scaled_in_body(body.inertia, pose, [velocity[3], velocity[4], velocity[5]]);
        [px, py, pz, x, y, z]
    }

    fn own_wrench(gravity: &[f64; 3], body: &Body<Self>, pose: &[f64; 7], velocity: &[f64; 6]) -> [f64; 6] {
        let [_, _, _, lx, ly, lz] = Self::momentum(body, pose, velocity);
        // -ω × (I ω): zero where the three moments are equal
        let [gx, gy, gz] = if is_isotropic(body.inertia) {
            [0.0; 3]
        } else {
            cross([lx, ly, lz], [velocity[3], velocity[4], velocity[5]])
        };
        [body.mass * gravity[0], body.mass * gravity[1], body.mass * gravity[2], gx, gy, gz]
    }

    fn potential(gravity: &[f64; 3], pose: &[f64; 7]) -> f64 {
        -(gravity[0] * pose[0] + gravity[1] * pose[1] + gravity[2] * pose[2])
    }

    fn displacement(from: &[f64; 7], to: &[f64; 7]) -> [f64; 6] {
        let ([a, ax, ay, az], [b, bx, by, bz]) = ([from[3], from[4], from[5], from[6]], [to[3], to[4], to[5], to[6]]);
        // to × conj(from)
        let e0 = b * a + bx * ax + by * ay + bz * az;
        let e = [
            -b * ax + bx * a - by * az + bz * ay,
            -b * ay + by * a - bz * ax + bx * az,
            -b * az + bz * a - bx * ay + by * ax,
        ];
        let length = dot(e, e).sqrt();
        let turn = if length > 0.0 { 2.0 * libm::atan2(length, e0.abs()) / length * e0.signum() } else { 0.0 };
        [to[0] - from[0], to[1] - from[1], to[2] - from[2], turn * e[0], turn * e[1], turn * e[2]]
    }

    fn separation(radius: f64, a: &[f64; 7], b: &[f64; 7]) -> f64 {
        let away = [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
        let cosine: f64 = a[3..].iter().zip(&b[3..]).map(|(a, b)| a * b).sum();
        dot(away, away).sqrt() + 2.0 * radius * libm::acos(cosine.abs().min(1.0))
    }

    fn radius(body: &Body<Self>) -> f64 {
        match &body.shape {
            SpatialShape::Sphere { center, radius } => dot(*center, *center).sqrt() + radius,
            SpatialShape::Box { half } => dot(*half, *half).sqrt(),
            SpatialShape::HalfSpace { .. } => f64::INFINITY,
        }
    }

    fn fastest(radius: f64, [x, y, z, wx, wy, wz]: &[f64; 6]) -> f64 {
        (x * x + y * y + z * z).sqrt() + radius * (wx * wx + wy * wy + wz * wz).sqrt()
    }

    fn follow((): &(), world: &World<Self>, found: &Contact<Self>, _: &[[f64; 7]], to: &[[f64; 7]]) -> Contact<Self> {
        meeting(world, to, found.name).map_or(*found, |meeting| contact(world, to, found.name, meeting))
    }

    fn swing(point: &[f64; 3], pose: &[f64; 7], wrench: &[f64; 6], velocity: &[f64; 6]) -> [f64; 6] {
        let r = [point[0] - pose[0], point[1] - pose[1], point[2] - pose[2]];
        let ([fx, fy, fz, ..], [_, _, _, wx, wy, wz]) = (*wrench, *velocity);
        // ω · (φ × r) × f = (ω · r) (f · φ) - (r · f) (ω · φ)
        let (across, along) = (dot([wx, wy, wz], r), dot(r, [fx, fy, fz]));
        [0.0, 0.0, 0.0, across * fx - along * wx, across * fy - along * wy, across * fz - along * wz]
    }

    fn half_thickness(shape: &SpatialShape) -> f64 {
        match shape {
            SpatialShape::Sphere { radius, .. } => *radius,
            SpatialShape::Box { half: [x, y, z] } => x.min(*y).min(*z),
            SpatialShape::HalfSpace { .. } => f64::INFINITY,
        }
    }
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
    fn on_half_space(&mut self, pose: &[f64; 7], point: [f64; 3], normal: [f64; 3]) {
        match self.world.bodies[self.body].shape {
            SpatialShape::Sphere { center, radius } => {
                self.push(ball_on(pose, center, radius, point, normal), Feature::Surface(0));
            }
            SpatialShape::Box { half } => {
                for corner in 0..8_u32 {
                    self.push(corner_on(pose, half, corner, point, normal), Feature::Vertex(corner));
                }
            }
            SpatialShape::HalfSpace { .. } => {}
        }
    }

    fn balls(&mut self) {
        if let Some(meeting) = balls(self.world, self.poses, self.body, self.other) {
            self.push(meeting, Feature::Surface(0));
        }
    }

    fn push(&mut self, meeting: Meeting, feature: Feature) {
        if meeting.0 <= self.reach {
            let name = ContactName { body: self.body, feature, other: self.other, other_feature: Feature::Surface(0) };
            self.out.push(contact(self.world, self.poses, name, meeting));
        }
    }
}

/// Gap, point and normal of a pair of features.
type Meeting = (f64, [f64; 3], [f64; 3]);

fn ball_on(pose: &[f64; 7], center: [f64; 3], radius: f64, point: [f64; 3], normal: [f64; 3]) -> Meeting {
    let center = placed(pose, center);
    (height(center, point, normal) - radius, std::array::from_fn(|i| center[i] - radius * normal[i]), normal)
}

fn corner_on(pose: &[f64; 7], half: [f64; 3], corner: u32, point: [f64; 3], normal: [f64; 3]) -> Meeting {
    let own = std::array::from_fn(|i| if corner >> i & 1 == 1 { half[i] } else { -half[i] });
    let at = placed(pose, own);
    (height(at, point, normal), at, normal)
}

fn balls(world: &World<Spatial>, poses: &[[f64; 7]], body: usize, other: usize) -> Option<Meeting> {
    let ball = |body: usize| match &world.bodies.get(body)?.shape {
        SpatialShape::Sphere { center, radius } => Some((placed(&poses[body], *center), *radius)),
        _ => None,
    };
    let ((a, radius), (b, other_radius)) = (ball(body)?, ball(other)?);
    let away: [f64; 3] = std::array::from_fn(|i| a[i] - b[i]);
    let distance = dot(away, away).sqrt();
    let normal = if distance > 0.0 { away.map(|x| x / distance) } else { [0.0, 0.0, 1.0] };
    let point = std::array::from_fn(|i| b[i] + other_radius * normal[i]);
    Some((distance - radius - other_radius, point, normal))
}

fn height(p: [f64; 3], point: [f64; 3], normal: [f64; 3]) -> f64 {
    dot(normal, [p[0] - point[0], p[1] - point[1], p[2] - point[2]])
}

fn contact(
    world: &World<Spatial>,
    poses: &[[f64; 7]],
    name: ContactName,
    (gap, point, n): Meeting,
) -> Contact<Spatial> {
    let [t, o] = tangents(n);
    let rows = |pose: &[f64; 7], sign: f64| -> <Spatial as crate::model::Space>::Rows {
        let r = [point[0] - pose[0], point[1] - pose[1], point[2] - pose[2]];
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

/// The pair of features that meets in `name`, at these poses.
fn meeting(world: &World<Spatial>, poses: &[[f64; 7]], name: ContactName) -> Option<Meeting> {
    let Some(obstacle) = name.other.checked_sub(world.bodies.len()) else {
        return balls(world, poses, name.body, name.other);
    };
    let SpatialShape::HalfSpace { point, normal } = world.fixed[obstacle].shape else {
        return None;
    };
    match (&world.bodies[name.body].shape, name.feature) {
        (SpatialShape::Sphere { center, radius }, _) => {
            Some(ball_on(&poses[name.body], *center, *radius, point, normal))
        }
        (SpatialShape::Box { half }, Feature::Vertex(corner)) => {
            Some(corner_on(&poses[name.body], *half, corner, point, normal))
        }
        _ => None,
    }
}

/// Tangents t and o with (t, o, n) right-handed: t = +x, o = +y for n = +z.
fn tangents(n: [f64; 3]) -> [[f64; 3]; 2] {
    let across = if n[1].abs() < 0.9 { [0.0, 1.0, 0.0] } else { [0.0, 0.0, -n[1].signum()] };
    let t = cross(across, n);
    let length = dot(t, t).sqrt();
    let t = t.map(|x| x / length);
    [t, cross(n, t)]
}

/// A point of the body in the world.
fn placed(pose: &[f64; 7], own: [f64; 3]) -> [f64; 3] {
    let turned = turned(pose, own);
    [pose[0] + turned[0], pose[1] + turned[1], pose[2] + turned[2]]
}

/// A direction of the body in the world: v + 2 e × (e × v + e0 v).
fn turned(pose: &[f64; 7], v: [f64; 3]) -> [f64; 3] {
    let (e0, e) = (pose[3], [pose[4], pose[5], pose[6]]);
    let inner = cross(e, v);
    let inner = [inner[0] + e0 * v[0], inner[1] + e0 * v[1], inner[2] + e0 * v[2]];
    let outer = cross(e, inner);
    [v[0] + 2.0 * outer[0], v[1] + 2.0 * outer[1], v[2] + 2.0 * outer[2]]
}

/// A vector of the world, its components along the body's axes times `factors`.
fn scaled_in_body(factors: [f64; 3], pose: &[f64; 7], v: [f64; 3]) -> [f64; 3] {
    if is_isotropic(factors) {
        return v.map(|x| x * factors[0]);
    }
    let own = turned(&conjugate(pose), v);
    turned(pose, [own[0] * factors[0], own[1] * factors[1], own[2] * factors[2]])
}

/// The same pose with the orientation turned back.
fn conjugate(pose: &[f64; 7]) -> [f64; 7] {
    [pose[0], pose[1], pose[2], pose[3], -pose[4], -pose[5], -pose[6]]
}

fn is_isotropic(moments: [f64; 3]) -> bool {
    moments[0] == moments[1] && moments[1] == moments[2]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
