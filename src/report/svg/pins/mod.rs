//! Pins over a conveyor: the sequence, the toppling graph, the pin action diagram.

mod action;
mod axis;
mod bars;
mod diagram;
mod graph;
mod planned;
mod pose;
mod sequence;

pub(super) use action::sample;
pub(super) use sequence::pin;

use super::canvas::{Align, At, Canvas, INK, MUTED};
use super::legend::Legend;
use super::scene::{shortened, wrapped};
use crate::answer::{Orientation, Pins};
use crate::report::{Ride, phrase};
use axis::Heights;
use std::iter;

/// Width of the drawing, in pixels: a row of curves and a row of bars need more of it than one part.
const PAGE: f64 = 1200.0;
/// Left and right of everything.
const SIDE: f64 = 24.0;
/// So many orientations are drawn.
const MOST: usize = 12;
/// Between two pictures.
const GAP: f64 = 22.0;

/// What the pictures show.
struct Setting<'a> {
    ride: &'a Ride<'a>,
    answer: &'a Pins,
    /// The orientations that are drawn, each followed by the one onto which it topples.
    shown: Vec<&'a Orientation>,
    heights: Heights,
}

/// One of the pictures, as high as `bottom`.
struct Picture {
    canvas: Canvas,
    legend: Legend,
    bottom: f64,
}

impl Picture {
    /// A picture with its heading, and what is to be said about it.
    fn new(heading: &str, remark: &str) -> Self {
        let mut canvas = Canvas::new();
        canvas.text(At::new(SIDE, 10.0), Align::Left, 14.0, INK, true, heading);
        let right_of_heading = SIDE + 24.0 + 7.6 * heading.chars().count() as f64;
        canvas.text(At::new(right_of_heading, 10.0), Align::Left, 12.0, MUTED, false, remark);
        Self { canvas, legend: Legend::default(), bottom: 26.0 }
    }
}

/// The drawing of `plan pins`: the part before each pin, as in Fig. 1 of Zhang, Goldberg et al., *Pin Design for Part
/// Feeding*, the toppling graph as in Fig. 8, and below it the action of pins at all heights as in Fig. 9.
///
/// The turns from one stable orientation to the next stand side by side, so that the curves go on from one to the next.
#[must_use]
pub fn pins(ride: &Ride, answer: &Pins) -> String {
    let shown = in_turn(answer);
    let heights = Heights::of(answer, ride.part.unit);
    let setting = Setting { ride, answer, shown, heights };
    let said = phrase::pins(ride, answer);

    let mut page = Canvas::new();
    page.text(At::new(SIDE, 24.0), Align::Left, 17.0, INK, true, &shortened(ride.name, 100));
    let mut bottom = 46.0;
    for line in wrapped(&said, 180) {
        page.text(At::new(SIDE, bottom), Align::Left, 12.5, MUTED, false, &line);
        bottom += 16.0;
    }
    for picture in [sequence::draw(&setting), graph::draw(&setting), diagram::draw(&setting)] {
        bottom += GAP;
        page.inset(picture.canvas, bottom);
        bottom = picture.legend.draw(&mut page, PAGE, bottom + picture.bottom);
    }
    page.finish(PAGE, bottom, ride.name, &said)
}

/// The first orientations, in the order in which the part topples from one onto the next.
fn in_turn(answer: &Pins) -> Vec<&Orientation> {
    let next = |from: &&Orientation| answer.orientations.iter().find(|orientation| orientation.edge == from.next);
    iter::successors(answer.orientations.first(), next).take(answer.orientations.len().min(MOST)).collect()
}

/// The length of the fewest rows of at most `most`, about equal.
fn row_length(count: usize, most: usize) -> usize {
    count.div_ceil(count.div_ceil(most).max(1)).max(1)
}

/// Says what is left out; nothing if that is nothing.
fn left_out(setting: &Setting) -> String {
    let all = setting.answer.orientations.len();
    if all > MOST { format!("the first {MOST} of {all} orientations") } else { String::new() }
}

#[cfg(test)]
pub(super) mod tests;
