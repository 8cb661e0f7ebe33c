//! Exact feasibility of small linear programs: two-phase simplex with Bland's rule.

use super::dot;
use num_traits::{One, Signed, Zero};
use partplan::exact::{Q, Z, primitive_row};

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Relation {
    Equal,
    AtLeast,
    Greater,
}

/// Find `x` with `row . x (relation) bound` for every row; the first `free` variables may be negative, the rest not.
#[derive(Debug, Clone)]
pub struct Program {
    free: usize,
    non_negative: usize,
    rows: Vec<(Vec<Q>, Relation, Q)>,
}

impl Program {
    pub fn new(free: usize, non_negative: usize) -> Self {
        Self { free, non_negative, rows: Vec::new() }
    }

    pub fn require(&mut self, row: Vec<Q>, relation: Relation, bound: Q) {
        assert_eq!(row.len(), self.free + self.non_negative);
        self.rows.push((row, relation, bound));
    }

    pub fn is_feasible(&self) -> bool {
        self.witness().is_some()
    }

    /// A solution, checked by substitution. Strict rows must hold by a common margin `t <= 1`, which is maximised.
    pub fn witness(&self) -> Option<Vec<Q>> {
        let split = 2 * self.free + self.non_negative;
        let strict = self.rows.iter().any(|(_, relation, _)| *relation == Relation::Greater);
        let variables = split + usize::from(strict);
        let mut tableau = Tableau::new(variables);
        for (row, relation, bound) in &self.rows {
            let (free, rest) = row.split_at(self.free);
            let mut wide: Vec<Q> = free.to_vec();
            wide.extend(free.iter().map(|v| -v));
            wide.extend_from_slice(rest);
            wide.resize(variables, Q::zero());
            if *relation == Relation::Greater {
                wide[split] = -Q::one();
            }
            tableau.add(wide, *relation != Relation::Equal, bound.clone());
        }
        if strict {
            let mut wide = vec![Q::zero(); variables];
            wide[split] = -Q::one();
            tableau.add(wide, true, -Q::one());
        }
        let values = tableau.solve(strict.then_some(split))?;
        if strict && !values[split].is_positive() {
            return None;
        }
        let free = (0..self.free).map(|i| &values[i] - &values[self.free + i]);
        let solution: Vec<Q> = free.chain(values[2 * self.free..split].iter().cloned()).collect();
        assert!(self.holds(&solution), "the simplex method returned a point that violates its program");
        Some(solution)
    }

    fn holds(&self, x: &[Q]) -> bool {
        let signs = x[self.free..].iter().all(|v| !v.is_negative());
        signs
            && self.rows.iter().all(|(row, relation, bound)| {
                let gap = dot(row, x) - bound;
                match relation {
                    Relation::Equal => gap.is_zero(),
                    Relation::AtLeast => !gap.is_negative(),
                    Relation::Greater => gap.is_positive(),
                }
            })
    }
}

/// Rows `(entries . x - right) / scale = 0` with `x >= 0`, in integers: every division below is exact (Bareiss).
struct Tableau {
    variables: usize,
    /// Entries, and the right side last.
    rows: Vec<Vec<Z>>,
    /// Which rows own a surplus column with -1.
    surplus: Vec<bool>,
    basis: Vec<usize>,
    /// Reduced costs, and minus the objective last.
    cost: Vec<Z>,
    scale: Z,
}

impl Tableau {
    fn new(variables: usize) -> Self {
        let (rows, surplus, basis, cost) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        Self { variables, rows, surplus, basis, cost, scale: Z::one() }
    }

    fn add(&mut self, mut row: Vec<Q>, surplus: bool, right: Q) {
        row.push(right);
        self.rows.push(primitive_row(&row));
        self.surplus.push(surplus);
    }

