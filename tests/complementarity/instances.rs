//! The 17 instances with exact data, known solutions and certificates.

use crate::brute::in_doubles;
use crate::check::proof_holds;
use num_traits::{Signed as _, Zero as _};
use partplan::complementarity::{
    Count, Enumeration, ExactLcp, Images, Lcp, Limits, Proof, Rung, Solver, Verdict, enumerate,
};
use partplan::exact::{Q, dot, parse_literal};
use serde_json::Value;

struct Instance {
    name: String,
    status: String,
    lcp: ExactLcp,
    solutions: Vec<Vec<Q>>,
    has_unique_w: bool,
    farkas: Option<Vec<Q>>,
    ends_in_ray: bool,
}

fn instances() -> Vec<Instance> {
    let text = include_str!("lcp_instances.json");
    let all: Vec<Value> = serde_json::from_str(text).unwrap();
    let number = |value: &Value| match value {
        Value::String(text) => parse_literal(text).unwrap(),
        other => parse_literal(&other.to_string()).unwrap(),
    };
    let row = |value: &Value| value.as_array().unwrap().iter().map(number).collect::<Vec<Q>>();
    let rows = |value: &Value| value.as_array().unwrap().iter().map(row).collect::<Vec<_>>();
    all.iter()
        .map(|one| Instance {
            name: one["name"].as_str().unwrap().to_owned(),
            status: one["status"].as_str().unwrap().to_owned(),
            lcp: ExactLcp::new(rows(&one["M"]), row(&one["q"])).unwrap(),
            solutions: rows(&one["solutions"]),
            has_unique_w: one["w_unique"] == Value::Bool(true),
            farkas: one.get("farkas").map(row),
            ends_in_ray: one["lemke"]["lex"][0] == "ray",
        })
        .collect()
}

#[test]
fn the_file_is_what_the_tests_expect() {
    let all = instances();
    assert_eq!(all.len(), 17);
    for Instance { name, lcp, solutions, farkas, .. } in &all {
        assert!(solutions.iter().all(|z| lcp.is_solution(z)), "{name}");
        if let Some(y) = farkas {
            assert!(proof_holds(lcp, &Proof::Farkas(y.clone())), "{name}");
        }
    }
}

/// From every rung on: the ladder in doubles, and the exact rungs alone.
#[test]
fn every_instance_is_answered_from_every_rung() {
    for instance in instances() {
        let Instance { name, status, lcp, solutions, .. } = &instance;
        let (m, q) = in_doubles(lcp);
        for first in Rung::ALL {
            let mut solver = Solver::with_limits(Limits { first, ..Limits::default() });
            let verdict = solver.solve(Lcp { m: &m, q: &q }, None, &|| Ok(lcp.clone())).unwrap();
            match verdict {
                Verdict::Solved(solution) => {
                    assert_ne!(status, "none", "{name} from {first:?}");
                    assert!(solution.rung >= first, "{name} from {first:?} on {:?}", solution.rung);
                    if let Some(z) = solution.exact {
                        assert!(lcp.is_solution(z), "{name} from {first:?}");
                        assert!(status == "some" || solutions.contains(&z.to_vec()), "{name} from {first:?}");
                    } else {
                        assert!(near_solution(lcp, solution.z), "{name} from {first:?}");
                    }
                    if status == "unique" {
                        let close = |(z, exact): (&f64, &Q)| (z - partplan::exact::to_f64(exact)).abs() < 1e-12;
                        assert!(solution.z.iter().zip(&solutions[0]).all(close), "{name} from {first:?}");
                    }
                }
                Verdict::NoSolution(proof) => {
                    assert_eq!(status, "none", "{name} from {first:?}");
                    assert!(proof_holds(lcp, &proof), "{name} from {first:?}");
                }
                Verdict::Undecided(why) => panic!("{name} from {first:?}: {why:?}"),
            }
        }
    }
}

