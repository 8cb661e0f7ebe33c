//! All nondegenerate solutions by Gaussian elimination on each of the 2^n bases.

use num_traits::{Signed as _, Zero as _};
use partplan::complementarity::ExactLcp;
use partplan::exact::{Q, ratio, to_f64};

pub fn lcp(m: &[&[i64]], q: &[i64]) -> ExactLcp {
    let row = |row: &[i64]| row.iter().map(|entry| ratio(*entry, 1)).collect::<Vec<Q>>();
    ExactLcp::new(m.iter().map(|entries| row(entries)).collect(), row(q)).unwrap()
}

/// The solutions of all complementary bases that are not singular, each once.
pub fn basic_solutions(lcp: &ExactLcp) -> Vec<Vec<Q>> {
    let n = lcp.size();
    let mut found: Vec<Vec<Q>> = Vec::new();
    for mask in 0_u32..1 << n {
        let basic: Vec<usize> = (0..n).filter(|i| mask >> i & 1 == 1).collect();
        let rows = basic.iter().map(|i| {
            let entries = basic.iter().map(|j| lcp.m()[*i][*j].clone());
            entries.chain([-&lcp.q()[*i]]).collect::<Vec<Q>>()
        });
        let Some(values) = eliminate(rows.collect()) else { continue };
        let mut z = vec![Q::zero(); n];
        basic.iter().zip(values).for_each(|(index, value)| z[*index] = value);
        if lcp.is_solution(&z) && !found.contains(&z) {
            found.push(z);
        }
    }
    found
}

/// Solves the system whose rows end in the right side; `None` if it is singular.
fn eliminate(mut rows: Vec<Vec<Q>>) -> Option<Vec<Q>> {
    let k = rows.len();
    for step in 0..k {
        let pivot_row = (step..k).find(|row| !rows[*row][step].is_zero())?;
        rows.swap(step, pivot_row);
        let pivot = rows[step].clone();
        for (index, row) in rows.iter_mut().enumerate() {
            if index != step && !row[step].is_zero() {
                let factor = &row[step] / &pivot[step];
                row.iter_mut().zip(&pivot).for_each(|(entry, by)| *entry -= &factor * by);
            }
        }
    }
    Some((0..k).map(|at| &rows[at][k] / &rows[at][at]).collect())
}

/// Whether all principal minors are positive, by elimination on each principal submatrix.
pub fn is_p_matrix(lcp: &ExactLcp) -> bool {
    (1_u32..1 << lcp.size()).all(|mask| {
        let basic: Vec<usize> = (0..lcp.size()).filter(|i| mask >> i & 1 == 1).collect();
        let rows: Vec<Vec<Q>> = basic.iter().map(|i| basic.iter().map(|j| lcp.m()[*i][*j].clone()).collect()).collect();
        determinant(rows).is_positive()
    })
}

fn determinant(mut rows: Vec<Vec<Q>>) -> Q {
    let mut value = ratio(1, 1);
    for step in 0..rows.len() {
        let Some(pivot_row) = (step..rows.len()).find(|row| !rows[*row][step].is_zero()) else { return Q::zero() };
        if pivot_row != step {
            rows.swap(step, pivot_row);
            value = -value;
        }
        let pivot = rows[step].clone();
        value *= &pivot[step];
        for row in &mut rows[step + 1..] {
            let factor = &row[step] / &pivot[step];
            row.iter_mut().zip(&pivot).for_each(|(entry, by)| *entry -= &factor * by);
        }
    }
    value
}

/// The problem in doubles, row after row; only for entries that are doubles or nearly so.
pub fn in_doubles(lcp: &ExactLcp) -> (Vec<f64>, Vec<f64>) {
    (lcp.m().iter().flatten().map(to_f64).collect(), lcp.q().iter().map(to_f64).collect())
}
