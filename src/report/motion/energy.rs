//! Mechanical energy of a frame.

use super::{Run, Shown};
use crate::answer::Frame;

/// Kinetic and potential energy of the free bodies (J); that of local deformation is not in a frame.
#[must_use]
pub fn energy<S: Shown>(run: &Run<S>, frame: &Frame<S>) -> f64 {
    let bodies = run.world.bodies.iter().zip(frame.poses.iter().zip(&frame.velocities));
    let free = bodies.filter(|(body, _)| !body.is_kinematic);
    free.map(|(body, (pose, velocity))| {
        let gravity = run.world.gravity.as_ref();
        let speed2: f64 = velocity.as_ref().iter().take(S::DIMENSION).map(|v| v * v).sum();
        let height: f64 = gravity.iter().zip(pose.as_ref()).map(|(g, x)| -g * x).sum();
        body.mass * (speed2 / 2.0 + height) + S::spin_energy(body, pose, velocity)
    })
    .sum()
}
