//! What compliant contacts remember from step to step: their deformation and their force, by name.

use super::super::contact::Contact;
use super::super::mechanics::Mechanics;
use super::law::{Force, Law, energy};
use super::newton::Joint;
use crate::answer::ContactName;
use crate::model::World;

/// One contact's.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Entry {
    name: ContactName,
    delta: [f64; 3],
    lambda: [f64; 3],
    /// Overlap that nothing deformed for (m).
    offset: f64,
    /// Gap when last seen (m).
    gap: f64,
}

/// All contacts', in the order in which they were found.
#[derive(Debug, Clone, Default)]
pub(in crate::dynamics) struct Memory {
    entries: Vec<Entry>,
    spare: Vec<Entry>,
    is_found: Vec<bool>,
}

/// A deformation below this part of the gap changes nothing.
const NEGLIGIBLE: f64 = f64::EPSILON / 256.0;

impl Memory {
    /// Makes the joints of a step of `h`, a contact each that has compliance.
    ///
    /// A pair that overlaps when it is first found has no deformation to push with, which would be energy from nowhere:
    /// its overlap counts as none, but for the deformation that it takes over from a pair of the same bodies that it
    /// replaces.
    pub fn recall<S: Mechanics>(&mut self, contacts: &[Contact<S>], h: f64, joints: &mut Vec<Joint<S>>) {
        joints.clear();
        self.is_found.clear();
        self.is_found.resize(self.entries.len(), false);
        let (mut next, mut is_replacing) = (0, false);
        for contact in contacts {
            let Some(law) = Law::new(&contact.material, h) else {
                continue;
            };
            let mut joint = Joint {
                start: *contact,
                now: *contact,
                delta: [0.0; 3],
                offset: (-contact.gap).max(0.0),
                law,
                force: Force::default(),
                earlier: [0.0; 3],
            };
            if let Some(at) = self.find(contact.name, next) {
                next = at + 1;
                self.is_found[at] = true;
                let Entry { delta, lambda, offset, .. } = self.entries[at];
                (joint.delta, joint.offset, joint.force.lambda) = (delta, offset, lambda);
            } else {
                is_replacing |= contact.gap < 0.0;
            }
            joints.push(joint);
        }
        if is_replacing {
            self.hand_over(joints);
        }
    }

    /// Gives the deformation of overlapping pairs that are gone to new ones of the same bodies.
    fn hand_over<S: Mechanics>(&mut self, joints: &mut [Joint<S>]) {
        for joint in joints {
            let name = joint.start.name;
            if joint.offset == 0.0 || self.find(name, 0).is_some() {
                continue;
            }
            let is_gone = |(entry, is_found): (&Entry, &bool)| {
                !is_found && entry.gap <= 0.0 && (entry.name.body, entry.name.other) == (name.body, name.other)
            };
            if let Some(at) = self.entries.iter().zip(&self.is_found).position(is_gone) {
                self.is_found[at] = true;
                joint.delta[0] = self.entries[at].delta[0].clamp(0.0, joint.offset);
                joint.offset -= joint.delta[0];
            }
        }
    }

    /// Takes all overlap for deformation, as a scene starts.
    pub fn start<S: Mechanics>(&mut self, contacts: &[Contact<S>]) {
        let deformed = contacts.iter().filter(|contact| contact.gap < 0.0).map(|contact| Entry {
            name: contact.name,
            delta: [-contact.gap, 0.0, 0.0],
            lambda: [0.0; 3],
            offset: 0.0,
            gap: contact.gap,
        });
        self.entries.clear();
        self.entries.extend(deformed);
    }

    /// Keeps what the joints became; others relax by C / (C + h K) and are forgotten once they change nothing, at
    /// once where their features parted while they overlapped.
    pub fn keep<S: Mechanics>(&mut self, world: &World<S>, h: f64, joints: &[Joint<S>]) {
        self.spare.clear();
        for Joint { now, delta, force, law, offset, .. } in joints {
            let delta = law.deformed(force.lambda, *delta);
            let offset = offset.min((-now.gap).max(0.0));
            self.spare.push(Entry { name: now.name, delta, lambda: force.lambda, offset, gap: now.gap });
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
