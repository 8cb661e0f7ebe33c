//! Stewart and Trinkle's step, equations (10)-(13): semi-implicit, gaps closed at the end of the step.

use super::adverse::{Motion, Problem};
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
    /// Whether of several motions the most adverse one is followed.
    pub is_adverse: bool,
    /// The contacts with an impulse under that motion, and these impulses.
    adverse: Option<Motion<S>>,
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
            is_adverse: false,
            adverse: None,
        }
    }

    /// Solves for the contacts that the free motion closes, then for those too that the answer closes, until none is left.
    fn press(&mut self, poses: &[S::Pose]) -> Result<Solved, Refused> {
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
            for (index, contact) in self.contacts.iter().enumerate() {
                let closes = || contact.velocity(0, &self.velocities) + self.gap_speed(contact) < 0.0;
                if !self.is_pressed[index] && closes() {
                    (self.is_pressed[index], grown) = (true, true);
                }
            }
            if !std::mem::take(&mut grown) {
                return Ok(total);
            }
            let pressed = self.contacts.iter().zip(&self.is_pressed).filter(|(_, is_pressed)| **is_pressed);
            self.pressed.clear();
            self.pressed.extend(pressed.map(|(contact, _)| *contact));
            self.offsets = self.pressed.iter().map(|contact| self.gap_speed(contact)).collect();
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

impl<S: Mechanics> StewartTrinkle<'_, S> {
    /// Solves with overlaps as they are, or where that is impossible with slight ones as none: a body squeezed by rounding
    /// in a snug slot has no admissible impulses.
    fn press_or_be_lenient(&mut self, poses: &[S::Pose]) -> Result<Solved, Refused> {
        (self.adverse, self.is_lenient) = (None, false);
        match self.press(poses) {
            Err(Refused::NoSolution(_)) => {
                self.is_lenient = true;
                self.press(poses)
            }
            pressed => pressed,
        }
    }

    /// Takes the most adverse of all motions that the step allows; `false` if none was found.
    fn turn_adverse(&mut self, poses: &[S::Pose]) -> bool {
        self.is_lenient = true;
        let offsets: Vec<f64> = self.contacts.iter().map(|contact| self.gap_speed(contact)).collect();
        let problem =
            Problem { world: self.world, poses, contacts: &self.contacts, offsets: &offsets, free: &self.free };
        let opening = |motion: &Motion<S>| problem.opening(&motion.velocities);
        let worst = problem.motions().into_iter().max_by(|a, b| opening(a).total_cmp(&opening(b)));
        if let Some(worst) = &worst {
            self.velocities.clone_from(&worst.velocities);
        }
        self.adverse = worst;
        self.adverse.is_some()
    }

    /// φ/h of (13), overlaps undone no faster than allowed.
    fn gap_speed(&self, contact: &Contact<S>) -> f64 {
        let slight = if self.is_lenient { SLIGHT_OVERLAP * self.touching } else { 0.0 };
        match contact.gap {
            gap if gap < 0.0 && gap > -slight => 0.0,
            gap => (gap / self.h).max(-self.recovery_speed),
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
            let solved = if self.is_adverse && self.turn_adverse(&state.poses) {
                Solved { problems: 1, closed: 1, ..Solved::nothing() }
            } else {
                self.press_or_be_lenient(&state.poses)?
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
        let (contacts, impulses) = match &self.adverse {
            Some(motion) => (&self.contacts, &motion.impulses),
            None => (&self.pressed, &self.impulses.answer),
        };
        contacts.iter().zip(impulses.iter().copied())
    }

    fn deepest(&self) -> f64 {
        deepest(&self.contacts)
    }

    fn forces(&self, world: &World<S>, state: &State<S>) -> Option<Forces> {
        if self.adverse.is_some() {
            return None;
        }
        self.impulses.forces(world, &state.poses, &self.pressed, self.h)
    }

    fn is_suspect(&self) -> bool {
        self.impulses.is_suspect
    }
}
