//! From the part's coordinates to the page.

use super::canvas::At;
use crate::exact::{Q, to_f64};
use crate::model::{Part, Shape};
use num_traits::{Signed as _, Zero as _};

/// Width of every drawing, in pixels.
pub(super) const WIDTH: f64 = 720.0;
/// Room around the part for fixels, arrows and labels.
const MARGIN: f64 = 92.0;
/// Tallest part on the page.
const TALLEST: f64 = 420.0;
/// Room above for the title and the answer.
pub(super) const HEADER: f64 = 62.0;

/// The outline on the page, counter-clockwise as seen.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Outline {
    Polygon(Vec<At>),
    Circle { center: At, radius: f64 },
}

impl Outline {
    /// Points along the outline, close enough to test labels against.
    pub(super) fn samples(&self) -> Vec<At> {
        match self {
            Outline::Polygon(corners) => {
                let next = corners.iter().cycle().skip(1);
                corners.iter().zip(next).flat_map(|(from, to)| along(*from, *to)).collect()
            }
            Outline::Circle { center, radius } => {
                (0..240).map(|k| center.along(At::unit(f64::from(k) / 120.0 * std::f64::consts::PI), *radius)).collect()
            }
        }
    }

    /// Whether a point of the page lies in the part.
    pub(super) fn covers(&self, at: At) -> bool {
        match self {
            Outline::Polygon(corners) => {
                let next = corners.iter().cycle().skip(1);
                let crossings = corners.iter().zip(next).filter(|(a, b)| {
                    (a.y > at.y) != (b.y > at.y) && at.x < a.x + (at.y - a.y) / (b.y - a.y) * (b.x - a.x)
                });
                crossings.count() % 2 == 1
            }
            Outline::Circle { center, radius } => at.minus(*center).length() < *radius,
        }
    }
}

/// Where the part lies on the page.
pub(super) struct View {
    corner: [Q; 2],
    size: Q,
    /// Pixels of the part's larger side.
    pixels: f64,
    origin: At,
    /// Lower edge of the drawing; the legend follows.
    pub(super) bottom: f64,
    pub(super) outline: Outline,
}

impl View {
    pub(super) fn new(part: &Part) -> Self {
        let (low, high) = bounds(&part.shape);
        let sides = [&high[0] - &low[0], &high[1] - &low[1]];
        let size =
            sides.iter().max().filter(|side| side.is_positive()).cloned().unwrap_or_else(|| Q::from_integer(1.into()));
        let [wide, tall] = sides.each_ref().map(|side| to_f64(&(side / &size)));
        let pixels = ((WIDTH - 2.0 * MARGIN) / wide.max(1e-9)).min(TALLEST / tall.max(1e-9));
        let origin = At::new((WIDTH - pixels * wide) / 2.0, HEADER + MARGIN + pixels * tall);
        let bottom = origin.y + MARGIN;
        let mut view = Self { corner: low, size, pixels, origin, bottom, outline: Outline::Polygon(Vec::new()) };
        view.outline = match &part.shape {
            Shape::Polygon(polygon) => Outline::Polygon(polygon.vertices().iter().map(|v| view.at(v)).collect()),
            Shape::Circle { center, radius } => {
                Outline::Circle { center: view.at(center), radius: view.length(radius) }
            }
        };
        view
    }

    /// Subtracts exactly before it rounds: a part far from the origin is drawn as well as one at it.
    pub(super) fn at(&self, point: &[Q; 2]) -> At {
        let [x, y] = [0, 1].map(|axis| to_f64(&((&point[axis] - &self.corner[axis]) / &self.size)));
        At::new(self.origin.x + x * self.pixels, self.origin.y - y * self.pixels)
    }

    pub(super) fn length(&self, length: &Q) -> f64 {
        to_f64(&(length / &self.size)) * self.pixels
    }

    /// Part units in a pixel.
    pub(super) fn units_per_pixel(&self) -> f64 {
        to_f64(&self.size) / self.pixels
    }
}

/// The unit vector on the page that points as `vector` does in the part's frame.
pub(super) fn direction(vector: &[Q; 2]) -> At {
    let largest = vector.iter().map(Q::abs).max().filter(|v| !v.is_zero());
    let [x, y] = match largest {
        Some(largest) => vector.each_ref().map(|v| to_f64(&(v / &largest))),
        None => [0.0, 0.0],
    };
    At::new(x, -y).normalized()
}

/// Points every few pixels from `from` to `to`.
pub(super) fn along(from: At, to: At) -> Vec<At> {
    let step = to.minus(from);
    let count = (step.length() / 4.0).ceil().max(1.0);
    (0..count as usize).map(|k| from.along(step, k as f64 / count)).collect()
}

fn bounds(shape: &Shape) -> ([Q; 2], [Q; 2]) {
    match shape {
        Shape::Polygon(polygon) => {
            let side = |axis: usize| {
                let values = polygon.vertices().iter().map(move |vertex| &vertex[axis]);
                let low = values.clone().min().expect("a polygon has vertices").clone();
                (low, values.max().expect("a polygon has vertices").clone())
            };
            let ([left, right], [bottom, top]) = (<[Q; 2]>::from(side(0)), <[Q; 2]>::from(side(1)));
            ([left, bottom], [right, top])
        }
        Shape::Circle { center, radius } => {
            (center.each_ref().map(|c| c - radius), center.each_ref().map(|c| c + radius))
        }
    }
}
