//! Exact feasibility of small linear programs: two-phase simplex with Bland's rule.

use super::dot;
use num_traits::{One, Signed, Zero};
use partplan::exact::Q;

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

/// Rows `entries . x = right` with `x >= 0`; `surplus` says which rows own a column with -1.
struct Tableau {
    variables: usize,
    rows: Vec<Vec<Q>>,
    surplus: Vec<bool>,
    right: Vec<Q>,
    basis: Vec<usize>,
}

impl Tableau {
    fn new(variables: usize) -> Self {
        Self { variables, rows: Vec::new(), surplus: Vec::new(), right: Vec::new(), basis: Vec::new() }
    }

    fn add(&mut self, row: Vec<Q>, surplus: bool, right: Q) {
        self.rows.push(row);
        self.surplus.push(surplus);
        self.right.push(right);
    }

    /// Values of the variables at a feasible point, the one with the largest `objective` if there is one.
    fn solve(mut self, objective: Option<usize>) -> Option<Vec<Q>> {
        let artificial = self.start();
        let width = self.rows.first().map_or(self.variables, Vec::len);
        let mut cost = vec![Q::zero(); width];
        cost[artificial..].fill(Q::one());
        self.minimise(&cost);
        let infeasible = self.basis.iter().zip(&self.right).any(|(b, value)| *b >= artificial && !value.is_zero());
        if infeasible {
            return None;
        }
        self.drop_artificial(artificial);
        if let Some(objective) = objective {
            let mut cost = vec![Q::zero(); artificial];
            cost[objective] = -Q::one();
            self.minimise(&cost);
        }
        let mut values = vec![Q::zero(); self.variables];
        for (b, value) in self.basis.iter().zip(&self.right) {
            if *b < self.variables {
                values[*b] = value.clone();
            }
        }
        Some(values)
    }

    /// Appends surplus and artificial columns, one of each row's own in the basis; returns the first artificial column.
    fn start(&mut self) -> usize {
        let artificial = self.variables + self.rows.len();
        let width = artificial + self.rows.len();
        for i in 0..self.rows.len() {
            self.rows[i].resize(width, Q::zero());
            if self.surplus[i] {
                self.rows[i][self.variables + i] = -Q::one();
            }
            let own_sign_is_right = self.surplus[i] && !self.right[i].is_positive();
            if self.right[i].is_negative() || own_sign_is_right {
                self.rows[i].iter_mut().for_each(|v| *v = -&*v);
                self.right[i] = -&self.right[i];
            }
            self.basis.push(if own_sign_is_right { self.variables + i } else { artificial + i });
            if !own_sign_is_right {
                self.rows[i][artificial + i] = Q::one();
            }
        }
        artificial
    }

    fn minimise(&mut self, cost: &[Q]) {
        while let Some(column) = (0..cost.len()).find(|c| self.reduced_cost(cost, *c).is_negative()) {
            let ratios = (0..self.rows.len()).filter(|r| self.rows[*r][column].is_positive());
            let row = ratios
                .min_by_key(|r| (&self.right[*r] / &self.rows[*r][column], self.basis[*r]))
                .expect("both objectives are bounded");
            self.pivot(row, column);
        }
    }

    fn reduced_cost(&self, cost: &[Q], column: usize) -> Q {
        let basic: Q = (self.basis.iter().zip(&self.rows))
            .filter(|(b, row)| !cost[**b].is_zero() && !row[column].is_zero())
            .map(|(b, row)| &cost[*b] * &row[column])
            .sum();
        &cost[column] - basic
    }

    fn drop_artificial(&mut self, artificial: usize) {
        let mut row = 0;
        while row < self.rows.len() {
            if self.basis[row] < artificial {
                row += 1;
            } else if let Some(column) = (0..artificial).find(|c| !self.rows[row][*c].is_zero()) {
                self.pivot(row, column);
                row += 1;
            } else {
                self.rows.swap_remove(row);
                self.right.swap_remove(row);
                self.basis.swap_remove(row);
            }
        }
        self.rows.iter_mut().for_each(|r| r.truncate(artificial));
    }

    fn pivot(&mut self, row: usize, column: usize) {
        let scale = self.rows[row][column].recip();
        self.rows[row].iter_mut().filter(|v| !v.is_zero()).for_each(|v| *v *= &scale);
        self.right[row] *= &scale;
        let (pivot_row, pivot_right) = (self.rows[row].clone(), self.right[row].clone());
        for other in (0..self.rows.len()).filter(|r| *r != row) {
            let factor = self.rows[other][column].clone();
            if factor.is_zero() {
                continue;
            }
            for (value, pivot) in self.rows[other].iter_mut().zip(&pivot_row).filter(|(_, pivot)| !pivot.is_zero()) {
                *value -= &factor * pivot;
            }
            self.right[other] -= &factor * &pivot_right;
        }
        self.basis[row] = column;
    }
}
