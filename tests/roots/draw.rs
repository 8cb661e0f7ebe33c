//! Random polynomials, with known roots or none known.

use super::support::sturm;
use num_traits::One;
use partplan::exact::{Polynomial, Q, ratio};
use proptest::collection::vec;
use proptest::prelude::*;

/// Small rationals, thirds and eighths among them so that bisection meets some and misses others.
pub fn small() -> impl Strategy<Value = Q> {
    (-24..=24_i64, prop::sample::select(vec![1_i64, 2, 3, 8])).prop_map(|(p, q)| ratio(p, q))
}

/// Integer coefficients, low degree first, the last not zero.
pub fn coefficients(degrees: std::ops::RangeInclusive<usize>) -> impl Strategy<Value = Vec<Q>> {
    let entry = || prop_oneof![3 => -9..=9_i64, 1 => -1_000_000..=1_000_000_i64];
    let leading = entry().prop_filter("the leading coefficient is not zero", |c| *c != 0);
    (degrees.prop_flat_map(move |degree| vec(entry(), degree)), leading)
        .prop_map(|(lower, leading)| lower.into_iter().chain([leading]).map(|c| Q::from_integer(c.into())).collect())
}

/// `Π (x - r)` over the roots given.
pub fn with_roots(roots: &[Q]) -> Vec<Q> {
    roots.iter().fold(vec![Q::one()], |p, root| sturm::product(&p, &[-root, Q::one()]))
}

pub fn polynomial(coefficients: &[Q]) -> Polynomial {
    Polynomial::from_rationals(coefficients)
}

pub fn sorted(mut roots: Vec<Q>) -> Vec<Q> {
    roots.sort();
    roots.dedup();
    roots
}
