//! Which features may meet within a step.

use super::contact::Contact;
use super::mechanics::Mechanics;
use crate::model::World;

/// Finds the contacts of a world; keeps its memory between steps.
#[derive(Debug)]
pub(super) struct Nearby<'w, S: Mechanics> {
    world: &'w World<S>,
    pub outlines: S::Outlines,
    radii: Vec<f64>,
}

impl<'w, S: Mechanics> Nearby<'w, S> {
    pub fn new(world: &'w World<S>) -> Self {
        Self { world, outlines: S::outlines(world), radii: world.bodies.iter().map(S::radius).collect() }
    }

    /// Radius of the largest body about its center of mass, of those that have one (m).
    pub fn largest(&self) -> f64 {
        self.radii.iter().copied().filter(|radius| radius.is_finite()).fold(0.0, f64::max)
    }

    /// Radius of the smallest body about its center of mass (m).
    pub fn size(&self) -> f64 {
        self.radii.iter().copied().fold(f64::INFINITY, f64::min)
    }

    /// A gap up to this counts as touching: a billionth of the smallest body (m).
    pub fn touching(&self) -> f64 {
        1e-9 * self.size().min(1e3)
    }

    /// Least distance over which one outline can pass through another unseen, from contact to contact (m).
    pub fn thinnest(&self) -> f64 {
        let n = self.world.bodies.len();
        let half = |at: usize| match at.checked_sub(n) {
            None => S::half_thickness(&self.world.bodies[at].shape),
            Some(fixed) => S::half_thickness(&self.world.fixed[fixed].shape),
        };
        let pairs = (0..n).flat_map(|a| (a + 1..n + self.world.fixed.len()).map(move |b| (a, b)));
        pairs.map(|(a, b)| half(a) + half(b)).fold(f64::INFINITY, f64::min)
    }

    /// A distance beyond which no pair of features meets in a step at these velocities, or the scene's margin if that is
    /// larger (m).
    pub fn reach(&self, velocities: &[S::Velocity], h: f64) -> f64 {
        self.reach_beyond(0.0, velocities, h)
    }

    /// The same for pairs that count as closed up to a gap of `closed` (m).
    pub fn reach_beyond(&self, closed: f64, velocities: &[S::Velocity], h: f64) -> f64 {
        let swept = 1.1 * h * self.closing_speed(velocities) + closed;
        self.world.margin.map_or(swept, |margin| margin.max(swept))
    }

    /// A speed at which no two points approach each other faster (m/s).
    pub fn closing_speed(&self, velocities: &[S::Velocity]) -> f64 {
        let (mut first, mut second) = (0.0_f64, 0.0_f64);
        for (radius, velocity) in self.radii.iter().zip(velocities) {
            let speed = S::fastest(*radius, velocity);
            (first, second) = if speed > first { (speed, first) } else { (first, second.max(speed)) };
        }
        first + second
    }

    /// Every contact with a gap of at most `reach`, in a fixed order.
    pub fn find(&mut self, poses: &[S::Pose], reach: f64, out: &mut Vec<Contact<S>>) {
        S::contacts(&mut self.outlines, self.world, poses, reach, out);
    }
}
