//! Where the answer has a closed form: pins without friction over a belt that never slips.
//!
//! Zhang, Goldberg et al., section VII: the pin's force is normal to the edge and must pass above the pivot, so a pin
//! works above the foot of the pivot on the edge that it touches.

use crate::properties::kinds;
use crate::support::drawn::{Drawn, runs};
use crate::support::{cross, dot, int};
use num_traits::Signed;
use partplan::answer::{Orientation, PinAction, Pins};
use partplan::exact::{Algebraic, Polynomial, Q, ratio};
use proptest::prelude::*;
use std::cmp::Ordering;

use PinAction::{FallBack, Jam, Pass, PassUnder, Repeat};

fn planned(outline: &[[i64; 2]], center: [Q; 2], belt: Q, pin: Q) -> Pins {
    let outline = outline.iter().map(|point| point.map(int)).collect();
    Drawn::new(outline, center, belt, pin).planned()
}

fn minus(a: &[Q; 2], b: &[Q; 2]) -> [Q; 2] {
    [&a[0] - &b[0], &a[1] - &b[1]]
}

/// Whether the height is the root of a non-negative square.
fn squares_to(height: &Algebraic, square: &Q) -> bool {
    let polynomial = Polynomial::from_rationals(&[-square, int(0), int(1)]);
    *height > int(0) && height.sign_of(&polynomial) == Ordering::Equal
}

/// What a triangle with acute corners does on edge `down`: squares of critical heights, and the action from each on.
fn expected(corners: &[[Q; 2]], center: &[Q; 2], down: usize) -> Vec<(Q, PinAction)> {
    let corner = |i: usize| &corners[(down + i) % 3];
    let twice_area = cross(&minus(corner(1), corner(0)), &minus(corner(2), corner(0)));
    // altitude onto the edge from each corner to the next
    let altitude2 = [0, 1, 2].map(|edge| {
        let along = minus(corner(edge + 1), corner(edge));
        &twice_area * &twice_area / dot(&along, &along)
    });
    let com = minus(center, corner(0));
    let [right, top] = [1, 2].map(|i| dot(&minus(corner(i), corner(0)), &com));
    // upright on the pivot, the higher of the two other corners; if that is the right one, the edge between them was
    // level before, and that is the least height of the rolling part
    let upright = right.clone().max(top.clone());
    let lost2 = if right >= top { altitude2[1].clone() } else { &upright * &upright / dot(&com, &com) };
    let (foot2, rest2, later2) = (&altitude2[1], &altitude2[0], &altitude2[2]);
    let mut critical: Vec<&Q> = [foot2, &lost2, later2].into_iter().filter(|h| *h < rest2).collect();
    critical.sort();
    critical.dedup();
    let action = |square: &Q| {
        if square < foot2 {
            Jam
        } else if *square >= lost2 {
            FallBack
        } else if square >= later2 {
            Pass
        } else {
            Repeat
        }
    };
    let mut found = vec![(int(0), Jam)];
    for square in critical {
        if found.last().is_some_and(|(_, last)| *last != action(square)) {
            found.push((square.clone(), action(square)));
        }
    }
    found.push((rest2.clone(), PassUnder));
    found
}

fn check(orientation: &Orientation, expected: &[(Q, PinAction)]) -> Result<(), TestCaseError> {
    prop_assert_eq!(kinds(orientation), expected.iter().map(|(_, action)| *action).collect::<Vec<_>>());
    for (interval, (square, _)) in orientation.intervals.iter().zip(expected).skip(1) {
        prop_assert!(squares_to(&interval.from, square), "{} for the root of {square}", interval.from.to_f64());
    }
    Ok(())
}

proptest! {
    #![proptest_config(runs(30))]

    /// The pivot's feet are those of the altitudes: an acute triangle jams up to the altitude of its pivot.
    #[test]
    fn acute_triangles_topple_above_the_altitude_of_their_pivot(
        corners in prop::collection::vec([-20..=20_i64, -20..=20_i64], 3),
        weights in [1..=5_i64, 1..=5_i64, 1..=5_i64],
    ) {
        let mut corners = corners;
        let exact = |corners: &[[i64; 2]]| corners.iter().map(|c| c.map(int)).collect::<Vec<[Q; 2]>>();
        let [a, b, c] = &exact(&corners)[..] else { unreachable!("three corners were drawn") };
        if cross(&minus(b, a), &minus(c, a)).is_negative() {
            corners.swap(1, 2);
        }
        let exact = exact(&corners);
        let acute = (0..3).all(|i| {
            let [at, next, last] = [0, 1, 2].map(|step| &exact[(i + step) % 3]);
            dot(&minus(next, at), &minus(last, at)).is_positive()
        });
        prop_assume!(acute);
        let total: i64 = weights.iter().sum();
        let center: [Q; 2] =
            [0, 1].map(|axis| exact.iter().zip(weights).map(|(v, w)| &v[axis] * ratio(w, total)).sum());
        let answer = planned(&corners, center.clone(), int(1_000_000_000_000), int(0));
        // acute at both ends: the center of mass is over every edge
        prop_assert_eq!(&answer.stable, &[0, 1, 2]);
        for orientation in &answer.orientations {
            check(orientation, &expected(&exact, &center, orientation.edge))?;
        }
    }

    /// The pivot's foot is the lower right corner, which passes every height up to the width: only above it does a pin work,
    /// and then the part lies lower than the pin.
    #[test]
    fn rectangles_pass_above_their_width(width in 1..=30_i64, height in 1..=30_i64) {
        let center = [ratio(width, 2), ratio(height, 2)];
        let outline = [[0, 0], [width, 0], [width, height], [0, height]];
        let answer = planned(&outline, center, int(1_000_000_000_000), int(0));
        for orientation in &answer.orientations {
            let (width, height) = if orientation.edge % 2 == 0 { (width, height) } else { (height, width) };
            let mut expected = vec![(int(0), Jam)];
            if width < height {
                expected.push((int(width * width), Pass));
            }
            expected.push((int(height * height), PassUnder));
            check(orientation, &expected)?;
        }
        let pins = answer.plan.sequence.as_ref().map(Vec::len);
        prop_assert_eq!(pins, Some(usize::from(width != height)), "a square looks the same on all sides");
    }
}
