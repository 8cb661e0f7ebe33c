//! A fixture whose friction grows by a factor, and whether its sets of wrenches are empty.

use super::super::sets::{are_independent, contacts_on_rung, transition_cones};
use super::super::transitions::Transitions;
use crate::cone::{Cone, Outside, complement};
use crate::exact::{Int, Ladder, Long, Overflow, Q, Rung, Z, climb, on_rung};
use crate::mechanics::{Contact, ContactRows, FrictionEdges};
use crate::model::{Fixture, Part};
use std::cell::Cell;

/// The contacts of a seated part for every factor on the coefficients of some of its fixels.
///
/// Only the largest static coefficients matter: no letter of the sets slides. Every cone of the sets' holes grows with
/// the factor, for more friction allows more forces, so the sets shrink: each is empty from one factor on.
#[derive(Debug, Clone)]
pub(super) struct Family {
    pub(super) contacts: Vec<Contact>,
    pub(super) edges: Vec<FrictionEdges>,
    pub(super) is_independent: bool,
    /// The lowest rung that held everything so far: factors are alike, and so are the numbers that they lead to.
    rung: Cell<Rung>,
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
        let is_independent = contacts_on_rung::<Long>(contacts).and_then(|contacts| are_independent(&contacts));
        let is_independent = is_independent.expect("integers of any size do not overflow");
        let edges = FrictionEdges::of(part, fixture);
        Self { contacts: contacts.to_vec(), edges, is_independent, rung: Cell::new(Rung::Word) }
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
        self.is_independent && self.run(&IsPossible { contacts: self.at(factor), set, least_dim: 0 })
    }

    /// Whether `set` has an interior at `factor`.
    pub(super) fn has_interior(&self, set: Set, factor: &Q) -> bool {
        self.is_independent && self.run(&IsPossible { contacts: self.at(factor), set, least_dim: 3 })
    }

    /// Whether `wrench` is in the acyclic set at `factor`.
    pub(super) fn holds_acyclic(&self, factor: &Q, wrench: &[Z]) -> bool {
        self.is_independent && self.run(&HoldsAcyclic { contacts: self.at(factor), wrench })
    }

    /// The facet normals of each cell of `set` at `factor` that has an interior.
    pub(super) fn cells(&self, set: Set, factor: &Q) -> Vec<Vec<Vec<Z>>> {
        if self.is_independent { self.run(&Cells { contacts: self.at(factor), set }) } else { Vec::new() }
    }

    fn run<J: Ladder>(&self, job: &J) -> J::Output {
        let (output, rung) = climb(job, self.rung.get());
        self.rung.set(rung);
        output
    }
}

struct IsPossible {
    contacts: Vec<Contact>,
    set: Set,
    least_dim: usize,
}

impl Ladder for IsPossible {
    type Output = bool;

    fn run<T: Int>(&self) -> Result<bool, Overflow> {
        let contacts = contacts_on_rung::<T>(&self.contacts)?;
        match self.set {
            Set::Goal => {
                let mut pieces = Outside::of(3, &goal_holes(&contacts)?)?;
                while let Some(piece) = pieces.next_piece()? {
                    if piece.closure().dim() >= self.least_dim {
                        return Ok(true);
                    }
                }
                Ok(false)
            }
            Set::Acyclic => {
                let transitions = Transitions::of(&contacts)?;
                let mut pieces = Outside::of(3, &transitions.loops)?;
                while let Some(piece) = pieces.next_piece()? {
                    if transitions.is_acyclic_somewhere(piece, self.least_dim)? {
                        return Ok(true);
                    }
                }
                Ok(false)
            }
        }
    }
}

fn goal_holes<T: Int>(contacts: &[ContactRows<T>]) -> Result<Vec<Cone<T>>, Overflow> {
    Ok(transition_cones(contacts)?.into_iter().map(|(_, cone)| cone).collect())
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

struct Cells {
    contacts: Vec<Contact>,
    set: Set,
}

impl Ladder for Cells {
    type Output = Vec<Vec<Vec<Z>>>;

    fn run<T: Int>(&self) -> Result<Self::Output, Overflow> {
        let contacts = contacts_on_rung::<T>(&self.contacts)?;
        let cells = match self.set {
            Set::Goal => complement(3, &goal_holes(&contacts)?)?,
            Set::Acyclic => {
                let transitions = Transitions::of(&contacts)?;
                transitions.verdict(complement(3, &transitions.loops)?)?.acyclic
            }
        };
        let normals = |cell: &Cone<T>| {
            let rows = cell.closure().facets().rows();
            rows.map(|row| row.iter().map(T::to_z).collect()).collect()
        };
        Ok(cells.iter().filter(|cell| cell.closure().dim() == 3).map(normals).collect())
    }
}
