//! The rungs one by one, limits, bad input, and what does not depend on history.

use crate::check::violation;
use crate::contacts::{Family, Problem, Random, draw};
use partplan::complementarity::{
    ACCEPTED_RESIDUAL, Basis, ExactLcp, Factors, Lcp, LcpError, Limits, Rung, Solver, Undecided, Verdict,
};
use partplan::exact::ratio;

fn problems(family: Family, count: usize) -> impl Iterator<Item = (Problem, Vec<f64>)> {
    let mut random = Random(5);
    (0..count).map(move |_| {
        let problem = draw(family, &mut random);
        let mut m = Vec::new();
        problem.factors().assemble(&mut m).unwrap();
        (problem, m)
    })
}

#[test]
fn every_rung_can_be_the_first() {
    for first in Rung::ALL.into_iter().filter(|rung| *rung < Rung::Cases) {
        let mut solver = Solver::with_limits(Limits { first, ..Limits::default() });
        let mut used = 0;
        for (problem, m) in problems(Family::Generic { from: 1, to: 3 }, 60) {
            let lcp = Lcp { m: &m, q: &problem.q };
            let Verdict::Solved(solution) = solver.solve(lcp, None, &|| problem.factors().to_exact()).unwrap() else {
                panic!("gaps are not negative")
            };
            assert!(solution.rung >= first);
            assert!(violation(&problem, solution.z) <= ACCEPTED_RESIDUAL, "{first:?}");
            used += usize::from(solution.rung == first);
        }
        // the first two need a friction-free right side or a basis
        assert!(used > 0 || first <= Rung::Warm, "{first:?} answers nothing");
    }
}

/// The same contacts a moment later: the last basis answers.
#[test]
fn a_warm_start_answers_the_next_step() {
    let mut solver = Solver::default();
    let mut warm = 0;
    for (problem, m) in problems(Family::Generic { from: 1, to: 6 }, 200) {
        let exact = || problem.factors().to_exact();
        let Verdict::Solved(solution) = solver.solve(Lcp { m: &m, q: &problem.q }, None, &exact).unwrap() else {
            panic!("gaps are not negative")
        };
        let basis = solution.basis.clone();
        let mut next = problem.clone();
        next.q.iter_mut().for_each(|value| *value *= 1.0 + 1e-6);
        let again = solver.solve(Lcp { m: &m, q: &next.q }, Some(&basis), &|| next.factors().to_exact()).unwrap();
        let Verdict::Solved(solution) = again else { panic!("gaps are not negative") };
        assert!(violation(&next, solution.z) <= ACCEPTED_RESIDUAL);
        warm += usize::from(solution.rung <= Rung::Warm);
    }
    assert!(warm >= 195, "{warm} of 200");
}

/// A basis that does not fit, of whatever kind, costs time and nothing else.
#[test]
fn a_wrong_basis_does_no_harm() {
    let mut solver = Solver::default();
    for (problem, m) in problems(Family::Generic { from: 1, to: 3 }, 100) {
        let n = problem.q.len();
        for basis in [Basis::new(n), Basis::with(n, 0..n), Basis::with(n, [n - 1]), Basis::new(n + 1)] {
            let lcp = Lcp { m: &m, q: &problem.q };
            let verdict = solver.solve(lcp, Some(&basis), &|| problem.factors().to_exact()).unwrap();
            let Verdict::Solved(solution) = verdict else { panic!("gaps are not negative") };
            assert!(violation(&problem, solution.z) <= ACCEPTED_RESIDUAL);
        }
    }
}

/// A reused solver and a new one give the same bits, and faster time scales the impulses by exactly as much.
#[test]
fn answers_depend_on_the_problem_alone() {
    let mut reused = Solver::default();
    for (problem, m) in problems(Family::Generic { from: 1, to: 8 }, 200) {
        let exact = || problem.factors().to_exact();
        let lcp = Lcp { m: &m, q: &problem.q };
        let mut fresh = Solver::default();
        let first = reused.solve(lcp, None, &exact).unwrap();
        assert_eq!(first, fresh.solve(lcp, None, &exact).unwrap());
        let Verdict::Solved(first) = first else { panic!("gaps are not negative") };
        let faster: Vec<f64> = problem.q.iter().map(|value| value * 1024.0).collect();
        let verdict = fresh.solve(Lcp { m: &m, q: &faster }, None, &exact).unwrap();
        let Verdict::Solved(second) = verdict else { panic!("gaps are not negative") };
        assert!(first.z.iter().zip(second.z).all(|(a, b)| a * 1024.0 == *b));
    }
}

/// Units of mass: the residual of the same motion is the same.
#[test]
fn the_residual_has_no_unit() {
    for (problem, m) in problems(Family::Generic { from: 1, to: 4 }, 50) {
        let mut heavy = problem.clone();
        heavy.inverse_mass.iter_mut().for_each(|value| *value /= 4096.0);
        let mut heavy_m = Vec::new();
        heavy.factors().assemble(&mut heavy_m).unwrap();
        let impulses = problem.factors().impulses();
        let z: Vec<f64> = (0..problem.q.len()).map(|i| 0.01 * (i as f64 + 1.0)).collect();
        let mut heavy_z = z.clone();
        heavy_z[..impulses].iter_mut().for_each(|value| *value *= 4096.0);
        let one = Lcp { m: &m, q: &problem.q }.residual(&z);
        assert_eq!(one, Lcp { m: &heavy_m, q: &heavy.q }.residual(&heavy_z));
        assert!(one.violation > 1e-3);
    }
}

