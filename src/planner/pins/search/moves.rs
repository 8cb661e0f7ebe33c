//! What pins do to sets of orientations.

use super::tolerance::inside;
use super::{Band, PinSearch, Q};
use crate::answer::Symmetry;
use crate::cone::bits::{Set, all, count, intersect, is_subset, members, union};
use crate::exact::{Algebraic, ratio};
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// The orientations, which of them look the same, and what pins do to them.
pub(super) struct Task<'a> {
    stable: &'a [usize],
    bands: &'a [Band],
    /// For each place its class.
    classes: Vec<usize>,
    n_classes: usize,
    /// The class to end in.
    end: Option<usize>,
    /// The bands that do not jam every orientation, ascending.
    rows: Vec<Row>,
}

/// A band that is of use.
struct Row {
    band: usize,
    jams: Set,
    moves: Set,
    /// The orientations for which the next lower row, the height between, and this one do the same.
    same: Set,
    /// The ends, rounded inward; the bands themselves are open.
    ends: [Q; 2],
}

/// Rows from one to another that, for the orientations in question, do the same at every height.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Run {
    first: usize,
    last: usize,
}

/// A step from one set to another by the widest run that makes it.
#[derive(Debug, Clone)]
pub(super) struct Move {
    pub(super) after: Set,
    pub(super) run: Run,
    pub(super) tolerance: Q,
}

/// Pins one after the other: the sets before each, the pins, and the set after the last.
pub(super) struct Way {
    pub(super) sets: Vec<Set>,
    pub(super) runs: Vec<Run>,
    pub(super) last: Set,
}

impl<'a> Task<'a> {
    pub(super) fn of(stable: &'a [usize], symmetry: &Symmetry, bands: &'a [Band], end: Option<usize>) -> Self {
        let place = |edge: usize| stable.binary_search(&edge).expect("only stable edges are in question");
        let mut classes = vec![0; stable.len()];
        for (class, edges) in symmetry.classes.iter().enumerate() {
            edges.iter().for_each(|edge| classes[place(*edge)] = class);
        }
        let end = end.map(|edge| classes[place(edge)]);
        let mut task = Self { stable, bands, classes, n_classes: symmetry.classes.len(), end, rows: Vec::new() };
        task.rows = (0..bands.len()).filter_map(|band| task.row(band)).collect();
        task
    }

    fn row(&self, index: usize) -> Option<Row> {
        let band = &self.bands[index];
        let outcome = &band.outcome;
        let places = |holds: &dyn Fn(usize) -> bool| set_of(self.n(), (0..self.n()).filter(|place| holds(*place)));
        let jams = places(&|place| outcome[place].is_none());
        if count(&jams) == self.n() {
            return None;
        }
        let below = index.checked_sub(1).map(|below| &self.bands[below]).filter(|below| below.high == band.low);
        let is_same = |place: usize| {
            outcome[place].is_some()
                && band.at_low.get(place) == Some(&outcome[place])
                && below.is_some_and(|below| below.outcome[place] == outcome[place])
        };
        let ends = inside(&band.low, &band.high).expect("a band has room");
        let moves = places(&|place| outcome[place].is_some_and(|to| to != place));
        Some(Row { band: index, same: places(&is_same), jams, moves, ends })
    }

    /// How many orientations there are.
    pub(super) fn n(&self) -> usize {
        self.stable.len()
    }

    pub(super) fn n_classes(&self) -> usize {
        self.n_classes
    }

    pub(super) fn class(&self, place: usize) -> usize {
        self.classes[place]
    }

    /// The class to end in, if one is asked for.
    pub(super) fn end(&self) -> Option<usize> {
        self.end
    }

    pub(super) fn everything(&self) -> Set {
        all(self.n())
    }

    /// Whether all of `set` look the same, and as asked.
    pub(super) fn is_goal(&self, set: &[u64]) -> bool {
        let mut classes = members(set).map(|place| self.classes[place]);
        let first = classes.next();
        (self.end.is_none() || first == self.end) && classes.all(|class| Some(class) == first)
    }

    pub(super) fn edge(&self, place: usize) -> usize {
        self.stable[place]
    }

    pub(super) fn edges(&self, set: &[u64]) -> Vec<usize> {
        members(set).map(|place| self.stable[place]).collect()
    }

    /// The stable edges that look like one of `set`.
    pub(super) fn class_edges(&self, set: &[u64]) -> Vec<usize> {
        let classes = self.classes_in(set);
        let is_like = |place: &usize| classes.contains(&self.classes[*place]);
        (0..self.n()).filter(is_like).map(|place| self.stable[place]).collect()
    }

    pub(super) fn classes_in(&self, set: &[u64]) -> BTreeSet<usize> {
        members(set).map(|place| self.classes[place]).collect()
    }