    /// Values of the variables at a feasible point, the one with the largest `objective` if there is one.
    fn solve(mut self, objective: Option<usize>) -> Option<Vec<Q>> {
        let artificial = self.start();
        self.minimise();
        if self.basis.iter().zip(&self.rows).any(|(b, row)| *b >= artificial && !row[row.len() - 1].is_zero()) {
            return None;
        }
        self.drop_artificial(artificial);
        if let Some(objective) = objective {
            self.cost = vec![Z::zero(); artificial + 1];
            if let Some(row) = self.basis.iter().position(|b| *b == objective) {
                self.cost.clone_from(&self.rows[row]);
            }
            self.cost[objective] -= &self.scale;
            self.minimise();
        }
        let mut values = vec![Q::zero(); self.variables];
        for (b, row) in self.basis.iter().zip(&self.rows).filter(|(b, _)| **b < self.variables) {
            values[*b] = Q::new(row[row.len() - 1].clone(), self.scale.clone());
        }
        Some(values)
    }

    /// Gives each row a surplus and an artificial column, one of the two in the basis; the first phase minimises the
    /// sum of the artificial ones, which start at the returned column.
    fn start(&mut self) -> usize {
        let count = self.rows.len();
        let artificial = self.variables + count;
        self.cost = vec![Z::zero(); artificial + count + 1];
        for i in 0..count {
            let right = self.rows[i].pop().expect("the right side is last");
            let own = self.surplus[i] && !right.is_positive();
            let row = &mut self.rows[i];
            row.resize(artificial + count, Z::zero());
            row.push(right.clone());
            if self.surplus[i] {
                row[self.variables + i] = -Z::one();
            }
            if own || right.is_negative() {
                row.iter_mut().for_each(|v| *v = -&*v);
            }
            self.basis.push(if own { self.variables + i } else { artificial + i });
            if !own {
                self.cost.iter_mut().zip(&*row).for_each(|(cost, v)| *cost -= v);
                row[artificial + i] = Z::one();
            }
        }
        artificial
    }

    /// Bland: the first column that lowers the cost, and among the rows that bound it the first basic variable.
    fn minimise(&mut self) {
        let columns = self.cost.len() - 1;
        while let Some(column) = (0..columns).find(|c| self.cost[*c].is_negative()) {
            let ratio = |r: &usize| Q::new(self.rows[*r][columns].clone(), self.rows[*r][column].clone());
            let bounding = (0..self.rows.len()).filter(|r| self.rows[*r][column].is_positive());
            let row = bounding.min_by_key(|r| (ratio(r), self.basis[*r])).expect("both objectives are bounded");
            self.pivot(row, column);
        }
    }

    fn drop_artificial(&mut self, artificial: usize) {
        let mut row = 0;
        while row < self.rows.len() {
            if self.basis[row] < artificial {
                row += 1;
            } else if let Some(column) = (0..artificial).find(|c| !self.rows[row][*c].is_zero()) {
                if self.rows[row][column].is_negative() {
                    self.rows[row].iter_mut().for_each(|v| *v = -&*v); // its right side is zero
                }
                self.pivot(row, column);
                row += 1;
            } else {
                self.rows.swap_remove(row);
                self.basis.swap_remove(row);
            }
        }
        for row in &mut self.rows {
            row.drain(artificial..row.len() - 1);
        }
    }

    fn pivot(&mut self, row: usize, column: usize) {
        let pivot_row = self.rows[row].clone();
        let pivot = &pivot_row[column];
        let others = self.rows.iter_mut().enumerate().filter(|(r, _)| *r != row).map(|(_, other)| other);
        for other in others.chain([&mut self.cost]) {
            let factor = other[column].clone();
            for (value, entry) in other.iter_mut().zip(&pivot_row) {
                if !value.is_zero() || !(factor.is_zero() || entry.is_zero()) {
                    *value = (&*value * pivot - &factor * entry) / &self.scale;
                }
            }
        }
        self.scale = pivot.clone();
        self.basis[row] = column;
    }
}
