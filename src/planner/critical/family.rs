//! A fixture whose friction grows by a factor, and whether its sets of wrenches are empty.

use super::super::sets::{are_independent, contacts_on_rung, transition_cones};
use super::super::transitions::Transitions;
use crate::cone::{Cone, Outside, complement};
use crate::exact::{Int, Ladder, Overflow, Q, Rung, Z, climb, on_rung};
use crate::mechanics::{Contact, FrictionEdges};
use crate::model::{Fixture, Part};

/// The contacts of a seated part for every factor on the coefficients of some of its fixels.
///
/// Only the largest static coefficients matter: no letter of the sets slides. Every cone of the sets' holes grows with
/// the factor, for more friction allows more forces, so the sets shrink: each is empty from one factor on.
#[derive(Debug, Clone)]
pub(super) struct Family {
    pub(super) contacts: Vec<Contact>,
    pub(super) edges: Vec<FrictionEdges>,
    pub(super) is_independent: bool,
}

/// A set of wrenches that guarantees the seat.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Set {
    Goal,
    Acyclic,
}

impl Family {
    /// All coefficients of the fixture times one factor.
    pub(super) fn of(part: &Part, fixture: &Fixture, contacts: &[Contact]) -> Self {
        let is_independent = are_independent(contacts).expect("integers of any size do not overflow");
        Self { contacts: contacts.to_vec(), edges: FrictionEdges::of(part, fixture), is_independent }
    }

    /// The coefficients of one fixel times the factor, all others as they are.
    pub(super) fn of_fixel(&self, fixel: usize) -> Self {
        let edges = self.edges.iter().enumerate();
        let edges = edges.map(|(index, edges)| if index == fixel { edges.clone() } else { edges.held() }).collect();
        Self { edges, ..self.clone() }
    }

    /// Whether the factor is without effect.
    pub(super) fn is_constant(&self) -> bool {
        self.edges.iter().all(FrictionEdges::is_constant)
    }

    /// The contacts for one factor; only what the sets depend on follows it.
    pub(super) fn at(&self, factor: &Q) -> Vec<Contact> {
        let contact = |(contact, edges): (&Contact, &FrictionEdges)| Contact {
            static_forces: edges.at(factor),
            ..contact.clone()
        };
        self.contacts.iter().zip(&self.edges).map(contact).collect()
    }

    /// Whether `set` holds a wrench at `factor`.
    pub(super) fn is_possible(&self, set: Set, factor: &Q) -> bool {
        self.is_independent && climb(&IsPossible { contacts: self.at(factor), set }, Rung::Word).0
    }

    /// Whether `wrench` is in the acyclic set at `factor`.
    pub(super) fn holds_acyclic(&self, factor: &Q, wrench: &[Z]) -> bool {
        self.is_independent && climb(&HoldsAcyclic { contacts: self.at(factor), wrench }, Rung::Word).0
    }

    /// The cells of `set` at `factor`.
    pub(super) fn cells(&self, set: Set, factor: &Q) -> Vec<Cone<Z>> {
        if !self.is_independent {
            return Vec::new();
        }
        cells(set, &self.at(factor)).expect("integers of any size do not overflow")
    }
}

struct IsPossible {
    contacts: Vec<Contact>,
    set: Set,
}

impl Ladder for IsPossible {
    type Output = bool;

    fn run<T: Int>(&self) -> Result<bool, Overflow> {
        let contacts = contacts_on_rung::<T>(&self.contacts)?;
        match self.set {
            Set::Goal => {
                let holes: Vec<Cone<T>> = transition_cones(&contacts)?.into_iter().map(|(_, cone)| cone).collect();
                Ok(Outside::of(3, &holes)?.next_piece()?.is_some())
            }
            Set::Acyclic => {
                let transitions = Transitions::of(&contacts)?;
                let mut pieces = Outside::of(3, &transitions.loops)?;
                while let Some(piece) = pieces.next_piece()? {
                    if transitions.is_acyclic_somewhere(piece)? {
                        return Ok(true);
                    }
                }
                Ok(false)
            }
        }
    }
}

struct HoldsAcyclic<'a> {
    contacts: Vec<Contact>,
    wrench: &'a [Z],
}

impl Ladder for HoldsAcyclic<'_> {
    type Output = bool;

    fn run<T: Int>(&self) -> Result<bool, Overflow> {
        Transitions::of(&contacts_on_rung::<T>(&self.contacts)?)?.is_acyclic(&on_rung(self.wrench)?)
    }
}

fn cells<T: Int>(set: Set, contacts: &[Contact]) -> Result<Vec<Cone<T>>, Overflow> {
    let contacts = contacts_on_rung::<T>(contacts)?;
    match set {
        Set::Goal => {
            let holes: Vec<Cone<T>> = transition_cones(&contacts)?.into_iter().map(|(_, cone)| cone).collect();
            complement(3, &holes)
        }
        Set::Acyclic => {
            let transitions = Transitions::of(&contacts)?;
            Ok(transitions.verdict(complement(3, &transitions.loops)?)?.acyclic)
        }
    }
}
