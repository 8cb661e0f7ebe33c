//! Mechanics in space: six velocities a body.

use super::contact::Contact;
use super::mechanics::{Contacts, Mechanics};
use super::spatial_pairs;
use super::turning::{conjugate, cross, dot, turned};
use crate::model::{Body, Finger, Spatial, SpatialShape, World};

impl Mechanics for Spatial {
    type Outlines = ();

    const TANGENTS: usize = 2;

    fn outlines(_: &World<Self>) {}

    fn contacts((): &mut (), world: &World<Self>, poses: &[[f64; 7]], reach: f64, out: &mut Contacts<Self>) {
        spatial_pairs::find(world, poses, reach, out);
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

    fn push(_: &Body<Self>, _: &Finger, _: &[f64; 7]) -> Option<[f64; 6]> {
        None
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

    fn follow(
        (): &(),
        world: &World<Self>,
        found: &Contact<Self>,
        from: &[[f64; 7]],
        to: &[[f64; 7]],
    ) -> Contact<Self> {
        spatial_pairs::follow(world, found, from, to)
    }

    fn swing(point: &[f64; 3], pose: &[f64; 7], wrench: &[f64; 6], velocity: &[f64; 6]) -> [f64; 6] {
        let r = [point[0] - pose[0], point[1] - pose[1], point[2] - pose[2]];
        let ([fx, fy, fz, ..], [_, _, _, wx, wy, wz]) = (*wrench, *velocity);
        // ω · (φ × r) × f = (ω · r) (f · φ) - (r · f) (ω · φ)
        let (across, along) = (dot([wx, wy, wz], r), dot(r, [fx, fy, fz]));
        [0.0, 0.0, 0.0, across * fx - along * wx, across * fy - along * wy, across * fz - along * wz]
    }

    fn is_fixed_only(shape: &SpatialShape) -> bool {
        matches!(shape, SpatialShape::HalfSpace { .. })
    }

    fn half_thickness(shape: &SpatialShape) -> f64 {
        match shape {
            SpatialShape::Sphere { radius, .. } => *radius,
            SpatialShape::Box { half: [x, y, z] } => x.min(*y).min(*z),
            SpatialShape::HalfSpace { .. } => f64::INFINITY,
        }
    }
}

/// A vector of the world, its components along the body's axes times `factors`.
fn scaled_in_body(factors: [f64; 3], pose: &[f64; 7], v: [f64; 3]) -> [f64; 3] {
    if is_isotropic(factors) {
        return v.map(|x| x * factors[0]);
    }
    let own = turned(&conjugate(pose), v);
    turned(pose, [own[0] * factors[0], own[1] * factors[1], own[2] * factors[2]])
}

fn is_isotropic(moments: [f64; 3]) -> bool {
    moments[0] == moments[1] && moments[1] == moments[2]
}
