//! The pin action diagram, as in Fig. 9 of the paper: what a pin of any height does to every orientation.

use super::super::canvas::{Align, At, Canvas, GREEN, INK, MUTED, ORANGE, Pen};
use super::super::legend::Swatch;
use super::super::scene::shortened;
use super::action::{self, Rect};
use super::axis::Upright;
use super::bars::bars;
use super::{PAGE, Picture, SIDE, Setting};
use crate::answer::{Orientation, PinAction};
use crate::exact::Q;
use crate::report::{decimal, phrase};

const HEIGHT: f64 = 290.0;
/// Left of the bars, for the axis.
const AXIS: f64 = 52.0;
/// Right of the bars, for the names of the pins.
const NAMES: f64 = 190.0;
/// Between the names of two pins.
const LINE: f64 = 14.0;
/// So many heights of pins have room beside the bars.
const MOST_LINES: usize = (HEIGHT / LINE) as usize;

/// Draws the pin action diagram with the planned pins.
pub(super) fn draw(setting: &Setting) -> Picture {
    let planned = planned(setting);
    let mut remark = super::left_out(setting);
    if planned.len() > MOST_LINES {
        let also = format!("the first {MOST_LINES} of {} heights of pins", planned.len());
        remark = if remark.is_empty() { also } else { format!("{remark}; {also}") };
    }
    let mut picture = Picture::new("Pin action diagram", &remark);
    let top = picture.bottom + 24.0;
    let upright = Upright::new(&setting.heights, top, top + HEIGHT);
    let (left, right) = (SIDE + AXIS, PAGE - SIDE - NAMES);
    upright.draw(&mut picture.canvas, &setting.heights, left, right);
    let pitch = ((right - left) / setting.shown.len().max(1) as f64).min(190.0);
    for (column, orientation) in setting.shown.iter().enumerate() {
        let middle = left + pitch * (column as f64 + 0.5);
        let half = (0.36 * pitch).min(46.0);
        bar(&mut picture, setting, &upright, orientation, [middle - half, middle + half]);
        let name = |canvas: &mut Canvas, down: f64, colour, bold, text: &str| {
            canvas.text(At::new(middle, upright.belt + down), Align::Middle, 12.0, colour, bold, text);
        };
        name(&mut picture.canvas, 13.0, INK, true, &format!("edge {}", orientation.edge));
        name(&mut picture.canvas, 28.0, MUTED, false, &format!("topples onto {}", orientation.next));
    }
    picture.canvas.line(&[At::new(left, upright.belt), At::new(right, upright.belt)], Pen::stroke(INK, 1.3));
    let end = left + pitch * setting.shown.len() as f64;
    lines(&mut picture, setting, &upright, [left, end], &planned[..planned.len().min(MOST_LINES)]);
    picture.bottom = upright.belt + 44.0;
    picture
}

fn bar(picture: &mut Picture, setting: &Setting, upright: &Upright, orientation: &Orientation, x: [f64; 2]) {
    for bar in bars(orientation, &setting.heights, upright) {
        let rect = Rect::new(x, bar.y);
        action::fill(&mut picture.canvas, rect, bar.action);
        picture.canvas.polygon(&rect.corners(), Pen::stroke(INK, 0.8));
        picture.legend.add(Swatch::PinAction(bar.action), action::meaning(bar.action));
        let name = bar.action.map_or("uncertain", PinAction::name);
        let room = bar.y[1] - bar.y[0] > 15.0 && x[1] - x[0] > 6.0 * name.chars().count() as f64 + 4.0;
        if room {
            let at = At::new((x[0] + x[1]) / 2.0, (bar.y[0] + bar.y[1]) / 2.0);
            if bar.action.is_none() {
                let half = 3.0 * name.chars().count() as f64 + 3.0;
                let behind = Rect::new([at.x - half, at.x + half], [at.y - 7.0, at.y + 7.0]);
                picture.canvas.polygon(&behind.corners(), Pen::fill("#ffffff", 1.0));
            }
            picture.canvas.text(at, Align::Middle, 11.0, action::ink(bar.action), false, name);
        }
    }
    for [from, to] in &orientation.repeat_over_dip {
        let [low, high] = [from, to].map(|end| upright.y(setting.heights.share(end)));
        let pen = Pen::stroke(ORANGE, 4.0);
        picture.canvas.line(&[At::new(x[1] + 3.0, low), At::new(x[1] + 3.0, high)], pen);
        picture.legend.add(Swatch::Line(pen), "ducks below the pin while it settles: better avoided");
    }
}

/// Heights of planned pins from the belt up, and which pins have them, counted from one.
fn planned<'a>(setting: &Setting<'a>) -> Vec<(&'a Q, &'a Q, Vec<String>)> {
    let mut planned: Vec<(&Q, &Q, Vec<String>)> = Vec::new();
    for (index, pin) in setting.answer.plan.sequence.iter().flatten().enumerate() {
        let number = (index + 1).to_string();
        match planned.iter_mut().find(|(height, ..)| *height == &pin.height) {
            Some((_, _, numbers)) => numbers.push(number),
            None => planned.push((&pin.height, &pin.tolerance, vec![number])),
        }
    }
    planned.sort_by_key(|(height, ..)| *height);
    planned
}

/// A line through all columns for each height, and its name to the right of them, clear of the other names.
fn lines(picture: &mut Picture, setting: &Setting, upright: &Upright, x: [f64; 2], planned: &[(&Q, &Q, Vec<String>)]) {
    let unit = setting.heights.unit;
    let mut lowest = upright.belt;
    let mut names = Vec::new();
    for (height, _, _) in planned {
        let y = upright.y(setting.heights.share_of(height));
        let name = y.min(lowest);
        names.push([y, name]);
        lowest = name - LINE;
    }
    // names that were pushed over the upper end come down again, all of them having room together
    let mut highest = upright.top;
    for [_, name] in names.iter_mut().rev() {
        *name = name.max(highest);
        highest = *name + LINE;
    }
    for ((height, tolerance, numbers), [y, name]) in planned.iter().zip(names) {
        let line = [At::new(x[0], y), At::new(x[1] + 6.0, y), At::new(x[1] + 18.0, name), At::new(x[1] + 22.0, name)];
        picture.canvas.line(&line[..2], Pen::stroke("#ffffff", 4.4));
        picture.canvas.line(&line, Pen::stroke(GREEN, 2.0));
        let pins = if numbers.len() == 1 { "pin" } else { "pins" };
        let tolerance = decimal::root_at_least(&(*tolerance * *tolerance));
        let which = format!("{pins} {}", phrase::joined(numbers, "and"));
        let text = format!("{}: {} \u{b1} {tolerance} {unit}", shortened(&which, 14), decimal::brief(height));
        picture.canvas.text(At::new(x[1] + 26.0, name), Align::Left, 12.0, INK, false, &text);
        picture.legend.add(Swatch::Line(Pen::stroke(GREEN, 2.0)), "planned pin");
    }
}
