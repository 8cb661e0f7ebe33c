//! Poses back onto the contacts that hold them.

use super::contact::{Contact, add_scaled, dot};
use super::mechanics::{Mechanics, mobility};
use crate::model::World;

/// Most sweeps over the contacts.
const MAX_SWEEPS: usize = 100;

/// A contact to close.
#[derive(Debug, Clone, Copy)]
pub(super) struct Held<S: Mechanics> {
    pub contact: Contact<S>,
    /// Whether the gap is to vanish rather than only not to be negative.
    pub is_pressed: bool,
}

/// Moves poses by the smallest amount, measured by the mass matrix, that closes the gaps of `held` to first order; by
/// projected Gauss-Seidel, which redundant contacts do not stop.
pub(super) fn project<S: Mechanics>(world: &World<S>, poses: &mut [S::Pose], held: &[Held<S>]) {
    let mut shifts = vec![S::Velocity::default(); poses.len()];
    let weighed = |body: usize, row: &S::Velocity| S::weighed(&world.bodies[body], &poses[body], row);
    let compliance = |contact: &Contact<S>| -> f64 {
        contact.sides().map(|(body, rows)| mobility(world, poses, body, &rows.as_ref()[0])).sum()
    };
    let compliances: Vec<f64> = held.iter().map(|held| compliance(&held.contact)).collect();
    let mut multipliers = vec![0.0; held.len()];
    for _ in 0..MAX_SWEEPS {
        let mut largest = 0.0_f64;
        for ((Held { contact, is_pressed }, compliance), multiplier) in
            held.iter().zip(&compliances).zip(&mut multipliers)
        {
            if *compliance <= 0.0 {
                continue;
            }
            let moved: f64 = contact.sides().map(|(body, rows)| dot(&rows.as_ref()[0], &shifts[body])).sum();
            let wanted: f64 = *multiplier - (contact.gap + moved) / compliance;
            let wanted = if *is_pressed { wanted } else { wanted.max(0.0) };
            let change = wanted - *multiplier;
            *multiplier = wanted;
            largest = largest.max((change * compliance).abs());
            for (body, rows) in contact.sides() {
                add_scaled(&mut shifts[body], change, &weighed(body, &rows.as_ref()[0]));
            }
        }
        let worst = held.iter().map(|held| held.contact.gap.abs()).fold(0.0, f64::max);
        if largest <= 1e-3 * worst {
            break;
        }
    }
    for (pose, shift) in poses.iter_mut().zip(&shifts) {
        *pose = S::advanced(pose, shift, 1.0);
    }
}
