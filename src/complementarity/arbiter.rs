//! Lemke's method in integers, which always ends.

use super::Basis;
use super::integral::Integral;
use crate::exact::{Entries, Int, Ladder, Overflow, Q, Rung, Z, climb};
use num_traits::{One as _, Zero as _};
use std::cmp::Ordering;

/// How the path ended.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum ExactEnd {
    /// At a solution.
    Solved { z: Vec<Q>, basis: Basis },
    /// On a secondary ray with this direction of `z`.
    Ray { direction: Vec<Q> },
    /// At the limit of pivots.
    Limit,
}

/// Follows Lemke's path with lexicographic ties and says how many pivots that took.
///
/// No basis comes twice, because the problem with the right side `q' + (ε, ε², …)` has no ties; so it ends without a
/// limit, after at most as many pivots as there are bases.
///
/// # Source
/// Cottle, Pang and Stone (1992), Algorithm 4.4.1 with 4.9.
pub(super) fn lemke(integral: &Integral, limit: usize) -> (ExactEnd, usize) {
    let is_wide = integral.rows.iter().flatten().any(|entry| entry.bits() > 40);
    let lowest = if is_wide { Rung::Big } else { Rung::Word };
    let ((mut end, pivots), _) = climb(&Path { rows: &integral.rows, limit }, lowest);
    match &mut end {
        ExactEnd::Solved { z, .. } => *z = integral.restore(z),
        ExactEnd::Ray { direction } => *direction = integral.restore(direction),
        ExactEnd::Limit => {}
    }
    (end, pivots)
}

struct Path<'a> {
    rows: &'a [Vec<Z>],
    limit: usize,
}

impl Ladder for Path<'_> {
    type Output = (ExactEnd, usize);

    fn run<T: Int>(&self) -> Result<Self::Output, Overflow> {
        let n = self.rows.len();
        let mut dictionary = Dictionary::<T>::new(self.rows)?;
        let Some(mut row) = dictionary.first_to_leave()? else {
            return Ok((ExactEnd::Solved { z: vec![Q::zero(); n], basis: Basis::new(n) }, 0));
        };
        let mut column = dictionary.place[2 * n];
        for pivots in 1..=self.limit {
            let left = dictionary.basic[row];
            dictionary.pivot(row, column)?;
            if left == 2 * n {
                return Ok((dictionary.solution(), pivots));
            }
            column = dictionary.place[if left < n { left + n } else { left - n }];
            match dictionary.leaving(column)? {
                Some(next) => row = next,
                None => return Ok((ExactEnd::Ray { direction: dictionary.direction(column) }, pivots)),
            }
        }
        Ok((ExactEnd::Limit, self.limit))
    }
}

/// Column of the positive multiplier of the basic variable.
const OWN: usize = 0;
/// Column of the constant.
const CONSTANT: usize = 1;

/// Rows `own · basic = constant + Σ entry · nonbasic`, each primitive.
///
/// Variables: `w_i` is `i`, `z_i` is `n + i`, `z0` is `2 n`.
struct Dictionary<T> {
    rows: Vec<Entries<T>>,
    basic: Vec<usize>,
    /// The variable of each column; the first two have none.
    nonbasic: Vec<usize>,
    /// Row or column of each variable.
    place: Vec<usize>,
}

impl<T: Int> Dictionary<T> {
    fn new(rows: &[Vec<Z>]) -> Result<Self, Overflow> {
        let n = rows.len();
        let mut all = Vec::with_capacity(n);
        for row in rows {
            let mut entries: Entries<T> = Entries::with_capacity(n + 3);
            entries.push(T::unit());
            for entry in row {
                entries.push(T::from_z(entry).ok_or(Overflow)?);
            }
            entries.push(T::unit()); // the covering vector is all ones
            all.push(entries);
        }
        let nonbasic = [usize::MAX; 2].into_iter().chain(n..=2 * n).collect();
        Ok(Self { rows: all, basic: (0..n).collect(), nonbasic, place: (0..n).chain(2..n + 3).collect() })
    }

    /// The row with the least `q' + (ε, ε², …)`, or none if `q' ≥ 0`.
    fn first_to_leave(&self) -> Result<Option<usize>, Overflow> {
        let constant = |row: &usize| &self.rows[*row][CONSTANT];
        let least = (0..self.rows.len()).min_by(|a, b| constant(a).cmp(constant(b)).then(b.cmp(a)));
        Ok(least.filter(|row| constant(row).sign().is_lt()))
    }

