//! A run from start to end: steps, and what is worth keeping of them.

use super::Moment;
use super::contact::{Contact, dot};
use super::impulses::SLIPPING;
use super::judge::{Judge, short};
use super::mechanics::Mechanics;
use super::options::Options;
use super::solved::{Refused, Solved};
use super::state::{State, applied};
use super::stepper::Stepper;
use crate::answer::{
    ContactName, ContactState, Energy, Event, Frame, ModelChoice, Simulation, SolverStatistics, Status, Touch,
};
use crate::complementarity::Rung;
use crate::model::World;

/// Steps `world` to its end, or until `watch` says no.
pub(super) fn run<S: Mechanics>(
    world: &World<S>,
    options: &Options,
    model: ModelChoice,
    stepper: &mut impl Stepper<S>,
    watch: &mut dyn FnMut(Moment<S>) -> bool,
) -> Simulation<S> {
    let h = model.step;
    let n_steps = step_count(world.duration, h);
    let mut log = Log::start(world, stepper.stored(), n_steps.div_ceil(options.frames.max(2) - 1).max(1));
    let mut state = State::start(world);
    let mut before = state.clone();
    let mut status = Status::Complete;
    log.keep(&state, stepper);
    let mut judge = Judge::new(world);
    if let Some((depth, note)) = judge.overlap(&state) {
        log.penetration.0 = depth;
        log.notes.push(note);
    }
    let (mut said_reversal, mut said_together) = (false, false);
    for index in 0..n_steps {
        let moment = Moment { time: state.time, poses: &state.poses, velocities: &state.velocities };
        if index >= options.max_steps || !watch(moment) {
            status = Status::Partial;
            break;
        }
        // the last step may be shorter; times are products, not sums, so that they do not drift
        let end = if index + 1 == n_steps { world.duration } else { (index + 1) as f64 * h };
        let length = if (end - state.time - h).abs() <= 1e-9 * h { h } else { end - state.time };
        before.clone_from(&state);
        match stepper.step(&mut state, length) {
            Ok(solved) => {
                if let (Some(reversal), false) = (solved.reversal, said_reversal) {
                    log.notes.push(judge.reversal(before.time, reversal));
                    said_reversal = true;
                }
                if solved.together > 1 && !said_together {
                    log.notes.push(judge.together(before.time, solved.together));
                    said_together = true;
                }
                log.step(world, &before, &state, stepper, solved);
                if let Some((judged, note)) = judge.step(&before, stepper.is_suspect(), &log.held) {
                    status = judged;
                    log.notes.push(note);
                }
            }
            Err(refused) => {
                status = log.refused(state.time, &refused);
                break;
            }
        }
        state.time = end;
        if (index + 1) % log.every == 0 || index + 1 == n_steps {
            log.keep(&state, stepper);
        }
    }
    if status == Status::Complete
        && options.forces
        && let Some(forces) = stepper.forces(world, &state)
    {
        log.notes.extend(judge.forces(&forces));
    }
    log.finish(world, &state, stepper, status, model)
}

/// How many steps of `h` make up `duration`; a remainder of rounding is none.
fn step_count(duration: f64, h: f64) -> usize {
    let exact = duration / h;
    let whole = exact.round();
    if (exact - whole).abs() <= 1e-9 * whole { whole as usize } else { exact.ceil() as usize }
}

/// What is kept of a run.
struct Log<S: Mechanics> {
    every: usize,
    frames: Vec<Frame<S>>,
    events: Vec<Event>,
    /// Contacts with a force, by name.
    held: Vec<(ContactName, ContactState)>,
    now: Vec<(ContactName, ContactState)>,
    energy: Energy,
    last_energy: f64,
    penetration: (f64, f64),
    solver: SolverStatistics,
    rungs: [usize; Rung::ALL.len()],
    closed: usize,
    continued: usize,
    notes: Vec<String>,
}

