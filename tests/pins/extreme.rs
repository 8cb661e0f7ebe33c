//! Parts at the edge of what is allowed: symmetric, neutral, with many corners, with no friction or a practically
//! infinite one.

use crate::agree::agrees;
use crate::properties::{alike, kinds};
use crate::support::drawn::{Drawn, bodies, pin_frictions, runs};
use crate::support::int;
use num_traits::One;
use partplan::answer::PinAction;
use partplan::exact::{Q, ratio};
use proptest::prelude::*;

fn drawn(outline: &[[i64; 2]], center: [Q; 2]) -> Drawn {
    Drawn::new(outline.iter().map(|point| point.map(int)).collect(), center, ratio(4, 3), ratio(7, 80))
}

proptest! {
    #![proptest_config(runs(20))]

    /// A belt without friction cannot push the part over the pin: whatever touches it jams.
    #[test]
    fn a_belt_without_friction_jams_every_part_that_touches_a_pin((outline, center) in bodies(), pin in pin_frictions()) {
        let answer = Drawn::new(outline, center, int(0), pin).planned();
        for orientation in &answer.orientations {
            prop_assert_eq!(kinds(orientation), [PinAction::Jam, PinAction::PassUnder]);
            prop_assert_eq!(&orientation.intervals[1].from, &orientation.height);
        }
    }

    #[test]
    fn a_practically_infinite_belt_agrees((outline, center) in bodies(), pin in pin_frictions()) {
        let belt = Q::from_integer(partplan::exact::Z::from(10).pow(30));
        let drawn = Drawn::new(outline, center, belt, pin);
        agrees(&drawn.planned(), &drawn.oracle(), &[0.3, 0.7]).map_err(TestCaseError::fail)?;
    }

    /// A half turn about the center of mass: opposite edges look the same.
    #[test]
    fn centrally_symmetric_parts_do_the_same_on_opposite_edges(half in half_outline()) {
        let outline: Vec<[Q; 2]> = half.iter().cloned().chain(half.iter().map(|[x, y]| [-x, -y])).collect();
        let drawn = Drawn::new(outline, [int(0), int(0)], ratio(4, 3), ratio(7, 80));
        let answer = drawn.planned();
        let (n_edges, shift) = (answer.hull.len(), answer.symmetry.shift);
        prop_assert!(shift <= n_edges / 2 && (n_edges / 2).is_multiple_of(shift));
        for orientation in &answer.orientations {
            let other = (orientation.edge + n_edges / 2) % n_edges;
            let class = answer.symmetry.classes.iter().find(|class| class.contains(&orientation.edge));
            prop_assert!(class.is_some_and(|class| class.contains(&other)));
            let other = answer.orientations.iter().find(|o| o.edge == other).expect("an orientation");
            prop_assert!(alike(&orientation.intervals, &other.intervals));
        }
        agrees(&answer, &drawn.oracle(), &[0.5]).map_err(TestCaseError::fail)?;
    }

    /// The center of mass so near to a vertical through a corner that doubles see it on either side.
    #[test]
    fn a_nearly_neutral_edge_agrees((outline, _) in bodies(), edge in any::<prop::sample::Index>(), side in -1..=1_i64, end in 0..2_usize) {
        let hull = Drawn::new(outline.clone(), [int(0), int(0)], int(1), int(0)).oracle().hull;
        let at = edge.index(hull.len());
        let [a, b] = [&hull[at], &hull[(at + 1) % hull.len()]];
        let along = [&b[0] - &a[0], &b[1] - &a[1]];
        let corner = [a, b][end];
        // up from the corner as far as the part goes there, half of the way
        let up = [-&along[1], along[0].clone()];
        let Some(depth) = depth(&hull, corner, &up) else { return Ok(()) };
        let nudge = ratio(side, 1_000_000_000_000_000_000);
        let center = [0, 1].map(|i| &corner[i] + &up[i] * &depth * ratio(1, 2) + &along[i] * &nudge);
        let drawn = Drawn::new(outline, center, ratio(4, 3), ratio(7, 80));
        let answer = drawn.planned();
        let inside = (side > 0) == (end == 0) && side != 0;
        prop_assert_eq!(answer.stable.contains(&at), inside);
        agrees(&answer, &drawn.oracle(), &[0.5]).map_err(TestCaseError::fail)?;
    }
}

