//! The pin action diagram, as in Fig. 9 of the paper: what a pin of any height does to every orientation.

use super::super::canvas::{Align, At, INK, MUTED, ORANGE, Pen};
use super::super::legend::Swatch;
use super::super::scene::shortened;
use super::action::{self, Rect};
use super::axis::Upright;
use super::bars::bars;
use super::planned::{self, Planned, planned};
use super::{PAGE, Picture, SIDE, Setting};
use crate::answer::{Orientation, PinAction};
use crate::report::{decimal, phrase};

const HEIGHT: f64 = 290.0;
/// Left of the bars, for the axis.
const AXIS: f64 = 52.0;
/// Right of the bars, for the names of the pins.
const NAMES: f64 = 190.0;
/// Of a column with the space beside its bars.
const WIDEST: f64 = 190.0;
/// Between the names of two pins.
const LINE: f64 = 14.0;
/// So many heights of pins have room beside the bars.
pub(super) const MOST_LINES: usize = (HEIGHT / LINE) as usize;

/// Draws the pin action diagram with the planned pins.
pub(super) fn draw(setting: &Setting) -> Picture {
    let planned = planned(setting.answer);
    let mut remark = super::left_out(setting);
    if planned.len() > MOST_LINES {
        let also = format!("the lowest {MOST_LINES} of {} heights of pins", planned.len());
        remark = if remark.is_empty() { also } else { format!("{remark}; {also}") };
    }
    let planned = &planned[..planned.len().min(MOST_LINES)];
    let mut picture = Picture::new("Pin action diagram", &remark);
    let top = picture.bottom + 24.0;
    let upright = Upright::new(top, top + HEIGHT, setting.heights.tallest);
    let left = SIDE + AXIS;
    let room = PAGE - SIDE - left - if planned.is_empty() { 0.0 } else { NAMES };
    let pitch = (room / setting.shown.len().max(1) as f64).min(WIDEST);
    let right = left + pitch * setting.shown.len() as f64;
    upright.draw(&mut picture.canvas, &setting.heights, left, right);
    let intervals = || setting.shown.iter().flat_map(|orientation| &orientation.intervals);
    for action in action::ALL.into_iter().filter(|action| intervals().any(|interval| interval.action == *action)) {
        picture.legend.add(action::swatch(action), action::meaning(action));
    }
    let heights: Vec<f64> = planned.iter().map(|pin| upright.y(setting.heights.share_of(pin.height))).collect();
    for (column, orientation) in setting.shown.iter().enumerate() {
        let middle = left + pitch * (column as f64 + 0.5);
        let half = (0.36 * pitch).min(46.0);
        draw_bars(&mut picture, setting, &upright, orientation, [middle - half, middle + half], &heights);
        let at = |down: f64| At::new(middle, upright.belt + down);
        picture.canvas.text(at(14.0), Align::Middle, 12.0, INK, true, &format!("edge {}", orientation.edge));
        picture.canvas.text(at(29.0), Align::Middle, 11.0, MUTED, false, &format!("\u{2192} {}", orientation.next));
    }
    picture.canvas.line(&[At::new(left, upright.belt), At::new(right, upright.belt)], Pen::stroke(INK, 1.3));
    lines(&mut picture, setting, &upright, [left, right], planned, &heights);
    picture.bottom = upright.belt + 44.0;
    picture
}

