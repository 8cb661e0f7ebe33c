//! A device before and after its design: snapshots for each entry, its dimensions, and how the search went.

use super::super::canvas::{Align, At, BLUE, Canvas, GREEN, INK, MUTED, Pen};
use super::super::legend::{Legend, Swatch};
use super::super::scene::{shortened, wrapped};
use super::dimensioned::Dimensioned;
use super::panel::{FOOT, Panel, Room};
use super::shades::{PATH, Shades};
use super::snapshots::Snapshots;
use super::{GAP, PAGE, SIDE};
use crate::answer::{FeederPlan, Film};
use crate::model::Planar;
use crate::report::decimal::near;
use crate::report::motion::{self, Run, Shown as _};
use crate::report::{Chute, phrase};

/// Highest row of snapshots.
const TALLEST: f64 = 420.0;
/// Above a view, for its two lines.
const HEADING: f64 = 40.0;
/// Height of the chart of the search.
const CHART: f64 = 150.0;
/// Left of it, for its numbers.
const NUMBERS: f64 = 44.0;
/// Between two lines of the table.
const LINE: f64 = 15.0;

/// The drawing of `plan feeder`, as Figs. 6 to 10 of the paper.
#[must_use]
pub fn feeder(chute: &Chute, answer: &FeederPlan, films: &[Film]) -> String {
    let said = phrase::feeder(chute, answer);
    let mut page = Canvas::new();
    page.text(At::new(SIDE, 24.0), Align::Left, 17.0, INK, true, &shortened(chute.name, 80));
    let mut bottom = 46.0;
    for line in wrapped(&said, 135) {
        page.text(At::new(SIDE, bottom), Align::Left, 12.5, MUTED, false, &line);
        bottom += 16.0;
    }
    let mut legend = Legend::default();
    for row in films.chunk_by(|a, b| a.design == b.design) {
        bottom = snapshots(&mut page, &mut legend, chute, answer, row, bottom);
    }
    legend.add(Swatch::Band(Shades::of(0).shade(0.7)), "the part, from light to dark");
    legend.add(Swatch::Line(Pen::stroke(PATH, 1.0).dashed()), "path of its center of mass");
    bottom = legend.draw(&mut page, PAGE, bottom);
    bottom = dimensioned(&mut page, chute, answer, films, bottom + 4.0);
    bottom = dimensions(&mut page, chute, answer, bottom + 8.0);
    if !answer.trace.is_empty() {
        bottom = trace(&mut page, answer, bottom + 20.0);
    }
    page.finish(PAGE, bottom + 8.0, chute.name, &said)
}

/// A row of views, one for each entry.
fn snapshots(
    page: &mut Canvas,
    legend: &mut Legend,
    chute: &Chute,
    answer: &FeederPlan,
    films: &[Film],
    top: f64,
) -> f64 {
    let runs: Vec<Run<Planar>> =
        films.iter().map(|film| Run { name: chute.name, world: &film.world, warnings: &[] }).collect();
    let shots: Vec<Snapshots<Planar>> =
        runs.iter().zip(films).map(|(run, film)| Snapshots::new(run, motion::sound(run, &film.simulation))).collect();
    let panels: Vec<Panel> =
        runs.iter().zip(&shots).map(|(run, shots)| Panel::new(run, shots, Planar::VIEWS[0])).collect();
    let wide = (PAGE - 2.0 * SIDE - GAP * (panels.len() as f64 - 1.0)) / panels.len() as f64;
    let widest = panels.iter().map(Panel::wide).fold(0.0, f64::max);
    let highest = panels.iter().map(Panel::high).fold(0.0, f64::max);
    let scale = (wide / widest).min(TALLEST / highest);
    for (index, (panel, film)) in panels.iter().zip(films).enumerate() {
        let low = At::new(SIDE + index as f64 * (wide + GAP), top + HEADING);
        let design = if film.design == "at first" { Some(&answer.start) } else { answer.best.as_ref() };
        let fate = design
            .and_then(|design| design.runs.get(film.entry))
            .map_or_else(String::new, |run| format!("{} after {} s", run.fate.name(), near(run.time, 3)));
        let entry = chute.feeder.entries.get(film.entry).map_or("", String::as_str);
        let title = format!("{}: {}", film.design, shortened(entry, 40));
        page.text(At::new(low.x, low.y - 24.0), Align::Left, 12.5, INK, true, &title);
        page.text(At::new(low.x, low.y - 9.0), Align::Left, 12.0, MUTED, false, &fate);
        panel.draw(page, legend, &Room { low, high: At::new(low.x + wide, low.y + highest * scale), scale });
    }
    top + HEADING + highest * scale + FOOT + 10.0
}

