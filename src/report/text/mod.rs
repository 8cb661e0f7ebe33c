//! Text for people: the answer first.

mod chart;
mod cone;
mod feeder;
mod friction;
mod insert;
mod lines;
mod orientation;
mod pins;
mod polyhedron;
mod simulation;
mod stable;
mod suggest;
mod throw;
mod verification;
mod witness;

pub use chart::chart;
pub use cone::{cones, judged_cones};
pub use feeder::feeder;
pub use insert::insertion;
pub use pins::pins;
pub use polyhedron::polyhedron_notes;
pub use simulation::simulation;
pub use stable::stability;
pub use suggest::suggestion;
pub use throw::throw;
pub use verification::{verification, verified};
