//! Labels beside what they name, clear of the part and of each other.

use super::canvas::{Align, At, Canvas};
use super::view::{HEADER, View, WIDTH};

/// One word beside a point.
struct Label {
    anchor: At,
    /// Where the label would rather be, seen from its anchor.
    toward: At,
    /// Least distance from the anchor to the middle of the text.
    distance: f64,
    size: f64,
    colour: &'static str,
    bold: bool,
    text: String,
}

/// Labels to place and marks to keep clear of.
pub(super) struct Labels {
    obstacles: Vec<At>,
    wanted: Vec<Label>,
}

impl Labels {
    pub(super) fn new(view: &View) -> Self {
        Self { obstacles: view.samples(), wanted: Vec::new() }
    }

    /// Keeps labels off these points.
    pub(super) fn avoid(&mut self, points: &[At]) {
        self.obstacles.extend_from_slice(points);
    }

    /// Asks for a label near `anchor`, best `distance` away `toward` a direction.
    pub(super) fn want(
        &mut self,
        anchor: At,
        toward: At,
        distance: f64,
        colour: &'static str,
        bold: bool,
        text: String,
    ) {
        self.wanted.push(Label { anchor, toward, distance, size: if bold { 12.5 } else { 11.0 }, colour, bold, text });
    }

    pub(super) fn draw(&self, canvas: &mut Canvas, view: &View) {
        let mut taken: Vec<(At, At)> = Vec::new();
        for label in &self.wanted {
            let half = At::new(0.29 * label.size * label.text.chars().count() as f64 + 1.0, 0.5 * label.size + 1.0);
            let candidates = (0..4).flat_map(|ring| (0..24).map(move |turn| (ring, turn)));
            let best = candidates
                .map(|(ring, turn)| {
                    let angle = f64::from(turn) * std::f64::consts::PI / 12.0;
                    let toward = turned_by(label.toward, angle);
                    let at =
                        label.anchor.along(toward, label.distance + 6.0 * f64::from(ring) + half.x * toward.x.abs());
                    let away = 1.0 - angle.cos();
                    (self.cost(view, at, half, &taken) + 14.0 * away + 5.0 * f64::from(ring), at)
                })
                .min_by(|a, b| a.0.total_cmp(&b.0))
                .map_or(label.anchor, |(_, at)| at);
            canvas.text(best, Align::Middle, label.size, label.colour, label.bold, &label.text);
            taken.push((best, half));
        }
    }

    fn cost(&self, view: &View, at: At, half: At, taken: &[(At, At)]) -> f64 {
        let near = |point: &At| (point.x - at.x).abs() < half.x + 2.0 && (point.y - at.y).abs() < half.y + 2.0;
        let struck = self.obstacles.iter().filter(|point| near(point)).count() as f64;
        let overlaps = taken
            .iter()
            .filter(|(other, size)| {
                (other.x - at.x).abs() < half.x + size.x && (other.y - at.y).abs() < half.y + size.y
            })
            .count() as f64;
        let outside =
            at.x - half.x < 4.0 || at.x + half.x > WIDTH - 4.0 || at.y - half.y < HEADER || at.y + half.y > view.bottom;
        10.0 * struck + 200.0 * overlaps + if view.covers(at) { 60.0 } else { 0.0 } + if outside { 200.0 } else { 0.0 }
    }
}

fn turned_by(vector: At, angle: f64) -> At {
    let (sin, cos) = angle.sin_cos();
    At::new(vector.x * cos - vector.y * sin, vector.x * sin + vector.y * cos)
}
