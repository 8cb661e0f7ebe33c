//! A converted polyhedron.

use crate::exact::Q;

/// Rows of a polyhedron and how they touch; all row numbers count from one, as in the files.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Polyhedron {
    /// `H`: rows `(b, a)` of `b + a · x ≥ 0`. `V`: points `(1, x)` and rays `(0, x)`.
    pub representation: char,
    /// Entries per row.
    pub columns: usize,
    /// Dimension of the smallest affine space around the polyhedron; `None` if it has no point.
    pub dimension: Option<usize>,
    /// How many rows, the first ones, are equalities or lines.
    pub n_linear: usize,
    /// The rows.
    pub rows: Vec<Vec<Q>>,
    /// For each row the rows adjacent to it, if asked for.
    pub adjacency: Option<Vec<Vec<usize>>>,
    /// For each row the input rows that it lies on, if asked for.
    pub incidence: Option<Vec<Vec<usize>>>,
    /// What became of the input rows, if redundant ones were dropped.
    pub fates: Option<RowFates>,
}

/// What became of the rows of the input.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RowFates {
    /// For each row of the output its number in the input.
    pub kept: Vec<usize>,
    /// Rows that the others imply.
    pub redundant: Vec<usize>,
    /// Rows that were not said to be linear but are.
    pub implicit: Vec<usize>,
}
