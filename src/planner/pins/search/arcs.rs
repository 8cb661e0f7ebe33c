//! How many pins are needed where none jams: backward search over arcs of the cyclic order.

use super::moves::{Move, Task, Way};
use crate::cone::bits::members;
use crate::exact::Q;
use num_traits::Zero as _;
use std::collections::{BTreeSet, HashSet, VecDeque};

/// For every set of orientations how many pins it needs at least, exactly.
///
/// Every pin that is of use moves each orientation down to the first one where parts stop, in cyclic order, and jams none.
/// What it takes into an arc of that order is then an arc: a set can be made one orientation by n pins if and only if one
/// of the arcs that n pins take there holds it.
pub(super) struct Arcs {
    /// Orientations that can be told apart.
    n: usize,
    /// By first orientation and length less one, `None` if no pins will do.
    needed: Vec<Option<usize>>,
}

impl Arcs {
    /// By pins with at least this tolerance.
    ///
    /// `None` if some pin is of use that jams an orientation, or moves one otherwise than to the next stop.
    ///
    /// # Source
    /// Eppstein (1990), "Reset sequences for monotonic automata", theorem 1.
    ///
    /// # Cost
    /// O(k² m) with k orientations and m different outcomes.
    pub(super) fn of(task: &Task, least: &Q) -> Option<Self> {
        let n = task.n_classes();
        // a turn of the part onto itself takes the orientations round in steps of their number of classes
        let is_round = |place: usize| task.class(place) == task.class(place % n);
        let n_first: BTreeSet<usize> = (0..n).map(|place| task.class(place)).collect();
        let is_whole = task.n().is_multiple_of(n) && n_first.len() == n && (0..task.n()).all(is_round);
        let maps = task.maps();
        if !is_whole || maps.iter().any(|outcome| stops(outcome, n).is_none()) {
            return None;
        }
        // as no pin jams, those for all orientations are all
        let wide = task.runs(&task.everything()).into_iter().filter(|run| task.tolerance(*run) >= *least);
        let wide: BTreeSet<&[Option<usize>]> = wide.map(|run| task.run_outcome(run)).collect();
        let stops: Vec<Stops> = wide.into_iter().filter_map(|outcome| stops(outcome, n)).collect();
        let mut arcs = Self { n, needed: vec![None; n * n] };
        arcs.fill(&stops, |place| task.end().is_none_or(|end| task.class(place) == end));
        arcs.spread();
        Some(arcs)
    }

    /// As few pins as any have, and the widest of these if every pin must stay in heights that do the same to all
    /// orientations, there or not; also how many sets were met. `None` if no pins will do.
    pub(super) fn way(&self, task: &Task) -> Option<(Way, usize)> {
        let fewest = self.fewest()?;
        let mut tolerances: Vec<Q> = task.runs(&task.everything()).into_iter().map(|run| task.tolerance(run)).collect();
        tolerances.sort();
        let is_enough = |least: &Q| Self::of(task, least).is_some_and(|arcs| arcs.fewest() == Some(fewest));
        let n_enough = tolerances.partition_point(is_enough);
        let least = n_enough.checked_sub(1).map_or_else(Q::zero, |last| tolerances[last].clone());
        let wide = Self::of(task, &least)?;
        let mut way = Way { sets: Vec::new(), runs: Vec::new(), last: task.everything() };
        let mut met = HashSet::from([task.everything()]);
        for left in (0..fewest).rev() {
            let moves = task.moves(&way.last);
            met.extend(moves.iter().map(|step| step.after.clone()));
            let is_next = |step: &Move| step.tolerance >= least && wide.needed(&step.after) == Some(left);
            let next = moves.into_iter().find(is_next).expect("a pin makes what needs one pin less");
            way.sets.push(std::mem::replace(&mut way.last, next.after));
            way.runs.push(next.run);
        }
        Some((way, met.len()))
    }

    /// The pins needed for all orientations; `None` if no pins will do.
    pub(super) fn fewest(&self) -> Option<usize> {
        self.needed[self.at(0, self.n)]
    }

    /// The pins needed for a set.
    pub(super) fn needed(&self, set: &[u64]) -> Option<usize> {
        let places: BTreeSet<usize> = members(set).map(|place| place % self.n).collect();
        let last = places.last().copied()?;
        let before = std::iter::once(last).chain(places.iter().copied());
        // the arcs that leave out one gap
        let lengths = places.iter().zip(before).map(|(first, last)| (*first, (last + self.n - first) % self.n + 1));
        lengths.filter_map(|(first, length)| self.needed[self.at(first, length)]).min()
    }

    /// Arcs of all lengths up to all orientations, which is one arc however it begins.
    fn at(&self, first: usize, length: usize) -> usize {
        (if length == self.n { 0 } else { first }) * self.n + length - 1
    }

    /// The arcs that are taken to one orientation, by the fewest pins.
    fn fill(&mut self, stops: &[Stops], is_target: impl Fn(usize) -> bool) {
        let mut queue = VecDeque::new();
        for place in (0..self.n).filter(|place| is_target(*place)) {
            let at = self.at(place, 1);
            self.needed[at] = Some(0);
            queue.push_back((place, 1, 0));
        }
        while let Some((first, length, n_pins)) = queue.pop_front() {
            for (first, length) in stops.iter().filter_map(|stops| stops.taken_into(first, length)) {
                let at = self.at(first, length);
                if self.needed[at].is_none() {
                    self.needed[at] = Some(n_pins + 1);
                    queue.push_back((first, length, n_pins + 1));
                }
            }
        }
    }

    /// What holds for an arc holds for its parts.
    fn spread(&mut self) {
        for length in (1..self.n).rev() {
            for first in 0..self.n {
                let longer = [first, (first + self.n - 1) % self.n].map(|first| self.at(first, length + 1));
                let at = self.at(first, length);
                let known = [at, longer[0], longer[1]].into_iter().filter_map(|at| self.needed[at]);
                self.needed[at] = known.min();
            }
        }
    }
}

/// Where parts stop at a pin.
struct Stops {
    /// For each orientation how far above is the first stop, itself included.
    up: Vec<usize>,
    /// The same below.
    down: Vec<usize>,
}

/// The stops of a pin that takes every orientation down to the next one; `None` if it does not.
fn stops(outcome: &[Option<usize>], n: usize) -> Option<Stops> {
    let is_stop = |place: usize| outcome[place % n].is_some_and(|to| to % n == place % n);
    let find = |way: &dyn Fn(usize) -> usize| (0..n).find(|far| is_stop(way(*far)));
    let up = (0..n).map(|place| find(&|far| place + far)).collect::<Option<Vec<_>>>()?;
    let down = (0..n).map(|place| find(&|far| place + n - far)).collect::<Option<Vec<_>>>()?;
    let goes_down =
        |(place, to): (usize, &Option<usize>)| *to == Some((place + outcome.len() - down[place % n]) % outcome.len());
    outcome.iter().enumerate().all(goes_down).then_some(Stops { up, down })
}

impl Stops {
    /// The arc of the orientations that the pin takes into an arc, as first and length; `None` if there are none.
    fn taken_into(&self, first: usize, length: usize) -> Option<(usize, usize)> {
        let n = self.up.len();
        let lowest = (self.up[first] < length).then(|| (first + self.up[first]) % n)?;
        let last = (first + length - 1) % n;
        let highest = (last + n - self.down[last]) % n;
        // up to the stop above the highest
        let above = (highest + 1) % n;
        let end = (above + self.up[above]) % n;
        let length = (end + n - lowest) % n;
        Some((lowest, if length == 0 { n } else { length }))
    }
}
