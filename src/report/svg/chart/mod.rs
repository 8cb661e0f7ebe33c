//! Error against time, a panel for each piece of work; and maps of where methods fail.

mod axes;
mod mark;
mod panel;
mod tiles;

pub(super) use mark::{Mark, sample};
pub use tiles::failures;

use super::canvas::{Align, At, Canvas, INK, MUTED};
use super::legend::{Legend, Swatch};
use super::scene::wrapped;
use crate::answer::{Chart, ChartFamily, ChartPoint};
use crate::report::markdown::distinct;
use panel::Panel;

/// Width of the drawing, in pixels.
const PAGE: f64 = 900.0;
/// Left and right of everything.
const SIDE: f64 = 24.0;
/// Between two panels.
const GAP: f64 = 20.0;
/// Height of a panel.
const HIGH: f64 = 330.0;

/// The chart of a family: logarithmic axes, a curve for each method; `None` if nothing of it was measured.
#[must_use]
pub fn chart(chart: &Chart, family: ChartFamily) -> Option<String> {
    let points: Vec<&ChartPoint> = chart.points.iter().filter(|point| point.family == family).collect();
    let methods = distinct(points.iter().map(|point| point.method.as_str()));
    let works = distinct(points.iter().map(|point| point.work.as_str()));
    if works.is_empty() {
        return None;
    }
    let mut page = Canvas::new();
    let said = format!("{}: {}, against {}", family.title(), family.error(), family.time());
    let mut bottom = head(&mut page, family.title(), &conditions(chart));
    let columns = works.len().min(2);
    let wide = if columns == 1 { 560.0 } else { (PAGE - 2.0 * SIDE - GAP) / 2.0 };
    for row in works.chunks(columns) {
        for (column, work) in row.iter().enumerate() {
            let shown: Vec<&ChartPoint> = points.iter().copied().filter(|point| point.work == *work).collect();
            let low = At::new(SIDE + column as f64 * (wide + GAP), bottom);
            Panel::new(family, work, &methods, &shown, [low, At::new(low.x + wide, low.y + HIGH)]).draw(&mut page);
        }
        bottom += HIGH + 14.0;
    }
    let mut legend = Legend::default();
    for (index, method) in methods.iter().enumerate() {
        legend.add(Swatch::Chart(Mark::of(index)), method);
    }
    if points.iter().any(|point| point.failed > 0) {
        legend.add(Swatch::Chart(Mark::of(0).hollow()), "hollow: some runs failed, with their share");
    }
    bottom = legend.draw(&mut page, PAGE, bottom);
    let remark = "The lower left is best. Whiskers: quartiles of the time.";
    page.text(At::new(SIDE, bottom + 4.0), Align::Left, 11.0, MUTED, false, remark);
    Some(page.finish(PAGE, bottom + 18.0, family.title(), &said))
}

/// Title and conditions; returns where they end.
fn head(page: &mut Canvas, title: &str, conditions: &str) -> f64 {
    page.text(At::new(SIDE, 24.0), Align::Left, 17.0, INK, true, title);
    let mut bottom = 46.0;
    for line in wrapped(conditions, 150) {
        page.text(At::new(SIDE, bottom), Align::Left, 11.0, MUTED, false, &line);
        bottom += 15.0;
    }
    bottom + 6.0
}

fn conditions(chart: &Chart) -> String {
    let all = chart.conditions.iter().map(|(name, value)| format!("{name} {value}"));
    all.collect::<Vec<_>>().join(", ")
}
