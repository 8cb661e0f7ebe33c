//! What can be wrong with a polyhedron file.

use super::read::{MAX_COLUMNS, MAX_DECIMAL_EXPONENT};

/// A fault and its place.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{line}:{column}: {fault}")]
pub struct FormatError {
    /// Line, from one.
    pub line: usize,
    /// Column in characters, from one.
    pub column: usize,
    /// What is wrong there.
    pub fault: FormatFault,
}

/// Why a text is no polyhedron file.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum FormatFault {
    /// The text has no `begin`.
    #[error("no line \"begin\"; write begin, a line such as \"4 3 rational\", the rows and end")]
    NoBegin,
    /// The text ends within the matrix.
    #[error("the file ends where {expected} should follow")]
    Ends {
        /// What should follow.
        expected: &'static str,
    },
    /// A second matrix.
    #[error("a second \"begin\"; a file holds one polyhedron")]
    SecondBegin,
    /// The number of rows or columns is none.
    #[error("\"{found}\" is no {what}; write the number of rows, that of columns and the kind of number: 4 3 rational")]
    Size {
        /// What stands there.
        found: String,
        /// What it should be.
        what: &'static str,
    },
    /// Zero columns.
    #[error("0 columns; a row has at least the constant (inequality) or the 1 or 0 of a point or ray")]
    NoColumns,
    /// Too many columns.
    #[error("{columns} columns, more than the {MAX_COLUMNS} that are accepted")]
    TooManyColumns {
        /// Their number.
        columns: String,
    },
    /// Neither integer nor rational nor real.
    #[error("\"{found}\" is no kind of number; write integer, rational or real")]
    NumberKind {
        /// What stands there.
        found: String,
    },
    /// Not a number.
    #[error("\"{found}\" is no number (row {row}, entry {entry}); write 3, -1/3 or 0.25")]
    Number {
        /// What stands there.
        found: String,
        /// Row, from one.
        row: usize,
        /// Entry of the row, from one.
        entry: usize,
    },
    /// A fraction over zero.
    #[error("the denominator of \"{found}\" is zero (row {row}, entry {entry})")]
    ZeroDenominator {
        /// What stands there.
        found: String,
        /// Row, from one.
        row: usize,
        /// Entry of the row, from one.
        entry: usize,
    },
    /// A decimal exponent beyond the limit.
    #[error("the exponent of \"{found}\" is beyond ±{MAX_DECIMAL_EXPONENT} (row {row}, entry {entry})")]
    Exponent {
        /// What stands there.
        found: String,
        /// Row, from one.
        row: usize,
        /// Entry of the row, from one.
        entry: usize,
    },
    /// A row without all of its entries.
    #[error("row {row} has {found} of {columns} entries; {announced} rows of {columns} entries are announced")]
    ShortRow {
        /// Row, from one.
        row: usize,
        /// Entries found.
        found: usize,
        /// Entries per row.
        columns: usize,
        /// Rows announced.
        announced: String,
    },
    /// Fewer rows than announced.
    #[error("{found} rows where {announced} are announced; correct the number after \"begin\" or add the rows")]
    FewRows {
        /// Rows found.
        found: usize,
        /// Rows announced.
        announced: usize,
    },
    /// More rows than announced.
    #[error("\"{found}\" where \"end\" should follow the {announced} announced rows of {columns} entries")]
    ManyRows {
        /// What stands there.
        found: String,
        /// Rows announced.
        announced: usize,
        /// Entries per row.
        columns: usize,
    },
    /// A generator that is neither point nor ray.
    #[error("row {row} of a V-representation starts with \"{found}\"; write 1 for a point and 0 for a ray or line")]
    Generator {
        /// What stands there.
        found: String,
        /// Row, from one.
        row: usize,
    },
    /// A list of rows that is not one.
    #[error("\"{found}\" where {expected} should follow; write {keyword}, how many rows and which: {keyword} 2 1 4")]
    RowList {
        /// `linearity` or its like.
        keyword: String,
        /// What stands there.
        found: String,
        /// What should.
        expected: &'static str,
    },
    /// A row number out of range.
    #[error("row {number} is out of range; the rows have the numbers 1 to {rows}")]
    RowNumber {
        /// The number.
        number: String,
        /// How many rows there are.
        rows: usize,
    },
    /// A row number where there is no row.
    #[error("row {number} is out of range; there are no rows")]
    NoRows {
        /// The number.
        number: String,
    },
    /// A point that is said to be a line.
    #[error("row {row} is a point; only rays, which start with 0, can be lines")]
    PointAsLine {
        /// Row, from one.
        row: usize,
    },
    /// A second representation line that says otherwise.
    #[error("both an H- and a V-representation; a file holds one")]
    TwoRepresentations,
    /// An option that changes the polyhedron.
    #[error("\"{option}\" changes the polyhedron and is not understood; {instead}")]
    Option {
        /// Its name.
        option: String,
        /// What to write instead.
        instead: &'static str,
    },
}
