//! The double description method in doubles with a tolerance, for comparison only: no decision of the crate sees it.

use super::cone::Faces;
use crate::exact::{Q, Z, to_f64};

/// A ray of unit length, and the normals that it lies on.
struct Ray {
    entries: Vec<f64>,
    on: u64,
}

/// For each ray of `{x : normals · x ≤ 0}` the normals that it lies on within `tolerance`; `None` if the first normals
/// do not span the space.
pub(super) fn faces(normals: &[Vec<Z>], tolerance: f64) -> Option<Faces> {
    let normals: Vec<Vec<f64>> =
        normals.iter().map(|row| unit(row.iter().map(|z| to_f64(&Q::from(z.clone()))).collect())).collect();
    let dimension = normals.first()?.len();
    let mut rays = simplex(&normals[..dimension.min(normals.len())], tolerance)?;
    for (index, normal) in normals.iter().enumerate().skip(dimension) {
        let sides: Vec<f64> = rays.iter().map(|ray| dot(&ray.entries, normal)).collect();
        let mut fresh = Vec::new();
        for (inside, a) in sides.iter().zip(&rays).filter(|(side, _)| **side < -tolerance) {
            for (outside, b) in sides.iter().zip(&rays).filter(|(side, _)| **side > tolerance) {
                let common = a.on & b.on;
                let is_apart = rays.iter().filter(|ray| ray.on & common == common).count() > 2;
                if common.count_ones() as usize + 2 < dimension || is_apart {
                    continue;
                }
                let entries = a.entries.iter().zip(&b.entries).map(|(a, b)| outside * a - inside * b).collect();
                let entries = unit(entries);
                let on = lies_on(&entries, &normals[..=index], tolerance);
                fresh.push(Ray { entries, on });
            }
        }
        let mut kept: Vec<Ray> = Vec::new();
        for (side, mut ray) in sides.into_iter().zip(rays) {
            if side <= tolerance {
                ray.on |= u64::from(side.abs() <= tolerance) << index;
                kept.push(ray);
            }
        }
        kept.extend(fresh);
        rays = kept;
    }
    let mut faces: Faces = rays.iter().map(|ray| ray.on).collect();
    faces.sort_unstable();
    Some(faces)
}

/// The rays of a simplicial cone: solutions of as many equations, by elimination with partial pivots.
fn simplex(normals: &[Vec<f64>], tolerance: f64) -> Option<Vec<Ray>> {
    let size = normals.len();
    let mut rows: Vec<Vec<f64>> = normals
        .iter()
        .enumerate()
        .map(|(at, normal)| normal.iter().copied().chain((0..size).map(|k| f64::from(u8::from(k == at)))).collect())
        .collect();
    for column in 0..size {
        let pivot = (column..size).max_by(|a, b| rows[*a][column].abs().total_cmp(&rows[*b][column].abs()))?;
        rows.swap(column, pivot);
        let head = rows[column][column];
        if head.abs() <= tolerance {
            return None;
        }
        rows[column].iter_mut().for_each(|entry| *entry /= head);
        let row = rows[column].clone();
        for other in (0..size).filter(|other| *other != column) {
            let factor = rows[other][column];
            rows[other].iter_mut().zip(&row).for_each(|(entry, pivot)| *entry -= factor * pivot);
        }
    }
    let ray = |at: usize| {
        let entries = unit((0..size).map(|k| -rows[k][size + at]).collect());
        let all = (1_u64 << size) - 1;
        Ray { entries, on: all & !(1 << at) }
    };
    Some((0..size).map(ray).collect())
}

fn lies_on(ray: &[f64], normals: &[Vec<f64>], tolerance: f64) -> u64 {
    normals.iter().enumerate().fold(0, |set, (at, normal)| set | u64::from(dot(ray, normal).abs() <= tolerance) << at)
}

fn unit(row: Vec<f64>) -> Vec<f64> {
    let length = dot(&row, &row).sqrt();
    row.into_iter().map(|entry| entry / length).collect()
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
