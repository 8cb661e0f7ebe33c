//! Stewart and Trinkle's step, equations (10)-(13): semi-implicit, gaps closed at the end of the step.

use super::contact::{Contact, deepest};
use super::forces::Forces;
use super::impulses::{FrictionCone, Impulses};
use super::mechanics::Mechanics;
use super::nearby::Nearby;
use super::solved::{Refused, Solved};
use super::state::State;
use super::stepper::Stepper;
use crate::model::World;

/// Overlaps up to so many times what counts as touching are none where they make a step impossible.
const SLIGHT_OVERLAP: f64 = 100.0;

/// Steps a world by (10)-(13); keeps its memory between steps.
#[derive(Debug)]
pub(super) struct StewartTrinkle<'w, S: Mechanics> {
    world: &'w World<S>,
    nearby: Nearby<'w, S>,
    impulses: Impulses<S>,
    /// Every pair of features near enough to touch in the step.
    contacts: Vec<Contact<S>>,
    /// Those that the step presses on.
    pressed: Vec<Contact<S>>,
    is_pressed: Vec<bool>,
    offsets: Vec<f64>,
    free: Vec<S::Velocity>,
    velocities: Vec<S::Velocity>,
    recovery_speed: f64,
    /// Length of the step (s).
    h: f64,
    /// Whether overlaps too small to matter count as none in this step.
    is_lenient: bool,
    /// A gap up to this counts as touching (m).
    touching: f64,
}

impl<'w, S: Mechanics> StewartTrinkle<'w, S> {
    /// `recovery_speed` bounds the speed at which overlaps are undone (m/s); infinite for the paper's φ/h.
    pub fn new(world: &'w World<S>, recovery_speed: f64) -> Self {
        let nearby = Nearby::new(world);
        Self {
            world,
            touching: nearby.touching(),
            nearby,
            impulses: Impulses::new(world, FrictionCone::Edges),
            contacts: Vec::new(),
            pressed: Vec::new(),
            is_pressed: Vec::new(),
            offsets: Vec::new(),
            free: Vec::new(),
            velocities: Vec::new(),
            recovery_speed,
            h: 0.0,
            is_lenient: false,
        }
    }

    /// Solves for the contacts that the free motion closes, then for those too that the answer closes, until none is left.
    fn press(&mut self, poses: &[S::Pose], h: f64) -> Result<Solved, Refused> {
        // φ/h of (13), overlaps undone no faster than allowed
        let recovery_speed = self.recovery_speed;
        let slight = if self.is_lenient { SLIGHT_OVERLAP * self.touching } else { 0.0 };
        let gap_speed = |contact: &Contact<S>| match contact.gap {
            gap if gap < 0.0 && gap > -slight => 0.0,
            gap => (gap / h).max(-recovery_speed),
        };
        self.velocities.clone_from(&self.free);
        // what was pressed and still touches is likely to be again: the last basis then fits at once
        let (last, touching) = (&self.pressed, self.touching);
        let was_pressed = |contact: &Contact<S>| last.iter().any(|last| last.name == contact.name);
        self.is_pressed.clear();
        self.is_pressed.extend(self.contacts.iter().map(|contact| contact.gap <= touching && was_pressed(contact)));
        self.pressed.clear();
        let mut total = Solved::nothing();
        let mut grown = self.is_pressed.contains(&true);
        loop {
            for (contact, is_pressed) in self.contacts.iter().zip(&mut self.is_pressed) {
                let closes = || contact.velocity(0, &self.velocities) + gap_speed(contact) < 0.0;
                if !*is_pressed && closes() {
                    (*is_pressed, grown) = (true, true);
                }
            }
            if !std::mem::take(&mut grown) {
                return Ok(total);
            }
            let pressed = self.contacts.iter().zip(&self.is_pressed).filter(|(_, is_pressed)| **is_pressed);
            self.pressed.clear();
            self.pressed.extend(pressed.map(|(contact, _)| *contact));
            self.offsets.clear();
            self.offsets.extend(self.pressed.iter().map(&gap_speed));
            self.velocities.clone_from(&self.free);
            total.add(self.impulses.solve(
                self.world,
                poses,
                &self.pressed,
                &self.offsets,
                &[],
                &mut self.velocities,
            )?);
        }
    }
}

impl<S: Mechanics> Stepper<S> for StewartTrinkle<'_, S> {
    fn step(&mut self, state: &mut State<S>, h: f64) -> Result<Solved, Refused> {
        self.impulses.is_suspect = false;
        self.h = h;
        state.free(self.world, h, &mut self.free);
        let mut reach = self.nearby.reach(&state.velocities, h).max(self.nearby.reach(&self.free, h));
        loop {
            self.nearby.find(&state.poses, reach, &mut self.contacts);
            self.is_lenient = false;
            let solved = match self.press(&state.poses, h) {
                // a body squeezed by rounding in a snug slot has no admissible impulses; one squeezed by more has none
                // that matter
                Err(Refused::NoSolution(_)) => {
                    self.is_lenient = true;
                    self.press(&state.poses, h)?
                }
                pressed => pressed?,
            };
            // impulses may have made a body faster than the reach of the contacts allows for
            let needed = self.nearby.reach(&self.velocities, h);
            if needed <= reach {
                state.advance(h, 1.0, &self.velocities);
                state.time += h;
                return Ok(solved);
            }
            reach = 2.0 * needed;
        }
    }

    fn touches(&self) -> impl Iterator<Item = (&Contact<S>, [f64; 3])> {
        self.pressed.iter().zip(self.impulses.answer.iter().copied())
    }

    fn deepest(&self) -> f64 {
        deepest(&self.contacts)
    }

    fn forces(&self, world: &World<S>, state: &State<S>) -> Option<Forces> {
        self.impulses.forces(world, &state.poses, &self.pressed, self.h)
    }

    fn is_suspect(&self) -> bool {
        self.impulses.is_suspect
    }
}