    /// The different outcomes, each once, in ascending order of heights.
    pub(super) fn maps(&self) -> Vec<&[Option<usize>]> {
        let mut known = BTreeSet::new();
        self.rows.iter().map(|row| self.row_outcome(row)).filter(|outcome| known.insert(*outcome)).collect()
    }

    /// What there is to search through; the sets that can be reached are not counted yet.
    pub(super) fn counts(&self) -> PinSearch {
        let is_idle = |outcome: &&[Option<usize>]| outcome.iter().enumerate().all(|(place, to)| *to == Some(place));
        let distinct: BTreeSet<&[Option<usize>]> = self.bands.iter().map(|band| band.outcome.as_slice()).collect();
        let busy = || distinct.iter().filter(|outcome| !is_idle(outcome));
        PinSearch {
            height_classes: self.bands.len(),
            distinct_outcome_maps: busy().count(),
            usable_first_pins: busy().filter(|outcome| !outcome.contains(&None)).count(),
            ..PinSearch::default()
        }
    }

    /// Every pin that jams none of `from`, as runs of rows.
    pub(super) fn runs(&self, from: &[u64]) -> Vec<Run> {
        let mut runs: Vec<Run> = Vec::new();
        for (index, row) in self.rows.iter().enumerate().filter(|(_, row)| are_disjoint(from, &row.jams)) {
            match runs.last_mut() {
                Some(run) if run.last + 1 == index && is_subset(from, &row.same) => run.last = index,
                _ => runs.push(Run { first: index, last: index }),
            }
        }
        runs
    }

    /// The sets that one pin makes of `from`, except those that hold all of it.
    pub(super) fn moves(&self, from: &[u64]) -> Vec<Move> {
        let mut places: HashMap<Set, usize> = HashMap::new();
        let mut moves: Vec<Move> = Vec::new();
        for run in self.runs(from) {
            let after = self.after(from, run);
            if is_subset(from, &after) {
                continue;
            }
            let tolerance = self.tolerance(run);
            match places.get(&after) {
                Some(place) if moves[*place].tolerance < tolerance => {
                    moves[*place] = Move { after, run, tolerance };
                }
                Some(_) => {}
                None => {
                    places.insert(after.clone(), moves.len());
                    moves.push(Move { after, run, tolerance });
                }
            }
        }
        moves
    }

    /// Where the orientations of `from` go.
    fn after(&self, from: &[u64], run: Run) -> Set {
        set_of(self.n(), members(from).map(|place| self.goes_to(place, run)))
    }

    /// Where a pin of this run, which does not jam it, sends an orientation.
    pub(super) fn goes_to(&self, place: usize, run: Run) -> usize {
        self.run_outcome(run)[place].expect("the pin jams none of the set")
    }

    /// The members of `from` that some pin usable on all of it moves.
    pub(super) fn moved(&self, from: &[u64]) -> Set {
        let usable = self.rows.iter().filter(|row| are_disjoint(from, &row.jams));
        intersect(&usable.fold(set_of(self.n(), []), |moved, row| union(&moved, &row.moves)), from)
    }

    /// Half the width.
    pub(super) fn tolerance(&self, run: Run) -> Q {
        let [low, high] = self.ends(run);
        (high - low) * ratio(1, 2)
    }

    /// The ends, rounded inward.
    pub(super) fn ends(&self, run: Run) -> [&Q; 2] {
        [&self.rows[run.first].ends[0], &self.rows[run.last].ends[1]]
    }

    /// The ends exactly.
    pub(super) fn critical(&self, run: Run) -> [&Algebraic; 2] {
        [&self.bands[self.rows[run.first].band].low, &self.bands[self.rows[run.last].band].high]
    }

    /// Where the edges of `set` go.
    pub(super) fn outcome(&self, set: &[u64], run: Run) -> BTreeMap<usize, usize> {
        members(set).map(|place| (self.stable[place], self.stable[self.goes_to(place, run)])).collect()
    }

    /// What the pins of a run do, where they all do the same.
    pub(super) fn run_outcome(&self, run: Run) -> &[Option<usize>] {
        self.row_outcome(&self.rows[run.first])
    }

    fn row_outcome(&self, row: &Row) -> &[Option<usize>] {
        &self.bands[row.band].outcome
    }
}

/// The set of these members of a universe.
pub(super) fn set_of(universe: usize, members: impl IntoIterator<Item = usize>) -> Set {
    let mut set: Set = all(universe);
    set.iter_mut().for_each(|word| *word = 0);
    for member in members {
        set[member / 64] |= 1 << (member % 64);
    }
    set
}

fn are_disjoint(a: &[u64], b: &[u64]) -> bool {
    a.iter().zip(b).all(|(x, y)| x & y == 0)
}
