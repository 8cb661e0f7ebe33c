//! Parts whose friction or center of mass is known within limits: what is said holds for every value.

use crate::agree::end;
use crate::support::drawn::{Drawn, belts, bodies, pin_frictions, runs};
use crate::support::{int, q};
use partplan::answer::{PinAction, Pins};
use partplan::exact::{Q, ratio, to_f64};
use partplan::model::Range;
use partplan::planner::{PinQuestion, PinsError, pins};
use proptest::collection::vec;
use proptest::prelude::*;

/// A box of parts and conveyors around `drawn`, its half-widths shares of the coefficients and of the part.
#[derive(Debug, Clone)]
struct Uncertain {
    drawn: Drawn,
    belt: Q,
    pin: Q,
    center: Q,
}

fn uncertain() -> impl Strategy<Value = Uncertain> {
    let share = || prop_oneof![1 => Just(int(0)), 3 => (1..=20_i64).prop_map(|x| ratio(x, 100))];
    (bodies(), belts(), pin_frictions(), share(), share(), share()).prop_map(|((outline, at), belt, pin, b, p, c)| {
        let (belt_half, pin_half) = (&belt * b, &pin * p);
        let drawn = Drawn::new(outline, at, belt, pin);
        Uncertain { drawn, belt: belt_half, pin: pin_half, center: c / int(4) }
    })
}

impl Uncertain {
    fn planned(&self) -> Result<Pins, PinsError> {
        let mut part = self.drawn.part();
        part.center_of_mass_tolerance.clone_from(&self.center);
        let mut conveyor = self.drawn.conveyor();
        let around = |value: &Q, half: &Q| Range { min: value - half, max: value + half };
        conveyor.belt_friction = around(&self.drawn.belt, &self.belt);
        conveyor.pin_friction = around(&self.drawn.pin, &self.pin);
        pins(&part, &conveyor, &PinQuestion::default())
    }

    /// One choice, at shares from -1 to 1 of the half-widths.
    fn choice(&self, shares: &[i64]) -> Drawn {
        let at = |value: &Q, half: &Q, share: i64| value + half * ratio(share, 12);
        let center = [0, 1].map(|i| at(&self.drawn.center[i], &self.center, shares[i]));
        let belt = at(&self.drawn.belt, &self.belt, shares[2]);
        let pin = at(&self.drawn.pin, &self.pin, shares[3]);
        Drawn::new(self.drawn.outline.clone(), center, belt, pin)
    }
}

proptest! {
    #![proptest_config(runs(10))]

    /// What is said of a height comes true at every point of the box, exactly; jams are certain at its corners only.
    #[test]
    fn a_promise_holds_all_over_the_box(case in uncertain(), shares in vec(vec(-12..=12_i64, 4), 3), at in vec(1..=7_i64, 2)) {
        let Ok(answer) = case.planned() else { return Ok(()) };
        for shares in shares {
            let choice = case.choice(&shares).planned();
            prop_assert_eq!(&answer.stable, &choice.stable);
            for (ours, point) in answer.orientations.iter().zip(&choice.orientations) {
                prop_assert_eq!((ours.next, &ours.pivots), (point.next, &point.pivots));
                for interval in &ours.intervals {
                    let Some(action) = interval.action.filter(|action| *action != PinAction::Jam) else { continue };
                    for eighths in &at {
                        let Some(height) = inside(interval, *eighths) else { continue };
                        prop_assert_eq!(point.action_at(&height).0, Some(action), "edge {} at {}", ours.edge, to_f64(&height));
                    }
                }
            }
        }
    }

    /// Pins planned for the box leave one class at every point of it.
    #[test]
    fn pins_work_all_over_the_box(case in uncertain(), shares in vec(vec(-12..=12_i64, 4), 3)) {
        let Ok(answer) = case.planned() else { return Ok(()) };
        let Some(sequence) = &answer.plan.sequence else { return Ok(()) };
        for shares in shares {
            let choice = case.choice(&shares).planned();
            let mut set = choice.stable.clone();
            for pin in sequence {
                let ends = set.iter().map(|edge| end(&choice, *edge, &pin.height));
                set = ends.collect::<Option<_>>().ok_or_else(|| TestCaseError::fail(format!("a jam at {}", pin.height)))?;
            }
            prop_assert!(set.iter().all(|edge| answer.plan.end.contains(edge)), "{set:?}");
        }
    }

    /// Where nothing is said, some corners of the box differ. (In a range of friction at the pin, mixtures of its ends count
    /// as well.)
    #[test]
    fn silence_has_a_reason(case in uncertain()) {
        let case = Uncertain { pin: int(0), ..case };
        let Ok(answer) = case.planned() else { return Ok(()) };
        let sides = |corner: usize| [0, 1, 2, 3].map(|bit| if corner >> bit & 1 == 0 { -12 } else { 12 });
        // where nothing is uncertain both sides are the same
        let halves = [&case.center, &case.center, &case.belt, &case.pin];
        let is_new = |corner: &usize| (0..4).all(|bit| corner >> bit & 1 == 0 || *halves[bit] > int(0));
        let corners: Vec<Pins> = (0..16).filter(is_new).map(|corner| case.choice(&sides(corner)).planned()).collect();
        for (at, ours) in answer.orientations.iter().enumerate() {
            for interval in ours.intervals.iter().filter(|i| i.action.is_none()) {
                let Some(height) = inside(interval, 4) else { continue };
                let actions: Vec<Option<PinAction>> = corners.iter().map(|c| c.orientations[at].action_at(&height).0).collect();
                prop_assert!(actions.iter().any(|action| *action != actions[0]), "edge {} at {}", ours.edge, to_f64(&height));
            }
        }
    }
}

/// Between the ends of a range of belt friction that both jam, one while the part rolls and one while it settles, the part
/// may come through: jams are not promised, all else is.
#[test]
fn a_jam_at_both_ends_of_a_range_is_none_in_between() {
    let outline = [
        ["-18/5", "-24/5"],
        ["-168/53", "-270/53"],
        ["-48/37", "-140/37"],
        ["5", "0"],
        ["0", "7"],
        ["-432/73", "495/73"],
        ["-360/97", "325/97"],
    ];
    let outline = outline.map(|point| point.map(q)).to_vec();
    let center = ["-2529272821/2360592970", "1884613117/2360592970"].map(q);
    let action = |belt: &str| {
        let drawn = Drawn::new(outline.clone(), center.clone(), q(belt), int(0));
        let answer = drawn.planned();
        let found = answer.orientations.iter().find(|o| o.edge == 3).expect("a stable edge").action_at(&int(3)).0;
        assert_eq!(found, drawn.oracle().action(3, 3.0), "{belt}");
        found
    };
    assert_eq!(["1/5", "23/40", "16/5"].map(action), [PinAction::Jam, PinAction::Repeat, PinAction::Jam].map(Some));
}

/// A height inside of an interval.
fn inside(interval: &partplan::answer::ActionInterval, eighths: i64) -> Option<Q> {
    let width = ratio(1, 1_000_000_000_000);
    let [_, low] = interval.from.enclosure(&width);
    let [high, _] = match &interval.to {
        Some(to) => to.enclosure(&width),
        None => [int(2) * &low, int(2) * &low],
    };
    (low < high).then(|| &low + (&high - &low) * ratio(eighths, 8))
}
