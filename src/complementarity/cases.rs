//! All solutions of a small problem: complementary choices, depth first.

use super::integral::Integral;
use crate::cone::Pair;
use crate::exact::{Int, Ladder, Matrix, Overflow, Z, climb, on_rung};
use std::cmp::Ordering;

/// What the search found.
#[derive(Debug, Clone, Default)]
pub(super) struct Cases {
    /// Maximal convex sets of solutions.
    pub(super) pieces: Vec<Choice>,
    /// Choices without a solution; with those of the pieces they are all.
    pub(super) excluded: Vec<[Vec<usize>; 2]>,
    /// Cases looked at.
    pub(super) visited: usize,
    /// Whether the limit was not met.
    pub(super) is_complete: bool,
}

/// The set of all solutions with some zeros.
#[derive(Debug, Clone)]
pub(super) struct Choice {
    /// Indices with `z = 0`, respectively `w = 0`, on all of the set; together all indices.
    pub(super) zeros: [Vec<usize>; 2],
    /// Rows `(t, t z')`: points where `t > 0`, else directions.
    pub(super) generators: Vec<Vec<Z>>,
}

/// Searches at most `limit` cases.
///
/// A case is a polyhedron `z' ≥ 0` with some `z'_i = 0`, `w'_i ≥ 0` and some `w'_i = 0`, given by its vertices and rays. Where
/// these violate no pair the polyhedron is a set of solutions; else a violated pair is decided both ways, one of which
/// is often seen to be empty.
pub(super) fn search(integral: &Integral, limit: usize) -> Cases {
    let longest = integral.rows.iter().flatten().map(Z::bits).max().unwrap_or(0);
    let lowest = if longest > 30 { crate::exact::Rung::Big } else { crate::exact::Rung::Word };
    let mut cases = climb(&Search { rows: &integral.rows, limit }, lowest).0;
    keep_maximal(&mut cases.pieces);
    cases
}

struct Search<'a> {
    rows: &'a [Vec<Z>],
    limit: usize,
}

impl Ladder for Search<'_> {
    type Output = Cases;

    fn run<T: Int>(&self) -> Result<Cases, Overflow> {
        let rows = self.rows.iter().map(|row| on_rung(row)).collect::<Result<Vec<Vec<T>>, _>>()?;
        let mut cases = Cases { is_complete: true, ..Cases::default() };
        let start = Case { zero_z: Vec::new(), zero_w: Vec::new(), bounded_w: Vec::new() };
        visit(&rows, start, self.limit, &mut cases)?;
        Ok(cases)
    }
}

#[derive(Debug, Clone)]
struct Case {
    zero_z: Vec<usize>,
    zero_w: Vec<usize>,
    /// Indices with `w' ≥ 0`.
    bounded_w: Vec<usize>,
}

/// What the generators of a case say about a pair.
#[derive(Debug, Clone, Copy, Default)]
struct PairSigns {
    /// Some generator has `z > 0`.
    z_positive: bool,
    /// Some generator has `w > 0`, `w < 0`.
    w_positive: bool,
    w_negative: bool,
    /// Some point has `z = 0` and `w ≥ 0`, respectively `w = 0`.
    has_zero_z: bool,
    has_zero_w: bool,
}

impl PairSigns {
    fn is_violated(&self) -> bool {
        self.w_negative || self.z_positive && self.w_positive
    }
}

fn visit<T: Int>(rows: &[Vec<T>], case: Case, limit: usize, cases: &mut Cases) -> Result<(), Overflow> {
    if cases.visited >= limit {
        cases.is_complete = false;
        return Ok(());
    }
    cases.visited += 1;
    let generators = generators(rows, &case)?;
    if !generators.iter().any(|generator| generator[0].sign().is_gt()) {
        cases.excluded.push([case.zero_z, case.zero_w]);
        return Ok(());
    }
    let signs = (0..rows.len()).map(|pair| pair_signs(rows, &generators, pair)).collect::<Result<Vec<_>, _>>()?;
    let choices = |pair: &usize| usize::from(signs[*pair].has_zero_z) + usize::from(signs[*pair].has_zero_w);
    let Some(pair) = (0..rows.len()).filter(|pair| signs[*pair].is_violated()).min_by_key(choices) else {
        cases.pieces.push(piece(&signs, &generators));
        return Ok(());
    };
    let sign = signs[pair];
    if !sign.z_positive {
        // z is zero on all of it: nothing to decide, the condition w ≥ 0 is missing
        let mut bounded = case;
        bounded.bounded_w.push(pair);
        return visit(rows, bounded, limit, cases);
    }
    let mut with_zero_w = case.clone();
    with_zero_w.zero_w.push(pair);
    let mut with_zero_z = case;
    with_zero_z.zero_z.push(pair);
    with_zero_z.bounded_w.push(pair);
    for (case, has_any) in [(with_zero_z, sign.has_zero_z), (with_zero_w, sign.has_zero_w)] {
        if has_any {
            visit(rows, case, limit, cases)?;
        } else {
            cases.excluded.push([case.zero_z, case.zero_w]);
        }
    }
    Ok(())
}

