//! The factors at which a set may become empty: roots of determinants of the rays that span its cones.

use super::determinants::Determinants;
use super::family::Family;
use crate::exact::{FloatInterval, Polynomial, Q, Z, cross, make_primitive};
use crate::mechanics::Contact;
use num_traits::{Signed as _, Zero as _};
use std::cmp::Ordering;

/// A ray `base + k slope` that spans cones of some modes, as a function of the factor `k`.
struct Ray {
    base: [Z; 3],
    slope: [Z; 3],
    /// Whose friction it is; `None` for an acceleration.
    fixel: Option<usize>,
}

/// The rays that span the cones of all modes over `m s a u`, the same for every mode up to their signs.
///
/// With independent normals an acceleration cone is spanned by the vectors dual to the normals and by the directions in
/// which no normal accelerates; a cone of forces by the edges of friction cones.
pub(super) struct Rays(Vec<Ray>);

impl Rays {
    /// The rays of at most three contacts with independent normals, and the constant `wrench` as a last one.
    pub(super) fn of(family: &Family, wrench: Option<&[Z]>) -> Self {
        let constant = |base: [Z; 3]| Ray { base, slope: [Z::zero(), Z::zero(), Z::zero()], fixel: None };
        let mut rays: Vec<Ray> = dual_basis(&family.contacts).into_iter().map(constant).collect();
        for (fixel, edges) in family.edges.iter().enumerate() {
            for side in 0..2 {
                rays.push(Ray {
                    base: triple(&edges.base[side]),
                    slope: triple(&edges.slope[side]),
                    fixel: Some(fixel),
                });
            }
        }
        // zero friction has one edge
        rays.dedup_by(|a, b| a.fixel == b.fixel && a.fixel.is_some() && a.base == b.base && a.slope == b.slope);
        rays.extend(wrench.map(|wrench| constant(triple(wrench))));
        Self(rays)
    }

    /// A factor beyond all roots of all determinants.
    ///
    /// With entries at most `G` the coefficients of `[a c d][b e f] - [b c d][a e f]` sum to at most 2 (6 (2 G)³)², and
    /// no root of an integer polynomial exceeds 1 plus its largest coefficient (Cauchy).
    pub(super) fn beyond_all(&self) -> Q {
        let entries = self.0.iter().flat_map(|ray| ray.base.iter().chain(&ray.slope));
        let bits = entries.map(Z::bits).max().unwrap_or(0);
        Q::from(Z::from(1) << (14 + 6 * bits))
    }

    /// Polynomials of which one is zero at every factor strictly above `low` and at most `high` at which the
    /// arrangement of the planes of all cones changes; the last ray is a wrench to be judged if `is_judged`.
    ///
    /// A cone is a union of simplicial cones on its rays, so signs of `[a b x]` and `[a b c] = det(a, b, c)` decide
    /// membership of `x`, and the sets are unions of cells of the arrangement of the planes of two rays. A cell vanishes
    /// or appears only where three planes meet in a line without doing so always: where some `[a b c]` is zero, or
    /// `det(a × b, c × d, e × f) = [a c d][b e f] - [b c d][a e f]`, which is a product of two `[a b c]` if the planes
    /// share a ray. For a single wrench `x` the `[a b c]` and `[a b x]` are enough.
    pub(super) fn events(&self, low: &Q, high: &Q, is_judged: bool) -> Vec<Polynomial> {
        let near = self.determinants(low, high);
        let mut events = Vec::new();
        for triple in triples(self.0.len()) {
            if may_be_zero(near.at(triple)) {
                events.push(self.determinant(triple));
            }
        }
        if !is_judged {
            let planes = self.planes();
            for (index, first) in planes.iter().enumerate() {
                for (second, third) in disjoint_pairs(&planes[index + 1..], first) {
                    let ([a, b], [c, d], [e, f]) = (*first, second, third);
                    let value = near.at([a, c, d]) * near.at([b, e, f]) - near.at([b, c, d]) * near.at([a, e, f]);
                    if may_be_zero(value) {
                        let product = |first, second| &self.determinant(first) * &self.determinant(second);
                        events.push(&product([a, c, d], [b, e, f]) - &product([b, c, d], [a, e, f]));
                    }
                }
            }
        }
        different(events)
    }

    fn determinants(&self, low: &Q, high: &Q) -> Determinants {
        let factor = FloatInterval::between(low, high);
        let range = |ray: &Ray| {
            // a length about one keeps products of six within the doubles
            let bits = ray.base.iter().chain(&ray.slope).map(Z::bits).max().unwrap_or(0);
            let entry = |value: &Z| FloatInterval::of_rational(&Q::new(value.clone(), Z::from(1) << bits));
            [0, 1, 2].map(|axis| entry(&ray.base[axis]) + factor * entry(&ray.slope[axis]))
        };
        Determinants::of(self.0.iter().map(range).collect())
    }

    /// `[a b c]` as a polynomial in the factor.
    fn determinant(&self, [a, b, c]: [usize; 3]) -> Polynomial {
        inner_product(&self.vector(a), &cross_product(&self.vector(b), &self.vector(c)))
    }

