//! A chart as comma-separated values, to be drawn again or read by others.

use crate::answer::{Chart, ChartFamily, ChartMap, ChartPoint, ChartTile};
use std::fmt::Write as _;

/// Columns, in order.
const COLUMNS: [&str; 16] = [
    "kind",
    "family",
    "work",
    "method",
    "setting",
    "x",
    "y",
    "error",
    "failed",
    "of",
    "ambiguous",
    "succeeded",
    "time_low_s",
    "time_median_s",
    "time_high_s",
    "command",
];

/// A line for each condition, then a row for each point and tile with the command that measures it again.
#[must_use]
pub fn chart(chart: &Chart) -> String {
    let mut text = String::new();
    for (name, value) in &chart.conditions {
        let _ = writeln!(text, "# {}: {}", on_a_line(name), on_a_line(value));
    }
    let mut rows = csv::Writer::from_writer(Vec::new());
    // writing into memory does not fail
    let _ = rows.write_record(COLUMNS);
    for point in &chart.points {
        let [low, median, high] = point.time.map(|time| format!("{time:e}"));
        let _ = rows.write_record([
            "point",
            point.family.name(),
            &point.work,
            &point.method,
            &point.setting,
            "",
            "",
            &point.error.map_or_else(String::new, |error| format!("{error:e}")),
            &point.failed.to_string(),
            &point.of.to_string(),
            "",
            "",
            &low,
            &median,
            &high,
            &command_of(chart, point),
        ]);
    }
    for tile in &chart.tiles {
        let of = tile.succeeded + tile.ambiguous + tile.failed;
        let _ = rows.write_record([
            "tile",
            tile.map.name(),
            "",
            &tile.method,
            "",
            &format!("{:e}", tile.x),
            &format!("{:e}", tile.y),
            "",
            &tile.failed.to_string(),
            &of.to_string(),
            &tile.ambiguous.to_string(),
            &tile.succeeded.to_string(),
            "",
            "",
            "",
            &command(chart, &tile.id()),
        ]);
    }
    text + &String::from_utf8_lossy(&rows.into_inner().unwrap_or_default())
}

/// The command that measures a point again.
#[must_use]
pub fn command_of(chart: &Chart, point: &ChartPoint) -> String {
    point.command.clone().unwrap_or_else(|| command(chart, &point.id()))
}

/// The command that measures what has this id again.
#[must_use]
pub fn command(chart: &Chart, id: &str) -> String {
    let condition =
        |name: &str| chart.conditions.iter().find(|(known, _)| known == name).map(|(_, value)| value.as_str());
    let cases = condition("cases").map_or_else(String::new, |cases| format!(" {cases}"));
    let quick = if condition("run") == Some("quick") { " --quick" } else { "" };
    let seed = condition("seed").unwrap_or("0");
    format!("plan chart{cases}{quick} --seed {seed} --only {}", quoted(id))
}

/// A word of a command, as shells take it.
#[must_use]
pub fn quoted(word: &str) -> String {
    format!("'{}'", word.replace('\'', r"'\''"))
}

/// Why a text is not a chart.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("line {line}: {what}")]
pub struct NoChart {
    /// Counted from 1.
    pub line: u64,
    /// What is wrong, and what would be right.
    pub what: String,
}

/// Reads what [`chart`] wrote.
///
/// # Errors
/// [`NoChart`] for the first line that it would not have written.
pub fn read_chart(text: &str) -> Result<Chart, NoChart> {
    // spreadsheets write a byte order mark
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut chart = Chart::default();
    let comments: Vec<&str> = text.lines().take_while(|line| line.starts_with('#')).collect();
    for (index, comment) in comments.iter().enumerate() {
        let condition = comment.strip_prefix("# ").and_then(|condition| condition.split_once(": "));
        let (name, value) = condition.ok_or_else(|| NoChart {
            line: index as u64 + 1,
            what: format!("\"{comment}\" where a condition is needed; write \"# seed: 0\""),
        })?;
        chart.conditions.push((as_it_was(name), as_it_was(value)));
    }
    let rest = text.split_inclusive('\n').skip(comments.len()).collect::<String>();
    let mut rows = csv::ReaderBuilder::new().flexible(true).from_reader(rest.as_bytes());
    let bad =
        |at: Option<&csv::Position>, what: String| NoChart { line: comments.len() as u64 + line(&rest, at), what };
    let broken = |error: &csv::Error| bad(error.position(), format!("{error}; write rows of comma-separated values"));
    let header = rows.headers().map_err(|error| broken(&error))?;
    if header.iter().ne(COLUMNS) {
        return Err(bad(None, format!("these are not the columns of a chart; write {}", COLUMNS.join(","))));
    }
    for row in rows.records() {
        let row = row.map_err(|error| broken(&error))?;
        let line = row.position();
        let read = Row(&row);
        if row.len() != COLUMNS.len() {
            return Err(bad(line, format!("the row has {} fields; write {}", row.len(), COLUMNS.len())));
        }
        match read.text("kind") {
            "point" => {
                let point = read.point(&chart).map_err(|what| bad(line, what))?;
                chart.points.push(point);
            }
            "tile" => chart.tiles.push(read.tile().map_err(|what| bad(line, what))?),
            other => return Err(bad(line, format!("the kind is \"{other}\"; write point or tile"))),
        }
    }
    Ok(chart)
}

