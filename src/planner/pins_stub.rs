//! A place for the planner of pins that is to come: it checks the question and answers nothing.

use crate::answer::Pins;
use crate::exact::Q;
use crate::geometry::{difference, dot};
use crate::model::{Conveyor, Part, Shape};
use num_traits::Signed as _;

/// What is asked about pins.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct PinQuestion {
    /// Heights of which to tell what a pin does.
    pub heights: Vec<Q>,
    /// The edge on which the part is to end; any if none is given.
    pub end: Option<usize>,
    /// The most pins.
    pub max_pins: Option<usize>,
    /// Whether to trade more pins for a wider tolerance.
    pub pareto: bool,
}

/// Why pins cannot be planned.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum PinsError {
    /// A disc has no edges to rest on.
    #[error("a disc has no edges to rest on; give the part as a polygon")]
    Disc,
    /// The part cannot end where it does not rest stably.
    #[error("the part does not rest stably on edge {edge} of its hull; the edges on which it does are {}", listed(.stable))]
    UnstableEnd {
        /// The edge that was asked for.
        edge: usize,
        /// Those that can be.
        stable: Vec<usize>,
    },
    /// There is no planner yet.
    #[error("pins cannot be planned yet")]
    Missing,
}

/// Checks the question.
///
/// # Errors
/// Always.
pub fn pins(part: &Part, _conveyor: &Conveyor, question: &PinQuestion) -> Result<Pins, PinsError> {
    let Shape::Polygon(polygon) = &part.shape else { return Err(PinsError::Disc) };
    let hull: Vec<&[Q; 2]> = polygon.hull().into_iter().map(|corner| &polygon.vertices()[corner]).collect();
    let is_stable = |edge: &usize| {
        let (a, b, center) = (hull[*edge], hull[(edge + 1) % hull.len()], &part.center_of_mass);
        let along = difference(a, b);
        dot(&along, &difference(a, center)).is_positive() && dot(&along, &difference(center, b)).is_positive()
    };
    let stable: Vec<usize> = (0..hull.len()).filter(is_stable).collect();
    match question.end {
        Some(edge) if !stable.contains(&edge) => Err(PinsError::UnstableEnd { edge, stable }),
        _ => Err(PinsError::Missing),
    }
}

fn listed(edges: &[usize]) -> String {
    edges.iter().map(usize::to_string).collect::<Vec<_>>().join(", ")
}
