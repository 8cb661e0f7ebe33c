//! Balkcom & Trinkle's own construction of a wrench cone: matrices E, N, R, S, V and `F = K^F P`, eqs. (6)-(18).

use super::canonical::{Inequality, canonical};
use super::hull::{integers, negated, polar};
use super::modes::Contacts;
use super::{Wrench, member::rational};
use nalgebra::DMatrix;
use num_traits::{One, Signed, Zero};
use partplan::answer::Cone;
use partplan::exact::{Q, Z};

pub type Matrix = DMatrix<Q>;

/// Whose signs Section 5.4's matrix S carries.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SlidingSign {
    /// Table 2's: `c_t = -mu_k c_n` for `l`.
    Table2,
    /// As printed in Section 5.4: exchanged.
    Printed,
}

/// J (3, 2n): normals first, then tangents.
pub fn jacobian(contacts: &Contacts) -> Matrix {
    let normals = contacts.list.iter().map(|c| &c.normal);
    let columns: Vec<&Wrench> = normals.chain(contacts.list.iter().map(|c| &c.tangent)).collect();
    DMatrix::from_fn(3, columns.len(), |i, j| columns[j][i].clone())
}

/// B = J^T M^-1 (2n, 3), for unit mass.
pub fn b_matrix(contacts: &Contacts) -> Matrix {
    let inverse = [Q::one(), Q::one(), contacts.rho2.recip()];
    jacobian(contacts).transpose() * DMatrix::from_fn(3, 3, |i, j| if i == j { inverse[i].clone() } else { Q::zero() })
}

/// C = [I -A] (2n, 4n) with A = J^T M^-1 J, eq. (8).
pub fn c_matrix(contacts: &Contacts) -> Matrix {
    let a = b_matrix(contacts) * jacobian(contacts);
    let rows = a.nrows();
    DMatrix::from_fn(rows, 2 * rows, |i, j| match j.checked_sub(rows) {
        None => {
            if i == j {
                Q::one()
            } else {
                Q::zero()
            }
        }
        Some(k) => -&a[(i, k)],
    })
}

/// `K z = P g` with `z >= 0`, and `z_j > 0` where `strict`.
#[derive(Debug, Clone)]
pub struct ConeForm {
    pub k: Matrix,
    pub p: Matrix,
    pub strict: Vec<bool>,
    /// E, N, R, S, V.
    pub e: Matrix,
    pub n: Matrix,
    pub r: Matrix,
    pub s: Matrix,
    pub v: Matrix,
}

/// What a mode asks of each element of `y = (a, c)`: index sets of Sections 5.1 to 5.5.
#[derive(Default)]
struct Sets {
    unconstrained: Vec<usize>,
    negative: Vec<usize>,
    rolling: Vec<usize>,
    sliding_left: Vec<usize>,
    sliding_right: Vec<usize>,
    zero: Vec<usize>,
    strict: Vec<usize>,
}

impl Sets {
    /// Table 2, with `b` for an `s` whose `a_n > 0`. Frictionless rolling has `c_t = 0`, because R is singular there.
    fn of(contacts: &Contacts, mode: &str) -> Self {
        let n = contacts.list.len();
        let mut sets = Self::default();
        for (i, letter) in mode.chars().enumerate() {
            let (a_n, a_t, c_n, c_t) = (i, n + i, 2 * n + i, 3 * n + i);
            match letter {
                's' => sets.unconstrained.push(a_t),
                'b' => {
                    sets.unconstrained.push(a_t);
                    sets.strict.push(a_n);
                }
                'a' => {
                    sets.unconstrained.push(a_t);
                    sets.strict.push(a_n);
                    sets.negative.push(a_n);
                }
                'u' => sets.unconstrained.extend([a_n, a_t]),
                'l' => {
                    sets.zero.push(a_n);
                    sets.strict.push(a_t);
                    sets.sliding_left.push(c_t);
                }
                'r' => {
                    sets.zero.push(a_n);
                    sets.strict.push(a_t);
                    sets.negative.push(a_t);
                    sets.sliding_right.push(c_t);
                }
                'n' => sets.zero.extend([a_n, a_t]),
                'm' => {
                    sets.zero.push(a_n);
                    sets.unconstrained.push(a_t);
                }
                _ => panic!("{letter} is not a letter"),
            }
            match letter {
                's' | 'b' | 'a' | 'u' => sets.zero.extend([c_n, c_t]),
                'n' | 'm' if contacts.list[i].friction.static_.max.is_zero() => sets.zero.push(c_t),
                'n' | 'm' => sets.rolling.push(c_t),
                _ => {}
            }
        }
        sets
    }
}

