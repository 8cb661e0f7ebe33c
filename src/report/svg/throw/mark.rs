//! The looks of edges, and small marks.

use super::super::canvas::{At, BLUE, Canvas, GREEN, INK, MUTED, ORANGE, PINK, Pen, SKY};
use super::super::simulation::hatching;

/// Green is for sensors, red for what leaves.
const COLOURS: [&str; 6] = [BLUE, ORANGE, PINK, SKY, INK, MUTED];
const HATCH: &str = "#c2c8ce";
const WHITE: &str = "#ffffff";

/// How what belongs to an edge is inked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in super::super) struct Hue {
    pub(super) colour: &'static str,
    /// The colours have been used before: dots are rings.
    is_ring: bool,
}

impl Hue {
    pub(super) fn of(lane: usize) -> Self {
        Self { colour: COLOURS[lane % COLOURS.len()], is_ring: lane >= COLOURS.len() }
    }

    pub(super) fn dot(self, canvas: &mut Canvas, at: At, radius: f64) {
        let pen = if self.is_ring {
            Pen::fill(WHITE, 1.0).outlined(self.colour, 1.2)
        } else {
            Pen::fill(self.colour, 1.0).outlined(WHITE, 0.5)
        };
        canvas.circle(at, radius, pen);
    }

    /// Bars of an edge: paler if the colour has been used before.
    pub(super) fn bar(self) -> Pen {
        Pen::fill(self.colour, if self.is_ring { 0.25 } else { 0.75 }).outlined(self.colour, 1.0)
    }

    pub(super) fn band(self) -> Pen {
        Pen::fill(self.colour, if self.is_ring { 0.08 } else { 0.2 }).outlined(self.colour, 1.0)
    }

    /// Small squares, as one mark.
    pub(super) fn specks(self, canvas: &mut Canvas, places: &[At]) {
        let speck = |half: f64| {
            let line = move |at: &At| vec![At::new(at.x - half, at.y), At::new(at.x + half, at.y)];
            places.iter().map(line).collect::<Vec<_>>()
        };
        canvas.lines(&speck(1.5), Pen::stroke(self.colour, 3.0));
        if self.is_ring {
            canvas.lines(&speck(0.6), Pen::stroke(WHITE, 1.2));
        }
    }
}

/// A mark of the legend.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in super::super) enum Mark {
    Area(Pen),
    Hatched,
    Dot(Hue),
    Jog,
    Flip,
    Diamond,
    Cross,
    Upright(Pen),
    /// Whether it is covered.
    Sensor(bool),
    Arm,
    NextPlace,
    Best,
    Own,
}

/// A small picture of a mark.
pub(in super::super) fn sample(canvas: &mut Canvas, at: At, mark: Mark) {
    let (left, right) = (At::new(at.x - 11.0, at.y), At::new(at.x + 11.0, at.y));
    let area = rectangle([left.x, right.x], [at.y - 6.0, at.y + 6.0]);
    match mark {
        Mark::Area(pen) => canvas.polygon(&area, pen),
        Mark::Hatched => hatched(canvas, &area),
        Mark::Dot(hue) => hue.dot(canvas, at, 4.0),
        Mark::Jog => hop(canvas, At::new(left.x, at.y + 5.0), At::new(right.x, at.y + 5.0), MUTED),
        Mark::Flip => canvas.arrow(At::new(left.x, at.y - 5.0), At::new(right.x, at.y + 5.0), MUTED, 1.1),
        Mark::Diamond => diamond(canvas, at, INK),
        Mark::Cross => cross(canvas, at),
        Mark::Upright(pen) => canvas.line(&[At::new(at.x, at.y - 8.0), At::new(at.x, at.y + 8.0)], pen),
        Mark::Sensor(is_covered) => sensor(canvas, At::new(at.x, at.y - 4.0), is_covered),
        Mark::Arm => arm(canvas, At::new(left.x + 3.0, at.y), left.y, right.x),
        Mark::NextPlace => {
            canvas.line(&[left, right], Pen::stroke(MUTED, 1.0).dashed());
            next_place(canvas, right);
        }
        Mark::Best => best(canvas, at),
        Mark::Own => own(canvas, at),
    }
}

pub(super) fn rectangle(x: [f64; 2], y: [f64; 2]) -> [At; 4] {
    [At::new(x[0], y[0]), At::new(x[1], y[0]), At::new(x[1], y[1]), At::new(x[0], y[1])]
}

