//! Lemke's method in doubles, on a dictionary of n rows and n + 2 columns.

use super::Basis;

/// Which of the rows that tie leaves the basis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Ties {
    /// The one with the largest pivot: rounding grows least.
    LargestPivot,
    /// The lexicographically least: no basis comes twice, were it not for rounding.
    Lexicographic,
}

/// How the path ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum End {
    /// At a complementary basis, as far as doubles can tell.
    Complementary,
    /// On a secondary ray.
    Ray,
    /// At the limit of pivots.
    Limit,
}

/// `z0` up to this part of `‖q‖∞` counts as zero: its last ratio hardly ever comes out as the exact minimum.
const COVER_IS_ZERO: f64 = 1e-9;
/// Ratios this close tie.
const TIE: f64 = 1e-12;
/// Entries below this part of their column's largest are rounding errors, not pivots.
const NO_PIVOT: f64 = 1e-10;

/// The dictionary `basic = constant + Σ entry · nonbasic` and its room, kept from solve to solve.
///
/// Variables: `w_i` is `i`, `z_i` is `n + i`, `z0` is `2 n`.
#[derive(Debug, Clone, Default)]
pub(super) struct Dictionary {
    size: usize,
    stride: usize,
    /// Rows of the constant, then of the entries of the nonbasic variables; columns beyond n + 2 are zero.
    entries: Vec<f64>,
    /// The variable of each row.
    basic: Vec<usize>,
    /// The variable of each column; the first column, of the constants, has none.
    nonbasic: Vec<usize>,
    /// Row or column of each variable.
    place: Vec<usize>,
    pivot_row: Vec<f64>,
    /// For each row its constant, not negative, and the negative of its entry in the column that enters.
    bounds: Vec<[f64; 2]>,
    /// Pivots so far.
    pub(super) pivots: usize,
}

impl Dictionary {
    /// Follows the path of `w = q + M z + d z0` from `z0 = ∞`, where `cover` is `d > 0`, or all ones if it is empty.
    pub(super) fn follow(&mut self, m: &[f64], q: &[f64], cover: &[f64], ties: Ties, limit: usize) -> End {
        // row lengths that are known when compiled make small problems twice as fast
        match q.len() {
            0..=4 => self.follow_with::<6>(m, q, cover, ties, limit),
            5..=8 => self.follow_with::<10>(m, q, cover, ties, limit),
            9..=16 => self.follow_with::<18>(m, q, cover, ties, limit),
            17..=32 => self.follow_with::<34>(m, q, cover, ties, limit),
            _ => self.follow_with::<0>(m, q, cover, ties, limit),
        }
    }

    fn follow_with<const STRIDE: usize>(
        &mut self,
        m: &[f64],
        q: &[f64],
        cover: &[f64],
        ties: Ties,
        limit: usize,
    ) -> End {
        self.load::<STRIDE>(m, q, cover);
        let n = self.size;
        let zero = COVER_IS_ZERO * q.iter().fold(0.0, |most: f64, value| value.abs().max(most));
        let first = |a: usize, b: usize| {
            let ratio = |row: usize| q[row] / cover.get(row).copied().unwrap_or(1.0);
            if ratio(b) < ratio(a) { b } else { a }
        };
        let Some(mut row) = (0..n).reduce(first) else { return End::Complementary };
        let mut column = n + 1;
        loop {
            let left = self.basic[row];
            self.pivot::<STRIDE>(row, column);
            self.pivots += 1;
            if left == 2 * n {
                return End::Complementary;
            }
            if self.pivots >= limit {
                return End::Limit;
            }
            column = self.place[complement(left, n)];
            row = match self.leaving::<STRIDE>(column, zero, ties) {
                Some(row) => row,
                None if self.value_of_cover() <= zero => return End::Complementary,
                None => return End::Ray,
            };
        }
    }

    fn load<const STRIDE: usize>(&mut self, m: &[f64], q: &[f64], cover: &[f64]) {
        let n = q.len();
        let stride = if STRIDE == 0 { n + 2 } else { STRIDE };
        self.size = n;
        self.stride = stride;
        self.pivots = 0;
        self.entries.clear();
        self.entries.resize(n * stride, 0.0);
        for (i, row) in self.entries.chunks_exact_mut(stride).enumerate() {
            row[0] = q[i];
            row[1..=n].copy_from_slice(&m[i * n..(i + 1) * n]);
            row[n + 1] = cover.get(i).copied().unwrap_or(1.0);
        }
        self.basic.clear();
        self.basic.extend(0..n);
        self.nonbasic.clear();
        self.nonbasic.push(usize::MAX);
        self.nonbasic.extend(n..=2 * n);
        self.place.clear();
        self.place.extend(0..n);
        self.place.extend(1..=n + 1);
        self.pivot_row.clear();
        self.pivot_row.resize(stride, 0.0);
        self.bounds.clear();
        self.bounds.resize(n, [0.0; 2]);
    }

