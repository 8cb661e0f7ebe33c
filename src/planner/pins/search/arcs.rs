//! How many pins are needed where none jams: backward search over arcs of the cyclic order.

use super::moves::Task;
use crate::cone::bits::members;
use std::collections::{BTreeSet, VecDeque};

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
    /// `None` if some pin is of use that jams an orientation, or moves one otherwise than to the next stop.
    ///
    /// # Source
    /// Eppstein (1990), "Reset sequences for monotonic automata", theorem 1.
    ///
    /// # Cost
    /// O(k² m) with k orientations and m different outcomes.
    pub(super) fn of(task: &Task) -> Option<Self> {
        let n = task.n_classes();
        // a turn of the part onto itself takes the orientations round in steps of their number of classes
        let is_round = |place: usize| task.class(place) == task.class(place % n);
        let n_first: BTreeSet<usize> = (0..n).map(|place| task.class(place)).collect();
        if !task.n().is_multiple_of(n) || n_first.len() != n || !(0..task.n()).all(is_round) {
            return None;
        }
        let stops = task.maps().into_iter().map(|outcome| stops(outcome, n)).collect::<Option<Vec<_>>>()?;
        let mut arcs = Self { n, needed: vec![None; n * n] };
        arcs.fill(&stops, |place| task.end().is_none_or(|end| task.class(place) == end));
        arcs.spread();
        Some(arcs)
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
