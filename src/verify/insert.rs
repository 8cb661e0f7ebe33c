//! Insertion put to the test: the part near its seat, pushed or tilted as the plan says, against every solution of its
//! contact problems.

use super::draw::Draw;
use super::experiment::{Ending, Experiment, Trial, tally};
use super::seat::{Kind, Seat, dot, length, metres, sub, unit_vector};
use crate::answer::{Action, Quantity, Recommendation, Replay, Simulation, Status};
use crate::dynamics::{ModelKind, Moment, Options, Policy, observe};
use crate::exact::{Q, Z, ratio, to_f64};
use crate::model::{
    Body, Finger, Fixture, GivenPush, Material, Obstacle, Part, Planar, PlanarShape, Restitution, Shape, Timed, World,
};
use std::fmt::Write as _;

/// Steps in the time that the wrench takes to close the largest gap without contacts.
const STEPS: f64 = 64.0;

/// Times allowed, over that time.
const PATIENCE: f64 = 60.0;

/// Steps for which a state lasts that is believed to last.
const DWELL: usize = 64;

/// Steps in which a part that is seated comes to rest if it is held.
const HELD: usize = 16 * DWELL;

/// Gap, over the departure, up to which a fixel holds.
const CLOSED: f64 = 1e-3;

/// Speed, over that at which the largest gap would close, that is none.
const STILL: f64 = 1e-6;

/// Gap, over the departure, from which the part has left.
const LOST: f64 = 30.0;

/// Half-width of a flat fixel under a vertex, over the part's size.
const FLAT: f64 = 0.02;

/// The same on the side of an edge that lies along the flat, over the largest gap at the start.
const FLUSH: f64 = 4.0;

/// Largest gap at the start, over the part's size, and over the distance of a fixel from the end of an edge.
const DEPARTURE: f64 = 1e-4;
const ROOM: f64 = 0.02;

/// Largest gap at the start, over the part's size, that is tried.
const FARTHEST: f64 = 0.1;

/// Bisections of the largest departure.
const BISECTIONS: usize = 3;

/// Least gap, over the part's size, that doubles resolve.
const RESOLVED: f64 = 1e-7;

/// How the wrench is applied; lengths in metres, world axes those of the case.
#[derive(Debug, Clone, PartialEq)]
pub enum Push {
    /// A frictionless finger on a straight guide.
    Finger(Finger),
    /// Gravity in the plane of the tray, a unit vector.
    Tilt([f64; 2]),
    /// A steady wrench at the center of mass.
    Wrench([f64; 3]),
}

/// The runs of a plan for an insertion.
#[derive(Debug)]
pub struct InsertTrials {
    seat: Seat,
    /// Half-width of the square in which the center of mass lies (m).
    tolerance: f64,
    push: Push,
    is_given: bool,
    seed: u64,
    /// Largest gap at the start, over the part's size.
    departure: f64,
}

/// What is drawn for a run.
struct Start {
    /// Largest gap (m).
    widest: f64,
    pose: [f64; 3],
    friction: Vec<f64>,
    /// How far the center of mass is from where the case has it.
    off: [f64; 2],
}

impl InsertTrials {
    /// The runs of a plan, with gaps of up to `departure` times the part's size at the start, or 1e-4 of it, less where
    /// a fixel is near the end of an edge.
    #[must_use]
    pub fn new(part: &Part, fixture: &Fixture, push: Push, seed: u64, departure: Option<f64>) -> Self {
        let seat = Seat::new(part, fixture);
        let departure = departure.unwrap_or_else(|| DEPARTURE.min(ROOM * seat.room / seat.size));
        Self {
            tolerance: metres(part.unit) * to_f64(&part.center_of_mass_tolerance),
            seat,
            push,
            is_given: false,
            seed,
            departure,
        }
    }

    /// The same, said to be of a plan that the case brings along.
    #[must_use]
    pub fn given(self) -> Self {
        Self { is_given: true, ..self }
    }

    /// Sets of contacts from which the part is not seated yet; as many runs go once through all of them.
    #[must_use]
    pub fn n_states(&self) -> u64 {
        (1_u64 << self.seat.fixels.len().min(16)) - 1
    }

    /// The largest gaps at the start from which as many runs all end seated: by steps of four, then by bisection. `None` where
    /// `watch` ends the search or the runs fail from the least gaps.
    pub fn farthest(&self, runs: u64, watch: &(dyn Fn() -> bool + Sync)) -> Option<Quantity> {
        let all_seated = |departure: f64| -> Option<bool> {
            let trials = Self { departure, seat: self.seat.clone(), push: self.push.clone(), ..*self };
            let tally = tally(&trials, 0..runs, watch)?;
            Some(tally.confirmed == runs)
        };
        let (mut low, mut high) = (self.departure, FARTHEST);
        if !all_seated(low)? {
            return None;
        }
        while low < FARTHEST {
            let next = (4.0 * low).min(FARTHEST);
            if !all_seated(next)? {
                high = next;
                break;
            }
            low = next;
        }
        for _ in 0..BISECTIONS {
            let middle = (low * high).sqrt();
            if low < high && all_seated(middle)? { low = middle } else { high = middle }
        }
        let gap = low * self.seat.size;
        Some(Quantity { name: "seats from gaps up to", low: gap, high: gap, unit: "m" })
    }

