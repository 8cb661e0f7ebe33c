//! Guesses for the equation of a compliant step, one after the other until one leads to its solution.

use super::contact::add_scaled;
use super::mechanics::Mechanics;
use super::song_pang_kumar_law::Law;
use super::song_pang_kumar_newton::{Newton, Stage, Work};
use super::state::State;
use crate::model::World;

/// Shortest step that predicts the next longer one: h / 2⁸.
const PREDICTORS: i32 = 8;
/// Factor of friction beyond which nothing slips.
const ROUGH: f64 = 1e6;

/// How a step was solved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Climb {
    pub work: Work,
    /// Whether solutions of other problems had to lead the way.
    pub continued: bool,
}

impl<S: Mechanics> Newton<S> {
    /// The velocities after a step of `h` from `base`, the joints as found at the poses `found`; left in
    /// [`Newton::velocities`].
    ///
    /// The guesses: what the forces of before would do; no forces; solutions without slip and without
    /// friction; solutions of steps of h/2, h/4, ...
    pub fn climb(
        &mut self,
        world: &World<S>,
        outlines: &S::Outlines,
        found: &[S::Pose],
        base: &State<S>,
        h: f64,
    ) -> Option<Climb> {
        let mut free = std::mem::take(&mut self.free);
        let mut iterations = 0;
        let mut solve = |newton: &mut Self, scale: i32, friction: f64, guess: Guess| {
            let h = libm::scalbn(h, scale);
            base.free(world, h, &mut free);
            for joint in &mut newton.joints {
                if let Some(law) = Law::new(&joint.start.material, h) {
                    joint.law = law.with_friction(friction);
                }
            }
            match guess {
                Guess::Kept => {}
                Guess::Free => newton.velocities.clone_from(&free),
                Guess::Pushed => newton.push(world, &base.poses, &free, h),
            }
            let work = newton.solve(&Stage { world, outlines, found, poses: &base.poses, free: &free, h });
            iterations += work.map_or(0, |work| work.iterations);
            work
        };
        let is_pushed = self.joints.iter().any(|joint| joint.force.lambda[0] > 0.0);
        let mut found = is_pushed.then(|| solve(self, 0, 1.0, Guess::Pushed)).flatten();
        if found.is_none() {
            found = solve(self, 0, 1.0, Guess::Free);
        }
        let continued = found.is_none();
        for friction in [ROUGH, 0.0] {
            if found.is_none() && solve(self, 0, friction, Guess::Free).is_some() {
                found = solve(self, 0, 1.0, Guess::Kept);
            }
        }
        if found.is_none()
            && let Some(start) = (1..=PREDICTORS).find(|halvings| solve(self, -halvings, 1.0, Guess::Free).is_some())
        {
            for halvings in (0..start).rev() {
                found = solve(self, -halvings, 1.0, Guess::Kept);
                if found.is_none() {
                    break;
                }
            }
        }
        self.free = free;
        found.map(|work| Climb { work: Work { iterations, ..work }, continued })
    }

    /// The velocities that the forces of before would lead to.
    fn push(&mut self, world: &World<S>, poses: &[S::Pose], free: &[S::Velocity], h: f64) {
        self.velocities.clear();
        self.velocities.extend_from_slice(free);
        for joint in self.joints.iter().filter(|joint| joint.force.lambda[0] > 0.0) {
            for (body, rows) in joint.start.sides() {
                let mut wrench = S::Velocity::default();
                for (row, lambda) in rows.as_ref().iter().zip(joint.force.lambda) {
                    add_scaled(&mut wrench, h * lambda, row);
                }
                add_scaled(&mut self.velocities[body], 1.0, &S::weighed(&world.bodies[body], &poses[body], &wrench));
            }
        }
    }
}

#[derive(Debug, Clone, Copy)]
enum Guess {
    Kept,
    Free,
    Pushed,
}
