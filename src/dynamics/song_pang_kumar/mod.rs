//! Song, Pang and Kumar's step, equations (14)-(17): fully implicit, contacts visco-elastic.

mod bounce;
mod check;
mod climb;
mod law;
mod memory;
mod newton;
mod solve;

pub use check::SimulationError;
pub(super) use check::{check, check_shapes};

use super::contact::{Contact, deepest};
use super::mechanics::{Mechanics, mobility};
use super::nearby::Nearby;
use super::solved::{Fallbacks, Refused, Solved};
use super::state::State;
use super::stepper::Stepper;
use super::touches::Touches;
use crate::answer::{ContactName, ContactState};
use crate::complementarity::Rung;
use crate::model::World;
use law::margin;
use memory::Memory;
use newton::{Newton, Work};

/// Steps a world by (17); keeps its memory between steps.
///
/// M, and u with the gyroscopic wrench of a body with unequal moments, are taken where the step starts; they do not
/// change in the plane and for balls.
#[derive(Debug)]
pub(super) struct SongPangKumar<'w, S: Mechanics> {
    world: &'w World<S>,
    nearby: Nearby<'w, S>,
    /// Half thickness of the bodies, then of the obstacles.
    half_thickness: Vec<f64>,
    second_order: bool,
    newton: Newton<S>,
    memory: Memory,
    /// Every pair of features near enough to touch in the step.
    contacts: Vec<Contact<S>>,
    /// Where the stage starts, then where it ends.
    base: State<S>,
    /// Impulses of the step by contact, as it was last (N s).
    touched: Touches<S>,
    last_step: f64,
    before: (State<S>, Memory),
    rate: Vec<f64>,
}

/// What is worth knowing of a run at step `h`: what is too soft, and what impacts restitute.
pub(super) fn notes<S: Mechanics>(world: &World<S>, h: f64, second_order: bool) -> Vec<String> {
    let mut notes = check::notes(world);
    notes.extend(bounce::bounces(world, h, second_order));
    notes
}

/// γ of the two-stage method, 1 - 1/√2.
const STAGE: f64 = 1.0 - std::f64::consts::FRAC_1_SQRT_2;
/// Stiffest dashpot, h C / m, that two stages are used for: beyond it they bounce where nothing does.
const STIFFEST: f64 = 1.0;
const MAX_HALVINGS: usize = 12;

impl<'w, S: Mechanics> SongPangKumar<'w, S> {
    /// With `second_order`, steps of two stages wherever the dashpots allow it.
    pub fn new(world: &'w World<S>, second_order: bool) -> Self {
        let mut nearby = Nearby::new(world);
        let start = State::start(world);
        let (mut contacts, mut memory) = (Vec::new(), Memory::default());
        // overlaps may be as deep as bodies are large
        nearby.find(&start.poses, nearby.largest(), &mut contacts);
        memory.start(&contacts);
        let shapes = world.bodies.iter().map(|body| &body.shape).chain(world.fixed.iter().map(|fixed| &fixed.shape));
        Self {
            world,
            nearby,
            half_thickness: shapes.map(S::half_thickness).collect(),
            second_order,
            newton: Newton::new(),
            memory,
            contacts,
            base: start.clone(),
            touched: Touches::default(),
            last_step: 0.0,
            before: (start, Memory::default()),
            rate: Vec::new(),
        }
    }

    /// A step of `h`, or steps of halves of it where that has no answer.
    fn divided(&mut self, state: &mut State<S>, h: f64, halvings: usize, solved: &mut Solved) -> Result<(), Refused> {
        match self.attempt(state, h, solved) {
            Err(Refused::Unsolved) if halvings < MAX_HALVINGS => {
                solved.fallbacks.divided += 1;
                self.divided(state, 0.5 * h, halvings + 1, solved)?;
                self.divided(state, 0.5 * h, halvings + 1, solved)
            }
            done => done,
        }
    }

    /// A step of `h`; nothing has changed when it is refused.
    fn attempt(&mut self, state: &mut State<S>, h: f64, solved: &mut Solved) -> Result<(), Refused> {
        state.free(self.world, h, &mut self.newton.velocities);
        let mut reach = self.reach(&state.velocities, h).max(self.reach(&self.newton.velocities, h));
        loop {
            if !reach.is_finite() {
                return Err(Refused::Unsolved);
            }
            self.nearby.find(&state.poses, reach, &mut self.contacts);
            self.check(state, h)?;
            let in_stages = self.second_order && self.stiffest(&state.poses, h) <= STIFFEST;
            let stage = if in_stages { STAGE * h } else { h };
            self.memory.recall(&self.contacts, stage, &mut self.newton.joints);
            self.base.clone_from(state);
            self.solve(&state.poses, stage, solved)?;
            // contacts may have made a body faster than the reach allows for
            let mut needed = self.reach(&self.newton.velocities, h);
            if in_stages && needed <= reach {
                self.start_second(state, h);
                self.solve(&state.poses, stage, solved)?;
                needed = self.reach(&self.newton.velocities, h);
            }
            if needed <= reach {
                self.base.advance(stage, 1.0, &self.newton.velocities);
                self.finish(state, h, stage);
                return Ok(());
            }
            reach = 2.0 * needed;
        }
    }

