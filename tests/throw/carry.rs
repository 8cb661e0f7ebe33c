//! Carries against forces at the ends of the edge that lies on the arm.

use super::expected;
use partplan::exact::{Q, Surd, ratio, to_f64};
use partplan::mechanics::throwing::{Load, RestingEdge};
use partplan::model::{Shape, Thrower};
use partplan::planner::{self, CarryQuestion, ThrowError, ThrowQuestion};
use proptest::prelude::*;
use std::sync::LazyLock;

/// Every edge of some public cases, at radius 20 with friction 2/5.
static LOADS: LazyLock<Vec<Load>> = LazyLock::new(|| ["pentagon", "random_10", "clockwise_mm"].map(loads).concat());

fn loads(name: &str) -> Vec<Load> {
    let case = expected::of(name);
    let (part, thrower) = (case.part(), case.thrower());
    let Shape::Polygon(polygon) = &part.shape else { panic!("a polygon") };
    let corners: Vec<[Q; 2]> = polygon.hull().iter().map(|k| polygon.vertices()[*k].clone()).collect();
    let load = |edge| Load {
        edge,
        radius: ratio(20, 1),
        offset: thrower.offset.clone(),
        rho2: part.gyration2(),
        gravity: thrower.gravity.clone(),
        friction: Some(ratio(2, 5)),
    };
    RestingEdge::all(&corners, &part.center_of_mass, &part.gyration2()).into_iter().map(load).collect()
}

/// Whether forces in the friction cones at both ends of the edge move the part with the arm: w = sum of f_j w_j, f_j ≥ 0,
/// as a combination of three of the four; with `slack` on every f_j, relative to the largest.
fn is_held(load: &Load, angle: f64, rate: f64, acceleration: f64, slack: f64) -> bool {
    let [d, left, right] = [&load.edge.d, &load.edge.u_left, &load.edge.u_right].map(Surd::to_f64);
    let [radius, h, rho2, gravity] = [&load.radius, &load.offset, &load.rho2, &load.gravity].map(to_f64);
    let mu = to_f64(load.friction.as_ref().unwrap());
    let w = [
        -acceleration * (h + d) - rate * rate * radius + gravity * angle.sin(),
        acceleration * radius - rate * rate * (h + d) + gravity * angle.cos(),
        acceleration * rho2,
    ];
    let v = -d;
    let generators =
        [[-mu, 1.0, left + mu * v], [mu, 1.0, left - mu * v], [mu, 1.0, right - mu * v], [-mu, 1.0, right + mu * v]];
    let size = w[0].abs().max(w[1].abs()).max(w[2].abs() / (right - left));
    (0..4).any(|left_out| {
        let [a, b, c]: [[f64; 3]; 3] =
            (0..4).filter(|k| *k != left_out).map(|k| generators[k]).collect::<Vec<_>>().try_into().unwrap();
        let whole = determinant(a, b, c);
        let forces = [determinant(w, b, c), determinant(a, w, c), determinant(a, b, w)].map(|part| part / whole);
        forces.iter().all(|force| *force >= -slack * size)
    })
}

fn determinant(a: [f64; 3], b: [f64; 3], c: [f64; 3]) -> f64 {
    let cross = [b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]];
    a[0] * cross[0] + a[1] * cross[1] + a[2] * cross[2]
}

/// Accelerations to try: about the ends, and all over.
fn samples(ends: &[f64; 2]) -> Vec<f64> {
    let mut samples: Vec<f64> = (-60..=60).map(|k| 40.0 * f64::from(k)).collect();
    for end in ends.iter().filter(|end| end.is_finite()) {
        samples.extend([-1e-2, -1e-4, 1e-4, 1e-2].map(|off| end + off * (1.0 + end.abs())));
    }
    samples
}

fn check(load: &Load, angle: f64, rate: f64, ends: Option<[f64; 2]>) -> Result<(), TestCaseError> {
    let Some([from, to]) = ends else {
        for acceleration in samples(&[f64::NAN; 2]) {
            prop_assert!(!is_held(load, angle, rate, acceleration, -1e-9), "{acceleration} holds");
        }
        return Ok(());
    };
    prop_assert!(from <= to);
    for acceleration in samples(&[from, to]) {
        let off = 1e-6 * (1.0 + acceleration.abs());
        if from + off <= acceleration && acceleration <= to - off {
            prop_assert!(is_held(load, angle, rate, acceleration, 1e-9), "{acceleration} in {from} {to} fails");
        } else if acceleration < from - off || to + off < acceleration {
            prop_assert!(!is_held(load, angle, rate, acceleration, -1e-9), "{acceleration} off {from} {to} holds");
        }
    }
    Ok(())
}

