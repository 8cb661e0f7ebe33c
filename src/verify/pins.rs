//! Pins over a conveyor put to the test: the belt a moving surface, each pin a fixed point, every stable orientation sent
//! through the whole sequence.

use super::draw::Draw;
use super::experiment::{Ending, Experiment, Trial, tally};
use super::seat::{length, metres, sub};
use crate::answer::{Pins, Quantity, Replay, Simulation, Status};
use crate::dynamics::{ModelKind, Moment, Options, observe};
use crate::exact::{Q, to_f64};
use crate::model::{Body, Conveyor, Material, Obstacle, Part, Planar, PlanarShape, Range, Restitution, Shape, World};

/// Acceleration of gravity (m/s²).
const GRAVITY: f64 = 9.81;

/// Belt speed over √(g L), L the diameter of the hull, at which parts move slowly.
const SLOW: f64 = 0.03;

/// Fastest belt tried, over √(g L).
const FASTEST: f64 = 3.0;

/// Factor between the speeds tried, and bisections between the last two.
const FASTER: f64 = 1.5;
const BISECTIONS: usize = 4;

/// Step over √(L/g).
const STEP: f64 = 0.02;

/// Distances over L: between the first pin and the part at the start, and between pins on a slow belt.
const CLEAR: f64 = 0.05;
const SPACING: f64 = 2.0;

/// Travel of the belt over L in which a part that is not jammed advances by [`ADVANCE`] or turns further by as many rad.
const STALL: f64 = 1.5;
const ADVANCE: f64 = 0.1;

/// Turn (rad) after which a part that is not past the pins never will be: it has been on each edge twice.
const TURNS: f64 = 2.0 * std::f64::consts::TAU;

/// Travel of the belt over L allowed for each pin.
const TRAVEL: f64 = 12.0;

/// Turn from a resting pose (rad), and steps, at which the part is at rest on an edge.
const FLAT: f64 = 1e-3;
const DWELL: usize = 20;

/// The runs of a plan for pins.
#[derive(Debug, Clone)]
pub struct PinTrials {
    /// Corners of the hull (m), counter-clockwise.
    hull: Vec<[f64; 2]>,
    com: [f64; 2],
    /// Half-width of the square in which the center of mass lies.
    tolerance: f64,
    mass: f64,
    inertia: f64,
    stable: Vec<usize>,
    /// Edges that look alike have the same number.
    classes: Vec<usize>,
    /// Height and the ends that do the same, of each pin.
    pins: Vec<[f64; 3]>,
    /// Whether the case brings the pins along.
    is_given: bool,
    /// The edge to end on; `None` for the one that the first orientation ends on.
    last: Option<usize>,
    belt: [f64; 2],
    pin: [f64; 2],
    seed: u64,
    /// Belt speed over √(g L).
    speed: f64,
}

/// What is drawn for a run.
struct Start {
    edge: usize,
    heights: Vec<f64>,
    belt: f64,
    pin: f64,
    off: [f64; 2],
}

impl PinTrials {
    /// The runs of the plan found, or of pins of these heights that bring every orientation to one; `None` if there are
    /// none or none are needed.
    #[must_use]
    pub fn new(part: &Part, conveyor: &Conveyor, found: &Pins, given: &[Q], seed: u64) -> Option<Self> {
        let unit = metres(part.unit);
        let point = |[x, y]: &[Q; 2]| [unit * to_f64(x), unit * to_f64(y)];
        let Shape::Polygon(_) = &part.shape else { return None };
        let planned = found.plan.sequence.as_ref();
        let pins: Vec<[f64; 3]> = if given.is_empty() {
            let ends = |pin: &crate::answer::Pin| {
                // inside of the ends, which do something else
                let height = to_f64(&pin.height);
                let inner = |end: f64| height + 0.999 * (end - height);
                [height, inner(pin.low.to_f64()), inner(pin.high.to_f64())].map(|height| unit * height)
            };
            planned?.iter().map(ends).collect()
        } else {
            given.iter().map(|height| [unit * to_f64(height); 3]).collect()
        };
        if pins.is_empty() {
            return None;
        }
        let last = planned.filter(|_| given.is_empty()).and_then(|pins| Some(*pins.last()?.after.first()?));
        let n = found.hull.len();
        let shift = found.symmetry.shift.clamp(1, n);
        let range = |range: &Range| [to_f64(&range.min), to_f64(&range.max)];
        Some(Self {
            hull: found.hull.iter().map(point).collect(),
            com: point(&part.center_of_mass),
            tolerance: unit * to_f64(&part.center_of_mass_tolerance),
            mass: to_f64(&part.mass),
            inertia: unit * unit * to_f64(&part.inertia),
            stable: found.stable.clone(),
            classes: (0..n).map(|edge| edge % shift).collect(),
            pins,
            is_given: !given.is_empty(),
            last,
            belt: range(&conveyor.belt_friction),
            pin: range(&conveyor.pin_friction),
            seed,
            speed: SLOW,
        })
    }

