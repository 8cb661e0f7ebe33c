//! Of `goal`: the public cases, closed forms, invariance, and brute force on its closed holes.

use crate::support::cases::{FOUR, NAMES, expected, number, seated, wrench_of};
use crate::support::member::rational;
use crate::support::modes::{Contacts, unseating_modes};
use crate::support::random::{Setup, any_friction, polygons, runs, seatable, wrenches};
use crate::support::{Wrench, dot, int, wrench};
use crate::{answer, covers, norm2};
use num_traits::{One, Signed, Zero};
use partplan::answer::{CanonicalCone, Cone, Robust};
use partplan::exact::{Q, from_float_exact, ratio, to_f64};
use partplan::geometry::Polygon;
use partplan::model::{Fixel, Fixture, Friction, LengthUnit, Part, Place, Range, Shape};
use partplan::planner::{Question, mode_cones};
use partplan::report::{Subject, json};
use proptest::prelude::*;

fn robust(setup: &Setup) -> Option<Robust> {
    answer(setup).robust
}

/// The closed cones whose complement is the goal set.
fn holes((part, fixture): &Setup) -> Vec<CanonicalCone> {
    let modes = unseating_modes(fixture.fixels.len()).iter().map(|mode| mode.parse().expect("a mode")).collect();
    let question = Question { modes, robust: true, ..Question::default() };
    let cones = mode_cones(part, fixture, &question).expect("one letter per fixel");
    cones.into_iter().filter_map(|(_, cone)| if let Cone::Of(cone) = cone { Some(cone) } else { None }).collect()
}

/// Squared distance of `g` from `hole`: a point on the boundary is a combination of at most two generators
/// (Carathéodory), and so is every point of a flat cone.
fn distance2(hole: &CanonicalCone, g: &Wrench, rho2: &Q) -> Q {
    let side = |row: &Vec<partplan::exact::Z>| dot(&rational(row), g);
    let is_inside = hole.equalities.iter().all(|row| side(row).is_zero())
        && hole.faces.iter().all(|face| !side(&face.normal).is_positive());
    if is_inside {
        return Q::zero();
    }
    let mut generators: Vec<Vec<Q>> = hole.rays.iter().map(|ray| rational(ray)).collect();
    for line in &hole.lines {
        generators.push(rational(line));
        generators.push(rational(line).iter().map(|value| -value).collect());
    }
    let product = |a: &[Q], b: &[Q]| &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2] / rho2;
    let mut least = norm2(g, rho2);
    for (i, a) in generators.iter().enumerate() {
        let (aa, ag) = (product(a, a), product(a, g));
        if ag.is_positive() {
            least = least.min(norm2(g, rho2) - &ag * &ag / &aa);
        }
        for b in &generators[..i] {
            let (bb, ab, bg) = (product(b, b), product(a, b), product(b, g));
            let determinant = &aa * &bb - &ab * &ab;
            let (of_a, of_b) = (&ag * &bb - &bg * &ab, &bg * &aa - &ag * &ab);
            if determinant.is_positive() && of_a.is_positive() && of_b.is_positive() {
                least = least.min(norm2(g, rho2) - (&of_a * &ag + &of_b * &bg) / determinant);
            }
        }
    }
    least
}

/// Squared distance of `g` from the nearest hole, over its squared length.
fn radius2(setup: &Setup, holes: &[CanonicalCone], g: &Wrench) -> Q {
    let rho2 = setup.0.gyration2();
    let nearest = holes.iter().map(|hole| distance2(hole, g, &rho2)).min().expect("every fixture has holes");
    nearest / norm2(g, &rho2)
}

/// The exact radius is that of the brute force, and the bound is above it by no more than the tolerance.
fn check_exact(setup: &Setup, robust: &Robust) -> Result<(), TestCaseError> {
    prop_assert_eq!(&radius2(setup, &holes(setup), &robust.wrench), &robust.radius2);
    prop_assert!(robust.radius2.is_positive() && robust.radius2 <= Q::one());
    prop_assert!(covers(&robust.radius_upper, &robust.radius2));
    let tolerance = from_float_exact(Robust::TOLERANCE).expect("a tolerance is finite");
    let lower = &robust.radius_upper - tolerance;
    prop_assert!(lower.is_negative() || &lower * &lower <= robust.radius2, "the search stopped short: {:?}", robust);
    Ok(())
}

