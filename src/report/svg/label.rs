//! Labels beside what they name, clear of the part and of each other.

use super::canvas::{Align, At, Canvas};
use super::view::{HEADER, Outline, View, WIDTH};

/// Cost of a label over another one or beyond the frame.
const NO_ROOM: f64 = 200.0;

/// One word beside a point.
struct Label {
    /// Points any of which the label may name.
    anchors: Vec<At>,
    /// Where the label would rather be, seen from its anchor.
    toward: At,
    /// Least distance from the anchor to the middle of the text.
    distance: f64,
    size: f64,
    colour: &'static str,
    bold: bool,
    text: String,
    /// Whether it is left out rather than put over another label.
    optional: bool,
}

/// Labels to place and marks to keep clear of.
pub(super) struct Labels {
    /// What labels must not leave: the upper left and the lower right corner.
    frame: [At; 2],
    part: Option<Outline>,
    obstacles: Vec<At>,
    wanted: Vec<Label>,
    /// Whether texts have a light rim.
    rimmed: bool,
}

impl Labels {
    pub(super) fn new(view: &View) -> Self {
        Self::around([At::new(4.0, HEADER), At::new(WIDTH - 4.0, view.bottom)], view.outline.clone())
    }

    /// Labels of a part in a frame.
    pub(super) fn around(frame: [At; 2], part: Outline) -> Self {
        Self { frame, obstacles: part.samples(), part: Some(part), wanted: Vec::new(), rimmed: false }
    }

    /// Labels in an empty frame.
    pub(super) fn within(frame: [At; 2]) -> Self {
        Self { frame, part: None, obstacles: Vec::new(), wanted: Vec::new(), rimmed: false }
    }

    /// Gives the texts a light rim, for labels that lie over lines.
    pub(super) fn rimmed(self) -> Self {
        Self { rimmed: true, ..self }
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
        let size = if bold { 12.5 } else { 11.0 };
        let anchors = vec![anchor];
        self.wanted.push(Label { anchors, toward, distance, size, colour, bold, text, optional: false });
    }

    /// Asks for a label above or below any point of a curve, to be left out where there is no room.
    pub(super) fn offer(&mut self, anchors: Vec<At>, colour: &'static str, text: String) {
        let (toward, distance, size) = (At::new(0.0, -1.0), 9.0, 11.0);
        self.wanted.push(Label { anchors, toward, distance, size, colour, bold: false, text, optional: true });
    }

    /// Asks for a label as [`Labels::want`], to be left out where there is no room.
    pub(super) fn offer_near(&mut self, anchor: At, toward: At, distance: f64, colour: &'static str, text: String) {
        self.want(anchor, toward, distance, colour, false, text);
        if let Some(label) = self.wanted.last_mut() {
            label.optional = true;
        }
    }

    pub(super) fn draw(&self, canvas: &mut Canvas) {
        let mut taken: Vec<(At, At)> = Vec::new();
        for label in &self.wanted {
            let half = At::new(0.29 * label.size * label.text.chars().count() as f64 + 1.0, 0.5 * label.size + 1.0);
            let turns = (0..4).flat_map(|ring| (0..24).map(move |turn| (ring, turn)));
            let reach = label.distance + 20.0 + half.x + half.x.max(half.y);
            let near = |anchor: At| {
                let near = |at: &&At| (at.x - anchor.x).abs() <= reach && (at.y - anchor.y).abs() <= reach;
                self.obstacles.iter().filter(near).copied().collect::<Vec<_>>()
            };
            let anchors: Vec<(At, Vec<At>)> = label.anchors.iter().map(|anchor| (*anchor, near(*anchor))).collect();
            let candidates = anchors.iter().flat_map(|anchor| turns.clone().map(move |turn| (anchor, turn)));
            let best = candidates
                .map(|((anchor, obstacles), (ring, turn))| {
                    let angle = f64::from(turn) * std::f64::consts::PI / 12.0;
                    let toward = turned_by(label.toward, angle);
                    let at = anchor.along(toward, label.distance + 6.0 * f64::from(ring) + half.x * toward.x.abs());
                    let away = 1.0 - angle.cos();
                    (self.cost(at, half, obstacles, &taken) + 14.0 * away + 5.0 * f64::from(ring), at)
                })
                .min_by(|a, b| a.0.total_cmp(&b.0));
            let Some((_, at)) = best.filter(|(cost, _)| !label.optional || *cost < NO_ROOM) else { continue };
            if self.rimmed {
                canvas.rimmed_text(at, Align::Middle, label.size, label.colour, label.bold, &label.text);
            } else {
                canvas.text(at, Align::Middle, label.size, label.colour, label.bold, &label.text);
            }
            taken.push((at, half));
        }
    }

    fn cost(&self, at: At, half: At, obstacles: &[At], taken: &[(At, At)]) -> f64 {
        let near = |point: &At| (point.x - at.x).abs() < half.x + 2.0 && (point.y - at.y).abs() < half.y + 2.0;
        let struck = obstacles.iter().filter(|point| near(point)).count() as f64;
        let overlaps = taken
            .iter()
            .filter(|(other, size)| {
                (other.x - at.x).abs() < half.x + size.x && (other.y - at.y).abs() < half.y + size.y
            })
            .count() as f64;
        let [low, high] = self.frame;
        let outside =
            at.x - half.x < low.x || at.x + half.x > high.x || at.y - half.y < low.y || at.y + half.y > high.y;
        let covered = self.part.as_ref().is_some_and(|part| part.covers(at));
        10.0 * struck + NO_ROOM * overlaps + if covered { 60.0 } else { 0.0 } + if outside { NO_ROOM } else { 0.0 }
    }
}

fn turned_by(vector: At, angle: f64) -> At {
    let (sin, cos) = angle.sin_cos();
    At::new(vector.x * cos - vector.y * sin, vector.x * sin + vector.y * cos)
}
