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

use crate::answer::{Obstacle, Pin, PinPlan, PinSearch, Symmetry, Tradeoff};
use crate::exact::{Algebraic, Q};
use arcs::Arcs;
use layers::{Found, Rule, search};
use moves::{Run, Task, Way};
use num_traits::Zero as _;
use tolerance::{rounded_down, rounding, short};

/// Where arcs tell the number of pins, the search for wider ones is given up after so many sets.
const MOST_SETS: usize = 2_000;

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
/// With k orientations and b bands O(b k) a set, and O(b² k²) in all for the fewest pins where none jams. Otherwise the
/// number of sets may be exponential, as it may for wider tolerances and for the smallest sets if there is no plan.
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
    let arcs = Arcs::of(&task, &Q::zero());
    plan.searched.by_arcs = arcs.is_some();
    let by_arcs = arcs.as_ref().and_then(|arcs| arcs.way(&task));
    let shortest = match by_arcs {
        Some((way, n_sets)) => {
            plan.searched.reachable_sets = n_sets;
            way
        }
        None => {
            let pairs = obstacle::inseparable_pairs(&task);
            let found = search(&task, &Rule::default(), is_over);
            plan.searched.reachable_sets = found.n_sets;
            match found.goals.first() {
                Some(goal) => found.way_to(*goal),
                None if found.is_cut && pairs.is_empty() => return plan,
                None => {
                    let obstacle = obstacle::of(&task, &found, pairs);
                    let wiper = wiper::best(&task, wanted.max_pins, is_over);
                    plan.obstacle = Some(Obstacle { wiper, ..obstacle });
                    return plan;
                }
            }
        }
    };
    let n_pins = shortest.runs.len();
    if wanted.max_pins.is_some_and(|most| most < n_pins) {
        plan.needs = Some(n_pins);
        return plan;
    }
    let way = widest(&task, shortest, arcs.as_ref(), wanted, &mut plan.pareto, is_over);
    plan.end = task.class_edges(&way.last);
    plan.sequence = Some(way.sets.iter().zip(&way.runs).map(|(set, run)| pin(&task, set, *run)).collect());
    plan
}

/// The widest of all ways as short as one that is known, and what longer ones allow if that is wanted.
///
/// Where arcs tell the number of pins, the way known is already the widest but for heights that are critical only for
/// orientations that cannot be there: then the search for a wider one may be given up.
fn widest(
    task: &Task,
    known: Way,
    arcs: Option<&Arcs>,
    wanted: &Wanted,
    pareto: &mut Vec<Tradeoff>,
    is_over: &mut dyn FnMut() -> bool,
) -> Way {
    let n_pins = known.runs.len();
    let Some(least) = known.runs.iter().map(|run| task.tolerance(*run)).min() else { return known };
    let rule = Rule {
        arcs,
        most_pins: if wanted.pareto { wanted.max_pins } else { Some(n_pins) },
        is_weighed: true,
        known: Some(&least),
        goes_on: wanted.pareto,
        most_sets: arcs.filter(|_| !wanted.pareto).map(|_| MOST_SETS),
    };
    let found = search(task, &rule, is_over);
    if wanted.pareto {
        *pareto = tradeoffs(&found, Tradeoff { pins: n_pins, tolerance: least });
    }
    found.widest_with(n_pins).map_or(known, |goal| found.way_to(goal))
}

/// The goals whose tolerance is wider than with fewer pins by more than what the ends of bands are rounded.
fn tradeoffs(found: &Found, first: Tradeoff) -> Vec<Tradeoff> {
    let mut entries = vec![first];
    let most = found.goals.last().map_or(0, |goal| found.reached[*goal].n_pins);
    for pins in 1..=most {
        let last = entries.last_mut().expect("there is a first");
        let tolerance = found.widest_with(pins).and_then(|goal| found.reached[goal].tolerance.clone());
        match tolerance {
            Some(tolerance) if pins == last.pins => last.tolerance = tolerance,
            Some(tolerance) if tolerance > &last.tolerance + rounding(&last.tolerance) => {
                entries.push(Tradeoff { pins, tolerance });
            }
            _ => {}
        }
    }
    entries.iter_mut().for_each(|entry| entry.tolerance = rounded_down(&entry.tolerance));
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
