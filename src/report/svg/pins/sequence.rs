//! The part before each pin and after the last, as in Fig. 1 of the paper: one row for each orientation that arrives.

use super::super::canvas::{Align, At, Canvas, GREEN, INK, MUTED, Pen};
use super::super::legend::Swatch;
use super::pose::{Pose, key};
use super::{PAGE, Picture, SIDE, Setting, row_length};
use crate::answer::{Orientation, Pin};
use crate::report::{decimal, height};

/// Room for the part with its numbers.
const KEY: f64 = 210.0;
/// So many pins are drawn.
const MOST_PINS: usize = 6;
/// So many orientations beside each other where there are no pins.
const IN_A_ROW: usize = 6;
/// Between two pins.
const WIDEST: f64 = 260.0;
/// Under the belt, for the number of the edge.
const FOOT: f64 = 20.0;
/// Half the width of the band of heights that a pin may have.
const BAND: f64 = 4.5;

/// Draws the pins and what they do, or the orientations if there are no pins.
pub(super) fn draw(setting: &Setting) -> Picture {
    match setting.answer.plan.sequence.as_deref() {
        None | Some([]) => orientations(setting),
        Some(pins) => rows(setting, pins),
    }
}

/// A pin, seen from its end, in the band of heights that it may have.
pub(in super::super) fn pin(canvas: &mut Canvas, at: At, band: [f64; 2]) {
    let [top, bottom] = band;
    let corner = |x: f64, y: f64| At::new(at.x + x * BAND, y);
    let corners = [corner(-1.0, top), corner(1.0, top), corner(1.0, bottom), corner(-1.0, bottom)];
    canvas.polygon(&corners, Pen::fill(GREEN, 0.3).outlined(GREEN, 1.0));
    canvas.circle(at, 2.8, Pen::fill(INK, 1.0));
}

fn orientations(setting: &Setting) -> Picture {
    let remark = remark(setting, &["the part in every orientation that it may have"]);
    let mut picture = Picture::new("Stable orientations", &remark);
    let columns = row_length(setting.shown.len(), IN_A_ROW);
    let left = SIDE + KEY;
    let grid = Grid::new(setting, left, columns, 0.0, 150.0);
    let top = picture.bottom;
    for (row, orientations) in setting.shown.chunks(columns).enumerate() {
        let belt = grid.belt(top, row);
        let end = left + grid.column * orientations.len() as f64;
        draw_belt(&mut picture.canvas, belt, [left, end]);
        for (column, orientation) in orientations.iter().enumerate() {
            grid.part(&mut picture.canvas, setting, column, belt, orientation.edge);
        }
    }
    let rows = setting.shown.len().div_ceil(columns);
    picture.bottom = top + grid.pitch * rows as f64;
    close(picture, setting, top)
}

fn rows(setting: &Setting, pins: &[Pin]) -> Picture {
    let drawn = &pins[..pins.len().min(MOST_PINS)];
    let fewer = format!("the first {} of {} pins", drawn.len(), pins.len());
    let moving =
        "each row is the belt, moving to the right, with the part as it may arrive and what the pins make of it";
    let remark = remark(setting, &[moving, if drawn.len() < pins.len() { &fewer } else { "" }]);
    let mut picture = Picture::new("Sequence of pins", &remark);
    let left = SIDE + KEY;
    let grid = Grid::new(setting, left, drawn.len() + 1, 2.0 * BAND + 14.0, 600.0 / setting.shown.len() as f64);
    let top = picture.bottom + 56.0;
    let bottom = top + grid.pitch * setting.shown.len() as f64;
    for (index, pin) in drawn.iter().enumerate() {
        let x = grid.pin(left, index);
        let rule = [At::new(x, top), At::new(x, bottom - FOOT)];
        picture.canvas.line(&rule, Pen::stroke("#d5d9dd", 1.0));
        name(&mut picture.canvas, setting, At::new(x, picture.bottom + 10.0), index, pin);
    }
    for (row, orientation) in setting.shown.iter().enumerate() {
        let belt = grid.belt(top, row);
        draw_belt(&mut picture.canvas, belt, [left, left + grid.column * (drawn.len() + 1) as f64]);
        for (column, edge) in way(setting, orientation, drawn).into_iter().enumerate() {
            grid.part(&mut picture.canvas, setting, column, belt, edge);
        }
        for (index, planned) in drawn.iter().enumerate() {
            let y = |share: f64| belt - share * grid.pixels;
            let band = [&planned.high, &planned.low].map(|end| y(setting.heights.share(end)));
            pin(
                &mut picture.canvas,
                At::new(grid.pin(left, index), y(setting.heights.share_of(&planned.height))),
                band,
            );
        }
    }
    picture.bottom = bottom;
    picture.legend.add(Swatch::Pin, "pin at its recommended height, and the heights that do the same");
    close(picture, setting, top)
}

