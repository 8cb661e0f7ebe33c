//! Runs of scenes, as reports show them: names, views, energies.

mod energy;
mod names;
mod planar;
mod spatial;

pub use energy::energy;
pub use names::{change, contact, plain};
pub use planar::rounded;

use crate::answer::{Frame, Simulation};
use crate::model::{Body, Space, World};
use serde_json::Value;
use std::fmt;

/// What a report of a run is about.
#[derive(Debug, Clone, Copy)]
pub struct Run<'a, S: Space> {
    /// Name of the case, or of its file.
    pub name: &'a str,
    /// The scene.
    pub world: &'a World<S>,
    /// Warnings of the reader.
    pub warnings: &'a [String],
}

/// A direction of view: which coordinates go to the right and up.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct View {
    /// What it is called; empty in the plane.
    pub name: &'static str,
    /// Coordinate to the right.
    pub right: usize,
    /// Coordinate upward.
    pub up: usize,
}

impl View {
    /// A point as seen.
    #[must_use]
    pub fn of(self, point: &[f64]) -> [f64; 2] {
        [self.right, self.up].map(|axis| point.get(axis).copied().unwrap_or(0.0))
    }
}

/// An outline as seen (m).
#[derive(Debug, Clone, PartialEq)]
pub enum Outline {
    /// A polygon.
    Polygon(Vec<[f64; 2]>),
    /// A disc; of radius zero a point.
    Disc {
        /// Center.
        center: [f64; 2],
        /// Radius.
        radius: f64,
        /// Where a mark on its rim is, which shows how it turns.
        mark: [f64; 2],
    },
    /// What lies below a line.
    Half {
        /// A point of the line.
        point: [f64; 2],
        /// Unit normal, out of the material.
        normal: [f64; 2],
    },
}

/// The plane or space, as reports show it.
pub trait Shown: Space + fmt::Debug {
    /// 2 or 3.
    const DIMENSION: usize;
    /// Names and units of the entries of a pose.
    const POSE: &'static [[&'static str; 2]];
    /// Names and units of the entries of a velocity.
    const VELOCITY: &'static [[&'static str; 2]];
    /// Directions of view.
    const VIEWS: &'static [View];
    /// Headings of [`Shown::cells`].
    const HEADINGS: &'static [&'static str];

    /// A shape at a pose as seen; what is seen as a whole plane is left out.
    fn outlines(shape: &Self::Shape, pose: Option<&Self::Pose>, view: View) -> Vec<Outline>;

    /// The pieces of a shape in its frame, as the script of a page reads them: one key each, `polygon`, `disc` (center, radius),
    /// `half` (point, normal), `sphere` (center, radius) or `box` (halves of its lengths).
    fn pieces(shape: &Self::Shape) -> Vec<Value>;

    /// Angle between two orientations (rad).
    fn turn(from: &Self::Pose, to: &Self::Pose) -> f64;

    /// Kinetic energy of the rotation (J).
    fn spin_energy(body: &Body<Self>, pose: &Self::Pose, velocity: &Self::Velocity) -> f64;

    /// Orientation in words.
    fn orientation(pose: &Self::Pose) -> String;

    /// Pose and velocity in a table.
    fn cells(pose: &Self::Pose, velocity: &Self::Velocity) -> Vec<String>;

    /// Impulse along the axes of the world (N s), of its parts along n, t and o.
    fn impulse(normal: &Self::Vector, parts: [f64; 3]) -> Self::Vector;
}

/// Whether a body is as good as at rest: slower than 1 mm/s and 1 mrad/s.
#[must_use]
pub fn is_at_rest<S: Shown>(velocity: &S::Velocity) -> bool {
    velocity.as_ref().iter().all(|entry| entry.abs() < 1e-3)
}

/// The frames that hold a pose and a velocity of every body, all numbers finite.
pub fn sound<'a, S: Shown>(run: &Run<S>, answer: &'a Simulation<S>) -> Vec<&'a Frame<S>> {
    let count = run.world.bodies.len();
    let is_finite = |entries: &[f64]| entries.iter().all(|entry| entry.is_finite() && entry.abs() < 1e15);
    let is_sound = |frame: &&Frame<S>| {
        frame.poses.len() == count
            && frame.velocities.len() == count
            && frame.time.is_finite()
            && frame.poses.iter().all(|pose| is_finite(pose.as_ref()))
            && frame.velocities.iter().all(|velocity| is_finite(velocity.as_ref()))
    };
    answer.frames.iter().filter(is_sound).collect()
}
