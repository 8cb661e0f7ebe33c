//! The throw map against throws of thirty digits.

use super::expected::{self, Expected, index, number};
use partplan::mechanics::throwing::{Body, Catch, Settling, Thrown};
use serde_json::Value;

fn relative(found: f64, expected: &Value) -> f64 {
    let expected = number(expected);
    (found - expected).abs() / expected.abs()
}

fn catch(body: &Body<f64>, throw: &Value, settling: Settling) -> Catch {
    match body.throw(index(&throw["edge"]), number(&throw["R"]), settling) {
        Thrown::Caught(catch) => catch,
        other => panic!("{other:?} for {throw}"),
    }
}

/// Largest relative error of a throw, after its branch was compared.
fn error(case: &Expected, body: &Body<f64>, throw: &Value, settling: Settling) -> f64 {
    let found = catch(body, throw, settling);
    let branch = (found.edge, found.steps, found.impact_vertex);
    let wanted = (index(&throw["to_edge"]), throw["steps"].as_i64().unwrap(), index(&throw["impact_vertex"]));
    assert_eq!(branch, wanted, "{}: {throw}", case.name);
    [
        relative(found.radius, &throw["to_R"]),
        relative(found.flight_rotation, &throw["flight_rotation"]),
        relative(found.flight_rotation / body.rate(), &throw["flight_time"]),
        // a difference of lengths that may be near zero
        (found.impact_x - number(&throw["impact_x"])).abs() / number(&throw["R"]),
        relative(found.omega_after * body.rate(), &throw["omega_after"]),
        relative(found.slope, &throw["slope"]),
    ]
    .into_iter()
    .fold(0.0, f64::max)
}

#[test]
fn throws_of_the_public_cases_agree_to_eleven_digits_next_to_breaks_too() {
    let mut n_throws = 0;
    for case in expected::all() {
        let body = case.body();
        for (key, settling) in
            [("throws", Settling::Full), ("stress_throws", Settling::Full), ("throws_first_stable", Settling::First)]
        {
            for throw in case.answer[key].as_array().unwrap() {
                let error = error(&case, &body, throw, settling);
                assert!(error < 1e-11, "{}: {error:e} for {throw}", case.name);
                n_throws += 1;
            }
        }
    }
    assert!(n_throws > 250, "{n_throws}");
}

#[test]
fn parts_that_miss_the_arm_are_told() {
    for case in expected::all() {
        let body = case.body::<f64>();
        for throw in case.answer["off_arm"].as_array().unwrap() {
            match body.throw(index(&throw["edge"]), number(&throw["R"]), Settling::Full) {
                Thrown::OffArm { x, impact_vertex, .. } => {
                    assert_eq!(impact_vertex, index(&throw["impact_vertex"]));
                    assert!(relative(x, &throw["impact_x"]) < 1e-11 || x < 0.0, "{x} for {throw}");
                }
                other => panic!("{other:?} for {throw}"),
            }
        }
    }
}

#[test]
fn orbits_stay_as_close_as_their_growth_allows() {
    for case in expected::all() {
        let (body, radius) = (case.body::<f64>(), part_radius(&case));
        let orbit = case.answer["orbit"].as_array().unwrap();
        let mut at = (index(&orbit[0][0]), number(&orbit[0][1]));
        for state in &orbit[1..] {
            let Thrown::Caught(catch) = body.throw(at.0, at.1, Settling::Full) else {
                panic!("{} at {at:?}", case.name)
            };
            let (wanted, growth) = (number(&state[1]), number(&state[3]));
            if growth * 1e-15 > 1e-3 * radius {
                break;
            }
            assert_eq!((catch.edge, catch.steps), (index(&state[0]), state[2].as_i64().unwrap()), "{}", case.name);
            // the reference stayed below 1e-15 R growth
            assert!((catch.radius - wanted).abs() < 1e-14 * wanted * growth.max(1.0), "{}: {state}", case.name);
            at = (catch.edge, catch.radius);
        }
    }
}

fn part_radius(case: &Expected) -> f64 {
    let hull = case.answer["hull"].as_array().unwrap();
    let com = &case.answer["center_of_mass"];
    let distance = |corner: &Value| (number(&corner[0]) - number(&com[0])).hypot(number(&corner[1]) - number(&com[1]));
    hull.iter().map(distance).fold(0.0, f64::max)
}
