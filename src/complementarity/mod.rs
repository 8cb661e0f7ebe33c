//! Linear complementarity problems `w = M z + q`, `0 ≤ w ⊥ z ≥ 0`, as frictional contact poses them.
//!
//! [`Solver`] answers in doubles where a residual certifies the answer, and exactly elsewhere.

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
