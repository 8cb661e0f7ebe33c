//! Small dense linear systems, solved in place.

/// A square system; keeps its memory.
#[derive(Debug, Default)]
pub(super) struct System {
    n: usize,
    /// Row-major.
    pub matrix: Vec<f64>,
}

impl System {
    /// The identity of `n` rows.
    pub fn reset(&mut self, n: usize) {
        self.n = n;
        self.matrix.clear();
        self.matrix.resize(n * n, 0.0);
        for i in 0..n {
            self.matrix[i * n + i] = 1.0;
        }
    }

    /// Solves in place by elimination with the largest pivot of each column; false where the matrix is singular.
    pub fn solve(&mut self, right: &mut [f64]) -> bool {
        let n = self.n;
        for column in 0..n {
            let size = |row: usize| self.matrix[row * n + column].abs();
            let pivot = (column + 1..n).fold(column, |best, row| if size(row) > size(best) { row } else { best });
            if size(pivot).is_nan() || size(pivot) == 0.0 {
                return false;
            }
            if pivot != column {
                for k in column..n {
                    self.matrix.swap(pivot * n + k, column * n + k);
                }
                right.swap(pivot, column);
            }
            let (above, below) = self.matrix.split_at_mut((column + 1) * n);
            let pivot_row = &above[column * n + column..];
            let (done, open) = right.split_at_mut(column + 1);
            for (row, right) in below.chunks_exact_mut(n).zip(open) {
                let factor = row[column] / pivot_row[0];
                if factor != 0.0 {
                    for (x, y) in row[column..].iter_mut().zip(pivot_row) {
                        *x -= factor * y;
                    }
                    *right -= factor * done[column];
                }
            }
        }
        for row in (0..n).rev() {
            let known: f64 = (row + 1..n).map(|k| self.matrix[row * n + k] * right[k]).sum();
            right[row] = (right[row] - known) / self.matrix[row * n + row];
        }
        right.iter().all(|x| x.is_finite())
    }
}