/// The line of a row, counted from 1: where its first character is, past any empty lines.
fn line(text: &str, at: Option<&csv::Position>) -> u64 {
    let start = at.map_or(0, |at| usize::try_from(at.byte()).unwrap_or(usize::MAX));
    let Some((before, rest)) = text.split_at_checked(start) else { return 1 };
    let empty = rest.len() - rest.trim_start_matches(['\r', '\n']).len();
    1 + before.chars().chain(rest[..empty].chars()).filter(|c| *c == '\n').count() as u64
}

/// A text without line breaks.
fn on_a_line(text: &str) -> String {
    text.replace('\\', r"\\").replace('\n', r"\n").replace('\r', r"\r")
}

/// What [`on_a_line`] was given.
fn as_it_was(text: &str) -> String {
    let mut letters = text.chars();
    let mut whole = String::new();
    while let Some(letter) = letters.next() {
        let next = if letter == '\\' { letters.next() } else { Some(letter) };
        match (letter, next) {
            ('\\', Some('n')) => whole.push('\n'),
            ('\\', Some('r')) => whole.push('\r'),
            (_, next) => whole.extend(next),
        }
    }
    whole
}

struct Row<'a>(&'a csv::StringRecord);

impl Row<'_> {
    fn text(&self, column: &str) -> &str {
        COLUMNS.iter().position(|name| *name == column).and_then(|at| self.0.get(at)).unwrap_or_default()
    }

    fn point(&self, chart: &Chart) -> Result<ChartPoint, String> {
        let family = ChartFamily::ALL.into_iter().find(|family| family.name() == self.text("family"));
        let point = ChartPoint {
            family: family.ok_or_else(|| self.unknown(ChartFamily::ALL.map(ChartFamily::name).join(", ")))?,
            work: self.text("work").to_owned(),
            method: self.text("method").to_owned(),
            setting: self.text("setting").to_owned(),
            error: if self.text("error").is_empty() { None } else { Some(self.number("error", 0.0)?) },
            failed: self.count("failed")?,
            of: self.count("of")?,
            time: [
                self.number("time_low_s", 0.0)?,
                self.number("time_median_s", 0.0)?,
                self.number("time_high_s", 0.0)?,
            ],
            command: None,
        };
        let own = command(chart, &point.id());
        let said = self.text("command");
        let command = (said != own).then(|| said.to_owned());
        if point.failed > point.of {
            return Err(format!("{} of {} runs failed; at most all can", point.failed, point.of));
        }
        if point.error.is_none() && point.failed < point.of {
            let answers = point.of - point.failed;
            return Err(format!("{answers} runs did not fail and there is no error; write the error of their answers"));
        }
        if !point.time.is_sorted() {
            return Err("the times are not in order; write lower quartile, median, upper quartile".to_owned());
        }
        Ok(ChartPoint { command, ..point })
    }

    fn tile(&self) -> Result<ChartTile, String> {
        let map = ChartMap::ALL.into_iter().find(|map| map.name() == self.text("family"));
        let tile = ChartTile {
            map: map.ok_or_else(|| self.unknown(ChartMap::ALL.map(ChartMap::name).join(", ")))?,
            method: self.text("method").to_owned(),
            x: self.number("x", f64::MIN)?,
            y: self.number("y", f64::MIN)?,
            succeeded: self.count("succeeded")?,
            ambiguous: self.count("ambiguous")?,
            failed: self.count("failed")?,
        };
        let of = self.count("of")?;
        if [tile.succeeded, tile.ambiguous, tile.failed].iter().try_fold(0, |sum: u64, n| sum.checked_add(*n))
            != Some(of)
        {
            return Err(format!("the runs that succeeded, were ambiguous and failed do not add up to {of}"));
        }
        Ok(tile)
    }

    fn unknown(&self, known: String) -> String {
        format!("there is no family \"{}\"; write one of {known}", self.text("family"))
    }

    fn number(&self, column: &str, least: f64) -> Result<f64, String> {
        let text = self.text(column);
        let number = text.parse::<f64>().ok().filter(|number| number.is_finite() && *number >= least);
        number.ok_or_else(|| {
            format!("{column} is \"{text}\"; write a finite number{}", if least == 0.0 { ", not negative" } else { "" })
        })
    }

    fn count(&self, column: &str) -> Result<u64, String> {
        let text = self.text(column);
        text.parse().map_err(|_| format!("{column} is \"{text}\"; write a whole number"))
    }
}
