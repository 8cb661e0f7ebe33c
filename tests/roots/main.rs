//! Polynomials and real algebraic numbers, judged by closed forms, Sturm's theorem and rational arithmetic.

mod closed;
mod draw;
mod filter;
mod images;
mod numbers;
mod polynomials;
#[path = "../support/mod.rs"]
mod support;
