//! Random systems with small numbers, degenerate ones often.

use num_traits::{Signed, Zero};
use partplan::cone::{Generators, HalfSpaces, Pair};
use partplan::exact::{Int, Matrix, Z};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::Index;
use proptest::test_runner::FileFailurePersistence;

/// `cases` runs unless the environment says otherwise.
pub fn runs(cases: u32) -> ProptestConfig {
    let asked = std::env::var_os("PROPTEST_CASES").is_some();
    let default = ProptestConfig::default();
    ProptestConfig {
        cases: if asked { default.cases } else { cases },
        max_shrink_iters: 500,
        failure_persistence: Some(Box::new(FileFailurePersistence::Direct("proptest-regressions/kernel.txt"))),
        ..default
    }
}

/// Equalities, closed and strict rows.
#[derive(Debug, Clone)]
pub struct System {
    pub dim: usize,
    pub equalities: Vec<Vec<i64>>,
    pub closed: Vec<Vec<i64>>,
    pub strict: Vec<Vec<i64>>,
}

impl System {
    pub fn new(dim: usize, equalities: &[&[i64]], closed: &[&[i64]], strict: &[&[i64]]) -> Self {
        let [equalities, closed, strict] =
            [equalities, closed, strict].map(|rows| rows.iter().map(|row| row.to_vec()).collect());
        Self { dim, equalities, closed, strict }
    }

    pub fn half_spaces<T: Int>(&self) -> HalfSpaces<T> {
        let [equalities, closed, strict] =
            [&self.equalities, &self.closed, &self.strict].map(|rows| matrix(self.dim, rows));
        HalfSpaces { equalities, closed, strict }
    }

    /// By definition.
    pub fn holds(&self, x: &[Z]) -> bool {
        let side = |row: &Vec<i64>| row.iter().zip(x).map(|(a, b)| b * a).sum::<Z>();
        self.equalities.iter().all(|row| side(row).is_zero())
            && self.closed.iter().all(|row| !side(row).is_positive())
            && self.strict.iter().all(|row| side(row).is_negative())
    }

    /// The closed cone of all rows.
    pub fn pair<T: Int>(&self) -> Pair<T> {
        let normals: Vec<Vec<i64>> = self.closed.iter().chain(&self.strict).cloned().collect();
        Pair::from_normals(&matrix(self.dim, &self.equalities), &matrix(self.dim, &normals)).unwrap()
    }
}

pub fn matrix<T: Int>(columns: usize, rows: &[Vec<i64>]) -> Matrix<T> {
    let entry = |value: &i64| T::from_z(&(*value).into()).unwrap();
    Matrix::from_rows(columns, rows.iter().map(|row| row.iter().map(entry).collect::<Vec<T>>()))
}

pub fn convert<T: Int>(row: &[Z]) -> Vec<T> {
    row.iter().map(|value| T::from_z(value).unwrap()).collect()
}

pub fn span<T: Int>(dim: usize, lines: &[Vec<i64>], rays: &[Vec<i64>]) -> Generators<T> {
    Generators { lines: matrix(dim, lines), rays: matrix(dim, rays) }
}

pub fn vector(dim: usize) -> impl Strategy<Value = Vec<i64>> {
    vec(prop_oneof![2 => Just(0_i64), 5 => -3..=3_i64], dim)
}

/// Rows of which most, if a point is drawn, hold there; some are duplicates, opposites, multiples, sums, or zero.
pub fn rows(dim: usize, most: usize) -> impl Strategy<Value = Vec<Vec<i64>>> {
    let inside = prop_oneof![1 => Just(vec![0; dim]), 3 => vector(dim)];
    let more = vec((0..6_u8, any::<Index>(), any::<Index>()), 0..=2);
    (vec(vector(dim), 0..=most), inside, more).prop_map(move |(mut rows, inside, more)| {
        for row in &mut rows {
            if row.iter().zip(&inside).map(|(a, b)| a * b).sum::<i64>() > 0 {
                row.iter_mut().for_each(|value| *value = -*value);
            }
        }
        for (kind, a, b) in more {
            let zero = vec![0; dim];
            let [a, b] = [a, b].map(|at| if rows.is_empty() { zero.clone() } else { at.get(&rows).clone() });
            rows.push(match kind {
                0 => zero,
                1 => a,
                2 => a.iter().map(|value| -value).collect(),
                3 => a.iter().map(|value| 3 * value).collect(),
                _ => a.iter().zip(&b).map(|(x, y)| x + y).collect(),
            });
        }
        rows
    })
}

/// None most of the time.
pub fn few_rows(dim: usize) -> impl Strategy<Value = Vec<Vec<i64>>> {
    prop_oneof![4 => Just(Vec::new()), 2 => vec(vector(dim), 1), 1 => vec(vector(dim), 2)]
}

pub fn closed_system(dims: std::ops::RangeInclusive<usize>, most: usize) -> impl Strategy<Value = System> {
    dims.prop_flat_map(move |dim| {
        (few_rows(dim), rows(dim, most)).prop_map(move |(equalities, closed)| System {
            dim,
            equalities,
            closed,
            strict: Vec::new(),
        })
    })
}

/// Rows of one draw, each strict or not.
pub fn system(dim: usize, most: usize) -> impl Strategy<Value = System> {
    (few_rows(dim), rows(dim, most), vec(any::<bool>(), most + 2)).prop_map(move |(equalities, rows, is_strict)| {
        let (strict, closed): (Vec<_>, Vec<_>) = rows.into_iter().zip(is_strict).partition(|(_, strict)| *strict);
        let [closed, strict] = [closed, strict].map(|rows| rows.into_iter().map(|(row, _)| row).collect());
        System { dim, equalities, closed, strict }
    })
}

/// One point inside of each face of the cone, the same moved along a line, and their negatives.
pub fn face_points<T: Int>(pair: &Pair<T>) -> Vec<Vec<Z>> {
    let mut points = Vec::new();
    for face in pair.faces().unwrap() {
        let mut point = vec![Z::zero(); pair.ambient()];
        for (weight, ray) in face.iter().enumerate() {
            add(&mut point, pair.rays().row(*ray), weight as i64 + 1);
        }
        points.push(point.clone());
        points.push(point.iter().map(|v| -v).collect());
        for (weight, line) in pair.lines().rows().enumerate() {
            add(&mut point, line, 2 * weight as i64 - 1);
            points.push(point.clone());
        }
    }
    points
}

fn add<T: Int>(point: &mut [Z], row: &[T], weight: i64) {
    point.iter_mut().zip(row).for_each(|(v, r)| *v += r.to_z() * weight);
}
