//! A part that is toppled from one stable edge to the next.

use super::height::Height;
use super::jams::Edge;
use super::pivoting::{Facing, Pivoting};
use super::region::Signs;
use super::signs::{Span, order};
use super::sketch::{Sketch, Sketched};
use crate::exact::{Algebraic, Q};
use crate::geometry::rests_on;
use std::rc::Rc;

/// A hull on a belt that carries it against pins.
#[derive(Debug, Clone, Copy)]
pub struct Toppled<'a> {
    /// Corners of the convex hull, counter-clockwise, no three on a line.
    pub corners: &'a [[Q; 2]],
    /// Center of mass, strictly inside.
    pub center_of_mass: &'a [Q; 2],
    /// Coefficient μ_t between part and belt, not negative.
    pub belt_friction: &'a Q,
    /// Coefficient μ_p between part and pin, not negative: what counts for the moment about P1, and for that about the
    /// pivot.
    ///
    /// They are the same where the coefficient is known. Where it is not, the part may jam while it settles for some
    /// coefficient inside of a range only if it does so for the greatest about the pivot with one of both ends about P1, as
    /// each moment is linear in the coefficient and that about the pivot falls.
    pub pin_friction: [&'a Q; 2],
}

/// What pins of all heights do while a part turns from one stable edge to the next.
#[derive(Debug)]
pub struct Turn {
    /// The stable edge that is reached.
    pub next: usize,
    /// Corners about which the part turns, in order.
    pub pivots: Vec<usize>,
    /// Turn until the center of mass is over the pivot of the moment, in degrees, to nearest.
    pub theta_t_deg: f64,
    /// Turn until the next stable edge is flat, in degrees, to nearest.
    pub theta_1_deg: f64,
    /// Heights of the part at the beginning and at the end.
    pub heights: [Height; 2],
    /// Its least height while it rolls: higher pins lose it.
    pub least_rolling: Height,
    /// Its least height while it settles.
    pub least_settling: Height,
    /// Heights at which a pin stops the part while it rolls, before it is lost; closed intervals in any order.
    pub rolling_jams: Vec<[Height; 2]>,
    /// Heights at which a pin stops the part while it settles; closed intervals in any order.
    pub settling_jams: Vec<[Height; 2]>,
    /// The edges that a pin may touch first, from the belt up, each with the heights of its ends before the turn.
    pub side: Vec<(usize, [Height; 2])>,
    /// The curves, if they are to be drawn.
    pub sketch: Sketch,
}

impl Toppled<'_> {
    /// The turn that begins on the stable edge `edge`.
    ///
    /// # Source
    /// Zhang, Goldberg et al. (2001), section IV. The pivot changes whenever an edge that is not stable lands flat.
    ///
    /// # Panics
    /// If the part does not rest on `edge` stably.
    #[must_use]
    pub fn turn(&self, edge: usize, is_drawn: bool, signs: &Signs) -> Turn {
        assert!(self.is_stable(edge), "a turn begins on a stable edge");
        let n = self.corners.len();
        let mut walk = Walk::default();
        let mut pivot = edge;
        loop {
            walk.pivot(self, Pivoting::about(self, pivot, signs), is_drawn, signs);
            pivot = (pivot + n - 1) % n;
            if self.is_stable(pivot) {
                return walk.end(pivot);
            }
        }
    }

    /// Whether the part rests on `edge` stably.
    #[must_use]
    pub fn is_stable(&self, edge: usize) -> bool {
        rests_on(self.corners, self.center_of_mass, edge)
    }
}

/// What is known of a turn so far.
#[derive(Default)]
struct Walk {
    pivots: Vec<usize>,
    turned: f64,
    theta_t: Option<f64>,
    first: Option<Height>,
    last: Option<Height>,
    least_rolling: Option<Height>,
    least_settling: Option<Height>,
    rolling_jams: Vec<[Height; 2]>,
    settling_jams: Vec<[Height; 2]>,
    side: Vec<(usize, [Height; 2])>,
    sketch: Sketch,
}

impl Walk {
    fn pivot(&mut self, part: &Toppled, pivoting: Pivoting, is_drawn: bool, signs: &Signs) {
        let facing = pivoting.facing(signs);
        let tops = Tops::of(&pivoting, &facing);
        if self.pivots.is_empty() {
            self.side = side(part, &pivoting, &facing);
            self.first = Some(tops.at(&pivoting.span.from));
        }
        self.pivots.push(pivoting.pivot);
        let span = pivoting.span.clone();
        let balance = if self.theta_t.is_none() { pivoting.balance(signs) } else { None };
        let rolling = match (&self.theta_t, &balance) {
            (Some(_), _) => span.until(&span.from),
            (None, Some(balance)) => span.until(balance),
            (None, None) => span.clone(),
        };
        let edges: Vec<Edge> = facing.into_iter().map(|facing| Edge::of(part, &pivoting, facing)).collect();
        if self.theta_t.is_none() {
            self.roll(&edges, &tops, &rolling, signs);
            self.theta_t = balance.as_ref().map(|_| self.turned + degrees(&rolling));
        }
        let settling = span.since(&rolling.to);
        if self.theta_t.is_some() {
            self.settle(&edges, &tops, &settling, signs);
        }
        if is_drawn {
            self.draw(part, &pivoting, &edges, [&rolling, &settling]);
        }
        self.last = Some(tops.at(&span.to));
        self.turned += degrees(&span);
    }

