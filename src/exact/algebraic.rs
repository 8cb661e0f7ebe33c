//! Real algebraic numbers: rationals, and simple roots of integer polynomials between two rationals.

use super::bracket::Bracket;
use super::{Polynomial, Q, Z, ratio, to_f64};
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
    /// The root in a bracket, as a rational if its polynomial is linear or it is zero.
    pub(super) fn bracketed(bracket: Bracket) -> Self {
        if let [constant, slope] = bracket.polynomial().coefficients() {
            return Q::new(-constant, slope.clone()).into();
        }
        let mut number = Self { form: Form::Root(bracket) };
        number.keep_off_zero();
        number
    }

    /// Cuts a bracket at zero, so that widths relative to the root can be reached.
    fn keep_off_zero(&mut self) {
        let Form::Root(bracket) = &mut self.form else { return };
        match bracket.compare(&Q::zero()) {
            Ordering::Equal => self.form = Form::Rational(Q::zero()),
            side => bracket.cut_at_zero(side),
        }
    }

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
        let mut number = self.clone();
        number.refine(width);
        number.bounds()
    }

    /// The bounds that it is known by now: see [`Algebraic::enclosure`].
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

    /// Divides the width of the bounds by `2^bits`; nothing for a rational.
    fn halve(&mut self, bits: u32) {
        if let Form::Root(bracket) = &self.form {
            let [low, high] = bracket.ends();
            let width = (high - low) / Q::from(Z::one() << bits);
            self.refine(&width);
        }
    }

    /// The number as a rational if it is one, whatever the degree of its polynomial.
    ///
    /// The leading coefficient of an integer polynomial times a rational root is an integer: one candidate is left when
    /// the bounds are close enough.
    #[must_use]
    pub fn rational(&self) -> Option<Q> {
        let mut number = self.clone();
        if let Form::Root(bracket) = &self.form {
            let leading = bracket.polynomial().leading().map(Z::abs).unwrap_or_default();
            number.refine(&Q::new(Z::one(), leading.clone()));
            if let Form::Root(bracket) = &number.form {
                let above = (&bracket.ends()[0] * &leading).floor() + Q::one();
                let candidate = above / leading;
                return bracket.compare(&candidate).is_eq().then_some(candidate);
            }
        }
        match number.form {
            Form::Rational(value) => Some(value),
            Form::Root(_) => None,
        }
    }

    /// The sign of `polynomial` here.
    #[must_use]
    pub fn sign_of(&self, polynomial: &Polynomial) -> Ordering {
        if let Some(sign) = certain_sign(&polynomial.range_on(&self.bounds())) {
            return sign;
        }
        if self.is_root_of(polynomial) {
            return Ordering::Equal;
        }
        let mut number = self.clone();
        let mut bits = 2;
        // the value is not zero, so it is on one side of zero once the bounds are close
        loop {
            number.halve(bits);
            if let Some(sign) = certain_sign(&polynomial.range_on(&number.bounds())) {
                return sign;
            }
            bits *= 2;
        }
    }

    fn is_root_of(&self, polynomial: &Polynomial) -> bool {
        match &self.form {
            Form::Rational(value) => polynomial.sign_at(value).is_eq(),
            Form::Root(bracket) => {
                let [low, high] = bracket.ends();
                has_sign_change(&bracket.polynomial().gcd(polynomial), low, high)
            }
        }
    }

    /// An interval at most `width` wide that holds `numerator / denominator` at this number; `None` if the denominator
    /// is zero here.
    ///
    /// # Panics
    /// If `width` is not positive.
    #[must_use]
    pub fn image(&self, numerator: &Polynomial, denominator: &Polynomial, width: &Q) -> Option<[Q; 2]> {
        assert!(width.is_positive(), "an enclosure needs a positive width");
        let mut number = self.clone();
        if number.is_root_of(denominator) {
            return None;
        }
        let mut bits = 2;
        // the denominator is not zero, so both ranges shrink to their values
        loop {
            let bounds = number.bounds();
            let image = quotient(&numerator.range_on(&bounds), &denominator.range_on(&bounds));
            if let Some([low, high]) = image
                && &high - &low <= *width
            {
                return Some([low, high]);
            }
            number.halve(bits);
            bits *= 2;
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
            if width.is_zero() { number.halve(8) } else { number.refine(&width) }
        }
    }
}

/// The sign of every number in the interval, if it is one.
fn certain_sign([low, high]: &[Q; 2]) -> Option<Ordering> {
    let sign = low.cmp(&Q::zero());
    (sign == high.cmp(&Q::zero())).then_some(sign)
}

/// The quotients of numbers from two intervals; `None` if the divisor may be zero.
fn quotient(dividend: &[Q; 2], divisor: &[Q; 2]) -> Option<[Q; 2]> {
    certain_sign(divisor).filter(|sign| sign.is_ne())?;
    let [low, high] = divisor;
    let mut ends: Vec<Q> = dividend.iter().flat_map(|end| [end / low, end / high]).collect();
    ends.sort();
    Some([ends[0].clone(), ends[3].clone()])
}

fn has_sign_change(polynomial: &Polynomial, low: &Q, high: &Q) -> bool {
    polynomial.sign_at(low) != polynomial.sign_at(high)
}

impl Ord for Algebraic {
    /// Exact: equality is decided by a common factor, order by narrowing until the bounds part.
    fn cmp(&self, other: &Self) -> Ordering {
        let (mut a, mut b) = match (&self.form, &other.form) {
            (Form::Rational(value), _) => return other.order(value).reverse(),
            (_, Form::Rational(value)) => return self.order(value),
            _ => (self.clone(), other.clone()),
        };
        if a.meets(&b) {
            return Ordering::Equal;
        }
        let mut bits = 2;
        // the numbers differ, so their bounds part
        loop {
            let ([a_low, a_high], [b_low, b_high]) = (a.bounds(), b.bounds());
            if a_high <= b_low {
                return Ordering::Less;
            }
            if b_high <= a_low {
                return Ordering::Greater;
            }
            a.halve(bits);
            b.halve(bits);
            bits *= 2;
        }
    }
}

impl Algebraic {
    fn order(&self, value: &Q) -> Ordering {
        match &self.form {
            Form::Rational(own) => own.cmp(value),
            Form::Root(bracket) => bracket.compare(value),
        }
    }

    /// Whether both are the same root.
    ///
    /// A common factor has at most one root between the inner ends, and none on them: a sign change is that root.
    fn meets(&self, other: &Self) -> bool {
        let (Form::Root(a), Form::Root(b)) = (&self.form, &other.form) else { return false };
        let low = a.ends()[0].clone().max(b.ends()[0].clone());
        let high = a.ends()[1].clone().min(b.ends()[1].clone());
        low < high && has_sign_change(&a.polynomial().gcd(b.polynomial()), &low, &high)
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
