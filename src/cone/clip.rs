//! Cutting a cone of dimension three whose rays form a cycle.

use super::linear::crossing;
use crate::exact::{Int, Matrix, Overflow};

/// Clips a three-dimensional cone (modulo lines) whose rays are in cyclic order.
pub(super) fn clip<T: Int>(
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
