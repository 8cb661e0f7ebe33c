//! A device with its dimensions, as Fig. 6 of the paper.

use super::super::canvas::{At, BLUE, Canvas, INK, Pen};
use super::super::label::Labels;
use super::super::scene::scale_bar;
use super::super::view::along;
use super::panel::{Room, extent, obstacle};
use crate::model::Dimension;
use crate::report::decimal::near;
use crate::report::motion::Outline;
use std::f64::consts::TAU;

/// Around what is measured, over its size.
const SPARE: f64 = 0.1;
/// Pixels between the tips of an arrow with two heads, at least.
const ARROW: f64 = 22.0;
/// Largest radius of the arc of an angle, in pixels.
const RADIUS: f64 = 46.0;
const WIDTH: f64 = 1.3;

/// The outlines of a device, and what is measured of it (m).
pub(super) struct Dimensioned {
    pub(super) fixed: Vec<Outline>,
    pub(super) dimensions: Vec<Dimension>,
}

impl Dimensioned {
    /// The corners of what it shows: lower left, upper right.
    pub(super) fn frame(&self) -> [[f64; 2]; 2] {
        let points = || self.dimensions.iter().flat_map(|one| one.ends.iter().chain(&one.corner));
        let end = |axis: usize, far: f64| points().map(|point| point[axis] * far).fold(f64::MIN, f64::max) * far;
        let [low, high] = [-1.0, 1.0].map(|far| [end(0, far), end(1, far)]);
        let spare = SPARE * (high[0] - low[0]).max(high[1] - low[1]).max(1e-9);
        [low.map(|entry| entry - spare), high.map(|entry| entry + spare)]
    }

    pub(super) fn draw(&self, canvas: &mut Canvas, middle: [f64; 2], room: &Room) {
        let place = room.centered(middle);
        let mut labels = Labels::within([room.low, room.high]).rimmed();
        for outline in &self.fixed {
            obstacle(canvas, outline, room, &place);
            let corners: Vec<At> = extent(outline).into_iter().map(&place).collect();
            let next = corners.iter().cycle().skip(1);
            corners.iter().zip(next).for_each(|(from, to)| labels.avoid(&along(*from, *to)));
        }
        for dimension in &self.dimensions {
            let [from, to] = dimension.ends.map(&place);
            match dimension.corner.map(&place) {
                None => distance(canvas, &mut labels, dimension, from, to),
                Some(corner) => angle(canvas, &mut labels, dimension, corner, [from, to]),
            }
        }
        labels.draw(canvas);
        let rim = [room.low, At::new(room.high.x, room.low.y), room.high, At::new(room.low.x, room.high.y)];
        canvas.polygon(&rim, Pen::stroke("#d5d9dd", 1.0));
        scale_bar(canvas, At::new(room.high.x - 1.0, room.high.y + super::panel::FOOT), 1.0 / room.scale, "m");
    }
}

fn distance(canvas: &mut Canvas, labels: &mut Labels, dimension: &Dimension, from: At, to: At) {
    let [a, b] = dimension.ends;
    let way = to.minus(from);
    if way.length() >= ARROW {
        let middle = from.along(way, 0.5);
        canvas.arrow(middle, from, BLUE, WIDTH);
        canvas.arrow(middle, to, BLUE, WIDTH);
    } else {
        canvas.line(&[from, to], Pen::stroke(BLUE, 2.0 * WIDTH));
        [from, to].into_iter().for_each(|end| canvas.circle(end, 2.0, Pen::fill(BLUE, 1.0)));
    }
    labels.avoid(&along(from, to));
    let text = format!("{} {} mm", dimension.name, near(1e3 * (b[0] - a[0]).hypot(b[1] - a[1]), 3));
    labels.want(from.along(way, 0.5), way.normalized().turned(), 7.0, INK, false, text);
}

/// The smaller of the two angles between the sides.
fn angle(canvas: &mut Canvas, labels: &mut Labels, dimension: &Dimension, corner: At, ends: [At; 2]) {
    let [from, to] = ends.map(|end| {
        let way = end.minus(corner);
        (-way.y).atan2(way.x)
    });
    let ahead = (to - from).rem_euclid(TAU);
    let (start, sweep) = if ahead <= TAU / 2.0 { (from, ahead) } else { (to, TAU - ahead) };
    let reach = ends.map(|end| end.minus(corner).length());
    let radius = RADIUS.min(0.9 * reach[0].min(reach[1]));
    for end in ends {
        canvas.line(&[corner, end], Pen::stroke(BLUE, 0.8).dashed());
        labels.avoid(&along(corner, end));
    }
    canvas.arc(corner, radius, start, sweep, false, Pen::stroke(BLUE, WIDTH));
    let outward = At::unit(start + sweep / 2.0);
    let text = format!("{} {}°", dimension.name, near(sweep.to_degrees(), 3));
    labels.want(corner.along(outward, radius), outward, 7.0, INK, false, text);
}
