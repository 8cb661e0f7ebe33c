//! `plan throw` in words.

use super::super::decimal::{Span, near};
use super::super::{Toss, height, phrase};
use super::lines::Report;
use crate::answer::{
    Carry, Caught, Certificate, Design, Fate, LimitSet, ProofLimit, SensorWindow, SettingKind, SurdRatio, Throw,
    ThrowQuery,
};
use crate::exact::{Algebraic, from_float_exact, to_f64};

/// Edges in the table.
const MOST_EDGES: usize = 10;
/// Edges of a pattern named in full.
const MOST_IN_PATTERN: usize = 12;
/// Ranges of starts on one edge.
const MOST_RANGES: usize = 2;
/// Remarks on what is not as in the paper.
const MOST_PROBLEMS: usize = 3;

/// Where to put the sensor, the pattern that it reads, what of it is proved, and the ranges of each edge.
#[must_use]
pub fn throw(toss: &Toss, answer: &Throw) -> String {
    let mut report = Report::new(&phrase::throw(toss, answer));
    let unit = toss.part.unit.symbol();
    windows(&mut report, answer, unit);
    if let Some(set) = answer.limit.sets.first() {
        report.line("pattern", &pattern(set));
    }
    starts(&mut report, answer, unit);
    safe_starts(&mut report, &answer.certificate, unit);
    report.line("proof", &proof(&answer.certificate, unit));
    slides(&mut report, answer);
    grasp(&mut report, answer, unit);
    if let Some(design) = &answer.design {
        settings(&mut report, design, unit);
    }
    answer.throws.iter().for_each(|query| asked(&mut report, query, unit));
    answer.carries.iter().for_each(|carry| report.line("carry", &carried(carry, unit)));
    edges(&mut report, answer, unit);
    answer.reach.problems.iter().take(MOST_PROBLEMS).for_each(|problem| report.line("note", problem));
    report.finish()
}

/// All places of a sensor that are proved, or were found.
fn windows(report: &mut Report, answer: &Throw, unit: &str) {
    let Some(sensor) = answer.sensors.first() else { return };
    let row = |window: &SensorWindow| {
        let (range, how) = match window.proved {
            Some(range) => (range, "proved"),
            None => (window.range, "not proved"),
        };
        let often = phrase::often(window.throws_per_part);
        let first = match window.settle_throws {
            0 => "from the first throw on".to_owned(),
            n => format!("after {}", phrase::count(n, "throw")),
        };
        let edges = phrase::alike(&window.edges);
        format!("{} {unit} tells {}, {often}, {first}; {how}", between(range), edges.trim_end_matches(','))
    };
    let rows: Vec<String> = sensor.windows.iter().map(row).collect();
    report.list("sensor", &rows, "none: wherever it is covered, several edges may be down");
}

/// Edges in turn, how often the part jogs there, how long it takes.
fn pattern(set: &LimitSet) -> String {
    let jogs = |edge: &usize| match set.jogs.get(edge) {
        Some([0, 0]) | None => edge.to_string(),
        Some([least, most]) if least == most => format!("{edge} ({})", phrase::count(*most, "jog")),
        Some([least, most]) => format!("{edge} ({least} to {most} jogs)"),
    };
    let shown: Vec<String> = set.pattern.iter().take(MOST_IN_PATTERN).map(jogs).collect();
    let order = match (shown.len(), set.pattern.len()) {
        (0, _) => format!("jogs on edge {}", set.main_edge),
        (n, all) if n < all => format!("mostly edge {}, then {} more, and again", shown.join(", "), all - n),
        _ => format!("mostly edge {}, and again", shown.join(", ")),
    };
    let cycle = match set.throws_per_cycle.is_finite() {
        true => {
            let seconds = near(set.throws_per_cycle * set.seconds_per_throw, 3);
            format!("; {} throws and {seconds} s a cycle", near(set.throws_per_cycle, 3))
        }
        false => format!("; {} s a throw", near(set.seconds_per_throw, 3)),
    };
    let kind = match set.period {
        Some(period) => format!("repeats after {}", phrase::count(period, "throw")),
        None if set.lyapunov > 0.0 => "chaotic: neighbours part".to_owned(),
        None => "no period found".to_owned(),
    };
    format!("{order}{cycle}; {kind}")
}

