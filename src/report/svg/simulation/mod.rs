//! A run: bodies at chosen times, light to dark, the paths of their centers of mass, and what is fixed.

mod clip;
mod dimensioned;
mod feeder;
mod panel;
mod shades;
mod snapshots;

pub(super) use clip::hatching;
pub(in crate::report) use clip::within;
pub use feeder::feeder;

use super::canvas::{Align, At, Canvas, INK, MUTED, Pen};
use super::legend::{Legend, Swatch};
use super::scene::{shortened, wrapped};
use crate::answer::Simulation;
use crate::report::decimal::near;
use crate::report::motion::{self, Run, Shown};
use crate::report::phrase;
use panel::{FOOT, Panel, Room};
use shades::{PATH, Shades};
use snapshots::Snapshots;

/// Width of the drawing, in pixels.
const PAGE: f64 = 900.0;
/// Left and right of everything.
const SIDE: f64 = 24.0;
/// Highest view.
const TALLEST: f64 = 560.0;
/// Between two views side by side.
const GAP: f64 = 16.0;
/// Above a view, for its name.
const HEADING: f64 = 20.0;
/// The legend names so many bodies, as there are hues.
const MOST_NAMED: usize = 4;

/// The drawing of `plan simulate`, as Figs. 3 to 5 of the paper: about ten poses of each body; in space from the side and
/// from above.
///
/// Times are chosen so that the bodies move about as far from one pose to the next.
#[must_use]
pub fn simulation<S: Shown>(run: &Run<S>, answer: &Simulation<S>) -> String {
    let said = phrase::simulation(run, answer);
    let mut page = Canvas::new();
    page.text(At::new(SIDE, 24.0), Align::Left, 17.0, INK, true, &shortened(run.name, 80));
    let mut bottom = 46.0;
    for line in wrapped(&said, 135) {
        page.text(At::new(SIDE, bottom), Align::Left, 12.5, MUTED, false, &line);
        bottom += 16.0;
    }
    let snapshots = Snapshots::new(run, motion::sound(run, answer));
    let panels: Vec<Panel> = S::VIEWS.iter().map(|view| Panel::new(run, &snapshots, *view)).collect();
    let mut legend = Legend::default();
    for (panel, room) in panels.iter().zip(arranged(&panels, bottom + 4.0)) {
        let heading = At::new(room.low.x, room.low.y - HEADING + 6.0);
        page.text(heading, Align::Left, 12.0, MUTED, false, panel.view.name);
        panel.draw(&mut page, &mut legend, &room);
        bottom = room.high.y + FOOT + 4.0;
    }
    explain(run, &snapshots, &mut legend);
    legend.add(Swatch::Line(Pen::stroke(PATH, 1.0).dashed()), "path of a center of mass");
    legend.add(Swatch::CenterOfMass, "center of mass at the end");
    let bottom = legend.draw(&mut page, PAGE, bottom);
    page.finish(PAGE, bottom, run.name, &said)
}

/// Rooms for all views at one scale: side by side where that is larger, else one below the other.
fn arranged(panels: &[Panel], top: f64) -> Vec<Room> {
    let sizes = || panels.iter().map(|panel| [panel.wide(), panel.high()]);
    let [sum_wide, sum_high] = sizes().fold([0.0, 0.0], |sum, size| [sum[0] + size[0], sum[1] + size[1]]);
    let [most_wide, most_high] =
        sizes().fold([0.0, 0.0], |most: [f64; 2], size| [most[0].max(size[0]), most[1].max(size[1])]);
    let heading = if panels.iter().all(|panel| panel.view.name.is_empty()) { 0.0 } else { HEADING };
    let gaps = GAP * (panels.len() as f64 - 1.0);
    let wide = PAGE - 2.0 * SIDE;
    let beside = ((wide - gaps) / sum_wide).min(TALLEST / most_high);
    let below = (wide / most_wide).min(TALLEST / sum_high);
    let (scale, is_beside) = (beside.max(below), beside >= below);
    let spare = (wide - gaps - sum_wide * scale) / panels.len() as f64;
    let mut corner = At::new(SIDE, top + heading);
    let mut rooms = Vec::new();
    for panel in panels {
        let size = match is_beside {
            true => At::new(panel.wide() * scale + spare, most_high * scale),
            false => At::new(wide, panel.high() * scale),
        };
        let high = At::new(corner.x + size.x, corner.y + size.y);
        rooms.push(Room { low: corner, high, scale });
        corner = match is_beside {
            true => At::new(high.x + GAP, corner.y),
            false => At::new(SIDE, high.y + FOOT + 10.0 + heading),
        };
    }
    rooms
}

/// Which shades are whose, and of which times.
fn explain<S: Shown>(run: &Run<S>, snapshots: &Snapshots<S>, legend: &mut Legend) {
    let time = |frame: Option<&usize>| frame.map_or(0.0, |frame| snapshots.frames[*frame].time);
    let [first, last] = [snapshots.drawn.first(), snapshots.drawn.last()].map(|frame| near(time(frame), 3));
    let bodies = &run.world.bodies;
    for (number, body) in bodies.iter().enumerate().take(if bodies.len() > MOST_NAMED { 1 } else { MOST_NAMED }) {
        let name = if bodies.len() > MOST_NAMED { "bodies".to_owned() } else { motion::plain(&body.name) };
        let swatch = Swatch::Band(Shades::of(number).shade(0.7));
        legend.add(swatch, &format!("{name}, from light at {first} s to dark at {last} s"));
    }
}
