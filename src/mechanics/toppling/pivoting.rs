//! A part that turns about one corner, from one of the corner's edges flat on the belt to the other.

use super::curve::{Curve, round};
use super::height::narrowed;
use super::region::Signs;
use super::signs::Span;
use super::turn::Toppled;
use crate::exact::{Algebraic, Polynomial, Q, Z};
use num_integer::Integer as _;
use num_traits::{One as _, Signed as _, Zero as _};
use std::cmp::Ordering;
use std::rc::Rc;

type Vector = [Z; 2];

/// Rotation about a corner; `t = tan(angle / 2)` of the angle by which the belt has turned clockwise, seen from the part, from
/// the x axis of the part's frame or from that axis turned by right angles.
pub(super) struct Pivoting {
    pub(super) pivot: usize,
    pub(super) span: Span,
    /// Corners less the pivot, from the pivot on, times `scale`.
    pub(super) corners: Vec<Vector>,
    center_of_mass: Vector,
    scale: Z,
}

/// An edge that faces the pin.
pub(super) struct Facing {
    /// Its place after the pivot.
    pub(super) place: usize,
    /// While it faces the pin.
    pub(super) span: Span,
    /// From when on it leans back over the pivot, if that is in the span.
    pub(super) leans_from: Option<Rc<Algebraic>>,
}

impl Pivoting {
    pub(super) fn about(part: &Toppled, pivot: usize, signs: &Signs) -> Self {
        let n = part.corners.len();
        let all = part.corners.iter().flatten().chain(part.center_of_mass);
        let scale = all.fold(Z::one(), |scale, value| scale.lcm(value.denom()));
        let origin = &part.corners[pivot];
        let whole = |point: &[Q; 2]| [0, 1].map(|axis| ((&point[axis] - &origin[axis]) * &scale).to_integer());
        let mut corners: Vec<Vector> = (0..n).map(|place| whole(&part.corners[(pivot + place) % n])).collect();
        let mut center_of_mass = whole(part.center_of_mass);
        // the flat edge towards +x and up, so that t begins in (-1, 0] and stays finite for half a turn
        while !corners[1][0].is_positive() || corners[1][1].is_negative() {
            corners.iter_mut().chain([&mut center_of_mass]).for_each(quarter_turn);
        }
        let from = cross_b(&corners[1]).real_roots(-Q::one()..=Q::zero());
        let from = from.and_then(|roots| roots.into_iter().next()).expect("the flat edge is in the first quadrant");
        let landing = corners[n - 1].each_ref().map(|value| -value);
        let is_flat = |t: &Algebraic| *t > from && signs.filter.sign_of(&dot_b(&landing), t).is_gt();
        let to = cross_b(&landing).real_roots(..).expect("an edge has a direction").into_iter().find(is_flat);
        let to = to.expect("the part lands within half a turn");
        let span = Span { from: narrowed(from), to: narrowed(to) };
        Self { pivot, span, corners, center_of_mass, scale }
    }

    /// When the center of mass is over the pivot, if that is before the landing and was not before.
    pub(super) fn balance(&self, signs: &Signs) -> Option<Rc<Algebraic>> {
        self.span.roots(&dot_b(&self.center_of_mass), &signs.counter).pop()
    }

    /// The edges that face the pin at some turn, from the pivot up.
    pub(super) fn facing(&self, signs: &Signs) -> Vec<Facing> {
        let sign = |polynomial: &Polynomial, t: &Algebraic| signs.filter.sign_of(polynomial, t);
        let mut facing = Vec::new();
        for place in 0..self.corners.len() - 1 {
            let along = self.along(place);
            let (height, lean) = (cross_b(&along), dot_b(&along));
            if place > 0 && sign(&height, &self.span.from).is_le() {
                break;
            }
            let leaves = sign(&height, &self.span.to).is_lt().then(|| self.span.roots(&height, &signs.counter).pop());
            let to = leaves.flatten().unwrap_or_else(|| Rc::clone(&self.span.to));
            let span = Span { from: Rc::clone(&self.span.from), to };
            let leans_from = match (sign(&lean, &span.from), sign(&lean, &span.to)) {
                (Ordering::Greater, Ordering::Less) => span.roots(&lean, &signs.counter).pop(),
                (Ordering::Greater, _) => None,
                _ => Some(Rc::clone(&span.from)),
            };
            facing.push(Facing { place, span, leans_from });
        }
        facing
    }

    /// The vector along an edge.
    pub(super) fn along(&self, place: usize) -> Vector {
        let [start, end] = [place, place + 1].map(|place| &self.corners[place % self.corners.len()]);
        [&end[0] - &start[0], &end[1] - &start[1]]
    }

