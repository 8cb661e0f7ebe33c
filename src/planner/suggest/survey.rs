//! Every way to choose edges for the fixels, each with its most promising places by the estimate.

use super::estimate::Estimator;
use crate::answer::Searched;
use crate::model::Fixture;
use std::ops::RangeInclusive;

/// Places are shares of an edge in this many parts.
pub(super) const PARTS: i64 = 64;

/// The shares that may be proposed; what is nearer to a vertex is left out.
pub(super) const INSIDE: RangeInclusive<i64> = PARTS / 16..=PARTS - PARTS / 16;

/// Shares at which every choice of edges is tried first.
const FIRST: [i64; 3] = [PARTS / 4, PARTS / 2, 3 * PARTS / 4];

/// Edges for the fixels in the order of the case, with the best places known.
#[derive(Debug, Clone)]
pub(super) struct Candidate {
    pub(super) edges: Vec<usize>,
    /// In [`PARTS`] of the edges.
    pub(super) shares: Vec<i64>,
    /// Estimated margin.
    pub(super) margin: f64,
}

/// All choices of edges, but no two that differ by an exchange of equal fixels only; in lexical order.
pub(super) struct Choices {
    n_edges: usize,
    /// For each fixel the last one before it with the same friction, if any.
    twins: Vec<Option<usize>>,
    next: Option<Vec<usize>>,
}

impl Choices {
    pub(super) fn of(n_edges: usize, fixture: &Fixture) -> Self {
        let fixels = &fixture.fixels;
        let twin = |index: usize| fixels[..index].iter().rposition(|other| other.friction == fixels[index].friction);
        Self { n_edges, twins: (0..fixels.len()).map(twin).collect(), next: Some(vec![0; fixels.len()]) }
    }

    /// How many there are in all.
    pub(super) fn total(&self) -> usize {
        // the k-th of k equal fixels multiplies C(n + k - 2, k - 1) by (n + k - 1) / k
        let mut ranks: Vec<usize> = Vec::new();
        self.twins.iter().fold(1, |count: usize, twin| {
            let rank = twin.map_or(1, |twin| ranks[twin] + 1);
            ranks.push(rank);
            count.saturating_mul(self.n_edges + rank - 1) / rank
        })
    }
}

impl Iterator for Choices {
    type Item = Vec<usize>;

    fn next(&mut self) -> Option<Vec<usize>> {
        let current = self.next.take()?;
        if let Some(last) = current.iter().rposition(|edge| edge + 1 < self.n_edges) {
            let mut following = current.clone();
            following[last] += 1;
            for index in last + 1..following.len() {
                following[index] = self.twins[index].map_or(0, |twin| following[twin]);
            }
            self.next = Some(following);
        }
        Some(current)
    }
}

impl Candidate {
    /// The best of a few places on these edges.
    pub(super) fn first(edges: Vec<usize>, estimator: &Estimator, searched: &mut Searched) -> Self {
        let n_fixels = edges.len();
        let mut best = Self { shares: vec![PARTS / 2; n_fixels], edges, margin: 0.0 };
        let digit = |code: usize, index: usize| code / FIRST.len().pow(index as u32) % FIRST.len();
        for code in 0..FIRST.len().pow(n_fixels as u32) {
            best.offer((0..n_fixels).map(|index| FIRST[digit(code, index)]).collect(), estimator, searched);
        }
        best
    }

    /// Moves the fixels as long as that helps, in smaller and smaller steps.
    pub(super) fn climb(&mut self, estimator: &Estimator, searched: &mut Searched) {
        let mut step = PARTS / 8;
        while step > 0 {
            let before = self.margin;
            for moved in neighbours(&self.shares.clone(), step, self.shares.len()) {
                self.offer(moved, estimator, searched);
            }
            if self.margin <= before {
                step /= 2;
            }
        }
    }

    fn offer(&mut self, shares: Vec<i64>, estimator: &Estimator, searched: &mut Searched) {
        let places = self.edges.iter().zip(&shares).map(|(edge, share)| (*edge, *share as f64 / PARTS as f64));
        let margin = estimator.margin(&places.collect::<Vec<_>>(), self.margin);
        searched.estimated += 1;
        if margin > self.margin {
            (self.shares, self.margin) = (shares, margin);
        }
    }
}

/// The places that differ from `shares` by a step of at most `at_once` fixels, single moves first.
pub(super) fn neighbours(shares: &[i64], step: i64, at_once: usize) -> Vec<Vec<i64>> {
    let mut moves = vec![Vec::new()];
    for _ in shares {
        let extended = |moves: &Vec<i64>| [0, -step, step].map(|by| [moves.as_slice(), &[by]].concat());
        moves = moves.iter().flat_map(extended).collect();
    }
    let n_moved = |moves: &Vec<i64>| moves.iter().filter(|by| **by != 0).count();
    moves.retain(|moves| (1..=at_once).contains(&n_moved(moves)));
    moves.sort_by_key(n_moved);
    let moved = |moves: &Vec<i64>| shares.iter().zip(moves).map(|(share, by)| share + by).collect::<Vec<i64>>();
    moves.iter().map(moved).filter(|shares| shares.iter().all(|share| INSIDE.contains(share))).collect()
}
