//! Whether a scene can be stepped with compliant contacts, and what in it is too soft to mean much.

use super::super::judge::short;
use super::super::mechanics::Mechanics;
use crate::model::{Body, Space, World};

/// Why a scene was not run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SimulationError {
    /// A body is a half plane or half space, which only fixed things can be.
    #[error("body {body} has no other side: only fixed things can be half planes or half spaces")]
    FixedOnly {
        /// Number of the body.
        body: usize,
    },
    /// The model needs compliance and the material between these two has none.
    #[error("bodies {body} and {other} can touch, and their material has no stiffness and damping")]
    NoCompliance {
        /// Number of the body.
        body: usize,
        /// A body after it, or the number of bodies plus that of an obstacle.
        other: usize,
    },
    /// The adverse policy is asked for, and the scene or the model is not of the kind that it is known for.
    #[error(
        "only one free body in the plane without restitution has its most adverse motion found, stepped by Stewart and Trinkle's model"
    )]
    Adverse,
    /// Stiffness not positive, damping or gamma negative, or one of them not finite.
    #[error("the compliance between bodies {body} and {other} is no stiffness above 0, no damping or gamma from 0")]
    Compliance {
        /// Number of the body.
        body: usize,
        /// A body after it, or the number of bodies plus that of an obstacle.
        other: usize,
    },
}

/// Every body has a shape whose contacts are found.
pub(in crate::dynamics) fn check_shapes<S: Mechanics>(world: &World<S>) -> Result<(), SimulationError> {
    match world.bodies.iter().position(|body| S::is_fixed_only(&body.shape)) {
        Some(body) => Err(SimulationError::FixedOnly { body }),
        None => Ok(()),
    }
}

/// Every pair that can touch has a usable compliance.
pub(in crate::dynamics) fn check<S: Space>(world: &World<S>) -> Result<(), SimulationError> {
    for (body, other) in pairs(world) {
        let Some(compliance) = world.material(body, other).compliance else {
            return Err(SimulationError::NoCompliance { body, other });
        };
        let is_positive = compliance.stiffness.iter().all(|k| *k > 0.0 && k.is_finite());
        let mut others = compliance.damping.iter().chain([&compliance.gamma]);
        if !is_positive || !others.all(|x| *x >= 0.0 && x.is_finite()) {
            return Err(SimulationError::Compliance { body, other });
        }
    }
    Ok(())
}

/// What is worth knowing of a scene before it runs: bodies that sink under their own weight by more than half their
/// thickness, or start so fast that they might push through what they meet.
pub(in crate::dynamics) fn notes<S: Mechanics>(world: &World<S>) -> Vec<String> {
    let mut notes = Vec::new();
    let gravity = world.gravity.as_ref().iter().map(|g| g * g).sum::<f64>().sqrt();
    let half = |other: usize| match other.checked_sub(world.bodies.len()) {
        None => S::half_thickness(&world.bodies[other].shape),
        Some(fixed) => S::half_thickness(&world.fixed[fixed].shape),
    };
    for (body, other) in pairs(world) {
        let Some(compliance) = world.material(body, other).compliance else {
            continue;
        };
        let half = half(body).min(half(other));
        for at in [body, other] {
            let Some(Body { mass, name, velocity, is_kinematic: false, shape: _, .. }) = world.bodies.get(at) else {
                continue;
            };
            let with = name_of(world, if at == body { other } else { body });
            let sink = mass * gravity / compliance.stiffness[0];
            if sink > half {
                notes.push(format!(
                    "{name} on {with} sinks by {} m under its weight, more than half the thickness, {} m",
                    short(sink),
                    short(half)
                ));
            }
            let speed = S::fastest(0.0, velocity);
            let depth = speed * (mass / compliance.stiffness[0]).sqrt().min(mass / compliance.damping[0]);
            if depth > half {
                notes.push(format!(
                    "at its first speed {name} would be up to {} m deep in {with}, more than half the thickness, {} m",
                    short(depth),
                    short(half)
                ));
            }
        }
    }
    notes
}

/// The pairs that can touch and move.
fn pairs<S: Space>(world: &World<S>) -> impl Iterator<Item = (usize, usize)> {
    let n = world.bodies.len();
    let all = (0..n).flat_map(move |body| (body + 1..n + world.fixed.len()).map(move |other| (body, other)));
    all.filter(move |(body, other)| {
        let is_held = |at: usize| world.bodies.get(at).is_none_or(|body| body.is_kinematic);
        !(is_held(*body) && is_held(*other))
    })
}

fn name_of<S: Space>(world: &World<S>, at: usize) -> &str {
    match at.checked_sub(world.bodies.len()) {
        None => &world.bodies[at].name,
        Some(fixed) => &world.fixed[fixed].name,
    }
}
