//! Vectors in space, and orientations by Euler parameters.

pub(super) use crate::model::turned;

/// What stands upright at the origin.
pub(super) const UPRIGHT: [f64; 7] = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0];

/// A point of the body in the world.
pub(super) fn placed(pose: &[f64; 7], own: [f64; 3]) -> [f64; 3] {
    let turned = turned(pose, own);
    [pose[0] + turned[0], pose[1] + turned[1], pose[2] + turned[2]]
}

/// A point of the world in the body's frame.
pub(super) fn own(pose: &[f64; 7], point: [f64; 3]) -> [f64; 3] {
    turned(&conjugate(pose), sub(point, [pose[0], pose[1], pose[2]]))
}

/// The same pose with the orientation turned back.
pub(super) fn conjugate(pose: &[f64; 7]) -> [f64; 7] {
    [pose[0], pose[1], pose[2], pose[3], -pose[4], -pose[5], -pose[6]]
}

pub(super) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(super) fn sub(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub(super) fn scaled(factor: f64, v: [f64; 3]) -> [f64; 3] {
    v.map(|x| factor * x)
}

/// The point `by` away along `d`.
pub(super) fn along(point: [f64; 3], by: f64, d: [f64; 3]) -> [f64; 3] {
    [point[0] + by * d[0], point[1] + by * d[1], point[2] + by * d[2]]
}

pub(super) fn length(v: [f64; 3]) -> f64 {
    dot(v, v).sqrt()
}
