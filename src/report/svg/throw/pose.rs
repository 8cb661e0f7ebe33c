//! The hull at rest on one of its edges.

use super::super::canvas::{At, Canvas, INK, PART, Pen};
use super::super::scene::quartered;
use super::super::view::direction;
use crate::exact::{Q, to_f64};
use crate::geometry::difference;

/// Radius of the symbol of the center of mass.
pub(super) const COM: f64 = 4.5;

/// The hull with one edge on the arm, in shares of its larger side.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Pose {
    /// Corners: from the center of mass along the arm, and over the arm.
    pub(super) corners: Vec<[f64; 2]>,
    /// Height of the center of mass over the arm.
    pub(super) com: f64,
}

impl Pose {
    /// `None` for an edge that the hull does not have.
    pub(super) fn new(hull: &[[Q; 2]], center_of_mass: &[Q; 2], size: &Q, edge: usize) -> Option<Self> {
        let (from, to) = (hull.get(edge)?, &hull[(edge + 1) % hull.len()]);
        // the page's y axis points down, that of the part up
        let along = direction(&difference(from, to));
        let place = |point: &[Q; 2]| {
            let [x, y] = difference(from, point).map(|v| to_f64(&(v / size)));
            [x * along.x - y * along.y, x * along.y + y * along.x]
        };
        let com = place(center_of_mass);
        let corners = hull.iter().map(place).map(|[x, y]| [x - com[0], y]).collect();
        Some(Self { corners, com: com[1] })
    }

    /// How far it reaches from the center of mass, to the left, which is negative, and to the right.
    pub(super) fn sides(&self) -> [f64; 2] {
        self.corners.iter().fold([0.0, 0.0], |[left, right], [x, _]| [x.min(left), x.max(right)])
    }

    pub(super) fn height(&self) -> f64 {
        self.corners.iter().map(|[_, y]| *y).fold(self.com, f64::max)
    }

    /// Draws it with the center of mass over `foot` on the arm, its larger side `pixels` long.
    pub(super) fn draw(&self, canvas: &mut Canvas, foot: At, pixels: f64, fill: Pen) {
        let corners: Vec<At> =
            self.corners.iter().map(|[x, y]| At::new(foot.x + x * pixels, foot.y - y * pixels)).collect();
        canvas.polygon(&corners, Pen::fill(PART, 1.0));
        canvas.polygon(&corners, fill.outlined(INK, 1.3));
        quartered(canvas, At::new(foot.x, foot.y - self.com * pixels), COM);
    }
}
