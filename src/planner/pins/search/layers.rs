//! Breadth-first search over sets of orientations.

use super::arcs::Arcs;
use super::moves::{Run, Task, Way};
use crate::cone::bits::{Set, count, is_subset};
use crate::exact::Q;
use std::collections::{BTreeMap, HashSet};

/// What to search for.
#[derive(Clone, Copy, Default)]
pub(super) struct Rule<'a> {
    /// How many pins sets need at least, if that is known.
    pub(super) arcs: Option<&'a Arcs>,
    /// The most pins.
    pub(super) most_pins: Option<usize>,
    /// Whether tolerances count.
    pub(super) is_weighed: bool,
    /// The tolerance that is to be exceeded.
    pub(super) known: Option<&'a Q>,
    /// Whether to go on after the fewest pins, as long as more may have a wider tolerance.
    pub(super) goes_on: bool,
    /// After so many sets the search is given up.
    pub(super) most_sets: Option<usize>,
}

/// What a search has found.
#[derive(Default)]
pub(super) struct Found {
    /// The sets that were not given up, by ascending numbers of pins.
    pub(super) reached: Vec<Reached>,
    /// Those that are as wanted.
    pub(super) goals: Vec<usize>,
    /// How many different sets were met.
    pub(super) n_sets: usize,
    /// Whether the search was ended before its end.
    pub(super) is_cut: bool,
}

/// A set of orientations after some pins.
pub(super) struct Reached {
    pub(super) set: Set,
    pub(super) n_pins: usize,
    /// The least tolerance on the way; none before the first pin, and where tolerances do not count.
    pub(super) tolerance: Option<Q>,
    last: Option<(usize, Run)>,
}

/// Searches all sets that pins make of all orientations, those of one more pin in each step.
///
/// A set is given up if one of its subsets T was reached by no more pins and with no narrower tolerance. Nothing is lost
/// by that: a pin that may be used on a set S ⊇ T jams no member of T, so it may be used on T; it makes a subset of what
/// it makes of S, which is not empty; and it may be off on T at least as far as on S, because heights that do the same
/// to all of S do so to all of T. So whatever pins make of S, the same pins make no more of T: what looks the same in S
/// does in T, and a set that holds no other reachable set is never given up. Without tolerances the argument is the same
/// with all of them equal.
///
/// With tolerances, a set is also given up if a goal is known that has no narrower one.
pub(super) fn search(task: &Task, rule: &Rule, is_over: &mut dyn FnMut() -> bool) -> Found {
    let start = Reached { set: task.everything(), n_pins: 0, tolerance: None, last: None };
    let mut met = HashSet::from([start.set.clone()]);
    let mut found = Found::default();
    let mut front = Vec::new();
    found.keep(task, start, &mut front);
    while !found.is_cut && !front.is_empty() && (rule.goes_on || found.goals.is_empty()) {
        let n_pins = found.reached[front[0]].n_pins + 1;
        if rule.most_pins.is_some_and(|most| most < n_pins) {
            break;
        }
        let Some(next) = found.step(task, rule, &front, is_over) else {
            found.is_cut = true;
            break;
        };
        front.clear();
        for candidate in next {
            met.insert(candidate.set.clone());
            if is_over() || rule.most_sets.is_some_and(|most| most < met.len()) {
                found.is_cut = true;
                break;
            }
            if !rule.is_hopeless(&candidate) && !found.is_beaten(&candidate) {
                found.keep(task, candidate, &mut front);
            }
        }
    }
    found.n_sets = met.len();
    found
}

impl Rule<'_> {
    /// Whether the tolerance is too narrow, or a goal can be reached from all orientations, but not from this set with
    /// the pins that are left.
    fn is_hopeless(&self, candidate: &Reached) -> bool {
        if self.known.is_some() && candidate.tolerance.as_ref() <= self.known {
            return true;
        }
        let Some((arcs, fewest)) = self.arcs.and_then(|arcs| Some((arcs, arcs.fewest()?))) else { return false };
        let Some(needed) = arcs.needed(&candidate.set) else { return true };
        let most = if self.goes_on { self.most_pins } else { Some(fewest) };
        most.is_some_and(|most| most < candidate.n_pins + needed)
    }
}

impl Found {
    /// The goal with this number of pins that has the widest tolerance.
    pub(super) fn widest_with(&self, n_pins: usize) -> Option<usize> {
        let goals = self.goals.iter().copied().filter(|goal| self.reached[*goal].n_pins == n_pins);
        goals.reduce(|a, b| if self.reached[a].tolerance < self.reached[b].tolerance { b } else { a })
    }

    /// The pins that lead to a reached set.
    pub(super) fn way_to(&self, goal: usize) -> Way {
        let mut way = Way { sets: Vec::new(), runs: Vec::new(), last: self.reached[goal].set.clone() };
        let mut at = goal;
        while let Some((before, run)) = self.reached[at].last {
            way.sets.push(self.reached[before].set.clone());
            way.runs.push(run);
            at = before;
        }
        way.sets.reverse();
        way.runs.reverse();
        way
    }

    /// What one more pin makes of the sets in front, so ordered that no set beats an earlier one; `None` if time is over.
    fn step(
        &self,
        task: &Task,
        rule: &Rule,
        front: &[usize],
        is_over: &mut dyn FnMut() -> bool,
    ) -> Option<Vec<Reached>> {
        let mut next: BTreeMap<(Set, Option<Q>), Reached> = BTreeMap::new();
        for &index in front {
            if is_over() {
                return None;
            }
            let before = &self.reached[index];
            for step in task.moves(&before.set) {
                let narrower =
                    |tolerance: &Q| before.tolerance.clone().map_or(tolerance.clone(), |a| a.min(tolerance.clone()));
                let tolerance = rule.is_weighed.then(|| narrower(&step.tolerance));
                let reached = Reached {
                    set: step.after.clone(),
                    n_pins: before.n_pins + 1,
                    tolerance: tolerance.clone(),
                    last: Some((index, step.run)),
                };
                next.entry((step.after, tolerance)).or_insert(reached);
            }
        }
        let mut next: Vec<Reached> = next.into_values().collect();
        next.sort_by(|a, b| count(&a.set).cmp(&count(&b.set)).then_with(|| b.tolerance.cmp(&a.tolerance)));
        Some(next)
    }

    fn is_beaten(&self, candidate: &Reached) -> bool {
        let is_wider = |other: &Reached| other.tolerance.is_none() || other.tolerance >= candidate.tolerance;
        let of_goals = candidate.tolerance.is_some()
            && self.goals.iter().any(|goal| self.reached[*goal].tolerance >= candidate.tolerance);
        of_goals || self.reached.iter().any(|other| is_wider(other) && is_subset(&other.set, &candidate.set))
    }

    fn keep(&mut self, task: &Task, reached: Reached, front: &mut Vec<usize>) {
        let index = self.reached.len();
        if task.is_goal(&reached.set) {
            self.goals.push(index)
        } else {
            front.push(index)
        }
        self.reached.push(reached);
    }
}