/// The device before and after side by side, with what the case measures of it.
fn dimensioned(page: &mut Canvas, chute: &Chute, answer: &FeederPlan, films: &[Film], top: f64) -> f64 {
    let designs = [("at first", Some(&answer.start)), ("designed", answer.best.as_ref())];
    let shown = designs.into_iter().filter_map(|(name, design)| {
        let film = films.iter().find(|film| film.design == name)?;
        let fixed = film.world.fixed.iter();
        let fixed = fixed.flat_map(|fixed| Planar::outlines(&fixed.shape, None, Planar::VIEWS[0])).collect();
        let dimensions = chute.feeder.device.dimensions(&design?.variables, &chute.feeder.nominal());
        (!dimensions.is_empty()).then_some((name, Dimensioned { fixed, dimensions }))
    });
    let shown: Vec<(&str, Dimensioned)> = shown.collect();
    if shown.is_empty() {
        return top;
    }
    let frames: Vec<[[f64; 2]; 2]> = shown.iter().map(|(_, device)| device.frame()).collect();
    let most = |axis: usize| frames.iter().map(|[low, high]| high[axis] - low[axis]).fold(0.0, f64::max);
    let wide = (PAGE - 2.0 * SIDE - GAP) / 2.0;
    let scale = (wide / most(0)).min(TALLEST / most(1));
    for (index, ((name, device), [low, high])) in shown.iter().zip(&frames).enumerate() {
        let at = At::new(SIDE + index as f64 * (wide + GAP), top + HEADING);
        page.text(At::new(at.x, at.y - 9.0), Align::Left, 12.5, INK, true, &format!("{name}: dimensions"));
        let middle = [(low[0] + high[0]) / 2.0, (low[1] + high[1]) / 2.0];
        device.draw(page, middle, &Room { low: at, high: At::new(at.x + wide, at.y + most(1) * scale), scale });
    }
    top + HEADING + most(1) * scale + FOOT + 10.0
}

/// Each variable with its value at first and as designed, in two columns.
fn dimensions(page: &mut Canvas, chute: &Chute, answer: &FeederPlan, top: f64) -> f64 {
    let variables = &chute.feeder.variables;
    let rows = variables.len().div_ceil(2);
    let wide = 0.5 * (PAGE - 2.0 * SIDE);
    for column in 0..2 {
        let left = SIDE + column as f64 * wide;
        let heads = [(70.0, "at first"), (140.0, "designed")];
        if column * rows < variables.len() {
            for (at, head) in heads {
                page.text(At::new(left + at, top + LINE), Align::Left, 11.0, MUTED, false, head);
            }
        }
        for (row, variable) in variables.iter().skip(column * rows).take(rows).enumerate() {
            let index = column * rows + row;
            let y = top + (row as f64 + 2.0) * LINE;
            let designed = answer.best.as_ref().map_or_else(|| "-".to_owned(), |best| near(best.variables[index], 4));
            page.text(At::new(left, y), Align::Left, 11.5, INK, true, &shortened(&variable.name, 10));
            page.text(At::new(left + 70.0, y), Align::Left, 11.5, INK, false, &near(variable.start, 4));
            page.text(At::new(left + 140.0, y), Align::Left, 11.5, INK, true, &designed);
            let meaning = variable.meaning.as_deref().unwrap_or("");
            page.text(At::new(left + 205.0, y), Align::Left, 10.5, MUTED, false, &shortened(meaning, 36));
        }
    }
    top + (rows as f64 + 2.0) * LINE
}

/// Cost against evaluations, its best so far as a line.
fn trace(page: &mut Canvas, answer: &FeederPlan, top: f64) -> f64 {
    let (left, right, bottom) = (SIDE + NUMBERS, PAGE - SIDE, top + 24.0 + CHART);
    let costs = || answer.trace.iter().map(|evaluation| evaluation.cost);
    let least = costs().fold(f64::INFINITY, f64::min).max(1e-9).log10().floor();
    let most = costs().fold(0.0, f64::max).max(1e-9).log10().ceil().max(least + 1.0);
    let count = answer.trace.len();
    let place = |index: usize, cost: f64| {
        let along = (index as f64 + 1.0) / count as f64;
        let up = (cost.max(1e-9).log10() - least) / (most - least);
        At::new(left + along * (right - left), bottom - up * CHART)
    };
    page.text(At::new(SIDE, top + 8.0), Align::Left, 12.5, INK, true, "cost of each evaluation (s)");
    for decade in 0..=(most - least) as usize {
        let value = 10.0_f64.powf(least + decade as f64);
        let y = place(0, value).y;
        page.line(&[At::new(left, y), At::new(right, y)], Pen::stroke("#e3e6e9", 1.0));
        page.text(At::new(left - 6.0, y + 4.0), Align::Right, 11.0, MUTED, false, &near(value, 2));
    }
    for (index, evaluation) in answer.trace.iter().enumerate() {
        let colour = if evaluation.passes { GREEN } else { "#9aa3ab" };
        page.circle(place(index, evaluation.cost), 1.5, Pen::fill(colour, 0.8));
    }
    let mut best = f64::INFINITY;
    let line: Vec<At> = costs()
        .enumerate()
        .map(|(index, cost)| {
            best = best.min(cost);
            place(index, best)
        })
        .collect();
    page.line(&line, Pen::stroke(BLUE, 1.6));
    page.text(At::new(right, bottom + 15.0), Align::Right, 11.0, MUTED, false, &format!("{count} evaluations"));
    let key = "green: passes from every entry and at every step; grey: does not; line: best so far";
    page.text(At::new(left, bottom + 15.0), Align::Left, 11.0, MUTED, false, key);
    bottom + 20.0
}
