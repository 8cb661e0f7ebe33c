//! Curves to be drawn: heights of the corners and of the center of mass as the part turns, and for what pins need and where
//! they jam the middles of the edges, which will do for a picture.

use crate::answer::{Curve, CurveKind};

/// Turns at which the curves are computed.
const TURNS: u32 = 60;

/// The curves of a hull that turns from one of its edges on.
pub(super) fn curves(hull: &[[f64; 2]], com: [f64; 2], edge: usize, theta_1_deg: f64) -> Vec<Curve> {
    let n = hull.len();
    let all = (0..n).flat_map(|k| [CurveKind::Vertex(k), CurveKind::Rolling(k), CurveKind::Jamming(k)]);
    let points = |kind: CurveKind| {
        let turns = (0..=TURNS).map(|step| theta_1_deg * f64::from(step) / f64::from(TURNS));
        let heights = turns.map(|turn| Some([turn, height(hull, com, edge, turn, kind)?]));
        heights.skip_while(Option::is_none).map_while(|point| point).collect()
    };
    all.chain([CurveKind::Radius]).map(|kind| Curve { kind, points: points(kind) }).collect()
}

fn height(hull: &[[f64; 2]], com: [f64; 2], edge: usize, turn: f64, kind: CurveKind) -> Option<f64> {
    let n = hull.len();
    let (from, to) = (hull[edge], hull[(edge + 1) % n]);
    let (sin, cos) = (turn.to_radians() - (to[1] - from[1]).atan2(to[0] - from[0])).sin_cos();
    let turned = |[x, y]: [f64; 2]| [x * cos - y * sin, x * sin + y * cos];
    let corners: Vec<[f64; 2]> = hull.iter().map(|corner| turned(*corner)).collect();
    let pivot = corners.iter().copied().min_by(|a, b| a[1].total_cmp(&b[1]))?;
    let height = |corner: usize| corners[corner % n][1] - pivot[1];
    let faces = |edge: usize| height(edge + 1) > height(edge);
    let middle = |edge: usize| (height(edge) + height(edge + 1)) / 2.0;
    let rolls = turned(com)[0] > pivot[0];
    match kind {
        CurveKind::Radius => Some(turned(com)[1] - pivot[1]),
        CurveKind::Vertex(corner) => (faces(corner) || faces(corner + n - 1)).then(|| height(corner)),
        CurveKind::Rolling(edge) => (faces(edge) && rolls).then(|| middle(edge)),
        CurveKind::Jamming(edge) => (faces(edge) && !rolls).then(|| middle(edge)),
    }
}
