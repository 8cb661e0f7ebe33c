//! Stewart and Trinkle's step with restitution: "one stops the ST model at the time of the impact, applies an impact
//! model, resets the velocity variables, and resumes time stepping".

use super::contact::Contact;
use super::forces::Forces;
use super::impact::Impact;
use super::impulses::{FrictionCone, Impulses};
use super::mechanics::Mechanics;
use super::nearby::Nearby;
use super::solved::{Refused, Solved};
use super::state::State;
use super::stepper::Stepper;
use super::stewart_trinkle::StewartTrinkle;
use super::touches::Touches;
use crate::answer::ContactName;
use crate::model::World;

/// Most stops in one step; what closes after them does not bounce.
const MAX_STOPS: usize = 32;

/// Steps a world by (10)-(13), stopped where something that restitutes closes.
#[derive(Debug)]
pub(super) struct Stopped<'w, S: Mechanics> {
    world: &'w World<S>,
    scheme: StewartTrinkle<'w, S>,
    nearby: Nearby<'w, S>,
    impulses: Impulses<S>,
    contacts: Vec<Contact<S>>,
    free: Vec<S::Velocity>,
    /// Impulses of the whole step, and when each began (s).
    touches: Touches<S>,
    deepest: f64,
    is_suspect: bool,
}

impl<'w, S: Mechanics> Stopped<'w, S> {
    /// `recovery_speed` as in [`StewartTrinkle::new`].
    pub fn new(world: &'w World<S>, recovery_speed: f64) -> Self {
        Self {
            world,
            scheme: StewartTrinkle::new(world, recovery_speed),
            nearby: Nearby::new(world),
            impulses: Impulses::new(world, FrictionCone::Edges),
            contacts: Vec::new(),
            free: Vec::new(),
            touches: Touches::default(),
            deepest: 0.0,
            is_suspect: false,
        }
    }

    /// The first time within `left` at which something that restitutes closes.
    ///
    /// The scheme moves by `τ (ν + τ M⁻¹ u)`, so that a gap closes at a root of a quadratic.
    fn next_stop(&mut self, state: &State<S>, left: f64) -> Option<f64> {
        state.free(self.world, left, &mut self.free);
        let reach = self.nearby.reach(&state.velocities, left).max(self.nearby.reach(&self.free, left));
        self.nearby.find(&state.poses, reach, &mut self.contacts);
        let touching = self.nearby.touching();
        let bounces = |contact: &&Contact<S>| contact.material.restitution.coefficient() > 0.0;
        let closing = |contact: &Contact<S>| {
            let speed = contact.velocity(0, &state.velocities);
            if contact.gap <= touching {
                return (speed < 0.0).then_some(0.0);
            }
            let pull = (contact.velocity(0, &self.free) - speed) / left;
            first_root(contact.gap, speed, pull).filter(|time| *time <= left)
        };
        self.contacts.iter().filter(bounces).filter_map(closing).min_by(f64::total_cmp)
    }

    /// The impact of what has come within what the last substep may have left open.
    fn strike(&mut self, state: &mut State<S>, slack: f64, h: f64, total: &mut Solved) -> Result<(), Refused> {
        self.nearby.find(&state.poses, slack, &mut self.contacts);
        let impact = Impact { touching: slack, h, is_plastic: false };
        for (contact, impulse) in impact.strike(self.world, &mut self.impulses, &self.contacts, state, total)? {
            self.touches.add(&contact, impulse, state.time);
        }
        Ok(())
    }
}

/// Smallest positive root of `gap + speed τ + pull τ²`.
pub(super) fn first_root(gap: f64, speed: f64, pull: f64) -> Option<f64> {
    let discriminant = speed * speed - 4.0 * pull * gap;
    if discriminant < 0.0 {
        return None;
    }
    let sum = -0.5 * (speed + discriminant.sqrt().copysign(speed));
    let roots = [sum / pull, gap / sum];
    roots.into_iter().filter(|root| *root > 0.0 && root.is_finite()).min_by(f64::total_cmp)
}

impl<S: Mechanics> Stepper<S> for Stopped<'_, S> {
    fn step(&mut self, state: &mut State<S>, h: f64) -> Result<Solved, Refused> {
        let start = state.clone();
        self.touches.clear();
        (self.deepest, self.is_suspect) = (0.0, false);
        let (mut left, mut stops, mut total) = (h, 0, Solved::nothing());
        let substep = |this: &mut Self, state: &mut State<S>, r: f64, total: &mut Solved| -> Result<(), Refused> {
            total.add(this.scheme.step(state, r)?);
            this.deepest = this.deepest.max(this.scheme.deepest());
            this.is_suspect |= this.scheme.is_suspect();
            this.scheme.touches().for_each(|(contact, impulse)| this.touches.add(contact, impulse, state.time));
            Ok(())
        };
        while left > 1e-12 * h {
            let stop = self.next_stop(state, left).filter(|_| stops < MAX_STOPS);
            let done = match stop {
                None => substep(self, state, left, &mut total).map(|()| left = 0.0),
                Some(after) => {
                    stops += 1;
                    // the gap was closed to first order: curvature leaves up to (ω τ)² of the size
                    let turned = self.nearby.closing_speed(&state.velocities) * after;
                    let slack = self.nearby.touching() + turned * turned / self.nearby.size();
                    let moved = if after > 0.0 { substep(self, state, after, &mut total) } else { Ok(()) };
                    left -= after;
                    moved.and_then(|()| self.strike(state, slack, h, &mut total))
                }
            };
            if let Err(refused) = done {
                *state = start;
                return Err(refused);
            }
        }
        Ok(total)
    }

    fn touches(&self) -> impl Iterator<Item = (&Contact<S>, [f64; 3])> {
        self.touches.iter()
    }

    fn deepest(&self) -> f64 {
        self.deepest
    }

    fn touched_at(&self, name: &ContactName) -> Option<f64> {
        self.touches.since(name)
    }

    fn forces(&self, world: &World<S>, state: &State<S>) -> Option<Forces> {
        self.scheme.forces(world, state)
    }

    fn is_suspect(&self) -> bool {
        self.is_suspect
    }
}

#[cfg(test)]
mod tests {
    use super::first_root;

    #[test]
    fn roots_are_the_first_ahead() {
        let root = |gap: f64, speed: f64, pull: f64| first_root(gap, speed, pull);
        assert_eq!(root(1.0, -2.0, 0.0), Some(0.5));
        assert_eq!(root(2.0, 1.0, -1.0), Some(2.0));
        assert_eq!(root(2.0, -3.0, 1.0), Some(1.0));
        assert_eq!((root(1.0, 1.0, 1.0), root(1.0, 0.5, 0.0)), (None, None));
    }
}
