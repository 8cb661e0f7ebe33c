//! Sequences of pins by trying every set of orientations, with what balance of forces says that pins do.

use crate::support::topple::Conveyed;
use partplan::answer::Pins;
use std::collections::{BTreeMap, BTreeSet, VecDeque};

/// Where each stable edge goes at one height, or none if it jams.
type Outcome = BTreeMap<usize, Option<usize>>;
type Set = BTreeSet<usize>;

/// Sequences of pins, all of them.
pub struct Search<'a> {
    stable: Set,
    classes: &'a [Vec<usize>],
    outcomes: BTreeSet<Outcome>,
}

impl<'a> Search<'a> {
    /// One pin in each band between critical heights that `pins` lists; none if doubles cannot say what one does.
    pub fn new(pins: &'a Pins, oracle: &Conveyed) -> Option<Self> {
        let ends = pins.orientations.iter().flat_map(|o| &o.intervals).map(|interval| interval.from.to_f64());
        let mut ends: Vec<f64> = ends.collect();
        ends.sort_by(f64::total_cmp);
        ends.dedup_by(|a, b| (*a - *b).abs() < 1e-12 * *b);
        ends.push(2.0 * ends.last()?);
        let mut outcomes = BTreeSet::new();
        for band in ends.windows(2) {
            let h = (band[0] + band[1]) / 2.0;
            let outcome = pins.stable.iter().map(|edge| Some((*edge, oracle.outcome(*edge, h)?)));
            outcomes.insert(outcome.collect::<Option<Outcome>>()?);
        }
        Some(Self { stable: pins.stable.iter().copied().collect(), classes: &pins.symmetry.classes, outcomes })
    }

    pub fn classes_of(&self, set: &Set) -> usize {
        self.classes.iter().filter(|class| class.iter().any(|edge| set.contains(edge))).count()
    }

    /// Sets that pins reach from `start`, with the number of pins.
    fn reach(&self, start: Set) -> BTreeMap<Set, usize> {
        let mut found = BTreeMap::from([(start.clone(), 0)]);
        let mut queue = VecDeque::from([start]);
        while let Some(set) = queue.pop_front() {
            let pins = found[&set];
            for outcome in &self.outcomes {
                let Some(after) = set.iter().map(|edge| outcome[edge]).collect::<Option<Set>>() else { continue };
                if !found.contains_key(&after) {
                    found.insert(after.clone(), pins + 1);
                    queue.push_back(after);
                }
            }
        }
        found
    }

    /// The fewest pins that leave one class.
    pub fn fewest_pins(&self) -> Option<usize> {
        let reached = self.reach(self.stable.clone());
        reached.iter().filter(|(set, _)| self.classes_of(set) == 1).map(|(_, pins)| *pins).min()
    }

    /// Sets of the fewest classes that pins leave.
    pub fn smallest_sets(&self) -> BTreeSet<Vec<usize>> {
        let reached = self.reach(self.stable.clone());
        let fewest = reached.keys().map(|set| self.classes_of(set)).min().expect("the start is reached");
        let smallest = reached.into_keys().filter(|set| self.classes_of(set) == fewest);
        smallest.map(|set| set.into_iter().collect()).collect()
    }

    /// Pairs of orientations that no pins bring into one class.
    pub fn inseparable_pairs(&self) -> BTreeSet<[usize; 2]> {
        let pairs = self.stable.iter().flat_map(|a| self.stable.range(a + 1..).map(|b| [*a, *b]));
        pairs.filter(|pair| self.reach(Set::from(*pair)).keys().all(|set| self.classes_of(set) > 1)).collect()
    }

    /// Orientations that no pin moves in any set that pins leave.
    pub fn never_moved(&self) -> Vec<usize> {
        let reached = self.reach(self.stable.clone());
        let moves = |edge: &usize| {
            let sets = reached.keys().filter(|set| set.contains(edge));
            let steps = sets.flat_map(|set| self.outcomes.iter().map(move |outcome| (set, outcome)));
            let mut free = steps.filter(|(set, outcome)| set.iter().all(|other| outcome[other].is_some()));
            free.any(|(_, outcome)| outcome[edge] != Some(*edge))
        };
        self.stable.iter().filter(|edge| !moves(edge)).copied().collect()
    }
}

/// Where the part may rest after pins at `heights`, whatever stable edge it came on; none where doubles cannot say.
pub fn replay(oracle: &Conveyed, heights: impl IntoIterator<Item = f64>) -> Option<Result<Set, String>> {
    let mut set: Set = oracle.stable.iter().copied().collect();
    for h in heights {
        let mut after = Set::new();
        for edge in set {
            match oracle.outcome(edge, h)? {
                Some(end) => after.insert(end),
                None => return Some(Err(format!("edge {edge} jams at {h}"))),
            };
        }
        set = after;
    }
    Some(Ok(set))
}