    /// The first runs start from every unseated set of contacts with gaps as large as may be, with the largest and the
    /// least friction; later ones are drawn.
    fn start(&self, run: u64, share: f64) -> Start {
        let mut draw = Draw::new(self.seed, run);
        let n = self.seat.fixels.len();
        let n_states = self.n_states();
        let (state, round) = (run % n_states, run / n_states);
        let widest = share * self.departure * self.seat.size;
        let gap = |draw: &mut Draw| if round < 2 { 1.0 } else { draw.between([0.02, 1.0]) };
        let gaps: Vec<f64> =
            (0..n).map(|fixel| if state >> fixel & 1 == 1 { 0.0 } else { widest * gap(&mut draw) }).collect();
        let mut aside = || widest * draw.between([-1.0, 1.0]);
        let drift = if n < 3 { [aside(), aside(), aside() / self.seat.rho] } else { [0.0; 3] };
        let friction = self.seat.fixels.iter().map(|spot| {
            let [low, high] = spot.friction;
            let drawn = match round {
                0 => high,
                1 => low,
                _ => draw.extreme(spot.friction),
            };
            let middle = 0.5 * (low + high);
            middle + share * (drawn - middle)
        });
        let friction = friction.collect();
        let off = [0, 1].map(|_| {
            let reach = share * self.tolerance;
            if round < 2 { 0.0 } else { draw.extreme([-reach, reach]) }
        });
        Start { widest, pose: self.seat.pose(&gaps, drift), friction, off }
    }

    fn world(&self, start: &Start) -> World<Planar> {
        let Seat { shape, mass, inertia, size, .. } = &self.seat;
        let (sine, cosine) = libm::sincos(start.pose[2]);
        let off = start.off;
        let turned = [cosine * off[0] - sine * off[1], sine * off[0] + cosine * off[1]];
        let pose = [start.pose[0] + turned[0], start.pose[1] + turned[1], start.pose[2]];
        let shifted = |point: &[f64; 2]| sub(*point, off);
        let shape = match shape {
            PlanarShape::Polygon(vertices) => PlanarShape::Polygon(vertices.iter().map(shifted).collect()),
            PlanarShape::Circle { center, radius } => PlanarShape::Circle { center: shifted(center), radius: *radius },
            other => other.clone(),
        };
        // forces that accelerate the part by its size in a second, squared
        let force = mass * size;
        let schedule = match &self.push {
            Push::Wrench(wrench) => vec![Timed { time: 0.0, value: wrench.map(|entry| force * entry) }],
            Push::Finger(_) | Push::Tilt(_) => Vec::new(),
        };
        let finger = match &self.push {
            Push::Finger(finger) => Some(Finger { force, ..*finger }),
            Push::Tilt(_) | Push::Wrench(_) => None,
        };
        let gravity = match &self.push {
            Push::Tilt(direction) => direction.map(|entry| size * entry),
            Push::Finger(_) | Push::Wrench(_) => [0.0; 2],
        };
        let part = Body {
            name: "part".to_owned(),
            shape,
            mass: *mass,
            inertia: [*inertia],
            pose,
            velocity: [0.0; 3],
            is_kinematic: false,
            schedule,
            finger,
        };
        let fixed = (0..self.seat.fixels.len()).map(|index| Obstacle {
            name: format!("fixel {index}"),
            shape: self.fixel(index),
            surface_velocity: [0.0; 2],
        });
        let material = |friction: f64| Material { friction, restitution: Restitution::Newton(0.0), compliance: None };
        let time = time(start, *size);
        World {
            gravity,
            duration: PATIENCE * time,
            step: Some(time / STEPS),
            margin: Some(2.0 * start.widest),
            directions: 2,
            bodies: vec![part],
            fixed: fixed.collect(),
            materials: std::iter::once(0.0).chain(start.friction.iter().copied()).map(material).collect(),
        }
    }

