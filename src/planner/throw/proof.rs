//! A proof by interval arithmetic: the throw map takes a set Z into itself, and all that recurs there is in some bands.
//!
//! Z is cut into cells, and an arrow leads from a cell to every one that its image may meet. The cells that an orbit visits
//! again and again are strongly connected, whether the map is continuous or not. A cell whose throws all jog outward may
//! meet itself without being recurrent: no orbit stays there.

use super::graph::components;
use super::reach::widen;
use super::safe;
use super::system::System;
use crate::answer::{Certificate, Component, CounterExample, EdgeReach, ProofLimit, Reach};
use crate::exact::FloatInterval;
use crate::mechanics::throwing::{Branch, BranchEnd, Branches, Elsewhere};
use std::collections::BTreeMap;

/// First cells over a part radius.
const FIRST: f64 = 64.0;
/// Cells over a part radius at which bands are told, unless something else is asked for.
pub(super) const RESOLUTION: f64 = 1_024.0;
/// Narrowest cell, in part radii.
const NARROWEST: f64 = 1e-9;
/// Cells at most.
const MOST_CELLS: usize = 200_000;
/// Z starts so far above the radius at which the part reaches over the pivot, in part radii: a fixed point is there. The
/// smaller ones are for throws that land nearer.
const ABOVE_CLEAR: [f64; 4] = [2e-2, 4e-3, 8e-4, 1.6e-4];
/// And ends so far above the landings, in part radii.
const ABOVE_LANDINGS: f64 = 0.004;

/// Tries to prove, refining cells until one component is left with `resolution` cells over a part radius, or a limit is
/// reached; `watch` is told cells and says whether
/// to go on. Where throws lead out of Z, the same is tried for a part of Z, or of all radii, that they do not lead out of.
pub(super) fn certify(
    system: &System,
    reach: &Reach,
    resolution: f64,
    watch: &mut dyn FnMut(usize, usize) -> bool,
) -> Certificate {
    let mut certificate = Certificate::default();
    for above_clear in ABOVE_CLEAR {
        certificate = certify_from(system, reach, above_clear, resolution, watch);
        let is_near = |example: &CounterExample| {
            let (edge, [_, high]) = example.landing?;
            Some(!example.leaves_domain && high < certificate.z.get(&edge)?[0])
        };
        if certificate.counterexample.as_ref().and_then(is_near) != Some(true) {
            break;
        }
    }
    if certificate.is_invariant || certificate.limit == Some(ProofLimit::Stopped) {
        return certificate;
    }
    let all: Vec<EdgeReach> =
        reach.edges.iter().map(|edge| EdgeReach { r_max: reach.scan_to, ..edge.clone() }).collect();
    for ranges in [certificate.z.clone(), domain(system, &all, ABOVE_CLEAR[1])] {
        let Some(cells) = safe::cells(system, &ranges, &mut certificate.images, watch) else {
            certificate.limit = Some(ProofLimit::Stopped);
            break;
        };
        if cells.is_empty() {
            continue;
        }
        let starts = safe::merged(&cells);
        let mut found = Certificate { starts, ..certificate.clone() };
        refine(system, cells, resolution, &mut found, watch);
        if found.is_unique {
            return found;
        }
    }
    certificate
}

fn certify_from(
    system: &System,
    reach: &Reach,
    above_clear: f64,
    resolution: f64,
    watch: &mut dyn FnMut(usize, usize) -> bool,
) -> Certificate {
    let z = ranges(system, reach, above_clear);
    let mut certificate = Certificate { z: z.clone(), ..Certificate::default() };
    if z.is_empty() {
        certificate.limit = Some(ProofLimit::Resolution);
        return certificate;
    }
    match invariant(system, &z, &mut certificate, watch) {
        Ok(cells) => {
            certificate.is_invariant = true;
            certificate.starts = z.into_iter().map(|(edge, range)| (edge, vec![range])).collect();
            refine(system, cells, resolution, &mut certificate, watch);
        }
        Err(limit) => certificate.limit = limit,
    }
    certificate
}