/// The belt, with an arrow to where it moves.
fn draw_belt(canvas: &mut Canvas, y: f64, [left, right]: [f64; 2]) {
    canvas.arrow(At::new(left, y), At::new(right, y), MUTED, 2.4);
}

fn close(mut picture: Picture, setting: &Setting, top: f64) -> Picture {
    picture.legend.add(Swatch::CenterOfMass, "center of mass");
    let frame = [At::new(SIDE, top), At::new(SIDE + KEY - 20.0, (top + KEY).min(picture.bottom - 14.0))];
    key(&mut picture.canvas, setting, frame);
    picture
}

/// The edges on which the part lies before each pin and after the last, as far as the pins say.
fn way(setting: &Setting, first: &Orientation, pins: &[Pin]) -> Vec<usize> {
    let mut way = vec![first.edge];
    let twins = |edge: usize| setting.answer.symmetry.classes.iter().find(move |class| class.contains(&edge));
    for pin in pins {
        let edge = way[way.len() - 1];
        // a pin may name one of the edges that look the same
        let alike = twins(edge).into_iter().flatten().find_map(|twin| pin.outcome.get(twin));
        let Some(next) = pin.outcome.get(&edge).or(alike) else { break };
        way.push(*next);
    }
    way
}

fn name(canvas: &mut Canvas, setting: &Setting, at: At, index: usize, pin: &Pin) {
    let unit = setting.heights.unit;
    let height = decimal::brief(&pin.height);
    let tolerance = decimal::root_at_least(&(&pin.tolerance * &pin.tolerance));
    canvas.text(at, Align::Middle, 12.0, INK, true, &format!("pin {}", index + 1));
    let place = format!("{height} {unit} \u{b1} {tolerance} {unit}");
    canvas.text(At::new(at.x, at.y + 15.0), Align::Middle, 12.0, INK, false, &place);
    let same = match height::between(&pin.low, &pin.high) {
        decimal::Span::Between(low, high) => format!("{low} to {high} {unit}"),
        decimal::Span::Single(_) => return,
    };
    canvas.text(At::new(at.x, at.y + 30.0), Align::Middle, 11.0, MUTED, false, &same);
}

/// Where the small pictures are.
struct Grid {
    left: f64,
    column: f64,
    /// Beside each part, for the pin.
    beside: f64,
    pitch: f64,
    /// Pixels of the part's larger side.
    pixels: f64,
}

impl Grid {
    fn new(setting: &Setting, left: f64, columns: usize, beside: f64, tallest: f64) -> Self {
        let column = ((PAGE - SIDE - left) / columns as f64).min(WIDEST);
        let pitch = tallest.clamp(66.0, 140.0);
        let widest = setting.shown.iter().map(|shown| Pose::new(setting, shown.edge).half).fold(1e-9, f64::max);
        let wide = (column - beside - 24.0) / (2.0 * widest);
        let pixels = wide.min((pitch - FOOT - 12.0) / setting.heights.tallest);
        Self { left, column, beside, pitch, pixels }
    }

    fn belt(&self, top: f64, row: usize) -> f64 {
        top + self.pitch * (row + 1) as f64 - FOOT
    }

    fn pin(&self, left: f64, index: usize) -> f64 {
        left + self.column * (index + 1) as f64 - self.beside / 2.0
    }

    fn part(&self, canvas: &mut Canvas, setting: &Setting, column: usize, belt: f64, edge: usize) {
        let x = self.left + self.column * (column as f64 + 0.5) - self.beside / 2.0;
        Pose::new(setting, edge).draw(canvas, At::new(x, belt - 1.2), self.pixels);
        canvas.text(At::new(x, belt + 11.0), Align::Middle, 11.0, MUTED, false, &format!("edge {edge}"));
    }
}

fn remark(setting: &Setting, said: &[&str]) -> String {
    let left_out = super::left_out(setting);
    let said = said.iter().copied().chain([left_out.as_str()]);
    said.filter(|text| !text.is_empty()).collect::<Vec<_>>().join("; ")
}