/// K, P and the selection matrices of one mode; every friction range must hold a single number.
pub fn cone_form(contacts: &Contacts, mode: &str, sign: SlidingSign) -> ConeForm {
    let n = contacts.list.len();
    assert_eq!(mode.len(), n);
    let friction = |c_t: usize| &contacts.list[c_t - 3 * n].friction;
    for contact in &contacts.list {
        let f = &contact.friction;
        assert!(f.static_.min == f.static_.max && f.kinetic.min == f.kinetic.max, "the paper knows no ranges");
    }
    let sets = Sets::of(contacts, mode);
    let identity = |size: usize| Matrix::from_fn(size, size, |i, j| if i == j { Q::one() } else { Q::zero() });

    let e = without_rows(&identity(2 * n), &sets.unconstrained); // rows of the constrained accelerations
    let mut negative = identity(4 * n);
    for i in &sets.negative {
        negative[(*i, *i)] = -Q::one();
    }
    let mut r = identity(4 * n);
    for i in &sets.rolling {
        let mu = &friction(*i).static_.max;
        r[(*i, *i)] = mu.clone();
        r[(*i - n, *i)] = Q::one();
        r[(*i, *i - n)] = -mu;
    }
    let mut s = identity(4 * n);
    let left = if sign == SlidingSign::Table2 { -Q::one() } else { Q::one() };
    for i in &sets.sliding_left {
        s[(*i, *i - n)] = &left * &friction(*i).kinetic.max;
    }
    for i in &sets.sliding_right {
        s[(*i, *i - n)] = -&left * &friction(*i).kinetic.max;
    }
    let removed: Vec<usize> = [&sets.zero, &sets.sliding_left, &sets.sliding_right, &sets.unconstrained]
        .into_iter()
        .flatten()
        .copied()
        .collect();
    let v = without_rows(&identity(4 * n), &removed).transpose(); // columns of the surviving variables
    let strict = (0..4 * n).filter(|i| !removed.contains(i)).map(|i| sets.strict.contains(&i)).collect();
    let k = &e * c_matrix(contacts) * &negative * &r * &s * &v;
    let p = &e * b_matrix(contacts);
    ConeForm { k, p, strict, e, n: negative, r, s, v }
}

fn without_rows(matrix: &Matrix, removed: &[usize]) -> Matrix {
    let kept: Vec<usize> = (0..matrix.nrows()).filter(|i| !removed.contains(i)).collect();
    DMatrix::from_fn(kept.len(), matrix.ncols(), |i, j| matrix[(kept[i], j)].clone())
}

/// K^F: rows `f` with `pos(K) = {x : f . x <= 0}`, Section 3.1.
pub fn face_normals(k: &Matrix) -> Matrix {
    let columns: Vec<Vec<Q>> = k.column_iter().map(|column| column.iter().cloned().collect()).collect();
    let dual = polar(k.nrows(), &integers(&columns));
    let mut rows: Vec<Vec<Z>> = dual.rays;
    rows.extend(dual.lines.iter().flat_map(|line| [line.clone(), negated(line)]));
    let rows: Vec<Vec<Q>> = rows.iter().map(|row| rational(row)).collect();
    DMatrix::from_fn(rows.len(), k.nrows(), |i, j| rows[i][j].clone())
}

/// `F g <= 0` with `F = K^F P`, eq. (18); a row is strict iff some strict column of K lies off its face: where the row
/// is tight that variable is zero, as Theorem 1 says with a positive offset k.
pub fn inequalities(form: &ConeForm) -> Vec<Inequality> {
    let faces = face_normals(&form.k);
    let (of_wrench, of_columns) = (&faces * &form.p, &faces * &form.k);
    (0..faces.nrows())
        .map(|i| Inequality {
            row: of_wrench.row(i).iter().cloned().collect(),
            strict: (0..form.strict.len()).any(|j| form.strict[j] && of_columns[(i, j)].is_negative()),
        })
        .collect()
}

/// The canonical form of the cone of `mode`.
pub fn mode_cone(contacts: &Contacts, mode: &str) -> Cone {
    canonical(&inequalities(&cone_form(contacts, mode, SlidingSign::Table2)))
}
