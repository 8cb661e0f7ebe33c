//! Free flight after an impulsive throw, up to the first impact.

use super::body::Body;
use super::real::Real;
use super::roll::Impact;
use std::f64::consts::TAU;

/// Marches that do not come to an impact are given up.
const MOST_MARCHES: usize = 1_000_000;

/// The part `angle` after its release from an edge, which is also the time.
#[derive(Debug, Clone, Copy)]
pub(super) struct Instant<N> {
    edge: usize,
    angle: N,
    /// Sine and one less cosine of the angle.
    turned: [N; 2],
    /// Sine and cosine of the turn of the part's frame.
    turn: [N; 2],
    /// Rise of the center of mass.
    rise: N,
    /// Its derivative.
    climb: N,
}

impl<N: Real> Instant<N> {
    /// Equation (5), thrown from `edge` at `radius`.
    pub(super) fn new(body: &Body<N>, edge: usize, radius: N, angle: N) -> Self {
        let half = N::double(0.5);
        let ([sin, cos], [along, across]) = (angle.sin_cos(), body.sides[edge].direction);
        let sin_half = (angle * half).sin_cos()[0];
        let fall = body.lambda * angle;
        Self {
            edge,
            angle,
            turned: [sin, sin_half * sin_half * N::double(2.0)],
            turn: [sin * along - cos * across, cos * along + sin * across],
            rise: angle * (radius - fall * half),
            climb: radius - fall,
        }
    }

    /// From the center of mass to a vertex, equation (6).
    pub(super) fn lever(&self, body: &Body<N>, vertex: usize) -> [N; 2] {
        let ([sin, cos], [x, y]) = (self.turn, body.corners[vertex].at);
        [x * cos - y * sin, x * sin + y * cos]
    }

    /// Height of a vertex over where the center of mass was on the arm, less d: what turning alone lifts it over the arm.
    pub(super) fn lift(&self, body: &Body<N>, vertex: usize) -> N {
        let (side, [sin, versine]) = (&body.sides[self.edge], self.turned);
        let resting = |end: usize| side.ends[end] * sin + side.height * versine;
        // the resting vertices start on the arm, exactly
        match vertex {
            left if left == self.edge => resting(0),
            right if right == body.next(self.edge) => resting(1),
            _ => side.height + self.lever(body, vertex)[1],
        }
    }

    /// Height of a vertex over the arm, F_k, and its derivative.
    pub(super) fn over(&self, body: &Body<N>, vertex: usize) -> [N; 2] {
        [self.rise + self.lift(body, vertex), self.climb + self.lever(body, vertex)[0]]
    }

    /// Height of the center of mass over the arm.
    pub(super) fn height(&self, body: &Body<N>) -> N {
        body.sides[self.edge].height + self.rise
    }

    /// How much lower the second vertex is than the first.
    pub(super) fn lower(&self, body: &Body<N>, first: usize, second: usize) -> N {
        self.lever(body, first)[1] - self.lever(body, second)[1]
    }

    /// x of the center of mass.
    pub(super) fn x(&self, body: &Body<N>, radius: N) -> N {
        radius - (body.offset + body.sides[self.edge].height) * self.angle
    }

    /// Angular velocity after a vertex has stopped on the arm, equations (7) to (9).
    pub(super) fn caught(&self, body: &Body<N>, vertex: usize) -> N {
        let [x, y] = self.lever(body, vertex);
        let corner = &body.corners[vertex];
        (body.rho2 - x * self.climb - y * (body.offset + body.sides[self.edge].height)) / corner.inertia
    }
}

/// A first impact.
#[derive(Debug, Clone, Copy)]
pub(super) struct Flight {
    /// Turn in flight (rad), and time in units of 1 / w.
    pub(super) angle: f64,
    pub(super) vertex: usize,
    /// Derivative of the vertex's height, negative unless it grazes.
    pub(super) closing: f64,
}

