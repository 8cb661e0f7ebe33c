//! The part on the arm before each throw of one cycle.

use super::super::canvas::{Align, At, Canvas, INK, MUTED, Pen};
use super::super::legend::Swatch;
use super::super::scene::quartered;
use super::cycle::{cycle, order};
use super::mark::{self, Mark};
use super::pose::{COM, Pose};
use super::{PAGE, Picture, SIDE, Setting};
use crate::exact::to_f64;
use crate::report::decimal;

/// Longer cycles show runs of jogs by their first and last pose.
const MOST_WHOLE: usize = 12;
/// So many poses are drawn.
const MOST: usize = 24;
const COLUMNS: usize = 4;
/// Right of each pose, for the jogs that are left out.
const BETWEEN: f64 = 22.0;
/// Under the arm.
const FOOT: f64 = 34.0;
const TALLEST: f64 = 150.0;

/// A pose in a row.
struct Shown {
    /// Zero if the poses do not follow each other.
    number: usize,
    edge: usize,
    radius: f64,
    /// Jogs after it that are left out.
    left_out: usize,
}

/// Draws the poses of one cycle, or of every stable edge if no limit set was found.
pub(super) fn draw(setting: &Setting) -> Option<Picture> {
    let per = to_f64(&setting.size);
    let poses = match setting.set() {
        Some(set) => of_cycle(cycle(set)),
        None => at_rest(setting),
    };
    let is_drawable = |shown: &Shown| {
        let share = shown.radius / per;
        share.is_finite() && share.abs() < 1e6 && setting.lane(shown.edge).is_some_and(|(_, lane)| lane.pose.is_some())
    };
    let all: Vec<Shown> = poses.into_iter().filter(is_drawable).collect();
    if all.is_empty() {
        return None;
    }
    let shown = &all[..all.len().min(MOST)];
    let mut picture = heading(setting, all.len());
    let grid = Grid::new(setting, shown, per);
    for (cell, pose) in shown.iter().enumerate() {
        let next = all.get(cell + 1).filter(|_| setting.set().is_some());
        grid.draw(&mut picture, setting, cell, pose, next);
    }
    picture.bottom += grid.tall * shown.len().div_ceil(COLUMNS) as f64;
    Some(picture)
}

fn heading(setting: &Setting, count: usize) -> Picture {
    let Some(set) = setting.set() else {
        return Picture::new("Poses", &["each stable edge at the least radius from which it can be thrown"]);
    };
    let (before, throws) = match cycle(set) {
        [before @ .., _] => (before, before.len()),
        [] => (&[][..], 0),
    };
    let edges: Vec<String> = order(before).iter().map(ToString::to_string).collect();
    let pattern = if edges.len() > 1 { format!("on edges {}", edges.join(", ")) } else { String::new() };
    let period = set.period.map_or(String::new(), |period| format!("the orbit repeats after {period}"));
    let fewer = if count > MOST { format!("the first {MOST} of {count} poses") } else { String::new() };
    let about = format!("the part before each of {throws} throws, and after the last");
    Picture::new("One cycle", &[&about, &pattern, &period, &fewer])
}

/// The states of a cycle; the inner ones of long runs on one edge are left out if there are many.
fn of_cycle(states: &[(usize, f64)]) -> Vec<Shown> {
    let is_kept = |place: usize| {
        let same = |other: Option<usize>| other.and_then(|k| states.get(k)).is_some_and(|(e, _)| *e == states[place].0);
        states.len() <= MOST_WHOLE + 1 || !(same(place.checked_sub(1)) && same(Some(place + 1)))
    };
    let mut shown: Vec<Shown> = Vec::new();
    for (place, (edge, radius)) in states.iter().enumerate() {
        if is_kept(place) {
            shown.push(Shown { number: place + 1, edge: *edge, radius: *radius, left_out: 0 });
        } else if let Some(last) = shown.last_mut() {
            last.left_out += 1;
        }
    }
    shown
}

fn at_rest(setting: &Setting) -> Vec<Shown> {
    let pose = |lane: &super::Lane| Some(Shown { number: 0, edge: lane.edge, radius: lane.reach?.r_low, left_out: 0 });
    setting.lanes.iter().filter_map(pose).collect()
}

/// Where the poses are, in shares of the part's size.
struct Grid {
    per: f64,
    wide: f64,
    tall: f64,
    pixels: f64,
    /// x at the left of a cell: that of the pivot, unless the part is far from it.
    low: f64,
    /// Height of the arm's surface over the bottom of a cell, in pixels.
    floor: f64,
    /// Height of the pivot over the arm's surface; `None` if it would not fit.
    pivot: Option<f64>,
}

