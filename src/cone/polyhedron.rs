//! Polyhedra as their files give them: rows of rationals, some of them linear.

use crate::exact::Q;
use num_traits::{One as _, Zero as _};

/// What the rows of a [`Polyhedron`] are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Representation {
    /// A row `(b, a)` is the inequality `b + a · x ≥ 0`, or the equality `b + a · x = 0` if it is linear.
    Inequalities,
    /// A row `(1, x)` is a point and `(0, x)` a ray, or a line if it is linear. Rays without a point start at the
    /// origin; no row at all means no point at all.
    Generators,
}

impl Representation {
    /// The representation that conversion leads to.
    #[must_use]
    pub fn other(self) -> Self {
        match self {
            Self::Inequalities => Self::Generators,
            Self::Generators => Self::Inequalities,
        }
    }

    /// `H` for inequalities, `V` for generators, as the files name them.
    #[must_use]
    pub fn letter(self) -> char {
        match self {
            Self::Inequalities => 'H',
            Self::Generators => 'V',
        }
    }
}

/// A polyhedron in one representation, not necessarily a minimal one.
///
/// Sign convention: `b + a · x ≥ 0`, as in the files of cddlib and lrslib and unlike [`Pair`](super::Pair).
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Polyhedron {
    representation: Representation,
    columns: usize,
    rows: Vec<Vec<Q>>,
    linear: Vec<usize>,
}

impl Polyhedron {
    /// A polyhedron in a space of `columns - 1` variables; `linear` are the indices, from zero, of the rows that are
    /// equalities or lines.
    ///
    /// # Panics
    /// If there is no column, a row has another number of entries, an index is out of range, or a generator starts
    /// with anything but 1 (point) or 0 (ray, line).
    #[must_use]
    pub fn new(representation: Representation, columns: usize, rows: Vec<Vec<Q>>, linear: &[usize]) -> Self {
        assert!(columns > 0, "the constant has a column");
        assert!(rows.iter().all(|row| row.len() == columns), "a row must have as many entries as there are columns");
        let mut linear = linear.to_vec();
        linear.sort_unstable();
        linear.dedup();
        assert!(linear.last().is_none_or(|last| *last < rows.len()), "linear rows must be rows");
        if representation == Representation::Generators {
            let is_line = |row: &usize| rows[*row][0].is_zero();
            assert!(rows.iter().all(|row| row[0].is_zero() || row[0].is_one()), "a generator starts with 0 or 1");
            assert!(linear.iter().all(is_line), "a line starts with 0");
        }
        Self { representation, columns, rows, linear }
    }

    /// What the rows are.
    #[must_use]
    pub fn representation(&self) -> Representation {
        self.representation
    }

    /// Entries per row: one more than there are variables.
    #[must_use]
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// The rows.
    #[must_use]
    pub fn rows(&self) -> &[Vec<Q>] {
        &self.rows
    }

    /// Indices of the equalities or lines, from zero, increasing.
    #[must_use]
    pub fn linear(&self) -> &[usize] {
        &self.linear
    }

    /// Whether row `index` is an equality or a line.
    #[must_use]
    pub fn is_linear(&self, index: usize) -> bool {
        self.linear.binary_search(&index).is_ok()
    }

    /// Generators with only some of their variables (from zero), in the order of `variables`.
    pub(super) fn with_variables(&self, variables: &[usize]) -> Self {
        let kept = |row: &Vec<Q>| {
            std::iter::once(&row[0]).chain(variables.iter().map(|variable| &row[variable + 1])).cloned().collect()
        };
        Self {
            representation: self.representation,
            columns: variables.len() + 1,
            rows: self.rows.iter().map(kept).collect(),
            linear: self.linear.clone(),
        }
    }
}
