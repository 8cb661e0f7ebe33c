//! The double description method in any dimension.

use super::bits::{BitRows, count, is_subset};
use super::linear::crossing;
use crate::exact::{Int, Matrix, Overflow};
use std::cmp::Ordering;

/// The double description method in any dimension, from the simplicial cone of the rows `basis`.
pub(super) fn describe<T: Int>(
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
