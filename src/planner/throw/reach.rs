//! The ranges of Proposition IV.4: from where throws jog, from where they flip, and what no throw lands beyond.

use super::pieces::{image, pieces};
use super::system::System;
use crate::answer::{EdgeReach, Piece, Reach};
use std::collections::BTreeMap;

/// Times that the ranges are widened.
const MOST_ROUNDS: usize = 200;

/// Finds the ranges, pieces of the map at first.
pub(super) fn reach(system: &System) -> Reach {
    let scan_to = system.scan_to();
    let mut problems = Vec::new();
    let mut edges: Vec<EdgeReach> = Vec::new();
    for &edge in &system.stable {
        let low = system.low(edge);
        let pieces = if low < scan_to { pieces(system, edge, low, scan_to) } else { Vec::new() };
        let jogs = pieces.iter().take_while(|piece| is_jog(edge, piece)).count();
        let r_flip = pieces.get(jogs).map(|piece| piece.from);
        if low >= scan_to {
            problems.push(format!("edge {edge}: its least radius lies beyond what was looked at"));
        } else if jogs == 0 {
            problems.push(format!("edge {edge}: a throw at its least radius is no jog"));
        } else if r_flip.is_none() {
            problems.push(format!("edge {edge}: no throw up to the end of the scan is a flip"));
        }
        edges.push(EdgeReach { edge, r_low: low, r_flip, r_max: r_flip.unwrap_or(low), lowest_image: None, pieces });
    }
    let mut is_inside = widen(system, &mut edges, scan_to, 0.0);
    for edge in &edges {
        if edge.lowest_image.is_some_and(|image| image < edge.r_low) {
            is_inside = false;
            problems.push(format!("edge {}: throws from the ranges land below its least radius", edge.edge));
        }
        if edge.r_max > scan_to {
            is_inside = false;
            problems.push(format!("edge {}: throws land beyond what was looked at", edge.edge));
        }
    }
    let is_stated = is_inside && problems.is_empty() && edges.iter().all(|edge| holds(system, edge));
    Reach { scan_to, edges, is_invariant: is_inside, proposition: is_stated, problems }
}

/// The ranges, in pieces of one.
pub(super) fn ranges(reach: &Reach) -> BTreeMap<usize, Vec<[f64; 2]>> {
    reach.edges.iter().map(|edge| (edge.edge, vec![[edge.r_low, edge.r_max]])).collect()
}

pub(super) fn is_jog(edge: usize, piece: &Piece) -> bool {
    piece.landing == Some((edge, 0))
}

/// Widens the ranges until they hold the images of throws from them, and `slack` more; whether all of these land on the arm.
pub(super) fn widen(system: &System, edges: &mut [EdgeReach], scan_to: f64, slack: f64) -> bool {
    let mut all_land = true;
    for _ in 0..MOST_ROUNDS {
        let mut landings: Vec<(usize, f64, f64)> = Vec::new();
        all_land = true;
        for edge in edges.iter() {
            for piece in edge.pieces.iter().filter(|piece| piece.from < edge.r_max) {
                let Some((onto, _)) = piece.landing else {
                    all_land = false;
                    continue;
                };
                match image(system, edge.edge, piece, piece.from, piece.to.min(edge.r_max)) {
                    Some(image) => landings.push((onto, image.least, image.most)),
                    None => all_land = false,
                }
            }
        }
        let mut is_wider = false;
        for edge in edges.iter_mut() {
            for (_, least, most) in landings.iter().filter(|(onto, ..)| *onto == edge.edge) {
                let most = most + slack;
                is_wider |= most > edge.r_max * (1.0 + 1e-14);
                edge.r_max = edge.r_max.max(most);
                edge.lowest_image = Some(edge.lowest_image.map_or(*least, |lowest| lowest.min(*least)));
            }
        }
        if !is_wider || edges.iter().any(|edge| edge.r_max > scan_to) {
            break;
        }
    }
    all_land
}

/// Whether jogs below `r_flip` go outward, and all throws above are flips.
fn holds(system: &System, reach: &EdgeReach) -> bool {
    reach.pieces.iter().filter(|piece| piece.from < reach.r_max).all(|piece| {
        let is_below = reach.r_flip.is_some_and(|r_flip| piece.to <= r_flip);
        // where the part begins to reach over the pivot a jog goes nowhere
        let from = piece.from.max(reach.r_low + 1e-9 * system.part_radius);
        is_below == is_jog(reach.edge, piece)
            && (!is_below || image(system, reach.edge, piece, from, piece.to).is_some_and(|image| image.gain > 0.0))
    })
}
