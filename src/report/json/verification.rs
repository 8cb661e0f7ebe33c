//! What dynamics says of a plan, and the scenes that refute it.

use super::scene::scene;
use crate::answer::{Quantity, Refutation, Verdict, Verification};
use serde_json::{Value, json};

/// The document of a plan with its verification; `null` where nothing was run.
#[must_use]
pub fn verified(mut document: Value, found: Option<&Verification>) -> Value {
    document["result"]["verification"] = found.map_or(Value::Null, verification);
    document
}

/// Schema of `plan verify`.
pub const VERIFY: &str = "plan.verify/1";

/// The document of `plan verify`; `is_done` where all runs asked for are in it.
#[must_use]
pub fn verified_alone(name: &str, found: &Verification, is_done: bool) -> Value {
    json!({
        "schema": VERIFY,
        "version": env!("CARGO_PKG_VERSION"),
        "case": name,
        "status": if is_done { "report" } else { "undecided" },
        "units": { "length": "m", "angle": "rad", "time": "s", "mass": "kg", "force": "N" },
        "result": { "verification": verification(found) },
    })
}

/// The verification itself; lengths in metres.
#[must_use]
pub fn verification(found: &Verification) -> Value {
    let tally = &found.tally;
    let verdict = match found.verdict() {
        Verdict::Confirmed => "confirmed",
        Verdict::Refuted => "refuted",
        Verdict::Inconclusive => "inconclusive",
    };
    json!({
        "verdict": verdict,
        "of": if found.is_given { "given plan" } else { "plan" },
        "seed": found.seed,
        "runs": tally.runs(),
        "confirmed": tally.confirmed,
        "moving": tally.moving,
        "refuted": tally.refuted,
        "inconclusive": tally.inconclusive,
        "wilson": tally.wilson(),
        "margin": tally.margin.map(|(left, run)| json!({ "left": left, "run": run })),
        "reasons": tally.reasons.iter().map(|(why, runs)| json!({ "why": why, "runs": runs })).collect::<Value>(),
        "settings": quantities(&found.settings),
        "limits": quantities(&found.limits),
        "refutations": found.refutations.iter().map(refutation).collect::<Value>(),
    })
}

fn quantities(list: &[Quantity]) -> Value {
    let quantity =
        |Quantity { name, low, high, unit }: &Quantity| json!({ "name": name, "low": low, "high": high, "unit": unit });
    list.iter().map(quantity).collect()
}

fn refutation(found: &Refutation) -> Value {
    let replay = &found.replay;
    json!({
        "run": found.run,
        "share": found.share,
        "why": found.why,
        "model": replay.model,
        "policy": if replay.is_adverse { "adverse" } else { "first" },
        "scene": scene("refutation", &replay.world)["scene"],
    })
}