    /// A point, or under a vertex a flat.
    fn fixel(&self, index: usize) -> PlanarShape {
        let spot = &self.seat.fixels[index];
        let (normal, at) = (spot.normal, spot.at);
        let (Kind::Vertex(vertex), PlanarShape::Polygon(vertices)) = (spot.kind, &self.seat.shape) else {
            return PlanarShape::Circle { center: at, radius: 0.0 };
        };
        let tangent = [normal[1], -normal[0]];
        let over = |other: &[f64; 2]| dot(normal, sub(*other, vertex));
        let along = |other: &[f64; 2]| dot(tangent, sub(*other, vertex));
        let none = 1e-9 * self.seat.size;
        if vertices.iter().all(|other| over(other) > none || length(sub(*other, vertex)) <= none) {
            return PlanarShape::HalfPlane { point: at, normal };
        }
        // where an edge lies along it the flat ends next to the vertex, lest it hold the edge up elsewhere
        let reach = |side: f64| {
            let is_flush = vertices.iter().any(|other| over(other).abs() <= none && side * along(other) > none);
            self.seat.size * if is_flush { FLAT.min(FLUSH * self.departure) } else { FLAT }
        };
        let (back, ahead, deep) = (reach(-1.0), reach(1.0), FLAT * self.seat.size);
        let corner = |across: f64, down: f64| {
            [at[0] + across * tangent[0] - down * normal[0], at[1] + across * tangent[1] - down * normal[1]]
        };
        PlanarShape::Polygon(vec![corner(-back, 0.0), corner(-back, deep), corner(ahead, deep), corner(ahead, 0.0)])
    }

    /// The contacts that hold and the fixels that are free, in words.
    fn state(&self, pose: &[f64; 3], closed: f64) -> String {
        let n = self.seat.fixels.len();
        let free: Vec<usize> = (0..n).filter(|fixel| self.seat.gap(*fixel, pose) > closed).collect();
        let mut words = String::from(if free.len() == 1 { "fixel" } else { "fixels" });
        for (index, fixel) in free.iter().enumerate() {
            let joint = match index {
                0 => " ",
                _ if index + 1 == free.len() => " and ",
                _ => ", ",
            };
            let _ = write!(words, "{joint}{fixel}");
        }
        words
    }
}

/// The time in which the wrench closes the largest gap without contacts (s).
fn time(start: &Start, size: f64) -> f64 {
    (2.0 * start.widest / size).sqrt()
}

impl Push {
    /// What a planner recommends.
    #[must_use]
    pub fn recommended(part: &Part, plan: &Recommendation) -> Self {
        let direction = |direction: &[Z; 2]| direction.each_ref().map(|entry| Q::from(entry.clone()));
        match &plan.action {
            Action::PushEdge { point, direction, edge, .. } => Self::finger(part, Some(*edge), point, direction),
            Action::PushArc { direction: from, .. } => Self::on_circle(part, &direction(from)),
            Action::Tilt { direction: pull, .. } => Self::Tilt(unit_vector(direction(pull).each_ref().map(to_f64))),
            Action::Wrench => Self::wrench(part, &plan.wrench),
        }
    }

    /// What a case says.
    #[must_use]
    pub fn given(part: &Part, given: &GivenPush) -> Self {
        match (given, &part.shape) {
            (GivenPush::Edge { edge, s }, Shape::Polygon(polygon)) => {
                let point = polygon.point(&polygon.location(*edge, s.clone()));
                Self::finger(part, Some(*edge), &point, &polygon.inward_normal(*edge))
            }
            (GivenPush::Circle(from), _) => Self::on_circle(part, from),
            (GivenPush::Tilt(direction), _) => Self::Tilt(unit_vector(direction.each_ref().map(to_f64))),
            (GivenPush::Wrench(wrench), _) => Self::wrench(part, wrench),
            (GivenPush::Edge { .. }, Shape::Circle { .. }) => Self::on_circle(part, &[ratio(0, 1), ratio(-1, 1)]),
        }
    }

    fn finger(part: &Part, edge: Option<usize>, point: &[Q; 2], direction: &[Q; 2]) -> Self {
        let unit = metres(part.unit);
        let at = point.each_ref().map(|entry| unit * to_f64(entry));
        Self::Finger(Finger { edge, at, direction: unit_vector(direction.each_ref().map(to_f64)), force: 1.0 })
    }

    /// Towards the center of a circle, from a direction.
    fn on_circle(part: &Part, from: &[Q; 2]) -> Self {
        let (center, direction) = match &part.shape {
            Shape::Circle { center, .. } => (center.clone(), from.each_ref().map(|entry| -entry)),
            Shape::Polygon(_) => (part.center_of_mass.clone(), from.each_ref().map(|entry| -entry)),
        };
        Self::finger(part, None, &center, &direction)
    }

    /// Scaled to accelerate by 1 m/s² in the norm of kinetic energy, for a mass of 1 kg.
    fn wrench(part: &Part, wrench: &[Q; 3]) -> Self {
        let unit = metres(part.unit);
        let [x, y, torque] = wrench.each_ref().map(to_f64);
        let rho = to_f64(&part.gyration2()).sqrt();
        let size = length([x, y]).hypot(torque / rho);
        Self::Wrench([x / size, y / size, unit * torque / size])
    }
}

