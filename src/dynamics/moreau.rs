//! Moreau's midpoint step with impacts located inside it.
//!
//! Velocities change as in (10)-(13) but without φ/h: what touches keeps touching or leaves. Positions move at the mean
//! velocity and rows of W are those of the midpoint, so that motion between impacts is second order in h. A gap that
//! closes within a step ends a shorter one, and there the law of impact acts.

use super::contact::{Contact, deepest};
use super::forces::Forces;
use super::impact::Impact;
use super::impulses::{FrictionCone, Impulses};
use super::mechanics::Mechanics;
use super::nearby::Nearby;
use super::project::{Held, project};
use super::solved::{Refused, Solved};
use super::state::State;
use super::stepper::Stepper;
use super::stopped::first_root;
use super::touches::Touches;
use crate::answer::ContactName;
use crate::model::World;

/// Most impacts located in one step; what closes after them in the same step is held closed without bouncing.
const MAX_IMPACTS: usize = 32;

/// Most times in one step that a closing gap is located; features that replace each other may close without an impact.
const MAX_LOCATIONS: usize = 4 * MAX_IMPACTS;

/// Most substeps tried to locate one impact.
const MAX_TRIALS: usize = 60;

/// Overlap, relative to the smallest body, that counts as held when projections do not undo it.
const HELD_OVERLAP: f64 = 1e-3;

/// Most pieces that a step is cut into so that nothing is passed through.
const MAX_PIECES: f64 = 1e6;

/// Most projections after a substep.
const MAX_PROJECTIONS: usize = 4;

/// Steps a world by Moreau's midpoint rule; keeps its memory between steps.
#[derive(Debug)]
pub(super) struct Moreau<'w, S: Mechanics> {
    world: &'w World<S>,
    nearby: Nearby<'w, S>,
    impulses: Impulses<S>,
    current: State<S>,
    trial: State<S>,
    /// Contacts at `current`, at the middle of the substep and at `trial`.
    here: Vec<Contact<S>>,
    middle: Vec<Contact<S>>,
    there: Vec<Contact<S>>,
    /// Contacts that hold in the substep, with the rows that it uses.
    closed: Vec<Contact<S>>,
    offsets: Vec<f64>,
    velocities: Vec<S::Velocity>,
    middle_poses: Vec<S::Pose>,
    /// Contacts that held in the last substep, and whether they pressed.
    held: Vec<(ContactName, bool)>,
    /// Contacts held closed to the end of the step because too many impacts were met.
    forced: Vec<ContactName>,
    /// What the substep passed through.
    passed: Vec<ContactName>,
    /// Impulses of the whole step by contact, and when each began.
    touches: Touches<S>,
    /// A gap up to this counts as touching (m).
    touching: f64,
    /// Least distance over which one outline can pass through another unseen (m).
    thinnest: f64,
    /// Length of the last substep (s).
    substep: f64,
    /// Length of the whole step (s).
    h: f64,
    deepest: f64,
    /// Whether the step starts with more overlap than its own errors leave.
    overlaps: bool,
    /// Energy that undoing such overlaps has added in the step (J).
    corrected: f64,
}

impl<'w, S: Mechanics> Moreau<'w, S> {
    pub fn new(world: &'w World<S>) -> Self {
        let nearby = Nearby::new(world);
        let (touching, thinnest) = (nearby.touching(), nearby.thinnest());
        Self {
            world,
            nearby,
            impulses: Impulses::new(world, FrictionCone::Disc),
            current: State::start(world),
            trial: State::start(world),
            here: Vec::new(),
            middle: Vec::new(),
            there: Vec::new(),
            closed: Vec::new(),
            offsets: Vec::new(),
            velocities: Vec::new(),
            middle_poses: Vec::new(),
            held: Vec::new(),
            forced: Vec::new(),
            passed: Vec::new(),
            touches: Touches::default(),
            touching,
            thinnest,
            substep: 0.0,
            h: 0.0,
            deepest: 0.0,
            overlaps: false,
            corrected: 0.0,
        }
    }