/// Cuts cells that the map takes into each other until one recurrent component is left, or a limit is reached.
fn refine(
    system: &System,
    mut cells: Vec<Cell>,
    resolution: f64,
    certificate: &mut Certificate,
    watch: &mut dyn FnMut(usize, usize) -> bool,
) {
    loop {
        let arrows = arrows(&cells);
        let found = components(&arrows);
        certificate.cells = cells.len();
        certificate.width = cells.iter().map(Cell::width).fold(f64::INFINITY, f64::min);
        certificate.components = found.iter().map(|component| describe(&cells, component)).collect();
        let kept: Vec<usize> = found.into_iter().flatten().collect();
        let widest = kept.iter().map(|cell| cells[*cell].width()).fold(0.0, f64::max);
        let is_fine = widest <= system.part_radius / resolution;
        certificate.is_unique = certificate.components.len() == 1;
        let is_at_end = certificate.width <= NARROWEST * system.part_radius || 2 * kept.len() > MOST_CELLS;
        // orbits that come to two of them stay apart
        let n_terminal = certificate.components.iter().filter(|component| component.is_terminal).count();
        if (certificate.is_unique && is_fine) || kept.is_empty() || n_terminal > 1 || is_at_end {
            if !certificate.is_unique {
                certificate.limit = Some(ProofLimit::Resolution);
            }
            break;
        }
        if !watch(kept.len(), MOST_CELLS) {
            certificate.limit = Some(ProofLimit::Stopped);
            break;
        }
        // with one component only wide cells are cut, else all
        let is_cut = |cell: &Cell| is_fine || cell.width() > 0.5 * widest;
        let mut next: Vec<Cell> = Vec::with_capacity(2 * kept.len());
        let mut old: Vec<Option<Cell>> = cells.into_iter().map(Some).collect();
        for place in kept {
            let Some(cell) = old[place].take() else { continue };
            if is_cut(&cell) {
                certificate.images += 2;
                next.extend(cell.halves().map(|radii| Cell::new(system, cell.edge, radii)));
            } else {
                next.push(cell);
            }
        }
        next.sort_by(|a, b| a.edge.cmp(&b.edge).then(a.radii[0].total_cmp(&b.radii[0])));
        cells = next;
    }
    certificate.beyond = beyond(certificate);
}

/// Radii of one edge with all that throws from there may do.
pub(super) struct Cell {
    pub(super) edge: usize,
    pub(super) radii: [f64; 2],
    pub(super) branches: Branches,
}

impl Cell {
    pub(super) fn new(system: &System, edge: usize, radii: [f64; 2]) -> Self {
        Self { edge, radii, branches: system.branches(edge, FloatInterval::from_ends(radii[0], radii[1])) }
    }

    pub(super) fn width(&self) -> f64 {
        self.radii[1] - self.radii[0]
    }

    pub(super) fn halves(&self) -> [[f64; 2]; 2] {
        let [low, high] = self.radii;
        let middle = 0.5 * (low + high);
        [[low, middle], [middle, high]]
    }
}

/// The ranges of the paper, a little away from where they end, and wider again for throws from what was added.
fn ranges(system: &System, reach: &Reach, above_clear: f64) -> BTreeMap<usize, [f64; 2]> {
    let slack = ABOVE_LANDINGS * system.part_radius;
    let mut edges = reach.edges.clone();
    edges.iter_mut().for_each(|edge| edge.r_max += slack);
    widen(system, &mut edges, reach.scan_to, slack);
    domain(system, &edges, above_clear)
}

/// From where throws are possible, a little away from where the part reaches over the pivot, up to `r_max`.
fn domain(system: &System, edges: &[EdgeReach], above_clear: f64) -> BTreeMap<usize, [f64; 2]> {
    let range = |edge: &EdgeReach| {
        let [grasp, clear] = system.lows(edge.edge)?;
        let low = grasp.max(clear + above_clear * system.part_radius);
        Some((edge.edge, [low, edge.r_max])).filter(|_| low < edge.r_max && low <= system.far())
    };
    edges.iter().filter_map(range).collect()
}

