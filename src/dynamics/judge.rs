//! What is said aloud of a run: overlaps at its start, and the first step at which forces do not exist or are not unique.

use super::forces::Forces;
use super::mechanics::Mechanics;
use super::nearby::Nearby;
use super::paradox::{Paradox, Suspect, judge};
use super::state::State;
use crate::answer::{ContactName, ContactState, Status};
use crate::model::World;

/// Most judgements in one run; each decides a small problem exactly.
const MAX_JUDGEMENTS: usize = 100;

/// A number with six digits, as notes say it.
pub(super) fn short(value: f64) -> String {
    format!("{value:.5e}").parse::<f64>().unwrap_or(value).to_string()
}

/// Judges the states of a run.
#[derive(Debug)]
pub(super) struct Judge<'w, S: Mechanics> {
    world: &'w World<S>,
    nearby: Nearby<'w, S>,
    held: Vec<(ContactName, ContactState)>,
    judgements: usize,
    is_settled: bool,
}

impl<'w, S: Mechanics> Judge<'w, S> {
    pub fn new(world: &'w World<S>) -> Self {
        Self { world, nearby: Nearby::new(world), held: Vec::new(), judgements: 0, is_settled: false }
    }

    /// The deepest overlap of a state (m), said.
    pub fn overlap(&mut self, state: &State<S>) -> Option<(f64, String)> {
        let mut contacts = Vec::new();
        self.nearby.find(&state.poses, 0.0, &mut contacts);
        let deepest = contacts.iter().min_by(|a, b| a.gap.total_cmp(&b.gap))?;
        let (name, depth) = (self.name(&deepest.name), -deepest.gap);
        (depth > self.nearby.touching()).then(|| (depth, format!("{name} overlap by {depth:.3e} m at the start")))
    }

    /// Judges the state before a step whose contacts were suspect, unless the same contacts have been judged.
    pub fn step(
        &mut self,
        before: &State<S>,
        is_suspect: bool,
        held: &[(ContactName, ContactState)],
    ) -> Option<(Status, String)> {
        if !is_suspect || self.is_settled || self.judgements >= MAX_JUDGEMENTS {
            return None;
        }
        if self.judgements > 0 && self.held == held {
            return None;
        }
        self.judgements += 1;
        self.held = held.to_vec();
        let touching = self.nearby.touching();
        let found = judge(self.world, &mut self.nearby, before, touching)?;
        self.is_settled = true;
        let (Paradox::Inconsistent(suspect) | Paradox::Ambiguous(suspect, _)) = found;
        let Suspect { name, compliance, free } = suspect;
        let (name, time) = (self.name(&name), short(before.time));
        let why = format!("normal compliance {compliance:.4} /kg, free normal acceleration {free:.3} m/s²");
        Some(match found {
            Paradox::Inconsistent(_) => (
                Status::Inconsistent,
                format!(
                    "at {time} s no finite force between {name} is consistent with rigid bodies and Coulomb friction ({why}): \
                     an impulse without a collision stops the slip, and impulse over step is not a force"
                ),
            ),
            Paradox::Ambiguous(..) => (
                Status::Ambiguous,
                format!(
                    "at {time} s {name} may lift off, keep sliding under a force, or jam ({why}): rigid bodies and Coulomb \
                     friction do not say which, and this run shows one of them"
                ),
            ),
        })
    }

    /// A slip that reversed inside an impact, said.
    pub fn reversal(&self, time: f64, (name, [step, routh]): (ContactName, [f64; 2])) -> String {
        format!(
            "at {} s the slip between {} reverses inside an impact: {step:.4} m/s after it, by Routh's law {routh:.4} m/s; \
             laws of impact do not agree on it",
            short(time),
            self.name(&name)
        )
    }

    /// Contacts that met in one impact, said.
    pub fn together(&self, time: f64, contacts: usize) -> String {
        format!(
            "at {} s {contacts} contacts meet in one impact: the law of impact acts on all of them at once, and one after the \
             other they might part otherwise",
            short(time)
        )
    }

    /// The contacts whose forces rigid bodies do not determine, said.
    pub fn forces(&self, forces: &Forces) -> Vec<String> {
        let open = forces.ranges.iter().filter(|(_, min, max)| max.is_none_or(|max| max - min > 1e-6 * max.abs()));
        let say = |(name, min, max): &(ContactName, f64, Option<f64>)| {
            let name = self.name(name);
            let range = match max {
                Some(max) => format!("anything from {min:.4} to {max:.4} N"),
                None => format!("anything from {min:.4} N on"),
            };
            format!("the normal force between {name} at the end is not determined: {range} moves the bodies alike")
        };
        let surplus = forces.surplus.map(|(contacts, velocities)| {
            format!(
                "the normal forces at the end are not determined: {contacts} contacts hold what has {velocities} velocities"
            )
        });
        surplus.into_iter().chain(open.map(say)).collect()
    }

    /// Two names.
    fn name(&self, contact: &ContactName) -> String {
        let other = match contact.other.checked_sub(self.world.bodies.len()) {
            None => &self.world.bodies[contact.other].name,
            Some(fixed) => &self.world.fixed[fixed].name,
        };
        format!("{} and {other}", self.world.bodies[contact.body].name)
    }
}