impl Experiment for InsertTrials {
    fn run(&self, run: u64, share: f64) -> Trial {
        if self.departure < RESOLVED {
            let why = "a fixel is so near the end of an edge that doubles do not resolve the gaps".to_owned();
            return Trial { ending: Ending::Inconclusive(why), left: 0.0, moves: false };
        }
        let start = self.start(run, share);
        let world = self.world(&start);
        let mut watch = Watch {
            trials: self,
            off: start.off,
            closed: CLOSED * start.widest,
            lost: LOST * start.widest,
            still: STILL * time(&start, self.seat.size) * self.seat.size,
            dwelt: [0; 2],
            was_seated: false,
            is_still: false,
            ending: None,
        };
        let options =
            Options { model: ModelKind::StewartTrinkle, policy: Policy::Adverse, frames: 2, ..Options::default() };
        let ended = observe(&world, &options, &mut |moment| watch.goes_on(moment));
        let (ending, time) = match (watch.ending, ended) {
            (Some(ending), Ok(Simulation { time, .. })) => (ending, time),
            (Some(ending), Err(_)) => (ending, 0.0),
            (None, Err(error)) => (Ending::Inconclusive(error.to_string()), 0.0),
            (None, Ok(Simulation { status: Status::Complete | Status::Ambiguous, time, .. })) => {
                (Ending::Inconclusive("not seated in the time allowed".to_owned()), time)
            }
            (None, Ok(Simulation { time, .. })) => {
                (Ending::Inconclusive("a contact problem was not solved".to_owned()), time)
            }
        };
        let moves = ending == Ending::Confirmed && !watch.is_still;
        Trial { ending, left: 1.0 - time / world.duration, moves }
    }

    fn replay(&self, run: u64, share: f64) -> Replay {
        Replay { world: self.world(&self.start(run, share)), model: "st", is_adverse: true }
    }

    fn settings(&self) -> Vec<Quantity> {
        let range = |name, [low, high]: [f64; 2], unit| Quantity { name, low, high, unit };
        let widest = self.departure * self.seat.size;
        let friction = self.seat.fixels.iter().map(|spot| spot.friction);
        let friction = friction.fold([f64::INFINITY, 0.0], |all, one| [all[0].min(one[0]), all[1].max(one[1])]);
        let mut settings = vec![
            range("gaps at the start", [0.0, widest], "m"),
            range("largest gap over the part's size", [self.departure; 2], ""),
            range("friction", friction, ""),
        ];
        if self.tolerance > 0.0 {
            settings.push(range("center of mass off by", [0.0, self.tolerance], "m"));
        }
        settings
    }

    fn seed(&self) -> u64 {
        self.seed
    }

    fn is_given(&self) -> bool {
        self.is_given
    }
}

/// Follows a run until it is known how it ends.
struct Watch<'a> {
    trials: &'a InsertTrials,
    off: [f64; 2],
    closed: f64,
    lost: f64,
    still: f64,
    /// Steps for which the part has been seated, and at rest elsewhere.
    dwelt: [usize; 2],
    /// Whether it has been seated for long enough.
    was_seated: bool,
    /// Whether it is seated and moves no longer.
    is_still: bool,
    ending: Option<Ending>,
}

impl Watch<'_> {
    fn goes_on(&mut self, moment: Moment<Planar>) -> bool {
        let seat = &self.trials.seat;
        let [x, y, angle] = moment.poses[0];
        let (sine, cosine) = libm::sincos(angle);
        let off = self.off;
        let pose = [x - (cosine * off[0] - sine * off[1]), y - (sine * off[0] + cosine * off[1]), angle];
        let widest = seat.widest(&pose);
        let [vx, vy, spin] = moment.velocities[0];
        self.is_still = moment.time > 0.0 && length([vx, vy]) + seat.size * spin.abs() <= self.still;
        let count = |is_so: bool, steps: usize| if is_so { steps + 1 } else { 0 };
        self.dwelt = [count(widest <= self.closed, self.dwelt[0]), count(self.is_still, self.dwelt[1])];
        let is_seated = self.dwelt[0] > DWELL;
        self.was_seated |= is_seated;
        // what moves when it arrives may still come to rest, or leave again
        let is_told = self.is_still || self.dwelt[0] > HELD || widest > self.closed;
        self.is_still &= is_seated;
        self.ending = if self.was_seated && is_told {
            Some(Ending::Confirmed)
        } else if widest > self.closed && self.dwelt[1] > DWELL {
            Some(Ending::Refuted(format!("rests with {} free", self.trials.state(&pose, self.closed))))
        } else if widest > self.lost {
            Some(Ending::Refuted("leaves its seat".to_owned()))
        } else {
            None
        };
        self.ending.is_none()
    }
}
