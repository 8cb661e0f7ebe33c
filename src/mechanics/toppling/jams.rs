//! Heights at which a pin on one edge stops the part.

use super::curve::Curve;
use super::height::Height;
use super::pivoting::{Facing, Pivoting, Slide};
use super::region::{Region, Signs};
use super::signs::Span;
use super::sketch::value;
use super::turn::Toppled;
use crate::exact::Algebraic;
use std::rc::Rc;

/// The curves that matter to a pin on one edge.
pub(super) struct Edge {
    facing: Facing,
    pub(super) bottom: Rc<Curve>,
    pub(super) top: Rc<Curve>,
    axis: Option<Rc<Curve>>,
    pub(super) down: [Option<Rc<Curve>>; 2],
    pub(super) up: [Option<Rc<Curve>>; 2],
}

impl Edge {
    pub(super) fn of(part: &Toppled, pivoting: &Pivoting, facing: Facing) -> Self {
        let place = facing.place;
        Self {
            bottom: pivoting.corner(place),
            top: pivoting.corner(place + 1),
            axis: pivoting.axis(place),
            down: pivoting.force(place, Slide::Down, part),
            up: pivoting.force(place, Slide::Up, part),
            facing,
        }
    }

    /// Its place after the pivot.
    pub(super) fn place(&self) -> usize {
        self.facing.place
    }

    /// Near the height H of section IV-C that a pin on the edge needs to roll the part, for drawing.
    pub(super) fn rolling_height(&self, t: f64) -> Option<f64> {
        let right = self.down.iter().flatten().map(|curve| value(curve, t)).reduce(f64::max)?;
        let Some(axis) = self.axis.as_ref().map(|axis| value(axis, t)).filter(|axis| *axis > 0.0) else {
            return Some(right);
        };
        let left = value(self.up[0].as_ref()?, t);
        Some(if left > axis { left } else { right.min(axis) })
    }

    /// Near the height J of section IV-D up to which a pin on the edge jams the part, for drawing.
    pub(super) fn jamming_height(&self, t: f64) -> Option<f64> {
        let heights = self.down.iter().flatten().map(|curve| value(curve, t)).reduce(f64::min)?;
        let axis = self.axis.as_ref().map(|axis| value(axis, t)).filter(|axis| *axis > 0.0);
        Some(axis.map_or(heights, |axis| heights.min(axis)))
    }

    /// The part of `span` in which the edge faces the pin.
    pub(super) fn faced(&self, span: &Span) -> Span {
        span.within(&self.facing.span)
    }

    /// Rolling stops where the moment about P1 or the pivot is not positive (section IV-C). P3 and, left of the vertical,
    /// the pivot never decide.
    pub(super) fn rolling_jams(&self, span: &Span, signs: &Signs) -> Vec<[Height; 2]> {
        let [upright, leaning] = self.parted(&self.faced(span));
        let Self { bottom, top, axis, down: [Some(p1), Some(pivot)], up: [Some(p1_up), _], .. } = self else {
            return self.any_contact(span, signs);
        };
        let mut found = Vec::new();
        for least in [p1, pivot] {
            found.extend(Region::between(&[bottom], &[top, least]).heights(&upright, signs));
            if let Some(axis) = axis {
                found.extend(Region::between(&[bottom], &[top, least, axis]).heights(&leaning, signs));
            }
        }
        let lows: Vec<&Rc<Curve>> = std::iter::once(bottom).chain(axis).collect();
        found.extend(Region::between(&lows, &[top, p1_up]).heights(&leaning, signs));
        found
    }

    /// Settling stops where the moments about P1 and the pivot are both not positive and the contact is not left of the
    /// vertical (section IV-D, without its P3).
    pub(super) fn settling_jams(&self, span: &Span, signs: &Signs) -> Vec<[Height; 2]> {
        let [upright, leaning] = self.parted(&self.faced(span));
        let Self { bottom, top, axis, down: [Some(p1), Some(pivot)], .. } = self else {
            return self.any_contact(span, signs);
        };
        let mut found = Region::between(&[bottom], &[top, p1, pivot]).heights(&upright, signs);
        if let Some(axis) = axis {
            found.extend(Region::between(&[bottom], &[top, p1, pivot, axis]).heights(&leaning, signs));
        }
        found
    }

    /// Without friction on the belt nothing holds the pivot.
    fn any_contact(&self, span: &Span, signs: &Signs) -> Vec<[Height; 2]> {
        Region::between(&[&self.bottom], &[&self.top]).heights(&self.faced(span), signs)
    }

    /// Before and after the edge leans back over the pivot.
    fn parted(&self, span: &Span) -> [Span; 2] {
        let lean: &Rc<Algebraic> = self.facing.leans_from.as_ref().unwrap_or(&span.to);
        [span.until(lean), span.since(lean)]
    }
}
