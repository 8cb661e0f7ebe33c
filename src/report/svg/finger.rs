//! Places where a frictionless finger may push: thick lines along the outline, ends filled if they belong to them.

use super::canvas::{At, MUTED, Pen};
use super::legend::Swatch;
use super::scene::Scene;
use super::view::{self, Outline};
use crate::answer::{ArcSet, FingerSet, Interval};
use crate::report::decimal;

/// One set of places.
pub(super) struct Band<'a> {
    pub(super) fingers: &'a FingerSet,
    pub(super) colour: &'static str,
    pub(super) meaning: &'static str,
    /// Lanes lie side by side outside of the outline.
    pub(super) lane: u8,
}

impl Band<'_> {
    fn offset(&self) -> f64 {
        4.5 + 7.0 * f64::from(self.lane)
    }

    fn width(&self) -> f64 {
        if self.lane == 0 { 5.0 } else { 4.0 }
    }

    fn is_empty(&self) -> bool {
        match self.fingers {
            FingerSet::Edges(edges) => edges.is_empty(),
            FingerSet::Arcs(set) => !set.all && set.arcs.is_empty(),
        }
    }
}

/// Draws the bands, and names the edges and vertices that the text report counts from.
pub(super) fn draw(scene: &mut Scene, bands: &[Band]) {
    for band in bands.iter().filter(|band| !band.is_empty()) {
        match (band.fingers, scene.view.outline.clone()) {
            (FingerSet::Edges(edges), Outline::Polygon(corners)) => {
                for fingers in edges {
                    let ends = [corners[fingers.edge], corners[(fingers.edge + 1) % corners.len()]];
                    for interval in &fingers.intervals {
                        segment(scene, band, ends, interval);
                    }
                }
            }
            (FingerSet::Arcs(set), Outline::Circle { center, radius }) => {
                rim(scene, band, center, radius + band.offset(), set);
            }
            _ => {}
        }
        scene.legend.add(Swatch::Band(band.colour), band.meaning);
    }
    name_edges(scene, bands);
}

fn segment(scene: &mut Scene, band: &Band, ends: [At; 2], interval: &Interval) {
    let outward = outward(ends);
    let [from, to] = interval.points.each_ref().map(|point| scene.view.at(point).along(outward, band.offset()));
    scene.canvas.line(&[from, to], Pen::stroke(band.colour, band.width()));
    scene.labels.avoid(&view::along(from, to));
    end(scene, band, from, interval.closed[0]);
    end(scene, band, to, interval.closed[1]);
}

fn rim(scene: &mut Scene, band: &Band, center: At, radius: f64, set: &ArcSet) {
    let pen = Pen::stroke(band.colour, band.width());
    if set.all {
        scene.canvas.circle(center, radius, pen);
    }
    for arc in &set.arcs {
        let (start, sweep) = (decimal::angle(&arc.from).to_radians(), decimal::sweep(arc).to_radians());
        scene.canvas.arc(center, radius, start, sweep, false, pen);
        end(scene, band, center.along(At::unit(start), radius), arc.closed[0]);
        end(scene, band, center.along(At::unit(start + sweep), radius), arc.closed[1]);
    }
}

fn end(scene: &mut Scene, band: &Band, at: At, closed: bool) {
    let fill = if closed { band.colour } else { "#ffffff" };
    scene.canvas.circle(at, 0.72 * band.width(), Pen::fill(fill, 1.0).outlined(band.colour, 1.4));
    scene.labels.avoid(&[at]);
}

fn name_edges(scene: &mut Scene, bands: &[Band]) {
    let Outline::Polygon(corners) = scene.view.outline.clone() else { return };
    let used = |edge: usize| {
        bands.iter().any(
            |band| matches!(band.fingers, FingerSet::Edges(edges) if edges.iter().any(|fingers| fingers.edge == edge)),
        )
    };
    let clear = bands.iter().filter(|band| !band.is_empty()).map(Band::offset).fold(0.0, f64::max) + 11.0;
    for (edge, from) in corners.iter().enumerate().filter(|(edge, _)| used(*edge)) {
        let to = corners[(edge + 1) % corners.len()];
        let previous = corners[(edge + corners.len() - 1) % corners.len()];
        let middle = middle_of_first(scene, bands, edge).unwrap_or_else(|| from.along(to.minus(*from), 0.5));
        scene.labels.want(middle, outward([*from, to]), clear, MUTED, false, format!("edge {edge}"));
        let (before, after) = (outward([previous, *from]), outward([*from, to]));
        let toward = At::new(before.x + after.x, before.y + after.y).normalized();
        scene.labels.want(*from, toward, 13.0, MUTED, false, format!("v{edge}"));
    }
}

fn middle_of_first(scene: &Scene, bands: &[Band], edge: usize) -> Option<At> {
    bands.iter().find_map(|band| {
        let FingerSet::Edges(edges) = band.fingers else { return None };
        let interval = edges.iter().find(|fingers| fingers.edge == edge)?.intervals.first()?;
        let [from, to] = interval.points.each_ref().map(|point| scene.view.at(point));
        Some(from.along(to.minus(from), 0.5))
    })
}

/// The outline runs counter-clockwise as seen, so outward is to the right.
pub(super) fn outward([from, to]: [At; 2]) -> At {
    let along = to.minus(from).normalized();
    At::new(-along.turned().x, -along.turned().y)
}