    /// Tries the motion over `r` from `current` to `trial`; what it passes through is in `passed` after it.
    fn substep(&mut self, r: f64, total: &mut Solved) -> Result<(), Refused> {
        self.current.free(self.world, r, &mut self.velocities);
        self.close(r);
        if !self.closed.is_empty() {
            let poses = if self.middle.is_empty() { &self.current.poses } else { &self.middle_poses };
            let solved =
                self.impulses.solve(self.world, poses, &self.closed, &self.offsets, &[], &mut self.velocities)?;
            total.add(solved);
        }
        self.trial.clone_from(&self.current);
        self.trial.advance(r, 0.5, &self.velocities);
        self.trial.time += r;
        self.substep = r;
        let reach = self.nearby.reach(&self.velocities, self.h) + self.touching;
        self.nearby.find(&self.trial.poses, reach, &mut self.there);
        self.passed.clear();
        for contact in self.there.iter().filter(|contact| contact.gap < -self.touching) {
            let is_closed = |closed: &Contact<S>| closed.name == contact.name;
            if self.closed.iter().any(is_closed) || self.is_another_name(contact) {
                continue;
            }
            self.passed.push(contact.name);
        }
        Ok(())
    }

    /// Whether a contact that was not there before is one of `closed` whose features changed on the way.
    fn is_another_name(&self, contact: &Contact<S>) -> bool {
        let ContactName { body, other, .. } = contact.name;
        let is_pair = |name: ContactName| name.body == body && name.other == other;
        contact.gap > -1e4 * self.touching
            && self.here.iter().all(|here| here.name != contact.name)
            && self.closed.iter().any(|closed| is_pair(closed.name))
    }

    /// Collects the contacts that hold over `r`, with the rows of the middle: there (W_m)ᵀ ν' + (r/2) Ẇᵀ ν is the velocity
    /// at the end, up to terms of second order.
    fn close(&mut self, r: f64) {
        self.closed.clear();
        self.offsets.clear();
        self.middle.clear();
        let velocities = &self.current.velocities;
        let holds = |contact: &Contact<S>| {
            let is_pressed = || self.held.iter().any(|(name, is_pressed)| *name == contact.name && *is_pressed);
            let leaves = || contact.velocity(0, velocities) * r > 10.0 * self.touching;
            self.forced.contains(&contact.name) || contact.gap <= self.touching && (is_pressed() || !leaves())
        };
        self.closed.extend(self.here.iter().filter(|contact| holds(contact)));
        let is_moving = velocities.iter().any(|velocity| velocity.as_ref().iter().any(|v| v.abs() * r > self.touching));
        if self.closed.is_empty() || !is_moving {
            self.offsets.resize(self.closed.len(), 0.0);
            return;
        }
        self.middle_poses.clear();
        let moved = |(pose, velocity)| S::advanced(pose, velocity, 0.5 * r);
        self.middle_poses.extend(self.current.poses.iter().zip(velocities).map(moved));
        let reach = self.nearby.reach(velocities, r) + self.touching;
        self.nearby.find(&self.middle_poses, reach, &mut self.middle);
        for contact in &mut self.closed {
            let Some(middle) = self.middle.iter().find(|middle| middle.name == contact.name) else {
                self.offsets.push(0.0);
                continue;
            };
            let change = |row: usize| middle.velocity(row, velocities) - contact.velocity(row, velocities);
            self.offsets.push(change(0));
            let mut surface = middle.surface;
            for row in 1..=S::TANGENTS {
                surface[row - 1] -= change(row);
            }
            *contact = Contact { surface, ..*middle };
        }
    }

