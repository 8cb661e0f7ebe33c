//! The fewest pins that turn all stable orientations into one, or why there are none.
//!
//! Orientations are numbered by their places among the stable edges. A pin in a [`Band`] sends a set of orientations to
//! the set of their outcomes, and may be used only if none of them jams.

mod arcs;
mod layers;
mod moves;
mod obstacle;
#[cfg(test)]
mod tests;
mod tolerance;
mod wiper;

use crate::answer::{Pin, PinPlan, PinSearch, Symmetry, Tradeoff};
use crate::exact::{Algebraic, Q};
use arcs::Arcs;
use layers::{Found, Rule, search};
use moves::{Run, Task};
use num_traits::Zero as _;
use tolerance::{rounded_down, short};

/// Heights strictly between two critical ones, and where every stable orientation ends at a pin of such a height.
///
/// Outcomes are places among the stable edges, in the order of these.
#[derive(Debug, Clone)]
pub(super) struct Band {
    pub(super) low: Algebraic,
    pub(super) high: Algebraic,
    /// `None` where the orientation jams or it is uncertain what it does.
    pub(super) outcome: Vec<Option<usize>>,
    /// The same at the height `low` itself; `None` also where that height is critical for an orientation on the way.
    ///
    /// A pin may be off across a height that is critical only for orientations that cannot be there.
    pub(super) at_low: Vec<Option<usize>>,
}

/// What is asked.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct Wanted {
    /// A stable edge on which, or on one that looks the same, the part is to end.
    pub(super) end: Option<usize>,
    /// The most pins allowed.
    pub(super) max_pins: Option<usize>,
    /// Whether wider tolerances by more pins are wanted.
    pub(super) pareto: bool,
}

/// Finds the fewest pins after which all stable orientations look the same, and among the fewest those with the widest
/// least tolerance; or shows why there are none.
///
/// `bands` are in ascending order. `is_over` is asked now and then, and ends the search by `true`: then what is found so
/// far is returned, the widest pins perhaps not yet, and the limit is left to the caller. That there are no pins is
/// proved, even so, if an obstacle is returned.
///
/// # Source
/// Zhang, Goldberg, Smith, Berretty & Overmars, "Pin design for part feeding", section VI, with a search that is complete
/// breadth first instead of depth first; Eppstein (1990), "Reset sequences for monotonic automata", where no pin jams.
///
/// # Cost
/// With k orientations and b bands O(b k) a set. The number of sets may be exponential if pins jam some orientations
/// only; it is at most the number of pins needed where none does ([`Arcs`]).
///
/// # Panics
/// If a band is empty, or an edge of the classes, or the one asked for, is not stable.
pub(super) fn plan(
    stable: &[usize],
    symmetry: &Symmetry,
    bands: &[Band],
    wanted: &Wanted,
    is_over: &mut dyn FnMut() -> bool,
) -> PinPlan {
    let task = Task::of(stable, symmetry, bands, wanted.end);
    let mut plan = PinPlan { searched: task.counts(), ..PinPlan::default() };
    let arcs = Arcs::of(&task);
    plan.searched.by_arcs = arcs.is_some();
    let pairs = obstacle::inseparable_pairs(&task);
    let first = search(&task, &Rule { arcs: arcs.as_ref(), ..Rule::default() }, is_over);
    plan.searched.reachable_sets = first.n_sets;
    let Some(fewest) = first.goals.first() else {
        if !first.is_cut || !pairs.is_empty() {
            let mut obstacle = obstacle::of(&task, &first, pairs);
            obstacle.wiper = wiper::best(&task, wanted.max_pins, is_over);
            plan.obstacle = Some(obstacle);
        }
        return plan;
    };
    let n_pins = first.reached[*fewest].n_pins;
    if wanted.max_pins.is_some_and(|most| most < n_pins) {
        plan.needs = Some(n_pins);
        return plan;
    }
    let most = if wanted.pareto { wanted.max_pins } else { Some(n_pins) };
    let rule = Rule { arcs: arcs.as_ref(), most_pins: most, is_weighed: true, goes_on: wanted.pareto };
    let widest = if n_pins == 0 { Found::default() } else { search(&task, &rule, is_over) };
    if wanted.pareto {
        plan.pareto = tradeoffs(&widest);
    }
    let (found, goal) = match widest.widest_with(n_pins) {
        Some(goal) => (&widest, goal),
        None => (&first, *fewest),
    };
    let (sets, runs) = found.way_to(goal);
    plan.end = task.class_edges(found.reached[goal].set.as_slice());
    plan.sequence = Some(sets.iter().zip(&runs).map(|(set, run)| pin(&task, set, *run)).collect());
    plan
}

/// The goals whose tolerance is wider than with fewer pins by more than what the ends of bands are rounded.
fn tradeoffs(found: &Found) -> Vec<Tradeoff> {
    let mut entries: Vec<Tradeoff> = Vec::new();
    let mut widest = Q::zero();
    let most = found.goals.last().map_or(0, |goal| found.reached[*goal].n_pins);
    for pins in 1..=most {
        let tolerance = found.widest_with(pins).and_then(|goal| found.reached[goal].tolerance.clone());
        if let Some(tolerance) = tolerance.filter(|tolerance| *tolerance > &widest + tolerance::rounding(&widest)) {
            entries.push(Tradeoff { pins, tolerance: rounded_down(&tolerance) });
            widest = tolerance;
        }
    }
    entries
}

/// The pin in the middle of a run of bands that do the same to all orientations of `set`.
fn pin(task: &Task, set: &[u64], run: Run) -> Pin {
    let [low, high] = task.ends(run);
    let (height, tolerance) = short(low, high);
    let outcome = task.outcome(set, run);
    let mut after: Vec<usize> = outcome.values().copied().collect();
    after.sort_unstable();
    after.dedup();
    let [low, high] = task.critical(run).map(Algebraic::clone);
    Pin { height, low, high, tolerance, outcome, after }
}
