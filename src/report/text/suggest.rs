//! `plan insert --suggest` in words.

use super::super::decimal;
use super::super::{Subject, phrase};
use super::friction;
use super::lines::Report;
use crate::answer::{Action, Proposal, Recommendation, Suggestion};

/// The best places, then every proposal in a few lines.
#[must_use]
pub fn suggestion(subject: &Subject, answer: &Suggestion) -> String {
    let mut report = Report::new(&phrase::suggestion(answer));
    for (index, proposal) in answer.proposals.iter().enumerate() {
        describe(&mut report, subject, index + 1, proposal);
    }
    if let Some(reason) = &answer.empty_because {
        report.line("try", phrase::remedy(reason));
        return report.finish();
    }
    if let Some(limit) = answer.limit {
        let ended = format!("the {} limit ended the search; these are the best so far", limit.name());
        report.line("incomplete", &ended);
    }
    let searched = &answer.searched;
    report.line(
        "searched",
        &format!(
            "{} of {} choices of edges, {} fixtures estimated, {} planned exactly",
            searched.choices, searched.of, searched.estimated, searched.planned
        ),
    );
    let closing = if answer.proposals.is_empty() {
        "a search, no proof that there are none"
    } else {
        "a search: better places may exist"
    };
    report.line("", closing);
    report.finish()
}

fn describe(report: &mut Report, subject: &Subject, number: usize, proposal: &Proposal) {
    let unit = subject.part.unit.symbol();
    report.line(&format!("proposal {number}"), &phrase::proposal(proposal));
    let fixels: Vec<String> = proposal
        .fixture
        .fixels
        .iter()
        .zip(&proposal.places)
        .enumerate()
        .map(|(index, (fixel, (edge, s)))| {
            format!("{index} on edge {edge} at {s} of it, at {} {unit}", phrase::point(&fixel.point))
        })
        .collect();
    report.list("fixels", &fixels, "none");
    aim(report, subject, &proposal.plan);
    if let Some(friction) = proposal.critical_friction.as_ref().and_then(friction::critical) {
        report.line("friction", &friction);
    }
}

fn aim(report: &mut Report, subject: &Subject, plan: &Recommendation) {
    let unit = subject.part.unit.symbol();
    match &plan.action {
        Action::PushEdge { edge, interval, s, point, .. } => {
            let along = decimal::place_on_edge(&phrase::edge_length2(subject, *edge), interval, s);
            report.line("push", &format!("{along} {unit} from vertex {edge}, at {} {unit}", phrase::point(point)));
        }
        Action::Tilt { direction, .. } => {
            report.line("tilt", &format!("gravity towards {} deg", decimal::near(decimal::angle(direction), 4)));
        }
        Action::PushArc { .. } | Action::Wrench => {}
    }
}
