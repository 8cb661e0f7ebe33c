//! Radii over the number of the throw from all starts, as they come to the limit set.

use super::super::canvas::{Align, At, INK, MUTED, Pen};
use super::super::legend::Swatch;
use super::mark::{self, Mark};
use super::scale::Scale;
use super::{PAGE, Picture, SIDE, Setting};
use crate::answer::EndedOrbit;

const HEIGHT: f64 = 250.0;
const AXIS: f64 = 50.0;
/// Between the bands at the right.
const PITCH: f64 = 15.0;
/// So many orbits and so many of their throws are drawn.
const MOST: usize = 48;
const MOST_THROWS: usize = 50;
/// Lines are drawn for so many orbits.
const MOST_LINES: usize = 6;
const LINE: &str = "#aab2b9";

/// Draws the orbits; `None` if no throw comes back to the arm.
pub(super) fn draw(setting: &Setting) -> Option<Picture> {
    let limit = &setting.answer.limit;
    let comes_back = limit.orbits.iter().any(|orbit| orbit.len() > 1) || limit.ended.iter().any(|end| end.after > 0);
    if !comes_back {
        return None;
    }
    let orbits = some_of(&limit.orbits, MOST);
    let ended = some_of(&limit.ended, MOST);
    let kept = orbits.len() + ended.len();
    let all = limit.orbits.len() + limit.ended.len();
    let some = if kept < all { format!("{kept} of {all} starts") } else { format!("{all} starts") };
    let came = match (limit.sets.len(), limit.ended.len()) {
        (1, 0) => "all of them come to the same pattern".to_owned(),
        (sets, 0) => format!("they come to {sets} patterns"),
        (0, _) => "all of them end".to_owned(),
        (_, n) => format!("{n} of them end"),
    };
    let mut picture = Picture::new("Orbits", &["the radius R before each throw", &some, &came]);
    let (top, bottom) = (picture.bottom + 16.0, picture.bottom + 16.0 + HEIGHT);
    let visited: Vec<usize> = (0..setting.lanes.len())
        .filter(|lane| limit.sets.iter().any(|set| set.bands.contains_key(&setting.lanes[*lane].edge)))
        .collect();
    let right = PAGE - SIDE - if visited.is_empty() { 0.0 } else { 12.0 + PITCH * visited.len() as f64 };
    let radii = setting.radii.on([bottom, top]);
    let longest =
        orbits.iter().map(|orbit| orbit.len().saturating_sub(1)).chain(ended.iter().map(|end| end.after)).max();
    let throws = longest.unwrap_or(0).clamp(1, MOST_THROWS);
    let across = Scale { values: [-0.6, throws as f64 + 0.4], page: [SIDE + AXIS, right], least_step: 1.0 };
    across.draw_across(&mut picture.canvas, bottom, top, "throws");
    radii.draw_up(&mut picture.canvas, SIDE + AXIS, right, &format!("R, {}", setting.unit()));

    let place = |number: usize, radius: f64| At::new(across.at(number as f64), radii.at(radius));
    draw_lines(&mut picture, &orbits, &place);
    draw_specks(&mut picture, setting, &orbits, &radii, &place);
    for end in ended {
        draw_end(&mut picture, setting, end, throws, &place);
    }
    let starts = orbits.iter().filter_map(|orbit| orbit.first());
    for (edge, radius) in starts {
        let colour = setting.lane(*edge).map_or(INK, |(_, lane)| lane.hue.colour);
        mark::diamond(&mut picture.canvas, place(0, *radius), colour);
    }
    let is_beyond = |radius: f64| radius > radii.values[1];
    let firsts = limit.orbits.iter().filter_map(|orbit| orbit.first()).chain(limit.ended.iter().map(|end| &end.start));
    let beyond = if firsts.into_iter().any(|(_, radius)| is_beyond(*radius)) {
        "start; from beyond at the top"
    } else {
        "start"
    };
    picture.legend.add(Swatch::Throw(Mark::Diamond), beyond);
    for (column, lane) in visited.iter().enumerate() {
        let lane = &setting.lanes[*lane];
        let x = right + 12.0 + PITCH * (column as f64 + 0.3);
        for (number, set) in limit.sets.iter().enumerate() {
            let Some(band) = set.bands.get(&lane.edge) else { continue };
            let [low, high] = band.map(|end| radii.at(end));
            let half = if number == 0 { 4.5 } else { 2.0 };
            picture.canvas.polygon(&mark::rectangle([x - half, x + half], [high - 0.7, low + 0.7]), lane.hue.bar());
        }
        picture.canvas.text(At::new(x, bottom + 13.0), Align::Middle, 11.0, MUTED, false, &lane.edge.to_string());
    }
    if !visited.is_empty() {
        let pen = Pen::fill(MUTED, 0.75).outlined(MUTED, 1.0);
        let others = if limit.sets.len() > 1 { ", narrow in others" } else { "" };
        let meaning = format!("at the right: radii of each edge in the limit set{others}");
        picture.legend.add(Swatch::Throw(Mark::Area(pen)), &meaning);
    }
    picture.bottom = bottom + 34.0;
    Some(picture)
}