    fn draw(&mut self, part: &Toppled, pivoting: &Pivoting, edges: &[Edge], phases: [&Span; 2]) {
        let n = part.corners.len();
        let names = edges.iter().map(|edge| (pivoting.pivot + edge.place()) % n);
        let sketched = Sketched { pivoting, edges, names: names.collect(), turned: self.turned };
        self.sketch.add(&sketched, phases);
    }

    /// Jams count until the part is lost: at a turn, for pins no higher than the part ever was before.
    fn roll(&mut self, edges: &[Edge], tops: &Tops, span: &Span, signs: &Signs) {
        let mut least = tops.at(&span.from);
        if let Some(before) = self.least_rolling.take() {
            least = least.min(before);
        }
        let mut from = Rc::clone(&span.from);
        for turn in tops.turns(span).into_iter().chain([Rc::clone(&span.to)]) {
            let height = tops.at(&turn);
            let is_end = Rc::ptr_eq(&turn, &span.to);
            if height < least || is_end {
                let part = Span { from: std::mem::replace(&mut from, Rc::clone(&turn)), to: turn };
                for [low, high] in edges.iter().flat_map(|edge| edge.rolling_jams(&part, signs)) {
                    if low <= least {
                        self.rolling_jams.push([low, high.min(least.clone())]);
                    }
                }
                least = least.min(height);
            }
        }
        self.least_rolling = Some(least);
    }

    fn settle(&mut self, edges: &[Edge], tops: &Tops, span: &Span, signs: &Signs) {
        self.settling_jams.extend(edges.iter().flat_map(|edge| edge.settling_jams(span, signs)));
        let turns = tops.turns(span);
        for turn in [&span.from, &span.to].into_iter().chain(&turns) {
            let height = tops.at(turn);
            self.least_settling = Some(match self.least_settling.take() {
                Some(least) => least.min(height),
                None => height,
            });
        }
    }

    fn end(self, next: usize) -> Turn {
        let known = |height: Option<Height>| height.expect("a turn rolls, then settles");
        Turn {
            next,
            pivots: self.pivots,
            theta_t_deg: self.theta_t.unwrap_or(self.turned),
            theta_1_deg: self.turned,
            heights: [known(self.first), known(self.last)],
            least_rolling: known(self.least_rolling),
            least_settling: known(self.least_settling),
            rolling_jams: self.rolling_jams,
            settling_jams: self.settling_jams,
            side: self.side,
            sketch: self.sketch,
        }
    }
}

/// The highest corner, which changes where an edge is flat on top.
struct Tops {
    /// Corners from the first on top to the last, each with the turn from which it is on top.
    corners: Vec<(Rc<Algebraic>, Rc<super::curve::Curve>)>,
}

impl Tops {
    fn of(pivoting: &Pivoting, facing: &[Facing]) -> Self {
        let top = facing.len();
        let mut corners = vec![(Rc::clone(&pivoting.span.from), pivoting.corner(top))];
        for edge in facing.iter().rev().take_while(|edge| order(&edge.span.to, &pivoting.span.to).is_lt()) {
            corners.push((Rc::clone(&edge.span.to), pivoting.corner(edge.place)));
        }
        Self { corners }
    }

    /// The height of the part.
    fn at(&self, turn: &Rc<Algebraic>) -> Height {
        let (_, corner) = self
            .corners
            .iter()
            .rfind(|(from, _)| order(from, turn).is_le())
            .expect("the first is there from the start");
        Height::of(corner, turn)
    }

    /// Where the highest corner changes strictly inside of `span`.
    fn turns(&self, span: &Span) -> Vec<Rc<Algebraic>> {
        let turns = self.corners.iter().map(|(turn, _)| turn);
        let is_inside = |turn: &&Rc<Algebraic>| order(turn, &span.from).is_gt() && order(turn, &span.to).is_lt();
        turns.filter(is_inside).map(Rc::clone).collect()
    }
}

/// The edges that face the pin before the turn, with the heights of their ends.
fn side(part: &Toppled, pivoting: &Pivoting, facing: &[Facing]) -> Vec<(usize, [Height; 2])> {
    let n = part.corners.len();
    let at = |place: usize| Height::of(&pivoting.corner(place), &pivoting.span.from);
    // the flat edge does not face the pin yet
    let places = facing.iter().map(|edge| edge.place).skip(1);
    places.map(|place| ((pivoting.pivot + place) % n, [at(place), at(place + 1)])).collect()
}

/// How far the part turns, in degrees, to nearest.
pub(super) fn degrees(span: &Span) -> f64 {
    2.0 * (span.to.to_f64().atan() - span.from.to_f64().atan()).to_degrees()
}