    /// The same with a belt of this speed (m/s).
    #[must_use]
    pub fn at_speed(&self, speed: f64) -> Self {
        Self { speed: speed / (GRAVITY * self.size()).sqrt(), ..self.clone() }
    }

    /// Orientations on which a part may arrive; as many runs go once through all of them.
    #[must_use]
    pub fn n_orientations(&self) -> u64 {
        self.stable.len() as u64
    }

    /// The highest belt speed up to which every orientation is turned as the plan says, at the planned heights, tried upward
    /// from the slow speed and then by bisection; `None` where `watch` ends the search or the plan fails from the start.
    pub fn fastest(&self, watch: &(dyn Fn() -> bool + Sync)) -> Option<Quantity> {
        let works = |speed: f64| -> Option<bool> {
            let trials = Self { speed, ..self.clone() };
            let tally = tally(&trials, 0..self.n_orientations(), watch)?;
            Some(tally.confirmed == self.n_orientations())
        };
        let (mut low, mut high) = (self.speed, FASTEST);
        if !works(low)? {
            return None;
        }
        while low < FASTEST {
            let next = (FASTER * low).min(FASTEST);
            if !works(next)? {
                high = next;
                break;
            }
            low = next;
        }
        for _ in 0..BISECTIONS {
            let middle = (low * high).sqrt();
            if low < high && works(middle)? { low = middle } else { high = middle }
        }
        let speed = low * (GRAVITY * self.size()).sqrt();
        Some(Quantity { name: "works up to a belt speed of", low: speed, high: speed, unit: "m/s" })
    }

    /// The edge on which the part of a run ends.
    ///
    /// # Errors
    /// How it ends otherwise.
    pub fn end(&self, run: u64) -> Result<usize, Ending> {
        match self.follow(run, 1.0) {
            (Ending::Confirmed, Some(edge), _) => Ok(edge),
            (ending, ..) => Err(ending),
        }
    }

    /// Diameter of the hull, L (m).
    fn size(&self) -> f64 {
        let pairs = self.hull.iter().flat_map(|a| self.hull.iter().map(|b| length(sub(*a, *b))));
        pairs.fold(0.0, f64::max)
    }

    fn spacing(&self) -> f64 {
        self.size() * SPACING.max(1.0 + 2.5 * self.speed)
    }

    /// The first runs send every orientation to the planned heights, with the friction in the middle of its ranges.
    fn start(&self, run: u64, share: f64) -> Start {
        let mut draw = Draw::new(self.seed, run);
        let n = self.n_orientations();
        let is_first = run < n;
        let mut near = |[low, high]: [f64; 2], middle: f64| {
            let drawn = if is_first { middle } else { draw.extreme([low, high]) };
            middle + share * (drawn - middle)
        };
        let heights = self.pins.iter().map(|[height, low, high]| near([*low, *high], *height)).collect();
        let mean = |[low, high]: [f64; 2]| 0.5 * (low + high);
        let [belt, pin] = [self.belt, self.pin].map(|range| near(range, mean(range)));
        let off = [0, 1].map(|_| near([-self.tolerance, self.tolerance], 0.0));
        Start { edge: self.stable[usize::try_from(run % n).unwrap_or(0)], heights, belt, pin, off }
    }