/// Cuts Z into cells whose images are all inside.
fn invariant(
    system: &System,
    z: &BTreeMap<usize, [f64; 2]>,
    certificate: &mut Certificate,
    watch: &mut dyn FnMut(usize, usize) -> bool,
) -> Result<Vec<Cell>, Option<ProofLimit>> {
    let mut cells = Vec::new();
    let mut is_resolved = true;
    for (&edge, &[low, high]) in z {
        let count = ((high - low) / system.part_radius * FIRST).ceil().max(1.0);
        let place = |k: f64| if k >= count { high } else { low + (high - low) * k / count };
        let mut open: Vec<[f64; 2]> =
            (0..count as usize).rev().map(|k| [place(k as f64), place(k as f64 + 1.0)]).collect();
        while let Some(radii) = open.pop() {
            if !watch(cells.len(), MOST_CELLS) {
                return Err(Some(ProofLimit::Stopped));
            }
            certificate.images += 1;
            let cell = Cell::new(system, edge, radii);
            if cell.branches.iter().all(|branch| is_inside(branch, z)) {
                cells.push(cell);
            } else if let Some(example) = counter_example(system, &cell, z) {
                certificate.counterexample = Some(example);
                return Err(None);
            } else if cell.width() <= NARROWEST * system.part_radius || cells.len() + open.len() > MOST_CELLS {
                is_resolved = false;
            } else {
                let [left, right] = cell.halves();
                open.extend([right, left]);
            }
        }
    }
    if is_resolved { Ok(cells) } else { Err(Some(ProofLimit::Resolution)) }
}

fn is_inside(branch: &Branch, z: &BTreeMap<usize, [f64; 2]>) -> bool {
    let BranchEnd::Rest { edge, radii, .. } = branch.end else { return false };
    let [low, high] = radii.ends();
    z.get(&edge).is_some_and(|[from, to]| *from <= low && high <= *to)
}

/// The cell, if all of it lands outside in one way.
fn counter_example(system: &System, cell: &Cell, z: &BTreeMap<usize, [f64; 2]>) -> Option<CounterExample> {
    let [Branch { end, .. }] = cell.branches[..] else { return None };
    let (landing, leaves_domain) = match end {
        BranchEnd::Rest { edge, radii, .. } => {
            let [low, high] = radii.ends();
            if z.get(&edge).is_some_and(|[from, to]| high >= *from && low <= *to) {
                return None;
            }
            (Some((edge, [low, high])), system.surely_below(edge, high))
        }
        BranchEnd::Other(Elsewhere::OffArm) => (None, true),
        BranchEnd::Other(_) => return None,
    };
    Some(CounterExample { edge: cell.edge, radii: cell.radii, landing, leaves_domain })
}

/// For each cell those that its image may meet; the cells are sorted by edge and radius.
fn arrows(cells: &[Cell]) -> Vec<Vec<usize>> {
    let arrows_of = |(place, cell): (usize, &Cell)| {
        let mut to = Vec::new();
        for branch in &cell.branches {
            let BranchEnd::Rest { edge, steps, radii, moved } = branch.end else { continue };
            let [low, high] = radii.ends();
            let first = cells.partition_point(|other| (other.edge, other.radii[1]) < (edge, low));
            let met = cells[first..].iter().take_while(|other| other.edge == edge && other.radii[0] <= high);
            let leaves = edge == cell.edge && steps == 0 && moved.ends()[0] > 0.0;
            to.extend((first..).zip(met).map(|(other, _)| other).filter(|other| !(leaves && *other == place)));
        }
        to.sort_unstable();
        to.dedup();
        to
    };
    cells.iter().enumerate().map(arrows_of).collect()
}

fn describe(cells: &[Cell], component: &[usize]) -> Component {
    let mut places = component.to_vec();
    places.sort_unstable();
    let own = || places.iter().map(|place| &cells[*place]);
    let bands = safe::merged(own());
    // cells that were dropped on the way are outside, too
    let is_terminal = own().all(|cell| cell.branches.iter().all(|branch| safe::is_covered(&branch.end, &bands)));
    Component { cells: places.len(), is_terminal, bands }
}

/// The edge with the farthest band, and the end of all others.
fn beyond(certificate: &Certificate) -> Option<(usize, f64)> {
    let [component] = &certificate.components[..] else { return None };
    let mut ends: Vec<(f64, usize)> =
        component.bands.iter().filter_map(|(edge, bands)| Some((bands.last()?[1], *edge))).collect();
    ends.sort_by(|a, b| b.0.total_cmp(&a.0));
    match ends[..] {
        [(_, edge)] => Some((edge, component.bands[&edge][0][0])),
        [(most, edge), (others, _), ..] if most > others => Some((edge, others)),
        _ => None,
    }
}