/// Which of the starts come to it, and what becomes of the others.
fn starts(report: &mut Report, answer: &Throw, unit: &str) {
    let (sets, ended) = (&answer.limit.sets, &answer.limit.ended);
    let all = sets.iter().map(|set| set.starts.len()).sum::<usize>() + ended.len();
    let mut parts: Vec<String> = Vec::new();
    for (place, set) in sets.iter().enumerate().take(2) {
        let which = if place == 0 { "come to it within" } else { "from further out come to another one within" };
        let which = if place > 0 && !is_farther(set, &sets[0]) { "come to another one within" } else { which };
        let count = match set.starts.len() {
            n if n == all => format!("all {all}"),
            n if place == 0 => format!("of {all}, {n}"),
            n => n.to_string(),
        };
        parts.push(format!("{count} {which} {}", phrase::count(set.transient, "throw")));
    }
    if sets.len() > 2 {
        parts.push(format!("the rest to {} more", sets.len() - 2));
    }
    if !ended.is_empty() {
        let count = if ended.len() == all { format!("all {all}") } else { ended.len().to_string() };
        parts.push(format!("{count} are lost"));
    }
    report.line("starts", &if all == 0 { "none were followed".to_owned() } else { parts.join("; ") });
    if let Some(first) = ended.first() {
        let (edge, radius) = first.at;
        report.line(
            "",
            &format!(
                "one after {}: edge {edge} at {} {unit} {}",
                phrase::count(first.after, "throw"),
                near(radius, 5),
                end(&first.fate, unit)
            ),
        );
    }
}

/// Whether all of a set lies beyond the other.
fn is_farther(set: &LimitSet, other: &LimitSet) -> bool {
    let least = |set: &LimitSet| set.starts.iter().map(|(_, radius)| *radius).fold(f64::INFINITY, f64::min);
    let most = |set: &LimitSet| set.starts.iter().map(|(_, radius)| *radius).fold(0.0, f64::max);
    least(set) > most(other)
}

/// From where parts are not lost, if that is not everywhere: the widest ranges.
fn safe_starts(report: &mut Report, proof: &Certificate, unit: &str) {
    if proof.is_invariant || !proof.is_unique {
        return;
    }
    let on_edge = |(edge, ranges): (&usize, &Vec<[f64; 2]>)| {
        let mut widest: Vec<&[f64; 2]> = ranges.iter().collect();
        widest.sort_by(|a, b| (b[1] - b[0]).total_cmp(&(a[1] - a[0])));
        let told: Vec<String> = widest.iter().take(MOST_RANGES).map(|range| between(**range)).collect();
        let more = match widest.len().saturating_sub(MOST_RANGES) {
            0 => String::new(),
            more => format!(", and {}", phrase::count(more, "shorter range")),
        };
        format!("edge {edge} at {} {unit}{more}", phrase::joined(&told, "or"))
    };
    let starts: Vec<String> = proof.starts.iter().map(on_edge).collect();
    report.list("start on", &starts, "");
}

fn proof(proof: &Certificate, unit: &str) -> String {
    let cells = format!("{} cells, the narrowest {} {unit}", proof.cells, near(proof.width, 3));
    let stop = match proof.limit {
        Some(ProofLimit::Stopped) => " before it was stopped",
        Some(ProofLimit::Resolution) => " at this resolution",
        None => "",
    };
    if !proof.is_invariant && !proof.is_unique {
        return match proof.counterexample {
            Some(_) => format!("throws lead out of the ranges ({})", phrase::count(proof.images, "image")),
            None => format!("none{stop}"),
        };
    }
    let from = match (proof.is_invariant, proof.z.len()) {
        (false, _) => "throws from the starts above".to_owned(),
        (true, 5..) => "throws from all ranges (--format json lists them)".to_owned(),
        (true, _) => {
            let ranges: Vec<String> =
                proof.z.iter().map(|(edge, range)| format!("{edge} at {}", between(*range))).collect();
            format!("throws from edge {} {unit}", phrase::joined(&ranges, "and"))
        }
    };
    let leads = match proof.components.len() {
        1 => "stay there and come to one pattern".to_owned(),
        n => format!("stay there; that they come to one pattern is not proved{stop}, {n} are left"),
    };
    let beyond = proof.beyond.map_or_else(String::new, |(edge, radius)| {
        format!("; in it, edge {edge} alone is met beyond {} {unit}", upward(radius))
    });
    format!("{from} {leads}{beyond} ({cells})")
}

