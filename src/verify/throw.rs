//! Throws put to the test: the part leaves a level arm as it is thrown, flies, and lands on a surface of finite friction that
//! may bounce or give way.

use super::draw::Draw;
use super::experiment::{Ending, Experiment, Trial, tally};
use super::seat::{length, metres, sub};
use crate::answer::{Quantity, Replay, Simulation, Status, Throw};
use crate::dynamics::{ModelKind, Moment, Options, observe};
use crate::exact::to_f64;
use crate::model::{Body, Compliance, Material, Obstacle, Part, Planar, PlanarShape, Restitution, Thrower, World};

/// Friction of a surface that catches without slip but for what mechanics forces, unless the case says otherwise.
const ROUGH: f64 = 2.0;

/// Least friction and largest restitution looked at.
const SMOOTH: f64 = 0.05;
const ELASTIC: f64 = 0.9;

/// Share of the throws that land as predicted while the pattern is said to be kept.
const KEPT: f64 = 0.95;

/// Bisections of the limits.
const BISECTIONS: usize = 6;

/// Step over √(size / g), size the radius of the part.
const STEP: f64 = 0.01;

/// Times allowed for a landing, over the time of flight.
const PATIENCE: f64 = 12.0;

/// Depth that a compliant surface gives way at the speed of release, over the size.
const GIVE: f64 = 0.01;

/// Steps of a compliant run in √(m/k).
const PERIOD: f64 = 0.2;

/// Gap over the size and speed over that of release at which a part is at rest, and steps for which it lasts.
const FLAT: f64 = 1e-3;
const STILL: f64 = 1e-3;
const DWELL: usize = 10;

/// What parts land on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Surface {
    /// Coefficients of friction, drawn between these.
    pub friction: [f64; 2],
    /// Coefficients of restitution, drawn between these.
    pub restitution: [f64; 2],
    /// Whether it gives way as lumped springs and dashpots, instead of being rigid.
    pub is_compliant: bool,
}

/// The runs of a plan for throws: each throw of the pattern, and where it is said to land.
#[derive(Debug, Clone)]
pub struct ThrowTrials {
    /// Corners of the hull about the center of mass (m).
    hull: Vec<[f64; 2]>,
    stable: Vec<usize>,
    /// Edges that look alike have the same number.
    classes: Vec<usize>,
    mass: f64,
    inertia: f64,
    offset: f64,
    /// Speed of the arm at release (rad/s).
    release: f64,
    gravity: f64,
    /// States of the pattern one after the other: edge, and radius (m).
    orbit: Vec<(usize, f64)>,
    surface: Surface,
    seed: u64,
}

impl ThrowTrials {
    /// The throws of the first pattern found; `None` where there is none. Without a `surface` it has the friction of the case
    /// or catches without slip, and does not bounce.
    #[must_use]
    pub fn new(part: &Part, thrower: &Thrower, found: &Throw, surface: Option<Surface>, seed: u64) -> Option<Self> {
        let unit = metres(part.unit);
        let com = part.center_of_mass.each_ref().map(to_f64);
        let corner = |[x, y]: &[_; 2]| sub([to_f64(x), to_f64(y)], com).map(|entry| unit * entry);
        let orbit: Vec<(usize, f64)> =
            found.limit.sets.first()?.orbit.iter().map(|(edge, radius)| (*edge, unit * radius)).collect();
        if orbit.len() < 2 {
            return None;
        }
        let friction = thrower.friction.as_ref().map(|range| [to_f64(&range.min), to_f64(&range.max)]);
        let rough = Surface { friction: friction.unwrap_or([ROUGH; 2]), restitution: [0.0; 2], is_compliant: false };
        let class = |edge: usize| found.classes.iter().position(|class| class.contains(&edge)).unwrap_or(edge);
        Some(Self {
            hull: found.hull.iter().map(corner).collect(),
            stable: found.stable.clone(),
            classes: (0..found.hull.len()).map(class).collect(),
            mass: to_f64(&part.mass),
            inertia: unit * unit * to_f64(&part.inertia),
            offset: unit * to_f64(&thrower.offset),
            release: to_f64(&thrower.release_deg_per_s).to_radians(),
            gravity: unit * to_f64(&thrower.gravity),
            orbit,
            surface: surface.unwrap_or(rough),
            seed,
        })
    }

    /// The same on another surface.
    #[must_use]
    pub fn on(&self, surface: Surface) -> Self {
        Self { surface, ..self.clone() }
    }