    /// Takes `trial` for `current`, with its impulses, and puts it back onto the contacts that hold.
    fn accept(&mut self) -> Result<(), Refused> {
        std::mem::swap(&mut self.current, &mut self.trial);
        std::mem::swap(&mut self.here, &mut self.there);
        let answer = &self.impulses.answer;
        self.held.clear();
        let time = self.current.time - self.substep;
        for (contact, impulse) in self.closed.iter().zip(answer) {
            self.held.push((contact.name, impulse[0] > 0.0));
            self.touches.add(contact, *impulse, time);
        }
        let met = deepest(&self.here);
        for _ in 0..MAX_PROJECTIONS {
            let held: Vec<Held<S>> = self.here.iter().filter_map(|contact| self.to_project(contact)).collect();
            if held.is_empty() {
                return Ok(());
            }
            self.deepest = held.iter().map(|held| -held.contact.gap).fold(self.deepest, f64::max);
            let before = self.current.energy(self.world);
            project(self.world, &mut self.current.poses, &held);
            if self.overlaps {
                self.corrected += self.current.energy(self.world) - before;
            }
            self.look();
        }
        // projections that fail may have made it deeper: what the bodies came with is said
        let (left, allowed) = (deepest(&self.here), HELD_OVERLAP * self.nearby.size());
        let depth = if met > allowed { met } else { left };
        if left > allowed { Err(Refused::Overlap { depth }) } else { Ok(()) }
    }

    /// A contact to put back: overlapping, or pressed and apart.
    fn to_project(&self, contact: &Contact<S>) -> Option<Held<S>> {
        let is_pressed = || self.held.iter().any(|(name, is_pressed)| *name == contact.name && *is_pressed);
        let is_off = contact.gap.abs() > 0.01 * self.touching;
        let is_pressed = is_off && is_pressed();
        (is_pressed || contact.gap < -self.touching).then_some(Held { contact: *contact, is_pressed })
    }

    /// At most `left`, and so little that nothing passes through anything unseen.
    fn seen(&self, left: f64) -> f64 {
        if self.here.is_empty() || self.thinnest == f64::INFINITY {
            return left;
        }
        let speed =
            self.nearby.closing_speed(&self.current.velocities).max(self.nearby.closing_speed(&self.velocities));
        let pieces = (left * speed / (0.5 * self.thinnest)).ceil();
        if pieces > 1.0 { left / pieces.min(MAX_PIECES) } else { left }
    }

    /// Finds the contacts at `current`.
    fn look(&mut self) {
        self.current.free(self.world, self.h, &mut self.velocities);
        let fastest = self.nearby.reach(&self.current.velocities, self.h);
        let reach = fastest.max(self.nearby.reach(&self.velocities, self.h)) + self.touching;
        self.nearby.find(&self.current.poses, reach, &mut self.here);
    }

