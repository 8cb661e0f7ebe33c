//! States by edge and radius: where throws are possible, the limit set, and throws from state to state.

use super::super::canvas::{Align, At, INK, MUTED, Pen, RED};
use super::super::label::Labels;
use super::super::legend::Swatch;
use super::super::view::along;
use super::cycle::cycle;
use super::lane::Lane;
use super::mark::{self, Mark};
use super::{NAMES, PAGE, Picture, SIDE, Setting};
use crate::answer::{CounterExample, Throw};
use crate::report::decimal;

/// Height of a lane.
const TALL: f64 = 66.0;
const SHORT: f64 = 50.0;
/// More lanes than this are low.
const MOST_TALL: usize = 6;
/// Half the height of a band.
const BAND: f64 = 8.0;
/// So many throws are drawn as arrows.
const MOST_ARROWS: usize = 60;
const DOT: f64 = 2.4;
const INVARIANT: &str = "#9aa3ab";

/// All radii that the lanes show.
pub(super) fn radii<'a>(answer: &'a Throw, lanes: &'a [Lane]) -> impl Iterator<Item = f64> + 'a {
    let reach = lanes.iter().filter_map(|lane| lane.reach);
    let reach = reach.flat_map(|reach| [Some(reach.r_low), reach.r_flip, Some(reach.r_max)]).flatten();
    let proof = &answer.certificate;
    let example = proof.counterexample.iter().flat_map(|example| [Some(example.radii), example.landing.map(|l| l.1)]);
    let bands = answer.limit.sets.iter().flat_map(|set| set.bands.values().copied());
    let footprints = answer.sensors.iter().take(1).flat_map(|sensor| sensor.footprints.values().copied());
    let windows = answer.window().into_iter().map(|window| window.range);
    let ranges = proof.z.values().copied().chain(example.flatten()).chain(bands).chain(footprints).chain(windows);
    let components = proof.components.iter().flat_map(|component| component.bands.values().flatten().copied());
    reach.chain(ranges.chain(components).flatten())
}

/// Draws the lanes.
pub(super) fn draw(setting: &Setting) -> Option<Picture> {
    let sets = setting.answer.limit.sets.len();
    let several = if sets > 1 { format!("{sets} patterns were met, dots and arrows show one") } else { String::new() };
    let none = match (sets, setting.answer.limit.ended.len()) {
        (0, 0) => "no pattern was found".to_owned(),
        (0, n) => format!("no pattern was found, {n} orbits end"),
        _ => String::new(),
    };
    let about = "a lane for each stable edge, R is where the center of mass is along the arm";
    let mut picture = Picture::new("States", &[about, &none, &several, &setting.left_out()]);
    let lanes = setting.lanes.len().max(1) as f64;
    let rows = Rows { top: picture.bottom + 4.0, tall: if setting.lanes.len() > MOST_TALL { SHORT } else { TALL } };
    let bottom = rows.top + rows.tall * lanes;
    for number in 0..setting.lanes.len() {
        draw_ground(&mut picture, setting, &rows, number);
    }
    let title = format!("R, {}", setting.unit());
    setting.radii.draw_across(&mut picture.canvas, bottom, rows.top, &title);
    let mut names = Vec::new();
    for number in 0..setting.lanes.len() {
        draw_bands(&mut picture, setting, &rows, number);
        names.push(draw_ends(&mut picture, setting, &rows, number));
    }
    draw_arrows(&mut picture, setting, &rows);
    draw_dots(&mut picture, setting, &rows);
    if let Some(example) = &setting.answer.certificate.counterexample {
        draw_counterexample(&mut picture, setting, &rows, example);
    }
    draw_ended(&mut picture, setting, &rows);
    names.into_iter().flatten().for_each(|labels| labels.draw(&mut picture.canvas));
    picture.bottom = bottom + 34.0;
    Some(picture)
}

/// Where the lanes are.
struct Rows {
    top: f64,
    tall: f64,
}

impl Rows {
    fn of(&self, number: usize) -> [f64; 2] {
        [0.0, 1.0].map(|down| self.top + self.tall * (number as f64 + down))
    }

    /// The line of a lane on which its states are.
    fn line(&self, number: usize) -> f64 {
        self.of(number)[0] + 0.66 * self.tall
    }
}