/// How many times `up` fits between a corner and the other side of the hull; none if the hull does not lie there.
fn depth(hull: &[[Q; 2]], corner: &[Q; 2], up: &[Q; 2]) -> Option<Q> {
    let crossings = (0..hull.len()).filter_map(|i| {
        let (a, b) = (&hull[i], &hull[(i + 1) % hull.len()]);
        let along = [&b[0] - &a[0], &b[1] - &a[1]];
        let from = [&a[0] - &corner[0], &a[1] - &corner[1]];
        let across = crate::support::cross(up, &along);
        let inward = crate::support::cross(&from, &along);
        (across > int(0)).then(|| inward / across)
    });
    crossings.min().filter(|depth| *depth > int(0))
}

/// Corners right of the origin, in the order of their directions.
fn half_outline() -> impl Strategy<Value = Vec<[Q; 2]>> {
    (prop::collection::btree_set(-9..=9_i64, 2..=6), prop::collection::vec(4..=7_i64, 6)).prop_map(|(tenths, radii)| {
        let corner = |(tenths, radius): (&i64, &i64)| {
            let t = ratio(*tenths, 10);
            let square = &t * &t;
            let scale = int(*radius) / (Q::one() + &square);
            [(Q::one() - square) * &scale, int(2) * t * scale]
        };
        tenths.iter().zip(&radii).map(corner).collect()
    })
}

#[test]
fn squares_and_a_hexagon_look_the_same_on_more_than_one_side() {
    let shapes: [(&[[i64; 2]], usize); 4] = [
        (&[[0, 0], [5, 0], [5, 5], [0, 5]], 1),
        (&[[0, 0], [5, 0], [5, 4], [0, 4]], 2),
        (&[[0, 0], [5, 0], [7, 4], [2, 4]], 2),
        (&[[4, 0], [2, 3], [-2, 3], [-4, 0], [-2, -3], [2, -3]], 3),
    ];
    for (outline, shift) in shapes {
        let count = int(outline.len() as i64);
        let center = [0, 1].map(|axis| outline.iter().map(|v| int(v[axis])).sum::<Q>() / &count);
        let drawn = drawn(outline, center);
        let answer = drawn.planned();
        assert_eq!(answer.symmetry.shift, shift, "{outline:?}");
        assert_eq!(answer.symmetry.classes.len(), shift, "{outline:?}: {:?}", answer.symmetry.classes);
        agrees(&answer, &drawn.oracle(), &[0.25, 0.5, 0.75]).unwrap();
    }
}

/// A dent that the hull hides makes a square look different from each side.
#[test]
fn what_the_hull_hides_is_seen() {
    let center = [ratio(5, 2), ratio(5, 2)];
    let dented = drawn(&[[0, 0], [5, 0], [5, 5], [3, 4], [0, 5]], center);
    let answer = dented.planned();
    assert_eq!((answer.hull.len(), answer.symmetry.shift), (4, 4));
}

/// A convex lattice polygon of `count` edges: their directions are the shortest there are.
fn lattice(count: usize) -> Vec<[Q; 2]> {
    let reach = -16..=16_i64;
    let half = reach.flat_map(|x| (0..=16).map(move |y| [x, y])).filter(|[x, y]| *y > 0 || *x > 0);
    let mut steps: Vec<[i64; 2]> = half.filter(|[x, y]| gcd(x.abs(), *y) == 1).collect();
    steps.sort_by_key(|[x, y]| x * x + y * y);
    steps.truncate(count / 2);
    steps.extend(steps.clone().iter().map(|step| step.map(|x| -x)));
    steps.sort_by(|a, b| f64::atan2(a[1] as f64, a[0] as f64).total_cmp(&f64::atan2(b[1] as f64, b[0] as f64)));
    let mut at = [0, 0];
    let corner = |step: &[i64; 2]| {
        at = [at[0] + step[0], at[1] + step[1]];
        at.map(int)
    };
    steps.iter().map(corner).collect()
}

/// Many corners: each stable edge faces the pin with half of them.
#[test]
fn parts_of_many_corners_agree() {
    for count in [40, 200] {
        let outline = lattice(count);
        let middle = |axis: usize| outline.iter().map(|v| v[axis].clone()).sum::<Q>() / int(count as i64);
        let center = [middle(0) + ratio(1, 3), middle(1) - ratio(1, 7)];
        let drawn = Drawn::new(outline, center, ratio(4, 3), ratio(7, 80));
        let answer = drawn.planned();
        assert_eq!(answer.hull.len(), count);
        agrees(&answer, &drawn.oracle(), &[0.5]).unwrap();
    }
}

fn gcd(a: i64, b: i64) -> i64 {
    if b == 0 { a } else { gcd(b, a % b) }
}
