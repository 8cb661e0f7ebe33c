//! Polygons within a rectangle of the page, and their hatching.

use super::super::canvas::At;

/// Between two lines of a hatching, in pixels.
const PITCH: f64 = 9.0;

/// What of a polygon lies in the rectangle from `low` to `high`.
pub(in crate::report) fn within(polygon: &[At], low: At, high: At) -> Vec<At> {
    let sides =
        [(At::new(1.0, 0.0), low), (At::new(-1.0, 0.0), high), (At::new(0.0, 1.0), low), (At::new(0.0, -1.0), high)];
    sides.iter().fold(polygon.to_vec(), |polygon, (inward, on)| beyond(&polygon, *on, *inward))
}

/// What of a polygon lies on the side of the line through `on` to which `inward` points.
pub(super) fn beyond(polygon: &[At], on: At, inward: At) -> Vec<At> {
    let height = |at: At| (at.x - on.x) * inward.x + (at.y - on.y) * inward.y;
    let mut kept = Vec::with_capacity(polygon.len() + 2);
    let next = polygon.iter().cycle().skip(1);
    for (from, to) in polygon.iter().zip(next) {
        let (a, b) = (height(*from), height(*to));
        if a >= 0.0 {
            kept.push(*from);
        }
        if (a >= 0.0) != (b >= 0.0) {
            kept.push(from.along(to.minus(*from), a / (a - b)));
        }
    }
    kept
}

/// Lines at 45 degrees across a polygon.
pub(in super::super) fn hatching(polygon: &[At]) -> Vec<Vec<At>> {
    // lines of constant x + y, each cut where it enters and leaves
    let level = |at: &At| at.x + at.y;
    let (least, most) = polygon.iter().map(level).fold((f64::MAX, f64::MIN), |(l, m), v| (l.min(v), m.max(v)));
    let pitch = PITCH * std::f64::consts::SQRT_2;
    let mut lines = Vec::new();
    let mut at = (least / pitch).floor() * pitch + pitch;
    while at < most {
        let next = polygon.iter().cycle().skip(1);
        let mut cuts: Vec<At> = polygon
            .iter()
            .zip(next)
            .filter(|(from, to)| (level(from) < at) != (level(to) < at))
            .map(|(from, to)| from.along(to.minus(*from), (at - level(from)) / (level(to) - level(from))))
            .collect();
        cuts.sort_by(|a, b| a.x.total_cmp(&b.x));
        lines.extend(cuts.chunks_exact(2).map(<[At]>::to_vec));
        at += pitch;
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_square_that_sticks_out_is_cut_at_the_frame() {
        let square = [At::new(-5.0, 2.0), At::new(5.0, 2.0), At::new(5.0, 8.0), At::new(-5.0, 8.0)];
        let cut = within(&square, At::new(0.0, 0.0), At::new(10.0, 5.0));
        let (xs, ys): (Vec<f64>, Vec<f64>) = cut.iter().map(|at| (at.x, at.y)).unzip();
        let ends = |values: &[f64]| {
            (values.iter().copied().fold(f64::MAX, f64::min), values.iter().copied().fold(f64::MIN, f64::max))
        };
        assert_eq!((cut.len(), ends(&xs), ends(&ys)), (4, (0.0, 5.0), (2.0, 5.0)));
        assert!(within(&square, At::new(20.0, 0.0), At::new(30.0, 5.0)).is_empty());
    }

    #[test]
    fn a_hatching_stays_inside() {
        let triangle = [At::new(0.0, 0.0), At::new(60.0, 0.0), At::new(0.0, 60.0)];
        let lines = hatching(&triangle);
        assert!(lines.len() >= 3);
        let is_inside = |at: &At| at.x >= -1e-9 && at.y >= -1e-9 && at.x + at.y <= 60.0 + 1e-9;
        assert!(lines.iter().flatten().all(is_inside));
    }
}
