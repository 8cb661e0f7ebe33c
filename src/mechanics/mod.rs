//! Contact modes and the wrenches that are consistent with them.

mod contact;
mod feasible;
mod frame;
mod friction;
mod mode;
pub mod throwing;
pub mod toppling;
mod wrench_cone;

pub use contact::{Contact, ContactRows};
pub use feasible::feasible_modes;
pub use frame::Frame;
pub use friction::FrictionEdges;
pub use mode::{Interaction, Mode, ModeError};
pub use wrench_cone::{acceleration_system, balanced_cone, force_rays, mode_cone};
