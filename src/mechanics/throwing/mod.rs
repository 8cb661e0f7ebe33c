//! Throwing a part with an arm and catching it there.
//!
//! # Source
//! Lynch, Northrop & Pan (2002), Stable limit sets in a dynamic parts feeder.

mod body;
mod carry;
mod enclosure;
mod flight;
mod grasp;
mod map;
mod motion;
mod real;
mod roll;

pub use body::Body;
pub use carry::{Accelerations, Load};
pub use enclosure::{Branch, BranchEnd, Branches, Elsewhere, Enclosing};
pub use grasp::RestingEdge;
pub use map::{Catch, Thrown};
pub use motion::Moment;
pub use real::Real;

/// When a part that rolls is taken to be at rest.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Settling {
    /// When it has not the energy to leave an edge, neither on nor, after one more impact, back.
    #[default]
    Full,
    /// On the first stable edge that it lands on, as section IV of the paper assumes.
    First,
}
