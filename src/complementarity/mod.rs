//! Linear complementarity problems `w = M z + q`, `0 ≤ w ⊥ z ≥ 0`, as frictional contact poses them.
//!
//! * [`Lcp`] is a problem in doubles, [`Factors`] are what a contact problem is made of, and [`ExactLcp`] is a problem
//!   without rounding.
//! * [`Solver`] climbs from the last basis over Lemke's method to Newton's, accepts an answer only with its
//!   [`Residual`], and ends in integers: with a solution, a [`Proof`] that there is none, or the limit it met.
//! * [`enumerate`] finds all solutions of a small problem, and tells forces from the velocities that they cause.

mod arbiter;
mod basis;
mod cases;
mod decide;
mod dense;
mod exact_basis;
mod exact_lcp;
mod factors;
mod farkas;
mod integral;
mod lcp;
mod lemke;
mod newton;
mod scaling;
mod solutions;
mod solver;
mod verdict;

pub use basis::Basis;
pub use exact_lcp::ExactLcp;
pub use factors::Factors;
pub use lcp::{ACCEPTED_RESIDUAL, ACCEPTED_VIOLATION, Lcp, LcpError, Residual};
pub use solutions::{Count, Enumeration, Images, Piece, Range, Solutions, enumerate};
pub use solver::Solver;
pub use verdict::{ExcludedCase, Limits, Proof, Rung, Solution, Undecided, Verdict};
