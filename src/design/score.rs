//! What the search sees of a design: the cheapest model first, finer ones for what passes it.

use super::objective::evaluated;
use super::robust::{drawn, offsets};
use crate::answer::{DesignCheck, EntryFate, EntryRun, FeederDesign};
use crate::dynamics::ModelKind;
use crate::model::{Feeder, Planar, Variable, World};

/// Steps of the checks over that of the case: the last is the screen.
const HALF: f64 = 0.5;
const TENTH: f64 = 0.1;
const SCREEN: f64 = 2.0;

/// Step of the compliant check over that of the case.
const COMPLIANT: f64 = 0.02;

/// Step of a case that states none (s).
const STEP: f64 = 1e-3;

/// Designs nearby that count in the score of one that passes, and how far they are over the ranges of the variables.
const NEARBY: u64 = 4;
const NEAR: f64 = 0.01;

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
    /// The largest cost of the steps looked at; of a design that passes, the mean of it and of
    /// the mean cost of designs nearby and of draws.
    pub cost: f64,
    /// Whether all entries passed at all steps.
    pub passes: bool,
}

/// Scores designs of a feeder.
#[derive(Debug, Clone, Copy)]
pub struct Scoring<'a> {
    feeder: &'a Feeder,
    options: &'a SearchOptions,
    /// The step of the case (s).
    step: f64,
}

impl<'a> Scoring<'a> {
    /// For a search.
    #[must_use]
    pub fn new(feeder: &'a Feeder, options: &'a SearchOptions) -> Self {
        let worlds = feeder.device.scenes(&feeder.start(), &feeder.nominal()).unwrap_or_default();
        let step = worlds.first().and_then(|world| world.step).unwrap_or(STEP);
        Self { feeder, options, step }
    }

    /// The cheapest model first: a coarse step, and finer ones for what passes it. The largest cost counts, since what the step
    /// decides is not to be trusted.
    #[must_use]
    pub fn score(&self, variables: &[f64]) -> Score {
        let (mut cost, nominal): (f64, _) = (0.0, self.feeder.nominal());
        for share in [SCREEN, 1.0, HALF] {
            let found = self.at(variables, &nominal, share);
            cost = cost.max(self.cost(&found));
            if !found.passes() {
                return Score { cost, passes: false };
            }
        }
        // nearby designs: what fails beside one that passes is not to be had in a workshop
        let nearby = (0..NEARBY).map(|run| self.cost(&self.at(&self.nearby(variables, run), &nominal, 1.0)));
        let draws = (0..self.options.draws).map(|run| {
            let uncertain = drawn(&self.feeder.uncertain, self.options.seed, run);
            self.cost(&self.at(variables, &uncertain, 1.0))
        });
        let others: Vec<f64> = nearby.chain(draws).collect();
        let mean = others.iter().sum::<f64>() / others.len() as f64;
        Score { cost: 0.5 * (cost + mean), passes: true }
    }

    /// A design next to another one, the same for every design but for where that is.
    fn nearby(&self, variables: &[f64], run: u64) -> Vec<f64> {
        let bounds = &self.feeder.variables;
        let places = offsets(bounds.len(), self.options.seed, run).zip(variables).zip(bounds);
        let moved = |((offset, at), bounds): ((f64, &f64), &Variable)| {
            (at + NEAR * (bounds.high - bounds.low) * offset).clamp(bounds.low, bounds.high)
        };
        places.map(moved).collect()
    }

    fn at(&self, variables: &[f64], uncertain: &[f64], share: f64) -> FeederDesign {
        evaluated(self.feeder, variables, uncertain, ModelKind::StewartTrinkle, Some(share * self.step))
    }

    /// (18), or its worst term. An entry that fails costs a unit of distance besides, so that a part that all but passes does not
    /// look better than one that passes slowly.
    fn cost(&self, design: &FeederDesign) -> f64 {
        let failed = |run: &EntryRun| if run.fate == EntryFate::Passes { 0.0 } else { self.feeder.goal.weight };
        let costs = design.runs.iter().map(|run| run.cost + failed(run));
        if self.options.worst { design.runs.len() as f64 * costs.fold(0.0, f64::max) } else { costs.sum() }
    }

    /// A design at smaller steps, and by Song, Pang and Kumar's model where its surfaces may give way.
    #[must_use]
    pub fn checks(&self, variables: &[f64]) -> Vec<DesignCheck> {
        let nominal = self.feeder.nominal();
        let gives_way = |world: &World<Planar>| {
            let n_bodies = world.bodies.len();
            (n_bodies..n_bodies + world.fixed.len()).all(|other| world.material(0, other).compliance.is_some())
        };
        let worlds = self.feeder.device.scenes(variables, &nominal).unwrap_or_default();
        let is_compliant = !worlds.is_empty() && worlds.iter().all(gives_way);
        let check = |model: ModelKind, name: &'static str, share: f64| DesignCheck {
            model: name,
            step: share * self.step,
            design: evaluated(self.feeder, variables, &nominal, model, Some(share * self.step)),
        };
        let rigid = [HALF, TENTH].map(|share| check(ModelKind::StewartTrinkle, "st", share));
        let compliant = is_compliant.then(|| check(ModelKind::SongPangKumar, "spk", COMPLIANT));
        rigid.into_iter().chain(compliant).collect()
    }
}
