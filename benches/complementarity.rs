//! Contact problems by the million, `cargo bench --bench complementarity`: who answers them, how surely and how fast.
//!
//! `LCP_PROBLEMS` says how many, 1,000,000 if it is not set; `LCP_FAMILY` picks one row of the first table.

#[path = "../tests/complementarity/check.rs"]
mod check;

use check::{proof_holds, violation};
use contacts::{Family, Problem, Random, draw, is_always_solvable};
use partplan::chart::contacts;
use partplan::complementarity::{ACCEPTED_RESIDUAL, Basis, Lcp, Limits, Rung, Solver, Verdict};
use std::hint::black_box;
use std::time::Instant;

/// Name, family, and how many of a thousand problems.
const FAMILIES: [(&str, Family, usize); 9] = [
    ("planar, 1-4 contacts", Family::Generic { from: 1, to: 4 }, 547),
    ("planar, 5-12 contacts", Family::Generic { from: 5, to: 12 }, 150),
    ("resting, 2-12 contacts", Family::Resting, 150),
    ("stacks of 2-6, ratio 1", Family::Stack { ratio: 1.0 }, 70),
    ("stacks of 2-6, ratio 10^3", Family::Stack { ratio: 1e3 }, 40),
    ("stacks of 2-6, ratio 10^6", Family::Stack { ratio: 1e6 }, 36),
    ("wild, 1-12 contacts", Family::Wild { overlaps: false }, 5),
    ("wild with overlaps", Family::Wild { overlaps: true }, 1),
    ("squeeze, 2-4 contacts", Family::Squeeze, 1),
];

fn main() {
    let setting = |name: &str| std::env::var(name).ok().and_then(|text| text.parse::<usize>().ok());
    let problems = setting("LCP_PROBLEMS").unwrap_or(1_000_000);
    println!("| family | problems | failures | unverified | no solution | undecided | rungs | exact | median | p99 |");
    println!("|---|---|---|---|---|---|---|---|---|---|");
    for (at, (name, family, share)) in FAMILIES.into_iter().enumerate() {
        if setting("LCP_FAMILY").is_none_or(|only| only == at) {
            robustness(name, family, (problems * share / 1000).max(1));
        }
    }
    if setting("LCP_FAMILY").is_none() {
        speed();
        arbiter();
    }
}

/// One row: who answered, and whether the answers hold when computed from the factors with twice the digits.
fn robustness(name: &str, family: Family, count: usize) {
    let mut random = Random(7);
    let mut solver = Solver::default();
    let mut m = Vec::new();
    let mut rungs = [0_usize; Rung::ALL.len()];
    let (mut failures, mut unverified, mut none, mut undecided) = (0, 0, 0, 0);
    let (mut times, mut exact_times) = (Vec::with_capacity(count), Vec::new());
    for _ in 0..count {
        let problem = draw(family, &mut random);
        let factors = problem.factors();
        factors.assemble(&mut m).expect("finite factors");
        let start = Instant::now();
        let verdict = solver.solve(Lcp { m: &m, q: &problem.q }, None, &|| factors.to_exact()).expect("a shape");
        let time = start.elapsed().as_secs_f64();
        times.push(time);
        let is_exact = match verdict {
            Verdict::Solved(solution) => {
                rungs[solution.rung as usize] += 1;
                let holds = match solution.exact {
                    Some(z) => factors.to_exact().expect("finite factors").is_solution(z),
                    None => violation(&problem, solution.z) <= ACCEPTED_RESIDUAL,
                };
                unverified += usize::from(!holds);
                solution.exact.is_some()
            }
            Verdict::NoSolution(proof) => {
                none += 1;
                unverified += usize::from(!proof_holds(&factors.to_exact().expect("finite factors"), &proof));
                failures += usize::from(is_always_solvable(family));
                true
            }
            Verdict::Undecided(_) => {
                undecided += 1;
                failures += usize::from(is_always_solvable(family));
                true
            }
        };
        if is_exact {
            exact_times.push(time);
        }
    }
    let mut shares = String::new();
    for (rung, answered) in Rung::ALL.iter().zip(rungs).filter(|(_, answered)| *answered > 0) {
        shares += &format!("{rung:?} {:.4} % ", 100.0 * answered as f64 / count as f64);
    }
    let exact = match exact_times.len() {
        0 => "0".to_owned(),
        some => format!(
            "{some}: {:.2} ms, p99 {:.1}",
            1e3 * quantile(&mut exact_times, 0.5),
            1e3 * quantile(&mut exact_times, 0.99)
        ),
    };
    let [median, late] = [0.5, 0.99].map(|part| 1e6 * quantile(&mut times, part));
    println!(
        "| {name} | {count} | {failures} | {unverified} | {none} | {undecided} | {shares}| {exact} | {median:.2} µs | {late:.1} µs |"
    );
}

