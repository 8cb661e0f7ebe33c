//! The document of `plan feeder`.

use super::super::Chute;
use crate::answer::{DesignCheck, EntryFate, EntryRun, FeederDesign, FeederPlan, Robustness};
use serde_json::{Value, json};

/// Schema of `plan feeder`.
pub const FEEDER: &str = "plan.feeder/1";

/// The document of `plan feeder`; SI units, floats with all their digits.
#[must_use]
pub fn feeder(chute: &Chute, answer: &FeederPlan) -> Value {
    let status = match (&answer.best, answer.limit) {
        (Some(_), _) => "plan",
        (None, _) => "undecided",
    };
    let variables = chute.feeder.variables.iter().enumerate().map(|(index, variable)| {
        json!({
            "name": variable.name,
            "meaning": variable.meaning,
            "min": variable.low,
            "max": variable.high,
            "start": variable.start,
            "value": answer.best.as_ref().map(|best| best.variables[index]),
            "passes": answer.robust.as_ref().map(|robust| robust.tolerances[index]),
        })
    });
    let trace = answer.trace.iter().map(|evaluation| json!([evaluation.cost, evaluation.passes]));
    json!({
        "schema": FEEDER,
        "version": env!("CARGO_PKG_VERSION"),
        "case": chute.name,
        "status": status,
        "units": { "length": "m", "angle": "rad", "time": "s", "mass": "kg" },
        "result": {
            "variables": variables.collect::<Value>(),
            "entries": chute.feeder.entries,
            "start": design(&answer.start),
            "best": answer.best.as_ref().map(design),
            "checks": answer.checks.iter().map(check).collect::<Value>(),
            "fragile": answer.fragile,
            "robust": answer.robust.as_ref().map(robustness),
            "seed": chute.seed,
            "evaluations": answer.trace.len(),
            "trace": trace.collect::<Value>(),
            "limit": answer.limit.map(|limit| limit.name()),
            "warnings": chute.warnings,
        },
    })
}

fn design(design: &FeederDesign) -> Value {
    json!({
        "variables": design.variables,
        "cost": design.cost,
        "passes": design.passes(),
        "runs": design.runs.iter().map(run).collect::<Value>(),
    })
}

fn run(run: &EntryRun) -> Value {
    let fate = match run.fate {
        EntryFate::Passes => "passes",
        EntryFate::Astray => "astray",
        EntryFate::Rests => "rests",
        EntryFate::TimesOut => "times-out",
        EntryFate::Unsolved => "unsolved",
        EntryFate::NoDevice => "no-device",
    };
    json!({ "fate": fate, "time": run.time, "pose": run.pose, "cost": run.cost })
}

fn check(check: &DesignCheck) -> Value {
    json!({ "model": check.model, "step": check.step, "design": design(&check.design) })
}

fn robustness(robust: &Robustness) -> Value {
    let [passed, draws] = robust.passed;
    json!({ "passed": passed, "draws": draws, "wilson": robust.wilson })
}
