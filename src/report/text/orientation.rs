//! What pins of all heights, and of given heights, do to each orientation.

use super::super::decimal::{self, Span};
use super::super::{Ride, height, phrase};
use super::lines::Report;
use super::pins;
use crate::answer::{HeightQuery, Orientation, PinAction, Pins};
use std::collections::BTreeMap;

/// Orientations and edges named in full up to this many.
const MOST_NAMED: usize = 8;

/// Heights listed for each action up to this many.
const MOST_HEIGHTS: usize = 4;

/// A line for each class of orientations that look the same.
pub(super) fn orientations(report: &mut Report, answer: &Pins) {
    let classes = &answer.symmetry.classes;
    let shown = if classes.len() > MOST_NAMED { MOST_NAMED - 1 } else { classes.len() };
    let of = |class: &Vec<usize>| answer.orientations.iter().find(|one| class.first() == Some(&one.edge));
    for (class, orientation) in classes[..shown].iter().filter_map(|class| Some((class, of(class)?))) {
        let alike = match &class[1..] {
            [] => String::new(),
            others => format!("; {} alike", phrase::numbered(others, MOST_NAMED)),
        };
        report.line(&format!("edge {}", orientation.edge), &(describe(orientation) + &alike));
        if let Some([from, to]) = &orientation.repeat_over_dip {
            let dip = about(from.to_f64(), to.to_f64());
            report.line("", &format!("where it repeats {dip} it ducks below the pin, and may pass instead"));
        }
    }
    if shown < classes.len() {
        report.line("", &format!("and {} more (--format json lists all)", classes.len() - shown));
    }
    if answer.orientations.iter().any(|orientation| !orientation.topple.is_empty()) {
        report.line("", "repeat: it topples and meets the pin again; pass: it topples and leaves the pin behind");
    }
}

/// A line for each height that was asked about.
pub(super) fn queries(report: &mut Report, ride: &Ride, answer: &Pins) {
    for query in &answer.queries {
        let label = format!("at {} {}", decimal::brief(&query.height), ride.part.unit.symbol());
        report.line(&label, &fates(query));
        if !query.critical_for.is_empty() {
            let edges = pins::edges(&query.critical_for);
            report.line("", &format!("exactly critical for {edges}: the least error may change what happens"));
        }
    }
}

/// Where a part topples to, and the heights of each action but jamming.
fn describe(orientation: &Orientation) -> String {
    let mut heights: BTreeMap<Option<PinAction>, Vec<String>> = BTreeMap::new();
    let mut jams = false;
    for interval in &orientation.intervals {
        let range = match (interval.action, &interval.to) {
            (Some(PinAction::Jam), _) => {
                jams = true;
                continue;
            }
            (_, None) => format!("from {}", height::beyond(&interval.from)),
            (None, Some(to)) => about(interval.from.to_f64(), to.to_f64()),
            (Some(_), Some(to)) => match height::between(&interval.from, to) {
                Span::Single(at) => format!("about {at}"),
                Span::Between(from, to) => format!("{from} to {to}"),
            },
        };
        heights.entry(interval.action).or_default().push(range);
    }
    let listed = |(action, heights): (&Option<PinAction>, &Vec<String>)| {
        let shown = heights.len().min(MOST_HEIGHTS);
        let more = if shown < heights.len() { ", ..." } else { "" };
        let name = action.map_or("depends on what is uncertain", words);
        format!("{name} {}{more}", phrase::joined(&heights[..shown], "and"))
    };
    let next =
        if orientation.topple.is_empty() { "never topples".to_owned() } else { format!("onto {}", orientation.next) };
    // actions in their order, passes first, what is uncertain last
    let actions = heights.iter().rev().map(listed).chain(jams.then(|| "else jam".to_owned()));
    format!("{next}: {}", actions.collect::<Vec<_>>().join("; "))
}

fn words(action: PinAction) -> &'static str {
    match action {
        PinAction::PassUnder => "pass under",
        PinAction::FallBack => "fall back",
        PinAction::Jam => "jam",
        PinAction::Repeat => "repeat",
        PinAction::Pass => "pass",
    }
}

fn about(from: f64, to: f64) -> String {
    format!("about {} to {}", decimal::near(from, 5), decimal::near(to, 5))
}

/// What becomes of the edges at one height, those of one fate together.
fn fates(query: &HeightQuery) -> String {
    let is_certain = query.actions.values().all(Option::is_some);
    let mut fates: Vec<(String, Vec<usize>)> = Vec::new();
    for (edge, action) in &query.actions {
        let outcome = query.outcomes.get(edge).copied().flatten();
        let fate = match (action, outcome) {
            (None, _) => "undetermined, it depends on what is uncertain".to_owned(),
            (Some(action @ (PinAction::PassUnder | PinAction::FallBack | PinAction::Jam)), _) => {
                words(*action).to_owned()
            }
            (Some(action), Some(end)) => format!("{}, end on {end}", words(*action)),
            (Some(action), None) if is_certain => format!("{}, then jam", words(*action)),
            (Some(action), None) => format!("{}, then jam or it is uncertain", words(*action)),
        };
        match fates.iter_mut().find(|(other, _)| *other == fate) {
            Some((_, edges)) => edges.push(*edge),
            None => fates.push((fate, vec![*edge])),
        }
    }
    let fates = fates.iter().map(|(fate, edges)| format!("{}: {fate}", phrase::numbered(edges, MOST_NAMED)));
    fates.collect::<Vec<_>>().join("; ")
}
