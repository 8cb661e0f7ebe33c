//! What `plan convert` says below the rows, as comments of the file format.

use crate::answer::Polyhedron;

/// Comment lines on emptiness, dropped rows, adjacency and incidence; none if there is nothing to say.
#[must_use]
pub fn polyhedron_notes(answer: &Polyhedron) -> String {
    let mut text = String::new();
    if answer.dimension.is_none() {
        text.push_str("* empty: no point belongs to the polyhedron\n");
    }
    if let Some(fates) = &answer.fates {
        for (what, rows) in [
            ("input rows kept", &fates.kept),
            ("redundant input rows", &fates.redundant),
            ("implicitly linear input rows", &fates.implicit),
        ] {
            text.push_str(&format!("* {what}:{}\n", spaced(rows)));
        }
    }
    let lists = [("adjacent rows", &answer.adjacency), ("input rows that each row lies on", &answer.incidence)];
    for (what, lists) in lists {
        let Some(lists) = lists else { continue };
        text.push_str(&format!("* {what}\n"));
        for (row, list) in lists.iter().enumerate() {
            text.push_str(&format!("*  {}:{}\n", row + 1, spaced(list)));
        }
    }
    text
}

fn spaced(rows: &[usize]) -> String {
    if rows.is_empty() { " none".to_owned() } else { rows.iter().map(|row| format!(" {row}")).collect() }
}