    /// What parts land on.
    #[must_use]
    pub fn surface(&self) -> Surface {
        self.surface
    }

    /// Throws of the pattern; as many runs go once through all of them.
    #[must_use]
    pub fn n_throws(&self) -> u64 {
        self.orbit.len() as u64 - 1
    }

    /// How smooth, and how elastic, a surface may be, rigid and compliant, for nearly all of so many throws to land on the edges
    /// predicted; by bisection. What fails from the start is left out.
    pub fn kept(&self, runs: u64, watch: &(dyn Fn() -> bool + Sync)) -> Vec<Quantity> {
        let rough = self.surface.friction[1].max(ROUGH);
        let share = |friction: f64, restitution: f64, is_compliant: bool| -> Option<bool> {
            let surface = Surface { friction: [friction; 2], restitution: [restitution; 2], is_compliant };
            let tally = tally(&self.on(surface), 0..runs, watch)?;
            Some(tally.confirmed as f64 >= KEPT * runs as f64)
        };
        let bisect = |good: f64, bad: f64, is_kept: &dyn Fn(f64) -> Option<bool>| -> Option<f64> {
            if !is_kept(good)? {
                return None;
            }
            if is_kept(bad)? {
                return Some(bad);
            }
            let (mut good, mut bad) = (good, bad);
            for _ in 0..BISECTIONS {
                let middle = 0.5 * (good + bad);
                if is_kept(middle)? { good = middle } else { bad = middle }
            }
            Some(good)
        };
        let named = |name, found: Option<f64>| found.map(|at| Quantity { name, low: at, high: at, unit: "" });
        let smooth = |is_compliant| bisect(rough, SMOOTH, &|friction| share(friction, 0.0, is_compliant));
        let elastic = |is_compliant| bisect(0.0, ELASTIC, &|restitution| share(rough, restitution, is_compliant));
        [
            named("pattern kept down to friction", smooth(false)),
            named("up to restitution", elastic(false)),
            named("on a compliant surface down to friction", smooth(true)),
            named("and up to restitution", elastic(true)),
        ]
        .into_iter()
        .flatten()
        .collect()
    }

    /// The throw of a run, and what it lands on.
    fn start(&self, run: u64, share: f64) -> (usize, Surface) {
        let mut draw = Draw::new(self.seed, run);
        let round = run / self.n_throws();
        let mut near = |[low, high]: [f64; 2], nominal: f64| {
            let drawn = if round == 0 { nominal } else { draw.extreme([low, high]) };
            [nominal + share * (drawn - nominal); 2]
        };
        let Surface { friction, restitution, is_compliant } = self.surface;
        let surface = Surface {
            friction: near(friction, friction[1]),
            restitution: near(restitution, restitution[0]),
            is_compliant,
        };
        (usize::try_from(run % self.n_throws()).unwrap_or(0), surface)
    }

    /// Radius of the part about its center of mass (m).
    fn size(&self) -> f64 {
        self.hull.iter().map(|corner| length(*corner)).fold(0.0, f64::max)
    }

    fn world(&self, throw: usize, surface: Surface) -> World<Planar> {
        let (edge, radius) = self.orbit[throw];
        let [a, b] = [self.hull[edge], self.hull[(edge + 1) % self.hull.len()]];
        let [x, y] = sub(b, a);
        let angle = -libm::atan2(y, x);
        let height = (x * a[1] - y * a[0]).abs() / length([x, y]);
        let (size, w) = (self.size(), self.release);
        let place = [radius, self.offset + height];
        let speed = w * length(place);
        let body = Body {
            name: "part".to_owned(),
            shape: PlanarShape::Polygon(self.hull.clone()),
            mass: self.mass,
            inertia: [self.inertia],
            pose: [place[0], place[1], angle],
            velocity: [-w * place[1], w * place[0], w],
            is_kinematic: false,
            schedule: Vec::new(),
            finger: None,
        };
        let arm = Obstacle {
            name: "arm".to_owned(),
            shape: PlanarShape::HalfPlane { point: [0.0, self.offset], normal: [0.0, 1.0] },
            surface_velocity: [0.0; 2],
        };
        let restitution = surface.restitution[0];
        let stiffness = self.mass * (speed / (GIVE * size)).powi(2);
        let compliance = surface.is_compliant.then(|| {
            // the ratio of damping with which a linear contact restitutes so much
            let log = restitution.max(1e-3).ln();
            let ratio = -log / (std::f64::consts::PI.powi(2) + log * log).sqrt();
            let damping = 2.0 * ratio * (stiffness * self.mass).sqrt();
            Compliance { stiffness: [stiffness; 2], damping: [damping; 2], gamma: 1e-8 * self.mass * self.gravity }
        });
        let own = if surface.is_compliant { 0.0 } else { restitution };
        let material = Material { friction: surface.friction[0], restitution: Restitution::Newton(own), compliance };
        let step = STEP * (size / self.gravity).sqrt();
        let flight = 2.0 * speed / self.gravity;
        World {
            gravity: [0.0, -self.gravity],
            duration: PATIENCE * flight.max((size / self.gravity).sqrt()),
            step: Some(if surface.is_compliant { step.min(PERIOD * (self.mass / stiffness).sqrt()) } else { step }),
            margin: None,
            directions: 2,
            bodies: vec![body],
            fixed: vec![arm],
            materials: vec![material; 2],
        }
    }

