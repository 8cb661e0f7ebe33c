//! The approximated system of Theorem IV.6: a part slides outward on its edge up to `r_flip`, and flips there.

use super::pieces::inside;
use super::system::System;
use crate::answer::{EdgeReach, Hybrid, Slide};
use crate::mechanics::throwing::Thrown;

/// Flips in a row after which the part is given up.
const MOST_FLIPS: usize = 1_000;

/// Follows the flips from every edge, and finds the cycles.
pub(super) fn hybrid(system: &System, edges: &[EdgeReach]) -> Hybrid {
    let slides: Vec<Slide> = edges.iter().filter_map(|edge| slide(system, edges, edge)).collect();
    let next = |edge: usize| slides.iter().find(|slide| slide.edge == edge)?.next;
    let mut cycles: Vec<Vec<usize>> = Vec::new();
    for slide in &slides {
        // after as many slides as there are edges the part is in a cycle
        let mut at = Some(slide.edge);
        (0..slides.len()).for_each(|_| at = at.and_then(next));
        let Some(first) = at else { continue };
        let mut cycle = vec![first];
        let mut at = next(first);
        while let Some(edge) = at.filter(|edge| *edge != first) {
            cycle.push(edge);
            at = next(edge);
        }
        let least = (0..cycle.len()).min_by_key(|k| cycle[*k]).unwrap_or(0);
        cycle.rotate_left(least);
        if !cycles.contains(&cycle) {
            cycles.push(cycle);
        }
    }
    cycles.sort();
    Hybrid { slides, cycles }
}

/// The slide on an edge from which the part flips within the scan.
fn slide(system: &System, edges: &[EdgeReach], from: &EdgeReach) -> Option<Slide> {
    let r_flip = from.r_flip?;
    let lost = |flips: Vec<(usize, f64, i64)>| Some(Slide { edge: from.edge, flips, next: None });
    let piece = from.pieces.iter().find(|piece| piece.from >= r_flip)?;
    let (Some((edge, steps)), Some((_, radius, _))) = (piece.landing, inside(system, from.edge, piece, piece.from))
    else {
        return lost(Vec::new());
    };
    let mut flips = vec![(edge, radius, steps)];
    loop {
        let (edge, radius, _) = flips[flips.len() - 1];
        if flips.len() > MOST_FLIPS {
            return lost(flips);
        }
        let slides = edges.iter().find(|reach| reach.edge == edge).and_then(|reach| reach.r_flip);
        match slides {
            Some(r_flip) if radius < r_flip => return Some(Slide { edge: from.edge, flips, next: Some(edge) }),
            // as in the theorem, whether or not the next throw has a grasp
            _ => match system.throw((edge, radius)) {
                Thrown::Caught(catch) => flips.push((catch.edge, catch.radius, catch.steps)),
                _ => return lost(flips),
            },
        }
    }
}
