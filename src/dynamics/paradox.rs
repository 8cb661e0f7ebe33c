//! Painlevé's paradox: contacts that slide with forces that do not exist or are not unique.

use super::contact::{Contact, add_scaled, dot};
use super::mechanics::Mechanics;
use super::nearby::Nearby;
use super::state::State;
use crate::answer::ContactName;
use crate::complementarity::{Count, Enumeration, ExactLcp, Lcp, enumerate};
use crate::model::World;

/// Most complementary cases looked at in one judgement.
const MAX_CASES: usize = 4096;

/// What the forces of sliding contacts are like.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Paradox {
    /// No finite forces exist: only an impulse, without any collision, is consistent.
    Inconsistent(Suspect),
    /// Several forces exist, or lifting off and pressing both do.
    Ambiguous(Suspect, Count),
}

/// A contact whose friction presses it harder the more it pushes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Suspect {
    pub name: ContactName,
    /// Normal acceleration for each unit of normal force while it slides, `A_nn - μ A_nt`: negative (1/kg).
    pub compliance: f64,
    /// Normal acceleration without forces (m/s²).
    pub free: f64,
}

/// Judges the contacts that slide at `state`: forces λ and accelerations `a = A λ + b` with `0 ≤ a ⊥ λ ≥ 0`.
///
/// `A = W_nᵀ M⁻¹ (W_n - μ ŝ W_t)` with the slip directions ŝ, `b = W_nᵀ M⁻¹ u + Ẇ_nᵀ ν`: the rigid problem of accelerations,
/// centripetal terms included, which (13) leaves out. Contacts that stick are not judged.
pub(super) fn judge<S: Mechanics>(
    world: &World<S>,
    nearby: &mut Nearby<'_, S>,
    state: &State<S>,
    touching: f64,
) -> Option<Paradox> {
    let mut contacts = Vec::new();
    nearby.find(&state.poses, touching, &mut contacts);
    let velocities = &state.velocities;
    let slides = |contact: &Contact<S>| slip(contact, velocities).is_some();
    let rests = |contact: &Contact<S>| contact.velocity(0, velocities).abs() <= 1e-6 * contact.speed(velocities);
    contacts.retain(|contact| rests(contact) && slides(contact));
    let columns: Vec<Vec<S::Velocity>> = contacts.iter().map(|contact| column(world, state, contact)).collect();
    let free = free_accelerations(world, nearby, state, &contacts);
    let n = contacts.len();
    let mut m = vec![0.0; n * n];
    for (i, contact) in contacts.iter().enumerate() {
        for (j, column) in columns.iter().enumerate() {
            let terms = contact.sides().map(|(body, rows)| dot(&rows.as_ref()[0], &column[body]));
            m[i * n + j] = terms.sum();
        }
    }
    let at = (0..n).filter(|i| m[i * n + i] < 0.0).min_by(|a, b| m[a * n + a].total_cmp(&m[b * n + b]))?;
    let suspect = Suspect { name: contacts[at].name, compliance: m[at * n + at], free: free[at] };
    let exact = ExactLcp::from_floats(Lcp { m: &m, q: &free }).ok()?;
    let Enumeration::Complete(all) = enumerate(&exact, MAX_CASES) else {
        return None;
    };
    match all.count() {
        Count::None => Some(Paradox::Inconsistent(suspect)),
        Count::Unique => None,
        count => Some(Paradox::Ambiguous(suspect, count)),
    }
}

/// Unit slip along t and o, unless it is rounding.
fn slip<S: Mechanics>(contact: &Contact<S>, velocities: &[S::Velocity]) -> Option<[f64; 2]> {
    let mut slip = [0.0; 2];
    for row in 1..=S::TANGENTS {
        slip[row - 1] = contact.velocity(row, velocities);
    }
    let speed = (slip[0] * slip[0] + slip[1] * slip[1]).sqrt();
    (speed > 1e-6 * contact.speed(velocities)).then(|| slip.map(|s| s / speed))
}

/// M⁻¹ (W_n - μ ŝ W_t): accelerations for a unit of normal force at a contact that slides.
fn column<S: Mechanics>(world: &World<S>, state: &State<S>, contact: &Contact<S>) -> Vec<S::Velocity> {
    let slip = slip(contact, &state.velocities).unwrap_or_default();
    let mut column = vec![S::Velocity::default(); world.bodies.len()];
    for (body, rows) in contact.sides() {
        let mut wrench = rows.as_ref()[0];
        for (row, slip) in rows.as_ref()[1..].iter().zip(slip) {
            add_scaled(&mut wrench, -contact.material.friction * slip, row);
        }
        column[body] = S::weighed(&world.bodies[body], &state.poses[body], &wrench);
    }
    column
}

/// W_nᵀ M⁻¹ u + Ẇ_nᵀ ν, the second by a central difference.
fn free_accelerations<S: Mechanics>(
    world: &World<S>,
    nearby: &mut Nearby<'_, S>,
    state: &State<S>,
    contacts: &[Contact<S>],
) -> Vec<f64> {
    let mut free = Vec::new();
    state.free(world, 1.0, &mut free);
    let fastest = nearby.reach(&state.velocities, 1.0).max(f64::MIN_POSITIVE);
    let h = 1e-5 * nearby.size() / fastest;
    let rate = |nearby: &mut Nearby<'_, S>, h: f64| -> Vec<Contact<S>> {
        let moved = state.poses.iter().zip(&state.velocities).map(|(pose, velocity)| S::advanced(pose, velocity, h));
        let mut found = Vec::new();
        nearby.find(&moved.collect::<Vec<_>>(), 1e-3 * nearby.size(), &mut found);
        found
    };
    let (before, after) = (rate(nearby, -h), rate(nearby, h));
    let velocities = &state.velocities;
    let accelerations = contacts.iter().map(|contact| {
        let speed_in = |list: &[Contact<S>]| {
            let same = list.iter().find(|other| other.name == contact.name);
            same.map(|other| other.velocity(0, velocities))
        };
        let turning =
            speed_in(&after).zip(speed_in(&before)).map_or(0.0, |(after, before)| (after - before) / (2.0 * h));
        contact.velocity(0, &free) - contact.velocity(0, velocities) + turning
    });
    accelerations.collect()
}
