//! What dynamics says of a plan, in words.

use super::super::decimal::near;
use super::lines::Report;
use crate::answer::{Quantity, Tally, Verdict, Verification};
use crate::exact::to_f64;
use crate::model::LengthUnit;

/// Share of the departures of a run that is none, for reports.
const NONE: f64 = 1e-3;

/// Reasons told; the rest is in JSON.
const MOST_REASONS: usize = 3;

/// The verdict, what was drawn, and how far the plan holds; lines to follow those of the plan.
#[must_use]
pub fn verification(unit: LengthUnit, found: &Verification) -> String {
    let mut report = Report::lines();
    let tally = &found.tally;
    let runs = tally.runs();
    let verdict = match found.verdict() {
        Verdict::Confirmed => format!("confirmed by {runs} of {runs} runs"),
        Verdict::Refuted => format!("refuted by {} of {runs} runs", tally.refuted.len()),
        Verdict::Inconclusive => format!("confirmed by {} of {runs} runs, the others are undecided", tally.confirmed),
    };
    let of = if found.is_given { "the plan given is " } else { "" };
    report.line("dynamics", &format!("{of}{verdict}{}", limits(unit, &found.limits)));
    if tally.moving > 0 {
        let moving = if tally.moving == tally.confirmed { "all".to_owned() } else { tally.moving.to_string() };
        report.line("", &format!("seated, but not held still then: {moving} of them"));
    }
    for (reason, count) in most(tally) {
        report.line("", &format!("{count} {}: {reason}", if *count == 1 { "run" } else { "runs" }));
    }
    if let Some(first) = found.refutations.first() {
        let from = match first.share {
            share if share < NONE => "however little departs from the plan".to_owned(),
            share => format!("from {} % of its departures on", near(100.0 * share, 3)),
        };
        report.line("", &format!("run {} fails {from}: {}", first.run, first.why));
    }
    let drawn = found.settings.iter().map(|setting| quantity(unit, setting));
    report.line("", &format!("with {}", drawn.collect::<Vec<_>>().join(", ")));
    report.finish()
}

/// `plan verify` in words: the share of so many runs asked for, with its interval, and the worst run.
#[must_use]
pub fn verified(unit: LengthUnit, found: &Verification, asked: u64) -> String {
    let tally = &found.tally;
    let runs = tally.runs();
    let share = near(100.0 * tally.confirmed as f64 / (runs as f64).max(1.0), 5);
    let [low, high] = tally.wilson().map(|share| near(100.0 * share, 5));
    let of = if runs == asked { String::new() } else { format!(" so far, of {asked} asked for") };
    let mut report = Report::new(&format!(
        "{share} % of {runs} runs{of} confirm the plan; between {low} and {high} % would, at 95 % confidence (Wilson)"
    ));
    if let Some((left, run)) = tally.margin {
        report.line("worst", &format!("run {run}, which had {} % of the time allowed left", near(100.0 * left, 3)));
    }
    report.line("seed", &found.seed.to_string());
    report.finish() + &verification(unit, found)
}

fn most(tally: &Tally) -> Vec<&(String, u64)> {
    let mut reasons: Vec<&(String, u64)> = tally.reasons.iter().collect();
    reasons.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
    reasons.truncate(MOST_REASONS);
    reasons
}

fn limits(unit: LengthUnit, limits: &[Quantity]) -> String {
    limits.iter().map(|limit| format!("; {}", quantity(unit, limit))).collect()
}

/// A quantity in the unit of the case.
fn quantity(unit: LengthUnit, quantity: &Quantity) -> String {
    let Quantity { name, low, high, unit: own } = quantity;
    let (scale, symbol) = match *own {
        "m" | "m/s" => (1.0 / to_f64(&unit.metres()), own.replacen('m', unit.symbol(), 1)),
        _ => (1.0, own.to_string()),
    };
    let number = |value: &f64| near(scale * value, 3);
    let symbol = if symbol.is_empty() { symbol } else { format!(" {symbol}") };
    if low == high {
        format!("{name} {}{symbol}", number(low))
    } else {
        format!("{name} {} to {}{symbol}", number(low), number(high))
    }
}
