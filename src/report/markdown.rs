//! Tables of a chart for a README.

use super::decimal::{duration, near, percent_of};
use super::ladder;
use crate::answer::{Chart, ChartFamily, ChartMap, ChartPoint};
use std::fmt::Write as _;

/// A table for each family, methods beside each other at the last setting of their curves; for the model ladder each
/// automatic choice beside the cheapest rung; for each map the share of tiles that succeed throughout.
#[must_use]
pub fn chart(chart: &Chart) -> String {
    let mut text = String::from("Measured with");
    let conditions = chart.conditions.iter().map(|(name, value)| cell(&format!(" {name} {value}")));
    let _ = writeln!(text, "{}.", conditions.collect::<Vec<_>>().join(","));
    for family in ChartFamily::ALL {
        let points: Vec<&ChartPoint> = chart.points.iter().filter(|point| point.family == family).collect();
        if points.is_empty() {
            continue;
        }
        let _ = writeln!(text, "\n**{}**: {} in {}\n", family.title(), family.error(), family.time());
        if family == ChartFamily::Ladder { choices(&mut text, chart) } else { methods(&mut text, &points) }
    }
    maps(&mut text, chart);
    text
}

/// Works down, methods across.
fn methods(text: &mut String, points: &[&ChartPoint]) {
    let methods = distinct(points.iter().map(|point| point.method.as_str()));
    let names = methods.iter().map(|method| cell(method)).collect::<Vec<_>>();
    let _ = writeln!(text, "| work | {} |\n|---{}|", names.join(" | "), "|---".repeat(methods.len()));
    for work in distinct(points.iter().map(|point| point.work.as_str())) {
        let last = |method: &&str| {
            let last = points.iter().rfind(|point| point.work == work && point.method == **method);
            last.map_or_else(String::new, |point| cell(&shown(point)))
        };
        let cells = methods.iter().map(last).collect::<Vec<_>>();
        let _ = writeln!(text, "| {} | {} |", cell(work), cells.join(" | "));
    }
}

/// Error, time and setting of a point.
fn shown(point: &ChartPoint) -> String {
    format!("{} ({})", measured(point), point.setting)
}

/// Error and time of a point, and what share of its runs failed.
pub(super) fn measured(point: &ChartPoint) -> String {
    let error = point.error.map_or_else(|| "no answer".to_owned(), |error| near(error, 2));
    let failed = match point.failed {
        0 => String::new(),
        failed => format!(", {} fail", percent_of(failed, point.of)),
    };
    format!("{error} in {}{failed}", duration(point.time[1]))
}

fn choices(text: &mut String, chart: &Chart) {
    let _ = writeln!(text, "| {} |\n|---|---|---|---|---|---|", ladder::HEADINGS.join(" | "));
    for row in ladder::rows(chart) {
        let _ = writeln!(text, "| {} |", row.cells().map(|text| cell(&text)).join(" | "));
    }
}

fn maps(text: &mut String, chart: &Chart) {
    let shown: Vec<ChartMap> =
        ChartMap::ALL.into_iter().filter(|map| chart.tiles.iter().any(|tile| tile.map == *map)).collect();
    if shown.is_empty() {
        return;
    }
    let _ = writeln!(text, "\n**Where methods fail**: share of runs over all tiles of a map\n");
    let _ =
        writeln!(text, "| map | method | succeed | say that there is no single answer | fail |\n|---|---|---|---|---|");
    for map in shown {
        let tiles = || chart.tiles.iter().filter(|tile| tile.map == map);
        for method in distinct(tiles().map(|tile| tile.method.as_str())) {
            let counts = tiles()
                .filter(|tile| tile.method == method)
                .map(|tile| [tile.succeeded, tile.ambiguous, tile.failed])
                .fold([0; 3], |sum: [u64; 3], counts| [0, 1, 2].map(|at| sum[at].saturating_add(counts[at])));
            let of = counts.into_iter().fold(0, u64::saturating_add);
            let [good, ambiguous, failed] = counts.map(|count| percent_of(count, of));
            let method = cell(method);
            let _ = writeln!(text, "| {} | {method} | {good} | {ambiguous} | {failed} |", map.title());
        }
    }
}

/// A text in which Markdown sees no end of a cell, of a line, and no tag.
fn cell(text: &str) -> String {
    text.replace('\\', r"\\").replace('|', r"\|").replace('<', "&lt;").replace(['\r', '\n'], " ")
}

/// Each once, in the order of their first occurrence.
pub(super) fn distinct<'a>(names: impl Iterator<Item = &'a str>) -> Vec<&'a str> {
    let mut found = Vec::new();
    for name in names {
        if !found.contains(&name) {
            found.push(name);
        }
    }
    found
}
