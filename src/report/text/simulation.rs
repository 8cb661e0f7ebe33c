//! `plan simulate` in words.

use super::super::decimal::near;
use super::super::motion::{Run, Shown, change, contact, plain};
use super::super::phrase;
use super::lines::Report;
use crate::answer::{Event, Simulation, SolverStatistics};

/// Bodies in the table.
const MOST_BODIES: usize = 5;
/// Changes of contacts listed.
const MOST_EVENTS: usize = 6;
/// Reasons for the model.
const MOST_REASONS: usize = 3;
/// Remarks.
const MOST_NOTES: usize = 3;

/// The final state, then how it came about and how far to trust it.
#[must_use]
pub fn simulation<S: Shown>(run: &Run<S>, answer: &Simulation<S>) -> String {
    let mut report = Report::new(&phrase::simulation(run, answer));
    bodies(&mut report, run, answer);
    model(&mut report, answer);
    events(&mut report, run, &answer.events);
    energy(&mut report, answer);
    let (depth, when) = answer.penetration;
    let deepest = match depth > 0.0 {
        true => format!("{} m at most, at {} s", near(depth, 3), near(when, 4)),
        false => "none".to_owned(),
    };
    report.line("overlap", &deepest);
    solver(&mut report, &answer.solver);
    notes(&mut report, &answer.notes);
    report.finish()
}

/// Pose and velocity of the first bodies.
fn bodies<S: Shown>(report: &mut Report, run: &Run<S>, answer: &Simulation<S>) {
    let head = std::iter::once("body".to_owned()).chain(S::HEADINGS.iter().map(|heading| (*heading).to_owned()));
    let mut rows = vec![head.collect::<Vec<String>>()];
    let states = answer.last.poses.iter().zip(&answer.last.velocities);
    for (body, (pose, velocity)) in run.world.bodies.iter().zip(states).take(MOST_BODIES) {
        rows.push(std::iter::once(plain(&body.name)).chain(S::cells(pose, velocity)).collect());
    }
    report.table(&rows);
    if let Some(more) = run.world.bodies.len().checked_sub(MOST_BODIES).filter(|more| *more > 0) {
        report.line("", &format!("and {more} more (--format json lists all)"));
    }
}

fn model<S: Shown>(report: &mut Report, answer: &Simulation<S>) {
    let model = &answer.model;
    let error =
        model.error.map_or_else(String::new, |error| format!(", final poses within about {} m", near(error, 2)));
    report.line("model", &format!("{}, step {} s{error}", model.chosen, near(model.step, 4)));
    for reason in model.why.iter().take(MOST_REASONS) {
        report.line("", reason);
    }
}

fn events<S: Shown>(report: &mut Report, run: &Run<S>, events: &[Event]) {
    if events.is_empty() {
        return report.line("contacts", "nothing changes");
    }
    let line =
        |event: &Event| format!("{} s  {} {}", near(event.time, 4), contact(run, &event.contact, plain), change(event));
    let mut lines: Vec<String> = events.iter().map(line).collect();
    if lines.len() > MOST_EVENTS {
        let left_out = lines.len() - (MOST_EVENTS - 1);
        lines.splice(3..3 + left_out, [format!("and {left_out} more changes (--format json lists all)")]);
    }
    for (index, text) in lines.iter().enumerate() {
        report.line(if index == 0 { "contacts" } else { "" }, text);
    }
}

fn energy<S: Shown>(report: &mut Report, answer: &Simulation<S>) {
    let energy = &answer.energy;
    let joule = |value: f64| if value.abs() < 1e-12 { "0".to_owned() } else { near(value, 4) };
    let gain = match energy.largest_gain > 0.0 {
        true => format!("; at most {} J gained in a step", near(energy.largest_gain, 2)),
        false => String::new(),
    };
    report.line(
        "energy",
        &format!(
            "{} J at the start, {} J at the end; work {} J, dissipated {} J{gain}",
            joule(energy.start),
            joule(energy.end),
            joule(energy.work),
            joule(energy.dissipated)
        ),
    );
}

fn solver(report: &mut Report, solver: &SolverStatistics) {
    let mut said = vec![
        phrase::count(solver.steps, "step"),
        phrase::count(solver.problems, "contact problem"),
        phrase::count(solver.pivots, "pivot"),
        format!("residual {}", near(solver.residual, 2)),
    ];
    let others = [(solver.impacts, "impact located", "impacts located"), (solver.subdivided, "step cut", "steps cut")];
    let others = others.iter().filter(|(count, ..)| *count > 0);
    said.extend(others.map(|(count, one, many)| format!("{count} {}", if *count == 1 { one } else { many })));
    report.line("solver", &said.join(", "));
    let rungs: Vec<String> = solver.rungs.iter().map(|(name, count)| format!("{name} {count}")).collect();
    if !rungs.is_empty() {
        report.line("", &format!("answered by {}", rungs.join(", ")));
    }
}

fn notes(report: &mut Report, notes: &[String]) {
    let shown = if notes.len() > MOST_NOTES { MOST_NOTES - 1 } else { notes.len() };
    for (index, note) in notes[..shown].iter().enumerate() {
        report.line(if index == 0 { "note" } else { "" }, note);
    }
    if shown < notes.len() {
        report.line("", &format!("and {} more (--format json lists all)", notes.len() - shown));
    }
}
