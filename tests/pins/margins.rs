//! How far friction and center of mass may be off: what is said works, exactly, and a little more does not.

use crate::agree::end;
use crate::support::conveyed::{Public, public};
use partplan::answer::{Margins, Pin, Pins};
use partplan::exact::{Q, ratio};
use partplan::model::Range;
use partplan::planner::{PinQuestion, pins};

fn planned(case: &Public, margins: bool) -> Pins {
    pins(&case.part, &case.conveyor, &PinQuestion { margins, ..PinQuestion::default() }).expect("the part rests")
}

/// Whether the pins planned for one case do the same in another.
fn works(plan: &Pins, other: &Pins) -> bool {
    let does_the_same = |pin: &Pin| pin.outcome.iter().all(|(from, to)| end(other, *from, &pin.height) == Some(*to));
    plan.plan.sequence.iter().flatten().all(does_the_same)
}

/// Rough pins jam what smooth ones turn, and so does a slippery belt.
#[test]
fn other_friction_is_proposed_where_it_helps_and_works() {
    let zero = ratio(0, 1);
    for (belt, pin, other) in [(20, ratio(2, 5), ratio(20, 1)), (0, zero.clone(), ratio(3, 1))] {
        let belt = if belt == 0 { ratio(3, 10) } else { ratio(belt, 1) };
        let plan = planned(&shifted(&belt, &pin, [&zero; 2]), false).plan;
        assert!(plan.sequence.is_none());
        let proposed = plan.obstacle.and_then(|obstacle| obstacle.friction).expect("other friction helps");
        assert_eq!((&proposed.belt_friction.min, &proposed.pin_friction.max), (&other, &zero));
        let helped = planned(&shifted(&other, &zero, [&zero; 2]), false).plan;
        assert_eq!(helped.sequence.map(|sequence| sequence.len()), Some(proposed.pins));
    }
    let plan = planned(&public("kite"), false).plan;
    assert_eq!(plan.obstacle.expect("a kite cannot be turned").friction, None);
}

/// The case with other friction and center of mass.
fn shifted(belt: &Q, pin: &Q, shift: [&Q; 2]) -> Public {
    let mut case = public("three_pins");
    case.conveyor.belt_friction = Range::exactly(belt.clone());
    case.conveyor.pin_friction = Range::exactly(pin.clone());
    case.part.center_of_mass.iter_mut().zip(shift).for_each(|(at, by)| *at += by);
    case
}

#[test]
fn all_that_the_margins_allow_works_and_a_step_more_does_not() {
    let plan = planned(&public("three_pins"), true);
    let Some(Margins { belt_friction, pin_friction, friction_tried, center_of_mass }) = &plan.plan.margins else {
        panic!("margins were asked for")
    };
    let (zero, belt, pin) = (ratio(0, 1), ratio(20, 1), ratio(1, 20));
    assert!(belt_friction.min < belt && belt < belt_friction.max && pin_friction.min < pin && pin < pin_friction.max);
    assert!(center_of_mass > &zero);
    let is_kept = |belt: &Q, pin: &Q, shift: [&Q; 2]| works(&plan, &planned(&shifted(belt, pin, shift), false));
    for share in (0..=4).map(|share| ratio(share, 4)) {
        let within = |range: &Range| &range.min + (&range.max - &range.min) * &share;
        assert!(is_kept(&within(belt_friction), &pin, [&zero, &zero]), "belt {share}");
        assert!(is_kept(&belt, &within(pin_friction), [&zero, &zero]), "pin {share}");
        let off = center_of_mass * (&share * ratio(2, 1) - ratio(1, 1));
        for shift in [[&off, center_of_mass], [center_of_mass, &off], [&off, &-center_of_mass]] {
            assert!(is_kept(&belt, &pin, shift), "center {shift:?}");
        }
    }
    // steps of the search: a 64th and a 16th of the friction, a 4096th of the part
    let step = |given: &Q, parts: i64| given * ratio(1, parts);
    assert!(belt_friction.min < step(&belt, 64) || !is_kept(&(&belt_friction.min - step(&belt, 64)), &pin, [&zero; 2]));
    assert_eq!(belt_friction.max, &belt * friction_tried);
    assert!(!is_kept(&belt, &(&pin_friction.max + step(&pin, 16)), [&zero; 2]));
    let wider = center_of_mass + ratio(6, 4096);
    let corners = [[&wider, &wider], [&wider, &-&wider], [&-&wider, &wider], [&-&wider, &-&wider]];
    assert!(corners.into_iter().any(|shift| !is_kept(&belt, &pin, shift)));
}
