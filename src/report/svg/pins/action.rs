//! How actions look: black, heavy, light and white as in Fig. 9 of the paper, so that a print without colours will do.

use super::super::canvas::{At, Canvas, INK, Pen};
use super::super::legend::Swatch;
use crate::answer::PinAction;

/// A rectangle of the page: its upper left and lower right corner.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in super::super) struct Rect {
    pub(in super::super) low: At,
    pub(in super::super) high: At,
}

impl Rect {
    pub(super) fn new(x: [f64; 2], y: [f64; 2]) -> Self {
        Self { low: At::new(x[0], y[0]), high: At::new(x[1], y[1]) }
    }

    pub(super) fn corners(self) -> [At; 4] {
        let Self { low, high } = self;
        [low, At::new(high.x, low.y), high, At::new(low.x, high.y)]
    }

    /// Parallel lines that rise to the right, `step` apart along the lower side.
    fn hatching(self, step: f64) -> Vec<Vec<At>> {
        let Self { low, high } = self;
        let tall = high.y - low.y;
        let count = ((high.x - low.x + tall) / step).floor() as usize;
        (1..=count)
            .map(|k| {
                // the line through (foot, lower side), rising by 45 degrees
                let foot = low.x - tall + step * k as f64;
                let (from, to) = (foot.max(low.x), (foot + tall).min(high.x));
                vec![At::new(from, high.y - (from - foot)), At::new(to, high.y - (to - foot))]
            })
            .collect()
    }
}

/// All actions, in the order of the legend.
pub(super) const ALL: [Option<PinAction>; 6] = [
    Some(PinAction::Jam),
    Some(PinAction::Repeat),
    Some(PinAction::Pass),
    Some(PinAction::FallBack),
    Some(PinAction::PassUnder),
    None,
];

/// The fill of an action.
pub(super) fn colour(action: Option<PinAction>) -> &'static str {
    match action {
        Some(PinAction::Jam) => INK,
        Some(PinAction::Repeat) => "#a3bace",
        Some(PinAction::Pass) => "#e1ebf3",
        Some(PinAction::PassUnder | PinAction::FallBack) | None => "#ffffff",
    }
}

/// Ink on the fill of an action.
pub(super) fn ink(action: Option<PinAction>) -> &'static str {
    if action == Some(PinAction::Jam) { "#ffffff" } else { INK }
}

/// The legend's mark of an action: one for both that leave the part as it is.
pub(super) fn swatch(action: Option<PinAction>) -> Swatch {
    Swatch::PinAction(if action == Some(PinAction::FallBack) { Some(PinAction::PassUnder) } else { action })
}

/// What an action means.
pub(super) fn meaning(action: Option<PinAction>) -> &'static str {
    match action {
        Some(PinAction::Jam) => "jam: the part is stuck",
        Some(PinAction::Repeat) => "repeat: it topples and meets the pin again",
        Some(PinAction::Pass) => "pass: it topples and leaves the pin behind",
        Some(PinAction::PassUnder | PinAction::FallBack) => "pass-under, fall-back: it stays as it is",
        None => "uncertain: differs within the ranges of the case",
    }
}

/// Fills a rectangle as `action` looks.
pub(super) fn fill(canvas: &mut Canvas, rect: Rect, action: Option<PinAction>) {
    canvas.polygon(&rect.corners(), Pen::fill(colour(action), 1.0));
    if action.is_none() {
        canvas.lines(&rect.hatching(7.0), Pen::stroke(INK, 0.7));
    }
}

/// A small picture of an action for the legend.
pub(in super::super) fn sample(canvas: &mut Canvas, at: At, action: Option<PinAction>) {
    let rect = Rect::new([at.x - 11.0, at.x + 11.0], [at.y - 6.0, at.y + 6.0]);
    fill(canvas, rect, action);
    canvas.polygon(&rect.corners(), Pen::stroke(INK, 0.8));
}