/// The picture of the edge, and where no throw is possible.
fn draw_ground(picture: &mut Picture, setting: &Setting, rows: &Rows, number: usize) {
    let (lane, [top, bottom]) = (&setting.lanes[number], rows.of(number));
    let canvas = &mut picture.canvas;
    canvas.line(&[At::new(SIDE, bottom), At::new(PAGE - SIDE, bottom)], Pen::stroke("#d5d9dd", 1.0));
    let name = At::new(SIDE + 2.0, (top + bottom) / 2.0);
    lane.hue.dot(canvas, At::new(name.x + 3.0, name.y), 4.0);
    canvas.text(At::new(name.x + 12.0, name.y), Align::Left, 12.0, INK, true, &format!("edge {}", lane.edge));
    if let Some(pose) = &lane.pose {
        let [left, right] = pose.sides();
        let pixels = (44.0 / (right - left)).min((rows.tall - 14.0) / pose.height());
        let foot = At::new(SIDE + NAMES - 34.0 - (left + right) / 2.0 * pixels, bottom - 5.0);
        let ends = [SIDE + NAMES - 60.0, SIDE + NAMES - 8.0].map(|x| At::new(x, foot.y));
        canvas.line(&ends, Pen::stroke(MUTED, 1.4));
        pose.draw(canvas, foot, pixels, Pen::fill("none", 1.0));
        picture.legend.add(Swatch::CenterOfMass, "center of mass");
    }
    let low = lane.reach.map_or(setting.radii.page[1], |reach| setting.radii.at(reach.r_low));
    if low > setting.radii.page[0] {
        let area = mark::rectangle([setting.radii.page[0], low], [top, bottom]);
        mark::hatched(&mut picture.canvas, &area);
        picture.legend.add(Swatch::Throw(Mark::Hatched), "no throw: slips, rolls or is left of the pivot");
    }
}

/// What is proved, and what was met.
fn draw_bands(picture: &mut Picture, setting: &Setting, rows: &Rows, number: usize) {
    let (lane, proof, radii) = (&setting.lanes[number], &setting.answer.certificate, &setting.radii);
    let (line, [_, bottom]) = (rows.line(number), rows.of(number));
    for ends in proof.starts.get(&lane.edge).into_iter().flatten() {
        let pen = Pen::stroke(INVARIANT, 4.0);
        picture.canvas.line(&ends.map(|end| At::new(radii.at(end), bottom - 3.0)), pen);
        picture.legend.add(Swatch::Line(pen), "proved: throws from here land here again");
    }
    let terminal = || proof.components.iter().filter(|component| component.is_terminal);
    let shown: Vec<_> = match proof.is_unique {
        true => proof.components.iter().take(1).collect(),
        false if terminal().count() > 1 => terminal().collect(),
        false => Vec::new(),
    };
    for band in shown.into_iter().filter_map(|component| component.bands.get(&lane.edge)).flatten() {
        let x = wide_enough(band.map(|end| radii.at(end)));
        picture.canvas.polygon(&mark::rectangle(x, [line - BAND, line + BAND]), lane.hue.band());
        let meaning = if proof.is_unique { "proved: all that recurs is here" } else { "proved: a pattern stays here" };
        let pen = Pen::fill(MUTED, 0.2).outlined(MUTED, 1.0);
        picture.legend.add(Swatch::Throw(Mark::Area(pen)), meaning);
    }
    for (place, set) in setting.answer.limit.sets.iter().enumerate() {
        let Some(band) = set.bands.get(&lane.edge) else { continue };
        let pen = if place == 0 { Pen::stroke(INK, 1.3) } else { Pen::stroke(INK, 1.3).dashed() };
        let meaning = if place == 0 { "radii met in the limit set" } else { "radii met in other limit sets" };
        let [low, high] = wide_enough(band.map(|end| radii.at(end)));
        let y = line + BAND + 3.0 * place.min(2) as f64 + 2.0;
        let bracket = [At::new(low, y - 3.0), At::new(low, y), At::new(high, y), At::new(high, y - 3.0)];
        picture.canvas.line(&bracket, pen);
        picture.legend.add(Swatch::Line(pen), meaning);
    }
}

/// R_flip and R_max; their values are to be written over all else.
fn draw_ends(picture: &mut Picture, setting: &Setting, rows: &Rows, number: usize) -> Option<Labels> {
    let reach = setting.lanes[number].reach?;
    let [top, bottom] = rows.of(number);
    let mut labels = Labels::within([At::new(SIDE + NAMES, top), At::new(PAGE - SIDE + 6.0, bottom)]).rimmed();
    let [flip_pen, max_pen] = [Pen::stroke(INK, 1.3).dashed(), Pen::stroke(INK, 1.6)];
    let mut told: Vec<String> = Vec::new();
    let ends = [
        (reach.r_flip, Some(flip_pen), "R_flip: from here on throws flip the part"),
        (Some(reach.r_max), Some(max_pen), "R_max: throws from up to here land no farther"),
        (Some(reach.r_low), None, ""),
    ];
    for (radius, pen, meaning) in ends {
        let Some(radius) = radius.filter(|radius| setting.radii.holds(*radius)) else { continue };
        let x = setting.radii.at(radius);
        if let Some(pen) = pen {
            let ends = [At::new(x, top + 1.0), At::new(x, bottom - 1.0)];
            picture.canvas.line(&ends, pen);
            picture.legend.add(Swatch::Throw(Mark::Upright(pen)), meaning);
            labels.avoid(&along(ends[0], ends[1]));
        }
        let text = decimal::near(radius, 4);
        if told.contains(&text) {
            continue;
        }
        let toward = At::new(if pen == Some(max_pen) { 1.0 } else { -1.0 }, 0.0);
        labels.offer_near(At::new(x, top + 8.0), toward, 5.0, MUTED, text.clone());
        told.push(text);
    }
    Some(labels)
}

