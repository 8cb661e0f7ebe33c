//! Small random polyhedra.

use super::support::int;
use partplan::cone::{Polyhedron, Representation};
use partplan::exact::{Q, ratio};
use proptest::collection::vec;
use proptest::prelude::*;

fn entry() -> impl Strategy<Value = Q> {
    prop_oneof![4 => (-3..=3_i64).prop_map(int), 1 => (-9..=9_i64, 1..=4_i64).prop_map(|(p, q)| ratio(p, q))]
}

/// Inequalities in 1 to 3 variables, some of them linear; empty, flat and unbounded ones among them.
pub fn inequalities() -> impl Strategy<Value = Polyhedron> {
    (2..=4_usize).prop_flat_map(|columns| {
        vec((vec(entry(), columns), prop::bool::weighted(0.15)), 0..=6).prop_map(move |drawn| {
            let linear: Vec<usize> = (0..drawn.len()).filter(|row| drawn[*row].1).collect();
            let rows = drawn.into_iter().map(|(row, _)| row).collect();
            Polyhedron::new(Representation::Inequalities, columns, rows, &linear)
        })
    })
}

/// Points, rays and lines in 1 to 3 variables.
pub fn generators() -> impl Strategy<Value = Polyhedron> {
    (2..=4_usize).prop_flat_map(|columns| {
        vec((vec(entry(), columns), 0..=5_u8), 0..=6).prop_map(move |drawn| {
            let linear: Vec<usize> = (0..drawn.len()).filter(|row| drawn[*row].1 == 0).collect();
            let row = |(mut row, kind): (Vec<Q>, u8)| {
                row[0] = int(i64::from(kind > 2));
                row
            };
            Polyhedron::new(Representation::Generators, columns, drawn.into_iter().map(row).collect(), &linear)
        })
    })
}

/// Either.
pub fn polyhedra() -> impl Strategy<Value = Polyhedron> {
    prop_oneof![inequalities(), generators()]
}
