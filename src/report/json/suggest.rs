//! The document of `plan insert --suggest`.

use super::super::Subject;
use super::friction::critical_friction;
use super::number::{range, rational, rationals};
use super::{context, empty_because, envelope, plan};
use crate::answer::{Proposal, Suggestion};
use crate::exact::to_f64;
use crate::model::{Fixel, Friction};
use serde_json::{Value, json};

/// Schema of `plan insert --suggest`.
pub const SUGGEST: &str = "plan.suggest/1";

/// The document of `plan insert --suggest`; `insert` of each proposal can take the place of the section in the case.
#[must_use]
pub fn suggestion(subject: &Subject, answer: &Suggestion) -> Value {
    let mut result = context(subject);
    // those of the case are what is to be replaced
    result.remove("fixels");
    let searched = &answer.searched;
    result.insert("proposals".into(), answer.proposals.iter().map(proposal).collect());
    result.insert(
        "searched".into(),
        json!({
            "choices": searched.choices,
            "of": searched.of,
            "estimated": searched.estimated,
            "planned": searched.planned,
        }),
    );
    result.insert("complete".into(), answer.limit.is_none().into());
    if let Some(limit) = answer.limit {
        result.insert("limit".into(), limit.name().into());
    }
    if let Some(reason) = &answer.empty_because {
        result.insert("empty_because".into(), empty_because(reason));
    }
    let status = match (answer.proposals.is_empty(), answer.limit) {
        (false, _) => "plan",
        (true, None) => "no-plan",
        (true, Some(_)) => "undecided",
    };
    envelope(subject, SUGGEST, status, result)
}

fn proposal(proposal: &Proposal) -> Value {
    let placed = || proposal.fixture.fixels.iter().zip(&proposal.places);
    let fixel = |(fixel, (edge, s)): (&Fixel, &(usize, crate::exact::Q))| {
        json!({
            "edge": edge,
            "s": rational(s),
            "at": rationals(&fixel.point),
            "normal": rationals(&fixel.normal),
        })
    };
    let given = |(fixel, (edge, s)): (&Fixel, &(usize, crate::exact::Q))| json!({ "edge": edge, "s": rational(s), "friction": friction(&fixel.friction) });
    json!({
        "fixels": placed().map(fixel).collect::<Value>(),
        "plan": plan(&proposal.plan),
        "margin2": rational(&proposal.plan.margin2),
        "margin_approx": to_f64(&proposal.plan.margin2).sqrt(),
        "critical_friction": proposal.critical_friction.as_ref().map(critical_friction),
        "insert": { "fixels": placed().map(given).collect::<Value>() },
    })
}

/// Friction as case files write it.
fn friction(friction: &Friction) -> Value {
    if friction.kinetic == friction.static_ {
        return range(&friction.static_);
    }
    json!({ "static": range(&friction.static_), "kinetic": range(&friction.kinetic) })
}