/// The bars of one orientation, named where there is room between the lines of planned pins.
fn draw_bars(
    picture: &mut Picture,
    setting: &Setting,
    upright: &Upright,
    orientation: &Orientation,
    x: [f64; 2],
    lines: &[f64],
) {
    for bar in bars(orientation, &setting.heights, upright) {
        let rect = Rect::new(x, bar.y);
        action::fill(&mut picture.canvas, rect, bar.action);
        picture.canvas.polygon(&rect.corners(), Pen::stroke(INK, 0.8));
        let name = bar.action.map_or("uncertain", PinAction::name);
        let [top, bottom] = widest_between(bar.y, lines);
        let half = 3.0 * name.chars().count() as f64 + 2.0;
        if bottom - top < 15.0 || x[1] - x[0] < 2.0 * half {
            continue;
        }
        let at = At::new((x[0] + x[1]) / 2.0, (top + bottom) / 2.0);
        if bar.action.is_none() {
            let behind = Rect::new([at.x - half, at.x + half], [at.y - 7.0, at.y + 7.0]);
            picture.canvas.polygon(&behind.corners(), Pen::fill("#ffffff", 1.0));
        }
        picture.canvas.text(at, Align::Middle, 11.0, action::ink(bar.action), false, name);
    }
    if let Some([from, to]) = &orientation.repeat_over_dip {
        let [low, high] = [from, to].map(|end| upright.y(setting.heights.share(end)));
        let pen = Pen::stroke(ORANGE, 4.0);
        picture.canvas.line(&[At::new(x[1] + 4.0, low), At::new(x[1] + 4.0, high)], pen);
        picture.legend.add(Swatch::Line(pen), "ducks below the pin while it settles: better avoided");
    }
}

/// The widest part of a bar without a line, from its upper end to its lower one.
fn widest_between([top, bottom]: [f64; 2], lines: &[f64]) -> [f64; 2] {
    // the lines come from the belt up
    let inside = lines.iter().rev().filter(|y| (top..bottom).contains(*y));
    let mut parts = vec![[top, bottom]];
    for y in inside {
        parts.last_mut().expect("starts with one")[1] = y - 3.0;
        parts.push([y + 3.0, bottom]);
    }
    parts.into_iter().max_by(|a, b| (a[1] - a[0]).total_cmp(&(b[1] - b[0]))).expect("starts with one")
}

/// A line through all columns for each height, and its name to the right of them, clear of the other names.
fn lines(
    picture: &mut Picture,
    setting: &Setting,
    upright: &Upright,
    [left, right]: [f64; 2],
    planned: &[Planned],
    heights: &[f64],
) {
    let unit = setting.heights.unit;
    for ((planned, y), name) in planned.iter().zip(heights).zip(apart(heights, upright)) {
        let (through, [from, to]) = ([left, right + 6.0].map(|x| At::new(x, *y)), [right + 6.0, right + 22.0]);
        picture.canvas.line(&through, Pen::stroke("#ffffff", 4.4));
        picture.canvas.line(&through, planned::pen());
        picture.canvas.line(&[At::new(from, *y), At::new(to, name)], Pen::stroke(MUTED, 0.8));
        picture.legend.add(Swatch::Line(planned::pen()), "planned pin, with a dot where the part may meet it");
        for (column, _) in setting.shown.iter().enumerate().filter(|(_, shown)| planned.met.contains(&shown.edge)) {
            let middle = left + (right - left) / setting.shown.len() as f64 * (column as f64 + 0.5);
            let dot = Pen::fill(planned::pen().stroke, 1.0).outlined("#ffffff", 1.2);
            picture.canvas.circle(At::new(middle, *y), 4.6, dot);
        }
        let word = if planned.pins.len() == 1 { "pin" } else { "pins" };
        let which = format!("{word} {}", phrase::joined(&planned.pins, "and"));
        let tolerance = decimal::root_at_least(&(planned.tolerance * planned.tolerance));
        let place = format!("{} \u{b1} {tolerance} {unit}", decimal::brief(planned.height));
        let text = format!("{}: {place}", shortened(&which, 14));
        picture.canvas.text(At::new(right + 26.0, name), Align::Left, 12.0, INK, false, &text);
    }
}

/// Places for names beside `heights`, which come from the belt up: a line apart, no higher than the diagram.
fn apart(heights: &[f64], upright: &Upright) -> Vec<f64> {
    let mut lowest = upright.belt;
    let mut names: Vec<f64> = Vec::new();
    for y in heights {
        names.push(y.min(lowest));
        lowest = y.min(lowest) - LINE;
    }
    // those pushed over the upper end come down again: all of them have room together
    let mut highest = upright.top;
    for name in names.iter_mut().rev() {
        *name = name.max(highest);
        highest = *name + LINE;
    }
    names
}
