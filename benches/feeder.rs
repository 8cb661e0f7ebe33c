//! Design of feeders, `cargo bench --bench feeder`: evaluations a second on one thread and on two, how many seeds find a design
//! that passes, and the same evaluations spent by COBYLA and by chance.

use cobyla::{RhoBeg, minimize};
use partplan::answer::FeederPlan;
use partplan::case::{Limits, read_feeder};
use partplan::design::{Journal, Score, Scoring, SearchOptions, design};
use partplan::model::Feeder;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng as _, SeedableRng as _};
use std::cell::RefCell;
use std::time::Instant;

const EVALUATIONS: usize = 1_000;
const SEEDS: u64 = 10;

/// Remembers nothing.
struct Nothing;

impl Journal for Nothing {
    fn known(&self, _: &[f64]) -> Option<Score> {
        None
    }

    fn add(&self, _: &[f64], _: Score, _: usize) -> bool {
        true
    }
}

fn main() {
    let path = format!("{}/cases/feeder.json", env!("CARGO_MANIFEST_DIR"));
    let feeder = read_feeder(&std::fs::read(path).expect("a case"), &Limits::default()).expect("a valid case").feeder;
    let [one, two] = [1, 2].map(|threads| rate(&feeder, threads));
    println!("evaluations a second: {one:.0} on one thread, {two:.0} on two ({:.2}x)\n", two / one);
    println!("| search | seeds that pass | best score, median (from .. to) |");
    println!("|---|---|---|");
    let evolution = |seed: u64| {
        let found = searched(&feeder, seed);
        let passing = found.trace.iter().filter(|evaluation| evaluation.passes).map(|evaluation| evaluation.cost);
        found.best.is_some().then(|| passing.fold(f64::INFINITY, f64::min))
    };
    row("CMA-ES", &evolution);
    row("COBYLA", &|seed| cobyla(&feeder, seed));
    row("chance", &|seed| chance(&feeder, seed));
}

fn searched(feeder: &Feeder, seed: u64) -> FeederPlan {
    design(feeder, &options(seed), &Nothing)
}

fn options(seed: u64) -> SearchOptions {
    SearchOptions { evaluations: EVALUATIONS, seed, worst: false, draws: 0 }
}

fn rate(feeder: &Feeder, threads: usize) -> f64 {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
    let start = Instant::now();
    let found = pool.install(|| searched(feeder, 1));
    found.trace.len() as f64 / start.elapsed().as_secs_f64()
}

/// One line of the table; a search gives the best score of a design that passes.
fn row(name: &str, search: &dyn Fn(u64) -> Option<f64>) {
    let mut costs: Vec<f64> = (0..SEEDS).filter_map(search).collect();
    costs.sort_by(f64::total_cmp);
    let cost = match costs[..] {
        [] => "none".to_owned(),
        _ => format!("{:.3} ({:.3} .. {:.3})", costs[costs.len() / 2], costs[0], costs[costs.len() - 1]),
    };
    println!("| {name} | {} of {SEEDS} | {cost} |", costs.len());
}

/// A place in the unit box as a design.
fn scaled(feeder: &Feeder, point: &[f64]) -> Vec<f64> {
    let scale = |(share, variable): (&f64, &partplan::model::Variable)| {
        variable.low + share.clamp(0.0, 1.0) * (variable.high - variable.low)
    };
    point.iter().zip(&feeder.variables).map(scale).collect()
}

/// From the first design, by linear approximations; the seed moves the start by a hundredth.
fn cobyla(feeder: &Feeder, seed: u64) -> Option<f64> {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let start = feeder.variables.iter().map(|variable| {
        let share = (variable.start - variable.low) / (variable.high - variable.low);
        (share + 0.01 * (unit(&mut random) - 0.5)).clamp(0.0, 1.0)
    });
    let start: Vec<f64> = start.collect();
    let options = options(seed);
    let (best, scoring) = (RefCell::new(f64::INFINITY), Scoring::new(feeder, &options));
    let objective = |x: &[f64], (): &mut ()| {
        let found = scoring.score(&scaled(feeder, x));
        if found.passes {
            best.replace_with(|best| best.min(found.cost));
        }
        found.cost
    };
    let bounds = vec![(0.0, 1.0); start.len()];
    let none: [fn(&[f64], &mut ()) -> f64; 0] = [];
    let _ = minimize(objective, &start, &bounds, &none, (), EVALUATIONS, RhoBeg::All(0.25), None);
    Some(best.into_inner()).filter(|best| best.is_finite())
}

/// Places all over the box.
fn chance(feeder: &Feeder, seed: u64) -> Option<f64> {
    let (mut random, options) = (ChaCha8Rng::seed_from_u64(seed), options(seed));
    let scoring = Scoring::new(feeder, &options);
    let tries = (0..EVALUATIONS).map(|_| {
        let point: Vec<f64> = feeder.variables.iter().map(|_| unit(&mut random)).collect();
        scoring.score(&scaled(feeder, &point))
    });
    tries.filter(|score| score.passes).map(|score| score.cost).min_by(f64::total_cmp)
}

fn unit(random: &mut ChaCha8Rng) -> f64 {
    (random.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
}
