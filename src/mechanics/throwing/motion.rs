//! The motion of a throw in time, for playing and for the time that it takes.

use super::Settling;
use super::body::Body;
use super::flight::{Flight, Instant};
use super::roll::{Impact, Landing};
use std::f64::consts::TAU;

/// Steps of the integration, in units of 1 / w.
const STEP: f64 = 0.01;
/// Moments of one flight at most.
const MOST_MOMENTS: f64 = 400.0;
/// Steps of one swing at most; a part that stands upright takes for ever.
const MOST_STEPS: usize = 20_000;
/// Rocks after which a part that cannot leave its edge is taken to be at rest.
const MOST_ROCKS: usize = 12;
/// Turns too small to be seen (rad).
const UNSEEN: f64 = 2e-3;

/// Where the part is at some time after its release.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moment {
    /// Time (s).
    pub time: f64,
    /// Center of mass (length).
    pub at: [f64; 2],
    /// Turn of the part's frame (rad).
    pub angle: f64,
}

impl Body<f64> {
    /// Tells where the part is from its release on to its rest, and returns the time from one to the other (s).
    pub fn play(&self, edge: usize, radius: f64, settling: Settling, mut tell: impl FnMut(&Moment)) -> f64 {
        let mut first = None;
        let mut landings: Vec<Landing<f64>> = Vec::new();
        let met = |flight: &Flight, impact: &Impact<f64>| first = Some((*flight, *impact));
        self.follow(edge, radius, settling, met, |landing| landings.push(*landing));
        let Some((flight, impact)) = first else { return 0.0 };

        let [along, across] = self.sides[edge].direction;
        let start = -libm::atan2(across, along);
        let steps = (flight.angle / STEP).ceil().clamp(1.0, MOST_MOMENTS);
        for step in 0..=steps as usize {
            let angle = flight.angle * step as f64 / steps;
            let at = Instant::new(self, edge, radius, angle);
            let at = [at.x(self, radius), self.offset + at.height(self)];
            tell(&Moment { time: angle / self.rate, at, angle: start + angle });
        }

        let since = (flight.angle - self.flat_after(edge, impact.vertex)).rem_euclid(TAU);
        let flat = start + flight.angle - since;
        let pivot = Pivot { vertex: impact.vertex, x: impact.x, flat, turn: since, speed: impact.omega };
        let mut swings = Swings { body: self, tell, time: flight.angle, pivot };
        for (number, landing) in landings.iter().enumerate() {
            swings.swing(landing.is_ccw);
            let next = landings.get(number + 1);
            swings.turn_about(landing, next.map(|next| next.is_ccw), settling);
        }
        swings.time / self.rate
    }
}

/// A vertex that the part turns about.
#[derive(Debug, Clone, Copy)]
struct Pivot {
    vertex: usize,
    x: f64,
    /// Turn of the part's frame when it is flat on the edge right of the vertex.
    flat: f64,
    /// Turn since.
    turn: f64,
    /// Angular velocity, in units of w.
    speed: f64,
}

struct Swings<'a, F> {
    body: &'a Body<f64>,
    tell: F,
    time: f64,
    pivot: Pivot,
}

impl<F: FnMut(&Moment)> Swings<'_, F> {
    /// Turns about the vertex until the part lies flat on the edge left of it, or on the one right of it.
    fn swing(&mut self, is_ccw: bool) {
        let (body, Pivot { vertex, flat, .. }) = (self.body, self.pivot);
        let ([left, _], height) = (body.sides[vertex].ends, body.sides[vertex].height);
        let end = if is_ccw { self.exterior(vertex) } else { 0.0 };
        let pull = body.lambda / body.corners[vertex].inertia;
        let x = |turn: f64| -left * libm::cos(turn) - height * libm::sin(turn);
        let (mut turn, mut speed) = (self.pivot.turn, self.pivot.speed);
        for _ in 0..MOST_STEPS {
            // leapfrog
            let middle = turn + 0.5 * STEP * speed;
            let faster = speed - STEP * pull * x(middle);
            let next = middle + 0.5 * STEP * faster;
            let is_there = if is_ccw { next >= end && faster > 0.0 } else { next <= end && faster < 0.0 };
            if is_there {
                let share = ((end - turn) / (next - turn)).clamp(0.0, 1.0);
                self.time += STEP * if share.is_finite() { share } else { 0.0 };
                break;
            }
            (turn, speed) = (next, faster);
            self.time += STEP;
            let at = [self.pivot.x + x(turn), body.offset - left * libm::sin(turn) + height * libm::cos(turn)];
            (self.tell)(&Moment { time: self.time / body.rate, at, angle: flat + turn });
        }
        self.pivot.turn = end;
        let at = [self.pivot.x + x(end), body.offset - left * libm::sin(end) + height * libm::cos(end)];
        (self.tell)(&Moment { time: self.time / body.rate, at, angle: flat + end });
    }

    /// From a landing to the way on: over the far vertex, back over the near one after a rock, or to rest.
    fn turn_about(&mut self, landing: &Landing<f64>, next: Option<bool>, settling: Settling) {
        let (edge, is_ccw) = (landing.edge, landing.is_ccw);
        let kept = self.body.sides[edge].energy_kept;
        let mut energy = kept * landing.energy;
        match next {
            Some(next) if next == is_ccw => self.lean(edge, is_ccw, energy),
            Some(_) => {
                self.lean(edge, is_ccw, energy);
                self.swing(!is_ccw);
                self.lean(edge, !is_ccw, kept * energy);
            }
            None if settling == Settling::First => {}
            None => {
                let mut way = is_ccw;
                for _ in 0..MOST_ROCKS {
                    self.lean(edge, way, energy);
                    if self.is_unseen() {
                        break;
                    }
                    self.swing(!way);
                    (way, energy) = (!way, kept * energy);
                }
            }
        }
    }

    /// Turns on over one end of the edge that the part lies on.
    fn lean(&mut self, edge: usize, is_ccw: bool, energy: f64) {
        let (body, Pivot { vertex, x, flat, turn, .. }) = (self.body, self.pivot);
        let now = flat + turn;
        let left = if vertex == edge { x } else { x - body.sides[edge].length };
        let to = if is_ccw { edge } else { body.next(edge) };
        let speed = (2.0 * energy.max(0.0) / body.corners[to].inertia).sqrt();
        self.pivot = if is_ccw {
            Pivot { vertex: to, x: left, flat: now, turn: 0.0, speed }
        } else {
            let turn = self.exterior(to);
            Pivot { vertex: to, x: left + body.sides[edge].length, flat: now - turn, turn, speed: -speed }
        };
    }

    /// Whether the rock that begins is too small to be seen.
    fn is_unseen(&self) -> bool {
        let Pivot { vertex, turn, speed, .. } = self.pivot;
        let (body, [left, _]) = (self.body, self.body.sides[vertex].ends);
        let pull = body.lambda * (-left * libm::cos(turn) - body.sides[vertex].height * libm::sin(turn)).abs();
        0.5 * body.corners[vertex].inertia * speed * speed < pull * UNSEEN
    }

    /// Turn from lying on the edge right of the vertex to lying on the one left of it.
    fn exterior(&self, vertex: usize) -> f64 {
        self.body.flat_after(vertex, self.body.previous(vertex))
    }
}
