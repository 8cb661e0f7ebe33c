//! One piece of work: a curve for each method.

use super::super::canvas::{Align, At, Canvas, INK, MUTED, Pen};
use super::super::label::Labels;
use super::super::scene::shortened;
use super::super::view::along;
use super::axes::{self, Logarithmic};
use super::mark::Mark;
use crate::answer::{ChartFamily, ChartPoint};
use crate::report::decimal::percent_of;

/// Left of a plot, for the numbers of its axis, and below it.
const LEFT: f64 = 56.0;
const FOOT: f64 = 40.0;
/// Above a plot, for what it shows.
const HEADING: f64 = 36.0;
/// Height of the bands for no answer, and for no error.
const BAND: f64 = 24.0;
/// Distance of two points up to which one word is enough for both.
const NEAR: f64 = 14.0;
const GRID: &str = "#e6e9ec";

pub(super) struct Panel<'a> {
    family: ChartFamily,
    work: &'a str,
    /// Points of each method, by number.
    curves: Vec<(usize, Vec<&'a ChartPoint>)>,
    frame: [At; 2],
    x: Option<Logarithmic>,
    y: Option<Logarithmic>,
    has_none: bool,
    has_zero: bool,
}

impl<'a> Panel<'a> {
    pub(super) fn new(
        family: ChartFamily,
        work: &'a str,
        methods: &[&str],
        points: &[&'a ChartPoint],
        frame: [At; 2],
    ) -> Self {
        let of = |method: &str| points.iter().copied().filter(|point| point.method == method).collect::<Vec<_>>();
        let curves = methods.iter().enumerate().map(|(index, method)| (index, of(method)));
        Self {
            family,
            work,
            curves: curves.filter(|(_, points)| !points.is_empty()).collect(),
            frame,
            x: Logarithmic::around(points.iter().flat_map(|point| point.time)),
            y: Logarithmic::around(points.iter().filter_map(|point| answer(point))),
            has_none: points.iter().any(|point| answer(point).is_none()),
            has_zero: points.iter().any(|point| answer(point).is_some_and(|error| error <= 0.0)),
        }
    }

    pub(super) fn draw(&self, canvas: &mut Canvas) {
        let [low, high] = self.plot();
        let mut labels =
            Labels::within([At::new(low.x + 2.0, low.y + 2.0), At::new(high.x - 2.0, high.y - 2.0)]).rimmed();
        canvas.text(
            At::new(self.frame[0].x, self.frame[0].y + 6.0),
            Align::Left,
            12.5,
            INK,
            true,
            &shortened(self.work, 60),
        );
        let error = At::new(self.frame[0].x, low.y - 12.0);
        canvas.text(error, Align::Left, 11.0, MUTED, false, self.family.error());
        self.grid(canvas);
        for (method, points) in &self.curves {
            // a curve does not lead to where there is no answer
            for answered in points.split(|point| answer(point).is_none()) {
                let places: Vec<At> = answered.iter().map(|point| self.place(point, point.time[1])).collect();
                canvas.line(&places, Pen::stroke(Mark::of(*method).colour(), 1.4));
                places.windows(2).for_each(|pair| labels.avoid(&along(pair[0], pair[1])));
            }
        }
        for (method, points) in &self.curves {
            for point in points {
                let whisker = [point.time[0], point.time[2]].map(|time| self.place(point, time));
                canvas.line(&whisker, Pen::stroke(Mark::of(*method).colour(), 1.0));
                let at = self.place(point, point.time[1]);
                let mark = Mark::of(*method);
                if point.failed > 0 { mark.hollow() } else { mark }.draw(canvas, at);
                let rim = (0..7).map(|turn| at.along(At::unit(f64::from(turn) * 0.9), 4.0));
                labels.avoid(&rim.chain([at]).collect::<Vec<_>>());
            }
        }
        // what failed is told first, so that it finds room; without an answer all failed
        let mut told: Vec<(At, String)> = Vec::new();
        for (_, points) in &self.curves {
            let share = |at: usize| points.get(at).map(|point| percent_of(point.failed, point.of));
            for (index, point) in points.iter().enumerate() {
                let own = share(index);
                let is_amid = index > 0 && share(index - 1) == own && share(index + 1) == own;
                if let (true, Some(_), Some(own), false) = (point.failed > 0, answer(point), own, is_amid) {
                    let at = self.place(point, point.time[1]);
                    let text = format!("{own} fail");
                    if is_new(&mut told, at, &text) {
                        labels.want(at, At::new(0.0, -1.0), 7.0, INK, false, text);
                    }
                }
            }
        }
        for (method, points) in &self.curves {
            let ends = [points.first(), points.last()].into_iter().flatten().take(points.len());
            for point in ends {
                let (at, setting) = (self.place(point, point.time[1]), shortened(&point.setting, 40));
                if is_new(&mut told, at, &setting) {
                    labels.offer_near(at, At::new(1.0, 0.0), 7.0, Mark::of(*method).colour(), setting);
                }
            }
        }
        labels.draw(canvas);
    }

    /// Upper left and lower right corner of the plot, bands included.
    fn plot(&self) -> [At; 2] {
        let [low, high] = self.frame;
        [At::new(low.x + LEFT, low.y + HEADING), At::new(high.x, high.y - FOOT)]
    }

    /// The same without the bands.
    fn scaled(&self) -> [f64; 2] {
        let [low, high] = self.plot();
        let band = |is_there: bool| if is_there { BAND } else { 0.0 };
        [low.y + band(self.has_none), high.y - band(self.has_zero)]
    }

    fn grid(&self, canvas: &mut Canvas) {
        let ([low, high], [top, bottom]) = (self.plot(), self.scaled());
        for tick in self.x.iter().flat_map(Logarithmic::ticks) {
            let x = self.across(tick);
            canvas.line(&[At::new(x, low.y), At::new(x, high.y)], Pen::stroke(GRID, 1.0));
            canvas.text(At::new(x, high.y + 12.0), Align::Middle, 10.5, MUTED, false, &axes::time(tick));
        }
        for tick in self.y.iter().flat_map(Logarithmic::ticks) {
            let y = self.down(tick);
            canvas.line(&[At::new(low.x, y), At::new(high.x, y)], Pen::stroke(GRID, 1.0));
            canvas.text(At::new(low.x - 6.0, y), Align::Right, 10.5, MUTED, false, &axes::plain(tick));
        }
        for (is_there, y, edge, name) in
            [(self.has_none, low.y + 0.5 * BAND, top, "no answer"), (self.has_zero, high.y - 0.5 * BAND, bottom, "0")]
        {
            if is_there {
                canvas.line(&[At::new(low.x, edge), At::new(high.x, edge)], Pen::stroke("#b9c0c6", 1.0).dashed());
                canvas.text(At::new(low.x - 6.0, y), Align::Right, 10.5, MUTED, false, name);
            }
        }
        let rim = [low, At::new(high.x, low.y), high, At::new(low.x, high.y)];
        canvas.polygon(&rim, Pen::stroke("#b9c0c6", 1.0));
        let middle = At::new(0.5 * (low.x + high.x), high.y + 28.0);
        canvas.text(middle, Align::Middle, 11.0, MUTED, false, self.family.time());
    }

    fn place(&self, point: &ChartPoint, time: f64) -> At {
        let [low, high] = self.plot();
        let y = match answer(point) {
            None => low.y + 0.5 * BAND,
            Some(error) if error > 0.0 => self.down(error),
            Some(_) => high.y - 0.5 * BAND,
        };
        At::new(self.across(time), y)
    }

    fn across(&self, time: f64) -> f64 {
        let [low, high] = self.plot();
        low.x + self.x.map_or(0.5, |axis| axis.place(time)) * (high.x - low.x)
    }

    fn down(&self, error: f64) -> f64 {
        let [top, bottom] = self.scaled();
        bottom - self.y.map_or(0.5, |axis| axis.place(error)) * (bottom - top)
    }
}

/// The error of a point; what is no finite number is no answer.
fn answer(point: &ChartPoint) -> Option<f64> {
    point.error.filter(|error| error.is_finite())
}

/// Whether nothing alike is told next to it; it is from now on.
fn is_new(told: &mut Vec<(At, String)>, at: At, text: &str) -> bool {
    let is_told = told.iter().any(|(other, said)| said == text && other.minus(at).length() < NEAR);
    told.push((at, text.to_owned()));
    !is_told
}
