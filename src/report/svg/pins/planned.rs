//! The heights of the planned pins, and which orientations meet a pin there.

use super::super::canvas::{GREEN, Pen};
use crate::answer::{Orientation, Pin, PinAction, Pins};
use crate::exact::Q;
use std::collections::BTreeSet;

/// How a planned height is drawn.
pub(super) fn pen() -> Pen {
    Pen { dash: "12 3", ..Pen::stroke(GREEN, 2.0) }
}

/// A height of planned pins.
pub(super) struct Planned<'a> {
    pub(super) height: &'a Q,
    pub(super) tolerance: &'a Q,
    /// The pins that have it, counted from one.
    pub(super) pins: Vec<String>,
    /// The edges on which the part may rest when it meets one of them.
    pub(super) met: BTreeSet<usize>,
}

/// The heights of the planned pins from the belt up.
pub(super) fn planned(answer: &Pins) -> Vec<Planned<'_>> {
    let mut planned: Vec<Planned> = Vec::new();
    let mut before = &answer.stable;
    for (index, pin) in answer.plan.sequence.iter().flatten().enumerate() {
        let at = planned.iter().position(|planned| planned.height == &pin.height).unwrap_or_else(|| {
            let (pins, met) = (Vec::new(), BTreeSet::new());
            planned.push(Planned { height: &pin.height, tolerance: &pin.tolerance, pins, met });
            planned.len() - 1
        });
        planned[at].pins.push((index + 1).to_string());
        planned[at].met.extend(met(answer, pin, before));
        before = &pin.after;
    }
    planned.sort_by_key(|planned| planned.height);
    planned
}

/// Where the part rests before the pin, and onto what it topples in front of it.
fn met(answer: &Pins, pin: &Pin, before: &[usize]) -> BTreeSet<usize> {
    let mut met = BTreeSet::new();
    let mut open = before.to_vec();
    while let Some(edge) = open.pop() {
        let orientation = answer.orientations.iter().find(|orientation| orientation.edge == edge);
        if met.insert(edge)
            && let Some(Orientation { next, .. }) =
                orientation.filter(|orientation| orientation.action_at(&pin.height).0 == Some(PinAction::Repeat))
        {
            open.push(*next);
        }
    }
    met
}
