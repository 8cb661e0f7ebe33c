//! What must hold for every part: random ones, convex and not, with and without friction.

use crate::agree::agrees;
use crate::search::{Search, replay};
use crate::support::drawn::{Drawn, drawn, runs};
use crate::support::int;
use partplan::answer::{ActionInterval, Orientation, PinAction, Pins};
use partplan::exact::{Algebraic, Q, ratio, to_f64};
use proptest::prelude::*;
use proptest::sample::Index;
use std::collections::BTreeSet;

proptest! {
    #![proptest_config(runs(60))]

    /// Inside of every interval the part does what balance of forces says, also just inside of the ends: what is just
    /// beyond an end is just inside of the next interval.
    #[test]
    fn balance_of_forces_agrees(drawn in drawn(), shares in prop::collection::vec(0.001_f64..0.999, 3)) {
        let answer = drawn.planned();
        let tally = agrees(&answer, &drawn.oracle(), &shares).map_err(TestCaseError::fail)?;
        prop_assert!(tally.judged > 0 && tally.unsure * 20 <= tally.judged, "{tally:?}");
    }
}

proptest! {
    #![proptest_config(runs(25))]

    /// The fewest pins, and what stands in their way, are those of a search that trusts balance of forces alone; the
    /// pins, replayed orientation by orientation, leave one class.
    #[test]
    fn searching_with_balance_of_forces_agrees(drawn in drawn()) {
        let (answer, oracle) = (drawn.planned(), drawn.oracle());
        let Some(search) = Search::new(&answer, &oracle) else { return Err(TestCaseError::reject("bands too thin")) };
        let sequence = answer.plan.sequence.as_ref();
        prop_assert_eq!(sequence.map(Vec::len), search.fewest_pins());
        if let Some(sequence) = sequence {
            if let Some(end) = replay(&oracle, sequence.iter().map(|pin| to_f64(&pin.height))) {
                let end = end.map_err(TestCaseError::fail)?;
                prop_assert!(end.iter().all(|edge| answer.plan.end.contains(edge)), "{end:?}");
                prop_assert!(answer.symmetry.classes.contains(&answer.plan.end));
            }
            prop_assert!(answer.plan.obstacle.is_none());
        } else if answer.symmetry.shift == answer.hull.len() {
            let obstacle = answer.plan.obstacle.as_ref().expect("a reason");
            let sets: BTreeSet<Vec<usize>> = obstacle.smallest_sets.iter().cloned().collect();
            prop_assert_eq!(sets, search.smallest_sets());
            let pairs: BTreeSet<[usize; 2]> = obstacle.inseparable_pairs.iter().copied().collect();
            prop_assert_eq!(pairs, search.inseparable_pairs());
            prop_assert_eq!(&obstacle.never_moved, &search.never_moved());
        }
    }

    /// A pin's height, its tolerance and its ends say the same as the intervals.
    #[test]
    fn pins_stand_inside_of_their_ends(drawn in drawn()) {
        let answer = drawn.planned();
        let mut before: BTreeSet<usize> = answer.stable.iter().copied().collect();
        for pin in answer.plan.sequence.iter().flatten() {
            prop_assert!(pin.tolerance > int(0));
            prop_assert!(pin.low <= &pin.height - &pin.tolerance && pin.high >= &pin.height + &pin.tolerance);
            prop_assert_eq!(pin.outcome.keys().copied().collect::<BTreeSet<_>>(), before);
            before = pin.outcome.values().copied().collect();
            prop_assert_eq!(pin.after.iter().copied().collect::<BTreeSet<_>>(), before.clone());
        }
    }

    #[test]
    fn moving_scaling_and_renumbering_change_nothing_else(
        drawn in drawn(),
        offset in [-9..=9_i64, -9..=9_i64],
        scale in (1..=9_i64, 1..=9_i64),
        first in any::<Index>(),
    ) {
        let answer = drawn.planned();
        let (offset, scale) = (offset.map(|x| ratio(x, 7)), ratio(scale.0, scale.1));
        let count = answer.hull.len();
        let place = |point: &[Q; 2]| [0, 1].map(|i| &(&point[i] * &scale) + &offset[i]);
        let mut moved = changed(&drawn, place);
        let first = first.index(moved.outline.len());
        moved.outline.rotate_left(first);
        let other = moved.planned();
        let shift = other.hull.iter().position(|corner| *corner == place(&answer.hull[0])).expect("the same corner");
        same(&answer, &other, &|edge| (edge + shift) % count, &scale)?;
    }

    /// By the triangles 3-4-5 and 5-12-13, and quarters.
    #[test]
    fn turning_changes_nothing_else(drawn in drawn(), turn in 0..4_usize) {
        let (cos, sin) = [(ratio(3, 5), ratio(4, 5)), (ratio(-5, 13), ratio(12, 13)), (int(0), int(1)), (int(-1), int(0))][turn].clone();
        let turned = changed(&drawn, |[x, y]| [x * &cos - y * &sin, x * &sin + y * &cos]);
        same(&drawn.planned(), &turned.planned(), &|edge| edge, &int(1))?;
    }

    /// A mirror reverses the way in which parts topple: the part's heights stay, and from where a part topples to where
    /// its mirror image does the two tip over the same corners in reverse. What pins do has nothing to do with it.
    #[test]
    fn a_mirror_reverses_the_way_round(drawn in drawn()) {
        let mut mirrored = changed(&drawn, |[x, y]| [-x, y.clone()]);
        mirrored.outline.reverse();
        let (answer, other) = (drawn.planned(), mirrored.planned());
        let count = answer.hull.len();
        let image = |corner: usize| {
            let [x, y] = &answer.hull[corner % count];
            other.hull.iter().position(|v| *v == [-x, y.clone()]).expect("the same corner")
        };
        // an edge ends where its image starts
        let edge_image = |edge: usize| image(edge + 1);
        prop_assert_eq!(answer.stable.iter().map(|e| edge_image(*e)).collect::<BTreeSet<_>>(), other.stable.iter().copied().collect());
        prop_assert_eq!(answer.symmetry.shift, other.symmetry.shift);
        let of = |edge: usize| other.orientations.iter().find(|o| o.edge == edge).expect("an orientation");
        for there in &answer.orientations {
            let back = of(edge_image(there.next));
            prop_assert_eq!(back.next, edge_image(there.edge));
            prop_assert_eq!(back.pivots.iter().rev().copied().collect::<Vec<_>>(), there.pivots.iter().map(|p| image(*p)).collect::<Vec<_>>());
            prop_assert!((there.theta_1_deg - back.theta_1_deg).abs() < 1e-9);
            prop_assert!((there.theta_t_deg + back.theta_t_deg - there.theta_1_deg).abs() < 1e-9);
            prop_assert_eq!(&there.height, &of(edge_image(there.edge)).height);
        }
    }
}

