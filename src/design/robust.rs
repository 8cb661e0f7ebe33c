//! How far a design may be off.

use super::objective::evaluated;
use crate::answer::{Robustness, wilson};
use crate::dynamics::ModelKind;
use crate::model::{Feeder, Uncertain};
use crate::verify::Draw;
use rayon::prelude::*;

/// First departure tried over the range of a variable, and bisections after the first that fails.
const FIRST: f64 = 1.0 / 256.0;
const BISECTIONS: usize = 5;

/// What is uncertain, drawn within its limits: draw `run` of a seed.
#[must_use]
pub(super) fn drawn(uncertain: &[Uncertain], seed: u64, run: u64) -> Vec<f64> {
    offsets(uncertain.len(), seed, run).zip(uncertain).map(|(offset, one)| one.value + one.off * offset).collect()
}

/// Numbers between -1 and 1: those of draw `run` of a seed.
pub(super) fn offsets(count: usize, seed: u64, run: u64) -> impl Iterator<Item = f64> {
    let mut draw = Draw::new(seed, run);
    (0..count).map(move |_| 2.0 * draw.unit() - 1.0)
}

/// The yield of a design over so many draws of what is uncertain, and how far each variable may be off by itself; `None` where
/// `watch` ends it.
pub fn robustness(
    feeder: &Feeder,
    variables: &[f64],
    seed: u64,
    draws: u64,
    watch: &(dyn Fn() -> bool + Sync),
) -> Option<Robustness> {
    let passes = |variables: &[f64], uncertain: &[f64]| {
        watch().then(|| evaluated(feeder, variables, uncertain, ModelKind::StewartTrinkle, None).passes())
    };
    let one = |run: u64| passes(variables, &drawn(&feeder.uncertain, seed, run)).map(u64::from);
    let passed = (0..draws).into_par_iter().map(one).try_reduce(|| 0, |a, b| Some(a + b))?;
    let nominal = feeder.nominal();
    let reach = |(index, end): (usize, f64)| {
        let step = end - variables[index];
        let at = |share: f64| {
            let mut moved = variables.to_vec();
            moved[index] += share * step;
            passes(&moved, &nominal)
        };
        let range = feeder.variables[index].high - feeder.variables[index].low;
        let (mut good, mut bad) = (0.0, (FIRST * range / step.abs()).min(1.0));
        if step == 0.0 {
            return Some(end);
        }
        while at(bad)? {
            good = bad;
            if bad == 1.0 {
                return Some(end);
            }
            bad = (2.0 * bad).min(1.0);
        }
        for _ in 0..BISECTIONS {
            let middle = 0.5 * (good + bad);
            if at(middle)? { good = middle } else { bad = middle }
        }
        Some(variables[index] + good * step)
    };
    let ends: Vec<(usize, f64)> =
        feeder.variables.iter().enumerate().flat_map(|(k, variable)| [(k, variable.low), (k, variable.high)]).collect();
    let ends: Vec<f64> = ends.into_par_iter().map(reach).collect::<Option<_>>()?;
    let tolerances = ends.chunks_exact(2).map(|ends| [ends[0], ends[1]]).collect();
    Some(Robustness { passed: [passed, draws], wilson: wilson(passed, draws), tolerances })
}