    /// Shortens the substep until it ends where the first of `passed` closes; returns its length.
    fn locate(&mut self, r: f64, total: &mut Solved) -> Result<f64, Refused> {
        let passed = std::mem::take(&mut self.passed);
        let least = |contacts: &[Contact<S>]| {
            let gaps = contacts.iter().filter(|contact| passed.contains(&contact.name)).map(|contact| contact.gap);
            gaps.fold(f64::INFINITY, f64::min)
        };
        let (mut high, mut at_high) = (r, least(&self.there));
        let at_start = least(&self.here);
        let (mut low, mut at_low) = (0.0, at_start);
        // what leaves and comes back within the substep is clear somewhere in between
        let mut clear = r;
        while at_low <= self.touching && clear > 1e-9 * r {
            clear *= 0.5;
            self.substep(clear, total)?;
            match least(&self.there) {
                gap if gap > self.touching => (low, at_low) = (clear, gap),
                gap if gap < -self.touching => (high, at_high) = (clear, gap),
                _ => {}
            }
        }
        if at_low <= self.touching {
            self.forced.extend(&passed);
            return Ok(0.0);
        }
        // the motion of a gap is close to a parabola through what is known of it: its root, then regula falsi, Illinois
        let speed = self.here.iter().filter(|contact| passed.contains(&contact.name));
        let speed = speed.map(|contact| contact.velocity(0, &self.current.velocities)).fold(f64::INFINITY, f64::min);
        let parabola =
            |length: f64, gap: f64| first_root(at_start, speed, (gap - at_start - speed * length) / (length * length));
        let mut guess = if passed.len() == 1 && low == 0.0 { parabola(high, at_high) } else { None };
        let mut last_side = 0;
        for trial in 0..MAX_TRIALS {
            let gaps = if at_low.is_finite() { at_low - at_high } else { 0.0 };
            let inside = guess.take().unwrap_or(high + at_high * (high - low) / gaps);
            let at = if trial % 8 == 7 || !(inside > low && inside < high) { 0.5 * (low + high) } else { inside };
            self.substep(at, total)?;
            let gap = least(&self.there);
            if gap.abs() <= 0.5 * self.touching || trial + 1 == MAX_TRIALS {
                self.accept()?;
                return Ok(at);
            }
            if gap > 0.0 {
                (low, at_low) = (at, gap);
                at_high *= if last_side == 1 { 0.5 } else { 1.0 };
                last_side = 1;
            } else {
                (high, at_high) = (at, gap);
                at_low *= if last_side == -1 { 0.5 } else { 1.0 };
                last_side = -1;
            }
        }
        Ok(0.0)
    }
}

impl<S: Mechanics> Stepper<S> for Moreau<'_, S> {
    fn step(&mut self, state: &mut State<S>, h: f64) -> Result<Solved, Refused> {
        (self.h, self.deepest, self.corrected) = (h, 0.0, 0.0);
        self.current.clone_from(state);
        self.current.drive(self.world);
        self.impulses.is_suspect = false;
        self.touches.clear();
        self.forced.clear();
        self.look();
        self.deepest = deepest(&self.here);
        self.overlaps = self.deepest > 1e3 * self.touching;
        let mut total = Solved::nothing();
        let mut left = h;
        let (mut impacts, mut locations) = (0, 0);
        while left > 1e-12 * h {
            let impact = Impact { touching: self.touching, h, is_plastic: impacts >= MAX_IMPACTS };
            let held = |name: &ContactName| self.held.iter().any(|(held, _)| held == name);
            let hits = impact.hits(&self.here, &self.current.velocities, held);
            if hits {
                impacts += 1;
                let struck =
                    impact.strike(self.world, &mut self.impulses, &self.here, &mut self.current, &mut total)?;
                for (contact, impulse) in struck {
                    self.touches.add(&contact, impulse, self.current.time);
                }
            }
            let r = self.seen(left);
            self.substep(r, &mut total)?;
            // what was to be held closed and is not even near is left to the projections
            if self.passed.iter().all(|name| self.forced.contains(name)) {
                self.accept()?;
                left -= r;
                continue;
            }
            if impacts >= MAX_IMPACTS || locations >= MAX_LOCATIONS {
                self.forced.append(&mut self.passed);
                continue;
            }
            locations += 1;
            left -= self.locate(r, &mut total)?;
        }
        std::mem::swap(state, &mut self.current);
        Ok(total)
    }

    fn touches(&self) -> impl Iterator<Item = (&Contact<S>, [f64; 3])> {
        self.touches.iter()
    }

    fn deepest(&self) -> f64 {
        self.deepest
    }

    fn corrected(&self) -> f64 {
        self.corrected
    }

    fn touched_at(&self, name: &ContactName) -> Option<f64> {
        self.touches.since(name)
    }

    fn forces(&self, world: &World<S>, state: &State<S>) -> Option<Forces> {
        self.impulses.forces(world, &state.poses, &self.closed, self.h)
    }

    fn is_suspect(&self) -> bool {
        self.impulses.is_suspect
    }
}