fn changed(drawn: &Drawn, place: impl Fn(&[Q; 2]) -> [Q; 2]) -> Drawn {
    let outline = drawn.outline.iter().map(&place).collect();
    Drawn { outline, center: place(&drawn.center), ..drawn.clone() }
}

/// Whether `other` says what `answer` says, its edges renamed and its heights `scale` times as great.
fn same(answer: &Pins, other: &Pins, rename: &dyn Fn(usize) -> usize, scale: &Q) -> Result<(), TestCaseError> {
    let sorted = |edges: &[usize]| edges.iter().map(|edge| rename(*edge)).collect::<BTreeSet<usize>>();
    prop_assert_eq!(sorted(&answer.stable), other.stable.iter().copied().collect());
    prop_assert_eq!(answer.symmetry.shift, other.symmetry.shift);
    let classes = |pins: &Pins, rename: &dyn Fn(usize) -> usize| {
        let class = |class: &Vec<usize>| class.iter().map(|edge| rename(*edge)).collect::<BTreeSet<usize>>();
        pins.symmetry.classes.iter().map(class).collect::<BTreeSet<_>>()
    };
    prop_assert_eq!(classes(answer, rename), classes(other, &|edge| edge));
    for ours in &answer.orientations {
        let theirs = other.orientations.iter().find(|o| o.edge == rename(ours.edge)).expect("an orientation");
        same_orientation(ours, theirs, rename, scale)?;
    }
    let pins = |pins: &Pins| pins.plan.sequence.as_ref().map(Vec::len);
    prop_assert_eq!(pins(answer), pins(other));
    let sets = |pins: &Pins, rename: &dyn Fn(usize) -> usize| {
        let sets = pins.plan.obstacle.iter().flat_map(|obstacle| obstacle.smallest_sets.iter());
        sets.map(|set| set.iter().map(|edge| rename(*edge)).collect()).collect::<BTreeSet<BTreeSet<usize>>>()
    };
    if answer.symmetry.shift == answer.hull.len() {
        prop_assert_eq!(sets(answer, rename), sets(other, &|edge| edge));
    }
    Ok(())
}

fn same_orientation(
    ours: &Orientation,
    theirs: &Orientation,
    rename: &dyn Fn(usize) -> usize,
    scale: &Q,
) -> Result<(), TestCaseError> {
    prop_assert_eq!(rename(ours.next), theirs.next);
    prop_assert_eq!(ours.pivots.iter().map(|p| rename(*p)).collect::<Vec<_>>(), theirs.pivots.clone());
    prop_assert!((ours.theta_t_deg - theirs.theta_t_deg).abs() < 1e-9);
    prop_assert!((ours.theta_1_deg - theirs.theta_1_deg).abs() < 1e-9);
    prop_assert!(scaled(&ours.height, &theirs.height, scale));
    prop_assert_eq!(ours.intervals.len(), theirs.intervals.len());
    for (a, b) in ours.intervals.iter().zip(&theirs.intervals) {
        prop_assert_eq!(a.action, b.action);
        prop_assert!(scaled(&a.from, &b.from, scale), "{} {}", a.from.to_f64(), b.from.to_f64());
    }
    prop_assert_eq!(ours.topple.len(), theirs.topple.len());
    for (a, b) in ours.topple.iter().zip(&theirs.topple) {
        prop_assert_eq!(rename(a.edge), b.edge);
        prop_assert!(scaled(&a.from, &b.from, scale) && scaled(&a.to, &b.to, scale));
    }
    Ok(())
}

/// Exactly the same if the scale is one, else to 1e-15.
fn scaled(ours: &Algebraic, theirs: &Algebraic, scale: &Q) -> bool {
    if *scale == int(1) {
        return ours == theirs;
    }
    let width = ratio(1, 1_000_000_000_000_000);
    let ([low, high], [at_least, at_most]) = (ours.enclosure(&width), theirs.enclosure(&width));
    low * scale <= at_most && high * scale >= at_least
}

/// Intervals of two orientations that look the same.
#[must_use]
pub fn alike(a: &[ActionInterval], b: &[ActionInterval]) -> bool {
    let key = |i: &ActionInterval| (i.from.clone(), i.action);
    let same = |(a, b): (&ActionInterval, &ActionInterval)| key(a) == key(b);
    a.len() == b.len() && a.iter().zip(b).all(same)
}

/// The kinds of actions on some heights.
#[must_use]
pub fn kinds(orientation: &Orientation) -> Vec<PinAction> {
    orientation.intervals.iter().map(|i| i.action.expect("nothing is uncertain")).collect()
}