impl Body<f64> {
    /// Largest distance of a corner from the center of mass (length).
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.corners.iter().map(|corner| corner.radius).fold(0.0, f64::max)
    }

    /// Whether the height of every vertex over the arm is strictly concave in time.
    #[must_use]
    pub fn is_concave(&self) -> bool {
        self.corners.iter().all(|corner| corner.radius < self.lambda)
    }

    /// The first impact of a throw that releases all vertices; `None` if none is found, which only rounding can bring about.
    pub(super) fn flight(&self, edge: usize, radius: f64) -> Option<Flight> {
        if self.is_concave() { Some(self.descend(edge, radius)) } else { self.march(edge, radius) }
    }

    /// The vertex that is lowest, sought from another one.
    pub(super) fn lowest(&self, at: &Instant<f64>, from: usize) -> usize {
        let is_lower = |this: usize, than: usize| at.lower(self, than, this) > 0.0;
        let walk = |step: &dyn Fn(usize) -> usize| {
            let mut vertex = from;
            while is_lower(step(vertex), vertex) {
                vertex = step(vertex);
            }
            vertex
        };
        let down = walk(&|vertex| self.previous(vertex));
        if down == from { walk(&|vertex| self.next(vertex)) } else { down }
    }

    /// Newton's method from beyond the impact: the lowest vertex's height is concave, so that every step stays beyond.
    fn descend(&self, edge: usize, radius: f64) -> Flight {
        let side = &self.sides[edge];
        // the lowest vertex is at least as far below the center of mass as the nearest edge
        let nearest = self.sides.iter().fold(f64::INFINITY, |least, side| least.min(side.height));
        let drop = (radius * radius + 2.0 * self.lambda * (side.height - nearest)).sqrt();
        let mut angle = (radius + drop) / self.lambda;
        let mut vertex = edge;
        loop {
            let at = Instant::new(self, edge, radius, angle);
            vertex = self.lowest(&at, vertex);
            let [height, closing] = at.over(self, vertex);
            let next = angle - height / closing;
            // the steps shrink until rounding stops them
            if !(next < angle && closing < 0.0) || angle - next <= f64::EPSILON * angle {
                return Flight { angle: if height < 0.0 && next < angle { next } else { angle }, vertex, closing };
            }
            angle = next;
        }
    }

    /// Steps that no vertex can meet the arm in: from height F and speed F', with F'' ≥ -M, none before
    /// (F' + √(F'² + 2 M F)) / M.
    fn march(&self, edge: usize, radius: f64) -> Option<Flight> {
        let mut angle = 0.0;
        for _ in 0..MOST_MARCHES {
            let at = Instant::new(self, edge, radius, angle);
            let free = |vertex: usize| {
                let [height, speed] = at.over(self, vertex);
                free(height.max(0.0), speed, self.lambda + self.corners[vertex].radius)
            };
            let (step, vertex) =
                (0..self.n_corners()).map(|vertex| (free(vertex), vertex)).min_by(|a, b| a.0.total_cmp(&b.0))?;
            if step <= 2.0 * f64::EPSILON * angle {
                return Some(Flight { angle, vertex, closing: at.over(self, vertex)[1] });
            }
            angle += step;
        }
        None
    }

    /// Edges passed in flight when `vertex` meets the arm.
    pub(super) fn steps(&self, edge: usize, vertex: usize, angle: f64) -> i64 {
        let n = self.n_corners();
        let base = (edge + n - vertex) % n;
        // less than half a turn after the edge right of the vertex was flat
        let turns = ((angle - self.flat_after(edge, vertex)) / TAU + 0.25).floor();
        // in a flight of more turns doubles do not tell the turn
        base as i64 + n as i64 * turns.clamp(-1e12, 1e12) as i64
    }

    /// Least turn, not negative, that lays `other` flat when `edge` was.
    pub(super) fn flat_after(&self, edge: usize, other: usize) -> f64 {
        let ([ax, ay], [bx, by]) = (self.sides[edge].direction, self.sides[other].direction);
        let turn = libm::atan2(bx * ay - by * ax, ax * bx + ay * by);
        if edge == other || turn >= 0.0 { turn.max(0.0) } else { turn + TAU }
    }

    /// The impact that a flight ends in.
    pub(super) fn impact(&self, edge: usize, radius: f64, flight: &Flight) -> Impact<f64> {
        let at = Instant::new(self, edge, radius, flight.angle);
        let [lever, below] = at.lever(self, flight.vertex);
        let omega = at.caught(self, flight.vertex);
        Impact {
            vertex: flight.vertex,
            steps: self.steps(edge, flight.vertex, flight.angle),
            x: at.x(self, radius) + lever,
            lever,
            omega,
            energy: 0.5 * self.corners[flight.vertex].inertia * omega * omega - self.lambda * below,
        }
    }

    /// d(landing radius)/dR: the landing is as far from the first impact for all radii about.
    pub(super) fn slope(&self, edge: usize, radius: f64, flight: &Flight) -> f64 {
        let at = Instant::new(self, edge, radius, flight.angle);
        let below = at.lever(self, flight.vertex)[1];
        let later = -flight.angle / flight.closing;
        1.0 - later * (self.offset + self.sides[edge].height + below)
    }
}

/// Time in which a vertex at this height and speed, whose acceleration is at least `-most`, cannot come down.
fn free(height: f64, speed: f64, most: f64) -> f64 {
    let root = (speed * speed + 2.0 * most * height).sqrt();
    // without cancellation where it falls
    if speed > 0.0 { (speed + root) / most } else { 2.0 * height / (root - speed) }
}
