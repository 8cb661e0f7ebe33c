//! Heights as values of curves at real algebraic numbers, compared exactly.

use super::curve::Curve;
use crate::exact::{Algebraic, FloatInterval, Polynomial, Q, Z};
use num_traits::{One as _, Zero as _};
use std::cell::OnceCell;
use std::cmp::Ordering;
use std::rc::Rc;

/// The height of a curve at one turn of the part.
#[derive(Debug, Clone)]
pub struct Height {
    curve: Rc<Curve>,
    at: Rc<Algebraic>,
    near: FloatInterval,
    exact: Rc<OnceCell<Algebraic>>,
}

/// Bits to which the turn is known where a curve is evaluated in doubles.
const BITS: u32 = 70;

/// The number with bounds narrow enough for [`Height`].
pub(super) fn narrowed(mut number: Algebraic) -> Rc<Algebraic> {
    number.refine(&Q::new(Z::one(), Z::one() << BITS));
    Rc::new(number)
}

impl Height {
    /// The height of `curve` at `at`, where it has no pole.
    pub(super) fn of(curve: &Rc<Curve>, at: &Rc<Algebraic>) -> Self {
        let [low, high] = at.bounds();
        let near = curve.near(FloatInterval::between(&low, &high));
        Self { curve: Rc::clone(curve), at: Rc::clone(at), near, exact: Rc::default() }
    }

    /// No height.
    #[must_use]
    pub fn zero() -> Self {
        Self::rational(&Q::zero())
    }

    /// A rational height, not negative.
    #[must_use]
    pub fn rational(height: &Q) -> Self {
        let curve = Curve::new(Polynomial::new(vec![height.numer().clone()]), height.denom().clone(), 0);
        Self::of(&Rc::new(curve), &Rc::new(Q::zero().into()))
    }

    /// The number itself.
    ///
    /// # Panics
    /// Never: curves have no poles where heights are taken.
    #[must_use]
    pub fn exact(&self) -> &Algebraic {
        self.exact.get_or_init(|| self.curve.at(&self.at))
    }

    /// Near the number, for drawing.
    #[must_use]
    pub fn near(&self) -> f64 {
        let [low, high] = self.near.ends();
        f64::midpoint(low, high)
    }
}

impl Ord for Height {
    fn cmp(&self, other: &Self) -> Ordering {
        let ([low, high], [other_low, other_high]) = (self.near.ends(), other.near.ends());
        if high < other_low {
            return Ordering::Less;
        }
        if other_high < low {
            return Ordering::Greater;
        }
        let is_same = self.curve.is(&other.curve) && (Rc::ptr_eq(&self.at, &other.at) || self.at == other.at);
        if is_same {
            return Ordering::Equal;
        }
        // the pivot stays on the belt, so that comparisons with zero are many
        match (self.curve.is_zero(), other.curve.is_zero()) {
            (true, true) => Ordering::Equal,
            (false, true) => self.curve.sign_at(&self.at),
            (true, false) => other.curve.sign_at(&other.at).reverse(),
            (false, false) => self.exact().cmp(other.exact()),
        }
    }
}

impl PartialOrd for Height {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Height {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Height {}
