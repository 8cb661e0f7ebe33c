//! Laws of impact: Newton's and Poisson's, all contacts that touch at once.

use super::contact::{Contact, add_scaled};
use super::impulses::{Impulses, SLIPPING};
use super::mechanics::Mechanics;
use super::routh::SingleImpact;
use super::solved::{Refused, Solved};
use super::state::State;
use crate::answer::ContactName;
use crate::model::{Restitution, World};

/// A contact that was struck, with its impulses along n, t and o (N s).
pub(super) type Struck<S> = (Contact<S>, [f64; 3]);

/// An impact of everything that touches.
#[derive(Debug, Clone, Copy)]
pub(super) struct Impact {
    /// A gap up to this counts as touching (m).
    pub touching: f64,
    /// Length of the step (s): a bounce that would last less than an eighth of it is none.
    pub h: f64,
    /// Whether nothing bounces.
    pub is_plastic: bool,
}

impl Impact {
    /// Whether something touches and approaches that has not been held.
    pub fn hits<S: Mechanics>(
        &self,
        contacts: &[Contact<S>],
        velocities: &[S::Velocity],
        is_held: impl Fn(&ContactName) -> bool,
    ) -> bool {
        let hits = |contact: &Contact<S>| contact.velocity(0, velocities) * self.h < -self.touching * 1e-3;
        contacts.iter().any(|contact| contact.gap <= self.touching && hits(contact) && !is_held(&contact.name))
    }

    /// Changes the velocities of `state` by the impact; returns what was struck, with its impulses along n, t and o.
    pub fn strike<S: Mechanics>(
        &self,
        world: &World<S>,
        impulses: &mut Impulses<S>,
        contacts: &[Contact<S>],
        state: &mut State<S>,
        total: &mut Solved,
    ) -> Result<Vec<Struck<S>>, Refused> {
        let struck: Vec<Contact<S>> = contacts.iter().filter(|c| c.gap <= self.touching).copied().collect();
        let mut free = Vec::new();
        state.free(world, self.h, &mut free);
        let coefficients: Vec<f64> = struck.iter().map(|contact| self.restitution(contact, state, &free)).collect();
        total.impacts += 1;
        for contact in &struck {
            total.fastest_impact = total.fastest_impact.max(-contact.velocity(0, &state.velocities));
        }
        if coefficients.iter().any(|e| *e > 0.0) {
            total.together = total.together.max(struck.len());
        }
        let energy = state.kinetic_energy(world);
        let before = state.velocities.clone();
        let mut share = 1.0;
        loop {
            state.velocities.clone_from(&before);
            let e: Vec<f64> = coefficients.iter().map(|e| share * e).collect();
            let answer = bounce(world, impulses, &struck, &e, state, total)?;
            // with friction a law of restitution can make energy: then as much of it acts as makes none
            if share == 0.0 || state.kinetic_energy(world) <= energy * (1.0 + 1e-12) {
                total.reversal = total.reversal.or_else(|| reversal(impulses, &struck, &before, &state.velocities));
                return Ok(struck.into_iter().zip(answer).collect());
            }
            share = if share > 1e-3 { 0.5 * share } else { 0.0 };
        }
    }

    /// The coefficient that acts at a contact: none where nothing approaches, or where gravity would end the bounce at once.
    fn restitution<S: Mechanics>(&self, contact: &Contact<S>, state: &State<S>, free: &[S::Velocity]) -> f64 {
        let e = contact.material.restitution.coefficient();
        let speed = -contact.velocity(0, &state.velocities);
        let pull = (-speed - contact.velocity(0, free)) / self.h;
        let is_at_rest = 2.0 * e * speed <= pull * self.h / 8.0;
        if self.is_plastic || speed <= 0.0 || is_at_rest { 0.0 } else { e }
    }
}

/// The slip of a single contact in the plane, if it reversed: after the impact as it was, and by Routh's law.
fn reversal<S: Mechanics>(
    impulses: &Impulses<S>,
    struck: &[Contact<S>],
    before: &[S::Velocity],
    after: &[S::Velocity],
) -> Option<(ContactName, [f64; 2])> {
    let ([contact], Some(compliance)) = (struck, impulses.single_compliance()) else {
        return None;
    };
    let [slip, end] = [before, after].map(|velocities| contact.velocity(1, velocities));
    if slip * end >= 0.0 || end.abs() <= SLIPPING * contact.speed(after) {
        return None;
    }
    let (approach, friction) = (contact.velocity(0, before), contact.material.friction);
    Some((contact.name, [end, SingleImpact { approach, slip, friction, compliance }.routh_slip()]))
}

/// One impact with these coefficients: compression and Newton's law, then Poisson's expansion.
fn bounce<S: Mechanics>(
    world: &World<S>,
    impulses: &mut Impulses<S>,
    struck: &[Contact<S>],
    e: &[f64],
    state: &mut State<S>,
    total: &mut Solved,
) -> Result<Vec<[f64; 3]>, Refused> {
    let is_poisson = |contact: &Contact<S>| matches!(contact.material.restitution, Restitution::Poisson(_));
    let rebound = |(contact, e): (&Contact<S>, &f64)| match contact.material.restitution {
        Restitution::Newton(_) => e * contact.velocity(0, &state.velocities).min(0.0),
        Restitution::Poisson(_) => 0.0,
    };
    let offsets: Vec<f64> = struck.iter().zip(e).map(rebound).collect();
    total.add(impulses.solve(world, &state.poses, struck, &offsets, &[], &mut state.velocities)?);
    let mut answer = impulses.answer.clone();
    if !struck.iter().zip(e).any(|(contact, e)| is_poisson(contact) && *e > 0.0) {
        return Ok(answer);
    }
    let stored = |((contact, e), impulse): ((&Contact<S>, &f64), &[f64; 3])| {
        if is_poisson(contact) { e * impulse[0] } else { 0.0 }
    };
    let expansion: Vec<f64> = struck.iter().zip(e).zip(&answer).map(stored).collect();
    for (contact, push) in struck.iter().zip(&expansion) {
        for (body, rows) in contact.sides() {
            let pushed = S::weighed(&world.bodies[body], &state.poses[body], &rows.as_ref()[0]);
            add_scaled(&mut state.velocities[body], *push, &pushed);
        }
    }
    total.add(impulses.solve(world, &state.poses, struck, &offsets, &expansion, &mut state.velocities)?);
    for ((sum, more), push) in answer.iter_mut().zip(&impulses.answer).zip(&expansion) {
        *sum = [sum[0] + more[0] + push, sum[1] + more[1], sum[2] + more[2]];
    }
    Ok(answer)
}
