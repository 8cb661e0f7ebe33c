//! What a wiper after the pins would have to take off the belt where pins alone do not do.

use super::moves::{Run, Task, set_of};
use super::pin;
use crate::answer::Wiper;
use crate::cone::bits::Set;
use std::collections::{HashMap, HashSet};

/// From here on the wiper that is known is taken as it is.
const MOST_STATES: usize = 10_000;

/// How many of the orientations at first are in each now.
type Counts = Vec<usize>;

/// The counts after some pins.
struct State {
    counts: Counts,
    n_pins: usize,
    last: Option<(usize, Run)>,
}

/// A class to keep, and what that is worth.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
struct Value {
    yielding: usize,
    /// Negative, so that fewer are better.
    discarded: isize,
}

/// The wiper with the largest yield, of these the one that discards the fewest, of these the one after the fewest pins.
///
/// Orientations at first are taken as equally likely. Sets do not tell how many of them have ended where, so counts are
/// searched; there may be far more of them than sets, and after [`MOST_STATES`] a better wiper may exist.
/// `None` if no pins take a part to the edge that is asked for.
pub(super) fn best(task: &Task, most_pins: Option<usize>, is_over: &mut dyn FnMut() -> bool) -> Option<Wiper> {
    let mut states = vec![State { counts: vec![1; task.n()], n_pins: 0, last: None }];
    let mut known = HashSet::from([states[0].counts.clone()]);
    let mut best: Option<(Value, usize, usize)> = None;
    let mut at = 0;
    while at < states.len() && (at == 0 || !is_over()) {
        if let Some((value, class)) = most_in_one_class(task, &states[at].counts)
            && best.as_ref().is_none_or(|(other, _, _)| value > *other)
        {
            best = Some((value, class, at));
        }
        if states.len() < MOST_STATES && most_pins.is_none_or(|most| states[at].n_pins < most) {
            for (counts, run) in steps(task, &states[at].counts) {
                if known.insert(counts.clone()) {
                    states.push(State { counts, n_pins: states[at].n_pins + 1, last: Some((at, run)) });
                }
            }
        }
        at += 1;
    }
    let (value, class, at) = best?;
    Some(wiper(task, &states, at, class, value.yielding))
}

fn wiper(task: &Task, states: &[State], mut at: usize, class: usize, yielding: usize) -> Wiper {
    let set = occupied(&states[at].counts);
    let mut classes = task.classes_in(&set);
    let first_of = |class: usize| {
        let place = (0..task.n()).find(|place| states[at].counts[*place] > 0 && task.class(*place) == class);
        task.edge(place.expect("the class is occupied"))
    };
    classes.remove(&class);
    let mut discarded: Vec<usize> = classes.into_iter().map(first_of).collect();
    discarded.sort_unstable();
    let kept = first_of(class);
    let mut pins = Vec::new();
    while let Some((before, run)) = states[at].last {
        pins.push(pin(task, &occupied(&states[before].counts), run));
        at = before;
    }
    pins.reverse();
    Wiper { pins, discarded, kept, yielding }
}

/// What one pin makes of the counts, by the widest run that makes it.
fn steps(task: &Task, counts: &Counts) -> Vec<(Counts, Run)> {
    let set = occupied(counts);
    let mut places: HashMap<Counts, usize> = HashMap::new();
    let mut steps: Vec<(Counts, Run)> = Vec::new();
    for run in task.runs(&set) {
        let mut after = vec![0; counts.len()];
        for (place, count) in counts.iter().enumerate().filter(|(_, count)| **count > 0) {
            after[task.goes_to(place, run)] += count;
        }
        let place = *places.entry(after.clone()).or_insert(steps.len());
        if place == steps.len() {
            steps.push((after, run));
        } else if task.tolerance(steps[place].1) < task.tolerance(run) {
            steps[place].1 = run;
        }
    }
    steps
}

fn most_in_one_class(task: &Task, counts: &Counts) -> Option<(Value, usize)> {
    let classes = task.classes_in(&occupied(counts));
    let discarded = 1 - isize::try_from(classes.len()).expect("there are few classes");
    let yielding =
        |class: usize| counts.iter().enumerate().filter(|(place, _)| task.class(*place) == class).map(|(_, n)| n).sum();
    let wanted = classes.into_iter().filter(|class| task.end().is_none_or(|end| end == *class));
    // the first of equals
    wanted
        .map(|class| (Value { yielding: yielding(class), discarded }, class))
        .reduce(|a, b| if b.0 > a.0 { b } else { a })
}

fn occupied(counts: &Counts) -> Set {
    set_of(counts.len(), (0..counts.len()).filter(|place| counts[*place] > 0))
}
