//! The throw map on intervals of radii: everything that it may do there, by outward rounding.
//!
//! The time T of the first impact grows with R. For one vertex k of the first impact everything is a function of the turn α
//! in flight, R(α) too, so that images are enclosed by mean values in α without the width of R and α adding up.

use super::Settling;
use super::body::Body;
use super::flight::{Flight, Instant};
use super::real::Real as _;
use super::roll::{End, Impact, roll};
use crate::exact::FloatInterval;
use smallvec::SmallVec;
use std::f64::consts::{FRAC_PI_2, TAU};

/// Trials to bracket an impact, each 16 times as wide.
const MOST_TRIALS: usize = 10;
/// Marches of a proof that no vertex grazes the arm.
const MOST_MARCHES: usize = 10_000;

/// A hull over an arm as intervals, with doubles to guess from.
#[derive(Debug, Clone)]
pub struct Enclosing {
    exact: Body<FloatInterval>,
    near: Body<f64>,
    is_concave: bool,
}

/// What a throw from some radii may do: all of one vertex of the first impact, one edge and one turn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Branch {
    /// Vertex of the first impact.
    pub impact_vertex: usize,
    /// What then.
    pub end: BranchEnd,
}

/// Where the throws of a branch end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum BranchEnd {
    /// At rest on an edge after so many steps, at some of these radii.
    Rest {
        /// Edge.
        edge: usize,
        /// Steps.
        steps: i64,
        /// Radii.
        radii: FloatInterval,
        /// How much more these are than the radii thrown from.
        moved: FloatInterval,
    },
    /// Beside the arm, upright on a vertex, or no more is known.
    Other(Elsewhere),
}

/// No rest on an edge.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Elsewhere {
    /// A vertex meets the line of the arm left of the pivot.
    OffArm,
    /// Upright on a vertex, or it rolls on and on.
    Balanced,
    /// Too wide an interval, or too many branches.
    Unknown,
}

/// The branches on an interval of radii.
pub type Branches = SmallVec<[Branch; 4]>;

/// Radii and turns in flight of throws whose first impact is with one vertex.
struct Cell {
    radii: FloatInterval,
    angles: FloatInterval,
}

impl Enclosing {
    /// The hull in intervals, and in doubles.
    #[must_use]
    pub fn new(exact: Body<FloatInterval>, near: Body<f64>) -> Self {
        let is_concave = exact.corners.iter().all(|corner| exact.lambda.exceeds(corner.radius) == Some(true));
        Self { exact, near, is_concave }
    }

    /// In intervals.
    #[must_use]
    pub fn exact(&self) -> &Body<FloatInterval> {
        &self.exact
    }

    /// In doubles.
    #[must_use]
    pub fn near(&self) -> &Body<f64> {
        &self.near
    }

    /// Every branch that a throw from `edge` at a radius between the ends of `radii` may take; all of the part is right of
    /// the pivot there.
    #[must_use]
    pub fn branches(&self, edge: usize, radii: FloatInterval, settling: Settling) -> Branches {
        let mut branches = Branches::new();
        let Some(angles) = self.impact_angles(edge, radii) else {
            branches.push(Branch { impact_vertex: edge, end: BranchEnd::Other(Elsewhere::Unknown) });
            return branches;
        };
        for (vertex, cell) in self.cells(edge, radii, angles) {
            self.settle(edge, vertex, &cell, settling, &mut branches);
        }
        branches
    }

    /// Bounds of the turn at the first impact.
    fn impact_angles(&self, edge: usize, radii: FloatInterval) -> Option<FloatInterval> {
        let [least, most] = radii.ends();
        let low = self.no_impact_before(edge, least, &self.near.flight(edge, least)?);
        let high = self.impact_before(edge, most, &self.near.flight(edge, most)?)?;
        (low < high && high - low < FRAC_PI_2).then(|| FloatInterval::from_ends(low, high))
    }

