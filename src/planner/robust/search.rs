//! Best-first branch and bound over all directions.

use super::frame::{dot, normalized};
use super::hole::Hole;
use crate::answer::Robust;
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// Of [`Robust::TOLERANCE`], the part that the search leaves between its best direction and its bound.
const GAP: f64 = 0.5 * Robust::TOLERANCE;

/// From here on the search ends with a wider gap.
const MOST_CELLS: usize = 200_000;

/// What the operations of a bound on a cell may round, with much to spare.
const ERROR: f64 = 1e-13;

/// The best direction met and what is known of it.
pub(super) struct Found {
    /// A unit vector.
    pub(super) direction: [f64; 3],
    /// About its distance from the nearest hole.
    pub(super) radius: f64,
    /// No unit vector is farther than this from the nearest hole.
    pub(super) upper: f64,
}

/// The directions through a square on one of the cube's facets: its corners, which doubles hold exactly.
struct Square {
    axis: usize,
    side: f64,
    low: [f64; 2],
    size: f64,
}

/// A square, an upper bound on the radius in it, and the holes that may be the nearest there.
struct Cell {
    square: Square,
    bound: f64,
    near: Vec<usize>,
}

/// Finds a direction about as far as possible from the nearest hole; `seeds` are unit vectors to begin with.
pub(super) fn search(holes: &[Hole], seeds: &[[f64; 3]]) -> Found {
    let mut found = Found { direction: [1.0, 0.0, 0.0], radius: -1.0, upper: 0.0 };
    for seed in seeds {
        let radius = holes.iter().map(|hole| hole.distance_at_most(seed)).fold(1.0, f64::min);
        found.offer(*seed, radius);
    }
    let everywhere: Vec<usize> = (0..holes.len()).collect();
    let mut open = BinaryHeap::new();
    let keep = |square: Square, near: &[usize], found: &mut Found, open: &mut BinaryHeap<Cell>| {
        let cell = square.bounded(holes, near, found);
        if cell.bound > found.radius + GAP {
            open.push(cell);
        } else {
            found.upper = found.upper.max(cell.bound);
        }
    };
    for axis in 0..3 {
        for side in [1.0, -1.0] {
            keep(Square { axis, side, low: [-1.0, -1.0], size: 2.0 }, &everywhere, &mut found, &mut open);
        }
    }
    let mut cells = 0;
    while let Some(cell) = open.pop() {
        cells += 4;
        if cell.bound <= found.radius + GAP || cells > MOST_CELLS {
            found.upper = found.upper.max(cell.bound);
            break;
        }
        for quarter in cell.square.quarters() {
            keep(quarter, &cell.near, &mut found, &mut open);
        }
    }
    found
}

impl Found {
    fn offer(&mut self, direction: [f64; 3], radius: f64) {
        if radius > self.radius {
            (self.direction, self.radius) = (direction, radius);
        }
    }
}

impl Square {
    fn point(&self, at: [f64; 2]) -> [f64; 3] {
        let mut point = [self.side; 3];
        point[(self.axis + 1) % 3] = self.low[0] + at[0] * self.size;
        point[(self.axis + 2) % 3] = self.low[1] + at[1] * self.size;
        point
    }

    fn quarters(&self) -> [Self; 4] {
        let size = self.size / 2.0;
        let [s, t] = self.low;
        let quarter = |low| Self { axis: self.axis, side: self.side, low, size };
        [quarter([s, t]), quarter([s + size, t]), quarter([s, t + size]), quarter([s + size, t + size])]
    }

    /// Bounds the radius in the square, and offers its corners.
    ///
    /// The distance from a convex cone is convex and homogeneous. With corners c_i and g = Σ λ_i c_i in the square,
    /// λ_i ≥ 0, a mean Σ μ_h d_h of the distances from some holes is at most max_i (Σ μ_h d_h(c_i) / |c_i|) Σ λ_i |c_i|,
    /// and Σ λ_i |c_i| ≤ |g| / cos θ with θ the largest angle between a corner and the middle of the square. The least
    /// distance is at most any mean, so means of one hole or two that are smallest at their largest corner give a bound
    /// whose error is of second order unless three holes meet.
    fn bounded(self, holes: &[Hole], near: &[usize], found: &mut Found) -> Cell {
        let middle = normalized(self.point([0.5, 0.5]));
        let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]].map(|at| normalized(self.point(at)));
        let far: Vec<[f64; 4]> =
            near.iter().map(|hole| corners.each_ref().map(|corner| holes[*hole].distance_at_most(corner))).collect();
        for (at, corner) in corners.iter().enumerate() {
            found.offer(*corner, far.iter().map(|far| far[at]).fold(1.0, f64::min));
        }
        let cos = corners.iter().map(|corner| dot(corner, &middle)).fold(1.0, f64::min);
        let bound = (least_mean(&far) / cos * (1.0 + ERROR) + ERROR).min(1.0);
        // no corner is farther than 2 tan θ from any direction in the square
        let width = 2.0 * (1.0 - cos * cos).sqrt() / cos;
        let may_be_nearest = |far: &[f64; 4]| far.iter().fold(1.0, |least: f64, d| least.min(*d)) - width <= bound;
        let near = near.iter().zip(&far).filter(|(_, far)| may_be_nearest(far)).map(|(hole, _)| *hole).collect();
        Cell { square: self, bound, near }
    }
}

/// The least, over means of one row or two, of the largest entry.
fn least_mean(rows: &[[f64; 4]]) -> f64 {
    let most = |row: &[f64; 4]| row.iter().fold(0.0, |most: f64, value| most.max(*value));
    let mut least = rows.iter().map(most).fold(1.0, f64::min);
    for (at, a) in rows.iter().enumerate() {
        for b in &rows[..at] {
            // no mean is below the lesser of the two at every corner
            if a.iter().zip(b).all(|(a, b)| a.min(*b) < least) {
                least = least.min(least_of_two(a, b));
            }
        }
    }
    least
}

/// The least, over means of the two rows, of the largest entry: where two entries that move apart are equal.
fn least_of_two(a: &[f64; 4], b: &[f64; 4]) -> f64 {
    let at = |share: f64| (0..4).map(|i| b[i] + share * (a[i] - b[i])).fold(0.0, f64::max);
    let mut least: f64 = 1.0;
    for i in 0..4 {
        for j in 0..i {
            let (slope_i, slope_j) = (a[i] - b[i], a[j] - b[j]);
            let share = (b[j] - b[i]) / (slope_i - slope_j);
            if slope_i * slope_j < 0.0 && (0.0..=1.0).contains(&share) {
                least = least.min(at(share));
            }
        }
    }
    least
}

impl Ord for Cell {
    fn cmp(&self, other: &Self) -> Ordering {
        self.bound.total_cmp(&other.bound)
    }
}

impl PartialOrd for Cell {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Cell {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Cell {}
