//! The pieces of the throw map: radii on one edge from which throws do alike, with proved ends.

use super::system::System;
use crate::answer::Piece;
use crate::exact::FloatInterval;
use crate::mechanics::throwing::{Branch, BranchEnd, Elsewhere, Thrown};

/// Images computed for one edge at most.
const MOST_IMAGES: usize = 200_000;
/// Least relative width that is cut in two; breaks are enclosed no better than that, as a rule.
const NARROW: f64 = 1e-12;

/// What throws that do alike have in common.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Sign {
    impact_vertex: usize,
    landing: Option<(usize, i64)>,
}

/// The pieces between two radii, by radius. What is narrower than [`NARROW`] may be left out.
///
/// # Cost
/// Some hundred images a break.
pub(super) fn pieces(system: &System, edge: usize, from: f64, to: f64) -> Vec<Piece> {
    let mut pieces: Vec<Piece> = Vec::new();
    let mut open = vec![[from, to]];
    let mut images = 0;
    while let Some([from, to]) = open.pop() {
        images += 1;
        let sign = sign(&system.branches(edge, FloatInterval::from_ends(from, to)));
        let middle = 0.5 * (from + to);
        let is_narrow = to - from <= NARROW * to || images > MOST_IMAGES;
        match sign {
            Some(Sign { impact_vertex, landing }) => match pieces.last_mut() {
                Some(last) if (last.impact_vertex, last.landing) == (impact_vertex, landing) => last.to = to,
                last => {
                    // a break is half way between what is proved on its sides
                    let start = last.map_or(from, |last| {
                        last.to = 0.5 * (last.to + from);
                        last.to
                    });
                    pieces.push(Piece { from: start, to, impact_vertex, landing });
                }
            },
            None if is_narrow => {}
            None => open.extend([[middle, to], [from, middle]]),
        }
    }
    pieces
}

/// What all throws of the branches have in common, if they do.
fn sign(branches: &[Branch]) -> Option<Sign> {
    let [Branch { impact_vertex, end }] = *branches else { return None };
    match end {
        BranchEnd::Rest { edge, steps, .. } => Some(Sign { impact_vertex, landing: Some((edge, steps)) }),
        BranchEnd::Other(Elsewhere::OffArm) => Some(Sign { impact_vertex, landing: None }),
        BranchEnd::Other(_) => None,
    }
}

/// Least and largest landing radius, and least gain, of throws from a part of a piece.
#[derive(Debug, Clone, Copy)]
pub(super) struct Image {
    pub(super) least: f64,
    pub(super) most: f64,
    /// Least of landing radius less radius.
    pub(super) gain: f64,
}

/// Radii of a piece at which its image is looked at.
const SAMPLES: usize = 32;
/// Bisections for where a slope is zero.
const BISECTIONS: usize = 60;

/// The image of a piece that lands, from `from` to `to` in it.
pub(super) fn image(system: &System, edge: usize, piece: &Piece, from: f64, to: f64) -> Option<Image> {
    let at = |radius: f64| inside(system, edge, piece, radius);
    let sample = |k: usize| from + (to - from) * k as f64 / SAMPLES as f64;
    let found: Vec<(f64, f64, f64)> = (0..=SAMPLES).filter_map(|k| at(sample(k))).collect();
    let mut values: Vec<(f64, f64)> = found.iter().map(|(radius, image, _)| (*radius, *image)).collect();
    for pair in found.windows(2) {
        // extremes of the image and of the gain
        for level in [0.0, 1.0] {
            if (pair[0].2 - level) * (pair[1].2 - level) < 0.0 {
                let [mut low, mut high] = [pair[0].0, pair[1].0];
                for _ in 0..BISECTIONS {
                    let middle = 0.5 * (low + high);
                    let is_same = at(middle).is_some_and(|found| (found.2 > level) == (pair[0].2 > level));
                    *if is_same { &mut low } else { &mut high } = middle;
                }
                values.extend(at(low).map(|(radius, image, _)| (radius, image)));
            }
        }
    }
    let fold = |of: &dyn Fn(&(f64, f64)) -> f64, pick: fn(f64, f64) -> f64| values.iter().map(of).reduce(pick);
    Some(Image {
        least: fold(&|(_, image)| *image, f64::min)?,
        most: fold(&|(_, image)| *image, f64::max)?,
        gain: fold(&|(radius, image)| image - radius, f64::min)?,
    })
}

/// Radius, landing radius and slope at the radius of a piece that is nearest to `radius` and certainly of it.
pub(super) fn inside(system: &System, edge: usize, piece: &Piece, radius: f64) -> Option<(f64, f64, f64)> {
    let mut aside = 0.0;
    for _ in 0..8 {
        let radius = if radius < 0.5 * (piece.from + piece.to) { radius + aside } else { radius - aside };
        if let Thrown::Caught(catch) = system.throw((edge, radius))
            && (Some((catch.edge, catch.steps)), catch.impact_vertex) == (piece.landing, piece.impact_vertex)
        {
            return Some((radius, catch.radius, catch.slope));
        }
        aside = if aside == 0.0 { 4.0 * f64::EPSILON * radius } else { 4.0 * aside };
    }
    None
}
