//! `plan insert` in words.

use super::super::decimal::{self, near, percent};
use super::super::{Subject, phrase};
use super::friction;
use super::lines::Report;
use crate::answer::{Action, EmptyReason, FingerSet, Insertion, NearestChange, Recommendation};
use crate::exact::{Z, to_f64};
use num_traits::Signed as _;

/// The answer, how to apply it, and what else would do.
#[must_use]
pub fn insertion(subject: &Subject, answer: &Insertion) -> String {
    let mut report = Report::new(&phrase::insertion(subject, answer));
    if let Some(plan) = &answer.plan {
        recommend(&mut report, subject, plan);
    }
    most_robust(&mut report, subject, answer);
    if let Some(friction) = answer.critical_friction.as_ref().and_then(friction::critical) {
        report.line("friction", &friction);
    }
    if let Some(reason) = &answer.empty_because {
        explain(&mut report, reason, answer.nearest_change.as_ref());
    }
    if !answer.acyclic.is_empty() {
        alternatives(&mut report, subject, answer);
        report.line("wrenches", &shares(answer));
    }
    report.wrenches(&answer.wrenches);
    report.modes(&answer.modes);
    report.fixels(subject);
    report.finish()
}

fn recommend(report: &mut Report, subject: &Subject, plan: &Recommendation) {
    let unit = subject.part.unit.symbol();
    match &plan.action {
        Action::PushEdge { edge, interval, s, point, direction } => {
            let along = decimal::place_on_edge(&phrase::edge_length2(subject, *edge), interval, s);
            report.line("aim", &format!("{along} {unit} from vertex {edge}, at {} {unit}", phrase::point(point)));
            report.line("direction", &format!("{} deg, square to the edge", phrase::heading(direction)));
        }
        Action::PushArc { direction, .. } => {
            report.line("aim", &format!("from {} deg towards the center", degrees(direction)));
        }
        Action::Tilt { direction, .. } => {
            report.line("aim", &format!("gravity towards {} deg", degrees(direction)));
        }
        Action::Wrench => {
            report.line("wrench", &format!("along (fx, fy, torque) = {}", phrase::tuple(&plan.wrench)));
        }
    }
    let rho = near(to_f64(&subject.part.gyration2()).sqrt(), 4);
    report.line(
        "margin",
        &format!(
            "at least {} % of it in any direction (torque counted over {rho} {unit})",
            decimal::percent_at_least(&plan.margin2)
        ),
    );
    report.line("", &margin_means(subject, plan));
}

/// What the margin allows of one error at a time.
fn margin_means(subject: &Subject, plan: &Recommendation) -> String {
    let (rho2, unit) = (subject.part.gyration2(), subject.part.unit.symbol());
    let shift = decimal::root_at_least(&(&plan.margin2 * &rho2));
    let turn = decimal::arcsine_at_least(&plan.margin2);
    match &plan.action {
        Action::PushEdge { point, .. } => {
            // turned by φ about its point at arm p, a push f changes by at most φ |f| sqrt(1 + p²/ρ²)
            let [fx, fy, torque] = &plan.wrench;
            let arm = [0, 1].map(|axis| &point[axis] - &subject.part.center_of_mass[axis]);
            let of_wrench = &rho2 + torque * torque / (fx * fx + fy * fy);
            let of_turn = &rho2 + &arm[0] * &arm[0] + &arm[1] * &arm[1];
            let turn = decimal::degrees_at_least(&(&plan.margin2 * of_wrench / of_turn));
            format!("so {shift} {unit} along the edge, or {turn} deg about the point")
        }
        Action::PushArc { .. } => format!("so {shift} {unit} off its line"),
        Action::Tilt { .. } => format!("so {turn} deg of tilt, or {shift} {unit} between gravity and center of mass"),
        Action::Wrench => format!("so {turn} deg of its force, or {shift} {unit} off its line"),
    }
}

/// The largest margin that any wrench has, and in which set: the smaller one if it has no less.
fn most_robust(report: &mut Report, subject: &Subject, answer: &Insertion) {
    let Some(robust) = answer.robust_acyclic.as_ref().filter(|robust| robust.radius2.is_positive()) else { return };
    let is_in_goal = answer.robust.as_ref().is_some_and(|of_goal| of_goal.radius2 >= robust.radius2);
    let shift = decimal::root_at_least(&(&robust.radius2 * subject.part.gyration2()));
    report.line(
        "robust",
        &format!(
            "up to {} % in {} by the wrench {}: {} deg of its force or {shift} {} off its line",
            decimal::percent_at_least(&robust.radius2),
            if is_in_goal { "goal" } else { "acyclic" },
            phrase::tuple(&robust.wrench),
            decimal::arcsine_at_least(&robust.radius2),
            subject.part.unit.symbol(),
        ),
    );
}

fn explain(report: &mut Report, reason: &EmptyReason, change: Option<&NearestChange>) {
    if let EmptyReason::BlockingModes { modes } = reason {
        report.line("because", &format!("every wrench is consistent with one of the modes {}", modes.join(" ")));
    }
    let change = change.and_then(friction::change);
    change.iter().for_each(|change| report.line("try", change));
    report.line(if change.is_some() { "or" } else { "try" }, phrase::remedy(reason));
}

fn alternatives(report: &mut Report, subject: &Subject, answer: &Insertion) {
    let action = answer.plan.as_ref().map(|plan| &plan.action);
    let mut fingers = answer.acyclic_fingers.clone();
    if let (Some(Action::PushEdge { edge, interval, .. }), FingerSet::Edges(edges)) = (action, &mut fingers) {
        for fingers in edges.iter_mut().filter(|fingers| fingers.edge == *edge) {
            fingers.intervals.retain(|other| other != interval);
        }
    }
    let recommended = matches!(action, Some(Action::PushEdge { .. } | Action::PushArc { .. }));
    let none = if recommended { "no other place" } else { "no place will do" };
    let label = if recommended { "or push" } else { "push" };
    let places = match (action, &answer.acyclic_fingers) {
        (Some(Action::PushArc { .. }), FingerSet::Arcs(set)) if set.arcs.len() < 2 => Vec::new(),
        _ => phrase::places(subject, &fingers),
    };
    report.list(label, &places, none);
    if !matches!(action, Some(Action::Tilt { .. })) || answer.acyclic_tilt.arcs.len() > 1 {
        let tilts = phrase::directions(&answer.acyclic_tilt, "gravity towards");
        report.list("or tilt", &tilts, "gravity alone seats it in no direction");
    }
}

fn shares(Insertion { goal, acyclic, hold, .. }: &Insertion) -> String {
    if !acyclic.has_interior() {
        return "the wrenches that seat it have no interior: any disturbance may spoil them".to_owned();
    }
    let steady = if goal.is_empty() {
        "none adds a contact at every step".to_owned()
    } else {
        let held = if hold.is_empty() { "none".to_owned() } else { format!("{} %", percent(&hold.volume_in_box)) };
        format!("{} % add a contact at every step, {held} hold it still then", percent(&goal.volume_in_box))
    };
    format!("{} % of all wrenches seat it; {steady}", percent(&acyclic.volume_in_box))
}

fn degrees(direction: &[Z; 2]) -> String {
    near(decimal::angle(direction), 4)
}
