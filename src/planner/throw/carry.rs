//! Carries that were asked for.

use super::{CarryQuestion, ThrowError};
use crate::answer::Carry;
use crate::exact::Q;
use crate::mechanics::throwing::{Load, RestingEdge};
use crate::model::Thrower;

/// The accelerations of each, with the least friction that the case allows; the edges asked about are there.
pub(super) fn carries(
    edges: &[RestingEdge],
    rho2: &Q,
    thrower: &Thrower,
    asked: &[CarryQuestion],
) -> Result<Vec<Carry>, ThrowError> {
    let carry = |carry: &CarryQuestion| {
        let friction = &thrower.friction.as_ref().ok_or(ThrowError::NoFriction)?.min;
        let load = Load {
            edge: edges[carry.edge].clone(),
            radius: carry.radius.clone(),
            offset: thrower.offset.clone(),
            rho2: rho2.clone(),
            gravity: thrower.gravity.clone(),
            friction: Some(friction.clone()),
        };
        Ok(Carry {
            edge: carry.edge,
            radius: carry.radius.clone(),
            angle_deg: carry.angle_deg.clone(),
            rate: carry.rate.clone(),
            friction: friction.clone(),
            accelerations: load.accelerations_at(&carry.angle_deg, &carry.rate),
        })
    };
    asked.iter().map(carry).collect()
}
