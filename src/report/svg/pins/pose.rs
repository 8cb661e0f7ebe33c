//! The hull on the belt, and with the numbers of its corners.

use super::super::canvas::{Align, At, Canvas, INK, MUTED, PART, Pen};
use super::super::finger::outward;
use super::super::label::Labels;
use super::super::scene::quartered;
use super::super::view::{Outline, direction};
use super::Setting;
use crate::exact::{Q, to_f64};
use crate::geometry::difference;

/// More corners than this are not numbered.
const MOST_NUMBERS: usize = 16;
const COM: f64 = 4.5;

/// The hull as it rests on one edge, in shares of the part's size; across from its middle, up from the belt.
pub(super) struct Pose {
    corners: Vec<[f64; 2]>,
    com: [f64; 2],
    /// From the middle to the sides.
    pub(super) half: f64,
}

impl Pose {
    pub(super) fn new(setting: &Setting, edge: usize) -> Self {
        let hull = &setting.answer.hull;
        let (from, to) = (&hull[edge], &hull[(edge + 1) % hull.len()]);
        let along = direction(&difference(to, from));
        let place = |point: &[Q; 2]| {
            let [x, y] = difference(point, from).map(|v| to_f64(&(v / &setting.heights.size)));
            // the page's y axis points down, that of the part up
            [x * along.x - y * along.y, x * along.y + y * along.x]
        };
        let corners: Vec<[f64; 2]> = hull.iter().map(place).collect();
        let com = place(&setting.ride.part.center_of_mass);
        let (left, right) =
            corners.iter().fold((f64::MAX, f64::MIN), |(left, right), [x, _]| (left.min(*x), right.max(*x)));
        let middle = (left + right) / 2.0;
        let centered = |[x, y]: [f64; 2]| [x - middle, y];
        let corners = corners.into_iter().map(centered).collect();
        Self { corners, com: centered(com), half: (right - left) / 2.0 }
    }

    /// Draws the part with the middle of its foot at `foot`, its larger side `pixels` long.
    pub(super) fn draw(&self, canvas: &mut Canvas, foot: At, pixels: f64) {
        let corners = self.on_page(foot, pixels);
        canvas.polygon(&corners, Pen::fill(PART, 1.0).outlined(INK, 1.3));
        quartered(canvas, self.com_on_page(foot, pixels), COM);
    }

    fn on_page(&self, foot: At, pixels: f64) -> Vec<At> {
        self.corners.iter().map(|[x, y]| At::new(foot.x + x * pixels, foot.y - y * pixels)).collect()
    }

    fn com_on_page(&self, foot: At, pixels: f64) -> At {
        At::new(foot.x + self.com[0] * pixels, foot.y - self.com[1] * pixels)
    }
}

/// Draws the part on its first stable edge with numbers at corners and edges, between two corners of the page.
pub(super) fn key(canvas: &mut Canvas, setting: &Setting, frame: [At; 2]) {
    let Some(first) = setting.shown.first() else { return };
    let pose = Pose::new(setting, first.edge);
    let tall = setting.heights.share(&first.height);
    let [low, high] = frame;
    let room = At::new(high.x - low.x - 44.0, high.y - low.y - 60.0);
    let pixels = (room.x / (2.0 * pose.half)).min(room.y / tall.max(1e-9));
    let foot = At::new((low.x + high.x) / 2.0, (low.y + high.y - 16.0 + tall * pixels) / 2.0);
    pose.draw(canvas, foot, pixels);

    let corners = pose.on_page(foot, pixels);
    let outline = Outline::Polygon(corners.clone());
    let mut labels = Labels::around(frame, outline);
    labels.avoid(&[pose.com_on_page(foot, pixels)]);
    let n = corners.len();
    let numbered = if n > MOST_NUMBERS { 1 } else { n };
    for corner in 0..numbered {
        let (here, next, before) = (corners[corner], corners[(corner + 1) % n], corners[(corner + n - 1) % n]);
        let (after, into) = (outward([here, next]), outward([before, here]));
        let toward = At::new(after.x + into.x, after.y + into.y).normalized();
        labels.want(here, toward, 9.0, INK, false, format!("V{corner}"));
        let middle = here.along(next.minus(here), 0.5);
        labels.want(middle, outward([here, next]), 8.0, MUTED, false, format!("e{corner}"));
    }
    labels.draw(canvas);
    let below = At::new(foot.x, foot.y + 34.0);
    canvas.text(below, Align::Middle, 11.0, MUTED, false, "corners V, edges e");
}
