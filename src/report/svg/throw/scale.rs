//! From values to the page.

use super::super::canvas::{Align, At, Canvas, INK, MUTED, Pen};
use super::super::scene::round_number;
use crate::report::decimal;

/// About so many pixels between two ticks, across and up.
const TICK: f64 = 64.0;
const UP: f64 = 44.0;
const MOST_TICKS: u32 = 60;
const RULE: &str = "#e4e7ea";

/// An axis: values between two ends, and where these are on the page.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Scale {
    pub(super) values: [f64; 2],
    pub(super) page: [f64; 2],
    /// Least step of its ticks.
    pub(super) least_step: f64,
}

impl Scale {
    /// An axis for all finite ones of the values, with some room beyond them; it starts at zero if they nearly do.
    pub(super) fn covering(values: impl Iterator<Item = f64>, page: [f64; 2]) -> Self {
        let [low, high] = extent(values);
        let room = 0.04 * (high - low);
        let low = if low >= 0.0 && low < 0.4 * high { 0.0 } else { low - room };
        Self { values: [low, high + room], page, least_step: 0.0 }
    }

    pub(super) fn on(self, page: [f64; 2]) -> Self {
        Self { page, ..self }
    }

    /// Where a value is; at the nearer end if it is beyond, at the first if it is no number.
    pub(super) fn at(&self, value: f64) -> f64 {
        let ([low, high], [from, to]) = (self.values, self.page);
        from + clamped((value - low) / (high - low)) * (to - from)
    }

    /// Whether a value is between the ends.
    pub(super) fn holds(&self, value: f64) -> bool {
        (self.values[0]..=self.values[1]).contains(&value)
    }

    /// Round values whose names have room beside each other.
    fn ticks_across(&self) -> Vec<f64> {
        let is_apart = |ticks: &Vec<f64>| {
            let widest = ticks.iter().map(|value| name(*value).chars().count()).max().unwrap_or(0);
            ticks.windows(2).all(|pair| self.at(pair[1]) - self.at(pair[0]) > 6.2 * widest as f64 + 8.0)
        };
        let spaces = (0..8).map(|k| TICK * 1.5_f64.powi(k));
        spaces.map(|space| self.ticks(space)).find(is_apart).unwrap_or_default()
    }

    /// Round values, about so many pixels between them.
    fn ticks(&self, space: f64) -> Vec<f64> {
        let ([low, high], [from, to]) = (self.values, self.page);
        let step = round_number((high - low) * space / (to - from).abs()).max(self.least_step);
        let first = (low / step).ceil();
        let is_told = step > 0.0 && step.is_finite() && first + 1.0 > first;
        let ticks = (0..MOST_TICKS).map(|k| (first + f64::from(k)) * step).take_while(|value| *value <= high);
        if is_told { ticks.collect() } else { Vec::new() }
    }

    /// Draws it as a horizontal axis at `y`, with rules up to `top`.
    pub(super) fn draw_across(&self, canvas: &mut Canvas, y: f64, top: f64, title: &str) {
        self.rules_across(canvas, [top, y]);
        let mut marks = vec![self.page.map(|x| At::new(x, y)).to_vec()];
        for value in self.ticks_across() {
            let x = self.at(value);
            marks.push(vec![At::new(x, y), At::new(x, y + 4.0)]);
            canvas.text(At::new(x, y + 13.0), Align::Middle, 11.0, MUTED, false, &name(value));
        }
        canvas.lines(&marks, Pen::stroke(INK, 1.0));
        canvas.text(At::new(self.page[1], y + 29.0), Align::Right, 11.0, MUTED, false, title);
    }

    /// Draws its rules only, between two heights of the page.
    pub(super) fn rules_across(&self, canvas: &mut Canvas, [top, bottom]: [f64; 2]) {
        let rule = |value| [top, bottom].map(|y| At::new(self.at(value), y)).to_vec();
        let rules: Vec<Vec<At>> = self.ticks_across().into_iter().map(rule).collect();
        canvas.lines(&rules, Pen::stroke(RULE, 0.8));
    }

    /// Draws it as an upright axis at `x`, with rules to `right`.
    pub(super) fn draw_up(&self, canvas: &mut Canvas, x: f64, right: f64, title: &str) {
        let mut marks = vec![self.page.map(|y| At::new(x, y)).to_vec()];
        for value in self.ticks(UP) {
            let y = self.at(value);
            canvas.line(&[At::new(x, y), At::new(right, y)], Pen::stroke(RULE, 0.8));
            marks.push(vec![At::new(x - 4.0, y), At::new(x, y)]);
            canvas.text(At::new(x - 7.0, y), Align::Right, 11.0, MUTED, false, &name(value));
        }
        canvas.lines(&marks, Pen::stroke(INK, 1.0));
        let top = self.page[0].min(self.page[1]);
        canvas.text(At::new(x - 30.0, top - 12.0), Align::Left, 11.0, MUTED, false, title);
    }
}

/// A share between zero and one; zero for what is no number.
pub(super) fn clamped(share: f64) -> f64 {
    if share.is_nan() { 0.0 } else { share.clamp(0.0, 1.0) }
}

fn name(value: f64) -> String {
    if value == 0.0 || (1e-5..1e7).contains(&value.abs()) { decimal::near(value, 6) } else { format!("{value:.2e}") }
}

/// The least and the largest finite value, apart from each other.
fn extent(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let finite = values.filter(|value| value.is_finite() && value.abs() < 1e300);
    let (low, high) = finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
    if low > high {
        [0.0, 1.0]
    } else if high - low > 1e-9 * low.abs().max(high.abs()) {
        [low, high]
    } else {
        let about = if low == 0.0 { 1.0 } else { 0.1 * low.abs() };
        [low - about, high + about]
    }
}
