//! `plan pins` in words.

use super::super::decimal::{self, Span};
use super::super::{Ride, height, phrase};
use super::lines::Report;
use super::orientation;
use crate::answer::{Margins, Obstacle, Pin, PinPlan, Pins, Wiper};
use crate::exact::Algebraic;
use crate::model::Range;
use num_traits::Zero as _;
use std::collections::BTreeMap;

/// Edges named in full up to this many.
const MOST_NAMED: usize = 8;

/// The pins as a table, or why there are none, then what pins do to each orientation.
#[must_use]
pub fn pins(ride: &Ride, answer: &Pins) -> String {
    let plan = &answer.plan;
    let mut report = Report::new(&phrase::pins(ride, answer));
    table(&mut report, ride, plan.sequence.as_deref().unwrap_or_default());
    if let Some(margins) = &plan.margins {
        report.line("margins", &bounds(ride, margins));
    }
    tradeoffs(&mut report, ride, plan);
    if let Some(obstacle) = &plan.obstacle {
        explain(&mut report, ride, answer, obstacle);
    }
    if let Some(least) = plan.needs {
        report.line("try", &format!("--max-pins {least}"));
    }
    if let (Some(limit), true) = (plan.limit, plan.is_decided()) {
        report.line("incomplete", &format!("the {} limit ended the search: better ones may exist", limit.name()));
    }
    orientation::queries(&mut report, ride, answer);
    orientation::orientations(&mut report, answer);
    searched(&mut report, plan);
    uncertain(&mut report, ride, plan);
    report.finish()
}

/// A row for each pin; nothing if there are none.
fn table(report: &mut Report, ride: &Ride, pins: &[Pin]) {
    if pins.is_empty() {
        return;
    }
    let unit = ride.part.unit.symbol();
    let headings = [
        "pin".to_owned(),
        format!("height {unit}"),
        "±".to_owned(),
        format!("works from {unit}"),
        "to".to_owned(),
        "what it does, by edge down".to_owned(),
    ];
    let row = |(index, pin): (usize, &Pin)| {
        let [height, tolerance] = height::with_tolerance(&pin.height, &pin.tolerance);
        let [from, to] = match height::between(&pin.low, &pin.high) {
            Span::Between(from, to) => [from, to],
            Span::Single(at) => [at, String::new()],
        };
        [(index + 1).to_string(), height, tolerance, from, to, turns(&pin.outcome)]
    };
    let rows: Vec<[String; 6]> = std::iter::once(headings).chain(pins.iter().enumerate().map(row)).collect();
    report.table(&rows);
}

/// Which edges go where, and which stay.
fn turns(outcome: &BTreeMap<usize, usize>) -> String {
    let mut moved: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    let mut kept = Vec::new();
    for (from, to) in outcome {
        if from == to { kept.push(*from) } else { moved.entry(*to).or_default().push(*from) }
    }
    let turned = moved.iter().map(|(to, from)| format!("{} to {to}", phrase::numbered(from, MOST_NAMED)));
    let turned: Vec<String> = turned.collect();
    let kept = phrase::numbered(&kept, MOST_NAMED);
    match (turned.is_empty(), kept.is_empty()) {
        (true, _) => format!("leaves {kept}"),
        (false, true) => format!("turns {}", turned.join("; ")),
        (false, false) => format!("turns {}; leaves {kept}", turned.join("; ")),
    }
}

/// How far what the case states may be off.
fn bounds(ride: &Ride, margins: &Margins) -> String {
    let friction = |name: &str, found: &Range, given: &Range| {
        let (min, max) = (Algebraic::from(found.min.clone()), Algebraic::from(found.max.clone()));
        let is_all = found.max == &given.max * &margins.friction_tried;
        match height::between(&min, &max) {
            Span::Between(min, max) => format!("{name} {min} to {max}{}", if is_all { " and more" } else { "" }),
            Span::Single(at) => format!("{name} {at}"),
        }
    };
    format!(
        "{}; {}; center of mass ±{} {}: each by itself",
        friction("belt", &margins.belt_friction, &ride.conveyor.belt_friction),
        friction("pins", &margins.pin_friction, &ride.conveyor.pin_friction),
        decimal::root_at_least(&(&margins.center_of_mass * &margins.center_of_mass)),
        ride.part.unit.symbol()
    )
}

fn tradeoffs(report: &mut Report, ride: &Ride, plan: &PinPlan) {
    let rows = plan.pareto.iter().map(|row| {
        let tolerance = decimal::root_at_least(&(&row.tolerance * &row.tolerance));
        format!("±{tolerance} {} at the tightest of {}", ride.part.unit.symbol(), phrase::count(row.pins, "pin"))
    });
    let rows: Vec<String> = rows.collect();
    if !rows.is_empty() {
        report.list("tolerance", &rows, "");
    }
}

