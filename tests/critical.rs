//! Critical friction against closed forms, and against the planner at factors just below and just above.

mod support;

use num_traits::{One, Zero};
use partplan::answer::{CriticalFactor, CriticalFriction, End, FrictionLimit, Insertion, NearestChange, Region};
use partplan::exact::{Algebraic, Polynomial, Q, ratio};
use partplan::model::{Fixel, Fixture, Friction, Part, Place, Range, Shape};
use partplan::planner::{Question, insertion};
use proptest::prelude::*;
use support::cases::{self, NAMES, seated};
use support::modes::Contacts;
use support::random::{Setup, any_friction, any_setup, discs, polygons, runs, seatable, single_friction};

fn planned((part, fixture): &Setup) -> Insertion {
    insertion(part, fixture, &Question { critical: true, ..Question::default() }).expect("no modes are asked for")
}

fn critical(setup: &Setup) -> CriticalFriction {
    planned(setup).critical_friction.expect("it was asked for")
}

fn finite(limit: &FrictionLimit) -> &CriticalFactor {
    if let FrictionLimit::Finite(end) = limit { end } else { panic!("{limit:?} is not finite") }
}

fn times(friction: &Friction, factor: &Q) -> Friction {
    let times = |range: &Range| Range { min: &range.min * factor, max: &range.max * factor };
    Friction { static_: times(&friction.static_), kinetic: times(&friction.kinetic) }
}

/// The setup with the coefficients of the `chosen` fixels times `factor`.
fn scaled((part, fixture): &Setup, factor: &Q, chosen: impl Fn(usize) -> bool) -> Setup {
    let scale = |(index, fixel): (usize, &Fixel)| {
        let friction = if chosen(index) { times(&fixel.friction, factor) } else { fixel.friction.clone() };
        Fixel { friction, ..fixel.clone() }
    };
    (part.clone(), Fixture { fixels: fixture.fixels.iter().enumerate().map(scale).collect() })
}

fn at(setup: &Setup, factor: &Q) -> Insertion {
    let (part, fixture) = scaled(setup, factor, |_| true);
    insertion(&part, &fixture, &Question::default()).expect("no modes are asked for")
}

/// Factors below and above `end`, a billionth of it away or nearer.
fn around(end: &CriticalFactor) -> [Q; 2] {
    let width = ratio(1, 1_000_000_000);
    match end.factor.rational() {
        Some(factor) => [&factor * (Q::one() - &width), &factor * (Q::one() + &width)],
        None => end.factor.enclosure(&width),
    }
}

/// That `holds` says true below the limit and false above, and at a rational limit what the answer says.
fn check_limit(limit: &FrictionLimit, holds: impl Fn(&Q) -> bool) {
    match limit {
        FrictionLimit::Always => assert!(!holds(&Q::zero()) && !holds(&ratio(1, 1_000)), "there is something to lose"),
        FrictionLimit::Never => assert!(holds(&Q::zero()) && holds(&ratio(1_000_000, 1)), "it is lost"),
        FrictionLimit::Finite(end) => {
            let [below, above] = around(end);
            assert!(holds(&below) && !holds(&above), "the limit is not {:?}", end.factor);
            match end.factor.rational() {
                Some(factor) => assert_eq!(Some(holds(&factor)), end.is_attained, "at {factor}"),
                None => assert_eq!(end.factor.sign_of(&end.factor.polynomial()), std::cmp::Ordering::Equal),
            }
        }
    }
}

fn check(setup: &Setup) {
    let answer = planned(setup);
    let critical = answer.critical_friction.as_ref().expect("it was asked for");
    check_limit(&critical.goal, |factor| !at(setup, factor).goal.is_empty());
    check_limit(&critical.acyclic, |factor| !at(setup, factor).acyclic.is_empty());
    check_end(setup, &critical.goal, |answer| answer.goal);
    check_end(setup, &critical.acyclic, |answer| answer.acyclic);
    assert_eq!(critical.plan.is_some(), answer.plan.is_some());
    if let (Some(limit), Some(plan)) = (&critical.plan, &answer.plan) {
        check_limit(limit, |factor| {
            let (part, fixture) = scaled(setup, factor, |_| true);
            Contacts::of(&part, &fixture).acyclic(&plan.wrench)
        });
    }
    assert_eq!(answer.nearest_change.is_some(), answer.acyclic.is_empty());
    if let Some(change) = &answer.nearest_change {
        check_change(setup, change);
    }
}

/// At a rational end the set has an interior iff it jumps; next to any other its volume has gone or not.
fn check_end(setup: &Setup, limit: &FrictionLimit, region: impl Fn(Insertion) -> Region) {
    let FrictionLimit::Finite(end) = limit else { return };
    let jumps = match end.factor.rational() {
        Some(factor) => region(at(setup, &factor)).has_interior(),
        None => {
            let [near, _] = around(end);
            let far = &near * ratio(9, 10);
            let [near, far] = [near, far].map(|factor| region(at(setup, &factor)).volume_in_box);
            near * ratio(10_000, 1) > far
        }
    };
    assert_eq!(end.end, Some(if jumps { End::Jumps } else { End::Shrinks }));
}

