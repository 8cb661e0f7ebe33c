//! Why no pins turn all orientations into one.

use super::layers::Found;
use super::moves::{Task, set_of};
use crate::answer::Obstacle;
use crate::cone::bits::{Set, is_subset, members, union};
use std::collections::VecDeque;

/// What a search that has reached no goal shows.
pub(super) fn of(task: &Task, found: &Found, inseparable_pairs: Vec<[usize; 2]>) -> Obstacle {
    let moved = found.reached.iter();
    let moved = moved.fold(set_of(task.n(), []), |moved, reached| union(&moved, &task.moved(&reached.set)));
    let never_moved = (0..task.n()).filter(|place| members(&moved).all(|other| other != *place));
    Obstacle {
        smallest_sets: smallest(task, found),
        inseparable_pairs,
        never_moved: never_moved.map(|place| task.edge(place)).collect(),
        wiper: None,
        friction: None,
    }
}

/// Of the sets with the fewest classes those that hold no other.
fn smallest(task: &Task, found: &Found) -> Vec<Vec<usize>> {
    let sets = || found.reached.iter().map(|reached| (task.classes_in(&reached.set).len(), &reached.set));
    let fewest = sets().map(|(n_classes, _)| n_classes).min();
    let smallest: Vec<&Set> = sets().filter(|(n, _)| Some(*n) == fewest).map(|(_, set)| set).collect();
    let holds_another = |set: &Set| smallest.iter().any(|other| *other != set && is_subset(other, set));
    let mut edges: Vec<Vec<usize>> =
        smallest.iter().filter(|set| !holds_another(set)).map(|set| task.edges(set)).collect();
    edges.sort_unstable();
    edges
}

/// The pairs of edges that no sequence of pins, each of which jams neither, takes to edges that look the same.
///
/// One such pair is a proof that no pins turn all orientations into one. Found backward from the pairs that look the
/// same: each pair is met once by each pin.
///
/// # Source
/// Natarajan (1989), cited in Zhang et al., section II: the graph of pairs.
///
/// # Cost
/// O(k² m) with k orientations and m different outcomes.
pub(super) fn inseparable_pairs(task: &Task) -> Vec<[usize; 2]> {
    let n = task.n();
    let sources: Vec<Vec<Vec<usize>>> = task.maps().into_iter().map(sources).collect();
    let mut joined = vec![false; n * n];
    let mut queue = VecDeque::new();
    for (a, b) in pairs(n).filter(|(a, b)| task.class(*a) == task.class(*b)) {
        joined[a * n + b] = true;
        queue.push_back((a, b));
    }
    while let Some((a, b)) = queue.pop_front() {
        for sources in &sources {
            for (a, b) in sources[a].iter().flat_map(|a| sources[b].iter().map(|b| (*a, *b))) {
                let (a, b) = (a.min(b), a.max(b));
                if !joined[a * n + b] {
                    joined[a * n + b] = true;
                    queue.push_back((a, b));
                }
            }
        }
    }
    pairs(n).filter(|(a, b)| !joined[a * n + b]).map(|(a, b)| [task.edge(a), task.edge(b)]).collect()
}

/// For each orientation those that a pin takes there.
fn sources(outcome: &[Option<usize>]) -> Vec<Vec<usize>> {
    let mut sources = vec![Vec::new(); outcome.len()];
    for (place, to) in outcome.iter().enumerate() {
        if let Some(to) = to {
            sources[*to].push(place);
        }
    }
    sources
}

fn pairs(n: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..n).flat_map(move |a| (a..n).map(move |b| (a, b)))
}
