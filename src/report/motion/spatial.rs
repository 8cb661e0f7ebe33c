//! Space, from the side and from above.

use super::planar::rounded;
use super::{Outline, Shown, View};
use crate::model::{Body, Spatial, SpatialShape, tangents, turned as rotated};
use serde_json::{Value, json};

/// A half space is drawn where it is seen edge on.
const EDGE_ON: f64 = 0.999;

impl Shown for Spatial {
    const DIMENSION: usize = 3;
    const POSE: &'static [[&'static str; 2]] =
        &[["x", "m"], ["y", "m"], ["z", "m"], ["e0", "1"], ["ex", "1"], ["ey", "1"], ["ez", "1"]];
    const VELOCITY: &'static [[&'static str; 2]] = &[
        ["vx", "m/s"],
        ["vy", "m/s"],
        ["vz", "m/s"],
        ["omega_x", "rad/s"],
        ["omega_y", "rad/s"],
        ["omega_z", "rad/s"],
    ];
    const VIEWS: &'static [View] = &[
        View { name: "from the side: x to the right, z up", right: 0, up: 2 },
        View { name: "from above: x to the right, y up", right: 0, up: 1 },
    ];
    const HEADINGS: &'static [&'static str] =
        &["x m", "y m", "z m", "turned deg", "about", "vx m/s", "vy m/s", "vz m/s", "spin rad/s"];

    fn outlines(shape: &SpatialShape, pose: Option<&[f64; 7]>, view: View) -> Vec<Outline> {
        let pose = pose.copied().unwrap_or([0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]);
        let place = |point: [f64; 3]| {
            let turned = rotated(&pose, point);
            view.of(&[0, 1, 2].map(|axis| pose[axis] + turned[axis]))
        };
        match shape {
            SpatialShape::Sphere { center, radius } => vec![Outline::Disc {
                center: place(*center),
                radius: *radius,
                mark: place([center[0], center[1], center[2] + radius]),
            }],
            SpatialShape::Box { half } => {
                let sign = |corner: usize, axis: usize| if corner >> axis & 1 == 1 { half[axis] } else { -half[axis] };
                let corners = (0..8).map(|corner| place([0, 1, 2].map(|axis| sign(corner, axis)))).collect();
                vec![Outline::Polygon(hull(corners))]
            }
            SpatialShape::HalfSpace { point, normal } => {
                let seen = view.of(&rotated(&pose, *normal));
                let is_edge_on = seen[0].hypot(seen[1]) > EDGE_ON;
                is_edge_on.then(|| Outline::Half { point: place(*point), normal: seen }).into_iter().collect()
            }
        }
    }

    fn pieces(shape: &SpatialShape) -> Vec<Value> {
        vec![match shape {
            SpatialShape::Sphere { center: [x, y, z], radius } => json!({ "sphere": [x, y, z, radius] }),
            SpatialShape::Box { half } => json!({ "box": half }),
            SpatialShape::HalfSpace { point: [x, y, z], normal: [u, v, w] } => json!({ "half": [x, y, z, u, v, w] }),
        }]
    }

    fn turn(from: &[f64; 7], to: &[f64; 7]) -> f64 {
        let cosine: f64 = (3..7).map(|axis| from[axis] * to[axis]).sum();
        2.0 * cosine.abs().min(1.0).acos()
    }

    fn spin_energy(body: &Body<Self>, pose: &[f64; 7], velocity: &[f64; 6]) -> f64 {
        let [x, y, z] = [velocity[3], velocity[4], velocity[5]];
        let mut inverse = *pose;
        inverse[4..].iter_mut().for_each(|entry| *entry = -*entry);
        let omega = rotated(&inverse, [x, y, z]);
        body.inertia.iter().zip(omega).map(|(moment, omega)| moment * omega * omega / 2.0).sum()
    }

    fn orientation(pose: &[f64; 7]) -> String {
        let (angle, axis) = turned(pose);
        if angle == 0.0 {
            return "not turned".to_owned();
        }
        format!("turned by {} deg about {}", rounded(angle.to_degrees()), triple(axis))
    }

    fn cells(pose: &[f64; 7], velocity: &[f64; 6]) -> Vec<String> {
        let (angle, axis) = turned(pose);
        let about = if angle == 0.0 { "-".to_owned() } else { triple(axis) };
        let places = pose[..3].iter().map(|entry| rounded(*entry));
        let spin = velocity[3..].iter().map(|entry| entry * entry).sum::<f64>().sqrt();
        let speeds = velocity[..3].iter().copied().chain([spin]).map(rounded);
        places.chain([rounded(angle.to_degrees()), about]).chain(speeds).collect()
    }

    fn impulse(normal: &[f64; 3], parts: [f64; 3]) -> [f64; 3] {
        let [t, o] = tangents(*normal);
        [0, 1, 2].map(|axis| parts[0] * normal[axis] + parts[1] * t[axis] + parts[2] * o[axis])
    }
}

/// Angle (rad) from the upright orientation, from 0 to π, and axis.
fn turned(pose: &[f64; 7]) -> (f64, [f64; 3]) {
    let sign = if pose[3] < 0.0 { -1.0 } else { 1.0 };
    let axis = [4, 5, 6].map(|entry| sign * pose[entry]);
    let sine = axis.iter().map(|entry| entry * entry).sum::<f64>().sqrt();
    if sine < 1e-12 {
        return (0.0, [0.0; 3]);
    }
    (2.0 * sine.atan2(sign * pose[3]), axis.map(|entry| entry / sine))
}

fn triple(values: [f64; 3]) -> String {
    format!("({})", values.map(|value| super::super::decimal::near((value * 1e3).round() / 1e3, 3)).join(", "))
}

/// The convex hull, counter-clockwise.
fn hull(mut points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    points.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    let mut around: Vec<[f64; 2]> = Vec::new();
    for is_lower in [true, false] {
        let start = around.len();
        let ordered: Vec<[f64; 2]> = if is_lower { points.clone() } else { points.iter().rev().copied().collect() };
        for point in ordered {
            while let [.., a, b] = around[start..]
                && (b[0] - a[0]) * (point[1] - a[1]) - (b[1] - a[1]) * (point[0] - a[0]) <= 0.0
            {
                around.pop();
            }
            around.push(point);
        }
        around.pop();
    }
    around
}
