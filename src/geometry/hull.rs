//! Convex hull of a polygon.

use super::polygon::Polygon;
use super::scaled;
use super::{cross, difference};
use crate::exact::{Q, Z};
use num_traits::Signed as _;

impl Polygon {
    /// Numbers of the vertices that are corners of the convex hull, counter-clockwise and ascending.
    ///
    /// Vertices inside a hull edge are dropped.
    #[must_use]
    pub fn hull(&self) -> Vec<usize> {
        let points = self.scaled().points;
        let mut by_x: Vec<usize> = (0..points.len()).collect();
        by_x.sort_by_key(|i| &points[*i]);
        let mut corners = half_hull(&points, by_x.iter().copied());
        corners.extend(half_hull(&points, by_x.iter().rev().copied()));
        // a simple counter-clockwise outline visits the corners in hull order
        corners.sort_unstable();
        corners
    }

    /// Whether `point` lies strictly inside the convex hull.
    #[must_use]
    pub fn hull_contains(&self, point: &[Q; 2]) -> bool {
        self.hull_contains_all(std::slice::from_ref(point))
    }

    /// Whether every one of `points` lies strictly inside the convex hull.
    #[must_use]
    pub fn hull_contains_all(&self, points: &[[Q; 2]]) -> bool {
        let hull = self.hull();
        (0..hull.len()).all(|i| {
            let (a, b) = (&self.vertices()[hull[i]], &self.vertices()[hull[(i + 1) % hull.len()]]);
            let along = difference(a, b);
            points.iter().all(|point| cross(&along, &difference(a, point)).is_positive())
        })
    }
}

/// Corners from the first to the last of `ordered`, without the last.
fn half_hull(points: &[[Z; 2]], ordered: impl Iterator<Item = usize>) -> Vec<usize> {
    let mut chain: Vec<usize> = Vec::new();
    for next in ordered {
        while let [.., a, b] = chain[..]
            && !scaled::turn(&points[a], &points[b], &points[next]).is_positive()
        {
            chain.pop();
        }
        chain.push(next);
    }
    chain.pop();
    chain
}