pub(super) fn hatched(canvas: &mut Canvas, area: &[At]) {
    canvas.polygon(area, Pen::fill("#f3f5f7", 1.0));
    canvas.lines(&hatching(area), Pen::stroke(HATCH, 0.9));
}

/// An arc from one place on a line to another: above it outward, below it inward.
pub(super) fn hop(canvas: &mut Canvas, from: At, to: At, colour: &'static str) {
    const STEPS: u32 = 12;
    let across = to.x - from.x;
    if across.abs() < 1.5 {
        let center = At::new(from.x, from.y - 6.0);
        return canvas.circle(center, 5.0, Pen::stroke(colour, 1.1));
    }
    let rise = (0.3 * across.abs() + 5.0).min(19.0) * across.signum();
    let point = |step: u32| {
        let [sin, cos] = <[f64; 2]>::from((f64::from(step) / f64::from(STEPS) * std::f64::consts::PI).sin_cos());
        At::new(from.x + across * (1.0 - cos) / 2.0, from.y - rise * sin)
    };
    let points: Vec<At> = (0..=STEPS).map(point).collect();
    if across.abs() < 9.0 {
        return canvas.line(&points, Pen::stroke(colour, 1.1));
    }
    let last = points.len() - 3;
    canvas.line(&points[..=last], Pen::stroke(colour, 1.1));
    canvas.arrow(points[last], to, colour, 1.1);
}

pub(super) fn diamond(canvas: &mut Canvas, at: At, colour: &'static str) {
    let corner = |x: f64, y: f64| At::new(at.x + x, at.y + y);
    let corners = [corner(-4.0, 0.0), corner(0.0, -4.5), corner(4.0, 0.0), corner(0.0, 4.5)];
    canvas.polygon(&corners, Pen::fill(WHITE, 1.0).outlined(colour, 1.3));
}

pub(super) fn cross(canvas: &mut Canvas, at: At) {
    let stroke = |x: f64, y: f64| vec![At::new(at.x - x, at.y - y), At::new(at.x + x, at.y + y)];
    canvas.lines(&[stroke(4.5, 4.5), stroke(4.5, -4.5)], Pen::stroke(WHITE, 4.5));
    canvas.lines(&[stroke(4.0, 4.0), stroke(4.0, -4.0)], Pen::stroke(INK, 2.0));
}

/// A sensor that looks up from `at`.
pub(super) fn sensor(canvas: &mut Canvas, at: At, is_covered: bool) {
    let corners = [at, At::new(at.x + 5.0, at.y + 9.0), At::new(at.x - 5.0, at.y + 9.0)];
    let pen = if is_covered { Pen::fill(GREEN, 1.0) } else { Pen::fill(WHITE, 1.0) };
    canvas.polygon(&corners, pen.outlined(GREEN, 1.4));
}

/// The arm from its pivot, with its surface at the height `surface`.
pub(super) fn arm(canvas: &mut Canvas, pivot: At, surface: f64, right: f64) {
    canvas.line(&[At::new(pivot.x, surface), At::new(right, surface)], Pen::stroke(MUTED, 2.0));
    canvas.line(&[At::new(pivot.x, surface), pivot], Pen::stroke(MUTED, 2.0));
    canvas.circle(pivot, 3.2, Pen::fill(WHITE, 1.0).outlined(INK, 1.4));
}

pub(super) fn next_place(canvas: &mut Canvas, at: At) {
    canvas.circle(at, 2.6, Pen::fill(WHITE, 1.0).outlined(MUTED, 1.1));
}

pub(super) fn best(canvas: &mut Canvas, at: At) {
    canvas.circle(at, 7.0, Pen::stroke(WHITE, 4.5));
    canvas.circle(at, 7.0, Pen::stroke(INK, 2.2));
}

pub(super) fn own(canvas: &mut Canvas, at: At) {
    let stroke = |x: f64, y: f64| vec![At::new(at.x - x, at.y - y), At::new(at.x + x, at.y + y)];
    canvas.lines(&[stroke(6.5, 0.0), stroke(0.0, 6.5)], Pen::stroke(WHITE, 5.0));
    canvas.lines(&[stroke(6.0, 0.0), stroke(0.0, 6.0)], Pen::stroke(INK, 2.0));
}