    /// A turn before which no throw from `radius` or beyond meets the arm.
    fn no_impact_before(&self, edge: usize, radius: f64, flight: &Flight) -> f64 {
        if !self.is_concave {
            return self.march(edge, radius, flight.angle);
        }
        // concave heights that start at zero or more have no zero before
        let is_free = |angle: &f64| *angle > 0.0 && self.is_above(edge, radius, *angle, flight.vertex);
        self.widths(edge, radius, flight).map(|width| flight.angle - width).find(is_free).unwrap_or(0.0)
    }

    /// A turn before which every throw from `radius` or less meets the arm.
    fn impact_before(&self, edge: usize, radius: f64, flight: &Flight) -> Option<f64> {
        let radius_ = FloatInterval::of_double(radius);
        let is_below = |angle: f64| {
            let at = Instant::new(&self.exact, edge, radius_, FloatInterval::of_double(angle));
            at.over(&self.exact, flight.vertex)[0].ends()[1] < 0.0
        };
        self.widths(edge, radius, flight).map(|width| flight.angle + width).find(|angle| is_below(*angle))
    }

    /// Half widths to try for a bracket of an impact, from the rounding of a height on.
    fn widths(&self, edge: usize, radius: f64, flight: &Flight) -> impl Iterator<Item = f64> + use<> {
        let Flight { angle, vertex, closing } = *flight;
        // vertices that rest on the arm at first are computed to a part of the angle
        let is_resting = vertex == edge || vertex == self.near.next(edge);
        let start = self.near.radius() * if is_resting { angle } else { 1.0 };
        let height = angle * (radius + self.near.lambda * angle) + start;
        let first = 4.0 * f64::EPSILON * (height / closing.abs().max(1e-9 * height) + angle);
        (0..MOST_TRIALS).scan(first, |width, _| {
            let this = *width;
            *width *= 16.0;
            Some(this)
        })
    }

    /// Whether all vertices are above the arm at one turn. Heights go up from the lowest vertex both ways.
    fn is_above(&self, edge: usize, radius: f64, angle: f64, from: usize) -> bool {
        let at = Instant::new(&self.exact, edge, FloatInterval::of_double(radius), FloatInterval::of_double(angle));
        let mut all = true;
        self.possibly_lowest(&at, from, |vertex| {
            all &= at.over(&self.exact, vertex)[0].is_positive() == Some(true);
        });
        all
    }

    /// Tells the vertices among which the lowest is, starting near it.
    fn possibly_lowest(&self, at: &Instant<FloatInterval>, from: usize, mut tell: impl FnMut(usize)) {
        let body = &self.exact;
        let n = body.n_corners();
        tell(from);
        for step in [Body::previous, Body::next] {
            let mut vertex = from;
            for _ in 1..n {
                let beyond = step(body, vertex);
                // from here on they go up
                if at.lower(body, beyond, vertex).is_positive() == Some(true) {
                    break;
                }
                tell(beyond);
                vertex = beyond;
            }
        }
    }

    /// As far as steps that no vertex can meet the arm in lead, at most to `end`.
    fn march(&self, edge: usize, radius: f64, end: f64) -> f64 {
        let (body, radius) = (&self.exact, FloatInterval::of_double(radius));
        let mut angle = 0.0;
        for _ in 0..MOST_MARCHES {
            let at = Instant::new(body, edge, radius, FloatInterval::of_double(angle));
            let step = |vertex: usize| {
                let [height, speed] = at.over(body, vertex);
                let most = body.lambda + body.corners[vertex].radius;
                // the step grows with height and speed: their least ones will do
                let [height, speed] = [height, speed].map(|value| FloatInterval::of_double(value.ends()[0]));
                let height = if height.ends()[0] < 0.0 && angle > 0.0 { return 0.0 } else { at_least_zero(height) };
                let root = (speed.square() + most * height * FloatInterval::of_double(2.0)).sqrt();
                let step = if speed.ends()[0] > 0.0 {
                    (speed + root) / most
                } else {
                    height * FloatInterval::of_double(2.0) / (root - speed)
                };
                step.ends()[0].max(0.0)
            };
            let least = (0..body.n_corners()).map(step).fold(f64::INFINITY, f64::min);
            let next = (angle + least).next_down();
            if next <= angle || next.is_nan() {
                return angle;
            }
            angle = next;
            if angle >= end {
                return end;
            }
        }
        angle
    }

