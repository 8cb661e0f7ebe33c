//! Polyhedron files: reading and writing, conversion, redundancy, adjacency, incidence, projection.

mod answers;
mod command;
mod draw;
mod faults;
mod files;
mod properties;
#[path = "../support/mod.rs"]
mod support;

use partplan::cone::format::read;
use partplan::cone::{Converted, Extras, Polyhedron, convert};
use partplan::exact::Q;

/// Rows and nothing else.
pub const PLAIN: Extras = Extras { adjacency: false, incidence: false };

/// The polyhedron of a text that must be right.
pub fn polyhedron(text: &str) -> Polyhedron {
    read(text.as_bytes()).unwrap_or_else(|fault| panic!("{fault}\n{text}")).polyhedron
}

/// The other representation of a text that must be right.
pub fn converted(text: &str) -> Converted {
    convert(&polyhedron(text), PLAIN)
}

/// Rows as words, for short comparisons.
pub fn words(rows: &[Vec<Q>]) -> Vec<String> {
    rows.iter().map(|row| row.iter().map(Q::to_string).collect::<Vec<_>>().join(" ")).collect()
}

/// Number of independent rows, by elimination.
pub fn rank(rows: &[Vec<Q>]) -> usize {
    let mut rows = rows.to_vec();
    let mut rank = 0;
    for column in 0..rows.first().map_or(0, Vec::len) {
        let Some(found) = (rank..rows.len()).find(|row| rows[*row][column] != support::int(0)) else { continue };
        rows.swap(rank, found);
        let pivot = rows[rank].clone();
        for row in &mut rows[rank + 1..] {
            let factor = &row[column] / &pivot[column];
            row.iter_mut().zip(&pivot).for_each(|(value, above)| *value -= &factor * above);
        }
        rank += 1;
    }
    rank
}