    fn world(&self, start: &Start) -> World<Planar> {
        let size = self.size();
        let speed = self.speed * (GRAVITY * size).sqrt();
        let com = [self.com[0] + start.off[0], self.com[1] + start.off[1]];
        let own: Vec<[f64; 2]> = self.hull.iter().map(|corner| sub(*corner, com)).collect();
        let angle = self.resting(start.edge);
        let (sine, cosine) = libm::sincos(angle);
        let turned: Vec<[f64; 2]> = own.iter().map(|[x, y]| [cosine * x - sine * y, sine * x + cosine * y]).collect();
        let lowest = turned.iter().map(|corner| corner[1]).fold(f64::INFINITY, f64::min);
        let foremost = turned.iter().map(|corner| corner[0]).fold(f64::NEG_INFINITY, f64::max);
        let body = Body {
            name: "part".to_owned(),
            shape: PlanarShape::Polygon(own),
            mass: self.mass,
            inertia: [self.inertia],
            pose: [-foremost - CLEAR * size, -lowest, angle],
            velocity: [speed, 0.0, 0.0],
            is_kinematic: false,
            schedule: Vec::new(),
            finger: None,
        };
        let still = [0.0; 2];
        let belt = Obstacle {
            name: "belt".to_owned(),
            shape: PlanarShape::HalfPlane { point: [0.0; 2], normal: [0.0, 1.0] },
            surface_velocity: [speed, 0.0],
        };
        let pins = start.heights.iter().enumerate().map(|(index, height)| Obstacle {
            name: format!("pin {}", index + 1),
            shape: PlanarShape::Circle { center: [index as f64 * self.spacing(), *height], radius: 0.0 },
            surface_velocity: still,
        });
        let fixed: Vec<Obstacle<Planar>> = std::iter::once(belt).chain(pins).collect();
        let material = |friction: f64| Material { friction, restitution: Restitution::Newton(0.0), compliance: None };
        let pins = start.heights.iter().map(|_| material(start.pin));
        let way = self.spacing() * self.pins.len() as f64 + TRAVEL * size * self.pins.len() as f64;
        World {
            gravity: [0.0, -GRAVITY],
            duration: way / speed,
            step: Some(STEP * (size / GRAVITY).sqrt()),
            margin: None,
            directions: 2,
            bodies: vec![body],
            fixed,
            materials: [material(0.0), material(start.belt)].into_iter().chain(pins).collect(),
        }
    }

    /// The turn that puts an edge of the hull down (rad).
    fn resting(&self, edge: usize) -> f64 {
        let [x, y] = sub(self.hull[(edge + 1) % self.hull.len()], self.hull[edge]);
        -libm::atan2(y, x)
    }

    /// The edge on which a part turned by `angle` rests, if any.
    fn edge_down(&self, angle: f64) -> Option<usize> {
        self.stable.iter().copied().find(|edge| {
            let off = angle - self.resting(*edge);
            (off - std::f64::consts::TAU * (off / std::f64::consts::TAU).round()).abs() <= FLAT
        })
    }

    /// How a run ends, the edge on which it does, and the share of the time left.
    fn follow(&self, run: u64, share: f64) -> (Ending, Option<usize>, f64) {
        let start = self.start(run, share);
        let world = self.world(&start);
        let mut watch = Watch::new(self, &start);
        let options = Options { model: ModelKind::Moreau, frames: 2, ..Options::default() };
        let ended = observe(&world, &options, &mut |moment| watch.goes_on(moment));
        let (status, time) = match ended {
            Ok(Simulation { status, time, .. }) => (status, time),
            Err(error) => return (Ending::Inconclusive(error.to_string()), None, 0.0),
        };
        let left = 1.0 - time / world.duration;
        let ending = match (watch.ending, status) {
            (Some(ending), _) => ending,
            // a rigid belt pushes without bound: what locks between it and a pin has no admissible impulses
            (None, Status::Inconsistent) if watch.is_at_pin => {
                Ending::Refuted(format!("from edge {} it wedges at pin {}", start.edge, watch.pin + 1))
            }
            (None, Status::Complete | Status::Ambiguous) => {
                Ending::Inconclusive("not past the pins in the time allowed".to_owned())
            }
            (None, Status::Inconsistent | Status::Partial) => {
                Ending::Inconclusive("a contact problem was not solved".to_owned())
            }
        };
        (ending, watch.edge, left)
    }
}

impl Experiment for PinTrials {
    fn run(&self, run: u64, share: f64) -> Trial {
        let (ending, edge, left) = self.follow(run, share);
        let (Ending::Confirmed, Some(edge)) = (&ending, edge) else {
            return Trial { ending, left, moves: false };
        };
        let last = self.last.or_else(|| self.follow(0, 1.0).1).unwrap_or(edge);
        if self.classes[edge] == self.classes[last] {
            return Trial { ending, left, moves: false };
        }
        let from = self.start(run, share).edge;
        let ending = Ending::Refuted(format!("from edge {from} it ends on edge {edge}, not {last}"));
        Trial { ending, left, moves: false }
    }