/// Cycles of the approximated system.
fn slides(report: &mut Report, answer: &Throw) {
    let name = |cycle: &Vec<usize>| {
        let mut names: Vec<String> = cycle.iter().take(MOST_IN_PATTERN).map(usize::to_string).collect();
        names.extend((cycle.len() > MOST_IN_PATTERN).then(|| format!("{} more", cycle.len() - MOST_IN_PATTERN)));
        names.join(", ")
    };
    let cycles: Vec<String> = answer.hybrid.cycles.iter().map(name).collect();
    let said = match &cycles[..] {
        [] => "no cycle: flips lead out of the ranges in which parts slide".to_owned(),
        [only] => format!("one cycle, of edge {only}"),
        several => format!("{} cycles, of edge {}", several.len(), several.join(" or of ")),
    };
    report.line("if jogs slid", &said);
}

/// Where every edge is grasped, and what friction that takes.
fn grasp(report: &mut Report, answer: &Throw, unit: &str) {
    let grasp = &answer.grasp;
    let ratio = |ratio: &SurdRatio| match ratio {
        SurdRatio::Number(value) => value.to_f64(),
        SurdRatio::Quotient(above, below) => above.to_f64() / below.to_f64(),
    };
    let common = match &grasp.mu_common {
        Some((_, mu)) => format!("with friction {}", upward(ratio(mu))),
        None => "with no friction that is enough".to_owned(),
    };
    let single = match &grasp.mu_edgewise {
        Some((_, mu)) => format!("; each from its least radius with {}", upward(mu.to_f64())),
        None => String::new(),
    };
    report.line("grasp", &format!("every edge from {} {unit} {common}{single}", upward(grasp.r_common.1.to_f64())));
}

/// The ranges of each stable edge, and those of the pattern.
fn edges(report: &mut Report, answer: &Throw, unit: &str) {
    let head = ["edge", "thrown from", "flips from", "lands up to", "friction", "in pattern from", "to", "throws %"];
    let mut rows = vec![head.map(str::to_owned).to_vec()];
    let set = answer.limit.sets.first();
    for reach in answer.reach.edges.iter().take(MOST_EDGES) {
        let grasp = answer.edges.iter().find(|edge| edge.edge == reach.edge).and_then(|edge| edge.grasp.as_ref());
        let mu =
            grasp.and_then(|grasp| grasp.mu_edge.as_ref()).map_or_else(|| "-".to_owned(), |mu| upward(mu.to_f64()));
        let band = set.and_then(|set| set.bands.get(&reach.edge));
        let end = |k: usize| band.map_or_else(|| "-".to_owned(), |band| near(band[k], 4));
        let share = set.and_then(|set| set.share.get(&reach.edge)).map_or(0.0, |share| 100.0 * share);
        rows.push(vec![
            reach.edge.to_string(),
            near(reach.r_low, 4),
            reach.r_flip.map_or_else(|| "-".to_owned(), |r_flip| near(r_flip, 4)),
            near(reach.r_max, 4),
            mu,
            end(0),
            end(1),
            near(share, 2),
        ]);
    }
    report.table(&rows);
    match answer.reach.edges.len().checked_sub(MOST_EDGES) {
        Some(more) if more > 0 => report.line("", &format!("and {more} more; lengths in {unit}")),
        _ => report.line("", &format!("lengths in {unit}")),
    }
}

/// A throw that was asked for.
fn asked(report: &mut Report, query: &ThrowQuery, unit: &str) {
    let from = format!("edge {} at {} {unit}", query.edge, near(to_f64(&query.radius), 8));
    match &query.fates[..] {
        [only] if query.is_certain || !matches!(only, Fate::Caught(_) | Fate::OffArm { .. }) => {
            report.line("throw", &format!("{from} {}", fate(only, unit)));
        }
        fates => {
            let within = near(query.within, 2);
            report.line("throw", &format!("{from}: less than {within} {unit} from a break of the map"));
            let told: Vec<String> = fates.iter().map(|one| fate(one, unit)).collect();
            told.iter()
                .enumerate()
                .for_each(|(k, told)| report.line("", &format!("{} {told}", if k == 0 { "it" } else { "or it" })));
        }
    }
}

fn fate(fate: &Fate, unit: &str) -> String {
    match fate {
        Fate::Caught(caught) => landing(caught, unit),
        Fate::UnstableEdge => "does not rest there".to_owned(),
        Fate::NoGrasp => "is not grasped there: it slips or rolls while it is thrown".to_owned(),
        Fate::Overhang => "reaches over the pivot there".to_owned(),
        Fate::OffArm { vertex, x } => {
            format!("meets the line of the arm beside it, vertex {vertex} at {} {unit}", near(*x, 6))
        }
        Fate::Balanced { vertex } => format!("is caught upright on vertex {vertex}"),
    }
}