    fn pivot(&mut self, row: usize, column: usize) -> Result<(), Overflow> {
        let mut chosen = std::mem::take(&mut self.rows[row]);
        // own x = … + entry y becomes -entry y = … - own x; the column's entry is negative or the cover's first one
        let is_positive = chosen[column].sign().is_gt();
        let entry = chosen[column].clone();
        chosen[column] = chosen[OWN].negated();
        chosen[OWN] = T::default();
        let multiplier = if is_positive { entry.clone() } else { entry.negated() };
        let wide = multiplier.widen();
        for other in &mut self.rows {
            if other.is_empty() || other[column].sign().is_eq() {
                continue;
            }
            let by = std::mem::take(&mut other[column]);
            let by = if is_positive { by.negated() } else { by };
            let mut next = Entries::with_capacity(other.len());
            T::combine(&wide, other, &by.widen(), &chosen, &mut next)?;
            *other = next;
        }
        if is_positive {
            chosen.iter_mut().for_each(|value| *value = value.negated());
        }
        chosen[OWN] = multiplier;
        self.rows[row] = chosen;
        let (left, entered) = (self.basic[row], self.nonbasic[column]);
        self.basic[row] = entered;
        self.nonbasic[column] = left;
        self.place[entered] = row;
        self.place[left] = column;
        Ok(())
    }

    /// The row that bounds the growth of the variable in `column` first; `z0` if it ties.
    fn leaving(&self, column: usize) -> Result<Option<usize>, Overflow> {
        let mut best: Option<usize> = None;
        let cover = self.place[2 * self.basic.len()];
        for row in (0..self.rows.len()).filter(|row| self.rows[*row][column].sign().is_lt()) {
            let Some(so_far) = best else {
                best = Some(row);
                continue;
            };
            let order = match self.compare(row, so_far, column, |row| Some(&self.rows[row][CONSTANT]), false)? {
                Ordering::Equal if row == cover => Ordering::Less,
                Ordering::Equal if so_far == cover => Ordering::Greater,
                Ordering::Equal => self.lexicographic(row, so_far, column)?,
                order => order,
            };
            if order.is_lt() {
                best = Some(row);
            }
        }
        Ok(best)
    }

    /// Which of two rows that tie bounds first if `q'` grows by `(ε, ε², …)`: a basic `w_k` gains `ε_k`, and a nonbasic
    /// one stands for `w_k - ε_k`.
    fn lexicographic(&self, a: usize, b: usize, column: usize) -> Result<Ordering, Overflow> {
        for variable in 0..self.basic.len() {
            let place = self.place[variable];
            let is_basic = self.basic.get(place) == Some(&variable);
            let change = |row: usize| match is_basic {
                true => (place == row).then(|| &self.rows[row][OWN]),
                false => Some(&self.rows[row][place]),
            };
            let order = self.compare(a, b, column, change, !is_basic)?;
            if order.is_ne() {
                return Ok(order);
            }
        }
        Ok(Ordering::Equal)
    }

    /// Compares `value / -entry` of two rows, none counting as zero, with all values negated on request.
    fn compare<'a>(
        &'a self,
        a: usize,
        b: usize,
        column: usize,
        value: impl Fn(usize) -> Option<&'a T>,
        negated: bool,
    ) -> Result<Ordering, Overflow> {
        let take = |row: usize| value(row).cloned().unwrap_or_default();
        let [ours, theirs] = [&self.rows[a][column], &self.rows[b][column]];
        // ours_value / -ours - theirs_value / -theirs has the sign of theirs_value · ours - ours_value · theirs
        let difference = T::dot(&[take(b), take(a).negated()], &[ours.clone(), theirs.clone()])?;
        let sign = T::wide_sign(&difference);
        Ok(if negated { sign.reverse() } else { sign })
    }

    fn solution(&self) -> ExactEnd {
        let n = self.basic.len();
        let mut z = vec![Q::zero(); n];
        let mut basis = Basis::new(n);
        for (variable, row) in self.basic.iter().zip(&self.rows).filter(|(variable, _)| **variable >= n) {
            basis.insert(variable - n);
            z[variable - n] = Q::new(row[CONSTANT].to_z(), row[OWN].to_z());
        }
        ExactEnd::Solved { z, basis }
    }

    /// How `z` changes with the variable in `column`.
    fn direction(&self, column: usize) -> Vec<Q> {
        let n = self.basic.len();
        let mut direction = vec![Q::zero(); n];
        let mut set = |variable: usize, value: Q| {
            if (n..2 * n).contains(&variable) {
                direction[variable - n] = value;
            }
        };
        set(self.nonbasic[column], Q::one());
        for (variable, row) in self.basic.iter().zip(&self.rows) {
            set(*variable, Q::new(row[column].to_z(), row[OWN].to_z()));
        }
        direction
    }
}