    /// Height V of a corner, `x sin θ + z cos θ` of section IV-B.
    pub(super) fn corner(&self, place: usize) -> Rc<Curve> {
        Rc::new(Curve::new(cross_b(&self.corners[place % self.corners.len()]), self.scale.clone(), 1))
    }

    /// Height R of the center of mass.
    pub(super) fn radius(&self) -> Rc<Curve> {
        Rc::new(Curve::new(cross_b(&self.center_of_mass), self.scale.clone(), 1))
    }

    /// Height H* at which a leaning edge crosses the vertical through the pivot, eq. (2); `None` if it does so in the
    /// pivot only.
    pub(super) fn axis(&self, place: usize) -> Option<Rc<Curve>> {
        let along = self.along(place);
        let arm = cross(&self.corners[place], &along);
        let lean = -dot_b(&along);
        let height = &round() * &Polynomial::new(vec![arm.clone()]);
        (!arm.is_zero()).then(|| Rc::new(Curve::leaning(height, self.scale.clone(), 0, lean)))
    }

    /// Heights on edge `place` below which the pin's force, on one edge of its friction cone, has no positive moment about
    /// P1, on the belt's friction cone above the center of mass, and about the pivot P2, eqs. (3), (4), (6), (7) and (13) to
    /// (16) in the plane of `t`.
    ///
    /// `None` for P1 without friction on the belt, where that point is at infinity and nothing holds the pivot.
    pub(super) fn force(&self, place: usize, slides: Slide, part: &Toppled) -> [Option<Rc<Curve>>; 2] {
        let [p1, pivot] = part.pin_friction;
        let (m, r) = (part.belt_friction.numer(), part.belt_friction.denom());
        let (about_pivot, length2, _) = self.about_pivot(place, slides, pivot);
        let pivot = Some(Rc::new(Curve::new(about_pivot, length2 * &self.scale, 1)));
        if m.is_zero() {
            return [None, pivot];
        }
        let (about_pivot, length2, force) = self.about_pivot(place, slides, p1);
        let tilt = &times(&cross_b(&force), m) - &times(&dot_b(&force), r);
        let weight = &(&cross_b(&self.along(place)) * &dot_b(&self.center_of_mass)) * &tilt;
        let about_p1 = &(&times(&about_pivot, m) * &(&round() * &round())) + &weight;
        [Some(Rc::new(Curve::new(about_p1, m * length2 * &self.scale, 3))), pivot]
    }

    /// Where the pin's force has no moment about the pivot: the height times `1 + t²` and a positive factor, the factor, and
    /// the force.
    fn about_pivot(&self, place: usize, slides: Slide, friction: &Q) -> (Polynomial, Z, Vector) {
        let (along, corner) = (self.along(place), &self.corners[place]);
        let unit = friction.denom();
        let against = match slides {
            Slide::Down => -friction.numer(),
            Slide::Up => friction.numer().clone(),
        };
        // n ∓ μ_p u times the denominator of μ_p; n is u turned into the part
        let force = [-&along[1] * unit + &against * &along[0], &along[0] * unit + &against * &along[1]];
        let length2 = dot(&along, &along) * unit;
        let height = &times(&cross_b(corner), &length2) - &times(&cross_b(&along), &cross(corner, &force));
        (height, length2, force)
    }
}

/// Which way the pin slides along the part.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Slide {
    /// Down the part: contacts right of the vertical through the pivot.
    Down,
    /// Up the part.
    Up,
}

fn times(polynomial: &Polynomial, factor: &Z) -> Polynomial {
    polynomial * &Polynomial::new(vec![factor.clone()])
}

fn quarter_turn(vector: &mut Vector) {
    let [x, y] = vector.each_ref().map(Clone::clone);
    *vector = [y, -x];
}

fn cross(a: &Vector, b: &Vector) -> Z {
    &a[0] * &b[1] - &a[1] * &b[0]
}

fn dot(a: &Vector, b: &Vector) -> Z {
    &a[0] * &b[0] + &a[1] * &b[1]
}

/// `(1 + t²) b × v` for the direction `b = (1 - t², -2 t) / (1 + t²)` of the belt.
fn cross_b(v: &Vector) -> Polynomial {
    Polynomial::new(vec![v[1].clone(), &v[0] * 2, -&v[1]])
}

/// `(1 + t²) b · v`.
fn dot_b(v: &Vector) -> Polynomial {
    Polynomial::new(vec![v[0].clone(), &v[1] * -2, -&v[0]])
}
