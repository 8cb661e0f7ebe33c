//! `plan chart` in words.

use super::super::decimal::near;
use super::super::ladder;
use super::super::markdown::{distinct, measured};
use super::lines::Report;
use crate::answer::{Chart, ChartFamily, ChartMap, ChartPoint};

/// How much was measured, and of each piece of work the most accurate point.
#[must_use]
pub fn chart(chart: &Chart) -> String {
    let families = ChartFamily::ALL.iter().filter(|family| chart.points.iter().any(|point| point.family == **family));
    let maps = ChartMap::ALL.iter().filter(|map| chart.tiles.iter().any(|tile| tile.map == **map));
    let mut report = Report::new(&format!(
        "{} points of {} families and {} tiles of {} maps",
        chart.points.len(),
        families.count(),
        chart.tiles.len(),
        maps.count()
    ));
    for family in ChartFamily::ALL {
        let points = || chart.points.iter().filter(|point| point.family == family);
        for (index, work) in distinct(points().map(|point| point.work.as_str())).into_iter().enumerate() {
            let best = points().filter(|point| point.work == work && point.error.is_some()).min_by(|a, b| {
                let key = |point: &ChartPoint| {
                    (point.failed as f64 / (point.of as f64).max(1.0), point.error.unwrap_or(f64::INFINITY))
                };
                let ((fa, ea), (fb, eb)) = (key(a), key(b));
                fa.total_cmp(&fb).then(ea.total_cmp(&eb)).then(a.time[1].total_cmp(&b.time[1]))
            });
            let said = best.map_or_else(|| "no answers".to_owned(), said);
            report.line(if index == 0 { family.name() } else { "" }, &format!("{work}: {said}"));
        }
    }
    for (index, row) in ladder::rows(chart).into_iter().enumerate() {
        let nothing = if row.auto.error.is_none() { "no answer" } else { "no rung is as accurate" };
        let ratio = row.ratio(row.envelope).map_or_else(
            || nothing.to_owned(),
            |ratio| format!("{} times the cheapest rung as accurate", near(ratio, 2)),
        );
        report
            .line(if index == 0 { "choice" } else { "" }, &format!("{}, {}: {ratio}", row.auto.work, row.auto.setting));
    }
    report.finish()
}

fn said(point: &ChartPoint) -> String {
    format!("{} ({}), {}", point.method, point.setting, measured(point))
}
