//! A cycle of an orbit: from one arrival on the main edge to a later one.

use crate::answer::LimitSet;
use std::collections::BTreeSet;

/// Throws shown of an orbit that does not come back.
const WITHOUT: usize = 12;
/// A cycle has no more throws, unless it comes back to the main edge only once.
const MOST: usize = 60;

/// The states of one cycle with the state that closes it: until the orbit has been on all of its edges, and from where it
/// then does as the pattern says, if it ever does.
pub(super) fn cycle(set: &LimitSet) -> &[(usize, f64)] {
    let orbit = &set.orbit[..];
    let is_arrival = |place: &usize| orbit[*place].0 == set.main_edge && orbit[place - 1].0 != set.main_edge;
    let arrivals: Vec<usize> = (1..orbit.len()).filter(is_arrival).collect();
    let is_usual = |place: &usize| order(&orbit[arrivals[*place]..arrivals[place + 1]]) == set.pattern;
    let n_cycles = arrivals.len().saturating_sub(1);
    if n_cycles == 0 {
        let count = set.period.unwrap_or(WITHOUT).clamp(1, MOST) + 1;
        return &orbit[..orbit.len().min(count)];
    }
    let first = (0..n_cycles).find(is_usual).unwrap_or(0);
    let edges = |states: &[(usize, f64)]| states.iter().map(|(edge, _)| *edge).collect::<BTreeSet<usize>>();
    let all = edges(orbit);
    let ends = (first + 1..arrivals.len()).take_while(|last| arrivals[*last] - arrivals[first] <= MOST);
    let whole = ends.into_iter().find(|last| edges(&orbit[arrivals[first]..arrivals[*last]]) == all);
    &orbit[arrivals[first]..=arrivals[whole.unwrap_or(first + 1)]]
}

/// Edges that follow each other.
pub(super) fn order(states: &[(usize, f64)]) -> Vec<usize> {
    let mut order: Vec<usize> = states.iter().map(|(edge, _)| *edge).collect();
    order.dedup();
    order
}
