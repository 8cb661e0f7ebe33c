//! Whether a cell of wrenches keeps an interior as its sides move with the factor.

use super::events::{Planes, Vector, cross_product, inner_product, triples};
use crate::exact::{Algebraic, Polynomial, Z};
use std::cmp::Ordering;

/// Whether a cell with the facet normals `cell` at one factor, where its sides are `planes`, still has an interior when they
/// have moved to `factor`, with no event between.
///
/// Its interior `{x : h_i · x < 0}` is lost iff normals have a positive dependence there (Gordan). Four independent but for
/// that would have had it before, so it takes two opposite normals or three in a plane around zero.
pub(super) fn lasts(cell: &[Vec<Z>], planes: &Planes, factor: &Algebraic) -> bool {
    let sides: Option<Vec<Vector>> = cell.iter().map(|row| planes.through(row)).collect();
    let sides = sides.expect("every facet of a cell is spanned by two rays");
    let at = At(factor);
    let n = sides.len();
    let mut pairs = (0..n).flat_map(|a| (a + 1..n).map(move |b| [a, b]));
    !pairs.any(|[a, b]| at.are_opposite(&sides[a], &sides[b]))
        && !triples(n).any(|[a, b, c]| at.surround_zero(&sides[a], &sides[b], &sides[c]))
}

/// Signs at one factor.
struct At<'a>(&'a Algebraic);

impl At<'_> {
    fn are_opposite(&self, a: &Vector, b: &Vector) -> bool {
        self.sign(&inner_product(a, b)).is_le() && cross_product(a, b).iter().all(|entry| self.sign(entry).is_eq())
    }

    fn surround_zero(&self, a: &Vector, b: &Vector, c: &Vector) -> bool {
        let (ab, bc, ca) = (cross_product(a, b), cross_product(b, c), cross_product(c, a));
        self.sign(&inner_product(&ab, c)).is_eq()
            && self.sign(&inner_product(&ab, &bc)).is_gt()
            && self.sign(&inner_product(&bc, &ca)).is_gt()
    }

    fn sign(&self, polynomial: &Polynomial) -> Ordering {
        self.0.sign_of(polynomial)
    }
}
