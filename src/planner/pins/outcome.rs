//! Where pins of all heights leave the part, from what they do to it at once.

use super::graph::Stretch;
use super::search::Band;
use crate::answer::PinAction;
use crate::mechanics::toppling::Height;

/// What pins do to the part on one stable edge; `None` where it is uncertain.
pub(super) struct Actions {
    /// The place of the stable edge onto which it topples.
    pub(super) next: usize,
    /// For all heights, ascending.
    pub(super) stretches: Vec<Stretch<Option<PinAction>>>,
}

impl Actions {
    /// What a pin does at a height that is not critical; `None` if it is, or if it is uncertain.
    pub(super) fn around(&self, height: &Height) -> Option<PinAction> {
        let is_inside = |stretch: &&Stretch<Option<PinAction>>| {
            stretch.from < *height && stretch.to.as_ref().is_none_or(|to| to > height)
        };
        self.stretches.iter().find(is_inside)?.action
    }
}

/// Final outcomes of the stable edges between all neighboring critical heights, but above the highest.
pub(super) fn bands(edges: &[Actions]) -> Vec<Band> {
    let mut heights: Vec<&Height> = edges.iter().flat_map(|edge| edge.stretches.iter().map(|s| &s.from)).collect();
    heights.sort();
    heights.dedup();
    let mut cursors = vec![0; edges.len()];
    let ends = |actions: &[Option<PinAction>]| (0..edges.len()).map(|edge| followed(edges, actions, edge)).collect();
    let band = |pair: &[&Height]| {
        let (mut above, mut here) = (Vec::new(), Vec::new());
        for (edge, cursor) in edges.iter().zip(&mut cursors) {
            while edge.stretches[*cursor].to.as_ref().is_some_and(|to| to <= pair[0]) {
                *cursor += 1;
            }
            let stretch = &edge.stretches[*cursor];
            above.push(stretch.action);
            here.push(stretch.action.filter(|_| stretch.from < *pair[0]));
        }
        let [low, high] = [pair[0], pair[1]].map(|height| height.exact().clone());
        Band { low, high, outcome: ends(&above), at_low: ends(&here) }
    };
    heights.windows(2).map(band).collect()
}

/// Where a part on edge `start` ends; one that turns forever in front of the pin jams (section VI).
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
