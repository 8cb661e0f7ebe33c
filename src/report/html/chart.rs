//! The page of `plan chart`: all figures, tables and the numbers behind them in one file.

use super::{document, escaped};
use crate::answer::{Chart, ChartFamily, ChartMap};
use crate::report::decimal::duration;
use crate::report::{csv, ladder, svg};
use std::fmt::Write as _;

const STYLE: &str = include_str!("chart.css");

/// Charts, maps, the table of automatic choices, and every point with the command that measures it again.
#[must_use]
pub fn chart(chart: &Chart) -> String {
    let mut body = String::new();
    let conditions = chart.conditions.iter().map(|(name, value)| row(&[name, value]));
    let _ = write!(body, "<table>{}</table>", conditions.collect::<String>());
    for family in ChartFamily::ALL {
        if let Some(figure) = svg::chart(chart, family) {
            let _ = write!(body, "<h2>{}</h2>{}", escaped(family.title()), inline(&figure));
        }
        if family == ChartFamily::Ladder {
            body.push_str(&choices(chart));
        }
    }
    for map in ChartMap::ALL {
        if let Some(figure) = svg::failures(chart, map) {
            let _ = write!(body, "<h2>Where methods fail: {}</h2>{}", escaped(map.title()), inline(&figure));
        }
    }
    body.push_str(&points(chart));
    let data: String = csv::chart(chart).bytes().map(encoded).collect();
    let policy = "default-src 'none'; style-src 'unsafe-inline'; img-src data:";
    let body = format!(
        r#"<h1>Error against time</h1>
<p>Methods of each family on the same work. Errors and failures are the same for a seed; times are CPU times, medians with
quartiles. <a download="chart.csv" href="data:text/csv;charset=utf-8,{data}">All numbers as chart.csv</a>.</p>
{body}"#
    );
    document("Error against time", policy, STYLE, &body)
}

fn choices(chart: &Chart) -> String {
    let rows = ladder::rows(chart);
    if rows.is_empty() {
        return String::new();
    }
    let mut table = format!("<div class=\"wide\"><table>{}", heading(&ladder::HEADINGS));
    for found in rows {
        table.push_str(&row(&found.cells().each_ref().map(String::as_str)));
    }
    table + "</table></div>"
}

fn points(chart: &Chart) -> String {
    let head = ["point", "error", "failed", "time", "quartiles", "measure it again"];
    let mut table = format!("<h2>All points</h2><div class=\"wide\"><table>{}", heading(&head));
    for point in &chart.points {
        let [low, median, high] = point.time.map(duration);
        let _ = writeln!(
            table,
            "<tr><td>{}</td><td class=\"number\">{}</td><td class=\"number\">{} of {}</td><td class=\"number\">{median}</td>\
             <td class=\"number\">{low} to {high}</td><td><code>{}</code></td></tr>",
            escaped(&point.id()),
            point.error.map_or_else(|| "no answer".to_owned(), |error| format!("{error:.3e}")),
            point.failed,
            point.of,
            escaped(&csv::command_of(chart, point))
        );
    }
    for tile in &chart.tiles {
        let said = format!("{} succeed, {} are ambiguous", tile.succeeded, tile.ambiguous);
        let failed = format!("{} of {}", tile.failed, tile.succeeded + tile.ambiguous + tile.failed);
        let command = escaped(&csv::command(chart, &tile.id()));
        let _ = writeln!(
            table,
            "<tr><td>{}</td><td>{said}</td><td class=\"number\">{failed}</td><td></td><td></td><td><code>{command}</code></td></tr>",
            escaped(&tile.id())
        );
    }
    table + "</table></div>"
}

/// A drawing without what only stands before it in a file of its own.
fn inline(figure: &str) -> &str {
    figure.find("<svg").map_or(figure, |start| &figure[start..])
}

fn heading(cells: &[&str]) -> String {
    let cells = cells.iter().map(|cell| format!("<th>{}</th>", escaped(cell)));
    format!("<tr>{}</tr>\n", cells.collect::<String>())
}

fn row(cells: &[&str]) -> String {
    let cells = cells.iter().map(|cell| format!("<td>{}</td>", escaped(cell)));
    format!("<tr>{}</tr>\n", cells.collect::<String>())
}

/// A byte of a data address.
fn encoded(byte: u8) -> String {
    if byte.is_ascii_alphanumeric() || b"-._~".contains(&byte) {
        char::from(byte).to_string()
    } else {
        format!("%{byte:02X}")
    }
}
