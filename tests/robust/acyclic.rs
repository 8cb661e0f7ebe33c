//! Of `acyclic`: against the programs that decide which wrenches belong to it, and where it is a single known cone.

use crate::support::cases::{NAMES, seated};
use crate::support::member::{in_region, rational};
use crate::support::modes::Contacts;
use crate::support::random::{Setup, any_friction, any_setup, polygons, runs, seatable, wrenches};
use crate::support::{Wrench, dot, int};
use crate::{answer, covers, norm2};
use num_traits::{Signed as _, Zero as _};
use partplan::answer::{Cone, Insertion, Robust};
use partplan::exact::{Q, from_float_exact, ratio, to_f64};
use partplan::mechanics::{Interaction, Mode};
use partplan::model::Range;
use partplan::planner::{Question, mode_cones};
use proptest::prelude::*;

/// The most robust wrench of `acyclic`, unless the set is empty or so thin that it holds no ball.
fn robust(answer: &Insertion) -> Option<&Robust> {
    answer.robust_acyclic.as_ref().filter(|robust| robust.radius2.is_positive())
}

/// Where a nearest point of the complement must be one: the feet of `g` on the planes and edges of the set's cells, and
/// zero, and `g` itself. With each cell's vectors, which lead from there into the pieces that meet.
fn feet(answer: &Insertion, g: &Wrench, rho2: &Q) -> (Vec<Wrench>, Vec<Wrench>) {
    let (mut feet, mut ways) = (vec![[0, 0, 0].map(int), g.clone()], Vec::new());
    let cones =
        answer.acyclic.cells.iter().filter_map(|cell| if let Cone::Of(cone) = cell { Some(cone) } else { None });
    for cone in cones {
        for normal in cone.faces.iter().map(|face| &face.normal).chain(&cone.equalities) {
            let normal = rational(normal);
            let raised = [normal[0].clone(), normal[1].clone(), &normal[2] * rho2];
            let share = dot(&normal, g) / dot(&normal, &raised);
            feet.push([0, 1, 2].map(|i| &g[i] - &share * &raised[i]));
            ways.push(raised);
        }
        for edge in cone.rays.iter().chain(&cone.lines) {
            let edge = <Wrench>::try_from(rational(edge)).expect("three components");
            let along = [edge[0].clone(), edge[1].clone(), &edge[2] / rho2];
            let share = dot(&along, g) / dot(&along, &edge);
            feet.push([0, 1, 2].map(|i| &share * &edge[i]));
            ways.push(edge);
        }
    }
    (feet, ways)
}

/// Of the wrenches within `radius2` of `g`, squared and not relative, and a hair beyond, one that is not certain to seat
/// the part, if the search about the feet meets one.
fn stray((part, _): &Setup, answer: &Insertion, g: &Wrench, radius2: &Q) -> Option<Wrench> {
    let rho2 = part.gyration2();
    let (feet, ways) = feet(answer, g, &rho2);
    let reached = |foot: &&Wrench| norm2(&[0, 1, 2].map(|i| &foot[i] - &g[i]), &rho2) <= *radius2;
    let size = to_f64(&norm2(g, &rho2)).sqrt();
    let mut probes = Vec::new();
    for foot in feet.iter().filter(reached) {
        probes.push(foot.clone());
        for way in &ways {
            let hair = from_float_exact(1e-9 * size / to_f64(&norm2(way, &rho2)).sqrt()).expect("finite");
            for hair in [hair.clone(), -hair] {
                probes.push([0, 1, 2].map(|i| &foot[i] + &hair * &way[i]));
            }
        }
    }
    probes.into_iter().find(|probe| !in_region(&answer.acyclic, probe))
}

/// The radius is that of a foot, a wrench beside that foot fails, and none that is nearer does.
fn check(setup: &Setup, disturbances: &[Wrench]) -> Result<(), TestCaseError> {
    let answer = answer(setup);
    prop_assert_eq!(answer.robust_acyclic.is_none(), answer.acyclic.is_empty());
    if let Some(of_goal) = &answer.robust {
        prop_assert!(answer.robust_acyclic.as_ref().is_some_and(|robust| robust.radius2 >= of_goal.radius2));
    }
    let Some(found) = robust(&answer) else {
        prop_assert!(!answer.acyclic.has_interior());
        return Ok(());
    };
    let (contacts, rho2) = (Contacts::of(&setup.0, &setup.1), setup.0.gyration2());
    let room2 = &found.radius2 * norm2(&found.wrench, &rho2);
    prop_assert!(covers(&found.radius_upper, &found.radius2));

    let beyond = stray(setup, &answer, &found.wrench, &room2);
    prop_assert!(beyond.is_some_and(|g| !contacts.acyclic(&g)), "a larger ball fits about {:?}", found);

    let (feet, _) = feet(&answer, &found.wrench, &rho2);
    let towards = feet.iter().map(|foot| [0, 1, 2].map(|i| &foot[i] - &found.wrench[i]));
    let step = towards.len() / 6 + 1;
    for way in disturbances.iter().cloned().chain(towards.step_by(step)).filter(|d| d.iter().any(|x| !x.is_zero())) {
        let share = from_float_exact(0.999 * to_f64(&(&room2 / norm2(&way, &rho2))).sqrt()).expect("finite");
        let disturbed: Wrench = [0, 1, 2].map(|i| &found.wrench[i] + &share * &way[i]);
        prop_assert!(&share * &share * norm2(&way, &rho2) < room2);
        prop_assert!(contacts.acyclic(&disturbed), "{:?}", disturbed);
    }
    Ok(())
}