impl Grid {
    fn new(setting: &Setting, shown: &[Shown], per: f64) -> Self {
        let poses: Vec<(&Pose, f64)> =
            shown.iter().filter_map(|s| Some((of(setting, s.edge)?, s.radius / per))).collect();
        let left = poses.iter().map(|(pose, x)| x + pose.sides()[0]).fold(f64::INFINITY, f64::min);
        let right = poses.iter().map(|(pose, x)| x + pose.sides()[1]).fold(0.0, f64::max);
        let height = poses.iter().map(|(pose, _)| pose.height()).fold(0.1, f64::max);
        let is_far = left > 0.6 * right && right > 3.0;
        let low = if is_far { left - 0.2 * (right - left) - 0.2 } else { left.min(0.0) - 0.05 };
        let wide = (PAGE - 2.0 * SIDE) / COLUMNS as f64;
        let pivot = Some(-to_f64(&setting.toss.thrower.offset) / per).filter(|y| y.abs() < 1.2 * height && !is_far);
        let [below, above] = [pivot.unwrap_or(0.0).min(0.0), pivot.unwrap_or(0.0).max(height)];
        let pixels = ((wide - BETWEEN) / (right - low + 0.05)).min(TALLEST / (above - below));
        let floor = FOOT - below * pixels;
        Self { per, wide, tall: (above - below) * pixels + FOOT + 16.0, pixels, low, floor, pivot }
    }

    fn draw(&self, picture: &mut Picture, setting: &Setting, cell: usize, shown: &Shown, next: Option<&Shown>) {
        let left = SIDE + self.wide * (cell % COLUMNS) as f64;
        let surface = picture.bottom + self.tall * (cell / COLUMNS + 1) as f64 - self.floor;
        let right = left + self.wide - BETWEEN;
        let x = |share: f64| left + (share - self.low) * self.pixels;
        let Some((_, lane)) = setting.lane(shown.edge) else { return };
        let Some(pose) = &lane.pose else { return };
        self.draw_arm(&mut picture.canvas, [left, right], surface, x(0.0));
        picture.legend.add(Swatch::Throw(Mark::Arm), "arm and its pivot");
        let foot = At::new(x(shown.radius / self.per), surface);
        pose.draw(&mut picture.canvas, foot, self.pixels, lane.hue.band());
        picture.legend.add(Swatch::CenterOfMass, "center of mass");
        let next = next.filter(|_| shown.left_out == 0).and_then(|next| Some((of(setting, next.edge)?, next.radius)));
        if let Some((other, radius)) = next {
            let from = At::new(foot.x, foot.y - pose.com * self.pixels);
            let to = At::new(x(radius / self.per), surface - other.com * self.pixels);
            picture.canvas.line(&[from, to], Pen::stroke(MUTED, 1.0).dashed());
            mark::next_place(&mut picture.canvas, to);
            quartered(&mut picture.canvas, from, COM);
            picture.legend.add(Swatch::Throw(Mark::NextPlace), "where it comes to rest next");
        }
        self.draw_sensor(picture, setting, shown, surface, &x, [left, right]);
        let below = picture.bottom + self.tall * (cell / COLUMNS + 1) as f64 - 12.0;
        let name = if shown.number > 0 { shown.number.to_string() } else { String::new() };
        picture.canvas.text(At::new(left, below), Align::Left, 12.0, INK, true, &name);
        let place = format!("edge {}, {} {}", shown.edge, decimal::near(shown.radius, 4), setting.unit());
        let after = if name.is_empty() { left } else { left + 8.0 + 7.2 * name.len() as f64 };
        picture.canvas.text(At::new(after, below), Align::Left, 11.0, MUTED, false, &place);
        if shown.left_out > 0 {
            let word = if shown.left_out == 1 { "jog" } else { "jogs" };
            let text = format!("{} more {word} \u{2192}", shown.left_out);
            picture.canvas.text(At::new(left + self.wide - 8.0, below), Align::Right, 11.0, INK, false, &text);
        }
    }

    fn draw_arm(&self, canvas: &mut Canvas, [left, right]: [f64; 2], surface: f64, pivot: f64) {
        match self.pivot {
            Some(height) => mark::arm(canvas, At::new(pivot, surface - height * self.pixels), surface, right),
            None => {
                mark::arm(canvas, At::new(left + 4.0, surface), surface, right);
                // the arm is cut short between the strokes
                let stroke = |x: f64| vec![At::new(x - 2.5, surface + 6.0), At::new(x + 2.5, surface - 6.0)];
                let gap = [At::new(left + 12.0, surface), At::new(left + 16.0, surface)];
                canvas.line(&gap, Pen::stroke("#ffffff", 3.0));
                canvas.lines(&[stroke(left + 12.0), stroke(left + 16.0)], Pen::stroke(MUTED, 1.2));
            }
        }
    }

    fn draw_sensor(
        &self,
        picture: &mut Picture,
        setting: &Setting,
        shown: &Shown,
        surface: f64,
        x: &impl Fn(f64) -> f64,
        [left, right]: [f64; 2],
    ) {
        let Some(window) = setting.answer.window() else { return };
        let at = x(window.at / self.per);
        if !(left..=right).contains(&at) {
            return;
        }
        let ends = setting.lane(shown.edge).map_or([0.0, 0.0], |(_, lane)| lane.ends);
        let is_covered = shown.radius + ends[0] <= window.at && window.at <= shown.radius + ends[1];
        mark::sensor(&mut picture.canvas, At::new(at, surface + 2.0), is_covered);
        let meaning = if is_covered { "sensor, covered" } else { "sensor, not covered" };
        picture.legend.add(Swatch::Throw(Mark::Sensor(is_covered)), meaning);
    }
}

fn of<'a>(setting: &'a Setting, edge: usize) -> Option<&'a Pose> {
    setting.lanes.iter().find(|lane| lane.edge == edge)?.pose.as_ref()
}