/// At most so many, from everywhere.
fn some_of<T>(all: &[T], most: usize) -> Vec<&T> {
    let count = all.len().min(most);
    (0..count).map(|k| &all[k * all.len() / count]).collect()
}

fn draw_lines(picture: &mut Picture, orbits: &[&Vec<(usize, f64)>], place: &impl Fn(usize, f64) -> At) {
    let line = |orbit: &&Vec<(usize, f64)>| -> Vec<At> {
        orbit.iter().take(MOST_THROWS + 1).enumerate().map(|(number, (_, radius))| place(number, *radius)).collect()
    };
    let lines: Vec<Vec<At>> = some_of(orbits, MOST_LINES).into_iter().map(line).filter(|line| line.len() > 1).collect();
    if !lines.is_empty() {
        let pen = Pen::stroke(LINE, 0.8);
        picture.canvas.lines(&lines, pen);
        picture.legend.add(Swatch::Line(pen), "some of the orbits");
    }
}

/// The states of all orbits, by edge.
fn draw_specks(
    picture: &mut Picture,
    setting: &Setting,
    orbits: &[&Vec<(usize, f64)>],
    radii: &Scale,
    place: &impl Fn(usize, f64) -> At,
) {
    for lane in &setting.lanes {
        let states = orbits.iter().flat_map(|orbit| orbit.iter().take(MOST_THROWS + 1).enumerate().skip(1));
        let here = states.filter(|(_, (edge, radius))| *edge == lane.edge && radii.holds(*radius));
        let places: Vec<At> = here.map(|(number, (_, radius))| place(number, *radius)).collect();
        if !places.is_empty() {
            lane.hue.specks(&mut picture.canvas, &places);
            picture.legend.add(Swatch::Throw(Mark::Dot(lane.hue)), &format!("on edge {}", lane.edge));
        }
    }
}

/// An orbit that ends: its start, and where its last throw is made.
fn draw_end(
    picture: &mut Picture,
    setting: &Setting,
    end: &EndedOrbit,
    throws: usize,
    place: &impl Fn(usize, f64) -> At,
) {
    let colour = |edge: usize| setting.lane(edge).map_or(INK, |(_, lane)| lane.hue.colour);
    let (from, to) = (place(0, end.start.1), place(end.after.min(throws), end.at.1));
    if end.after > 0 {
        let pen = Pen::stroke(LINE, 1.0).dashed();
        picture.canvas.line(&[from, to], pen);
        picture.legend.add(Swatch::Line(pen), "from the start to the last throw of an orbit that ends");
    }
    mark::diamond(&mut picture.canvas, from, colour(end.start.0));
    if end.after <= throws {
        mark::cross(&mut picture.canvas, to);
        picture.legend.add(Swatch::Throw(Mark::Cross), "an orbit ends with the throw from here");
    }
}
