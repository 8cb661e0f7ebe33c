//! Contact problems by the million, `cargo bench --bench complementarity`: which rung answers, and how fast.
//!
//! `LCP_PROBLEMS` sets how many; 1,000,000 by default.

#[path = "../tests/complementarity/contacts.rs"]
mod contacts;

use contacts::{Family, Random, draw, is_always_solvable};
use partplan::complementarity::{Lcp, Rung, Solver, Verdict};
use std::time::Instant;

const FAMILIES: [(&str, Family, usize); 8] = [
    ("planar, 1-4 contacts", Family::Generic { from: 1, to: 4 }, 500),
    ("planar, 5-12 contacts", Family::Generic { from: 5, to: 12 }, 150),
    ("resting, 2-12 contacts", Family::Resting, 150),
    ("stacks of 2-6, ratio 1", Family::Stack { ratio: 1.0 }, 60),
    ("stacks of 2-6, ratio 10^3", Family::Stack { ratio: 1e3 }, 60),
    ("stacks of 2-6, ratio 10^6", Family::Stack { ratio: 1e6 }, 40),
    ("wild, 1-12 contacts", Family::Wild, 30),
    ("squeeze, 2-4 contacts", Family::Squeeze, 10),
];

fn main() {
    let problems = std::env::var("LCP_PROBLEMS").ok().and_then(|text| text.parse().ok()).unwrap_or(1_000_000);
    let only: Option<usize> = std::env::var("LCP_FAMILY").ok().and_then(|text| text.parse().ok());
    for (at, (name, family, share)) in FAMILIES.into_iter().enumerate() {
        if only.is_some_and(|only| only != at) {
            continue;
        }
        robustness(name, family, (problems * share / 1000).max(1));
    }
}

fn robustness(name: &str, family: Family, count: usize) {
    let mut random = Random(7);
    let mut solver = Solver::with_limits(partplan::complementarity::Limits {
        cases: std::env::var("LCP_CASES").ok().and_then(|t| t.parse().ok()).unwrap_or(4096),
        ..Default::default()
    });
    let mut m = Vec::new();
    let mut rungs = [0_usize; 9];
    let mut none = 0;
    let mut undecided = 0;
    let mut times = Vec::with_capacity(count);
    for _ in 0..count {
        let problem = draw(family, &mut random);
        let factors = problem.factors();
        factors.assemble(&mut m).expect("finite factors");
        let lcp = Lcp { m: &m, q: &problem.q };
        let start = Instant::now();
        let verdict = solver.solve(lcp, None, &|| factors.to_exact());
        times.push(start.elapsed().as_secs_f64());
        if start.elapsed().as_secs_f64() > 0.3 {
            println!("slow {:.2} s n {}", start.elapsed().as_secs_f64(), problem.q.len());
        }
        match verdict.expect("a problem with a shape") {
            Verdict::Solved(solution) => rungs[solution.rung as usize] += 1,
            Verdict::NoSolution(_) => none += 1,
            Verdict::Undecided(_) => undecided += 1,
        }
    }
    times.sort_by(f64::total_cmp);
    println!(
        "{name} (always solvable: {}): {count}, none {none}, undecided {undecided}, {:.2} µs, p99 {:.2}",
        is_always_solvable(family),
        times[count / 2] * 1e6,
        times[count * 99 / 100] * 1e6
    );
    for (rung, count) in Rung::ALL.iter().zip(rungs).filter(|(_, count)| *count > 0) {
        println!("    {rung:?} {count}");
    }
}
