//! The impulses of a step that consists of several problems.

use super::contact::Contact;
use super::mechanics::Mechanics;
use crate::answer::ContactName;

/// Impulses by contact, each since a time.
#[derive(Debug)]
pub(super) struct Touches<S: Mechanics> {
    list: Vec<(Contact<S>, [f64; 3], f64)>,
}

impl<S: Mechanics> Default for Touches<S> {
    fn default() -> Self {
        Self { list: Vec::new() }
    }
}

impl<S: Mechanics> Touches<S> {
    pub fn clear(&mut self) {
        self.list.clear();
    }

    /// Adds an impulse along n, t and o (N s) that acts since `time` (s); the contact is kept as it was last.
    pub fn add(&mut self, contact: &Contact<S>, impulse: [f64; 3], time: f64) {
        match self.list.iter_mut().find(|(known, ..)| known.name == contact.name) {
            Some((known, sum, _)) => {
                *known = *contact;
                (0..3).for_each(|row| sum[row] += impulse[row]);
            }
            None => self.list.push((*contact, impulse, time)),
        }
    }

    /// Contacts with their impulses, in the order in which they were met.
    pub fn iter(&self) -> impl Iterator<Item = (&Contact<S>, [f64; 3])> {
        self.list.iter().map(|(contact, impulse, _)| (contact, *impulse))
    }

    /// Since when a contact acts.
    pub fn since(&self, name: &ContactName) -> Option<f64> {
        self.list.iter().find(|(contact, ..)| contact.name == *name).map(|(.., time)| *time)
    }
}