#[test]
fn the_public_cases_agree_with_an_independent_search() {
    for name in NAMES.into_iter().chain([FOUR]) {
        let theirs = &expected(name)["robust"];
        let setup = seated(name);
        let ours = robust(&setup);
        assert_eq!(ours.is_none(), theirs.is_null(), "{name}");
        let Some(ours) = ours else { continue };
        check_exact(&setup, &ours).unwrap_or_else(|fault| panic!("{name}: {fault}"));
        let value = |key: &str| theirs[key].as_f64().expect("a decimal");
        let radius = to_f64(&ours.radius2).sqrt();
        assert!((radius - value("radius")).abs() <= 2e-6, "{name}: {radius} {}", value("radius"));
        assert!(radius <= value("radius_upper"), "{name}");
        assert!(covers(&ours.radius_upper, &number(&theirs["radius2"])), "{name}");
        assert_eq!(radius2(&setup, &holes(&setup), &wrench_of(&theirs["w"])), number(&theirs["radius2"]), "{name}");
    }
}

#[test]
fn the_document_names_the_wrench_its_radius_and_the_bound() {
    let (part, fixture) = seated("n2_disc_fig5");
    let answer = crate::answer(&(part.clone(), fixture.clone()));
    let subject = Subject { name: "disc", part: &part, fixture: &fixture, warnings: &[] };
    let document = json::insertion(&subject, &answer, false);
    let shown = &document["result"]["robust"];
    // the sets are equal here
    assert_eq!(shown, &document["result"]["robust_acyclic"]);
    assert_eq!((&shown["w"], &shown["radius2"]), (&serde_json::json!([0, -1, 0]), &serde_json::json!("1/50")));
    assert_eq!(shown["radius"].as_f64(), Some(0.02_f64.sqrt()));
    let upper = shown["radius_upper"].as_f64().expect("a decimal");
    assert!((0.0..=Robust::TOLERANCE).contains(&(upper - 0.02_f64.sqrt())), "{upper}");

    let (part, fixture) = seated(FOUR);
    let answer = crate::answer(&(part.clone(), fixture.clone()));
    let subject = Subject { name: "square", part: &part, fixture: &fixture, warnings: &[] };
    let shown = &json::insertion(&subject, &answer, false)["result"];
    assert!(shown["robust"].is_null() && shown["robust_acyclic"].is_null());
}