fn check_change(setup: &Setup, change: &NearestChange) {
    let opens = |(part, fixture): &Setup| {
        !insertion(part, fixture, &Question::default()).expect("no modes are asked for").acyclic.is_empty()
    };
    for (fixel, end) in &change.single {
        let [below, above] = around(end);
        assert!(opens(&scaled(setup, &below, |index| index == *fixel)), "fixel {fixel} at {below}");
        assert!(!opens(&scaled(setup, &above, |index| index == *fixel)), "fixel {fixel} at {above}");
    }
    for fixel in 0..setup.1.fixels.len() {
        let rest = |factor: &Q| scaled(setup, factor, |index| index == fixel);
        if change.all.is_some() && !change.single.iter().any(|(single, _)| *single == fixel) {
            assert!(!opens(&rest(&Q::zero())), "fixel {fixel} alone would do");
        }
        let (part, mut fixture) = setup.clone();
        fixture.fixels.remove(fixel);
        if change.all.is_none() && !fixture.fixels.is_empty() {
            assert_eq!(opens(&(part, fixture)), change.without.contains(&fixel), "without fixel {fixel}");
        }
    }
}

/// The public pawl with friction 0.2 jumps to empty above exactly 25/33.
#[test]
fn the_public_pawl_jams_above_25_33() {
    let critical = critical(&seated("n3_pawl_02"));
    for limit in [&critical.goal, &critical.acyclic] {
        let end = finite(limit);
        assert_eq!(end.factor.rational(), Some(ratio(25, 33) / ratio(1, 5)));
        assert_eq!((end.is_attained, end.end, end.jam), (Some(true), Some(End::Jumps), Some([1, 2])));
    }
    assert!(finite(critical.plan.as_ref().expect("the pawl has a plan")).factor < ratio(125, 33));
}

#[test]
fn public_cases_lose_their_sets_where_the_answer_says() {
    for name in NAMES.iter().filter(|name| **name != "n3_huge_rationals").chain([&cases::FOUR]) {
        check(&seated(name));
    }
}

/// Two fixels apart by `h` along a peg of width `w` jam it above friction `h / w`, whatever holds its end.
#[test]
fn a_peg_between_walls_jams_where_the_diagonal_leaves_the_friction_cones() {
    let (part, mut fixture) = seated("n3_peg_jam");
    for (rise, friction) in [(ratio(1, 4), ratio(3, 10)), (ratio(1, 3), ratio(1, 9))] {
        fixture.fixels[0].point[1] = rise.clone();
        fixture.fixels[1].point[1] = -&rise;
        for fixel in &mut fixture.fixels {
            fixel.friction.static_ = Range::exactly(friction.clone());
            fixel.friction.kinetic = Range::exactly(friction.clone());
        }
        let critical = critical(&(part.clone(), fixture.clone()));
        let end = finite(&critical.acyclic);
        assert_eq!(end.factor, &rise * ratio(2, 1) / ratio(2, 1) / &friction);
        assert_eq!((end.is_attained, end.jam), (Some(true), Some([0, 1])));
        assert!(finite(&critical.goal).factor <= end.factor);
    }
}

/// A disc against two fixels is seated by some push as long as the friction angles add up to less than the angle between
/// the normals: only then is a direction left that slides along either fixel towards the other.
#[test]
fn a_disc_is_seated_while_friction_angles_add_up_to_less_than_the_angle_between_normals() {
    let friction = |value: Q| Friction { static_: Range::exactly(value.clone()), kinetic: Range::exactly(value) };
    let (part, mut fixture) = seated("n2_disc_paper");
    // a right angle: k² μ1 μ2 = 1
    fixture.fixels[0].friction = friction(ratio(1, 5));
    fixture.fixels[1].friction = friction(ratio(1, 10));
    let found = critical(&(part.clone(), fixture.clone()));
    let root = Polynomial::from([-50, 0, 1]).real_roots(ratio(0, 1)..).expect("not zero").remove(0);
    for limit in [&found.goal, &found.acyclic] {
        assert_eq!(finite(limit).factor, root);
        assert_eq!(finite(limit).end, Some(End::Shrinks));
    }
    // normals (0, 1) and (-p, q) / sqrt(p² + q²) from the right: tan(a + b) = p / q
    for (p, q) in [(3, 4), (12, 5), (24, 7)] {
        let [x, y] = [ratio(p, 1), ratio(-q, 1)];
        let length = [5, 13, 25].into_iter().find(|z| z * z == p * p + q * q).expect("a Pythagorean triple");
        let point = [&x / ratio(length, 1), &y / ratio(length, 1)];
        let normal = [-&point[0], -&point[1]];
        fixture.fixels[1] = Fixel { place: Place::Arc, point, normal, friction: friction(ratio(1, 10)) };
        // k (μ1 + μ2) q = p (1 - k² μ1 μ2), times 50
        let expected = Polynomial::from([-50 * p, 15 * q, p]).real_roots(ratio(0, 1)..).expect("not zero").remove(0);
        let found = critical(&(part.clone(), fixture.clone()));
        assert_eq!(finite(&found.goal).factor, expected, "{p}/{q}");
        assert_eq!(finite(&found.acyclic).factor, expected, "{p}/{q}");
    }
}

