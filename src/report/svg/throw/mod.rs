//! Throws: where the pattern lies, how orbits come to it, and its poses.

mod cycle;
mod design;
mod lane;
mod mark;
mod pose;
mod poses;
mod scale;
mod sensor;
mod starts;
mod states;

pub(super) use mark::{Mark, sample};

use super::super::{Toss, phrase};
use super::canvas::{Align, At, Canvas, INK, MUTED};
use super::legend::Legend;
use super::scene::{shortened, wrapped};
use crate::answer::{LimitSet, Throw};
use crate::exact::Q;
use lane::Lane;
use num_traits::{One as _, Signed as _};
use scale::Scale;

/// Width of the drawing, in pixels.
const PAGE: f64 = 900.0;
/// Left and right of everything.
const SIDE: f64 = 24.0;
/// Left of the plots, for the names of edges.
const NAMES: f64 = 132.0;
/// Between two pictures.
const GAP: f64 = 18.0;

/// What the pictures show.
struct Setting<'a> {
    toss: &'a Toss<'a>,
    answer: &'a Throw,
    /// The stable edges that are drawn.
    lanes: Vec<Lane<'a>>,
    /// Radii that the map speaks of.
    radii: Scale,
    /// The larger side of the hull.
    size: Q,
}

impl Setting<'_> {
    fn set(&self) -> Option<&LimitSet> {
        self.answer.limit.sets.first()
    }

    fn unit(&self) -> &'static str {
        self.toss.part.unit.symbol()
    }

    /// The lane of an edge, if it is drawn, and its number.
    fn lane(&self, edge: usize) -> Option<(usize, &Lane<'_>)> {
        self.lanes.iter().enumerate().find(|(_, lane)| lane.edge == edge)
    }

    /// Says what is left out; nothing if that is nothing.
    fn left_out(&self) -> String {
        let all = self.answer.stable.len();
        if all > self.lanes.len() {
            format!("{} of {all} stable edges are shown", self.lanes.len())
        } else {
            String::new()
        }
    }
}

/// One of the pictures, as high as `bottom`.
struct Picture {
    canvas: Canvas,
    legend: Legend,
    bottom: f64,
}

impl Picture {
    /// A picture with its heading, and what is to be said about it.
    fn new(heading: &str, remarks: &[&str]) -> Self {
        let mut canvas = Canvas::new();
        canvas.text(At::new(SIDE, 10.0), Align::Left, 14.0, INK, true, heading);
        let right_of_heading = SIDE + 20.0 + 7.8 * heading.chars().count() as f64;
        let remark = remarks.iter().filter(|remark| !remark.is_empty()).copied().collect::<Vec<_>>().join("; ");
        let room = ((PAGE - SIDE - right_of_heading) / 5.6) as usize;
        let remark = shortened(&remark, room);
        canvas.text(At::new(right_of_heading, 10.0), Align::Left, 12.0, MUTED, false, &remark);
        Self { canvas, legend: Legend::default(), bottom: 28.0 }
    }
}

/// The drawing of `plan throw`: states by edge and radius as in Figs. 5 and 8 of Lynch, Northrop & Pan, *Stable Limit Sets in a
/// Dynamic Parts Feeder*, the places for a sensor, how all starts converge, the poses of a cycle as in Fig. 6, and the settings
/// of the arm that were tried.
#[must_use]
pub fn throw(toss: &Toss, answer: &Throw) -> String {
    let size = size(answer);
    let lanes = lane::lanes(toss, answer, &size);
    let radii = Scale::covering(states::radii(answer, &lanes), [SIDE + NAMES, PAGE - SIDE]);
    let setting = Setting { toss, answer, lanes, radii, size };
    let said = phrase::throw(toss, answer);

    let mut page = Canvas::new();
    page.text(At::new(SIDE, 24.0), Align::Left, 17.0, INK, true, &shortened(toss.name, 80));
    let mut bottom = 46.0;
    for line in wrapped(&said, 135) {
        page.text(At::new(SIDE, bottom), Align::Left, 12.5, MUTED, false, &line);
        bottom += 16.0;
    }
    let pictures = [
        states::draw(&setting),
        sensor::draw(&setting),
        starts::draw(&setting),
        poses::draw(&setting),
        design::draw(&setting),
    ];
    for picture in pictures.into_iter().flatten() {
        bottom += GAP;
        page.inset(picture.canvas, bottom);
        bottom = picture.legend.draw(&mut page, PAGE, bottom + picture.bottom);
    }
    page.finish(PAGE, bottom, toss.name, &said)
}

fn size(answer: &Throw) -> Q {
    let side = |axis: usize| {
        let along = || answer.hull.iter().map(move |corner| &corner[axis]);
        along().max().zip(along().min()).map(|(high, low)| high - low)
    };
    side(0).max(side(1)).filter(Q::is_positive).unwrap_or_else(Q::one)
}

#[cfg(test)]
mod tests;
