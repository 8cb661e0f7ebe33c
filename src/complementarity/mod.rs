//! Linear complementarity problems `w = M z + q`, `0 ≤ w ⊥ z ≥ 0`, as frictional contact poses them.
//!
//! [`Solver`] answers in doubles where a residual certifies the answer, and exactly elsewhere.

mod basis;
mod dense;
mod exact_lcp;
mod factors;
mod lcp;
mod lemke;
mod newton;
mod scaling;
mod solver;
mod verdict;

pub use basis::Basis;
pub use exact_lcp::ExactLcp;
pub use factors::Factors;
pub use lcp::{ACCEPTED_RESIDUAL, Lcp, LcpError};
pub use solver::Solver;
pub use verdict::{ExcludedCase, Limits, Proof, Rung, Solution, Undecided, Verdict};
