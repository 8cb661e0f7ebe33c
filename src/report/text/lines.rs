//! Labelled lines that several reports share.

use super::super::Subject;
use super::super::phrase;
use super::cone::describe;
use super::witness;
use crate::answer::{Cone, WrenchVerdict};

/// Listed in full up to this many; the rest is counted, so that the answer fits a screen.
const MOST_LISTED: usize = 4;

/// A report under construction: an answer, then labelled lines.
pub(super) struct Report {
    text: String,
}

impl Report {
    pub(super) fn new(answer: &str) -> Self {
        Self { text: format!("{answer}\n") }
    }

    /// Lines without an answer of their own.
    pub(super) fn lines() -> Self {
        Self { text: String::new() }
    }

    pub(super) fn line(&mut self, label: &str, value: &str) {
        self.text.push_str(&format!("  {label:<11} {value}\n"));
    }

    /// The first few of `items`, a line each, or `none`.
    pub(super) fn list(&mut self, label: &str, items: &[String], none: &str) {
        if items.is_empty() {
            return self.line(label, none);
        }
        let shown = if items.len() > MOST_LISTED { MOST_LISTED - 1 } else { items.len() };
        for (index, item) in items[..shown].iter().enumerate() {
            self.line(if index == 0 { label } else { "" }, item);
        }
        if shown < items.len() {
            self.line("", &format!("and {} more (--format json lists all)", items.len() - shown));
        }
    }

    /// Rows under their headings, each column as wide as its widest entry.
    pub(super) fn table<R: AsRef<[String]>>(&mut self, rows: &[R]) {
        let rows = || rows.iter().map(AsRef::as_ref);
        let lengths = |column: usize| rows().filter_map(move |row| Some(row.get(column)?.chars().count()));
        let widths: Vec<usize> =
            (0..rows().map(<[String]>::len).max().unwrap_or(0)).map(|c| lengths(c).max().unwrap_or(0)).collect();
        for row in rows() {
            let cells: Vec<String> = row.iter().zip(&widths).map(|(cell, width)| format!("{cell:<width$}")).collect();
            self.text.push_str(&format!("  {}\n", cells.join("  ").trim_end()));
        }
    }

    pub(super) fn fixels(&mut self, subject: &Subject) {
        let unit = subject.part.unit.symbol();
        let describe = |(number, fixel): (usize, &crate::model::Fixel)| {
            let friction = &fixel.friction;
            let mut text = format!(
                "{number} at {} {unit}, normal {} deg, friction {}",
                phrase::point(&fixel.point),
                phrase::heading(&fixel.normal),
                phrase::range(&friction.static_)
            );
            if friction.kinetic != friction.static_ {
                text += &format!(" at rest, {} sliding", phrase::range(&friction.kinetic));
            }
            text
        };
        let fixels: Vec<String> = subject.fixture.fixels.iter().enumerate().map(describe).collect();
        self.list("fixels", &fixels, "none");
    }

    pub(super) fn wrenches(&mut self, wrenches: &[WrenchVerdict]) {
        for verdict in wrenches {
            self.line("wrench", &format!("{} {}", phrase::tuple(&verdict.wrench), words(verdict)));
            witness::reasons(verdict).iter().for_each(|reason| self.line("", reason));
        }
    }

    pub(super) fn modes(&mut self, modes: &[(String, Cone)]) {
        for (mode, cone) in modes {
            self.line("mode", &format!("{mode}: {}", describe(cone)));
        }
    }

    pub(super) fn finish(self) -> String {
        self.text
    }
}

fn words(verdict: &WrenchVerdict) -> String {
    let seats = if verdict.acyclic { "seats the part" } else { "is not guaranteed to seat the part" };
    let holds = match (verdict.strong, verdict.weak) {
        (true, _) => "seated, it stays at rest",
        (false, true) => "seated, it may stay or move",
        (false, false) => "seated, it moves",
    };
    let modes = match verdict.modes.as_slice() {
        [] => String::new(),
        modes => format!("; consistent with {}", modes.join(" ")),
    };
    format!("{seats}; {holds}{modes}")
}