    /// The vertices that may be first, each with the radii and turns at which it may.
    fn cells(&self, edge: usize, radii: FloatInterval, angles: FloatInterval) -> SmallVec<[(usize, Cell); 4]> {
        let (near, [low, high]) = (&self.near, angles.ends());
        let n = near.n_corners();
        let exterior = |vertex: usize| near.flat_after(vertex, near.previous(vertex));
        let at = Instant::new(near, edge, radii.ends()[0], low);
        // begin one vertex early, where doubles may not tell which is lowest
        let first = near.lowest(&at, edge);
        let mut vertex = near.next(first);
        let mut about = low - 0.5 * exterior(first) - exterior(vertex);
        let mut cells = SmallVec::new();
        for _ in 0..=n {
            // it is lowest from the turn at which the edge on its right is flat to that at which the one on its left is
            let flat = near.flat_after(edge, vertex);
            let start = flat + ((about - flat) / TAU).round() * TAU;
            let end = start + exterior(vertex);
            let doubt = 1e-14 * (1.0 + high.abs());
            if start > high + doubt {
                break;
            }
            let lowest = FloatInterval::from_ends(start - doubt, end + doubt);
            if let Some(cell) = lowest.meet(angles).and_then(|angles| self.cell(edge, vertex, radii, angles)) {
                cells.push((vertex, cell));
            }
            vertex = near.previous(vertex);
            about = end;
        }
        cells
    }

    /// Narrows the radii to those from which the vertex may meet the arm at such turns; `None` if there are none.
    fn cell(&self, edge: usize, vertex: usize, radii: FloatInterval, angles: FloatInterval) -> Option<Cell> {
        let body = &self.exact;
        let whole = Instant::new(body, edge, radii, angles);
        let closing = whole.over(body, vertex)[1];
        let from = if (-closing).is_positive() == Some(true) {
            // R(α) grows: R' = -F' / α
            let [low, high] = angles.ends().map(|angle| self.radius_at(edge, vertex, FloatInterval::of_double(angle)));
            low.join(high)
        } else {
            self.radius_at(edge, vertex, angles)
        };
        Some(Cell { radii: from.meet(radii)?, angles })
    }

    /// R(α): the radius from which the vertex meets the arm after a turn α.
    fn radius_at(&self, edge: usize, vertex: usize, angle: FloatInterval) -> FloatInterval {
        let body = &self.exact;
        let zero = FloatInterval::of_double(0.0);
        let lift = Instant::new(body, edge, zero, angle).lift(body, vertex);
        body.lambda * angle * FloatInterval::of_double(0.5) - lift / angle
    }

    /// From the first impact to rest.
    fn settle(&self, edge: usize, vertex: usize, cell: &Cell, settling: Settling, branches: &mut Branches) {
        let (impact, moved) = self.impact(edge, vertex, cell);
        roll(
            &self.exact,
            &impact,
            settling,
            |_| {},
            |end| {
                let end = match end {
                    End::Rest { edge, steps, beyond } => {
                        BranchEnd::Rest { edge, steps, radii: impact.x + beyond, moved: moved + beyond }
                    }
                    End::OffArm { .. } => BranchEnd::Other(Elsewhere::OffArm),
                    End::Balanced { .. } => BranchEnd::Other(Elsewhere::Balanced),
                    End::Unknown => BranchEnd::Other(Elsewhere::Unknown),
                };
                add(branches, Branch { impact_vertex: vertex, end });
            },
        );
    }

