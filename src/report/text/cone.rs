//! `plan cone` in words and rows.

use super::super::Subject;
use super::lines::Report;
use crate::answer::{CanonicalCone, Cone, WrenchVerdict};
use crate::exact::Z;

/// Faces and generators of every mode's cone.
#[must_use]
pub fn cones(subject: &Subject, modes: &[(String, Cone)]) -> String {
    judged_cones(subject, modes, &[])
}

/// [`cones`] with verdicts on wrenches.
#[must_use]
pub fn judged_cones(subject: &Subject, modes: &[(String, Cone)], wrenches: &[WrenchVerdict]) -> String {
    let answers: Vec<String> = modes.iter().map(|(mode, cone)| format!("{mode}: {}", describe(cone))).collect();
    let mut report = Report::new(&answers.join("\n"));
    for (mode, cone) in modes {
        if let Cone::Of(cone) = cone {
            rows(&mut report, mode, cone);
        }
    }
    report.wrenches(wrenches);
    report.fixels(subject);
    report.finish()
}

/// The shape of a cone in a few words.
pub(super) fn describe(cone: &Cone) -> String {
    let Cone::Of(cone) = cone else { return "no wrench at all".to_owned() };
    if cone.dim == 0 {
        return "the zero wrench only".to_owned();
    }
    if cone.dim == 3 && cone.faces.is_empty() {
        return if cone.excluded.is_empty() { "every wrench" } else { "every wrench but a few" }.to_owned();
    }
    let mut parts =
        vec![format!("dimension {}", cone.dim), count(cone.faces.len(), "face"), count(cone.rays.len(), "ray")];
    if !cone.lines.is_empty() {
        parts.push(count(cone.lines.len(), "line"));
    }
    parts.join(", ")
}

fn rows(report: &mut Report, mode: &str, cone: &CanonicalCone) {
    for row in &cone.equalities {
        report.line(mode, &format!("{} . g = 0", vector(row)));
    }
    for face in &cone.faces {
        report.line(mode, &format!("{} . g {} 0", vector(&face.normal), if face.strict { "<" } else { "<=" }));
    }
    for face in &cone.excluded {
        report.line(mode, &format!("{} . g < 0 (a missing edge or apex)", vector(&face.normal)));
    }
    for row in &cone.lines {
        report.line(mode, &format!("line {}", vector(row)));
    }
    for row in &cone.rays {
        report.line(mode, &format!("ray {}", vector(row)));
    }
}

fn vector(row: &[Z]) -> String {
    format!("({})", row.iter().map(Z::to_string).collect::<Vec<_>>().join(", "))
}

fn count(n: usize, noun: &str) -> String {
    if n == 1 { format!("1 {noun}") } else { format!("{n} {noun}s") }
}