fn load() -> impl Strategy<Value = Load> {
    (0..LOADS.len(), 1..400_i64, 1..20_i64).prop_map(|(number, radius, mu)| Load {
        radius: ratio(radius, 10),
        friction: Some(ratio(mu, 10)),
        ..LOADS[number].clone()
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    /// Arms in all directions (1 - t², 2 t) / (1 + t²), turning either way.
    #[test]
    fn exact_ends_are_where_forces_cease_to_hold(load in load(), p in -30..30_i64, q in 1..9_i64, rate in -120..120_i64) {
        let (square, across) = (p * p + q * q, 2 * p * q);
        let [cosine, sine] = [ratio(q * q - p * p, square), ratio(across, square)];
        let rate = ratio(rate, 10);
        let ends = load.accelerations([&cosine, &sine], &rate).map(|[from, to]| {
            [from.map_or(f64::NEG_INFINITY, |end| end.to_f64()), to.map_or(f64::INFINITY, |end| end.to_f64())]
        });
        check(&load, to_f64(&sine).atan2(to_f64(&cosine)), to_f64(&rate), ends)?;
    }

    /// Angles in degrees: close bounds, around where forces cease to hold.
    #[test]
    fn ends_for_degrees_are_enclosed_closely(load in load(), degrees in -3_600..3_600_i64, rate in -120..120_i64) {
        let (degrees, rate) = (ratio(degrees, 10), ratio(rate, 10));
        let ends = load.accelerations_at(&degrees, &rate);
        for [low, high] in ends.iter().flatten().flatten() {
            let width = to_f64(&(high - low));
            prop_assert!((0.0..=4e-15 * to_f64(low).abs().max(1e-20)).contains(&width), "{low} {high}");
        }
        let ends = ends.map(|[from, to]| {
            let middle = |[low, high]: [Q; 2]| 0.5 * (to_f64(&low) + to_f64(&high));
            [from.map_or(f64::NEG_INFINITY, middle), to.map_or(f64::INFINITY, middle)]
        });
        check(&load, to_f64(&degrees).to_radians(), to_f64(&rate), ends)?;
    }
}

/// Section III-A.1: a carry that ends in an impulse of any size is grasped from R_grasp on, R_grasp included.
#[test]
fn accelerations_are_unbounded_above_from_the_radius_of_the_impulsive_grasp_on() {
    let (level, still) = ([&ratio(1, 1), &ratio(0, 1)], ratio(0, 1));
    let mut n_exact = 0;
    for load in LOADS.iter().filter(|load| load.edge.is_stable()) {
        let mu = Surd::from(load.friction.clone().unwrap());
        let by_friction = &load.edge.height_over_pivot(&load.offset) / &mu;
        let r_grasp = load.edge.r_geom(&load.offset, &load.rho2).max(by_friction);
        let [below, above] = r_grasp.between(&ratio(1, 1_000_000_000));
        let is_unbounded = |radius: Q| {
            let [_, to] = Load { radius, ..load.clone() }.accelerations(level, &still).unwrap();
            to.is_none()
        };
        let off = ratio(1, 1_000_000);
        assert!(is_unbounded(above + &off) && !is_unbounded(below - &off));
        if let Some(radius) = r_grasp.rational() {
            assert!(is_unbounded(radius.clone()));
            n_exact += 1;
        }
    }
    assert!(n_exact > 2, "{n_exact}");
}

/// A level arm at rest holds a part exactly where it rests stably.
#[test]
fn an_arm_at_rest_holds_the_part_on_its_stable_edges_only() {
    let (level, still) = ([&ratio(1, 1), &ratio(0, 1)], ratio(0, 1));
    let zero = Surd::from(ratio(0, 1));
    for load in LOADS.iter() {
        let is_at_rest = load
            .accelerations(level, &still)
            .is_some_and(|[from, to]| from.is_none_or(|from| from <= zero) && to.is_none_or(|to| zero <= to));
        assert_eq!(is_at_rest, load.edge.is_stable());
    }
}

#[test]
fn right_angles_are_exact() {
    let rate = ratio(7, 2);
    for load in LOADS.iter() {
        for (degrees, direction) in [(0, [1, 0]), (90, [0, 1]), (-180, [-1, 0]), (630, [0, -1])] {
            let direction = direction.map(|part| ratio(part, 1));
            let exact = load.accelerations(direction.each_ref(), &rate);
            let found = load.accelerations_at(&ratio(degrees, 1), &rate);
            assert_eq!(exact.is_some(), found.is_some());
            for (exact, found) in exact.into_iter().flatten().zip(found.into_iter().flatten()) {
                let (Some(exact), Some([low, high])) = (exact, found) else { continue };
                assert!(Surd::from(low.clone()) <= exact && exact <= Surd::from(high.clone()));
                assert!(exact.rational().is_none_or(|exact| [&low, &high] == [exact, exact]));
            }
        }
    }
}

/// Without friction to slip on, only tipping over the ends of the edge bounds the arm.
#[test]
fn a_part_that_cannot_slip_is_held_at_least_as_well() {
    let (level, rate) = ([&ratio(4, 5), &ratio(3, 5)], ratio(2, 1));
    for load in LOADS.iter() {
        let rough = Load { friction: None, ..load.clone() };
        let Some([from, to]) = load.accelerations(level, &rate) else { continue };
        let [least, most] = rough.accelerations(level, &rate).unwrap();
        assert!(least.is_none_or(|least| from.is_some_and(|from| least <= from)));
        assert!(most.is_none_or(|most| to.is_some_and(|to| to <= most)));
    }
}

/// By the planner: the least friction of the range holds whatever the friction is.
#[test]
fn carries_that_are_asked_for_are_answered_with_the_least_friction() {
    let case = expected::of("triangle_friction");
    let (part, mut thrower) = (case.part(), case.thrower());
    let asked = CarryQuestion { edge: 2, radius: ratio(12, 1), angle_deg: ratio(0, 1), rate: ratio(1, 1) };
    let question = ThrowQuestion { carries: vec![asked], ..Default::default() };
    let plan = |thrower: &Thrower| planner::throw(&part, thrower, &question, &mut |_| false);
    let found = plan(&thrower).unwrap().carries.remove(0);
    assert_eq!((found.edge, &found.radius, &found.friction), (2, &ratio(12, 1), &ratio(1, 5)));
    // f_u = -13/6 α - 12, f_v = 12 α - 13/6 + 966: f_u = f_v / 5 bounds first
    let least = ratio(-6_143, 137);
    assert_eq!(found.accelerations, Some([Some([least.clone(), least]), None]));
    thrower.friction.as_mut().unwrap().max = ratio(1, 1);
    assert_eq!(plan(&thrower).unwrap().carries[0], found);
    thrower.friction = None;
    assert_eq!(plan(&thrower).unwrap_err(), ThrowError::NoFriction);
}
