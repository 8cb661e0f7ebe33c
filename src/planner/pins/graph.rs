//! Actions of pins of all heights, from the curves of the toppling graph.

use crate::answer::PinAction;
use crate::mechanics::toppling::{Height, Turn};

/// An action between two heights.
#[derive(Debug, Clone)]
pub(super) struct Stretch<A> {
    pub(super) from: Height,
    /// `None` where there is no end.
    pub(super) to: Option<Height>,
    pub(super) action: A,
}

/// Actions for all heights above zero, in order; neighbors differ. A single height that jams has a stretch of its own.
pub(super) fn actions(turn: &Turn) -> Vec<Stretch<PinAction>> {
    let rolling = merged(turn.rolling_jams.clone());
    let settling = merged(turn.settling_jams.clone());
    let [height, last] = &turn.heights;
    let zero = Height::zero();
    let mut ends: Vec<Height> = rolling.iter().chain(&settling).flatten().cloned().collect();
    ends.extend([zero.clone(), height.clone(), last.clone(), turn.least_rolling.clone()]);
    ends.sort();
    ends.dedup();
    let is_in =
        |jams: &[[Height; 2]], low: &Height, high: &Height| jams.iter().any(|[from, to]| from <= low && high <= to);
    // between two neighbors, or at a single height
    let action = |low: &Height, high: &Height| {
        if low >= height {
            PinAction::PassUnder
        } else if is_in(&rolling, low, high) {
            PinAction::Jam
        } else if low >= &turn.least_rolling {
            PinAction::FallBack
        } else if is_in(&settling, low, high) {
            PinAction::Jam
        } else if low >= last {
            PinAction::Pass
        } else {
            PinAction::Repeat
        }
    };
    let mut stretches: Vec<Stretch<PinAction>> = Vec::new();
    for (index, end) in ends.iter().enumerate() {
        let next = ends.get(index + 1);
        if *end > zero && action(end, end) == PinAction::Jam {
            push(&mut stretches, Stretch { from: end.clone(), to: Some(end.clone()), action: PinAction::Jam });
        }
        let after = next.map_or(PinAction::PassUnder, |next| action(end, next));
        push(&mut stretches, Stretch { from: end.clone(), to: next.cloned(), action: after });
    }
    stretches
}

/// Appends a stretch, or lengthens the last one with the same action.
pub(super) fn push<A: PartialEq>(stretches: &mut Vec<Stretch<A>>, next: Stretch<A>) {
    match stretches.last_mut() {
        Some(last) if last.action == next.action => last.to = next.to,
        _ => stretches.push(next),
    }
}

/// The union of closed intervals, ascending.
fn merged(mut intervals: Vec<[Height; 2]>) -> Vec<[Height; 2]> {
    intervals.sort();
    let mut union: Vec<[Height; 2]> = Vec::new();
    for [low, high] in intervals {
        match union.last_mut() {
            Some([_, last]) if low <= *last => {
                if high > *last {
                    *last = high;
                }
            }
            _ => union.push([low, high]),
        }
    }
    union
}

/// What all cases agree on; `None` where they do not.
pub(super) fn overlay(cases: &[Vec<Stretch<PinAction>>]) -> Vec<Stretch<Option<PinAction>>> {
    let known = |stretch: &Stretch<PinAction>| Stretch {
        from: stretch.from.clone(),
        to: stretch.to.clone(),
        action: Some(stretch.action),
    };
    if let [only] = cases {
        return only.iter().map(known).collect();
    }
    let mut ends: Vec<&Height> = cases.iter().flatten().map(|stretch| &stretch.from).collect();
    ends.sort();
    ends.dedup();
    let mut common: Vec<Stretch<Option<PinAction>>> = Vec::new();
    for (index, from) in ends.iter().enumerate() {
        let to = ends.get(index + 1).copied();
        let jams_alone =
            cases.iter().flatten().any(|stretch| stretch.to.as_ref() == Some(&stretch.from) && stretch.from == **from);
        if jams_alone {
            push(&mut common, Stretch { from: (*from).clone(), to: Some((*from).clone()), action: None });
        }
        let mut actions = cases.iter().map(|case| {
            let covers = |stretch: &&Stretch<PinAction>| {
                stretch.from <= **from && stretch.to.as_ref().is_none_or(|to| to > *from)
            };
            case.iter().find(covers).expect("stretches cover all heights").action
        });
        let first = actions.next();
        let action = first.filter(|first| actions.all(|action| action == *first));
        push(&mut common, Stretch { from: (*from).clone(), to: to.cloned(), action });
    }
    common
}
