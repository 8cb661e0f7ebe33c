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
    let conditions = chart.conditions.iter().map(|(name, value)| format!(" {name} {value}"));
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
    let _ = writeln!(text, "| work | {} |\n|---{}|", methods.join(" | "), "|---".repeat(methods.len()));
    for work in distinct(points.iter().map(|point| point.work.as_str())) {
        let cell = |method: &&str| {
            let last = points.iter().rfind(|point| point.work == work && point.method == **method);
            last.map_or_else(String::new, |point| shown(point))
        };
        let _ = writeln!(text, "| {work} | {} |", methods.iter().map(cell).collect::<Vec<_>>().join(" | "));
    }
}

/// Error, time and setting of a point.
fn shown(point: &ChartPoint) -> String {
    let error = point.error.map_or_else(|| "no answer".to_owned(), |error| near(error, 2));
    let failed = match point.failed {
        0 => String::new(),
        failed => format!(", {} fail", percent_of(failed, point.of)),
    };
    format!("{error} in {}{failed} ({})", duration(point.time[1]), point.setting)
}

fn choices(text: &mut String, chart: &Chart) {
    let _ = writeln!(text, "| {} |\n|---|---|---|---|---|---|", ladder::HEADINGS.join(" | "));
    for row in ladder::rows(chart) {
        let _ = writeln!(text, "| {} |", row.cells().join(" | "));
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
                .fold([0; 3], |[a, b, c], tile| [a + tile.succeeded, b + tile.ambiguous, c + tile.failed]);
            let of = counts.iter().sum();
            let [good, ambiguous, failed] = counts.map(|count| percent_of(count, of));
            let _ = writeln!(text, "| {} | {method} | {good} | {ambiguous} | {failed} |", map.title());
        }
    }
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