/// One cycle.
fn draw_arrows(picture: &mut Picture, setting: &Setting, rows: &Rows) {
    let Some(set) = setting.set() else { return };
    let states = cycle(set);
    for pair in states[..states.len().min(MOST_ARROWS + 1)].windows(2) {
        let [(from, start), (to, end)] = [pair[0], pair[1]];
        let (Some((here, lane)), Some((there, _))) = (setting.lane(from), setting.lane(to)) else { continue };
        let colour = lane.hue.colour;
        let tail = At::new(setting.radii.at(start), rows.line(here));
        let tip = At::new(setting.radii.at(end), rows.line(there));
        if here == there {
            mark::hop(&mut picture.canvas, tail, tip, colour);
            picture.legend.add(Swatch::Throw(Mark::Jog), "jog: the edge stays");
        } else {
            let back = tail.minus(tip).normalized();
            picture.canvas.arrow(tail, tip.along(back, DOT), colour, 1.1);
            picture.legend.add(Swatch::Throw(Mark::Flip), "flip, in the color of the edge thrown from");
        }
    }
}

fn draw_dots(picture: &mut Picture, setting: &Setting, rows: &Rows) {
    let Some(set) = setting.set() else { return };
    for (number, lane) in setting.lanes.iter().enumerate() {
        let line = rows.line(number);
        let here = set.orbit.iter().filter(|(edge, radius)| *edge == lane.edge && radius.is_finite());
        let mut places: Vec<f64> = here.map(|(_, radius)| setting.radii.at(*radius)).collect();
        places.sort_by(f64::total_cmp);
        // closer ones cannot be told from each other
        places.dedup_by(|next, kept| *next - *kept < 0.4);
        places.into_iter().for_each(|x| lane.hue.dot(&mut picture.canvas, At::new(x, line), DOT));
    }
    if let Some(lane) = setting.lanes.iter().find(|lane| set.bands.contains_key(&lane.edge)) {
        let meaning = format!("states of {} throws in the limit set", set.orbit.len());
        picture.legend.add(Swatch::Throw(Mark::Dot(lane.hue)), &meaning);
    }
}

fn draw_ended(picture: &mut Picture, setting: &Setting, rows: &Rows) {
    for ended in &setting.answer.limit.ended {
        let (edge, radius) = ended.at;
        let Some((number, _)) = setting.lane(edge).filter(|_| setting.radii.holds(radius)) else { continue };
        mark::cross(&mut picture.canvas, At::new(setting.radii.at(radius), rows.line(number)));
        picture.legend.add(Swatch::Throw(Mark::Cross), "an orbit ends with the throw from here");
    }
}

/// From which radii a throw provably leaves, and to where.
fn draw_counterexample(picture: &mut Picture, setting: &Setting, rows: &Rows, example: &CounterExample) {
    let radii = &setting.radii;
    let bar = |ends: [f64; 2]| wide_enough(ends.map(|end| radii.at(end)));
    let Some((number, _)) = setting.lane(example.edge) else { return };
    let (line, pen) = (rows.line(number), Pen::stroke(RED, 7.0));
    let x = bar(example.radii);
    picture.canvas.polygon(&mark::rectangle(x, [line - 9.0, line + 9.0]), Pen::fill(RED, 1.0).outlined(RED, 2.5));
    let leaves = if example.leaves_domain { "where no throw is possible" } else { "outside of the set" };
    picture.legend.add(Swatch::Line(pen), &format!("proved: throws from here end {leaves}"));
    let from = At::new((x[0] + x[1]) / 2.0, line);
    match example.landing.and_then(|(edge, ends)| Some((setting.lane(edge)?.0, bar(ends)))) {
        Some((there, ends)) => {
            let to = At::new((ends[0] + ends[1]) / 2.0, rows.line(there));
            picture.canvas.line(&ends.map(|x| At::new(x, to.y)), Pen::stroke(RED, 3.0));
            if there == number {
                mark::hop(&mut picture.canvas, from, to, RED);
            } else {
                picture.canvas.arrow(from, to, RED, 1.8);
            }
        }
        None => {
            let end = At::new(radii.page[0] + 8.0, line);
            picture.canvas.arrow(from, end, RED, 1.8);
            let text = if example.landing.is_none() { "beside the arm" } else { "onto another edge" };
            picture.canvas.rimmed_text(At::new(end.x + 4.0, line - 14.0), Align::Left, 11.0, RED, false, text);
        }
    }
}

/// Ends that can be told from each other.
fn wide_enough([low, high]: [f64; 2]) -> [f64; 2] {
    let spare = (1.5 - (high - low)).max(0.0) / 2.0;
    [low - spare, high + spare]
}
