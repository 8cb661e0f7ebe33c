//! A cycle of an orbit: from one arrival on the main edge to the next.

use crate::answer::LimitSet;

/// Throws shown of an orbit that does not come back.
const WITHOUT: usize = 12;

/// The states of one cycle, and of the next if `cycles` is two, with the state that closes it; as the pattern has it, if one
/// is.
pub(super) fn cycle(set: &LimitSet, cycles: usize) -> &[(usize, f64)] {
    let orbit = &set.orbit[..];
    let is_arrival = |place: &usize| orbit[*place].0 == set.main_edge && orbit[place - 1].0 != set.main_edge;
    let arrivals: Vec<usize> = (1..orbit.len()).filter(is_arrival).collect();
    let pairs = || arrivals.windows(2);
    let is_usual = |pair: &&[usize]| order(&orbit[pair[0]..pair[1]]) == set.pattern;
    let Some(first) = pairs().position(|pair| is_usual(&pair)).or_else(|| pairs().next().map(|_| 0)) else {
        let count = set.period.unwrap_or(WITHOUT).clamp(1, 4 * WITHOUT) + 1;
        return &orbit[..orbit.len().min(count)];
    };
    let last = (first + cycles.max(1)).min(arrivals.len() - 1);
    &orbit[arrivals[first]..=arrivals[last]]
}

/// Edges that follow each other.
fn order(states: &[(usize, f64)]) -> Vec<usize> {
    let mut order: Vec<usize> = states.iter().map(|(edge, _)| *edge).collect();
    order.dedup();
    order
}