fn quantile(values: &mut [f64], part: f64) -> f64 {
    values.sort_by(f64::total_cmp);
    values[((values.len() - 1) as f64 * part) as usize]
}

/// Time of one solve, cold and from the last basis.
fn speed() {
    println!("\n| contacts | n | cold | warm |");
    println!("|---|---|---|---|");
    for contacts in [1, 2, 4, 8, 12] {
        let mut random = Random(9);
        let problems: Vec<(Problem, Vec<f64>)> = (0..200)
            .map(|_| {
                let problem = draw(Family::Generic { from: contacts, to: contacts }, &mut random);
                let mut m = Vec::new();
                problem.factors().assemble(&mut m).expect("finite factors");
                (problem, m)
            })
            .collect();
        let mut solver = Solver::default();
        let mut solve = |problem: &(Problem, Vec<f64>), warm: Option<&Basis>| {
            let lcp = Lcp { m: &problem.1, q: &problem.0.q };
            match black_box(solver.solve(lcp, warm, &|| problem.0.factors().to_exact())).expect("a shape") {
                Verdict::Solved(solution) => (solution.basis.clone(), solution.rung),
                other => panic!("gaps are not negative: {other:?}"),
            }
        };
        let bases: Vec<Basis> = problems.iter().map(|problem| solve(problem, None).0).collect();
        let mut fastest = [f64::INFINITY; 2];
        for _ in 0..50 {
            let start = Instant::now();
            problems.iter().for_each(|problem| drop(black_box(solve(problem, None))));
            let cold = start.elapsed().as_secs_f64();
            let start = Instant::now();
            problems.iter().zip(&bases).for_each(|(problem, basis)| drop(black_box(solve(problem, Some(basis)))));
            let warm = start.elapsed().as_secs_f64();
            fastest = [fastest[0].min(cold), fastest[1].min(warm)];
        }
        let warm = problems.iter().zip(&bases).filter(|(problem, basis)| solve(problem, Some(basis)).1 <= Rung::Warm);
        let warm = warm.count() as f64 / 2.0;
        let [cold, hot] = fastest.map(|time| 1e6 * time / 200.0);
        println!("| {contacts} | {} | {cold:.3} µs | {hot:.3} µs, {warm:.1} % from the basis |", 4 * contacts);
    }
}

/// Time of Lemke's method in integers, without a proposal from doubles, **M** assembled from the factors included.
fn arbiter() {
    println!("\n| problems | answered | median | p99 |");
    println!("|---|---|---|---|");
    for (family, name) in [
        (Family::Generic { from: 1, to: 4 }, "1-4 contacts, n <= 16"),
        (Family::Generic { from: 4, to: 4 }, "4 contacts, n = 16"),
        (Family::Generic { from: 8, to: 8 }, "8 contacts, n = 32"),
        (Family::Stack { ratio: 1e6 }, "stacks, ratio 10^6, n <= 48"),
    ] {
        let mut random = Random(13);
        // a grip that rounding of q has closed ends in a ray and is left to the cases
        let mut solver = Solver::with_limits(Limits { first: Rung::Exact, cases: 0, ..Limits::default() });
        let mut m = Vec::new();
        let mut times = Vec::new();
        for _ in 0..200 {
            let problem = draw(family, &mut random);
            problem.factors().assemble(&mut m).expect("finite factors");
            let start = Instant::now();
            let lcp = Lcp { m: &m, q: &problem.q };
            let verdict = black_box(solver.solve(lcp, None, &|| problem.factors().to_exact())).expect("a shape");
            if let Verdict::Solved(_) = verdict {
                times.push(start.elapsed().as_secs_f64());
            }
        }
        let [median, late] = [0.5, 0.99].map(|part| 1e3 * quantile(&mut times, part));
        println!("| {name} | {} of 200 | {median:.2} ms | {late:.2} ms |", times.len());
    }
}
