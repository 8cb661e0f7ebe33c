//! What the marks mean.

use super::canvas::{Align, At, Canvas, INK, MUTED, ORANGE, Pen, RED, SKY};
use super::{chart, pins, scene, throw};
use crate::answer::PinAction;

const ROW: f64 = 20.0;
const LEFT: f64 = 24.0;

/// A small picture of a mark.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Swatch {
    Fixel,
    Friction,
    FrictionRange,
    Band(&'static str),
    Push,
    Tilt,
    CenterOfMass,
    Line(Pen),
    Pin,
    PinAction(Option<PinAction>),
    Throw(throw::Mark),
    Chart(chart::Mark),
}

/// Marks in use, in the order of their first use.
#[derive(Default)]
pub(super) struct Legend {
    entries: Vec<(Swatch, String)>,
}

impl Legend {
    pub(super) fn add(&mut self, swatch: Swatch, meaning: &str) {
        if self.entries.iter().all(|(other, _)| *other != swatch) {
            self.entries.push((swatch, meaning.to_owned()));
        }
    }

    /// Adds what another legend explains.
    pub(super) fn extend(&mut self, other: Self) {
        other.entries.into_iter().for_each(|(swatch, meaning)| self.add(swatch, &meaning));
    }

    /// Draws from `top` down on a page of width `page` and returns where it ends.
    pub(super) fn draw(&self, canvas: &mut Canvas, page: f64, top: f64) -> f64 {
        let rule = Pen::stroke("#d5d9dd", 1.0);
        canvas.line(&[At::new(LEFT, top + 6.0), At::new(page - LEFT, top + 6.0)], rule);
        let mut at = At::new(LEFT, top + 24.0);
        for (swatch, meaning) in &self.entries {
            let width = 32.0 + 6.9 * meaning.chars().count() as f64 + 16.0;
            if at.x + width > page - LEFT + 18.0 && at.x > LEFT {
                at = At::new(LEFT, at.y + ROW);
            }
            sample(canvas, *swatch, At::new(at.x + 12.0, at.y));
            canvas.text(At::new(at.x + 31.0, at.y), Align::Left, 11.5, MUTED, false, meaning);
            at.x += width;
        }
        at.y + 20.0
    }
}

fn sample(canvas: &mut Canvas, swatch: Swatch, at: At) {
    let (left, right) = (At::new(at.x - 11.0, at.y), At::new(at.x + 11.0, at.y));
    match swatch {
        Swatch::Fixel => {
            let corners = [At::new(at.x, at.y - 7.5), At::new(at.x - 4.5, at.y + 6.0), At::new(at.x + 4.5, at.y + 6.0)];
            canvas.polygon(&corners, Pen::fill(INK, 1.0));
        }
        Swatch::Friction => canvas.arc(left, 21.0, -0.32, 0.64, true, Pen::fill(ORANGE, 0.6)),
        Swatch::FrictionRange => {
            canvas.arc(left, 21.0, -0.4, 0.8, true, Pen::fill(ORANGE, 0.25));
            canvas.arc(left, 21.0, -0.2, 0.4, true, Pen::fill(ORANGE, 0.6));
        }
        Swatch::Band(colour) => canvas.line(&[left, right], Pen::stroke(colour, 5.0)),
        Swatch::Push => canvas.arrow(left, right, RED, 2.6),
        Swatch::Tilt => canvas.arc(left, 21.0, -0.4, 0.8, true, Pen::fill(SKY, 0.35).outlined(SKY, 1.0)),
        Swatch::CenterOfMass => scene::quartered(canvas, at, scene::COM),
        Swatch::Line(pen) => canvas.line(&[left, right], pen),
        Swatch::Pin => pins::pin(canvas, at, [at.y - 8.0, at.y + 8.0]),
        Swatch::PinAction(action) => pins::sample(canvas, at, action),
        Swatch::Throw(mark) => throw::sample(canvas, at, mark),
        Swatch::Chart(mark) => chart::sample(canvas, at, mark),
    }
}
