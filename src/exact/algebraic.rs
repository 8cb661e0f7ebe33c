//! Real algebraic numbers: rationals, and simple roots of integer polynomials between two rationals.

use super::bracket::Bracket;
use super::{Polynomial, Q, Z, approximate, ratio, to_f64};
use num_traits::{One as _, Signed as _, Zero as _};
use std::cmp::Ordering;

/// A real root of a polynomial, or a rational.
///
/// Comparisons are exact, also where two different polynomials share the root. A root may be rational without its form
/// showing it; [`Algebraic::rational`] decides.
///
/// # Examples
/// ```
/// use partplan::exact::{Polynomial, ratio};
/// let golden = Polynomial::from([-1, -1, 1]).real_roots(ratio(0, 1)..).unwrap().remove(0);
/// assert!(golden > ratio(1_618, 1_000) && golden < ratio(1_619, 1_000));
/// assert_eq!(golden.rational(), None);
/// ```
#[derive(Debug, Clone)]
pub struct Algebraic {
    form: Form,
}

#[derive(Debug, Clone)]
enum Form {
    Rational(Q),
    Root(Bracket),
}

impl From<Q> for Algebraic {
    fn from(value: Q) -> Self {
        Self { form: Form::Rational(value) }
    }
}

impl Algebraic {
    /// A primitive square-free polynomial that is zero here; linear only if the number is known to be rational.
    #[must_use]
    pub fn polynomial(&self) -> Polynomial {
        match &self.form {
            Form::Rational(value) => Polynomial::vanishing_at(value),
            Form::Root(bracket) => bracket.polynomial().clone(),
        }
    }

    /// Rationals at most `width` apart, the number strictly between them, or both equal to it.
    ///
    /// # Panics
    /// If `width` is not positive.
    #[must_use]
    pub fn enclosure(&self, width: &Q) -> [Q; 2] {
        self.refined(width).bounds()
    }

    /// The bounds known so far: [`Algebraic::enclosure`] for some width.
    #[must_use]
    pub fn bounds(&self) -> [Q; 2] {
        match &self.form {
            Form::Rational(value) => [value.clone(), value.clone()],
            Form::Root(bracket) => bracket.ends().clone(),
        }
    }

    /// Narrows [`Algebraic::bounds`] to `width`, so that later comparisons start from there.
    ///
    /// # Panics
    /// If `width` is not positive.
    pub fn refine(&mut self, width: &Q) {
        assert!(width.is_positive(), "an enclosure needs a positive width");
        if let Form::Root(bracket) = &mut self.form
            && let Some(root) = bracket.narrow(width)
        {
            self.form = Form::Rational(root);
        }
    }

    /// The number as a rational if it is one, whatever the degree of its polynomial.
    ///
    /// The leading coefficient of an integer polynomial times a rational root is an integer: one candidate is left when
    /// the bounds are close enough.
    #[must_use]
    pub fn rational(&self) -> Option<Q> {
        let leading = self.polynomial().leading().map(Z::abs).unwrap_or_default();
        match self.refined(&Q::new(Z::one(), leading.clone())).form {
            Form::Rational(value) => Some(value),
            Form::Root(bracket) => {
                let candidate = ((&bracket.ends()[0] * &leading).floor() + Q::one()) / leading;
                bracket.compare(&candidate).is_eq().then_some(candidate)
            }
        }
    }

    /// The sign of `polynomial` here, as a comparison with zero.
    #[must_use]
    pub fn sign_of(&self, polynomial: &Polynomial) -> Ordering {
        self.sign_after(polynomial, 4)
    }

    /// A rational strictly between this number and a greater one, with a short denominator for the room that there is;
    /// `None` if `greater` is not greater.
    ///
    /// # Examples
    /// ```
    /// use partplan::exact::{Polynomial, ratio};
    /// let roots = Polynomial::from([-2, 0, 1]).real_roots(..).unwrap();
    /// assert_eq!(roots[0].before(&roots[1]), Some(ratio(0, 1)));
    /// assert_eq!(roots[1].before(&roots[0]), None);
    /// ```
    #[must_use]
    pub fn before(&self, greater: &Self) -> Option<Q> {
        if self >= greater {
            return None;
        }
        let (mut a, mut b) = (self.clone(), greater.clone());
        // bounds of different numbers part
        loop {
            let ([_, low], [high, _]) = (a.bounds(), b.bounds());
            if low < high {
                let width = &high - &low;
                return Some(approximate(&((low + high) * ratio(1, 2)), &(width * ratio(1, 4))));
            }
            (a, b) = (a.halved(4), b.halved(4));
        }
    }