    /// The edge that lies on the arm at rest, if one does.
    fn resting(&self, pose: &[f64; 3], velocity: &[f64; 3]) -> Option<usize> {
        let (size, n) = (self.size(), self.hull.len());
        let [_, y, angle] = *pose;
        if length([velocity[0], velocity[1]]) + size * velocity[2].abs() > STILL * self.release * size {
            return None;
        }
        let (sine, cosine) = libm::sincos(angle);
        let gap = |corner: &[f64; 2]| y + sine * corner[0] + cosine * corner[1] - self.offset;
        // at rest a compliant surface has given way
        let lowest = self.hull.iter().map(gap).fold(f64::INFINITY, f64::min);
        let is_down = |corner: usize| gap(&self.hull[corner % n]) - lowest <= FLAT * size;
        let is_near = lowest.abs() <= GIVE * size;
        self.stable.iter().copied().find(|edge| is_near && is_down(*edge) && is_down(edge + 1))
    }
}

impl Experiment for ThrowTrials {
    fn run(&self, run: u64, share: f64) -> Trial {
        let (throw, surface) = self.start(run, share);
        let world = self.world(throw, surface);
        let (mut dwelt, mut landed) = (0, None);
        let model = if surface.is_compliant { ModelKind::SongPangKumar } else { ModelKind::Moreau };
        let options = Options { model, second_order: true, frames: 2, ..Options::default() };
        let mut watch = |moment: Moment<Planar>| {
            let edge = if moment.time > 0.0 { self.resting(&moment.poses[0], &moment.velocities[0]) } else { None };
            dwelt = if edge.is_some() { dwelt + 1 } else { 0 };
            landed = edge.filter(|_| dwelt > DWELL);
            landed.is_none()
        };
        let ended = observe(&world, &options, &mut watch);
        let (from, expected) = (self.orbit[throw].0, self.orbit[throw + 1].0);
        let (ending, time) = match (landed, ended) {
            (Some(edge), Ok(Simulation { time, .. })) if self.classes[edge] == self.classes[expected] => {
                (Ending::Confirmed, time)
            }
            (Some(edge), Ok(Simulation { time, .. })) => {
                (Ending::Refuted(format!("thrown from edge {from} it lands on {edge}, not {expected}")), time)
            }
            (None, Ok(Simulation { status: Status::Complete | Status::Ambiguous, time, .. })) => {
                (Ending::Inconclusive("not at rest in the time allowed".to_owned()), time)
            }
            (_, Ok(Simulation { time, .. })) => {
                (Ending::Inconclusive("a contact problem was not solved".to_owned()), time)
            }
            (_, Err(error)) => (Ending::Inconclusive(error.to_string()), 0.0),
        };
        Trial { ending, left: 1.0 - time / world.duration, moves: false }
    }

    fn replay(&self, run: u64, share: f64) -> Replay {
        let (throw, surface) = self.start(run, share);
        let model = if surface.is_compliant { "spk" } else { "moreau" };
        Replay { world: self.world(throw, surface), model, is_adverse: false }
    }

    fn settings(&self) -> Vec<Quantity> {
        let range = |name, [low, high]: [f64; 2]| Quantity { name, low, high, unit: "" };
        let throws = self.n_throws() as f64;
        vec![
            range("throws of the pattern", [throws; 2]),
            range("friction", self.surface.friction),
            range("restitution", self.surface.restitution),
        ]
    }

    fn seed(&self) -> u64 {
        self.seed
    }
}
