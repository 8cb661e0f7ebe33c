//! `plan stable` in words.

use super::super::{Subject, phrase};
use super::cone::describe;
use super::lines::Report;
use crate::answer::Stability;

/// Whether the seated part is in force closure, and where a push is certain to leave it at rest.
#[must_use]
pub fn stability(subject: &Subject, answer: &Stability) -> String {
    let mut report = Report::new(&phrase::stability(answer));
    report.line("weak", &format!("wrenches that can be balanced: {}", describe(&answer.weak)));
    report.list(
        "push holds",
        &phrase::places(subject, &answer.strong_fingers),
        "no finger is certain to hold the part",
    );
    report.list(
        "tilt holds",
        &phrase::directions(&answer.strong_tilt, "gravity towards"),
        "gravity alone is certain to hold it nowhere",
    );
    report.list("push closes", &phrase::places(subject, &answer.closure_fingers), "no finger closes the grasp");
    report.line("modes", &format!("{} feasible: {}", answer.feasible_modes.len(), answer.feasible_modes.join(" ")));
    report.wrenches(&answer.wrenches);
    report.modes(&answer.modes);
    report.fixels(subject);
    report.finish()
}