fn explain(report: &mut Report, ride: &Ride, answer: &Pins, obstacle: &Obstacle) {
    let stable = answer.stable.len();
    let is_stuck = obstacle.smallest_sets.iter().any(|set| set.len() == stable);
    if answer.orientations.iter().all(|orientation| orientation.topple.is_empty()) {
        report.line("because", "no pin topples the part, whatever its height");
    } else if is_stuck {
        report.line("because", "no pin moves an orientation without jamming one that may come along");
    } else {
        let sets: Vec<String> = obstacle.smallest_sets.iter().map(|set| left(answer, set)).collect();
        report.list("because", &sets, "pins leave more than one");
    }
    let everything = stable * stable.saturating_sub(1) / 2;
    if obstacle.inseparable_pairs.len() == everything {
        report.line("never one", "no sequence of pins brings any two orientations together");
    } else if !obstacle.inseparable_pairs.is_empty() {
        let pairs = partners(&obstacle.inseparable_pairs);
        report.line("never one", &format!("no sequence of pins brings together {}", pairs.join("; ")));
    }
    if !is_stuck && !obstacle.never_moved.is_empty() {
        let never = edges(&obstacle.never_moved);
        report.line("never moved", &format!("{never}: no pin moves them without jamming what may come along"));
    }
    if let Some(other) = &obstacle.friction {
        let belt = match other.belt_friction == ride.conveyor.belt_friction {
            true => String::new(),
            false => format!(" and belt friction {}", phrase::range(&other.belt_friction)),
        };
        let most = phrase::count(other.pins, "pin");
        report.line(
            "try",
            &format!(
                "pins that roll freely{belt}: then {most} turn{} the part",
                if other.pins == 1 { "s" } else { "" }
            ),
        );
    }
    if let Some(wiper) = &obstacle.wiper {
        report.line(if obstacle.friction.is_some() { "or" } else { "try" }, &wipe(answer, wiper));
        table(report, ride, &wiper.pins);
    }
}

/// What pins leave of all orientations.
fn left(answer: &Pins, set: &[usize]) -> String {
    let edges = edges(set);
    let is_one = answer.symmetry.classes.iter().any(|class| set.iter().all(|edge| class.contains(edge)));
    if is_one { format!("pins can turn them into {edges} down instead") } else { format!("pins leave {edges} at best") }
}

/// Each first of the pairs with all of its partners.
fn partners(pairs: &[[usize; 2]]) -> Vec<String> {
    let mut partners: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for [first, second] in pairs {
        partners.entry(*first).or_default().push(*second);
    }
    let named = partners
        .iter()
        .take(MOST_NAMED)
        .map(|(first, others)| format!("{first} with {}", phrase::numbered(others, MOST_NAMED)));
    let more = partners.len().checked_sub(MOST_NAMED).filter(|more| *more > 0);
    named.chain(more.map(|more| format!("and others with {more} more"))).collect()
}

fn wipe(answer: &Pins, wiper: &Wiper) -> String {
    let behind = match wiper.pins.len() {
        0 => "a wiper".to_owned(),
        1 => "1 pin and behind it a wiper".to_owned(),
        n => format!("{n} pins and behind them a wiper"),
    };
    format!(
        "{behind} that takes {} off the belt: edge {} is left, {} of {} orientations end there",
        edges(&wiper.discarded),
        wiper.kept,
        wiper.yielding,
        answer.stable.len()
    )
}

fn searched(report: &mut Report, plan: &PinPlan) {
    let searched = &plan.searched;
    report.line(
        "searched",
        &format!(
            "{} of heights with {}, {} of orientations",
            phrase::count(searched.height_classes, "band"),
            phrase::count(searched.distinct_outcome_maps, "different outcome"),
            phrase::count(searched.reachable_sets, "set")
        ),
    );
}

/// Friction and center of mass, and for what of it the answer holds.
fn uncertain(report: &mut Report, ride: &Ride, plan: &PinPlan) {
    let (conveyor, tolerance) = (ride.conveyor, &ride.part.center_of_mass_tolerance);
    let (belt, pins) = (phrase::range(&conveyor.belt_friction), phrase::range(&conveyor.pin_friction));
    let mut text = format!("belt {belt}, pins {pins}");
    if !tolerance.is_zero() {
        text += &format!("; center of mass within ±{} {}", decimal::brief(tolerance), ride.part.unit.symbol());
    }
    if ride.is_uncertain() && plan.sequence.is_some() {
        text += ": the plan holds for every value";
    } else if ride.is_uncertain() && plan.is_decided() {
        text += ": no plan holds for every value, one may for narrower ranges";
    }
    report.line("friction", &text);
}

/// `edge 1`, `edges 1, 2 and 3`.
pub(super) fn edges(edges: &[usize]) -> String {
    format!("edge{} {}", if edges.len() == 1 { "" } else { "s" }, phrase::numbered(edges, MOST_NAMED))
}
