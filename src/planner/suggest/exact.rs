//! Fixtures at given places, planned for exactly and improved.

use super::super::fingers::Pushes;
use super::super::seating::Seating;
use super::super::sets::{are_independent, contacts_on_rung};
use super::super::transitions::Transitions;
use super::estimate::Estimator;
use super::survey::{Candidate, PARTS, neighbours};
use crate::answer::{Action, Proposal, Recommendation, Searched};
use crate::exact::{Int, Ladder, Overflow, Q, Rung, climb, ratio, to_f64};
use crate::geometry::Polygon;
use crate::mechanics::Contact;
use crate::model::{Fixel, Fixture, Part, Place};
use std::cell::Cell;

/// The first steps of the search, in [`PARTS`] of an edge.
const FIRST_STEP: i64 = PARTS / 32;

/// Places are not improved whose margin is below this share of what it has to beat.
const CHANCE: f64 = 0.6;

/// What stays the same while the fixels move.
pub(super) struct Planner<'a> {
    part: &'a Part,
    polygon: &'a Polygon,
    /// Gives each fixel its friction.
    fixture: &'a Fixture,
    pushes: Pushes,
    /// The rung that the last plan needed: the next one hardly ever fits a lower one.
    rung: Cell<Rung>,
}

impl<'a> Planner<'a> {
    pub(super) fn of(part: &'a Part, polygon: &'a Polygon, fixture: &'a Fixture) -> Self {
        Self { part, polygon, fixture, pushes: Pushes::of(part), rung: Cell::new(Rung::Word) }
    }

    /// The candidate's places, each moved as long as the exact margin grows, in smaller and smaller steps; `None` if no
    /// push or tilt is certain to seat the part, or with a margin far below `least`.
    pub(super) fn improved(
        &self,
        candidate: &Candidate,
        least: f64,
        estimator: &Estimator,
        searched: &mut Searched,
    ) -> Option<Proposal> {
        let mut shares = candidate.shares.clone();
        let mut best = self.planned(&candidate.edges, &shares, searched)?;
        if to_f64(&best.plan.margin2).sqrt() < CHANCE * least {
            return None;
        }
        let mut step = FIRST_STEP;
        while step > 0 {
            let moves = neighbours(&shares, step, 2).into_iter().find_map(|moved| {
                if !is_hopeful(estimator, &candidate.edges, &moved, &best.plan, searched) {
                    return None;
                }
                let other = self.planned(&candidate.edges, &moved, searched)?;
                (other.plan.margin2 > best.plan.margin2).then_some((other, moved))
            });
            match moves {
                Some(better) => (best, shares) = better,
                None => step /= 2,
            }
        }
        Some(best)
    }

    /// The best push or tilt onto fixels at these shares, in [`PARTS`] parts of their edges.
    fn planned(&self, edges: &[usize], shares: &[i64], searched: &mut Searched) -> Option<Proposal> {
        searched.planned += 1;
        let places: Vec<(usize, Q)> =
            edges.iter().zip(shares).map(|(edge, share)| (*edge, ratio(*share, PARTS))).collect();
        let fixture = self.fixture_at(&places);
        let contacts = Contact::of(self.part, &fixture);
        let (plan, rung) = climb(&Seated { planner: self, contacts }, self.rung.get());
        self.rung.set(rung);
        let plan = plan?;
        // a wrench that neither finger nor tilt can exert is no plan to build fixels for
        let is_simple = !matches!(plan.action, Action::Wrench);
        is_simple.then_some(Proposal { fixture, places, plan, critical_friction: None })
    }

    fn fixture_at(&self, places: &[(usize, Q)]) -> Fixture {
        let fixels = self.fixture.fixels.iter().zip(places).map(|(fixel, (edge, s))| Fixel {
            place: Place::Edge { edge: *edge, s: s.clone() },
            point: self.polygon.point(&self.polygon.location(*edge, s.clone())),
            normal: self.polygon.inward_normal(*edge),
            friction: fixel.friction.clone(),
        });
        Fixture { fixels: fixels.collect() }
    }
}

/// Whether the estimate leaves hope that these places beat `plan`.
fn is_hopeful(
    estimator: &Estimator,
    edges: &[usize],
    shares: &[i64],
    plan: &Recommendation,
    searched: &mut Searched,
) -> bool {
    searched.estimated += 1;
    let places = edges.iter().zip(shares).map(|(edge, share)| (*edge, *share as f64 / PARTS as f64));
    let least = to_f64(&plan.margin2).sqrt();
    estimator.margin(&places.collect::<Vec<_>>(), least) > least
}

struct Seated<'a> {
    planner: &'a Planner<'a>,
    contacts: Vec<Contact>,
}

impl Ladder for Seated<'_> {
    type Output = Option<Recommendation>;

    fn run<T: Int>(&self) -> Result<Self::Output, Overflow> {
        let contacts = contacts_on_rung::<T>(&self.contacts)?;
        if !are_independent(&contacts)? {
            return Ok(None);
        }
        let transitions = Transitions::of(&contacts)?;
        Ok(Seating::of(self.planner.part, &self.planner.pushes, Some(&transitions))?.plan)
    }
}
