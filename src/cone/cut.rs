//! Generators of `{x : E x = 0, H x ≤ 0}` by cutting one half-space after the other (double description).

use super::clip::clip;
use super::describe::describe;
use super::linear::{cross, dot_sign, is_zero};
use crate::exact::{Entries, Int, Matrix, Overflow};
use smallvec::SmallVec;

/// Lines and extreme rays, not yet in canonical form.
pub(super) struct Cut<T> {
    pub(super) lines: Matrix<T>,
    pub(super) rays: Matrix<T>,
}

/// Cuts the space by all equalities and normals.
///
/// Lines absorb the first independent normals and leave a simplicial cone of dimension `r` (modulo lines). For `r = 3`
/// its rays form a cycle that each further normal clips, without any adjacency test; otherwise two rays are adjacent
/// iff no third lies on all normals that both lie on.
///
/// # Cost
/// `r = 3`: O(m k) for m normals and k rays. Otherwise O(m k³) words in the worst case, O(m k²) when few pairs survive
/// the count of common normals.
///
/// # Errors
/// [`Overflow`] if a primitive row does not fit `T`.
pub(super) fn cut_space<T: Int>(equalities: &Matrix<T>, normals: &Matrix<T>) -> Result<Cut<T>, Overflow> {
    let mut implied: Option<Matrix<T>> = None;
    loop {
        match attempt(implied.as_ref().unwrap_or(equalities), normals)? {
            Ok(cut) => return Ok(cut),
            Err(flat) => implied.get_or_insert_with(|| equalities.clone()).push(normals.row(flat)),
        }
    }
}

/// `Err(row)` if the cone turns out to lie in the hyperplane of normal `row`: the caller starts again with an equality.
fn attempt<T: Int>(equalities: &Matrix<T>, normals: &Matrix<T>) -> Result<Result<Cut<T>, usize>, Overflow> {
    let Start { lines, rays, basis } = match three_planes(equalities, normals)? {
        Some(start) => start,
        None => absorb_lines(equalities, normals)?,
    };
    let others = (0..normals.len()).filter(|row| !basis.contains(row));
    let rays = if basis.len() == 3 { clip(rays, normals, others)? } else { describe(rays, normals, &basis, others)? };
    Ok(rays.map(|rays| Cut { lines, rays }))
}

/// A simplicial cone (modulo lines) cut by the normals `basis`: ray `i` lies on all of them but the `i`-th.
struct Start<T> {
    lines: Matrix<T>,
    rays: Matrix<T>,
    basis: SmallVec<[usize; 8]>,
}

/// Starts from the whole space; each normal not constant on the lines left turns one line into a ray.
fn absorb_lines<T: Int>(equalities: &Matrix<T>, normals: &Matrix<T>) -> Result<Start<T>, Overflow> {
    let dim = normals.columns();
    let mut lines = Matrix::identity(dim);
    let mut scratch = Entries::new();
    for equality in equalities.rows() {
        absorb(&mut lines, equality, &mut scratch)?;
    }
    let mut rays = Matrix::with_capacity(dim, lines.len());
    let mut basis = SmallVec::new();
    for (row, normal) in normals.rows().enumerate() {
        if lines.is_empty() {
            break;
        }
        if let Some(inside) = absorb(&mut lines, normal, &mut scratch)? {
            flatten(&mut rays, &inside, normal, &mut scratch)?;
            rays.push(&inside);
            basis.push(row);
        }
    }
    Ok(Start { lines, rays, basis })
}

/// The same start for three dimensions without equalities: the rays of three independent planes are cross products.
fn three_planes<T: Int>(equalities: &Matrix<T>, normals: &Matrix<T>) -> Result<Option<Start<T>>, Overflow> {
    if normals.columns() != 3 || !equalities.is_empty() || normals.len() < 3 {
        return Ok(None);
    }
    let first = normals.row(0);
    let mut edge = Entries::new();
    let Some(second) = (1..normals.len()).find_map(|row| match cross(first, normals.row(row), &mut edge) {
        Ok(()) if is_zero(&edge) => None,
        outcome => Some(outcome.map(|()| row)),
    }) else {
        return Ok(None);
    };
    let second = second?;
    for third in second + 1..normals.len() {
        let side = dot_sign(normals.row(third), &edge)?;
        if side.is_eq() {
            continue;
        }
        let mut rays = Matrix::with_capacity(3, 4);
        for (a, b) in [(second, third), (third, 0)] {
            let mut ray = Entries::new();
            cross(normals.row(a), normals.row(b), &mut ray)?;
            rays.push(&ray);
        }
        rays.push(&edge);
        // the determinant of the three normals has the sign of `side`
        if side.is_gt() {
            (0..3).for_each(|ray| rays.row_mut(ray).iter_mut().for_each(|value| *value = value.negated()));
        }
        return Ok(Some(Start { lines: Matrix::new(3), rays, basis: SmallVec::from_slice(&[0, second, third]) }));
    }
    Ok(None)
}

/// Takes a line off the hyperplane of `normal` out, moves the others onto it, and returns the one taken, pointing to the
/// side `normal · x < 0`; `None` if all lines are on the hyperplane.
fn absorb<T: Int>(
    lines: &mut Matrix<T>,
    normal: &[T],
    scratch: &mut Entries<T>,
) -> Result<Option<Entries<T>>, Overflow> {
    for index in 0..lines.len() {
        let side = T::wide_sign(&T::dot(normal, lines.row(index))?);
        if side.is_eq() {
            continue;
        }
        let mut inside = lines.swap_remove(index);
        if side.is_gt() {
            inside.iter_mut().for_each(|value| *value = value.negated());
        }
        flatten(lines, &inside, normal, scratch)?;
        return Ok(Some(inside));
    }
    Ok(None)
}

/// Moves each row along the line `inside` onto the hyperplane of `normal`.
fn flatten<T: Int>(rows: &mut Matrix<T>, inside: &[T], normal: &[T], scratch: &mut Entries<T>) -> Result<(), Overflow> {
    let depth = T::wide_negated(&T::dot(normal, inside)?);
    for index in 0..rows.len() {
        let product = T::dot(normal, rows.row(index))?;
        if T::wide_sign(&product).is_ne() {
            scratch.clear();
            T::combine(&depth, rows.row(index), &product, inside, scratch)?;
            rows.row_mut(index).clone_from_slice(scratch);
        }
    }
    Ok(())
}
