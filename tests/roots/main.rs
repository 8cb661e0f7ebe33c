//! Polynomials and real algebraic numbers, judged by closed forms, Sturm's theorem and rational arithmetic.

mod closed;
mod draw;
mod numbers;
mod polynomials;
#[path = "../support/mod.rs"]
mod support;
