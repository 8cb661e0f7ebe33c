//! The search for dimensions: an evolution strategy over the unit box, its evaluations screened by a coarse step.

use super::objective::evaluated;
use super::score::{Score, Scoring, SearchOptions};
use crate::answer::{Evaluation, FeederPlan};
use crate::dynamics::ModelKind;
use crate::model::Feeder;
use cmaes::{CMAES, CMAESOptions, DVector};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// Designs of a generation, and the first spread of the search over the ranges of the variables.
const POPULATION: usize = 14;
const SPREAD: f64 = 0.25;

/// Spread after the strategy has converged and begins again at the best design.
const AGAIN: f64 = 0.1;

/// Cost of leaving the bounds, for each squared share of the range.
const OUTSIDE: f64 = 10.0;

/// Designs whose checks are tried, best first.
const CANDIDATES: usize = 24;

/// Remembers scores, so that a search that was killed goes on where it was.
pub trait Journal: Sync {
    /// The score of a design, if it is known.
    fn known(&self, variables: &[f64]) -> Option<Score>;

    /// Takes down a score and how many evaluations are done; the search ends on `false`.
    fn add(&self, variables: &[f64], score: Score, done: usize) -> bool;
}

/// Searches the dimensions of a device.
///
/// The same options give the same answer, bit by bit, on any number of threads.
pub fn design(feeder: &Feeder, options: &SearchOptions, journal: &dyn Journal) -> FeederPlan {
    let search = Search {
        feeder,
        options,
        journal,
        scoring: Scoring::new(feeder, options),
        is_over: AtomicBool::new(false),
        done: AtomicUsize::new(0),
        generation: Mutex::new(Vec::new()),
    };
    let nominal = feeder.nominal();
    let start = evaluated(feeder, &feeder.start(), &nominal, ModelKind::StewartTrinkle, None);
    let seen = search.seen();
    let trace = seen.iter().map(|(_, Score { cost, passes })| Evaluation { cost: *cost, passes: *passes }).collect();
    let mut passing: Vec<&(Vec<f64>, Score)> = seen.iter().filter(|(_, score)| score.passes).collect();
    passing.sort_by(|a, b| a.1.cost.total_cmp(&b.1.cost));
    passing.dedup_by(|a, b| a.0 == b.0);
    let (mut fragile, mut found) = (0, None);
    for (variables, _) in passing.into_iter().take(CANDIDATES) {
        let checks = search.scoring.checks(variables);
        let passes =
            |model: &str| checks.iter().filter(|check| check.model == model).all(|check| check.design.passes());
        if !passes("st") {
            fragile += 1;
            continue;
        }
        // one that also passes where surfaces give way is better, but surfaces may be said to give way as no real ones do
        let is_best = passes("spk");
        if is_best || found.is_none() {
            found = Some((variables, checks));
        }
        if is_best {
            break;
        }
    }
    let designed = |variables: &Vec<f64>| evaluated(feeder, variables, &nominal, ModelKind::StewartTrinkle, None);
    let best = found.as_ref().map(|(variables, _)| designed(variables));
    let checks = found.map(|(_, checks)| checks).unwrap_or_default();
    FeederPlan { start, best, checks, trace, fragile, robust: None, limit: None }
}

struct Search<'a> {
    feeder: &'a Feeder,
    options: &'a SearchOptions,
    journal: &'a dyn Journal,
    scoring: Scoring<'a>,
    is_over: AtomicBool,
    done: AtomicUsize,
    /// Designs of this generation, in the order in which they were done.
    generation: Mutex<Vec<(Vec<f64>, Score)>>,
}

impl Search<'_> {
    /// All designs looked at, those of a generation by their cost.
    fn seen(&self) -> Vec<(Vec<f64>, Score)> {
        let objective = |x: &DVector<f64>| self.objective(x.as_slice());
        let mut seen: Vec<(Vec<f64>, Score)> = Vec::new();
        let start = self
            .feeder
            .variables
            .iter()
            .map(|variable| (variable.start - variable.low) / (variable.high - variable.low));
        let (mut mean, mut spread): (Vec<f64>, f64) = (start.collect(), SPREAD);
        objective(&DVector::from_vec(mean.clone()));
        self.take(&mut seen);
        for round in 0.. {
            let strategy = CMAESOptions::new(mean.clone(), spread)
                .population_size(POPULATION)
                .seed(self.options.seed.wrapping_add(round << 32))
                .build(objective);
            // a population, a spread and a mean as above are never refused
            let Ok(mut strategy): Result<CMAES<_>, _> = strategy else { break };
            loop {
                if seen.len() + POPULATION > self.options.evaluations || self.is_over.load(Ordering::Relaxed) {
                    return seen;
                }
                let is_done = strategy.next_parallel().is_some();
                if !self.take(&mut seen) {
                    return seen;
                }
                if is_done {
                    break;
                }
            }
            let best = seen.iter().min_by(|a, b| a.1.cost.total_cmp(&b.1.cost));
            if let Some((best, _)) = best {
                mean = self
                    .feeder
                    .variables
                    .iter()
                    .zip(best)
                    .map(|(variable, value)| (value - variable.low) / (variable.high - variable.low))
                    .collect();
            }
            spread = AGAIN;
        }
        seen
    }

    /// Moves a generation over, in an order that does not depend on threads; not one that was broken off.
    fn take(&self, seen: &mut Vec<(Vec<f64>, Score)>) -> bool {
        let mut generation = match self.generation.lock() {
            Ok(mut generation) => std::mem::take(&mut *generation),
            Err(_) => return false,
        };
        if self.is_over.load(Ordering::Relaxed) {
            return false;
        }
        generation.sort_by(|(a, one), (b, other)| {
            let first = a.iter().zip(b).map(|(x, y)| x.total_cmp(y)).find(|order| order.is_ne());
            one.cost.total_cmp(&other.cost).then(first.unwrap_or(std::cmp::Ordering::Equal))
        });
        seen.extend(generation);
        true
    }

    /// What the strategy minimises: the score inside of the bounds, and how far outside of them a point is.
    fn objective(&self, point: &[f64]) -> f64 {
        if self.is_over.load(Ordering::Relaxed) {
            return f64::MAX;
        }
        let (mut variables, mut outside) = (Vec::with_capacity(point.len()), 0.0);
        for (share, variable) in point.iter().zip(&self.feeder.variables) {
            let inside = share.clamp(0.0, 1.0);
            outside += (share - inside).powi(2);
            variables.push(variable.low + inside * (variable.high - variable.low));
        }
        let score = self.journal.known(&variables).unwrap_or_else(|| self.scoring.score(&variables));
        let done = self.done.fetch_add(1, Ordering::Relaxed) + 1;
        if !self.journal.add(&variables, score, done) {
            self.is_over.store(true, Ordering::Relaxed);
        }
        if let Ok(mut generation) = self.generation.lock() {
            generation.push((variables, score));
        }
        score.cost + OUTSIDE * outside
    }
}
