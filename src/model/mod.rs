//! What a case means: the part, its friction, its fixture in exact numbers, and scenes for the time-steppers.

mod conveyor;
mod feeder;
mod fixture;
mod given;
mod orientation;
mod part;
mod scene;
mod thrower;

pub use conveyor::Conveyor;
pub use feeder::{Device, Dimension, Feeder, Goal, Rest, Uncertain, Variable};
pub use fixture::{Fixel, Fixture, Friction, Place, Range};
pub use given::GivenPush;
pub use orientation::{tangents, turned};
pub use part::{LengthUnit, Part, Shape};
pub use scene::{
    Body, Compliance, Entries, Finger, Material, Obstacle, Planar, PlanarShape, Restitution, Scene, Space, Spatial,
    SpatialShape, Timed, World,
};
pub use thrower::Thrower;
