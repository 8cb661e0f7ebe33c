//! The curves of the toppling graph by doubles, from force balance at many heights.

use crate::answer::{Curve, CurveKind};

/// Turns at which the curves are computed.
const TURNS: usize = 90;
/// Heights tried on each edge.
const HEIGHTS: usize = 300;

/// A part that turns from one edge on.
pub(super) struct Turned {
    pub(super) hull: Vec<[f64; 2]>,
    pub(super) com: [f64; 2],
    pub(super) edge: usize,
    /// Belt and pin.
    pub(super) friction: [f64; 2],
}

impl Turned {
    pub(super) fn curves(&self, theta_1_deg: f64) -> Vec<Curve> {
        let mut curves: Vec<Curve> = Vec::new();
        for step in 0..=TURNS {
            let turn = theta_1_deg * step as f64 / TURNS as f64;
            for (kind, height) in self.heights(turn) {
                let before = theta_1_deg * (step as f64 - 1.5) / TURNS as f64;
                let goes_on =
                    |curve: &&mut Curve| curve.kind == kind && curve.points[curve.points.len() - 1][0] > before;
                match curves.iter_mut().find(goes_on) {
                    Some(curve) => curve.points.push([turn, height]),
                    None => curves.push(Curve { kind, points: vec![[turn, height]] }),
                }
            }
        }
        curves
    }

    fn heights(&self, turn: f64) -> Vec<(CurveKind, f64)> {
        let n = self.hull.len();
        let (from, to) = (self.hull[self.edge], self.hull[(self.edge + 1) % n]);
        let angle = turn.to_radians() - (to[1] - from[1]).atan2(to[0] - from[0]);
        let (sin, cos) = angle.sin_cos();
        let turned = |[x, y]: [f64; 2]| [x * cos - y * sin, x * sin + y * cos];
        let corners: Vec<[f64; 2]> = self.hull.iter().map(|corner| turned(*corner)).collect();
        let pivot = corners.iter().copied().min_by(|a, b| a[1].total_cmp(&b[1])).expect("corners");
        let placed = |[x, y]: [f64; 2]| [x - pivot[0], y - pivot[1]];
        let corners: Vec<[f64; 2]> = corners.into_iter().map(placed).collect();
        let com = placed(turned(self.com));
        let faces = |edge: usize| corners[(edge + 1) % n][1] > corners[edge][1] + 1e-9;

        let mut heights = vec![(CurveKind::Radius, com[1])];
        for corner in 0..n {
            if faces(corner) || faces((corner + n - 1) % n) {
                heights.push((CurveKind::Vertex(corner), corners[corner][1]));
            }
        }
        for edge in (0..n).filter(|edge| faces(*edge)) {
            let ends = [corners[edge], corners[(edge + 1) % n]];
            let kind = if com[0] > 0.0 { CurveKind::Rolling(edge) } else { CurveKind::Jamming(edge) };
            let height = |k: usize| ends[0][1] + (ends[1][1] - ends[0][1]) * k as f64 / HEIGHTS as f64;
            let highest = (0..=HEIGHTS).rev().map(height).find(|height| self.is_bad(ends, com[0], *height));
            heights.extend(highest.map(|height| (kind, height)));
        }
        heights
    }

    /// Whether a pin at `height` on an edge that faces it stops the part: moments about the corners of the triangle that
    /// belt friction spans under the center of mass.
    fn is_bad(&self, [from, to]: [[f64; 2]; 2], com: f64, height: f64) -> bool {
        let [belt, pin] = self.friction;
        let [x, y] = [to[0] - from[0], to[1] - from[1]];
        let length = x.hypot(y);
        let (u, n) = ([x / length, y / length], [-y / length, x / length]);
        let at = from[0] + (height - from[1]) / u[1] * u[0];
        let is_right = at >= 0.0;
        let slip = if is_right { -pin } else { pin };
        let d = [n[0] + slip * u[0], n[1] + slip * u[1]];
        let about_pivot = at * d[1] - height * d[0];
        let about_upper = belt * about_pivot - com * (belt * d[1] - d[0]);
        if com > 0.0 {
            about_upper <= 0.0 || about_pivot <= 0.0
        } else {
            is_right && about_upper <= 0.0 && about_pivot <= 0.0
        }
    }
}