impl<S: Mechanics> Log<S> {
    fn start(world: &World<S>, stored: f64, every: usize) -> Self {
        let start = State::start(world).energy(world) + stored;
        Self {
            every,
            frames: Vec::new(),
            events: Vec::new(),
            held: Vec::new(),
            now: Vec::new(),
            energy: Energy { start, end: start, ..Energy::default() },
            last_energy: start,
            penetration: (0.0, 0.0),
            solver: SolverStatistics::default(),
            rungs: [0; Rung::ALL.len()],
            closed: 0,
            continued: 0,
            notes: Vec::new(),
        }
    }

    fn step(
        &mut self,
        world: &World<S>,
        before: &State<S>,
        after: &State<S>,
        stepper: &impl Stepper<S>,
        solved: Solved,
    ) {
        self.solver.steps += 1;
        self.solver.problems += solved.problems;
        self.solver.pivots += solved.pivots;
        self.solver.impacts += solved.impacts;
        self.solver.fastest_impact = self.solver.fastest_impact.max(solved.fastest_impact);
        self.solver.residual = self.solver.residual.max(solved.residual);
        self.solver.subdivided += solved.fallbacks.divided;
        self.continued += solved.fallbacks.continued;
        if solved.problems > 0 && solved.closed == solved.problems {
            self.closed += 1;
        } else if solved.problems > 0 {
            self.rungs[solved.rung as usize] += 1;
        }
        if stepper.deepest() > self.penetration.0 {
            self.penetration = (stepper.deepest(), before.time);
        }
        self.now.clear();
        for (contact, impulse) in stepper.touches() {
            let state = stepper.contact_state(contact, impulse, &after.velocities);
            if state != ContactState::Open {
                self.now.push((contact.name, state));
            }
        }
        self.now.sort_unstable_by_key(|(name, _)| *name);
        if self.now != self.held {
            self.change(after.time, stepper);
        }
        let energy = after.energy(world) + stepper.stored();
        let work = work(world, before, after, stepper) + stepper.corrected();
        self.energy.work += work;
        self.energy.largest_gain = self.energy.largest_gain.max(energy - self.last_energy - work);
        self.last_energy = energy;
    }

    /// Notes which contacts changed between `held` and `now`, and makes `now` what is held.
    fn change(&mut self, time: f64, stepper: &impl Stepper<S>) {
        let state_in = |list: &[(ContactName, ContactState)], name: &ContactName| {
            list.binary_search_by_key(name, |(name, _)| *name).map_or(ContactState::Open, |at| list[at].1)
        };
        let gone = self.held.iter().filter(|(name, _)| state_in(&self.now, name) == ContactState::Open);
        let mut changed: Vec<Event> =
            gone.map(|(name, from)| Event { time, contact: *name, from: *from, to: ContactState::Open }).collect();
        changed.extend(self.now.iter().filter_map(|(name, to)| {
            let from = state_in(&self.held, name);
            let since = if from == ContactState::Open { stepper.touched_at(name) } else { None };
            (from != *to).then_some(Event { time: since.unwrap_or(time), contact: *name, from, to: *to })
        }));
        changed.sort_by(|a, b| a.time.total_cmp(&b.time).then(a.contact.cmp(&b.contact)));
        self.events.append(&mut changed);
        std::mem::swap(&mut self.held, &mut self.now);
    }

    fn keep(&mut self, state: &State<S>, stepper: &impl Stepper<S>) {
        let touches = stepper.touches().map(|(contact, impulse)| Touch {
            contact: contact.name,
            state: stepper.contact_state(contact, impulse, &state.velocities),
            point: contact.point,
            normal: contact.normal,
            impulse,
        });
        self.frames.push(Frame {
            time: state.time,
            poses: state.poses.clone(),
            velocities: state.velocities.clone(),
            touches: touches.filter(|touch| touch.state != ContactState::Open).collect(),
        });
    }