/// A square about the origin with side 2, fixels of one friction inside edges at the given places.
fn square(places: &[(usize, Q)], friction: &Q) -> Setup {
    let vertices = [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(|point| point.map(int));
    let polygon = Polygon::new(vertices.to_vec()).expect("a square");
    let fixels = places.iter().map(|(edge, s)| Fixel {
        place: Place::Edge { edge: *edge, s: s.clone() },
        point: polygon.point(&polygon.location(*edge, s.clone())),
        normal: polygon.inward_normal(*edge),
        friction: Friction { static_: Range::exactly(friction.clone()), kinetic: Range::exactly(friction.clone()) },
    });
    let fixture = Fixture { fixels: fixels.collect() };
    let part = Part {
        unit: LengthUnit::Metre,
        shape: Shape::Polygon(polygon),
        center_of_mass: [int(0), int(0)],
        center_of_mass_tolerance: int(0),
        mass: int(1),
        inertia: ratio(2, 3),
    };
    (part, fixture)
}

#[test]
fn one_fixel_leaves_an_open_half_space_and_the_push_against_it_is_as_robust_as_any() {
    for friction in [ratio(0, 1), ratio(1, 2)] {
        let found = robust(&square(&[(0, ratio(1, 4))], &friction)).expect("one fixel can be reached");
        assert_eq!(found.radius2, int(1));
        assert_eq!(found.radius_upper, int(1));
    }
}

#[test]
fn two_frictionless_walls_at_right_angles_are_best_pushed_into_evenly() {
    // both normals meet the center of mass: the goal is the quadrant fx < 0, fy < 0 whatever the torque
    let setup = square(&[(0, ratio(1, 2)), (3, ratio(1, 2))], &int(0));
    let found = robust(&setup).expect("the corner can be reached");
    assert_eq!(found.wrench, wrench(-1, -1, 0));
    assert_eq!(found.radius2, ratio(1, 2));
    assert!(covers(&found.radius_upper, &ratio(1, 2)));
}

#[test]
fn no_wrench_is_robust_where_none_seats_the_part() {
    let facing = square(&[(0, ratio(1, 2)), (2, ratio(1, 2))], &ratio(1, 5));
    assert_eq!(robust(&facing), None);
}

/// The same part in lengths `unit` times shorter, of `mass` times the mass.
fn rescaled((part, fixture): &Setup, unit: &Q, mass: &Q) -> Setup {
    let (mut part, mut fixture) = (part.clone(), fixture.clone());
    let image = |point: &[Q; 2]| point.each_ref().map(|value| value * unit);
    let Shape::Polygon(polygon) = &part.shape else { panic!("only polygons are drawn here") };
    part.shape = Shape::Polygon(Polygon::new(polygon.vertices().iter().map(&image).collect()).expect("still simple"));
    part.center_of_mass = image(&part.center_of_mass);
    part.inertia = &part.inertia * unit * unit * mass;
    part.mass = &part.mass * mass;
    fixture.fixels.iter_mut().for_each(|fixel| fixel.point = image(&fixel.point));
    (part, fixture)
}

proptest! {
    #![proptest_config(runs(40))]

    #[test]
    fn units_and_mass_do_not_change_the_relative_radius(
        setup in prop_oneof![polygons(1..=3, any_friction()), seatable()],
        decades in -60..60_i32,
        mass in 1..50_i64,
    ) {
        let power = ratio(10, 1).pow(decades);
        let (ours, image) = (robust(&setup), robust(&rescaled(&setup, &power, &ratio(mass, 7))));
        prop_assert_eq!(ours.is_none(), image.is_none());
        if let (Some(ours), Some(image)) = (ours, image) {
            prop_assert!(covers(&ours.radius_upper, &image.radius2) && covers(&image.radius_upper, &ours.radius2));
            let (ours, image) = (to_f64(&ours.radius2).sqrt(), to_f64(&image.radius2).sqrt());
            prop_assert!((ours - image).abs() <= Robust::TOLERANCE, "{} {}", ours, image);
        }
    }

    #[test]
    fn the_radius_is_exact_and_no_wrench_beats_the_bound(
        setup in prop_oneof![polygons(1..=3, any_friction()), seatable()],
        others in wrenches(8),
    ) {
        let Some(found) = robust(&setup) else { return Ok(()) };
        check_exact(&setup, &found)?;
        let holes = holes(&setup);
        for other in others.iter().filter(|other| other.iter().any(|value| !value.is_zero())) {
            prop_assert!(covers(&found.radius_upper, &radius2(&setup, &holes, other)), "{:?}", other);
        }
    }

    #[test]
    fn every_disturbance_within_the_radius_leaves_the_part_certain_to_seat(
        setup in seatable(),
        disturbances in wrenches(6),
    ) {
        let Some(found) = robust(&setup) else { return Ok(()) };
        let (contacts, rho2) = (Contacts::of(&setup.0, &setup.1), setup.0.gyration2());
        let room2 = &found.radius2 * norm2(&found.wrench, &rho2);
        for disturbance in disturbances.iter().filter(|d| d.iter().any(|value| !value.is_zero())) {
            let share = from_float_exact(0.999 * to_f64(&(&room2 / norm2(disturbance, &rho2))).sqrt()).expect("finite");
            let disturbed: Wrench = [0, 1, 2].map(|i| &found.wrench[i] + &share * &disturbance[i]);
            prop_assert!(&share * &share * norm2(disturbance, &rho2) < room2);
            prop_assert!(contacts.goal(&disturbed), "{:?}", disturbed);
        }
    }
}