    /// The impact at all turns of the cell, each quantity as a function of the turn: its value in the middle and its
    /// derivative everywhere. Also how far right of the center of mass at the throw it is.
    fn impact(&self, edge: usize, vertex: usize, cell: &Cell) -> (Impact<FloatInterval>, FloatInterval) {
        let body = &self.exact;
        let (corner, half) = (&body.corners[vertex], FloatInterval::of_double(0.5));
        let [low, high] = cell.angles.ends();
        let middle = FloatInterval::of_double(0.5 * (low + high));
        let apart = cell.angles - middle;
        let over = body.offset + body.sides[edge].height;

        let whole = Instant::new(body, edge, cell.radii, cell.angles);
        let [lever, below] = whole.lever(body, vertex);
        let closing = whole.over(body, vertex)[1];
        let radius_slope = -closing / cell.angles;
        let climb = cell.radii - body.lambda * cell.angles;

        let radius = self.radius_at(edge, vertex, middle);
        let here = Instant::new(body, edge, radius, middle);
        let [lever_here, below_here] = here.lever(body, vertex);

        let x_slope = radius_slope - over - below;
        let x_here = here.x(body, radius) + lever_here;
        let ends = || {
            let at = |angle: f64| {
                let angle = FloatInterval::of_double(angle);
                let radius = self.radius_at(edge, vertex, angle);
                let at = Instant::new(body, edge, radius, angle);
                at.x(body, radius) + at.lever(body, vertex)[0]
            };
            at(low).join(at(high))
        };
        let moved = x_here - radius - (over + below) * apart;
        let x = if x_slope.sign().is_some() { ends() } else { x_here + x_slope * apart };
        let x = narrowed(x, cell.radii + moved);

        // ω⁺ = (ρ² - r_x ẏ - r_y (h + d)) / I, with r_x' = -r_y, r_y' = r_x, ẏ' = R' - λ
        let omega_slope = (below * climb - lever * (radius_slope - body.lambda) - lever * over) / corner.inertia;
        let omega_here = here.caught(body, vertex);
        let omega_all = whole.caught(body, vertex);
        let omega = narrowed(omega_here + omega_slope * apart, omega_all);

        let energy =
            |omega: FloatInterval, below: FloatInterval| corner.inertia * half * omega.square() - body.lambda * below;
        let energy_slope = corner.inertia * omega * omega_slope - body.lambda * lever;
        let energy = narrowed(energy(omega_here, below_here) + energy_slope * apart, energy(omega, below));
        let steps = self.near.steps(edge, vertex, 0.5 * (low + high));
        (Impact { vertex, steps, x, lever, omega, energy }, moved)
    }
}

/// A height that was zero before rounding, or is not negative.
fn at_least_zero(height: FloatInterval) -> FloatInterval {
    let [low, high] = height.ends();
    FloatInterval::from_ends(low.max(0.0), high.max(0.0))
}

/// What two enclosures of the same numbers leave.
fn narrowed(a: FloatInterval, b: FloatInterval) -> FloatInterval {
    a.meet(b).unwrap_or(a)
}

/// Adds a branch, or widens the one that is alike.
fn add(branches: &mut Branches, branch: Branch) {
    for known in branches.iter_mut().filter(|known| known.impact_vertex == branch.impact_vertex) {
        match (&mut known.end, branch.end) {
            (
                BranchEnd::Rest { edge, steps, radii, moved },
                BranchEnd::Rest { edge: other, steps: also, radii: more, moved: further },
            ) if (*edge, *steps) == (other, also) => {
                *radii = radii.join(more);
                *moved = moved.join(further);
                return;
            }
            (BranchEnd::Other(a), BranchEnd::Other(b)) if *a == b => return,
            _ => {}
        }
    }
    branches.push(branch);
}
