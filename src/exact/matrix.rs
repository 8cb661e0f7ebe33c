//! Rows of integers in one allocation.

use super::{Int, Long, Overflow, Q, Z};
use num_integer::Integer as _;
use num_traits::One as _;
use smallvec::SmallVec;

/// Entries of rows, on the stack while there are few: most cones in wrench space have at most four rows a side.
pub type Entries<T> = SmallVec<[T; 12]>;

/// A list of rows of equal length, stored flat.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Matrix<T> {
    columns: usize,
    n_rows: usize,
    entries: Entries<T>,
}

impl<T: Int> Matrix<T> {
    /// No rows yet.
    #[must_use]
    pub fn new(columns: usize) -> Self {
        Self { columns, n_rows: 0, entries: Entries::new() }
    }

    /// No rows yet, with room for `rows` of them.
    #[must_use]
    pub fn with_capacity(columns: usize, rows: usize) -> Self {
        Self { columns, n_rows: 0, entries: Entries::with_capacity(columns * rows) }
    }

    /// The unit vectors.
    #[must_use]
    pub fn identity(size: usize) -> Self {
        let mut entries = Entries::from_elem(T::default(), size * size);
        entries.iter_mut().step_by(size + 1).for_each(|diagonal| *diagonal = T::unit());
        Self { columns: size, n_rows: size, entries }
    }

    /// The rows that `rows` yields.
    ///
    /// # Panics
    /// If a row does not have `columns` entries.
    pub fn from_rows<R: AsRef<[T]>>(columns: usize, rows: impl IntoIterator<Item = R>) -> Self {
        let rows = rows.into_iter();
        let mut matrix = Self::with_capacity(columns, rows.size_hint().0);
        for row in rows {
            matrix.push(row.as_ref());
        }
        matrix
    }

    /// Entries per row.
    #[must_use]
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// The same rows in integers of any size.
    #[must_use]
    pub fn to_long(&self) -> Matrix<Long> {
        let entries = self.entries.iter().map(|entry| Long::from_z(&entry.to_z()).expect("any size fits")).collect();
        Matrix { columns: self.columns, n_rows: self.n_rows, entries }
    }

    /// Number of rows.
    #[must_use]
    pub fn len(&self) -> usize {
        self.n_rows
    }

    /// Whether there are no rows.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.n_rows == 0
    }

    /// Row `index`.
    #[must_use]
    pub fn row(&self, index: usize) -> &[T] {
        &self.entries[index * self.columns..(index + 1) * self.columns]
    }

    /// All rows in order.
    pub fn rows(&self) -> impl ExactSizeIterator<Item = &[T]> + Clone {
        (0..self.n_rows).map(|index| self.row(index))
    }

    /// Appends a row.
    ///
    /// # Panics
    /// If the row does not have [`Matrix::columns`] entries.
    pub fn push(&mut self, row: &[T]) {
        assert_eq!(row.len(), self.columns, "a row must have as many entries as the matrix has columns");
        self.entries.extend(row.iter().cloned());
        self.n_rows += 1;
    }

    /// Appends the row of the entries that `row` yields.
    ///
    /// # Panics
    /// If it yields another number of entries than [`Matrix::columns`].
    pub fn push_from(&mut self, row: impl Iterator<Item = T>) {
        self.entries.extend(row);
        self.n_rows += 1;
        assert_eq!(
            self.entries.len(),
            self.n_rows * self.columns,
            "a row must have as many entries as the matrix has columns"
        );
    }

    /// Appends the negative of a row.
    ///
    /// # Panics
    /// If the row does not have [`Matrix::columns`] entries.
    pub fn push_negated(&mut self, row: &[T]) {
        assert_eq!(row.len(), self.columns, "a row must have as many entries as the matrix has columns");
        self.entries.extend(row.iter().map(T::negated));
        self.n_rows += 1;
    }

    /// Appends all rows of `other`.
    ///
    /// # Panics
    /// If the columns differ.
    pub fn append(&mut self, other: &Self) {
        assert_eq!(other.columns, self.columns, "matrices must have the same columns");
        self.entries.extend(other.entries.iter().cloned());
        self.n_rows += other.n_rows;
    }

    /// Takes row `index` out; the last row takes its place.
    pub fn swap_remove(&mut self, index: usize) -> Entries<T> {
        let last = self.len() - 1;
        let taken = self.row(index).iter().cloned().collect();
        if index < last {
            let (head, tail) = self.entries.split_at_mut(last * self.columns);
            head[index * self.columns..(index + 1) * self.columns].clone_from_slice(tail);
        }
        self.entries.truncate(last * self.columns);
        self.n_rows = last;
        taken
    }

    /// Takes row `index` out; those after it move up.
    pub fn remove(&mut self, index: usize) -> Entries<T> {
        let taken = self.row(index).iter().cloned().collect();
        self.entries.drain(index * self.columns..(index + 1) * self.columns);
        self.n_rows -= 1;
        taken
    }

    /// Inserts a row before row `index`.
    ///
    /// # Panics
    /// If the row does not have [`Matrix::columns`] entries.
    pub fn insert(&mut self, index: usize, row: &[T]) {
        assert_eq!(row.len(), self.columns, "a row must have as many entries as the matrix has columns");
        self.entries.insert_many(index * self.columns, row.iter().cloned());
        self.n_rows += 1;
    }

    /// Row `index`, to be changed in place.
    pub fn row_mut(&mut self, index: usize) -> &mut [T] {
        &mut self.entries[index * self.columns..(index + 1) * self.columns]
    }

    /// Drops all rows.
    pub fn clear(&mut self) {
        self.entries.clear();
        self.n_rows = 0;
    }

    /// Appends the row that `write` appends to the entries.
    ///
    /// # Errors
    /// Those of `write`.
    ///
    /// # Panics
    /// If `write` appends another number of entries than [`Matrix::columns`].
    pub fn push_with<E>(&mut self, write: impl FnOnce(&mut Entries<T>) -> Result<(), E>) -> Result<(), E> {
        write(&mut self.entries)?;
        self.n_rows += 1;
        assert_eq!(
            self.entries.len(),
            self.n_rows * self.columns,
            "a row must have as many entries as there are columns"
        );
        Ok(())
    }
}

/// The row on a rung of the integer ladder.
///
/// # Errors
/// [`Overflow`] if an entry does not fit.
pub fn on_rung<T: Int>(row: &[Z]) -> Result<Vec<T>, Overflow> {
    row.iter().map(|value| T::from_z(value).ok_or(Overflow)).collect()
}

/// The primitive integer row on the same ray as `row`: one positive factor clears all denominators and divisors.
#[must_use]
pub fn primitive_row(row: &[Q]) -> Vec<Z> {
    let denominator = row.iter().fold(Z::one(), |lcm, value| lcm.lcm(value.denom()));
    let mut integers: Vec<Z> = row.iter().map(|value| value.numer() * (&denominator / value.denom())).collect();
    make_primitive(&mut integers);
    integers
}

/// Divides `row` by the greatest common divisor of its entries.
pub fn make_primitive(row: &mut [Z]) {
    if row.iter().any(|value| value.magnitude().is_one()) {
        return;
    }
    let given: Entries<Long> = row.iter().filter_map(Long::from_z).collect();
    let mut found = given.clone();
    Long::make_primitive(&mut found);
    if found != given {
        row.iter_mut().zip(&found).for_each(|(value, quotient)| *value = quotient.to_z());
    }
}