    /// Velocities at the end of `h` from the base, contacts as found at the poses `found`.
    fn solve(&mut self, found: &[S::Pose], h: f64, solved: &mut Solved) -> Result<(), Refused> {
        let Self { world, nearby, newton, base, .. } = self;
        if newton.joints.is_empty() {
            base.free(world, h, &mut newton.velocities);
            return Ok(());
        }
        let climb = newton.climb(world, &nearby.outlines, found, base, h).ok_or(Refused::Unsolved)?;
        let fallbacks = Fallbacks { continued: usize::from(climb.continued), divided: 0 };
        let Work { residual, iterations } = climb.work;
        let rung = if iterations == 0 { Rung::Free } else { Rung::Newton };
        solved.add(Solved { residual, pivots: iterations, rung, problems: 1, fallbacks, ..Solved::nothing() });
        Ok(())
    }

    /// Moves the base to where the second stage starts: from y and the first stage's Y on to y + (1 - γ)/γ (Y - y).
    fn start_second(&mut self, state: &State<S>, h: f64) {
        let ratio = (1.0 - STAGE) / STAGE;
        let Newton { joints, velocities, .. } = &mut self.newton;
        for joint in joints {
            let lambda = joint.force.lambda;
            joint.earlier = lambda.map(|lambda| (1.0 - STAGE) * h * lambda);
            let end = joint.law.deformed(lambda, joint.delta);
            for (delta, end) in joint.delta.iter_mut().zip(end) {
                let on = *delta + ratio * (end - *delta);
                // what relaxes does not overshoot
                *delta = if lambda[0] == 0.0 && on * *delta < 0.0 { 0.0 } else { on };
            }
        }
        self.base.advance((1.0 - STAGE) * h, 1.0, velocities);
        for (base, from) in self.base.velocities.iter_mut().zip(&state.velocities) {
            for (base, from) in base.as_mut().iter_mut().zip(from.as_ref()) {
                *base = from + ratio * (*base - from);
            }
        }
    }

    /// Takes over where the base has come to.
    fn finish(&mut self, state: &mut State<S>, h: f64, stage: f64) {
        let time = state.time + h;
        state.clone_from(&self.base);
        state.time = time;
        self.memory.keep(self.world, h, &self.newton.joints);
        for joint in &self.newton.joints {
            let impulse: [f64; 3] = std::array::from_fn(|i| joint.earlier[i] + stage * joint.force.lambda[i]);
            if impulse != [0.0; 3] {
                self.touched.add(&joint.now, impulse, time - h);
            }
        }
    }

    /// Refuses a body about to push through what it meets: v √(m/K) bounds the depth of an impact, v m/C too.
    fn check(&self, state: &State<S>, h: f64) -> Result<(), Refused> {
        for contact in self.contacts.iter().filter(|contact| contact.gap > 0.0) {
            let Some(compliance) = contact.material.compliance else {
                continue;
            };
            let approach = -contact.velocity(0, &state.velocities);
            if approach * h <= contact.gap {
                continue;
            }
            let inverse_mass: f64 =
                contact.sides().map(|(body, rows)| mobility(self.world, &state.poses, body, &rows.as_ref()[0])).sum();
            let mass = 1.0 / inverse_mass;
            let depth = approach * (mass / compliance.stiffness[0]).sqrt().min(mass / compliance.damping[0]);
            let half = self.half_thickness[contact.name.body].min(self.half_thickness[contact.name.other]);
            if depth > half {
                return Err(Refused::TooSoft { depth, half });
            }
        }
        Ok(())
    }

    /// h C / m of the stiffest dashpots, summed over the contacts of each body.
    fn stiffest(&mut self, poses: &[S::Pose], h: f64) -> f64 {
        self.rate.clear();
        self.rate.resize(self.world.bodies.len(), 0.0);
        for contact in &self.contacts {
            let damping = contact.material.compliance.map_or([0.0; 2], |compliance| compliance.damping);
            for (body, rows) in contact.sides() {
                let along = |row: usize| mobility(self.world, poses, body, &rows.as_ref()[row]);
                let tangential = (1..=S::TANGENTS).map(along).fold(0.0, f64::max);
                self.rate[body] += h * (damping[0] * along(0)).max(damping[1] * tangential);
            }
        }
        self.rate.iter().copied().fold(0.0, f64::max)
    }

    /// A distance beyond which no pair of features meets in a step at these velocities (m); pairs that overlap are
    /// within it too.
    fn reach(&self, velocities: &[S::Velocity], h: f64) -> f64 {
        self.nearby.reach_beyond(self.memory.deepest(), velocities, h)
    }
}

impl<S: Mechanics> Stepper<S> for SongPangKumar<'_, S> {
    fn step(&mut self, state: &mut State<S>, h: f64) -> Result<Solved, Refused> {
        self.touched.clear();
        self.last_step = h;
        self.before.0.clone_from(state);
        self.before.1.copy(&self.memory);
        let mut solved = Solved::nothing();
        match self.divided(state, h, 0, &mut solved) {
            Ok(()) => Ok(solved),
            Err(refused) => {
                state.clone_from(&self.before.0);
                self.memory.copy(&self.before.1);
                Err(refused)
            }
        }
    }

    fn touches(&self) -> impl Iterator<Item = (&Contact<S>, [f64; 3])> {
        self.touched.iter()
    }

    fn deepest(&self) -> f64 {
        deepest(&self.contacts)
    }

    fn stored(&self) -> f64 {
        self.memory.energy(self.world)
    }

    fn deformations(&self) -> Vec<(ContactName, [f64; 3])> {
        self.memory.deformations().collect()
    }

    /// A contact sticks while friction is below its bound, though its points move as it deforms.
    fn contact_state(&self, contact: &Contact<S>, impulse: [f64; 3], _: &[S::Velocity]) -> ContactState {
        match margin(&contact.material, impulse, self.last_step) {
            _ if impulse == [0.0; 3] => ContactState::Open,
            margin if margin > 1e-9 => ContactState::Stick,
            _ => ContactState::Slip,
        }
    }
}
