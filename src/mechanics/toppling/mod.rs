//! The toppling graph: what pins of all heights do to a part that they turn over on a belt.
//!
//! Every height of the graph is a rational function of `t = tan(angle / 2)`, and every condition is linear in the height of
//! the pin. Critical heights are values of such functions at roots of polynomials, so that all decisions are exact.
//!
//! # Source
//! Zhang, Goldberg, Smith, Berretty & Overmars (2001), Pin design for part feeding, section IV, with the conditions taken
//! from the balance of forces where the print departs from it.

mod curve;
mod height;
mod jams;
mod pivoting;
mod region;
mod signs;
mod sketch;
mod turn;

pub use height::Height;
pub use region::Signs;
pub use sketch::Sketch;
pub use turn::{Toppled, Turn};
