//! How far what a case states may be off before a sequence of pins fails.

use super::conveyed::Conveyed;
use super::outcome::followed;
use crate::answer::{Margins, Pin, PinAction};
use crate::exact::{Q, ratio};
use crate::geometry::Polygon;
use crate::mechanics::toppling::Height;
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
        let Ok(conveyed) = Conveyed::of(part, conveyor) else { return false };
        if conveyed.stable != self.stable || !conveyed.holds_its_center() {
            return false;
        }
        let edges = conveyed.edges();
        let place = |edge: usize| self.stable.iter().position(|stable| *stable == edge);
        self.sequence.iter().all(|pin| {
            let height = Height::rational(&pin.height);
            let actions: Vec<Option<PinAction>> = edges.iter().map(|edge| edge.around(&height)).collect();
            let ends_at = |edge: usize| followed(&edges, &actions, place(edge)?).map(|place| self.stable[place]);
            pin.outcome.iter().all(|(edge, end)| ends_at(*edge) == Some(*end))
        })
    }
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
