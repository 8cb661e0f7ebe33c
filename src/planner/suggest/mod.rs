//! Where to put the fixels: places on the edges that give the plan of insertion a large margin.

mod estimate;
mod exact;
mod survey;

use super::{Question, insertion};
use crate::answer::{EmptyReason, Proposal, Suggestion};
use crate::exact::to_f64;
use crate::model::{Fixture, Part, Shape};
use estimate::Estimator;
use exact::Planner;
use survey::{Candidate, Choices};

/// Of the choices of edges, so many that look best after a first try have their places improved by the estimate.
const CLIMBED: usize = 1_000;

/// How far below the exact margin an estimate may be, as a share of it, before a candidate is missed.
const SLACK: f64 = 0.05;

/// Where a search stands.
#[derive(Debug, Clone, Copy)]
pub struct Progress<'a> {
    /// What is being done.
    pub stage: Stage,
    /// Steps of the stage that are done.
    pub done: usize,
    /// Steps that the stage may still take at most, done ones included.
    pub of: usize,
    /// What a search that ends here has found.
    pub so_far: &'a Suggestion,
}

/// What a search is doing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stage {
    /// Estimating every choice of edges.
    Survey,
    /// Planning exactly for the most promising.
    Plan,
    /// Telling how much friction the proposals bear.
    Friction,
}

/// Proposes places for the fixels on the edges of `part`, at most `count`, the best first; `watch` hears of every step.
///
/// The fixels of `fixture` give their number and friction, in their order; where they are does not matter. What is made
/// large is the margin of the plan that `plan insert` recommends for the proposed fixels, not the radius of the most
/// robust wrench: a margin is of use only if one push or tilt can have it.
///
/// Every way to choose edges is tried at a few places in floating point (`Estimator`); the most promising are planned
/// for exactly and improved one fixel at a time in halving steps, in the order of their estimates, until no estimate is
/// above the exact margins found. So every number reported is exact, but the places are those of a search: better ones
/// may exist, and none found is no proof. The same input gives the same proposals.
///
/// # Errors
/// [`SuggestError::Disc`] for a part without edges.
pub fn suggest(
    part: &Part,
    fixture: &Fixture,
    count: usize,
    watch: &mut dyn FnMut(Progress),
) -> Result<Suggestion, SuggestError> {
    let Shape::Polygon(polygon) = &part.shape else { return Err(SuggestError::Disc) };
    let mut found = Suggestion::default();
    if fixture.fixels.len() > 3 {
        return Ok(Suggestion { empty_because: Some(EmptyReason::DependentNormals), ..found });
    }
    let estimator = Estimator::of(part, polygon, fixture);
    let candidates = survey(&estimator, Choices::of(polygon.n_edges(), fixture), &mut found, watch);
    let planner = Planner::of(part, polygon, fixture);
    for (index, candidate) in candidates.iter().enumerate() {
        let least = worst(&found.proposals, count);
        let promising = candidates[index..].iter().take_while(|other| other.margin * (1.0 + SLACK) > least).count();
        watch(Progress { stage: Stage::Plan, done: index, of: index + promising, so_far: &found });
        if promising == 0 {
            break;
        }
        if let Some(proposal) = planner.improved(candidate, least, &estimator, &mut found.searched) {
            rank(&mut found.proposals, proposal, count);
        }
    }
    let of = found.proposals.len();
    for done in 0..of {
        watch(Progress { stage: Stage::Friction, done, of, so_far: &found });
        let proposal = &mut found.proposals[done];
        let question = Question { critical: true, ..Question::default() };
        let answer = insertion(part, &proposal.fixture, &question).expect("no modes are asked for");
        proposal.critical_friction = answer.critical_friction;
    }
    Ok(found)
}

/// All choices of edges with estimated margins, the best first.
fn survey(
    estimator: &Estimator,
    choices: Choices,
    found: &mut Suggestion,
    watch: &mut dyn FnMut(Progress),
) -> Vec<Candidate> {
    let of = choices.total();
    found.searched.of = of;
    let mut candidates = Vec::new();
    for (done, edges) in choices.enumerate() {
        watch(Progress { stage: Stage::Survey, done, of, so_far: found });
        candidates.push(Candidate::first(edges, estimator, &mut found.searched));
        found.searched.choices += 1;
        if candidates.len() == 4 * CLIMBED {
            best_first(&mut candidates);
            candidates.truncate(CLIMBED);
        }
    }
    best_first(&mut candidates);
    candidates.truncate(CLIMBED);
    for candidate in &mut candidates {
        candidate.climb(estimator, &mut found.searched);
    }
    best_first(&mut candidates);
    candidates
}

fn best_first(candidates: &mut Vec<Candidate>) {
    candidates.retain(|candidate| candidate.margin > 0.0);
    // a stable sort: equals stay in the order of their edges
    candidates.sort_by(|a, b| b.margin.total_cmp(&a.margin));
}

/// The margin that one more proposal has to beat.
fn worst(proposals: &[Proposal], count: usize) -> f64 {
    if proposals.len() < count {
        return 0.0;
    }
    proposals.last().map_or(f64::INFINITY, |last| to_f64(&last.plan.margin2).sqrt())
}

/// Puts a proposal in its place, the better one of two on the same edges, at most `count` in all.
fn rank(proposals: &mut Vec<Proposal>, proposal: Proposal, count: usize) {
    let edges = sorted_edges(&proposal);
    if let Some(twin) = proposals.iter().position(|other| sorted_edges(other) == edges) {
        if proposals[twin].plan.margin2 >= proposal.plan.margin2 {
            return;
        }
        proposals.remove(twin);
    }
    proposals.push(proposal);
    proposals.sort_by(|a, b| b.plan.margin2.cmp(&a.plan.margin2).then_with(|| sorted_edges(a).cmp(&sorted_edges(b))));
    proposals.truncate(count);
}

fn sorted_edges(proposal: &Proposal) -> Vec<usize> {
    let mut edges: Vec<usize> = proposal.places.iter().map(|(edge, _)| *edge).collect();
    edges.sort_unstable();
    edges
}

/// Why places cannot be proposed.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SuggestError {
    /// The part is a disc.
    #[error("places are proposed on the edges of a polygon, and a disc has none; give fixels with \"at\": [x, y]")]
    Disc,
}
