//! What compliant contacts remember from step to step: their deformation and their force, by name.

use super::contact::Contact;
use super::mechanics::Mechanics;
use super::song_pang_kumar_law::{Force, Law, energy};
use super::song_pang_kumar_newton::Joint;
use crate::answer::ContactName;
use crate::model::World;

/// One contact's.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Entry {
    name: ContactName,
    delta: [f64; 3],
    lambda: [f64; 3],
    /// Gap when last seen (m).
    gap: f64,
}

/// All contacts', in the order in which they were found.
#[derive(Debug, Clone, Default)]
pub(super) struct Memory {
    entries: Vec<Entry>,
    spare: Vec<Entry>,
}

/// A deformation below this part of the gap changes nothing.
const NEGLIGIBLE: f64 = f64::EPSILON / 256.0;

impl Memory {
    /// Makes the joints of a step of `h`, a contact each that has compliance.
    ///
    /// An overlap that no deformation accounts for counts as one: the contact has closed under another name, or the
    /// scene starts with it.
    pub fn recall<S: Mechanics>(&self, contacts: &[Contact<S>], h: f64, joints: &mut Vec<Joint<S>>) {
        joints.clear();
        let mut next = 0;
        for contact in contacts {
            let Some(law) = Law::new(&contact.material, h) else {
                continue;
            };
            let (delta, lambda) = match self.find(contact.name, next) {
                Some(at) => {
                    next = at + 1;
                    (self.entries[at].delta, self.entries[at].lambda)
                }
                None => ([(-contact.gap).max(0.0), 0.0, 0.0], [0.0; 3]),
            };
            let force = Force { lambda, ..Force::default() };
            joints.push(Joint { start: *contact, now: *contact, delta, law, force, earlier: [0.0; 3] });
        }
    }

    /// Keeps the joints as they are.
    pub fn hold<S: Mechanics>(&mut self, joints: &[Joint<S>]) {
        let entry = |joint: &Joint<S>| Entry {
            name: joint.start.name,
            delta: joint.delta,
            lambda: [0.0; 3],
            gap: joint.start.gap,
        };
        self.entries.clear();
        self.entries.extend(joints.iter().map(entry));
    }

    /// Keeps what the joints became; others relax by C / (C + h K) and are forgotten once they change nothing, at
    /// once where their features parted while they overlapped.
    pub fn keep<S: Mechanics>(&mut self, world: &World<S>, h: f64, joints: &[Joint<S>]) {
        self.spare.clear();
        for Joint { now, delta, force, law, .. } in joints {
            let delta = law.deformed(force.lambda, *delta);
            self.spare.push(Entry { name: now.name, delta, lambda: force.lambda, gap: now.gap });
        }
        let n_joints = self.spare.len();
        let mut next = 0;
        for entry in &self.entries {
            let is_joint = (next..n_joints).chain(0..next).find(|at| self.spare[*at].name == entry.name);
            if let Some(at) = is_joint {
                next = at + 1;
            } else if let (true, Some(law)) =
                (entry.gap > 0.0, Law::new(world.material(entry.name.body, entry.name.other), h))
            {
                self.spare.push(Entry { delta: law.deformed([0.0; 3], entry.delta), lambda: [0.0; 3], ..*entry });
            }
        }
        let matters = |entry: &Entry| {
            entry.lambda[0] > 0.0
                || entry.gap <= 0.0
                || entry.delta.iter().any(|delta| delta.abs() > NEGLIGIBLE * entry.gap)
        };
        self.spare.retain(matters);
        std::mem::swap(&mut self.entries, &mut self.spare);
    }

    /// Energy of all deformations (J).
    pub fn energy<S: Mechanics>(&self, world: &World<S>) -> f64 {
        let of = |entry: &Entry| {
            let compliance = world.material(entry.name.body, entry.name.other).compliance;
            compliance.map_or(0.0, |compliance| energy(&compliance, entry.delta))
        };
        self.entries.iter().map(of).sum()
    }

    /// Deepest overlap of the contacts when last seen (m), not negative.
    pub fn deepest(&self) -> f64 {
        self.entries.iter().map(|entry| -entry.gap).fold(0.0, f64::max)
    }

    /// The deformations by contact.
    pub fn deformations(&self) -> impl Iterator<Item = (ContactName, [f64; 3])> {
        self.entries.iter().map(|entry| (entry.name, entry.delta))
    }

    /// Takes the place of `other` without giving up memory.
    pub fn copy(&mut self, other: &Self) {
        self.entries.clone_from(&other.entries);
    }

    fn find(&self, name: ContactName, from: usize) -> Option<usize> {
        let from = from.min(self.entries.len());
        (from..self.entries.len()).chain(0..from).find(|at| self.entries[*at].name == name)
    }
}
