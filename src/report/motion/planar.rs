//! The plane.

use super::super::decimal::near;
use super::{Outline, Shown, View};
use crate::model::{Body, Planar, PlanarShape};
use serde_json::{Value, json};

impl Shown for Planar {
    const DIMENSION: usize = 2;
    const POSE: &'static [[&'static str; 2]] = &[["x", "m"], ["y", "m"], ["angle", "rad"]];
    const VELOCITY: &'static [[&'static str; 2]] = &[["vx", "m/s"], ["vy", "m/s"], ["omega", "rad/s"]];
    const VIEWS: &'static [View] = &[View { name: "", right: 0, up: 1 }];
    const HEADINGS: &'static [&'static str] = &["x m", "y m", "angle deg", "vx m/s", "vy m/s", "omega rad/s"];

    fn outlines(shape: &PlanarShape, pose: Option<&[f64; 3]>, view: View) -> Vec<Outline> {
        let [x, y, angle] = pose.copied().unwrap_or_default();
        let (sin, cos) = angle.sin_cos();
        let place = |[u, v]: [f64; 2]| view.of(&[x + u * cos - v * sin, y + u * sin + v * cos]);
        match shape {
            PlanarShape::Polygon(corners) => {
                vec![Outline::Polygon(corners.iter().map(|corner| place(*corner)).collect())]
            }
            PlanarShape::Circle { center, radius } => vec![Outline::Disc {
                center: place(*center),
                radius: *radius,
                mark: place([center[0] + radius, center[1]]),
            }],
            PlanarShape::HalfPlane { point, normal: [u, v] } => {
                vec![Outline::Half { point: place(*point), normal: [u * cos - v * sin, u * sin + v * cos] }]
            }
            PlanarShape::Compound(pieces) => {
                pieces.iter().flat_map(|piece| Self::outlines(piece, pose, view)).collect()
            }
        }
    }

    fn pieces(shape: &PlanarShape) -> Vec<Value> {
        match shape {
            PlanarShape::Polygon(corners) => vec![json!({ "polygon": corners })],
            PlanarShape::Circle { center: [x, y], radius } => vec![json!({ "disc": [x, y, radius] })],
            PlanarShape::HalfPlane { point: [x, y], normal: [u, v] } => vec![json!({ "half": [x, y, u, v] })],
            PlanarShape::Compound(pieces) => pieces.iter().flat_map(Self::pieces).collect(),
        }
    }

    fn turn(from: &[f64; 3], to: &[f64; 3]) -> f64 {
        (to[2] - from[2]).abs()
    }

    fn spin_energy(body: &Body<Self>, _pose: &[f64; 3], velocity: &[f64; 3]) -> f64 {
        body.inertia[0] * velocity[2] * velocity[2] / 2.0
    }

    fn orientation(pose: &[f64; 3]) -> String {
        format!("angle {} deg", rounded(pose[2].to_degrees()))
    }

    fn cells(pose: &[f64; 3], velocity: &[f64; 3]) -> Vec<String> {
        let [x, y, angle] = *pose;
        [x, y, angle.to_degrees()].into_iter().chain(*velocity).map(rounded).collect()
    }

    fn impulse(normal: &[f64; 2], parts: [f64; 3]) -> [f64; 2] {
        let ([x, y], [n, t, _]) = (*normal, parts);
        [n * x + t * y, n * y - t * x]
    }
}

/// Four digits; what is below a billionth is nothing.
pub fn rounded(value: f64) -> String {
    if value.is_finite() { near(if value.abs() < 1e-9 { 0.0 } else { value }, 4) } else { value.to_string() }
}
