//! A part on an arm as the planner of throws sees it: the map, and where it is defined.

use super::grasp;
use crate::answer::{Caught, EdgeGrasp, Fate, GraspEdge};
use crate::exact::{FloatInterval, Q, Surd};
use crate::mechanics::throwing::{Body, Branches, Catch, Enclosing, RestingEdge, Settling, Thrown};
use crate::model::Thrower;

/// The throw map with its domain.
#[derive(Debug, Clone)]
pub(super) struct System {
    pub(super) map: Enclosing,
    pub(super) settling: Settling,
    /// Edges on which the part rests stably.
    pub(super) stable: Vec<usize>,
    /// For each edge, if it is stable.
    lows: Vec<Option<Low>>,
    /// Largest distance of a corner from the center of mass (length).
    pub(super) part_radius: f64,
}

/// The end of the domain on an edge.
#[derive(Debug, Clone, Copy)]
struct Low {
    grasp: FloatInterval,
    clear: FloatInterval,
}

/// A state: edge and radius.
pub(super) type State = (usize, f64);

impl System {
    /// The hull with these corners on the arm, and its edges there.
    pub(super) fn new(
        corners: &[[Q; 2]],
        center_of_mass: &[Q; 2],
        rho2: &Q,
        thrower: &Thrower,
        settling: Settling,
    ) -> (Self, Vec<GraspEdge>) {
        let arm = [&thrower.offset, &thrower.gravity, &thrower.release_deg_per_s];
        let resting = RestingEdge::all(corners, center_of_mass, rho2);
        let edges = grasp::edges(&resting, rho2, thrower);
        let near: Body<f64> = Body::new(corners, center_of_mass, rho2, &resting, arm);
        let enclosure = Surd::enclosure;
        let low = |grasp: &EdgeGrasp| Low { grasp: enclosure(&grasp.r_grasp), clear: enclosure(&grasp.r_clear) };
        let system = Self {
            part_radius: near.radius(),
            map: Enclosing::new(Body::new(corners, center_of_mass, rho2, &resting, arm), near),
            settling,
            stable: edges.iter().filter(|edge| edge.is_stable).map(|edge| edge.edge).collect(),
            lows: edges.iter().map(|edge| edge.grasp.as_ref().map(low)).collect(),
        };
        (system, edges)
    }

    pub(super) fn near(&self) -> &Body<f64> {
        self.map.near()
    }

    /// |h + d| of an edge (length).
    pub(super) fn over_pivot(&self, edge: usize) -> f64 {
        (self.near().offset() + self.near().height(edge)).abs()
    }

    /// u_l and u_r of an edge, enclosed.
    pub(super) fn enclosed_ends(&self, edge: usize) -> [FloatInterval; 2] {
        self.map.exact().ends(edge)
    }

    /// λ = |g| / w² (length).
    pub(super) fn lambda(&self) -> f64 {
        self.near().lambda()
    }

    /// Radii up to which the map is looked at: a part that lands there has turned by about half a turn, or some turns if its
    /// vertices are so far out that they may meet the arm at once.
    pub(super) fn scan_to(&self) -> f64 {
        self.lambda() * if self.near().is_concave() { 1.6 } else { 6.0 }
    }

    /// Orbits that come so far are taken to run away; the part turns over some hundred times in each flight.
    pub(super) fn far(&self) -> f64 {
        1_000.0 * self.scan_to()
    }

    /// The least double in the domain of a stable edge.
    pub(super) fn low(&self, edge: usize) -> f64 {
        self.lows[edge].map_or(f64::INFINITY, |low| low.grasp.ends()[1].max(low.clear.ends()[1].next_up()))
    }

    /// Least radius of a grasp on a stable edge, and that at which the part begins to reach over the pivot.
    pub(super) fn lows(&self, edge: usize) -> Option<[f64; 2]> {
        self.lows[edge].map(|low| [low.grasp.ends()[1], low.clear.ends()[1]])
    }

    /// Whether the radius is proved to be below the domain of the edge.
    pub(super) fn surely_below(&self, edge: usize, radius: f64) -> bool {
        self.lows[edge].is_none_or(|low| radius < low.grasp.ends()[0] || radius < low.clear.ends()[0])
    }

    /// A throw from the domain.
    pub(super) fn throw(&self, at: State) -> Thrown {
        self.near().throw(at.0, at.1, self.settling)
    }

    /// The state after a throw from the domain, and its slope; `None` if it is outside.
    pub(super) fn next(&self, at: State) -> Option<Catch> {
        match self.throw(at) {
            Thrown::Caught(catch) if catch.radius >= self.low(catch.edge) => Some(catch),
            _ => None,
        }
    }

    /// What a throw from the domain may do on an interval of radii.
    pub(super) fn branches(&self, edge: usize, radii: FloatInterval) -> Branches {
        self.map.branches(edge, radii, self.settling)
    }

    /// What a throw does, in the words of the answer.
    pub(super) fn fate(&self, at: State) -> Fate {
        match self.lows.get(at.0).copied().flatten() {
            None => Fate::UnstableEdge,
            Some(low) if at.1 < low.grasp.ends()[0] => Fate::NoGrasp,
            Some(low) if at.1 <= low.clear.ends()[0] => Fate::Overhang,
            Some(_) => self.told(&self.throw(at)),
        }
    }

    /// A throw in the words of the answer.
    pub(super) fn told(&self, thrown: &Thrown) -> Fate {
        match *thrown {
            Thrown::Caught(catch) => Fate::Caught(Caught {
                edge: catch.edge,
                radius: catch.radius,
                steps: catch.steps,
                flight_time: catch.flight_rotation / self.near().rate(),
                flight_rotation: catch.flight_rotation,
                impact_vertex: catch.impact_vertex,
                impact_x: catch.impact_x,
                omega_after: catch.omega_after * self.near().rate(),
                slope: catch.slope,
                in_domain: catch.radius >= self.low(catch.edge),
            }),
            Thrown::OffArm { vertex, x, .. } => Fate::OffArm { vertex, x },
            Thrown::Balanced { vertex } => Fate::Balanced { vertex },
        }
    }

    /// Whether sizes and speeds are numbers that doubles can be computed with.
    pub(super) fn is_in_range(&self) -> bool {
        let lengths = [self.part_radius, self.lambda(), self.near().rate()];
        let size = self.part_radius.max(self.near().offset().abs());
        lengths.into_iter().all(|length| (1e-100..1e100).contains(&length)) && size < 1e8 * self.lambda()
    }

    /// Up to so many states from a start on.
    pub(super) fn orbit(&self, start: State, count: usize) -> Vec<State> {
        let next = |at: &State| self.next(*at).map(|catch| (catch.edge, catch.radius));
        std::iter::successors(Some(start), next).take(count).collect()
    }

    /// Mean time of throws from these states (s).
    pub(super) fn mean_seconds(&self, states: impl Iterator<Item = State>) -> f64 {
        let times: Vec<f64> =
            states.map(|(edge, radius)| self.near().play(edge, radius, self.settling, |_| {})).collect();
        times.iter().sum::<f64>() / times.len() as f64
    }
}