/// How an orbit ended.
fn end(end: &Fate, unit: &str) -> String {
    match end {
        Fate::Caught(caught) if caught.in_domain => {
            format!("goes on to {} {unit}: it runs away", near(caught.radius, 4))
        }
        end => fate(end, unit),
    }
}

fn landing(caught: &Caught, unit: &str) -> String {
    let (edge, radius) = (caught.edge, near(caught.radius, 8));
    let turned = match caught.steps {
        0 => format!("jogs to {radius} {unit}"),
        steps => {
            let way = if steps > 0 { "counter-clockwise" } else { "clockwise" };
            let steps = usize::try_from(steps.unsigned_abs()).unwrap_or(usize::MAX);
            format!("flips by {} {way} to edge {edge} at {radius} {unit}", phrase::count(steps, "edge"))
        }
    };
    let out = if caught.in_domain { "" } else { ", from where it cannot be thrown again" };
    format!("{turned} after {} s in the air{out}", near(caught.flight_time, 4))
}

fn carried(carry: &Carry, unit: &str) -> String {
    let state = format!(
        "edge {} at {} {unit}, arm at {} deg and {} rad/s",
        carry.edge,
        near(to_f64(&carry.radius), 6),
        near(to_f64(&carry.angle_deg), 6),
        near(to_f64(&carry.rate), 6)
    );
    let Some([from, to]) = &carry.accelerations else { return format!("{state}: it moves, whatever the acceleration") };
    let inner = |end: &Option<[_; 2]>, k: usize| end.as_ref().map(|ends| near(to_f64(&ends[k]), 5));
    match (inner(from, 1), inner(to, 0)) {
        (Some(from), Some(to)) => format!("{state}: it stays still at {from} to {to} rad/s2"),
        (Some(from), None) => format!("{state}: it stays still from {from} rad/s2 up"),
        (None, Some(to)) => format!("{state}: it stays still up to {to} rad/s2"),
        (None, None) => format!("{state}: it stays still at any acceleration"),
    }
}

/// The recommended arm, and what became of all that were tried.
fn settings(report: &mut Report, design: &Design, unit: &str) {
    match (&design.best, &design.why_none) {
        (Some(best), _) => {
            let n = design.releases.len();
            let setting = &design.settings[best.place];
            let proved = if best.is_proved { "proved" } else { "not proved" };
            report.line(
                "best arm",
                &format!(
                    "offset {} {unit}, release {} deg/s: {} parts a second, edge {}, sensor at {} {unit} all over the margin; {proved}",
                    near(design.offsets[best.place / n], 6),
                    near(design.releases[best.place % n], 6),
                    near(setting.rate(), 3),
                    setting.edge.map_or_else(|| "-".to_owned(), |edge| edge.to_string()),
                    between(best.window)
                ),
            );
        }
        (None, why) => report.line("best arm", &format!("none: {}", why.as_deref().unwrap_or("no setting is a plan"))),
    }
    let count = |kind: SettingKind| design.settings.iter().filter(|setting| setting.kind == kind).count();
    let kinds = [
        (SettingKind::Feeder, "feed"),
        (SettingKind::Blind, "have no sensor"),
        (SettingKind::Several, "have several patterns"),
        (SettingKind::Lost, "lose parts"),
        (SettingKind::Open, "were not tried"),
    ];
    let said: Vec<String> = kinds
        .iter()
        .map(|(kind, does)| (count(*kind), does))
        .filter(|(n, _)| *n > 0)
        .map(|(n, does)| format!("{n} {does}"))
        .collect();
    report.line("arms", &format!("of {}, {}", design.settings.len(), phrase::joined(&said, "and")));
}

/// Both ends rounded inward.
fn between([low, high]: [f64; 2]) -> String {
    let exact = |end: f64| from_float_exact(end).map(Algebraic::from);
    match exact(low).zip(exact(high)).map(|(low, high)| height::between(&low, &high)) {
        Some(Span::Between(low, high)) => format!("{low} to {high}"),
        _ => near(low, 12),
    }
}

/// Rounded up.
fn upward(value: f64) -> String {
    let shown = near(value, 5);
    match from_float_exact(value).map(Algebraic::from) {
        Some(exact) if shown.parse().is_ok_and(|shown: f64| shown < value) => height::beyond(&exact),
        _ => shown,
    }
}
