//! The document of `plan chart`.

use crate::answer::{Chart, ChartPoint, ChartTile};
use crate::report::csv::{command, command_of};
use serde_json::{Map, Value, json};

/// Schema of `plan chart`.
pub const CHART: &str = "plan.chart/1";

/// The document of `plan chart`: every point and tile; times are CPU times in s: lower quartile, median, upper quartile.
#[must_use]
pub fn chart(chart: &Chart) -> Value {
    let conditions: Map<String, Value> =
        chart.conditions.iter().map(|(name, value)| (name.clone(), json!(value))).collect();
    json!({
        "schema": CHART,
        "version": env!("CARGO_PKG_VERSION"),
        "status": if chart.limit.is_some() { "undecided" } else { "plan" },
        "conditions": conditions,
        "result": {
            "points": chart.points.iter().map(|one| point(chart, one)).collect::<Value>(),
            "tiles": chart.tiles.iter().map(|one| tile(chart, one)).collect::<Value>(),
            "limit": chart.limit.map(|limit| limit.name()),
        },
    })
}

fn point(chart: &Chart, point: &ChartPoint) -> Value {
    json!({
        "family": point.family.name(),
        "work": point.work,
        "method": point.method,
        "setting": point.setting,
        "error": point.error,
        "failed": point.failed,
        "of": point.of,
        "time": point.time,
        "command": command_of(chart, point),
    })
}

fn tile(chart: &Chart, tile: &ChartTile) -> Value {
    json!({
        "map": tile.map.name(),
        "method": tile.method,
        "x": tile.x,
        "y": tile.y,
        "succeeded": tile.succeeded,
        "ambiguous": tile.ambiguous,
        "failed": tile.failed,
        "command": command(chart, &tile.id()),
    })
}
