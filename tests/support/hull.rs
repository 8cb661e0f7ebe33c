//! The textbook double description method on integer vectors, without any of the tricks that make it fast.

use num_integer::Integer as _;
use num_traits::{Signed, Zero};
use partplan::exact::{Q, Z, primitive_row};

/// Generators of a polyhedral cone: all of `lines` in both directions, and `rays`, extreme modulo the lines.
#[derive(Debug, Clone)]
pub struct Generators {
    pub lines: Vec<Vec<Z>>,
    pub rays: Vec<Vec<Z>>,
}

/// Generators of `{f : v . f <= 0 for all v in vectors}`; seen from the cone that `vectors` span, its face normals.
pub fn polar(dimension: usize, vectors: &[Vec<Z>]) -> Generators {
    let unit = |i| (0..dimension).map(|j| Z::from(i32::from(i == j))).collect();
    let mut lines: Vec<Vec<Z>> = (0..dimension).map(unit).collect();
    let mut rays: Vec<Vec<Z>> = Vec::new();
    for (done, v) in vectors.iter().enumerate() {
        if let Some(at) = lines.iter().position(|line| !product(v, line).is_zero()) {
            let mut line = lines.swap_remove(at);
            if product(v, &line).is_positive() {
                line.iter_mut().for_each(|x| *x = -&*x);
            }
            let scale = -product(v, &line);
            let onto_plane = |r: &Vec<Z>| combination(&scale, r, &product(v, r), &line);
            lines = lines.iter().map(onto_plane).collect();
            rays = rays.iter().map(onto_plane).collect();
            rays.push(line);
        } else {
            rays = cut(&rays, v, &vectors[..done]);
        }
    }
    Generators { lines, rays }
}

/// Keeps what satisfies `v . r <= 0`, and where an edge between two rays passes through the plane, the point of passage.
fn cut(rays: &[Vec<Z>], v: &[Z], earlier: &[Vec<Z>]) -> Vec<Vec<Z>> {
    let tight: Vec<Vec<bool>> =
        rays.iter().map(|r| earlier.iter().map(|e| product(e, r).is_zero()).collect()).collect();
    let sides: Vec<Z> = rays.iter().map(|r| product(v, r)).collect();
    let mut kept: Vec<Vec<Z>> = (0..rays.len()).filter(|i| !sides[*i].is_positive()).map(|i| rays[i].clone()).collect();
    for inside in (0..rays.len()).filter(|i| sides[*i].is_negative()) {
        for outside in (0..rays.len()).filter(|i| sides[*i].is_positive()) {
            let common: Vec<usize> = (0..earlier.len()).filter(|e| tight[inside][*e] && tight[outside][*e]).collect();
            let between = (0..rays.len()).filter(|i| *i != inside && *i != outside);
            let adjacent = between.into_iter().all(|i| common.iter().any(|e| !tight[i][*e]));
            if adjacent {
                kept.push(combination(&sides[outside], &rays[inside], &-&sides[inside], &rays[outside]));
            }
        }
    }
    kept
}

pub fn product(a: &[Z], b: &[Z]) -> Z {
    assert_eq!(a.len(), b.len());
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

fn combination(p: &Z, a: &[Z], q: &Z, b: &[Z]) -> Vec<Z> {
    primitive(a.iter().zip(b).map(|(x, y)| p * x + q * y).collect())
}

pub fn primitive(mut row: Vec<Z>) -> Vec<Z> {
    let divisor = row.iter().fold(Z::zero(), |g, x| g.gcd(x));
    if !divisor.is_zero() {
        row.iter_mut().for_each(|x| *x = &*x / &divisor);
    }
    row
}

pub fn negated(row: &[Z]) -> Vec<Z> {
    row.iter().map(|x| -x).collect()
}

/// Integer vectors on the same rays.
pub fn integers(rows: &[Vec<Q>]) -> Vec<Vec<Z>> {
    rows.iter().map(|row| primitive_row(row)).collect()
}

/// Reduced row echelon basis of the span, coprime rows with positive pivots.
pub fn echelon(rows: &[Vec<Z>]) -> Vec<Vec<Z>> {
    let width = rows.first().map_or(0, Vec::len);
    let mut rows = rows.to_vec();
    let mut done = 0;
    for column in 0..width {
        let Some(at) = (done..rows.len()).find(|r| !rows[*r][column].is_zero()) else { continue };
        rows.swap(done, at);
        if rows[done][column].is_negative() {
            rows[done] = negated(&rows[done]);
        }
        rows[done] = primitive(rows[done].clone());
        let pivot = rows[done].clone();
        for r in (0..rows.len()).filter(|r| *r != done) {
            rows[r] = combination(&pivot[column], &rows[r].clone(), &-&rows[r][column].clone(), &pivot);
        }
        done += 1;
    }
    rows.truncate(done);
    rows
}

/// `row` plus the multiples of the echelon `basis` that clear its pivot columns, on the same side, coprime.
pub fn reduced(row: &[Z], basis: &[Vec<Z>]) -> Vec<Z> {
    let mut row = row.to_vec();
    for pivot in basis {
        let column = pivot.iter().position(|x| !x.is_zero()).expect("basis rows are not zero");
        row = combination(&pivot[column], &row, &-&row[column].clone(), pivot);
    }
    primitive(row)
}
