//! The search for dimensions: an evolution strategy over the unit box, its evaluations screened by a coarse step.

use super::objective::evaluated;
use super::robust::drawn;
use crate::answer::{DesignCheck, Evaluation, FeederDesign, FeederPlan};
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

/// Steps of the checks over that of the case: the last is the screen.
const HALF: f64 = 0.5;
const TENTH: f64 = 0.1;
const SCREEN: f64 = 2.0;

/// Step of the compliant check over that of the case.
const COMPLIANT: f64 = 0.02;

/// Step of a case that states none (s).
const STEP: f64 = 1e-3;

/// Designs whose checks are tried, best first.
const CANDIDATES: usize = 24;

/// How a search goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SearchOptions {
    /// Evaluations of the objective.
    pub evaluations: usize,
    /// Seed of the search and of draws.
    pub seed: u64,
    /// Whether the worst entry counts, instead of all together.
    pub worst: bool,
    /// Draws of what is uncertain that each design which passes is tried with.
    pub draws: u64,
}

/// What the search sees of a design.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Score {
    /// The largest cost of the steps looked at, or their mean over draws.
    pub cost: f64,
    /// Whether all entries passed at all steps.
    pub passes: bool,
}

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
    let mut fragile = 0;
    let (mut best, mut checks) = (None, Vec::new());
    for (variables, _) in passing.into_iter().take(CANDIDATES) {
        let found = search.checks(variables);
        if found.iter().all(|check| check.design.passes()) {
            best = Some(evaluated(feeder, variables, &nominal, ModelKind::StewartTrinkle, None));
            checks = found;
            break;
        }
        fragile += 1;
    }
    FeederPlan { start, best, checks, trace, fragile, robust: None, limit: None }
}

struct Search<'a> {
    feeder: &'a Feeder,
    options: &'a SearchOptions,
    journal: &'a dyn Journal,
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
        let score = self.journal.known(&variables).unwrap_or_else(|| self.score(&variables));
        let done = self.done.fetch_add(1, Ordering::Relaxed) + 1;
        if !self.journal.add(&variables, score, done) {
            self.is_over.store(true, Ordering::Relaxed);
        }
        if let Ok(mut generation) = self.generation.lock() {
            generation.push((variables, score));
        }
        score.cost + OUTSIDE * outside
    }

    /// The cheapest model first: a coarse step, and finer ones for what passes it. The largest cost counts, since what the step
    /// decides is not to be trusted.
    fn score(&self, variables: &[f64]) -> Score {
        let (mut cost, nominal): (f64, _) = (0.0, self.feeder.nominal());
        for share in [SCREEN, 1.0, HALF] {
            let found = self.at(variables, &nominal, share);
            cost = cost.max(self.cost(&found));
            if !found.passes() {
                return Score { cost, passes: false };
            }
        }
        let draws = self.options.draws;
        for run in 0..draws {
            let found = self.at(variables, &drawn(self.feeder, self.options.seed, run), 1.0);
            // what fails under a draw is worse than what passes slowly
            cost += self.cost(&found) / draws as f64;
        }
        Score { cost, passes: true }
    }

    fn at(&self, variables: &[f64], uncertain: &[f64], share: f64) -> FeederDesign {
        evaluated(self.feeder, variables, uncertain, ModelKind::StewartTrinkle, Some(share * self.step(uncertain)))
    }

    /// The step of the case.
    fn step(&self, uncertain: &[f64]) -> f64 {
        let worlds = self.feeder.device.scenes(&self.feeder.start(), uncertain).unwrap_or_default();
        worlds.first().and_then(|world| world.step).unwrap_or(STEP)
    }

    fn cost(&self, design: &FeederDesign) -> f64 {
        let worst = design.runs.iter().map(|run| run.cost).fold(0.0, f64::max);
        if self.options.worst { design.runs.len() as f64 * worst } else { design.cost }
    }

    /// A design at smaller steps, and by Song, Pang and Kumar's model where its surfaces may give way.
    fn checks(&self, variables: &[f64]) -> Vec<DesignCheck> {
        let nominal = self.feeder.nominal();
        let step = self.step(&nominal);
        let is_compliant = self.feeder.device.scenes(variables, &nominal).is_ok_and(|worlds| {
            worlds.iter().all(|world| world.materials.iter().all(|material| material.compliance.is_some()))
        });
        let check = |model: ModelKind, name: &'static str, share: f64| DesignCheck {
            model: name,
            step: share * step,
            design: evaluated(self.feeder, variables, &nominal, model, Some(share * step)),
        };
        let rigid = [HALF, TENTH].map(|share| check(ModelKind::StewartTrinkle, "st", share));
        let compliant = is_compliant.then(|| check(ModelKind::SongPangKumar, "spk", COMPLIANT));
        rigid.into_iter().chain(compliant).collect()
    }
}
