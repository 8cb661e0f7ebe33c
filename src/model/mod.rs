//! What a case means, in exact numbers: the part, its friction, its fixture.

mod conveyor;
mod fixture;
mod part;

pub use conveyor::Conveyor;
pub use fixture::{Fixel, Fixture, Friction, Place, Range};
pub use part::{LengthUnit, Part, Shape};
