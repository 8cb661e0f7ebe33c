//! Both forms of a cone by trying every set of normals, in rational linear algebra.

use super::support::dot;
use num_integer::Integer as _;
use num_traits::{One, Signed, Zero};
use partplan::cone::Pair;
use partplan::exact::{Int, Matrix, Q, Z};

pub type Row = Vec<Q>;

/// The four parts of a canonical pair.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Forms {
    pub equalities: Vec<Vec<Z>>,
    pub facets: Vec<Vec<Z>>,
    pub lines: Vec<Vec<Z>>,
    pub rays: Vec<Vec<Z>>,
}

pub fn rational(row: &[i64]) -> Row {
    row.iter().map(|value| Q::from_integer((*value).into())).collect()
}

pub fn rationals(rows: &[Vec<i64>]) -> Vec<Row> {
    rows.iter().map(|row| rational(row)).collect()
}

pub fn integers<T: Int>(matrix: &Matrix<T>) -> Vec<Vec<Z>> {
    matrix.rows().map(|row| row.iter().map(T::to_z).collect()).collect()
}

pub fn rows_of<T: Int>(matrix: &Matrix<T>) -> Vec<Row> {
    matrix.rows().map(|row| row.iter().map(|value| Q::from_integer(value.to_z())).collect()).collect()
}

/// What the kernel says.
pub fn forms<T: Int>(pair: &Pair<T>) -> Forms {
    let [equalities, facets, lines, rays] = [pair.equalities(), pair.facets(), pair.lines(), pair.rays()].map(integers);
    Forms { equalities, facets, lines, rays }
}

/// What `{x : equalities x = 0, normals x <= 0}` must be.
pub fn forms_of_normals(dim: usize, equalities: &[Row], normals: &[Row]) -> Forms {
    let (lines, rays) = dual(dim, equalities, normals);
    let (span, facets) = dual(dim, &lines, &rays);
    let [equalities, facets, lines, rays] = [span, facets, lines, rays].map(|rows| coprime_rows(&rows));
    let [facets, rays] = [facets, rays].map(|mut rows| {
        rows.sort();
        rows
    });
    Forms { equalities, facets, lines, rays }
}

/// A basis of the lineality space and all extreme rays: on a line of the space orthogonal to the lineality space, where
/// one normal less than a basis vanishes.
fn dual(dim: usize, equalities: &[Row], normals: &[Row]) -> (Vec<Row>, Vec<Row>) {
    let all: Vec<Row> = equalities.iter().chain(normals).cloned().collect();
    let lines = echelon(dim, &kernel(dim, &all));
    let within: Vec<Row> = equalities.iter().chain(&lines).cloned().collect();
    let free = dim - rank(dim, &within);
    let mut rays: Vec<Row> = Vec::new();
    if free > 0 {
        for chosen in subsets(normals.len(), free - 1) {
            let tight: Vec<Row> = within.iter().cloned().chain(chosen.iter().map(|i| normals[*i].clone())).collect();
            let [direction] = &kernel(dim, &tight)[..] else { continue };
            for candidate in [direction.clone(), direction.iter().map(|v| -v).collect()] {
                if normals.iter().all(|normal| !dot(normal, &candidate).is_positive()) {
                    rays.push(reduced(&lines, &candidate));
                }
            }
        }
    }
    let mut unique: Vec<Row> = Vec::new();
    for ray in rays {
        let ray: Row = coprime(&ray).into_iter().map(Q::from_integer).collect();
        if !unique.contains(&ray) {
            unique.push(ray);
        }
    }
    (lines, unique)
}

/// All subsets of `0..of` with `size` members.
fn subsets(of: usize, size: usize) -> Vec<Vec<usize>> {
    if size == 0 {
        return vec![Vec::new()];
    }
    let mut all = Vec::new();
    for last in size - 1..of {
        all.extend(subsets(last, size - 1).into_iter().map(|mut subset| {
            subset.push(last);
            subset
        }));
    }
    all
}

/// Reduced row echelon form with pivots one.
pub fn echelon(dim: usize, rows: &[Row]) -> Vec<Row> {
    let mut rows = rows.to_vec();
    let mut done = 0;
    for column in 0..dim {
        let Some(found) = (done..rows.len()).find(|r| !rows[*r][column].is_zero()) else { continue };
        rows.swap(done, found);
        let pivot = rows[done][column].clone();
        rows[done].iter_mut().for_each(|v| *v /= &pivot);
        let pivot_row = rows[done].clone();
        for row in (0..rows.len()).filter(|r| *r != done) {
            let factor = rows[row][column].clone();
            if !factor.is_zero() {
                rows[row].iter_mut().zip(&pivot_row).for_each(|(v, p)| *v -= &factor * p);
            }
        }
        done += 1;
    }
    rows.truncate(done);
    rows
}

pub fn rank(dim: usize, rows: &[Row]) -> usize {
    echelon(dim, rows).len()
}

fn pivot(row: &Row) -> usize {
    row.iter().position(|v| !v.is_zero()).expect("a row of a basis is not zero")
}

/// A basis of `{x : rows x = 0}`.
fn kernel(dim: usize, rows: &[Row]) -> Vec<Row> {
    let basis = echelon(dim, rows);
    let pivots: Vec<usize> = basis.iter().map(pivot).collect();
    let free = (0..dim).filter(|column| !pivots.contains(column));
    free.map(|column| {
        let mut x = vec![Q::zero(); dim];
        x[column] = Q::one();
        for (row, pivot) in basis.iter().zip(&pivots) {
            x[*pivot] = -&row[column];
        }
        x
    })
    .collect()
}

/// The vector equal to `row` modulo the basis in echelon form, with zeros in its pivot columns.
pub fn reduced(basis: &[Row], row: &Row) -> Row {
    let mut row = row.clone();
    for own in basis {
        let factor = row[pivot(own)].clone();
        row.iter_mut().zip(own).for_each(|(v, b)| *v -= &factor * b);
    }
    row
}

pub fn coprime(row: &Row) -> Vec<Z> {
    let denominator = row.iter().fold(Z::one(), |lcm, v| lcm.lcm(v.denom()));
    let scaled: Vec<Z> = row.iter().map(|v| (v * &denominator).to_integer()).collect();
    let divisor = scaled.iter().fold(Z::zero(), |gcd, v| gcd.gcd(v));
    if divisor.is_zero() { scaled } else { scaled.iter().map(|v| v / &divisor).collect() }
}

fn coprime_rows(rows: &[Row]) -> Vec<Vec<Z>> {
    rows.iter().map(coprime).collect()
}
