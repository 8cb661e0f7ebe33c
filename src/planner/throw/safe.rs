//! Where to start a part so that it is never lost: a part of some ranges that the throw map takes into itself.

use super::proof::Cell;
use super::system::System;
use crate::mechanics::throwing::BranchEnd;
use std::collections::BTreeMap;

/// First cells over a part radius.
const FIRST: f64 = 64.0;
/// Cells over a part radius that are cut no more.
const LAST: f64 = 1_024.0;
/// Cells at most.
const MOST_CELLS: usize = 100_000;

/// Cells, sorted, whose images are all inside of them: cells of the ranges whose images may leave are cut, or dropped, until
/// none is left. `None` if it was stopped.
pub(super) fn cells(
    system: &System,
    ranges: &BTreeMap<usize, [f64; 2]>,
    images: &mut usize,
    watch: &mut dyn FnMut(usize, usize) -> bool,
) -> Option<Vec<Cell>> {
    let mut cells = Vec::new();
    for (&edge, &[low, high]) in ranges {
        let count = ((high - low) / system.part_radius * FIRST).ceil().clamp(1.0, MOST_CELLS as f64);
        let place = |k: f64| if k >= count { high } else { low + (high - low) * k / count };
        for k in 0..count as usize {
            if !watch(cells.len(), MOST_CELLS) {
                return None;
            }
            cells.push(Cell::new(system, edge, [place(k as f64), place(k as f64 + 1.0)]));
        }
        *images += count as usize;
    }
    loop {
        let kept = merged(&cells);
        let mut next = Vec::with_capacity(cells.len());
        let mut has_changed = false;
        for cell in cells {
            if cell.branches.iter().all(|branch| is_covered(&branch.end, &kept)) {
                next.push(cell);
                continue;
            }
            has_changed = true;
            // where all of it leaves, halves do so, too
            let may_stay = cell.branches.iter().any(|branch| meets(&branch.end, &kept));
            if may_stay && cell.width() > system.part_radius / LAST && next.len() < MOST_CELLS {
                *images += 2;
                next.extend(cell.halves().map(|radii| Cell::new(system, cell.edge, radii)));
            }
        }
        cells = next;
        if !has_changed {
            return Some(cells);
        }
        if !watch(cells.len(), MOST_CELLS) {
            return None;
        }
    }
}

/// The radii of the cells on each edge.
pub(super) fn merged<'c>(cells: impl IntoIterator<Item = &'c Cell>) -> BTreeMap<usize, Vec<[f64; 2]>> {
    let mut merged: BTreeMap<usize, Vec<[f64; 2]>> = BTreeMap::new();
    for cell in cells {
        let radii = merged.entry(cell.edge).or_default();
        match radii.last_mut() {
            Some(last) if last[1] == cell.radii[0] => last[1] = cell.radii[1],
            _ => radii.push(cell.radii),
        }
    }
    merged
}

/// Whether a landing is inside of the radii.
pub(super) fn is_covered(end: &BranchEnd, radii: &BTreeMap<usize, Vec<[f64; 2]>>) -> bool {
    let BranchEnd::Rest { edge, radii: landing, .. } = end else { return false };
    let [low, high] = landing.ends();
    radii.get(edge).is_some_and(|ranges| {
        let first = ranges.partition_point(|range| range[1] < high);
        ranges.get(first).is_some_and(|[from, to]| *from <= low && high <= *to)
    })
}

/// Whether a landing may be inside.
fn meets(end: &BranchEnd, radii: &BTreeMap<usize, Vec<[f64; 2]>>) -> bool {
    let BranchEnd::Rest { edge, radii: landing, .. } = end else { return false };
    let [low, high] = landing.ends();
    radii.get(edge).is_some_and(|ranges| {
        let first = ranges.partition_point(|range| range[1] < low);
        ranges.get(first).is_some_and(|[from, _]| *from <= high)
    })
}