#[test]
fn without_friction_nothing_is_lost() {
    let setup = scaled(&seated("n3_pawl_02"), &Q::zero(), |_| true);
    let critical = critical(&setup);
    assert_eq!(critical.acyclic, FrictionLimit::Never);
    assert_eq!(critical.plan, Some(FrictionLimit::Never));
}

#[test]
fn a_single_fixel_is_reached_whatever_the_friction() {
    for name in ["n1_edge", "n1_vertex"] {
        let critical = critical(&seated(name));
        let never = FrictionLimit::Never;
        assert_eq!((&critical.goal, &critical.acyclic, &critical.plan), (&never, &never, &Some(never.clone())));
    }
}

#[test]
fn dependent_normals_are_past_help_by_friction() {
    let answer = planned(&seated("n3_concurrent"));
    let critical = answer.critical_friction.expect("it was asked for");
    assert_eq!((critical.goal, critical.acyclic), (FrictionLimit::Always, FrictionLimit::Always));
    let change = answer.nearest_change.expect("the set is empty");
    assert_eq!((change.all, change.single.len(), change.without), (None, 0, vec![0, 1, 2]));
}

#[test]
fn it_is_answered_only_when_asked() {
    let (part, fixture) = seated("n3_peg_jam");
    let answer = insertion(&part, &fixture, &Question::default()).expect("no modes are asked for");
    assert_eq!((answer.critical_friction, answer.nearest_change), (None, None));
}

/// Three on a disc: every normal passes through the center.
fn is_hopeless((part, fixture): &(Part, Fixture)) -> bool {
    matches!(part.shape, Shape::Circle { .. }) && fixture.fixels.len() > 2
}

proptest! {
    #![proptest_config(runs(20))]

    #[test]
    fn sets_end_where_the_planner_finds_them_empty(setup in prop_oneof![
        2 => seatable(),
        1 => discs(2..=3, single_friction()),
        1 => polygons(2..=3, single_friction()),
    ]) {
        check(&setup);
        if is_hopeless(&setup) {
            prop_assert_eq!(critical(&setup).acyclic, FrictionLimit::Always);
        }
    }

    /// Every transition that the smaller set forbids is one that the larger set may forbid.
    #[test]
    fn the_goal_ends_first_and_the_plan_before_its_set(setup in any_setup(1..=3)) {
        let critical = critical(&setup);
        prop_assert!(order(&critical.goal) <= order(&critical.acyclic));
        if let Some(plan) = &critical.plan {
            prop_assert!(order(plan) <= order(&critical.acyclic));
            prop_assert!(order(plan) >= (1, Some(Algebraic::from(Q::one()))));
        }
    }

    /// Twice the coefficients bear half the factor.
    #[test]
    fn coefficients_times_a_number_divide_the_factor_by_it(
        setup in prop_oneof![seatable(), polygons(2..=3, any_friction())],
        (p, q) in (1..6_i64, 1..6_i64),
    ) {
        let number = ratio(p, q);
        let (once, more) = (critical(&setup), critical(&scaled(&setup, &number, |_| true)));
        for (a, b) in [(&once.goal, &more.goal), (&once.acyclic, &more.acyclic)] {
            match (a, b) {
                (FrictionLimit::Finite(a), FrictionLimit::Finite(b)) => {
                    prop_assert_eq!((a.end, a.jam), (b.end, b.jam));
                    prop_assert_eq!(a.factor.rational(), b.factor.rational().map(|factor| factor * &number));
                    let ([a_low, a_high], [b_low, b_high]) = (around(a), around(b));
                    prop_assert!(a_low <= b_high * &number && b_low * &number <= a_high);
                }
                _ => prop_assert_eq!(a, b),
            }
        }
    }
}

/// Limits from the first lost to those never lost.
fn order(limit: &FrictionLimit) -> (usize, Option<Algebraic>) {
    match limit {
        FrictionLimit::Always => (0, None),
        FrictionLimit::Finite(end) => (1, Some(end.factor.clone())),
        FrictionLimit::Never => (2, None),
    }
}
