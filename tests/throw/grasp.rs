//! Edges and grasps against the public cases, string by string.

use super::expected::{self, Expected, index};
use partplan::answer::{Fate, SurdRatio, Throw};
use partplan::exact::{Q, Surd, parse_literal, ratio};
use partplan::model::Part;
use partplan::planner::{self, ThrowError, ThrowQuestion};
use serde_json::{Value, json};
use std::sync::LazyLock;

/// What is exact of each answer, without waiting for orbits and proofs; asked about the throws that are refused.
static ANSWERS: LazyLock<Vec<(Expected, Throw)>> = LazyLock::new(|| {
    let asked = |throw: &Value| (index(&throw["edge"]), parse_literal(throw["R"].as_str().unwrap()).unwrap());
    let answer = |case: Expected| {
        let throws = case.answer["refused"].as_array().unwrap().iter().map(asked).collect();
        let question = ThrowQuestion { throws, ..Default::default() };
        let answer = planner::throw(&case.part(), &case.thrower(), &question, &mut |_| false).unwrap();
        (case, answer)
    };
    expected::all().into_iter().map(answer).collect()
});

/// A number as the public cases spell it, without its decimal.
fn spelled(number: &Surd) -> Value {
    match number.rational() {
        Some(exact) => json!({ "exact": exact.to_string() }),
        None => {
            let [a, b, n] = number.parts().map(Q::to_string);
            json!({ "a": a, "b": b, "sqrt_of": n })
        }
    }
}

fn spelled_ratio(ratio: &SurdRatio) -> Value {
    match ratio {
        SurdRatio::Number(number) => spelled(number),
        SurdRatio::Quotient(above, below) => json!({ "num": spelled(above), "den": spelled(below) }),
    }
}

fn without_decimals(value: &Value) -> Value {
    match value {
        Value::Object(fields) => {
            fields.iter().filter(|(key, _)| *key != "decimal").map(|(k, v)| (k.clone(), without_decimals(v))).collect()
        }
        other => other.clone(),
    }
}

#[test]
fn edges_of_the_public_cases_agree_string_by_string() {
    for (case, answer) in ANSWERS.iter() {
        let hull: Value =
            answer.hull.iter().map(|corner| corner.each_ref().map(Q::to_string)).map(|c| json!(c)).collect();
        assert_eq!((hull, json!(answer.stable)), (case.answer["hull"].clone(), case.answer["stable_edges"].clone()));
        let wanted = case.answer["edges"].as_array().unwrap();
        assert_eq!(answer.edges.len(), wanted.len());
        for (edge, wanted) in answer.edges.iter().zip(wanted) {
            let mut found = json!({
                "edge": edge.edge,
                "stable": edge.is_stable,
                "length2": edge.length2.to_string(),
                "u_left": spelled(&edge.u_left),
                "u_right": spelled(&edge.u_right),
                "d": spelled(&edge.d),
                "energy_kept": edge.energy_kept.to_string(),
                "roll_ratio_positive": edge.energy_kept > ratio(0, 1),
            });
            if let Some(grasp) = &edge.grasp {
                found["R_geom"] = spelled(&grasp.r_geom);
                found["R_grasp"] = spelled(&grasp.r_grasp);
                found["R_clear"] = spelled(&grasp.r_clear);
                found["mu_edge"] = grasp.mu_edge.as_ref().map_or(Value::Null, spelled);
            }
            assert_eq!(found, without_decimals(wanted), "{}", case.name);
        }
    }
}

#[test]
fn common_grasps_of_the_public_cases_agree_string_by_string() {
    for (case, answer) in ANSWERS.iter() {
        let grasp = &answer.grasp;
        let (mu_common, mu_edgewise) = (grasp.mu_common.as_ref().unwrap(), grasp.mu_edgewise.as_ref().unwrap());
        let found = json!({
            "R_common": spelled(&grasp.r_common.1),
            "R_common_edge": grasp.r_common.0,
            "mu_common": spelled_ratio(&mu_common.1),
            "mu_common_edge": mu_common.0,
            "mu_edgewise": spelled(&mu_edgewise.1),
            "mu_edgewise_edge": mu_edgewise.0,
        });
        assert_eq!(found, without_decimals(&case.answer["grasp"]), "{}", case.name);
    }
}

#[test]
fn throws_outside_of_the_domain_are_refused_for_the_reason_expected() {
    for (case, answer) in ANSWERS.iter() {
        let refused = case.answer["refused"].as_array().unwrap();
        assert_eq!(answer.throws.len(), refused.len());
        for (query, throw) in answer.throws.iter().zip(refused) {
            let outcome = match query.fates[0] {
                Fate::UnstableEdge => "unstable_edge",
                Fate::NoGrasp => "no_grasp",
                Fate::Overhang => "overhang",
                _ => "thrown",
            };
            assert_eq!(outcome, throw["outcome"].as_str().unwrap(), "{}: {throw}", case.name);
        }
    }
}

/// Edge 2 of the triangle needs |h + d| / μ = 65/6 at μ = 1/5.
#[test]
fn the_least_friction_of_a_range_decides() {
    let case = expected::of("triangle_friction");
    let mut thrower = case.thrower();
    let mu = thrower.friction.as_mut().unwrap();
    mu.max = ratio(9, 10);
    let found = planner::throw(&case.part(), &thrower, &ThrowQuestion::default(), &mut |_| false).unwrap();
    assert_eq!(found.edges[2].grasp.as_ref().unwrap().r_grasp, Surd::from(ratio(65, 6)));
}

#[test]
fn a_center_of_mass_that_leaves_the_resting_edges_open_is_refused() {
    let case = expected::of("pentagon");
    let mut part = case.part();
    let plan = |part: &Part| planner::throw(part, &case.thrower(), &ThrowQuestion::default(), &mut |_| false);
    part.center_of_mass_tolerance = ratio(1, 100);
    assert!(plan(&part).is_ok());
    part.center_of_mass_tolerance = ratio(5, 1);
    assert!(matches!(plan(&part), Err(ThrowError::UncertainRest { .. })));
}

#[test]
fn an_edge_that_is_not_there_is_named() {
    let case = expected::of("pentagon");
    let question = ThrowQuestion { throws: vec![(5, ratio(20, 1))], ..Default::default() };
    let error = planner::throw(&case.part(), &case.thrower(), &question, &mut |_| false).unwrap_err();
    assert_eq!(error, ThrowError::NoSuchEdge { edge: 5, last: 4 });
}