    /// Exchanges the basic variable of `row` with the nonbasic one of `column`.
    fn pivot<const STRIDE: usize>(&mut self, row: usize, column: usize) {
        let stride = if STRIDE == 0 { self.stride } else { STRIDE };
        let pivot_row = &mut self.pivot_row[..stride];
        let chosen = &mut self.entries[row * stride..(row + 1) * stride];
        let inverse = -1.0 / chosen[column];
        for (entry, kept) in chosen.iter_mut().zip(pivot_row.iter_mut()) {
            *entry *= inverse;
            *kept = *entry;
        }
        chosen[column] = -inverse;
        pivot_row[column] = -inverse;
        for (index, other) in self.entries.chunks_exact_mut(stride).enumerate() {
            let factor = other[column];
            if index == row || factor == 0.0 {
                continue;
            }
            other[column] = 0.0;
            for (entry, by) in other.iter_mut().zip(pivot_row.iter()) {
                *entry += factor * by;
            }
        }
        let (left, entered) = (self.basic[row], self.nonbasic[column]);
        self.basic[row] = entered;
        self.nonbasic[column] = left;
        self.place[entered] = row;
        self.place[left] = column;
    }

    /// The row that bounds the growth of the variable in `column`; `z0` leaves if its value then counts as zero.
    fn leaving<const STRIDE: usize>(&mut self, column: usize, zero: f64, ties: Ties) -> Option<usize> {
        let stride = if STRIDE == 0 { self.stride } else { STRIDE };
        let mut largest = 0.0_f64;
        for (pair, row) in self.bounds.iter_mut().zip(self.entries.chunks_exact(stride)) {
            *pair = [row[0].max(0.0), -row[column]];
            largest = largest.max(row[column].abs());
        }
        let threshold = NO_PIVOT * largest;
        // ratios [constant, -entry] are compared without divisions; all entries that count are positive
        let mut least = [f64::INFINITY, 1.0];
        for pair in self.bounds.iter().filter(|pair| pair[1] > threshold) {
            if pair[0] * least[1] < least[0] * pair[1] {
                least = *pair;
            }
        }
        let step = least[0] / least[1];
        if step == f64::INFINITY {
            return None;
        }
        let cover = self.place[2 * self.size];
        let [constant, entry] = self.bounds[cover];
        if entry > threshold && constant - entry * step <= zero {
            return Some(cover);
        }
        let limit = step + TIE * step;
        let is_tied = |pair: &[f64; 2]| pair[1] > threshold && pair[0] <= pair[1] * limit;
        let tied = self.bounds.iter().enumerate().filter(|(_, pair)| is_tied(pair));
        match ties {
            Ties::LargestPivot => tied.reduce(|a, b| if b.1[1] > a.1[1] { b } else { a }).map(|(row, _)| row),
            Ties::Lexicographic => tied.map(|(row, _)| row).reduce(|a, b| self.lexicographic(a, b, column)),
        }
    }

    /// Of two rows that tie the one that bounds first if `q` grows by `(ε, ε², …)`.
    fn lexicographic(&self, a: usize, b: usize, column: usize) -> usize {
        let entry = |row: usize, column: usize| self.entries[row * self.stride + column];
        for variable in 0..self.size {
            let place = self.place[variable];
            let is_basic = self.basic.get(place) == Some(&variable);
            let [ours, theirs] = [a, b].map(|row| {
                let change = if is_basic { f64::from(u8::from(place == row)) } else { -entry(row, place) };
                change / -entry(row, column)
            });
            if (ours - theirs).abs() > TIE * (ours.abs() + theirs.abs()) {
                return if ours < theirs { a } else { b };
            }
        }
        a
    }

    fn value_of_cover(&self) -> f64 {
        self.entries[self.place[2 * self.size] * self.stride]
    }

    /// The basis and the values of `z` in it, negative ones as zeros.
    pub(super) fn read(&self, basis: &mut Basis, z: &mut Vec<f64>) {
        let n = self.size;
        basis.reset(n);
        z.clear();
        z.resize(n, 0.0);
        for (row, variable) in self.basic.iter().enumerate().filter(|(_, v)| (n..2 * n).contains(*v)) {
            basis.insert(variable - n);
            let value = self.entries[row * self.stride];
            z[variable - n] = if value > 0.0 { value } else { 0.0 };
        }
    }
}

fn complement(variable: usize, n: usize) -> usize {
    if variable < n { variable + n } else { variable - n }
}
