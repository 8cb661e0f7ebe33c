//! Points on the curves of the toppling graph, for drawing.

use super::curve::Curve;
use super::jams::Edge;
use super::pivoting::Pivoting;
use super::signs::Span;
use crate::exact::FloatInterval;
use std::rc::Rc;

/// Points (turn in degrees, height) on the curves of a turn, each by the number of its edge or corner.
#[derive(Debug, Default)]
pub struct Sketch {
    /// Of the center of mass.
    pub radius: Vec<[f64; 2]>,
    /// Of corners while a pin may touch an edge of theirs.
    pub corners: Vec<(usize, Vec<[f64; 2]>)>,
    /// Least heights for rolling, where they are on their edge.
    pub rolling: Vec<(usize, Vec<[f64; 2]>)>,
    /// Greatest heights of jams while settling, where they are on their edge.
    pub jamming: Vec<(usize, Vec<[f64; 2]>)>,
}

/// Part of a turn about one corner.
pub(super) struct Sketched<'a> {
    pub(super) pivoting: &'a Pivoting,
    pub(super) edges: &'a [Edge],
    /// Numbers of the edges.
    pub(super) names: Vec<usize>,
    /// Degrees before it.
    pub(super) turned: f64,
}

/// Points on a curve about one corner.
const POINTS: u32 = 48;

impl Sketch {
    /// Adds a part of the turn, its rolling phase and its settling phase.
    pub(super) fn add(&mut self, part: &Sketched, [rolling, settling]: [&Span; 2]) {
        let span = &part.pivoting.span;
        self.radius.extend(part.points(span).map(|(degrees, t)| [degrees, value(&part.pivoting.radius(), t)]));
        let n = part.pivoting.corners.len();
        for (index, (edge, name)) in part.edges.iter().zip(&part.names).enumerate() {
            let faced = edge.faced(span);
            let mut corner = |name: usize, curve: &Rc<Curve>| {
                let points = part.points(&faced).map(|(degrees, t)| [degrees, value(curve, t)]).collect();
                self.corners.push((name, points));
            };
            if index > 0 {
                corner(*name, &edge.bottom);
            }
            if index + 1 == part.edges.len() {
                corner((name + 1) % n, &edge.top);
            }
            let heights = |t: f64| edge.rolling_height(t);
            self.rolling.extend(part.runs(edge, rolling, &heights).map(|run| (*name, run)));
            let heights = |t: f64| edge.jamming_height(t);
            self.jamming.extend(part.runs(edge, settling, &heights).map(|run| (*name, run)));
        }
    }
}

impl Sketched<'_> {
    fn points(&self, span: &Span) -> impl Iterator<Item = (f64, f64)> {
        let [from, to] = [&span.from, &span.to].map(|end| end.to_f64().atan());
        let (start, turned) = (self.pivoting.span.from.to_f64().atan(), self.turned);
        let count = if from < to { POINTS } else { 0 };
        (0..=count).filter(move |_| count > 0).map(move |step| {
            let angle = from + (to - from) * f64::from(step) / f64::from(count);
            (turned + 2.0 * (angle - start).to_degrees(), angle.tan())
        })
    }

    /// The stretches on which a height is on the edge.
    fn runs(
        &self,
        edge: &Edge,
        span: &Span,
        height: &dyn Fn(f64) -> Option<f64>,
    ) -> impl Iterator<Item = Vec<[f64; 2]>> {
        let mut runs = vec![Vec::new()];
        for (degrees, t) in self.points(&edge.faced(span)) {
            let (low, high) = (value(&edge.bottom, t), value(&edge.top, t));
            match height(t).filter(|height| (low..=high).contains(height)) {
                Some(height) => runs.last_mut().expect("there is one").push([degrees, height]),
                None if runs.last().is_some_and(|run| !run.is_empty()) => runs.push(Vec::new()),
                None => {}
            }
        }
        runs.into_iter().filter(|run| run.len() > 1)
    }
}

/// Near the height of a curve.
pub(super) fn value(curve: &Curve, t: f64) -> f64 {
    let [low, high] = curve.near(FloatInterval::from_ends(t, t)).ends();
    f64::midpoint(low, high)
}