#[test]
fn bad_input_is_an_error() {
    let mut solver = Solver::default();
    let never = || -> Result<ExactLcp, LcpError> { panic!("not asked for") };
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let (m, q) = ([1.0, 0.0, bad, 1.0], [-1.0, 1.0]);
        assert_eq!(solver.solve(Lcp { m: &m, q: &q }, None, &never), Err(LcpError::NotFinite));
        assert_eq!(solver.solve(Lcp { m: &[1.0], q: &[bad] }, None, &never), Err(LcpError::NotFinite));
    }
    let shape = LcpError::Shape { entries: 3, size: 2 };
    assert_eq!(solver.solve(Lcp { m: &[1.0; 3], q: &[1.0; 2] }, None, &never), Err(shape));
    let other = || ExactLcp::new(vec![vec![ratio(1, 1)]], vec![ratio(-1, 1)]);
    let lcp = Lcp { m: &[0.0, 0.0, 0.0, 0.0], q: &[-1.0, -1.0] };
    assert_eq!(solver.solve(lcp, None, &other), Err(LcpError::Sizes { exact: 1, doubles: 2 }));
    let factors = Factors { jacobian: &[1.0; 5], inverse_mass: &[1.0; 3], mu: &[0.5], directions: 2, q: &[0.0; 4] };
    let wanted = LcpError::Factor { what: "the jacobian", found: 5, expected: 9 };
    assert_eq!(factors.assemble(&mut Vec::new()), Err(wanted));
    assert_eq!(factors.to_exact(), Err(wanted));
    let five = Factors { q: &[0.0; 5], jacobian: &[1.0; 9], ..factors };
    assert!(matches!(five.to_exact(), Err(LcpError::Factor { what: "q", .. })));
}

/// The problem without variables is solved, and so are entries at the ends of the range of doubles.
#[test]
fn extreme_problems_end() {
    let mut solver = Solver::default();
    let empty = solver.solve(Lcp { m: &[], q: &[] }, None, &|| panic!("not asked for")).unwrap();
    assert!(matches!(empty, Verdict::Solved(solution) if solution.z.is_empty()));
    for value in [f64::MAX, f64::MIN_POSITIVE, 5e-324, 1e300, 1e-300] {
        let (m, q) = ([value, 0.0, 0.0, 1.0], [-1.0, -value]);
        let lcp = Lcp { m: &m, q: &q };
        let verdict = solver.solve(lcp, None, &|| ExactLcp::from_floats(lcp)).unwrap();
        let Verdict::Solved(solution) = verdict else { panic!("{value:e}: {verdict:?}") };
        let exact = ExactLcp::from_floats(lcp).unwrap();
        assert!(solution.exact.is_none_or(|z| exact.is_solution(z)), "{value:e}");
    }
}

#[test]
fn limits_are_named() {
    let limits = Limits { first: Rung::Exact, exact_pivots: 1, ..Limits::default() };
    let lcp = Lcp { m: &[2.0, 1.0, 1.0, 2.0], q: &[-5.0, -6.0] };
    let mut solver = Solver::with_limits(limits);
    let verdict = solver.solve(lcp, None, &|| ExactLcp::from_floats(lcp)).unwrap();
    assert_eq!(verdict, Verdict::Undecided(Undecided::Pivots(1)));
    // one pivot for each variable is not enough for Lemke's method, and a later rung takes over
    let mut hurried = Solver::with_limits(Limits { pivots_per_variable: 1, ..Limits::default() });
    let verdict = hurried.solve(lcp, None, &|| ExactLcp::from_floats(lcp)).unwrap();
    assert!(matches!(verdict, Verdict::Solved(solution) if solution.rung == Rung::Newton));
}

/// Six blocks, the top one a million times heavier: the impulses carry it, to the last digit where it takes integers.
#[test]
fn a_heavy_block_on_light_ones_is_carried() {
    let mut solver = Solver::default();
    for (problem, m) in problems(Family::Stack { ratio: 1e6 }, 20) {
        let exact = || problem.factors().to_exact();
        let Verdict::Solved(solution) = solver.solve(Lcp { m: &m, q: &problem.q }, None, &exact).unwrap() else {
            panic!("gaps are not negative")
        };
        match solution.exact {
            Some(z) => assert!(exact().unwrap().is_solution(z)),
            None => assert!(violation(&problem, solution.z) <= ACCEPTED_RESIDUAL),
        }
    }
}

/// Without friction directions a contact problem is its normal impulses.
#[test]
fn frictionless_contacts_are_problems_too() {
    let jacobian = [0.0, 1.0, -0.5, 0.0, 1.0, 0.5];
    let factors =
        Factors { jacobian: &jacobian, inverse_mass: &[1.0, 1.0, 3.0], mu: &[], directions: 0, q: &[-1.0; 2] };
    let mut m = Vec::new();
    factors.assemble(&mut m).unwrap();
    assert_eq!(m, [1.75, 0.25, 0.25, 1.75]);
    let mut solver = Solver::default();
    let Verdict::Solved(solution) = solver.solve(Lcp { m: &m, q: factors.q }, None, &|| factors.to_exact()).unwrap()
    else {
        panic!("it rests")
    };
    assert!(solution.z.iter().all(|p| (p - 0.5).abs() < 1e-15));
    assert_eq!(factors.to_exact().unwrap().m()[0], [ratio(7, 4), ratio(1, 4)]);
}
