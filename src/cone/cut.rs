//! Generators of `{x : E x = 0, H x ≤ 0}` by cutting one half-space after the other (double description).

use super::bits::{BitRows, count, is_subset};
use super::linear::{cross, dot_sign, is_zero};
use crate::exact::{Entries, Int, Matrix, Overflow};
use smallvec::SmallVec;
use std::cmp::Ordering;

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

/// Clips a three-dimensional cone (modulo lines) whose rays are in cyclic order.
fn clip<T: Int>(
    rays: Matrix<T>,
    normals: &Matrix<T>,
    rows: impl Iterator<Item = usize>,
) -> Result<Result<Matrix<T>, usize>, Overflow> {
    let mut ring = rays;
    let mut clipped = Matrix::with_capacity(normals.columns(), ring.len() + 1);
    let mut products = Vec::with_capacity(ring.len());
    for row in rows {
        let normal = normals.row(row);
        products.clear();
        for ray in ring.rows() {
            products.push(T::dot(normal, ray)?);
        }
        if !products.iter().any(|p| T::wide_sign(p).is_gt()) {
            continue;
        }
        if !products.iter().any(|p| T::wide_sign(p).is_lt()) {
            return Ok(Err(row));
        }
        clipped.clear();
        for (index, product) in products.iter().enumerate() {
            let next = (index + 1) % products.len();
            let (here, there) = (T::wide_sign(product), T::wide_sign(&products[next]));
            if here.is_le() {
                clipped.push(ring.row(index));
            }
            if here.is_lt() && there.is_gt() {
                crossing(&ring, index, product, next, &products[next], &mut clipped)?;
            } else if here.is_gt() && there.is_lt() {
                crossing(&ring, next, &products[next], index, product, &mut clipped)?;
            }
        }
        std::mem::swap(&mut ring, &mut clipped);
    }
    Ok(Ok(ring))
}

/// Appends the ray between ray `inside` (negative product) and ray `outside` (positive product) on the hyperplane.
fn crossing<T: Int>(
    rays: &Matrix<T>,
    inside: usize,
    depth: &T::Wide,
    outside: usize,
    height: &T::Wide,
    out: &mut Matrix<T>,
) -> Result<(), Overflow> {
    let (inside, outside) = (rays.row(inside), rays.row(outside));
    out.push_with(|entries| T::combine(height, inside, &T::wide_negated(depth), outside, entries))
}

/// The double description method in any dimension, from the simplicial cone of the rows `basis`.
fn describe<T: Int>(
    rays: Matrix<T>,
    normals: &Matrix<T>,
    basis: &[usize],
    rows: impl Iterator<Item = usize>,
) -> Result<Result<Matrix<T>, usize>, Overflow> {
    let common_needed = basis.len().saturating_sub(2);
    let mut rays = rays;
    let mut on = BitRows::new(normals.len());
    for own in 0..basis.len() {
        on.push(normals.len(), |row| basis.contains(&row) && basis[own] != row);
    }
    for row in rows {
        let normal = normals.row(row);
        let products = rays.rows().map(|ray| T::dot(normal, ray)).collect::<Result<Vec<_>, _>>()?;
        let products = &products;
        let with_sign = |sign: Ordering| (0..products.len()).filter(move |r| T::wide_sign(&products[*r]) == sign);
        if with_sign(Ordering::Greater).next().is_none() {
            with_sign(Ordering::Equal).for_each(|ray| on.insert(ray, row));
            continue;
        }
        if with_sign(Ordering::Less).next().is_none() {
            return Ok(Err(row));
        }
        let mut next_rays = Matrix::new(normal.len());
        let mut next_on = BitRows::new(normals.len());
        for ray in (0..products.len()).filter(|ray| T::wide_sign(&products[*ray]).is_le()) {
            next_rays.push(rays.row(ray));
            next_on.push_words(on.row(ray).iter().copied());
            if T::wide_sign(&products[ray]).is_eq() {
                next_on.insert(next_rays.len() - 1, row);
            }
        }
        let outside: Vec<usize> = with_sign(Ordering::Greater).collect();
        let mut common = vec![0_u64; on.row(0).len()];
        for inside in with_sign(Ordering::Less) {
            for outside in outside.iter().copied() {
                for (word, (a, b)) in common.iter_mut().zip(on.row(inside).iter().zip(on.row(outside))) {
                    *word = a & b;
                }
                if count(&common) < common_needed || !are_adjacent(&on, inside, outside, &common) {
                    continue;
                }
                crossing(&rays, inside, &products[inside], outside, &products[outside], &mut next_rays)?;
                next_on.push_words(common.iter().copied());
                next_on.insert(next_rays.len() - 1, row);
            }
        }
        (rays, on) = (next_rays, next_on);
    }
    Ok(Ok(rays))
}

fn are_adjacent(on: &BitRows, a: usize, b: usize, common: &[u64]) -> bool {
    !on.rows().enumerate().any(|(ray, set)| ray != a && ray != b && is_subset(common, set))
}