/// Vertices and rays of a case, as rows `(t, t z')`.
fn generators<T: Int>(rows: &[Vec<T>], case: &Case) -> Result<Vec<Vec<T>>, Overflow> {
    let n = rows.len();
    // variables that are zero are left out
    let kept: Vec<usize> = std::iter::once(0).chain((1..=n).filter(|at| !case.zero_z.contains(&(at - 1)))).collect();
    let restricted = |row: usize| -> Vec<T> { kept.iter().map(|at| rows[row][*at].clone()).collect() };
    let mut equalities = Matrix::new(kept.len());
    case.zero_w.iter().for_each(|row| equalities.push(&restricted(*row)));
    let mut normals = Matrix::new(kept.len());
    for row in Matrix::identity(kept.len()).rows() {
        normals.push_negated(row);
    }
    for row in case.bounded_w.iter().filter(|row| !case.zero_w.contains(row)) {
        normals.push_negated(&restricted(*row));
    }
    let pair = Pair::from_normals(&equalities, &normals)?;
    let expand = |ray: &[T]| {
        let mut full = vec![T::default(); n + 1];
        kept.iter().zip(ray).for_each(|(at, value)| full[*at] = value.clone());
        full
    };
    Ok(pair.rays().rows().map(expand).collect())
}

fn pair_signs<T: Int>(rows: &[Vec<T>], generators: &[Vec<T>], pair: usize) -> Result<PairSigns, Overflow> {
    let mut signs = PairSigns::default();
    // of the points, and of all generators with z = 0
    let (mut points, mut zero_z_points) = ([false; 3], [false; 3]);
    let mut zero_z_grows = false;
    for generator in generators {
        let w = T::wide_sign(&T::dot(&rows[pair], generator)?);
        let is_zero_z = generator[pair + 1].sign().is_eq();
        signs.z_positive |= !is_zero_z;
        signs.w_positive |= w.is_gt();
        signs.w_negative |= w.is_lt();
        zero_z_grows |= is_zero_z && w.is_gt();
        if generator[0].sign().is_gt() {
            points[index(w)] = true;
            zero_z_points[index(w)] |= is_zero_z;
        }
    }
    let [negative, zero, positive] = zero_z_points;
    signs.has_zero_z = zero || positive || negative && zero_z_grows;
    let [negative, zero, positive] = points;
    signs.has_zero_w = zero || positive && signs.w_negative || negative && signs.w_positive;
    Ok(signs)
}

fn index(sign: Ordering) -> usize {
    match sign {
        Ordering::Less => 0,
        Ordering::Equal => 1,
        Ordering::Greater => 2,
    }
}

fn piece<T: Int>(signs: &[PairSigns], generators: &[Vec<T>]) -> Choice {
    let zeros = |is_zero: &dyn Fn(&PairSigns) -> bool| (0..signs.len()).filter(|pair| is_zero(&signs[*pair])).collect();
    Choice {
        zeros: [zeros(&|sign| !sign.z_positive), zeros(&|sign| !sign.w_positive)],
        generators: generators.iter().map(|row| row.iter().map(T::to_z).collect()).collect(),
    }
}

/// Drops the sets within others: more zeros mean a subset.
fn keep_maximal(pieces: &mut Vec<Choice>) {
    let count = |piece: &Choice| piece.zeros[0].len() + piece.zeros[1].len();
    pieces.sort_by_key(count);
    let mut kept: Vec<Choice> = Vec::new();
    for piece in pieces.drain(..) {
        let is_within = |other: &Choice| {
            let subset = |side: usize| other.zeros[side].iter().all(|at| piece.zeros[side].binary_search(at).is_ok());
            subset(0) && subset(1)
        };
        if !kept.iter().any(is_within) {
            kept.push(piece);
        }
    }
    *pieces = kept;
}
