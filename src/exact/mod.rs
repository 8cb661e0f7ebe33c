//! Exact numbers: rationals, literals, and integer rows on a ladder of machine integers.
//!
//! Nothing outside of this folder names `num_bigint`.

mod int;
mod literal;
mod matrix;
mod minors;
mod rational;
mod wide;

pub use int::{Int, Ladder, Overflow, Rung, climb};
pub use literal::{LiteralError, MAX_EXPONENT, parse_literal};
pub use matrix::{Entries, Matrix, on_rung, primitive_row};
pub use minors::Minors;
pub use rational::{approximate, from_float_exact, ratio, to_f64};

/// Integers of any size.
pub type Z = num_bigint::BigInt;

/// Rational numbers of any size, always reduced.
pub type Q = num_rational::BigRational;
