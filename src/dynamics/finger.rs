//! A frictionless fingertip on a straight guide.

use super::collide::{dot, sub};
use crate::model::{Finger, PlanarShape};

/// Least cosine between guide and inward normal at which the tip still pushes: beyond, the guide would jam.
const LEAST_COSINE: f64 = 1e-3;

/// The wrench of the finger at the body's center of mass; `None` where the guide misses the body.
pub(super) fn push(shape: &PlanarShape, finger: &Finger, pose: &[f64; 3]) -> Option<[f64; 3]> {
    let (point, normal) = touch(shape, finger, pose)?;
    let force = finger.force / dot(normal, finger.direction);
    let arm = sub(point, [pose[0], pose[1]]);
    Some([force * normal[0], force * normal[1], force * (arm[0] * normal[1] - arm[1] * normal[0])])
}

/// Where the tip touches, with the unit normal into the body.
fn touch(shape: &PlanarShape, finger: &Finger, pose: &[f64; 3]) -> Option<([f64; 2], [f64; 2])> {
    let (sine, cosine) = libm::sincos(pose[2]);
    let place = |[x, y]: [f64; 2]| [pose[0] + cosine * x - sine * y, pose[1] + sine * x + cosine * y];
    let along = |distance: f64| [0, 1].map(|axis| finger.at[axis] + distance * finger.direction[axis]);
    match shape {
        PlanarShape::Polygon(vertices) => {
            let edge = finger.edge?;
            let [a, b] = [*vertices.get(edge)?, vertices[(edge + 1) % vertices.len()]].map(place);
            let side = sub(b, a);
            let length = dot(side, side).sqrt();
            let normal = [-side[1] / length, side[0] / length];
            let cosine = dot(normal, finger.direction);
            if cosine < LEAST_COSINE {
                return None;
            }
            let point = along(dot(normal, sub(a, finger.at)) / cosine);
            let share = dot(sub(point, a), side);
            (0.0..=length * length).contains(&share).then_some((point, normal))
        }
        PlanarShape::Circle { center, radius } => {
            let center = place(*center);
            let ahead = dot(sub(center, finger.at), finger.direction);
            let off = sub(center, along(ahead));
            let half_chord = (radius * radius - dot(off, off)).sqrt();
            let point = along(ahead - half_chord);
            let normal = sub(center, point).map(|entry| entry / radius);
            (dot(normal, finger.direction) >= LEAST_COSINE).then_some((point, normal))
        }
        PlanarShape::HalfPlane { .. } | PlanarShape::Compound(_) => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SQUARE: [[f64; 2]; 4] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];

    /// A guide upward at x = 0.5 meets the lower edge of a square: the whole force, with the arm 0.5.
    #[test]
    fn a_finger_square_to_an_edge_pushes_with_its_force() {
        let square = PlanarShape::Polygon(SQUARE.to_vec());
        let finger = Finger { edge: Some(0), at: [2.5, -9.0], direction: [0.0, 1.0], force: 3.0 };
        assert_eq!(push(&square, &finger, &[2.0, 7.0, 0.0]), Some([0.0, 3.0, 1.5]));
        assert_eq!(push(&square, &Finger { at: [3.5, 0.0], ..finger }, &[2.0, 7.0, 0.0]), None);
        assert_eq!(push(&square, &Finger { edge: Some(2), ..finger }, &[2.0, 7.0, 0.0]), None);
    }

    /// The component along the guide of what a slanted edge feels is the finger's force.
    #[test]
    fn the_guide_bears_what_a_slanted_edge_gives_sideways() {
        let square = PlanarShape::Polygon(SQUARE.to_vec());
        let finger = Finger { edge: Some(0), at: [0.25, -9.0], direction: [0.0, 1.0], force: 3.0 };
        let [x, y, torque] = push(&square, &finger, &[0.0, 0.0, 0.3]).unwrap();
        assert!((y - 3.0).abs() < 1e-12 && (x + 3.0 * 0.3_f64.tan()).abs() < 1e-12, "{x} {y}");
        // the line of force meets the guide at x = 0.25
        let height = (0.25 * 0.3_f64.sin() - 1.0) / 0.3_f64.cos();
        assert!((torque - (0.25 * y - height * x)).abs() < 1e-12, "{torque}");
    }

    #[test]
    fn a_disc_is_pushed_towards_its_center() {
        let disc = PlanarShape::Circle { center: [1.0, 0.0], radius: 2.0 };
        let finger = Finger { edge: None, at: [-9.0, 1.0], direction: [1.0, 0.0], force: 1.0 };
        let [x, y, torque] = push(&disc, &finger, &[0.0, 0.0, 0.0]).unwrap();
        assert!((x - 1.0).abs() < 1e-12 && (y + 1.0 / 3.0_f64.sqrt()).abs() < 1e-12, "{x} {y}");
        assert!((torque - y).abs() < 1e-12, "the force passes through (1, 0): {torque}");
        assert_eq!(push(&disc, &Finger { at: [-9.0, 2.5], ..finger }, &[0.0; 3]), None);
    }
}
