//! Where pins of all heights leave the part, from what they do to it at once.

use super::graph::{Stretch, push};
use crate::answer::PinAction;
use crate::mechanics::toppling::Height;

/// What pins do to the part on one stable edge; `None` where it is uncertain.
pub(super) struct Actions {
    /// The place of the stable edge onto which it topples.
    pub(super) next: usize,
    /// For all heights.
    pub(super) stretches: Vec<Stretch<Option<PinAction>>>,
}

/// Heights strictly between two critical ones, with the place where each stable edge ends; `None` where it jams or is
/// uncertain.
#[expect(dead_code, reason = "the search for sequences reads them")]
pub(super) struct Outcomes {
    pub(super) from: Height,
    pub(super) to: Option<Height>,
    pub(super) ends: Vec<Option<usize>>,
}

/// Final outcomes of the stable edges for all heights.
///
/// Neighbors differ, and the height between them is critical for an outcome: one that is critical for actions that end alike
/// has the same outcome as both sides, unless one of them jams.
pub(super) fn outcomes(edges: &[Actions]) -> Vec<Outcomes> {
    let mut heights: Vec<&Height> = edges.iter().flat_map(|edge| edge.stretches.iter().map(|s| &s.from)).collect();
    heights.sort();
    heights.dedup();
    let mut merged: Vec<Stretch<(Vec<Option<usize>>, bool)>> = Vec::new();
    let mut cursor = vec![0; edges.len()];
    for (index, from) in heights.iter().enumerate() {
        let to = heights.get(index + 1).copied();
        let is_point_jam = at_point(edges, &mut cursor, from);
        let actions: Vec<Option<PinAction>> =
            edges.iter().zip(&cursor).map(|(edge, at)| edge.stretches[*at].action).collect();
        let ends: Vec<Option<usize>> = (0..edges.len()).map(|edge| followed(edges, &actions, edge)).collect();
        if is_point_jam {
            // a mark of its own, so that what is below and above stay apart
            push(&mut merged, Stretch { from: (*from).clone(), to: Some((*from).clone()), action: (Vec::new(), true) });
        }
        push(&mut merged, Stretch { from: (*from).clone(), to: to.cloned(), action: (ends, false) });
    }
    let outcome = |Stretch { from, to, action: (ends, _) }| Outcomes { from, to, ends };
    merged.into_iter().filter(|stretch| !stretch.action.1).map(outcome).collect()
}

/// Moves each cursor to the stretch above `height`; whether one passed over jams at that height alone.
fn at_point(edges: &[Actions], cursor: &mut [usize], height: &Height) -> bool {
    let mut is_jam = false;
    for (edge, at) in edges.iter().zip(cursor) {
        while edge.stretches[*at].to.as_ref().is_some_and(|to| to <= height) {
            let stretch = &edge.stretches[*at];
            is_jam |= stretch.to.as_ref() == Some(&stretch.from);
            *at += 1;
        }
    }
    is_jam
}

/// Where a part on edge `start` ends; a part that turns forever in front of the pin jams (section VI).
pub(super) fn followed(edges: &[Actions], actions: &[Option<PinAction>], start: usize) -> Option<usize> {
    let mut edge = start;
    for _ in 0..=edges.len() {
        match actions[edge]? {
            PinAction::PassUnder | PinAction::FallBack => return Some(edge),
            PinAction::Pass => return Some(edges[edge].next),
            PinAction::Repeat => edge = edges[edge].next,
            PinAction::Jam => return None,
        }
    }
    None
}
