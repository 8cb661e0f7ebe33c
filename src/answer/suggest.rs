//! Answer of `plan insert --suggest`.

use super::{CriticalFriction, EmptyReason, Limit, Recommendation};
use crate::exact::Q;
use crate::model::Fixture;

/// Places for the fixels, the best first.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Suggestion {
    /// At most one for each combination of edges, by descending margin, then by the edges' numbers.
    pub proposals: Vec<Proposal>,
    /// How much was searched.
    pub searched: Searched,
    /// The limit that ended the search; `None` if it ended by itself. Better places may exist even so.
    pub limit: Option<Limit>,
    /// Why there can be no proposal, where that is known before any search.
    pub empty_because: Option<EmptyReason>,
}

/// Places for all fixels and the best push or tilt onto them.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Proposal {
    /// The fixels in the order of the case, each strictly inside an edge.
    pub fixture: Fixture,
    /// Edge and share of the edge of each fixel.
    pub places: Vec<(usize, Q)>,
    /// The push or tilt that `plan insert` recommends for these fixels, with its exact margin.
    pub plan: Recommendation,
    /// Up to which factor on the friction there are a plan and a guarantee; `None` where a limit ended the search before.
    pub critical_friction: Option<CriticalFriction>,
}

/// Work done.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Searched {
    /// Ways to choose an edge for every fixel that were looked at.
    pub choices: usize,
    /// Ways there are.
    pub of: usize,
    /// Fixtures whose margin was estimated in floating point.
    pub estimated: usize,
    /// Fixtures that were planned for exactly.
    pub planned: usize,
}
