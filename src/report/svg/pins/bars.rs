//! Intervals of heights as bars that can be seen: no thinner than a hairline, no more than there are pixels.

use super::axis::{Heights, Upright};
use crate::answer::{Orientation, PinAction};

/// Thinner bars are left out, if a part cannot be stuck there.
const THINNEST: f64 = 0.4;

/// Heights of one action on the page.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Bar {
    /// The upper end and the lower one.
    pub(super) y: [f64; 2],
    pub(super) action: Option<PinAction>,
}

/// The bars of an orientation from the belt up; those that jam come last, to lie over the others.
pub(super) fn bars(orientation: &Orientation, heights: &Heights, upright: &Upright) -> Vec<Bar> {
    let mut bars: Vec<Bar> = Vec::new();
    for interval in &orientation.intervals {
        let top = interval.to.as_ref().map_or(upright.top, |to| upright.y(heights.share(to)));
        let mut y = [top, upright.y(heights.share(&interval.from))];
        let jams = interval.action == Some(PinAction::Jam);
        if jams && y[1] - y[0] < 2.0 * THINNEST {
            let middle = (y[0] + y[1]) / 2.0;
            y = [middle - THINNEST, middle + THINNEST];
        } else if y[1] - y[0] < THINNEST {
            continue;
        }
        match bars.iter_mut().rev().take(2).find(|bar| bar.action == interval.action && bar.y[0] - y[1] < THINNEST) {
            Some(bar) => bar.y[0] = y[0].min(bar.y[0]),
            None => bars.push(Bar { y, action: interval.action }),
        }
    }
    bars.sort_by_key(|bar| bar.action == Some(PinAction::Jam));
    bars
}
