//! Where the bodies are and how they move.

use super::contact::{add_scaled, dot};
use super::mechanics::Mechanics;
use crate::model::{Body, World};

/// Poses and velocities at a time.
#[derive(Debug, PartialEq)]
pub(super) struct State<S: Mechanics> {
    pub time: f64,
    pub poses: Vec<S::Pose>,
    pub velocities: Vec<S::Velocity>,
}

impl<S: Mechanics> Clone for State<S> {
    fn clone(&self) -> Self {
        Self { time: self.time, poses: self.poses.clone(), velocities: self.velocities.clone() }
    }

    fn clone_from(&mut self, other: &Self) {
        self.time = other.time;
        self.poses.clone_from(&other.poses);
        self.velocities.clone_from(&other.velocities);
    }
}

impl<S: Mechanics> State<S> {
    pub fn start(world: &World<S>) -> Self {
        let bodies = &world.bodies;
        Self {
            time: 0.0,
            poses: bodies.iter().map(|body| body.pose).collect(),
            velocities: bodies.iter().map(|body| body.velocity).collect(),
        }
    }

    /// Velocities after `h` without contacts, `ν + M⁻¹ u h` of (13); kinematic bodies take the velocity of the time.
    pub fn free(&self, world: &World<S>, h: f64, velocities: &mut Vec<S::Velocity>) {
        velocities.clone_from(&self.velocities);
        for ((body, pose), velocity) in world.bodies.iter().zip(&self.poses).zip(velocities) {
            if body.is_kinematic {
                *velocity = *body.scheduled(self.time).unwrap_or(&body.velocity);
                continue;
            }
            let mut wrench = S::own_wrench(&world.gravity, body, pose, velocity);
            add_scaled(&mut wrench, 1.0, &applied(body, pose, self.time));
            add_scaled(velocity, h, &S::weighed(body, pose, &wrench));
        }
    }

    /// Gives kinematic bodies the velocity of the time.
    pub fn drive(&mut self, world: &World<S>) {
        for (body, velocity) in world.bodies.iter().zip(&mut self.velocities).filter(|(body, _)| body.is_kinematic) {
            *velocity = *body.scheduled(self.time).unwrap_or(&body.velocity);
        }
    }

    /// Moves every body at the mean of `(1 - weight) ν + weight ν'` for `h`, then takes the velocities `new`.
    pub fn advance(&mut self, h: f64, weight: f64, new: &[S::Velocity]) {
        for ((pose, velocity), new) in self.poses.iter_mut().zip(&mut self.velocities).zip(new) {
            let mut mean = *new;
            if weight != 1.0 {
                for (mean, old) in mean.as_mut().iter_mut().zip(velocity.as_ref()) {
                    *mean = (1.0 - weight) * old + weight * *mean;
                }
            }
            *pose = S::advanced(pose, &mean, h);
            *velocity = *new;
        }
    }

    /// Kinetic and potential energy of the free bodies (J).
    pub fn energy(&self, world: &World<S>) -> f64 {
        let bodies = world.bodies.iter().zip(&self.poses).filter(|(body, _)| !body.is_kinematic);
        let potential: f64 = bodies.map(|(body, pose)| body.mass * S::potential(&world.gravity, pose)).sum();
        self.kinetic_energy(world) + potential
    }

    /// Kinetic energy of the free bodies (J).
    pub fn kinetic_energy(&self, world: &World<S>) -> f64 {
        let bodies = world.bodies.iter().zip(&self.poses).zip(&self.velocities);
        let free = bodies.filter(|((body, _), _)| !body.is_kinematic);
        free.map(|((body, pose), velocity)| 0.5 * dot(velocity, &S::momentum(body, pose, velocity))).sum()
    }
}

/// The wrench that acts on a free body besides gravity: that of its schedule, and that of a finger.
pub(super) fn applied<S: Mechanics>(body: &Body<S>, pose: &S::Pose, time: f64) -> S::Velocity {
    let mut wrench = body.scheduled(time).copied().unwrap_or_default();
    if let Some(push) = body.finger.and_then(|finger| S::push(body, &finger, pose)) {
        add_scaled(&mut wrench, 1.0, &push);
    }
    wrench
}