    /// A double within one unit in the last place, for pictures and decimal views only.
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        let mut number = self.clone();
        // no bracket holds zero, but one may touch it
        loop {
            let [low, high] = number.bounds();
            let near = low.abs().min(high.abs());
            let width = near / Q::from(Z::one() << 60_u32);
            if &high - &low <= width {
                return to_f64(&((low + high) * ratio(1, 2)));
            }
            number = if width.is_zero() { number.halved(8) } else { number.refined(&width) };
        }
    }
}

/// The step of narrowing before which a common divisor is worth computing: most decisions fall earlier.
const WORTH_A_DIVISOR: u32 = 16;

impl Algebraic {
    /// The root in a bracket that is cut at zero, so that widths relative to the root can be reached; a rational if the
    /// root is zero or the polynomial linear.
    pub(super) fn bracketed(mut bracket: Bracket) -> Self {
        if let [constant, slope] = bracket.polynomial().coefficients() {
            return Q::new(-constant, slope.clone()).into();
        }
        match bracket.compare(&Q::zero()) {
            Ordering::Equal => Q::zero().into(),
            side => {
                bracket.cut_at_zero(side);
                Self { form: Form::Root(bracket) }
            }
        }
    }

    fn refined(&self, width: &Q) -> Self {
        let mut number = self.clone();
        number.refine(width);
        number
    }

    /// The same number with the width of its bounds divided by `2^bits`.
    pub(super) fn halved(&self, bits: u32) -> Self {
        if let Form::Root(bracket) = &self.form {
            let [low, high] = bracket.ends();
            return self.refined(&((high - low) / Q::from(Z::one() << bits)));
        }
        self.clone()
    }

    /// Halves the bounds ever more often: what is not zero is on one side of zero once they are close.
    fn sign_after(&self, polynomial: &Polynomial, bits: u32) -> Ordering {
        let [low, high] = polynomial.range_on(&self.bounds());
        let sign = low.cmp(&Q::zero());
        if sign == high.cmp(&Q::zero()) {
            return sign;
        }
        if bits == WORTH_A_DIVISOR && self.is_root_of(polynomial) {
            return Ordering::Equal;
        }
        self.halved(bits).sign_after(polynomial, 2 * bits)
    }

    /// Whether the factor shared with the own polynomial has its root here; it is not zero on the ends.
    fn is_root_of(&self, polynomial: &Polynomial) -> bool {
        match &self.form {
            Form::Rational(value) => polynomial.sign_at(value).is_eq(),
            Form::Root(bracket) => {
                let [low, high] = bracket.ends();
                has_sign_change(&bracket.polynomial().gcd(polynomial), low, high)
            }
        }
    }

    fn order(&self, value: &Q) -> Ordering {
        match &self.form {
            Form::Rational(own) => own.cmp(value),
            Form::Root(bracket) => bracket.compare(value),
        }
    }

    /// Halves the bounds ever more often: those of different numbers part once they are close.
    fn order_after(&self, other: &Self, bits: u32) -> Ordering {
        match (&self.form, &other.form) {
            (Form::Rational(value), _) => other.order(value).reverse(),
            (_, Form::Rational(value)) => self.order(value),
            (Form::Root(a), Form::Root(b)) if a.ends()[1] <= b.ends()[0] => Ordering::Less,
            (Form::Root(a), Form::Root(b)) if b.ends()[1] <= a.ends()[0] => Ordering::Greater,
            (Form::Root(a), Form::Root(b))
                if (bits == WORTH_A_DIVISOR || a.polynomial() == b.polynomial()) && are_one(a, b) =>
            {
                Ordering::Equal
            }
            _ => self.halved(bits).order_after(&other.halved(bits), 2 * bits),
        }
    }
}

fn has_sign_change(polynomial: &Polynomial, low: &Q, high: &Q) -> bool {
    polynomial.sign_at(low) != polynomial.sign_at(high)
}

/// Whether overlapping brackets hold the same root.
///
/// The common factor has at most one root between the inner ends, and none on them: a sign change is that root.
fn are_one(a: &Bracket, b: &Bracket) -> bool {
    let low = (&a.ends()[0]).max(&b.ends()[0]);
    let high = (&a.ends()[1]).min(&b.ends()[1]);
    has_sign_change(&a.polynomial().gcd(b.polynomial()), low, high)
}

impl Ord for Algebraic {
    fn cmp(&self, other: &Self) -> Ordering {
        self.order_after(other, 4)
    }
}

impl PartialOrd for Algebraic {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Algebraic {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Algebraic {}

impl PartialEq<Q> for Algebraic {
    fn eq(&self, other: &Q) -> bool {
        self.order(other).is_eq()
    }
}

impl PartialOrd<Q> for Algebraic {
    fn partial_cmp(&self, other: &Q) -> Option<Ordering> {
        Some(self.order(other))
    }
}
