//! Runs by number: how many end as a plan says, and which do not.

use crate::answer::{Quantity, Refutation, Replay, Tally, Verification};
use rayon::prelude::*;
use std::ops::Range;

/// Most refuting runs that are shrunk and kept.
const MAX_REFUTATIONS: usize = 8;

/// Length of a refuting scene over the time after which it is known to fail.
const AFTERWARDS: f64 = 1.05;

/// Halvings of the share of the departures in which a refuting run is shrunk.
const HALVINGS: usize = 12;

/// How a run ended.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Ending {
    /// As the plan says.
    Confirmed,
    /// Otherwise, and how.
    Refuted(String),
    /// Undecided, and why.
    Inconclusive(String),
}

/// A run.
#[derive(Debug, Clone, PartialEq)]
pub struct Trial {
    /// How it ended.
    pub ending: Ending,
    /// Share of the time allowed that was left, in [0, 1].
    pub left: f64,
    /// Whether it ended as the plan says but in motion: seated, and not held still.
    pub moves: bool,
}

/// Runs that are drawn by their number, the same whenever and wherever they run.
pub trait Experiment: Sync {
    /// Run number `run`, with all its departures from the nominal values times `share`, in [0, 1].
    fn run(&self, run: u64, share: f64) -> Trial;

    /// The scene of that run.
    fn replay(&self, run: u64, share: f64) -> Replay;

    /// What is set and what is drawn.
    fn settings(&self) -> Vec<Quantity>;

    /// Seed of the draws.
    fn seed(&self) -> u64;

    /// Whether the plan is one that the case brings along.
    fn is_given(&self) -> bool {
        false
    }
}

/// What these runs come to, in parallel; `watch` is told of each that ends and stops the others by answering `false`,
/// for which there is no tally.
pub fn tally(experiment: &impl Experiment, runs: Range<u64>, watch: &(dyn Fn() -> bool + Sync)) -> Option<Tally> {
    let one = |run: u64| {
        let trial = experiment.run(run, 1.0);
        let mut tally = Tally::default();
        match trial.ending {
            Ending::Confirmed => {
                (tally.confirmed, tally.moving, tally.margin) = (1, trial.moves.into(), Some((trial.left, run)));
            }
            Ending::Refuted(why) => (tally.refuted, tally.reasons) = (vec![run], vec![(why, 1)]),
            Ending::Inconclusive(why) => (tally.inconclusive, tally.reasons) = (1, vec![(why, 1)]),
        }
        watch().then_some(tally)
    };
    runs.into_par_iter().map(one).try_reduce(Tally::default, |mut a, b| {
        a.add(&b);
        Some(a)
    })
}

/// The verification that a tally comes to, its first refuting runs shrunk.
pub fn verification(experiment: &impl Experiment, tally: Tally, limits: Vec<Quantity>) -> Verification {
    let refutations = tally.refuted.iter().take(MAX_REFUTATIONS).map(|run| shrunk(experiment, *run)).collect();
    let is_given = experiment.is_given();
    Verification { is_given, seed: experiment.seed(), tally, settings: experiment.settings(), limits, refutations }
}

/// The least share of its departures with which a refuting run still fails, by bisection between a share that fails and
/// one that does not; its scene ends soon after it is known to fail.
fn shrunk(experiment: &impl Experiment, run: u64) -> Refutation {
    let fails = |share: f64| match experiment.run(run, share) {
        Trial { ending: Ending::Refuted(why), left, .. } => Some((why, left)),
        _ => None,
    };
    let (mut low, mut share, mut failure) = (0.0, 1.0, fails(1.0).unwrap_or_default());
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + share);
        match fails(middle) {
            Some(found) => (share, failure) = (middle, found),
            None => low = middle,
        }
    }
    let (why, left) = failure;
    let mut replay = experiment.replay(run, share);
    replay.world.duration *= (AFTERWARDS * (1.0 - left)).min(1.0);
    Refutation { run, share, why, replay }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Planar, World};

    /// Run n fails from the share 1/n on, for n from 2; run 0 never, run 1 is undecided.
    struct Made;

    impl Experiment for Made {
        fn run(&self, run: u64, share: f64) -> Trial {
            let ending = match run {
                0 => Ending::Confirmed,
                1 => Ending::Inconclusive("time".to_owned()),
                n if share * n as f64 >= 1.0 => Ending::Refuted("jams".to_owned()),
                _ => Ending::Confirmed,
            };
            Trial { ending, left: 0.5, moves: false }
        }

        fn replay(&self, _: u64, share: f64) -> Replay {
            let world: World<Planar> = World {
                gravity: [0.0; 2],
                duration: share,
                step: None,
                margin: None,
                directions: 2,
                bodies: Vec::new(),
                fixed: Vec::new(),
                materials: Vec::new(),
            };
            Replay { world, model: "st", is_adverse: false }
        }

        fn settings(&self) -> Vec<Quantity> {
            Vec::new()
        }

        fn seed(&self) -> u64 {
            7
        }
    }

    #[test]
    fn runs_are_counted_and_refutations_shrunk_to_where_they_begin() {
        let all = tally(&Made, 0..5, &|| true).unwrap();
        assert_eq!((all.confirmed, all.inconclusive, all.refuted.as_slice()), (1, 1, [2, 3, 4].as_slice()));
        assert_eq!(all.reasons, [("jams".to_owned(), 3), ("time".to_owned(), 1)]);
        let mut parts = tally(&Made, 2..5, &|| true).unwrap();
        parts.add(&tally(&Made, 0..2, &|| true).unwrap());
        assert_eq!(parts, all);
        assert_eq!(tally(&Made, 0..5, &|| false), None);
        let found = verification(&Made, all, Vec::new());
        for (refutation, least) in found.refutations.iter().zip([0.5, 1.0 / 3.0, 0.25]) {
            assert!(refutation.share >= least && refutation.share - least < 1e-3, "{refutation:?}");
            assert_eq!(refutation.replay.world.duration, 0.525 * refutation.share);
        }
    }
}
