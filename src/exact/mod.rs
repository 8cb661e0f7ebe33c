//! Exact numbers: rationals, literals, integer rows on a ladder of machine integers, polynomials and their real roots.
//!
//! Nothing outside of this folder names `num_bigint`.

mod algebraic;
mod bracket;
mod double;
mod filter;
mod float_functions;
mod float_interval;
mod gcd;
mod image;
mod int;
mod isolate;
mod limbs;
mod literal;
mod long;
mod matrix;
mod minors;
mod polynomial;
mod quad;
mod rational;
mod surd;
mod wide;

pub use algebraic::Algebraic;
pub use filter::SignFilter;
pub use float_interval::FloatInterval;
pub use int::{Int, Ladder, Overflow, Rung, climb};
pub use literal::{LiteralError, MAX_EXPONENT, parse_literal};
pub use long::Long;
pub use matrix::{Entries, Matrix, make_primitive, on_rung, primitive_row};
pub use minors::{Minors, cross};
pub use polynomial::Polynomial;
pub use rational::{approximate, dot, fraction, from_float_exact, ratio, sum, to_f64};
pub use surd::Surd;

/// Integers of any size.
pub type Z = num_bigint::BigInt;

/// Rational numbers of any size, always reduced.
pub type Q = num_rational::BigRational;