    /// Says why a step was refused.
    fn refused(&mut self, time: f64, refused: &Refused) -> Status {
        let time = short(time);
        let (what, status) = match refused {
            Refused::NoSolution(_) => {
                ("no impulses are admissible: bodies overlap and are held so", Status::Inconsistent)
            }
            Refused::Undecided(_) => ("the contact problem was not decided at a limit", Status::Partial),
            Refused::Broken(_) => ("the velocities grew beyond all bounds", Status::Partial),
            Refused::Overlap { depth } => {
                self.notes.push(format!("at {time} s bodies overlap by {depth:.3e} m and nothing moves them apart"));
                return Status::Inconsistent;
            }
            Refused::Unsolved => {
                ("the forces of compliant contacts were not found, however short the step", Status::Partial)
            }
            Refused::TooSoft { depth, half } => {
                self.notes.push(format!(
                    "at {time} s a contact is about to give way by up to {} m, more than half the thickness, {} m: it is too \
                     soft to keep the bodies apart",
                    short(*depth),
                    short(*half)
                ));
                return Status::Partial;
            }
        };
        self.notes.push(format!("at {time} s {what}"));
        status
    }

    fn finish(
        mut self,
        world: &World<S>,
        state: &State<S>,
        stepper: &impl Stepper<S>,
        status: Status,
        model: ModelChoice,
    ) -> Simulation<S> {
        self.keep(state, stepper);
        let last = self.frames.pop().expect("a frame was just kept");
        if self.frames.last().is_none_or(|frame| frame.time != last.time) {
            self.frames.push(last.clone());
        }
        let used = Rung::ALL.into_iter().zip(self.rungs).filter(|(_, count)| *count > 0);
        self.solver.rungs = used.map(|(rung, count)| (rung.name(), count)).collect();
        if self.solver.subdivided > 0 {
            self.notes.push(format!("{} times a step was halved to be solved", self.solver.subdivided));
        }
        if self.closed > 0 {
            self.solver.rungs.insert(0, ("closed form", self.closed));
        }
        if self.continued > 0 {
            self.solver.rungs.push(("continued", self.continued));
        }
        self.energy.end = state.energy(world) + stepper.stored();
        self.energy.dissipated = self.energy.start + self.energy.work - self.energy.end;
        Simulation {
            status,
            time: state.time,
            last,
            frames: self.frames,
            events: self.events,
            deformations: stepper.deformations(),
            energy: self.energy,
            penetration: self.penetration,
            solver: self.solver,
            model,
            notes: self.notes,
        }
    }
}

/// Open without a force, stick without slip; slip is told from rounding by the speeds that meet at the contact.
pub(super) fn contact_state<S: Mechanics>(
    contact: &Contact<S>,
    impulse: [f64; 3],
    velocities: &[S::Velocity],
) -> ContactState {
    if impulse == [0.0; 3] {
        return ContactState::Open;
    }
    let slip = (1..=S::TANGENTS).map(|row| contact.velocity(row, velocities).powi(2)).sum::<f64>().sqrt();
    let is_slipping = slip > SLIPPING * contact.speed(velocities) + 1e-12;
    if is_slipping { ContactState::Slip } else { ContactState::Stick }
}

/// Work of applied wrenches, moving surfaces and kinematic bodies in a step (J).
fn work<S: Mechanics>(world: &World<S>, before: &State<S>, after: &State<S>, stepper: &impl Stepper<S>) -> f64 {
    let mut work = 0.0;
    let poses = before.poses.iter().zip(&after.poses);
    for (body, (from, to)) in world.bodies.iter().zip(poses).filter(|(body, _)| !body.is_kinematic) {
        work += dot(&applied(body, from, before.time), &S::displacement(from, to));
    }
    for (contact, impulse) in stepper.touches() {
        // the velocity of the surface itself: that of the contact may hold terms of the scheme
        if let Some(fixed) = contact.name.other.checked_sub(world.bodies.len()) {
            let surface = &world.fixed[fixed].surface_velocity;
            work += (0..S::TANGENTS).map(|i| impulse[i + 1] * surface[i]).sum::<f64>();
        }
        for (body, rows) in contact.sides().filter(|(body, _)| world.bodies[*body].is_kinematic) {
            let push = |row: usize| impulse[row] * dot(&rows.as_ref()[row], &after.velocities[body]);
            work -= (0..=S::TANGENTS).map(push).sum::<f64>();
        }
    }
    work
}
