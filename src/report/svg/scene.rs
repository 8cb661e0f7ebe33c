//! The part on its page, with what is drawn around it.

use super::super::Subject;
use super::canvas::{Align, At, Canvas, INK, MUTED, PART, Pen};
use super::label::Labels;
use super::legend::{Legend, Swatch};
use super::view::{HEADER, Outline, View, WIDTH};
use crate::model::Part;
use num_traits::Zero as _;

/// Radius of the symbol of the center of mass.
pub(super) const COM: f64 = 6.5;

/// A drawing under construction.
pub(super) struct Scene {
    pub(super) canvas: Canvas,
    pub(super) view: View,
    pub(super) labels: Labels,
    pub(super) legend: Legend,
    pub(super) com: At,
    unit: &'static str,
}

impl Scene {
    /// The part, its center of mass still to come: it lies above everything else.
    pub(super) fn new(subject: &Subject) -> Self {
        let view = View::new(subject.part);
        let mut canvas = Canvas::new();
        fill(&mut canvas, &view.outline, Pen::fill(PART, 1.0));
        let com = view.at(&subject.part.center_of_mass);
        let mut labels = Labels::new(&view);
        labels.avoid(&[com]);
        let mut scene = Self { canvas, view, labels, legend: Legend::default(), com, unit: subject.part.unit.symbol() };
        scene.tolerance(subject.part);
        scene
    }

    pub(super) fn outline(&mut self) {
        fill(&mut self.canvas, &self.view.outline, Pen::stroke(INK, 1.6));
    }

    pub(super) fn finish(mut self, name: &str, answer: &str) -> String {
        let bottom = self.close(name, answer);
        let bottom = self.legend.draw(&mut self.canvas, WIDTH, bottom);
        self.canvas.finish(WIDTH, bottom, name, answer)
    }

    /// Draws what lies above all else, and the heading; returns the lower edge.
    pub(super) fn close(&mut self, name: &str, answer: &str) -> f64 {
        self.center_of_mass();
        self.labels.draw(&mut self.canvas);
        self.canvas.text(At::new(24.0, 24.0), Align::Left, 17.0, INK, true, &shortened(name, 70));
        for (row, line) in wrapped(answer, 108).iter().enumerate() {
            self.canvas.text(At::new(24.0, 46.0 + 16.0 * row as f64), Align::Left, 12.5, MUTED, false, line);
        }
        self.scale_bar();
        self.view.bottom.max(HEADER)
    }

    fn tolerance(&mut self, part: &Part) {
        if part.center_of_mass_tolerance.is_zero() {
            return;
        }
        let half = self.view.length(&part.center_of_mass_tolerance);
        let At { x, y } = self.com;
        let corner = |dx: f64, dy: f64| At::new(x + dx * half, y + dy * half);
        let square = [corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
        self.canvas.polygon(&square, Pen::stroke(MUTED, 1.0).dashed());
    }

    fn center_of_mass(&mut self) {
        quartered(&mut self.canvas, self.com, COM);
        self.legend.add(Swatch::CenterOfMass, "center of mass");
    }

    fn scale_bar(&mut self) {
        let end = At::new(WIDTH - 24.0, self.view.bottom - 8.0);
        scale_bar(&mut self.canvas, end, self.view.units_per_pixel(), self.unit);
    }
}

/// A bar of a round length with its right end at `end`, and that length above it.
pub(super) fn scale_bar(canvas: &mut Canvas, end: At, units_per_pixel: f64, unit: &str) {
    let length = round_number(units_per_pixel * 110.0);
    let (left, y) = (end.x - length / units_per_pixel, end.y);
    let tick = |x: f64| [At::new(x, y - 3.5), At::new(x, y + 3.5)];
    canvas.line(&[At::new(left, y), end], Pen::stroke(MUTED, 1.2));
    canvas.line(&tick(left), Pen::stroke(MUTED, 1.2));
    canvas.line(&tick(end.x), Pen::stroke(MUTED, 1.2));
    let label = format!("{} {unit}", super::super::decimal::near(length, 3));
    canvas.text(At::new((left + end.x) / 2.0, y - 11.0), Align::Middle, 11.0, MUTED, false, &label);
}

/// The largest of 1, 2 and 5 times a power of ten that is at most `wanted`.
pub(super) fn round_number(wanted: f64) -> f64 {
    let power = 10_f64.powf(wanted.log10().floor());
    [5.0, 2.0, 1.0].map(|m| m * power).into_iter().find(|l| *l <= wanted).unwrap_or(power)
}

/// The usual symbol: a circle with two dark quarters.
pub(super) fn quartered(canvas: &mut Canvas, center: At, radius: f64) {
    use std::f64::consts::{FRAC_PI_2, PI};
    canvas.circle(center, radius, Pen::fill("#ffffff", 1.0));
    canvas.arc(center, radius, 0.0, FRAC_PI_2, true, Pen::fill(INK, 1.0));
    canvas.arc(center, radius, PI, FRAC_PI_2, true, Pen::fill(INK, 1.0));
    canvas.circle(center, radius, Pen::stroke(INK, 1.2));
}

fn fill(canvas: &mut Canvas, outline: &Outline, pen: Pen) {
    match outline {
        Outline::Polygon(corners) => canvas.polygon(corners, pen),
        Outline::Circle { center, radius } => canvas.circle(*center, *radius, pen),
    }
}

/// Breaks at spaces into at most two lines of about `width` letters.
pub(super) fn wrapped(text: &str, width: usize) -> Vec<String> {
    if text.chars().count() <= width {
        return vec![text.to_owned()];
    }
    let mut first = String::new();
    let mut words = text.split(' ').peekable();
    while let Some(word) = words.next_if(|word| first.chars().count() + word.chars().count() < width) {
        first += word;
        first.push(' ');
    }
    let rest = words.collect::<Vec<_>>().join(" ");
    vec![first.trim_end().to_owned(), shortened(&rest, width)]
}

pub(super) fn shortened(text: &str, width: usize) -> String {
    if text.chars().count() <= width {
        return text.to_owned();
    }
    text.chars().take(width - 1).chain(['\u{2026}']).collect()
}
