//! Answers as text, JSON and pictures: pure functions of the answer and of what was asked.

pub mod json;
pub mod svg;
pub mod text;

mod decimal;
mod phrase;

use crate::exact::Q;
use crate::model::{Fixture, Part, Shape};
use num_traits::Signed as _;

/// What an answer is about.
#[derive(Debug, Clone, Copy)]
pub struct Subject<'a> {
    /// Name of the case, or of its file.
    pub name: &'a str,
    /// The part.
    pub part: &'a Part,
    /// Its fixture.
    pub fixture: &'a Fixture,
    /// Warnings of the reader.
    pub warnings: &'a [String],
}

impl Subject<'_> {
    /// Largest coordinate distance of the outline from the center of mass: the torque side of the box that measures
    /// volumes.
    fn reach(&self) -> Q {
        let com = &self.part.center_of_mass;
        match &self.part.shape {
            Shape::Polygon(polygon) => polygon
                .vertices()
                .iter()
                .flat_map(|vertex| [(&vertex[0] - &com[0]).abs(), (&vertex[1] - &com[1]).abs()])
                .max()
                .expect("a polygon has vertices"),
            Shape::Circle { center, radius } => {
                let offset = [(&center[0] - &com[0]).abs(), (&center[1] - &com[1]).abs()];
                offset.into_iter().max().expect("two coordinates") + radius
            }
        }
    }
}
