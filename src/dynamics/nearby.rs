//! Which features may meet within a step.

use super::contact::Contact;
use super::mechanics::Mechanics;
use crate::model::World;

/// Finds the contacts of a world; keeps its memory between steps.
#[derive(Debug)]
pub(super) struct Nearby<'w, S: Mechanics> {
    world: &'w World<S>,
    outlines: S::Outlines,
    radii: Vec<f64>,
}

impl<'w, S: Mechanics> Nearby<'w, S> {
    pub fn new(world: &'w World<S>) -> Self {
        Self { world, outlines: S::outlines(world), radii: world.bodies.iter().map(S::radius).collect() }
    }

    /// Radius of the smallest body about its center of mass (m).
    pub fn size(&self) -> f64 {
        self.radii.iter().copied().fold(f64::INFINITY, f64::min)
    }

    /// A distance beyond which no pair of features meets in a step at these velocities, or the scene's margin if that is
    /// larger (m).
    pub fn reach(&self, velocities: &[S::Velocity], h: f64) -> f64 {
        let (mut first, mut second) = (0.0_f64, 0.0_f64);
        for (radius, velocity) in self.radii.iter().zip(velocities) {
            let speed = S::fastest(*radius, velocity);
            (first, second) = if speed > first { (speed, first) } else { (first, second.max(speed)) };
        }
        let swept = 1.1 * h * (first + second);
        self.world.margin.map_or(swept, |margin| margin.max(swept))
    }

    /// Every contact with a gap of at most `reach`, in a fixed order.
    pub fn find(&mut self, poses: &[S::Pose], reach: f64, out: &mut Vec<Contact<S>>) {
        S::contacts(&mut self.outlines, self.world, poses, reach, out);
    }
}
