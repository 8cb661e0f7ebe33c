//! How far what a case states may be off before a sequence of pins fails.

use super::graph::{Stretch, actions};
use super::outcome::{Actions, followed};
use super::{corners_of_box, stable_edges};
use crate::answer::{Margins, Pin, PinAction};
use crate::exact::{Q, ratio};
use crate::geometry::Polygon;
use crate::mechanics::toppling::{Height, Signs};
use crate::model::{Conveyor, Part, Range};
use num_traits::Zero as _;

/// Steps of a margin down to no friction.
const DOWN: i64 = 64;
/// Steps of a margin up to [`MOST`] times the friction.
const UP: i64 = 144;
/// Beyond this share of the friction given nothing is tried.
const MOST: i64 = 10;
/// Steps of the margin of the center of mass, up to an eighth of the part.
const AROUND: i64 = 512;

/// A part, a conveyor and a sequence of pins that works for them.
pub(super) struct Planned<'a> {
    pub(super) part: &'a Part,
    pub(super) conveyor: &'a Conveyor,
    pub(super) outline: &'a Polygon,
    pub(super) corners: &'a [[Q; 2]],
    pub(super) stable: &'a [usize],
    pub(super) sequence: &'a [Pin],
}

impl Planned<'_> {
    /// How far each of what the case states may be off by itself, all else as stated; rounded inward.
    pub(super) fn margins(&self) -> Margins {
        let [belt, pin] = [&self.conveyor.belt_friction, &self.conveyor.pin_friction];
        let with_belt = |range: Range| Conveyor { belt_friction: range, ..self.conveyor.clone() };
        let with_pin = |range: Range| Conveyor { pin_friction: range, ..self.conveyor.clone() };
        let center =
            |steps: i64| &self.part.center_of_mass_tolerance + self.outline.extent() * ratio(steps, 8 * AROUND);
        let is_kept = |steps: i64| {
            let part = Part { center_of_mass_tolerance: center(steps), ..self.part.clone() };
            self.works(&part, self.conveyor)
        };
        Margins {
            belt_friction: self.widened(belt, &with_belt),
            pin_friction: self.widened(pin, &with_pin),
            friction_tried: ratio(MOST, 1),
            center_of_mass: center(last_kept(AROUND, &is_kept)),
        }
    }

    fn widened(&self, range: &Range, with: &dyn Fn(Range) -> Conveyor) -> Range {
        let least = |steps: i64| &range.min * ratio(DOWN - steps, DOWN);
        // friction that is zero grows to one
        let unit = if range.max.is_zero() { ratio(1, MOST - 1) } else { range.max.clone() };
        let most = |steps: i64| &range.max + &unit * ratio(steps * (MOST - 1), UP);
        let works = |min: Q, max: Q| self.works(self.part, &with(Range { min, max }));
        let down = last_kept(DOWN, &|steps| works(least(steps), range.max.clone()));
        let up = last_kept(UP, &|steps| works(range.min.clone(), most(steps)));
        Range { min: least(down), max: most(up) }
    }

    /// Whether each pin does to all orientations that may come what is planned.
    fn works(&self, part: &Part, conveyor: &Conveyor) -> bool {
        let choices = corners_of_box(part, conveyor);
        let centers: Vec<[Q; 2]> = choices.iter().map(|choice| choice.center_of_mass.clone()).collect();
        if !self.outline.hull_contains_all(&centers)
            || stable_edges(self.corners, &choices).as_deref() != Ok(self.stable)
        {
            return false;
        }
        let signs = Signs::default();
        let mut edges = Vec::new();
        let mut stretches = Vec::new();
        for edge in self.stable {
            let turns = choices.iter().map(|choice| choice.toppled(self.corners).turn(*edge, false, &signs));
            let turns: Vec<_> = turns.collect();
            let next = self.stable.iter().position(|stable| *stable == turns[0].next).expect("turns end stably");
            edges.push(Actions { next, stretches: Vec::new() });
            stretches.push(turns.iter().map(actions).collect::<Vec<_>>());
        }
        self.sequence.iter().all(|pin| {
            let height = Height::rational(&pin.height);
            let actions: Vec<Option<PinAction>> = stretches.iter().map(|cases| agreed(cases, &height)).collect();
            pin.outcome.iter().all(|(edge, end)| {
                let place = self.stable.iter().position(|stable| stable == edge).expect("pins meet stable edges");
                followed(&edges, &actions, place).map(|place| self.stable[place]) == Some(*end)
            })
        })
    }
}

/// What all cases do at a height that is critical for none of them.
fn agreed(cases: &[Vec<Stretch<PinAction>>], height: &Height) -> Option<PinAction> {
    let mut actions = cases.iter().map(|stretches| {
        let is_inside =
            |stretch: &&Stretch<PinAction>| stretch.from < *height && stretch.to.as_ref().is_none_or(|to| to > height);
        stretches.iter().find(is_inside).map(|stretch| stretch.action)
    });
    let first = actions.next().flatten()?;
    actions.all(|action| action == Some(first)).then_some(first)
}

/// The last of the steps up to `most` at which `is_kept`, which holds at zero and never again once it fails.
fn last_kept(most: i64, is_kept: &dyn Fn(i64) -> bool) -> i64 {
    let (mut kept, mut lost) = (0, most + 1);
    while lost - kept > 1 {
        // the first look is at the end itself, which is often reached
        let middle = if lost > most { most } else { i64::midpoint(kept, lost) };
        if is_kept(middle) { kept = middle } else { lost = middle }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_step_that_is_kept_is_found() {
        for last in 0..=20 {
            assert_eq!(last_kept(20, &|step| step <= last), last);
        }
        assert_eq!(last_kept(20, &|_| true), 20);
    }
}
