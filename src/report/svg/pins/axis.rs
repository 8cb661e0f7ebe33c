//! Heights above the belt, from the part's unit to the page.

use super::super::canvas::{Align, At, Canvas, INK, MUTED, Pen};
use super::super::scene::round_number;
use crate::answer::{Orientation, Pins};
use crate::exact::{Algebraic, Q, ratio, to_f64};
use crate::model::LengthUnit;
use crate::report::decimal;
use num_traits::{One as _, Signed as _};

/// Room above the highest, as a share of it.
const ABOVE: f64 = 0.07;

/// The scale of heights: shares of the larger side of the part.
pub(super) struct Heights {
    pub(super) size: Q,
    /// The height of the tallest orientation.
    pub(super) tallest: f64,
    pub(super) unit: &'static str,
}

impl Heights {
    pub(super) fn of(answer: &Pins, unit: LengthUnit) -> Self {
        let side = |axis: usize| {
            let along = || answer.hull.iter().map(move |corner| &corner[axis]);
            along().max().zip(along().min()).map(|(high, low)| high - low)
        };
        let size = side(0).max(side(1)).filter(Q::is_positive).unwrap_or_else(Q::one);
        let mut heights = Self { size, tallest: 1e-9, unit: unit.symbol() };
        let tops = answer.orientations.iter().map(|orientation: &Orientation| heights.share(&orientation.height));
        heights.tallest = tops.fold(heights.tallest, f64::max);
        heights
    }

    /// Divides before it rounds: units may be of any size.
    pub(super) fn share(&self, height: &Algebraic) -> f64 {
        let [low, _] = height.enclosure(&(&self.size * ratio(1, 1 << 20)));
        self.share_of(&low)
    }

    pub(super) fn share_of(&self, height: &Q) -> f64 {
        to_f64(&(height / &self.size))
    }

    /// A rounded height as a share; `None` where doubles cannot say.
    pub(super) fn share_near(&self, height: f64) -> Option<f64> {
        Some(height / to_f64(&self.size)).filter(|share| share.is_finite())
    }
}

/// An upright axis of heights, the belt at `belt`.
#[derive(Clone, Copy)]
pub(super) struct Upright {
    pub(super) belt: f64,
    pub(super) top: f64,
    /// Pixels of the part's larger side.
    pixels: f64,
}

impl Upright {
    /// An axis with room for heights up to `highest`, a share.
    pub(super) fn new(top: f64, belt: f64, highest: f64) -> Self {
        Self { belt, top, pixels: (belt - top) / (highest * (1.0 + ABOVE)) }
    }

    pub(super) fn y(&self, share: f64) -> f64 {
        (self.belt - share * self.pixels).max(self.top)
    }

    /// Draws it at `x`, with a rule of the page from each height that is named to `right`.
    pub(super) fn draw(&self, canvas: &mut Canvas, heights: &Heights, x: f64, right: f64) {
        let per_share = to_f64(&heights.size);
        let tallest = (self.belt - self.top) / self.pixels;
        let mut marks = vec![vec![At::new(x, self.top), At::new(x, self.belt)]];
        for value in ticks(tallest * per_share, tallest * per_share / 4.0) {
            let y = self.y(value / per_share);
            canvas.line(&[At::new(x, y), At::new(right, y)], Pen::stroke("#e4e7ea", 0.8));
            marks.push(vec![At::new(x - 4.0, y), At::new(x, y)]);
            canvas.text(At::new(x - 7.0, y), Align::Right, 11.0, MUTED, false, &decimal::near(value, 6));
        }
        canvas.lines(&marks, Pen::stroke(INK, 1.0));
        let title = format!("height above the belt, {}", heights.unit);
        canvas.text(At::new(x - 20.0, self.top - 12.0), Align::Left, 11.0, MUTED, false, &title);
    }
}

/// Round values from zero to `end`, their steps at most `step`; none where doubles cannot tell.
pub(super) fn ticks(end: f64, step: f64) -> Vec<f64> {
    let step = round_number(step);
    (0..100).map(|k| f64::from(k) * step).take_while(|value| step > 0.0 && *value <= end).collect()
}