    fn replay(&self, run: u64, share: f64) -> Replay {
        Replay { world: self.world(&self.start(run, share)), model: "moreau", is_adverse: false }
    }

    fn settings(&self) -> Vec<Quantity> {
        let range = |name, [low, high]: [f64; 2], unit| Quantity { name, low, high, unit };
        let speed = self.speed * (GRAVITY * self.size()).sqrt();
        let off = self.pins.iter().map(|[height, low, high]| (height - low).max(high - height)).fold(0.0, f64::max);
        let mut settings = vec![
            range("belt speed", [speed; 2], "m/s"),
            range("belt friction", self.belt, ""),
            range("pin friction", self.pin, ""),
        ];
        if off > 0.0 {
            settings.push(range("heights off by", [0.0, off], "m"));
        }
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
    trials: &'a PinTrials,
    off: [f64; 2],
    from: usize,
    size: f64,
    speed: f64,
    /// The next pin.
    pin: usize,
    /// Whether the part reaches over it.
    is_at_pin: bool,
    /// When and where the part was last seen to advance (s, m), and the farthest that it has turned (rad).
    advanced: [f64; 3],
    /// Steps for which it has rested past the last pin.
    dwelt: usize,
    edge: Option<usize>,
    ending: Option<Ending>,
}

impl<'a> Watch<'a> {
    fn new(trials: &'a PinTrials, start: &Start) -> Self {
        let size = trials.size();
        Self {
            trials,
            off: start.off,
            from: start.edge,
            size,
            speed: trials.speed * (GRAVITY * size).sqrt(),
            pin: 0,
            is_at_pin: false,
            advanced: [0.0, f64::NEG_INFINITY, f64::NEG_INFINITY],
            dwelt: 0,
            edge: None,
            ending: None,
        }
    }

    fn goes_on(&mut self, moment: Moment<Planar>) -> bool {
        let trials = self.trials;
        let ([x, y, angle], [vx, vy, spin]) = (moment.poses[0], moment.velocities[0]);
        let (sine, cosine) = libm::sincos(angle);
        let com = [trials.com[0] + self.off[0], trials.com[1] + self.off[1]];
        let across = trials.hull.iter().map(|corner| {
            let [u, v] = sub(*corner, com);
            x + cosine * u - sine * v
        });
        let [last, first] = across.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(x), b.max(x)]);
        let place = |pin: usize| pin as f64 * trials.spacing();
        while self.pin < trials.pins.len() && last > place(self.pin) {
            self.pin += 1;
        }
        let reach = 2.0 * STEP * self.speed * (self.size / GRAVITY).sqrt() + 1e-6 * self.size;
        self.is_at_pin = self.pin < trials.pins.len() && first > place(self.pin) - reach;
        let [_, farthest, most] = self.advanced;
        if x > farthest + ADVANCE * self.size || angle > most + ADVANCE {
            self.advanced = [moment.time, x.max(farthest), angle.max(most)];
        }
        let is_flying = y > 3.0 * self.size || spin.abs() * (self.size / GRAVITY).sqrt() > 30.0;
        if self.pin == trials.pins.len() {
            let slip = length([vx - self.speed, vy]) + self.size * spin.abs();
            let edge = trials.edge_down(angle).filter(|_| slip <= 1e-3 * (GRAVITY * self.size).sqrt());
            self.dwelt = if edge.is_some() { self.dwelt + 1 } else { 0 };
            if self.dwelt > DWELL {
                (self.edge, self.ending) = (edge, Some(Ending::Confirmed));
            }
        } else if (moment.time - self.advanced[0]) * self.speed > STALL * self.size {
            self.ending = Some(Ending::Refuted(format!("from edge {} it jams at pin {}", self.from, self.pin + 1)));
        } else if angle - trials.resting(self.from) > TURNS {
            let what = format!("from edge {} it rolls on and on at pin {}", self.from, self.pin + 1);
            self.ending = Some(Ending::Refuted(what));
        } else if is_flying {
            self.ending = Some(Ending::Refuted(format!("from edge {} pin {} throws it off", self.from, self.pin + 1)));
        }
        self.ending.is_none()
    }
}
