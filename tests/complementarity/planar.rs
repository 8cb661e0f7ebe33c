//! Twenty thousand contact problems, each answer verified from the factors.

use crate::check::violation;
use crate::contacts::{Family, Random, draw, is_always_solvable};
use partplan::complementarity::{ACCEPTED_RESIDUAL, Lcp, Limits, Rung, Solver, Verdict};

const FAMILIES: [(Family, usize); 8] = [
    (Family::Generic { from: 1, to: 4 }, 11_400),
    (Family::Generic { from: 5, to: 12 }, 2500),
    (Family::Resting, 3500),
    (Family::Stack { ratio: 1.0 }, 1760),
    (Family::Stack { ratio: 1e3 }, 150),
    (Family::Stack { ratio: 1e6 }, 50),
    (Family::Wild { overlaps: false }, 600),
    (Family::Wild { overlaps: true }, 40),
];

/// Every answer is right to the accepted residual, computed from the factors with twice the digits, whichever rung gave
/// it; exact answers satisfy the problem exactly; and problems without overlaps are always solved.
#[test]
fn no_answer_is_unverified() {
    let mut total = 0;
    for (family, count) in FAMILIES {
        let mut random = Random(20_000 + count as u64);
        let mut solver = Solver::with_limits(Limits { cases: 0, ..Limits::default() });
        let mut m = Vec::new();
        let mut rungs = [0; Rung::ALL.len()];
        let (mut none, mut undecided) = (0, 0);
        for index in 0..count {
            let problem = draw(family, &mut random);
            let factors = problem.factors();
            factors.assemble(&mut m).unwrap();
            match solver.solve(Lcp { m: &m, q: &problem.q }, None, &|| factors.to_exact()).unwrap() {
                Verdict::Solved(solution) => {
                    let found = violation(&problem, solution.z);
                    if let Some(z) = solution.exact {
                        assert!(factors.to_exact().unwrap().is_solution(z), "{family:?} {index}");
                    } else {
                        assert!(found <= ACCEPTED_RESIDUAL, "{family:?} {index}: {found:e} on {:?}", solution.rung);
                    }
                    rungs[solution.rung as usize] += 1;
                }
                Verdict::NoSolution(_) => none += 1,
                Verdict::Undecided(_) => undecided += 1,
            }
            total += 1;
        }
        println!("{family:?}: {rungs:?} by rung, {none} without a solution, {undecided} undecided");
        if is_always_solvable(family) {
            assert_eq!(none + undecided, 0, "{family:?}");
        }
    }
    assert_eq!(total, 20_000);
}

/// The check above can fail: an impulse that is off is seen.
#[test]
fn a_wrong_impulse_is_seen() {
    let mut random = Random(3);
    let mut m = Vec::new();
    let mut solver = Solver::default();
    let mut seen = 0;
    for _ in 0..50 {
        let problem = draw(Family::Generic { from: 2, to: 4 }, &mut random);
        problem.factors().assemble(&mut m).unwrap();
        let lcp = Lcp { m: &m, q: &problem.q };
        let Verdict::Solved(solution) = solver.solve(lcp, None, &|| problem.factors().to_exact()).unwrap() else {
            panic!("gaps are not negative")
        };
        let mut z = solution.z.to_vec();
        let Some(largest) = (0..problem.mu.len()).max_by(|a, b| z[*a].total_cmp(&z[*b])).filter(|i| z[*i] > 0.0) else {
            continue;
        };
        z[largest] *= 1.001;
        assert!(violation(&problem, &z) > 1e-6);
        assert!(!lcp.residual(&z).is_accepted());
        seen += 1;
    }
    assert!(seen > 20);
}
