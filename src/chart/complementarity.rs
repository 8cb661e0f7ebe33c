//! Contact problems: who answers them, how well and how fast.

use super::contacts::{Family, Problem, Random, draw};
use super::gauss_seidel::swept;
use super::measure::{Curve, Measure, Outcome};
use crate::answer::ChartFamily;
use crate::complementarity::{ACCEPTED_RESIDUAL, Lcp, LcpError, Limits, Rung, Solver, Verdict};

/// Families by name, and how many problems of each, in a quick and in a whole chart.
const WORK: [(&str, Family, [usize; 2]); 5] = [
    ("planar, 1 to 4 contacts", Family::Generic { from: 1, to: 4 }, [100, 1000]),
    ("resting on up to 12 contacts", Family::Resting, [50, 300]),
    ("stacks, ratio 1000", Family::Stack { ratio: 1e3 }, [50, 300]),
    ("stacks, ratio 1000000", Family::Stack { ratio: 1e6 }, [20, 100]),
    ("squeezed, without solution", Family::Squeeze, [50, 300]),
];

/// Sweeps of Gauss-Seidel.
const SWEEPS: [usize; 4] = [10, 100, 1_000, 10_000];

/// How a problem is answered.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Method {
    /// Lemke's method in doubles, alone.
    Lemke,
    /// All methods in doubles.
    Doubles,
    /// Those, and integers where they fail.
    Ladder,
    /// Integers from the start.
    Exact,
    /// Sweeps of projected Gauss-Seidel.
    GaussSeidel(usize),
}

pub(super) fn measure(measure: &mut Measure) {
    for (work, family, counts) in WORK {
        if !measure.wants(&[ChartFamily::Complementarity.name(), work]) {
            continue;
        }
        let problems = problems(family, measure.pick(counts[0], counts[1]), measure.question.seed);
        let mut point = |method: &str, setting: &str, how: Method, problems: &[(Problem, Vec<f64>)]| {
            let curve = Curve { family: ChartFamily::Complementarity, work, method };
            measure.point(curve, setting, problems.len() as u64, |_| answered(how, problems));
        };
        point("Lemke, doubles", "alone", Method::Lemke, &problems);
        point("ladder, doubles", "5 methods", Method::Doubles, &problems);
        point("ladder to integers", "default", Method::Ladder, &problems);
        point("integers", "from the start", Method::Exact, &problems[..problems.len().div_ceil(10)]);
        for sweeps in SWEEPS {
            let few = if sweeps > 1_000 { &problems[..problems.len().div_ceil(10)] } else { &problems };
            point("Gauss-Seidel", &format!("{sweeps} sweeps"), Method::GaussSeidel(sweeps), few);
        }
    }
}

/// Problems with their matrices.
pub(super) fn problems(family: Family, count: usize, seed: u64) -> Vec<(Problem, Vec<f64>)> {
    let mut random = Random(seed.wrapping_add(7));
    let all = (0..count).filter_map(|_| {
        let problem = draw(family, &mut random);
        let mut m = Vec::new();
        problem.factors().assemble(&mut m).ok()?;
        Some((problem, m))
    });
    all.collect()
}

/// The median residual of the answers, and how many are none or wrong.
pub(super) fn answered(method: Method, problems: &[(Problem, Vec<f64>)]) -> Outcome {
    let first = if method == Method::Exact { Rung::Exact } else { Rung::Free };
    let mut solver = Solver::with_limits(Limits { first, ..Limits::default() });
    let mut residuals: Vec<f64> = Vec::with_capacity(problems.len());
    let mut failed = 0;
    for (problem, m) in problems {
        match residual(method, &mut solver, problem, m) {
            Some(residual) => {
                failed += u64::from(residual.is_nan() || residual > ACCEPTED_RESIDUAL);
                residuals.push(residual);
            }
            None => failed += 1,
        }
    }
    residuals.sort_by(f64::total_cmp);
    let middle = residuals.len().saturating_sub(1) / 2;
    Outcome { error: residuals.get(middle).copied(), failed, of: problems.len() as u64 }
}

/// Of an answer, zero where it is exact or a proof that there is none; `None` for no answer.
fn residual(method: Method, solver: &mut Solver, problem: &Problem, m: &[f64]) -> Option<f64> {
    let lcp = Lcp { m, q: &problem.q };
    let factors = problem.factors();
    if let Method::GaussSeidel(sweeps) = method {
        return Some(lcp.residual(&swept(&factors, sweeps)).bound);
    }
    let is_exact = matches!(method, Method::Ladder | Method::Exact);
    let exact = || if is_exact { factors.to_exact() } else { Err(LcpError::NotFinite) };
    match solver.solve(lcp, None, &exact).ok()? {
        Verdict::Solved(solution) if method == Method::Lemke && solution.rung > Rung::Lemke => None,
        Verdict::Solved(solution) if solution.exact.is_some() => Some(0.0),
        Verdict::Solved(solution) => Some(solution.residual),
        Verdict::NoSolution(_) => Some(0.0),
        Verdict::Undecided(_) => None,
    }
}