/// `min(w, z)` in exact arithmetic, of the doubles as they are.
fn near_solution(lcp: &ExactLcp, z: &[f64]) -> bool {
    let z: Vec<Q> = z.iter().map(|value| partplan::exact::from_float_exact(*value).unwrap()).collect();
    let tolerance = partplan::exact::ratio(1, 1_000_000_000_000);
    let small = |(w, z): (&Q, &Q)| w.min(z).abs() <= tolerance;
    !z.iter().any(Q::is_negative) && lcp.w(&z).iter().zip(&z).all(small)
}

#[test]
fn enumeration_finds_the_listed_solutions_and_no_others() {
    for Instance { name, status, lcp, solutions, has_unique_w, .. } in instances() {
        let Enumeration::Complete(all) = enumerate(&lcp, 20_000) else { panic!("{name} is unfinished") };
        for z in &solutions {
            assert!(all.contains(&lcp, z), "{name}");
        }
        for piece in &all.pieces {
            assert!(piece.vertices.iter().all(|z| lcp.is_solution(z)), "{name}");
        }
        match status.as_str() {
            "none" => assert_eq!(all.count(), Count::None, "{name}"),
            "unique" => assert_eq!(all.count(), Count::Unique, "{name}"),
            "complete" => {
                let vertices: Vec<_> = all.pieces.iter().flat_map(|piece| piece.vertices.clone()).collect();
                assert_eq!(vertices.len(), solutions.len(), "{name}");
            }
            _ => {}
        }
        if has_unique_w {
            assert!(matches!(all.images(lcp.m()), Images::Unique(_)), "{name}");
            assert_eq!(all.count(), Count::Continuum, "{name}");
        }
    }
}

/// A ray is no proof: the fourth-order instance has exactly one solution, which the cases find.
#[test]
fn a_ray_alone_is_not_called_infeasible() {
    let all = instances();
    let instance = all.iter().find(|instance| instance.name == "solvable_but_ray_4").unwrap();
    assert!(instance.ends_in_ray);
    let (m, q) = in_doubles(&instance.lcp);
    let solve = |limits| {
        let mut solver = Solver::with_limits(limits);
        let verdict = solver.solve(Lcp { m: &m, q: &q }, None, &|| Ok(instance.lcp.clone())).unwrap();
        match verdict {
            Verdict::Solved(solution) => (true, Some(solution.rung)),
            Verdict::NoSolution(_) => panic!("there is one"),
            Verdict::Undecided(_) => (false, None),
        }
    };
    let exact = Limits { first: Rung::Exact, ..Limits::default() };
    assert_eq!(solve(exact), (true, Some(Rung::Cases)));
    assert_eq!(solve(Limits { cases: 0, ..exact }), (false, None));
}

/// The four-point block: each corner's impulse is between zero and what two corners can carry, and the motion is unique.
#[test]
fn the_forces_on_four_points_are_intervals_and_the_motion_is_one() {
    let all = instances();
    let block = all.iter().find(|instance| instance.name == "four_point_block_frictionless_4").unwrap();
    let Enumeration::Complete(solutions) = enumerate(&block.lcp, 1000) else { panic!() };
    let q = |text| parse_literal(text).unwrap();
    let ends: Vec<_> =
        (0..4).map(|i| solutions.range(i).unwrap()).map(|range| (range.min, range.max.unwrap())).collect();
    assert_eq!(ends[0], (q("0"), q("981/100000")));
    assert_eq!(ends[1], (q("0"), q("2943/200000")));
    assert_eq!(ends[2], (q("0"), q("2943/200000")));
    assert_eq!(ends[3], (q("0"), q("981/100000")));
    let still = vec![vec![q("1"); 4]];
    assert_eq!(solutions.images(&still), Images::Unique(vec![q("981/50000")]));
    assert!(block.solutions.iter().all(|z| dot(z, &still[0]) == q("981/50000")));
}

/// A body in a snug slot: the wedge force is any number.
#[test]
fn the_wedge_force_in_a_snug_slot_has_no_greatest_value() {
    let all = instances();
    let snug = all.iter().find(|instance| instance.name == "st_snug_8").unwrap();
    let Enumeration::Complete(solutions) = enumerate(&snug.lcp, 1000) else { panic!() };
    let range = solutions.range(0).unwrap();
    assert!(range.min.is_zero() && range.max.is_none());
    assert_eq!(solutions.count(), Count::Continuum);
}
