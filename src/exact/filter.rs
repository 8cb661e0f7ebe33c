//! Signs of polynomials, easy ones from doubles rounded outward and all others exactly.

use super::{Algebraic, FloatInterval, Polynomial, Q};
use std::cell::Cell;
use std::cmp::Ordering;

/// Decides signs exactly, by doubles where they are certain, and counts how often they were not.
///
/// # Examples
/// ```
/// use partplan::exact::{Polynomial, SignFilter, ratio};
/// let filter = SignFilter::default();
/// let p = Polynomial::from([-2, 0, 1]);
/// assert!(filter.sign_at(&p, &ratio(3, 2)).is_gt());
/// assert!(filter.sign_of(&p, &p.real_roots(..).unwrap()[0]).is_eq());
/// assert_eq!((filter.n_settled(), filter.n_exact()), (1, 1));
/// ```
#[derive(Debug, Default)]
pub struct SignFilter {
    settled: Cell<u64>,
    exact: Cell<u64>,
}

impl SignFilter {
    /// [`Polynomial::sign_at`].
    pub fn sign_at(&self, polynomial: &Polynomial, x: &Q) -> Ordering {
        self.decide(polynomial, FloatInterval::of_rational(x), || polynomial.sign_at(x))
    }

    /// [`Algebraic::sign_of`]; the doubles see no more of the number than its bounds, so refine these before.
    pub fn sign_of(&self, polynomial: &Polynomial, number: &Algebraic) -> Ordering {
        let [low, high] = number.bounds();
        self.decide(polynomial, FloatInterval::between(&low, &high), || number.sign_of(polynomial))
    }

    /// How many signs the doubles settled.
    #[must_use]
    pub fn n_settled(&self) -> u64 {
        self.settled.get()
    }

    /// How many signs took exact arithmetic.
    #[must_use]
    pub fn n_exact(&self) -> u64 {
        self.exact.get()
    }

    fn decide(&self, polynomial: &Polynomial, x: FloatInterval, exactly: impl FnOnce() -> Ordering) -> Ordering {
        let certain = value_on(polynomial, x).sign();
        let counter = if certain.is_some() { &self.settled } else { &self.exact };
        counter.set(counter.get() + 1);
        certain.unwrap_or_else(exactly)
    }
}

/// Horner's rule.
fn value_on(polynomial: &Polynomial, x: FloatInterval) -> FloatInterval {
    let mut coefficients = polynomial.coefficients().iter().rev().map(FloatInterval::of_integer);
    let leading = coefficients.next().unwrap_or_else(|| FloatInterval::of_integer(&0.into()));
    coefficients.fold(leading, |value, coefficient| value * x + coefficient)
}