    /// The planes of all cones as they are at `factor`.
    pub(super) fn planes_at(&self, factor: &Q) -> Planes {
        let at = |ray: &Ray| [0, 1, 2].map(|axis| &ray.base[axis] * factor.denom() + &ray.slope[axis] * factor.numer());
        let here: Vec<[Z; 3]> = self.0.iter().map(at).collect();
        let plane = |[a, b]: [usize; 2]| {
            let mut row = cross(&here[a], &here[b]).to_vec();
            make_primitive(&mut row);
            (row, [self.vector(a), self.vector(b)])
        };
        Planes(self.planes().into_iter().map(plane).collect())
    }

    fn vector(&self, index: usize) -> Vector {
        let Ray { base, slope, .. } = &self.0[index];
        [0, 1, 2].map(|axis| Polynomial::new(vec![base[axis].clone(), slope[axis].clone()]))
    }

    /// Whether some mode has both rays: not if the first is the acceleration at a fixel that must keep contact for the second.
    fn are_together(&self, [first, second]: [usize; 2]) -> bool {
        self.0[second].fixel != Some(first) && self.0[first].fixel != Some(second)
    }

    /// The pairs of rays that may span a facet.
    fn planes(&self) -> Vec<[usize; 2]> {
        let n = self.0.len();
        let pairs = (0..n).flat_map(|first| (first + 1..n).map(move |second| [first, second]));
        pairs.filter(|pair| self.are_together(*pair)).collect()
    }
}

/// Whether zero is among the numbers meant; true for whatever overflowed.
fn may_be_zero(value: FloatInterval) -> bool {
    !value.sign().is_some_and(Ordering::is_ne)
}

/// The polynomials that are not constant, primitive, with a positive leading coefficient, and each once.
fn different(events: Vec<Polynomial>) -> Vec<Polynomial> {
    let with_sign = |event: Polynomial| if event.leading().is_some_and(Z::is_negative) { -event } else { event };
    let is_constant = |event: &Polynomial| event.degree().is_none_or(|degree| degree == 0);
    let events = events.into_iter().filter(|event| !is_constant(event));
    let mut events: Vec<Polynomial> = events.map(|event| with_sign(event.primitive())).collect();
    events.sort_by(|a, b| a.coefficients().cmp(b.coefficients()));
    events.dedup();
    events
}

/// Planes of two rays, each with its primitive normal at one factor.
pub(super) struct Planes(Vec<(Vec<Z>, [Vector; 2])>);

impl Planes {
    /// As a function of the factor the vector that is `normal`, up to a positive number, at theirs; `None` if it is normal to no plane.
    pub(super) fn through(&self, normal: &[Z]) -> Option<Vector> {
        self.0.iter().find_map(|(row, [a, b])| {
            let is_opposite = row.iter().zip(normal).all(|(x, y)| *x == -y);
            match (row == normal, is_opposite) {
                (true, _) => Some(cross_product(a, b)),
                (_, true) => Some(cross_product(b, a)),
                _ => None,
            }
        })
    }
}

/// A vector as a function of the factor.
pub(super) type Vector = [Polynomial; 3];

pub(super) fn cross_product(a: &Vector, b: &Vector) -> Vector {
    let minor = |i: usize, j: usize| &(&a[i] * &b[j]) - &(&a[j] * &b[i]);
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

pub(super) fn inner_product(a: &Vector, b: &Vector) -> Polynomial {
    &(&(&a[0] * &b[0]) + &(&a[1] * &b[1])) + &(&a[2] * &b[2])
}

/// `x`, `y`, `z` with `n_i · x = 0` for all normal accelerations `n_i` but one each, or for all.
fn dual_basis(contacts: &[Contact]) -> Vec<[Z; 3]> {
    let mut normals: Vec<[Z; 3]> = contacts.iter().map(|contact| triple(&contact.normal_acceleration)).collect();
    // complete with unit vectors, which have no say of their own: lines in which no normal accelerates
    for axis in 0..3 {
        let mut unit = [Z::zero(), Z::zero(), Z::zero()];
        unit[axis] = Z::from(1);
        let is_new = match &normals[..] {
            [a] => cross(a, &unit).iter().any(|entry| !entry.is_zero()),
            [a, b] => !cross(a, b)[axis].is_zero(),
            _ => false,
        };
        if is_new {
            normals.push(unit);
        }
    }
    (0..3).map(|index| cross(&normals[(index + 1) % 3], &normals[(index + 2) % 3])).collect()
}

fn triple(row: &[Z]) -> [Z; 3] {
    [row[0].clone(), row[1].clone(), row[2].clone()]
}

pub(super) fn triples(n: usize) -> impl Iterator<Item = [usize; 3]> {
    (0..n).flat_map(move |a| (a + 1..n).flat_map(move |b| (b + 1..n).map(move |c| [a, b, c])))
}

/// The pairs of planes that share no ray with each other nor with `first`.
fn disjoint_pairs(planes: &[[usize; 2]], first: &[usize; 2]) -> impl Iterator<Item = ([usize; 2], [usize; 2])> {
    let share = |a: &[usize; 2], b: &[usize; 2]| a.iter().any(|ray| b.contains(ray));
    let apart: Vec<[usize; 2]> = planes.iter().copied().filter(|plane| !share(plane, first)).collect();
    let n = apart.len();
    let pairs = (0..n).flat_map(move |second| (second + 1..n).map(move |third| [second, third]));
    pairs.map(move |pair| pair.map(|index| apart[index])).filter(move |[c, d]| !share(c, d)).map(|[c, d]| (c, d))
}
