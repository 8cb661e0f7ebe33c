//! What dynamics says of a plan.

use crate::model::{Planar, World};

/// Runs of a time-stepper that put a plan to the test, and how they ended.
#[derive(Debug, Clone, PartialEq)]
pub struct Verification {
    /// Whether the plan is one that the case brings along, not the planner's.
    pub is_given: bool,
    /// Seed from which every run was drawn, with its number.
    pub seed: u64,
    /// How many runs ended how.
    pub tally: Tally,
    /// What was set, and between which values it was drawn.
    pub settings: Vec<Quantity>,
    /// How far an assumption of the plan may be left while it still works.
    pub limits: Vec<Quantity>,
    /// The refuting runs, each shrunk to the least departure that still fails; the first few.
    pub refutations: Vec<Refutation>,
}

/// What some runs came to; sums do not depend on the order of the runs.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Tally {
    /// Runs that ended as the plan says.
    pub confirmed: u64,
    /// Those of them that ended in motion: seated, and not held still.
    pub moving: u64,
    /// Numbers of the runs that ended otherwise, ascending.
    pub refuted: Vec<u64>,
    /// Runs that a limit ended, or whose contact problems were not decided.
    pub inconclusive: u64,
    /// Why runs were not confirmed, with how many, by the words.
    pub reasons: Vec<(String, u64)>,
    /// The least share of the time allowed that a confirmed run had left, with its number.
    pub margin: Option<(f64, u64)>,
}

/// A number or a range, named for reports.
#[derive(Debug, Clone, PartialEq)]
pub struct Quantity {
    /// What it is.
    pub name: &'static str,
    /// Least value.
    pub low: f64,
    /// Largest value; the least one where nothing is drawn.
    pub high: f64,
    /// Its unit; empty for a pure number.
    pub unit: &'static str,
}

/// A run that does not end as the plan says.
#[derive(Debug, Clone, PartialEq)]
pub struct Refutation {
    /// Its number.
    pub run: u64,
    /// The least share of its departures that still fails.
    pub share: f64,
    /// What happened then.
    pub why: String,
    /// The scene at that share.
    pub replay: Replay,
}

/// A scene, and how to run it.
#[derive(Debug, Clone, PartialEq)]
pub struct Replay {
    /// The scene, with its step.
    pub world: World<Planar>,
    /// The model: `st`, `moreau` or `spk`.
    pub model: &'static str,
    /// Whether of several motions the most adverse one is followed.
    pub is_adverse: bool,
}

/// A plan is confirmed if every run confirms it, and refuted by one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// Every run ended as the plan says.
    Confirmed,
    /// Some run did not.
    Refuted,
    /// No run ended otherwise, but some did not end.
    Inconclusive,
}

impl Verification {
    /// What the runs come to.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        match &self.tally {
            Tally { refuted, .. } if !refuted.is_empty() => Verdict::Refuted,
            Tally { inconclusive: 0, .. } => Verdict::Confirmed,
            _ => Verdict::Inconclusive,
        }
    }
}

impl Tally {
    /// How many runs there were.
    #[must_use]
    pub fn runs(&self) -> u64 {
        self.confirmed + self.refuted.len() as u64 + self.inconclusive
    }

    /// Adds what other runs came to.
    pub fn add(&mut self, other: &Self) {
        self.confirmed += other.confirmed;
        self.moving += other.moving;
        self.inconclusive += other.inconclusive;
        self.refuted.extend(&other.refuted);
        self.refuted.sort_unstable();
        for (reason, count) in &other.reasons {
            match self.reasons.binary_search_by(|(known, _)| known.cmp(reason)) {
                Ok(at) => self.reasons[at].1 += count,
                Err(at) => self.reasons.insert(at, (reason.clone(), *count)),
            }
        }
        let least = |a: (f64, u64), b: (f64, u64)| if b.0.total_cmp(&a.0).then(b.1.cmp(&a.1)).is_lt() { b } else { a };
        self.margin = match (self.margin, other.margin) {
            (Some(a), Some(b)) => Some(least(a, b)),
            (a, b) => a.or(b),
        };
    }

    /// Wilson's interval for the share of runs that would be confirmed, at 95 %.
    #[must_use]
    pub fn wilson(&self) -> [f64; 2] {
        wilson(self.confirmed, self.runs())
    }
}

/// Wilson's interval for a share of which `of` draws show `seen`, at 95 %.
#[must_use]
pub fn wilson(seen: u64, of: u64) -> [f64; 2] {
    let (n, z) = (of as f64, 1.959_963_984_540_054);
    if of == 0 {
        return [0.0, 1.0];
    }
    let share = seen as f64 / n;
    let middle = share + z * z / (2.0 * n);
    let half = z * (share * (1.0 - share) / n + z * z / (4.0 * n * n)).sqrt();
    let scale = 1.0 + z * z / n;
    [((middle - half) / scale).max(0.0), ((middle + half) / scale).min(1.0)]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Published example: 81 of 263 gives 0.255 to 0.366 (Newcombe 1998, method 3); none of 20 gives 0 to 0.161.
    #[test]
    fn wilson_intervals_are_the_published_ones() {
        let of = |confirmed, refuted| Tally { confirmed, refuted: (0..refuted).collect(), ..Tally::default() }.wilson();
        let [low, high] = of(81, 263 - 81);
        assert!((low - 0.2553).abs() < 1e-4 && (high - 0.3662).abs() < 1e-4, "{low} {high}");
        let [low, high] = of(0, 20);
        assert!(low == 0.0 && (high - 0.1611).abs() < 1e-4, "{low} {high}");
    }

    #[test]
    fn sums_of_tallies_do_not_depend_on_their_order() {
        let tally = |run: u64, reason: &str, left: f64| Tally {
            confirmed: 1,
            moving: 1,
            refuted: vec![run],
            inconclusive: run,
            reasons: vec![(reason.to_owned(), 1)],
            margin: Some((left, run)),
        };
        let parts = [tally(3, "jams", 0.5), tally(1, "leaves", 0.25), tally(2, "jams", 0.25)];
        let sum = |order: [usize; 3]| {
            let mut sum = Tally::default();
            order.into_iter().for_each(|at| sum.add(&parts[at]));
            sum
        };
        let first = sum([0, 1, 2]);
        assert_eq!((first.runs(), first.margin), (3 + 3 + 6, Some((0.25, 1))));
        assert_eq!(first.reasons, [("jams".to_owned(), 2), ("leaves".to_owned(), 1)]);
        assert!([[1, 2, 0], [2, 1, 0], [0, 2, 1]].into_iter().all(|order| sum(order) == first));
    }
}
