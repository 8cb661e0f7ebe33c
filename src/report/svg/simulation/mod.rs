//! A run: bodies at chosen times, light to dark, the paths of their centers of mass, and what is fixed.

mod clip;
mod panel;
mod shades;
mod snapshots;

use super::canvas::{Align, At, Canvas, INK, MUTED, Pen};
use super::legend::{Legend, Swatch};
use super::scene::{shortened, wrapped};
use crate::answer::Simulation;
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
/// Bodies that the legend names.
const MOST_NAMED: usize = 6;

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
    let gap = 16.0;
    let panels: Vec<Panel> = S::VIEWS.iter().map(|view| Panel::new(run, &snapshots, *view)).collect();
    // views lie side by side at one scale where that is larger, else one below the other
    let (sum, widest) =
        panels.iter().fold((0.0, 0.0_f64), |(sum, widest), panel| (sum + panel.wide(), widest.max(panel.wide())));
    let (high, highest) =
        panels.iter().fold((0.0, 0.0_f64), |(sum, most), panel| (sum + panel.high(), most.max(panel.high())));
    let gaps = gap * (panels.len() as f64 - 1.0);
    let beside = ((PAGE - 2.0 * SIDE - gaps) / sum).min(TALLEST / highest);
    let below = ((PAGE - 2.0 * SIDE) / widest).min(TALLEST / high);
    let (scale, is_beside) = if beside >= below { (beside, true) } else { (below, false) };
    let mut legend = Legend::default();
    let mut corner = At::new(SIDE, bottom + 4.0);
    for panel in &panels {
        if !panel.view.name.is_empty() {
            page.text(At::new(corner.x, corner.y + 6.0), Align::Left, 12.0, MUTED, false, panel.view.name);
        }
        let top = corner.y + if panel.view.name.is_empty() { 0.0 } else { 20.0 };
        let width = if is_beside {
            panel.wide() * scale + (PAGE - 2.0 * SIDE - gaps - sum * scale) / panels.len() as f64
        } else {
            PAGE - 2.0 * SIDE
        };
        let height = if is_beside { highest * scale } else { panel.high() * scale };
        let room = Room { low: At::new(corner.x, top), high: At::new(corner.x + width, top + height), scale };
        panel.draw(&mut page, &mut legend, &room);
        bottom = room.high.y + FOOT + 4.0;
        corner = if is_beside { At::new(room.high.x + gap, corner.y) } else { At::new(SIDE, bottom + 6.0) };
    }
    for (number, body) in run.world.bodies.iter().enumerate().take(MOST_NAMED) {
        let shade = Shades::of(number).shade(0.7);
        let name = motion::plain(&body.name);
        legend.add(Swatch::Band(shade), &format!("{name}, light at first, dark at last"));
    }
    legend.add(Swatch::Line(Pen::stroke(PATH, 1.0).dashed()), "path of a center of mass");
    legend.add(Swatch::CenterOfMass, "center of mass at the end");
    let bottom = legend.draw(&mut page, PAGE, bottom);
    page.finish(PAGE, bottom, run.name, &said)
}
