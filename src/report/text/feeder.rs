//! `plan feeder` in words.

use super::super::Chute;
use super::super::decimal::near;
use super::super::phrase;
use super::lines::Report;
use crate::answer::{FeederDesign, FeederPlan};

/// The design found, how parts fare in it, and how far to trust it.
#[must_use]
pub fn feeder(chute: &Chute, answer: &FeederPlan) -> String {
    let evaluations = answer.trace.len();
    let mut report = Report::new(&phrase::feeder(chute, answer));
    dimensions(&mut report, chute, answer);
    runs(&mut report, chute, "at first", &answer.start);
    if let Some(best) = &answer.best {
        runs(&mut report, chute, "designed", best);
    }
    let passing = answer.trace.iter().filter(|evaluation| evaluation.passes).count();
    let first = answer.trace.iter().position(|evaluation| evaluation.passes);
    let since = first.map_or_else(String::new, |at| format!(", the first was evaluation {}", at + 1));
    report.line("search", &format!("{evaluations} evaluations, {passing} of them pass{since}"));
    for check in &answer.checks {
        let verdict = if check.design.passes() { "passes" } else { "fails" };
        let cost = near(check.design.cost, 4);
        report.line(
            "checked",
            &format!("{} at a step of {} s: {verdict}, cost {cost} s", check.model, near(check.step, 3)),
        );
    }
    if answer.fragile > 0 {
        report.line("", &format!("{} better designs failed a check and were passed over", answer.fragile));
    }
    robustness(&mut report, chute, answer);
    report.finish()
}

/// Bounds, start and result of each variable, and how far it may be off.
fn dimensions(report: &mut Report, chute: &Chute, answer: &FeederPlan) {
    let mut head = vec!["variable", "from", "to", "at first", "designed"];
    let tolerances = answer.robust.as_ref().map(|robust| &robust.tolerances);
    if tolerances.is_some() {
        head.extend(["passes from", "to"]);
    }
    let mut rows: Vec<Vec<String>> = vec![head.into_iter().map(String::from).collect()];
    for (index, variable) in chute.feeder.variables.iter().enumerate() {
        let found = answer.best.as_ref().map_or_else(|| "-".to_owned(), |best| near(best.variables[index], 4));
        let mut row =
            vec![variable.name.clone(), near(variable.low, 4), near(variable.high, 4), near(variable.start, 4), found];
        if let Some([low, high]) = tolerances.map(|ends| ends[index]) {
            row.extend([near(low, 4), near(high, 4)]);
        }
        rows.push(row);
    }
    report.table(&rows);
}

fn runs(report: &mut Report, chute: &Chute, label: &str, design: &FeederDesign) {
    for (index, (entry, run)) in chute.feeder.entries.iter().zip(&design.runs).enumerate() {
        let label = if index == 0 { label } else { "" };
        let (time, cost) = (near(run.time, 3), near(run.cost, 4));
        report.line(label, &format!("{entry}: {} after {time} s, cost {cost} s", run.fate.name()));
    }
}

fn robustness(report: &mut Report, chute: &Chute, answer: &FeederPlan) {
    let Some(robust) = &answer.robust else { return };
    let [passed, draws] = robust.passed;
    let [low, high] = robust.wilson.map(|share| near(100.0 * share, 4));
    let share = near(100.0 * passed as f64 / (draws as f64).max(1.0), 4);
    report
        .line("yield", &format!("{share} % of {draws} draws of what is uncertain; {low} to {high} % at 95 % (Wilson)"));
    let drawn = chute.feeder.uncertain.iter().filter(|one| one.off > 0.0);
    let drawn: Vec<String> =
        drawn.map(|one| format!("{} {} ± {}", one.name, near(one.value, 3), near(one.off, 3))).collect();
    if !drawn.is_empty() {
        report.line("", &drawn.join(", "));
    }
}