#[test]
fn the_public_cases_hold_the_ball_that_is_claimed_and_no_larger_one() {
    for name in NAMES {
        check(&seated(name), &[[int(1), int(0), int(0)], [int(-1), int(2), int(1)]])
            .unwrap_or_else(|fault| panic!("{name}: {fault}"));
    }
}

#[test]
fn a_case_without_goal_has_a_robust_wrench_all_the_same() {
    let answer = answer(&seated("n3_acyclic_only"));
    assert!(answer.robust.is_none());
    assert!(robust(&answer).is_some());
}

/// Largest t with a unit vector g and `u · g ≥ t` for each of at most three unit vectors u: by minimax the distance of
/// zero from their convex hull.
fn incentre(inward: &[[f64; 3]]) -> f64 {
    let dot = |a: &[f64; 3], b: &[f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let sides = (0..inward.len()).flat_map(|i| (0..i).map(move |j| [i, j]));
    let of_sides = sides.map(|[i, j]| ((1.0 + dot(&inward[i], &inward[j])) / 2.0).sqrt()).fold(1.0, f64::min);
    let [a, b, c] = inward else { return of_sides };
    // the foot of zero on the plane through the tips, in barycentric coordinates: the Gram matrix solved for ones
    let (ab, bc, ca) = (dot(a, b), dot(b, c), dot(c, a));
    let determinant = 1.0 + 2.0 * ab * bc * ca - ab * ab - bc * bc - ca * ca;
    let weight = |opposite: f64, x: f64, y: f64| (1.0 - opposite * opposite + opposite * (x + y) - x - y) / determinant;
    let weights = [weight(bc, ab, ca), weight(ca, ab, bc), weight(ab, bc, ca)];
    if weights.iter().all(|weight| *weight >= 0.0) { weights.iter().sum::<f64>().sqrt().recip() } else { of_sides }
}

proptest! {
    #![proptest_config(runs(4))]

    #[test]
    fn the_ball_of_fixtures_that_seat_is_inside_and_as_large_as_it_can_be(
        setup in seatable(),
        disturbances in wrenches(2),
    ) {
        check(&setup, &disturbances)?;
    }

    #[test]
    fn no_wrench_beats_the_bound(setup in seatable(), others in wrenches(3)) {
        let answer = answer(&setup);
        let (Some(found), rho2) = (robust(&answer), setup.0.gyration2()) else { return Ok(()) };
        let near = [0, 1, 2].map(|i| &found.wrench[i] * ratio(if i == 2 { 101 } else { 100 }, 100));
        let others = others.into_iter().chain([near]).filter(|g| g.iter().any(|value| !value.is_zero()));
        for g in others {
            let room2 = &found.radius_upper * &found.radius_upper * norm2(&g, &rho2);
            prop_assert!(stray(&setup, &answer, &g, &room2).is_some(), "a larger ball fits about {:?}", g);
        }
    }
}

proptest! {
    #![proptest_config(runs(24))]

    #[test]
    fn the_ball_is_inside_and_as_large_as_it_can_be(setup in any_setup(1..=3), disturbances in wrenches(2)) {
        check(&setup, &disturbances)?;
    }

    /// Without friction `acyclic` is the interior of the cone that holds the seated part: its radius is that of the ball
    /// inscribed in a cone with a facet for each fixel.
    #[test]
    fn without_friction_the_ball_is_the_one_inscribed_in_the_holding_cone(
        setup in prop_oneof![polygons(1..=3, any_friction()), seatable()],
    ) {
        let (part, mut fixture) = setup;
        for fixel in &mut fixture.fixels {
            fixel.friction.static_ = Range::exactly(ratio(0, 1));
            fixel.friction.kinetic = Range::exactly(ratio(0, 1));
        }
        let modes = vec![Mode(vec![Interaction::Maintain; fixture.fixels.len()])];
        let question = Question { modes, ..Question::default() };
        let held = mode_cones(&part, &fixture, &question).expect("a letter per fixel").remove(0).1;
        let rho = to_f64(&part.gyration2()).sqrt();
        let answer = answer(&(part, fixture));
        let (Some(found), Cone::Of(held)) = (robust(&answer), held) else { return Ok(()) };
        let unit = |normal: &[partplan::exact::Z]| {
            let [x, y, t] = <[Q; 3]>::try_from(rational(normal)).expect("three components").map(|v| -to_f64(&v));
            let length = (x * x + y * y + t * t * rho * rho).sqrt();
            [x / length, y / length, t * rho / length]
        };
        let inward: Vec<[f64; 3]> = held.faces.iter().map(|face| unit(&face.normal)).collect();
        let (ours, theirs) = (to_f64(&found.radius2).sqrt(), incentre(&inward));
        prop_assert!((ours - theirs).abs() <= 2.0 * Robust::TOLERANCE, "{} {}", ours, theirs);
    }
}
