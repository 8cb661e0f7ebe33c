//! Directions of a pull through the center of mass, as a fan around it.

use super::canvas::{At, Pen, SKY};
use super::legend::Swatch;
use super::scene::Scene;
use crate::answer::ArcSet;
use crate::report::decimal;

/// Radius of the fan.
pub(super) const REACH: f64 = 58.0;

/// Draws the fan; an end that does not belong to it is dashed.
pub(super) fn draw(scene: &mut Scene, tilt: &ArcSet, meaning: &str) {
    if !tilt.all && tilt.arcs.is_empty() {
        return;
    }
    let (center, edge) = (scene.com, Pen::stroke(SKY, 1.3));
    if tilt.all {
        scene.canvas.circle(center, REACH, Pen::fill(SKY, 0.3).outlined(SKY, 1.3));
    }
    for arc in &tilt.arcs {
        let (start, sweep) = (decimal::angle(&arc.from).to_radians(), decimal::sweep(arc).to_radians());
        scene.canvas.arc(center, REACH, start, sweep, true, Pen::fill(SKY, 0.3));
        scene.canvas.arc(center, REACH, start, sweep, false, edge);
        for (angle, closed) in [(start, arc.closed[0]), (start + sweep, arc.closed[1])] {
            let pen = if closed { edge } else { edge.dashed() };
            scene.canvas.line(&[center, center.along(At::unit(angle), REACH)], pen);
        }
    }
    scene.legend.add(Swatch::Tilt, meaning);
}
