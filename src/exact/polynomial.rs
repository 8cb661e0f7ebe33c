//! Polynomials in one variable over the integers.

use super::{Q, Z, make_primitive, primitive_row};
use num_integer::Integer as _;
use num_traits::{One as _, Signed as _, Zero as _};
use std::cmp::Ordering;
use std::fmt;
use std::ops::{Add, Mul, Neg, Sub};

/// `c_0 + c_1 x + … + c_n x^n` with integer coefficients of any size.
///
/// # Examples
/// ```
/// use partplan::exact::{Polynomial, ratio};
/// use std::cmp::Ordering;
/// let p = Polynomial::from([-2, 0, 1]);
/// assert_eq!(p.to_string(), "x^2 - 2");
/// assert_eq!(p.sign_at(&ratio(7, 5)), Ordering::Less);
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Hash, Default)]
pub struct Polynomial {
    /// Low degree first; the last one is not zero, and zero has none.
    coefficients: Vec<Z>,
}

impl Polynomial {
    /// The polynomial with these coefficients, low degree first.
    #[must_use]
    pub fn new(mut coefficients: Vec<Z>) -> Self {
        while coefficients.last().is_some_and(Z::is_zero) {
            coefficients.pop();
        }
        Self { coefficients }
    }

    /// The primitive integer polynomial that is a positive multiple of the one with these coefficients.
    ///
    /// Signs and roots are kept, values are not: numerator and denominator of a rational function must be brought to a
    /// common factor before.
    #[must_use]
    pub fn from_rationals(coefficients: &[Q]) -> Self {
        Self::new(primitive_row(coefficients))
    }

    /// The primitive linear polynomial with this root and a positive leading coefficient.
    pub(super) fn vanishing_at(root: &Q) -> Self {
        Self { coefficients: vec![-root.numer(), root.denom().clone()] }
    }

    /// The coefficients, low degree first, the last one not zero; none for the zero polynomial.
    #[must_use]
    pub fn coefficients(&self) -> &[Z] {
        &self.coefficients
    }

    /// The degree; `None` for the zero polynomial.
    #[must_use]
    pub fn degree(&self) -> Option<usize> {
        self.coefficients.len().checked_sub(1)
    }

    /// The coefficient of the highest power; `None` for the zero polynomial.
    #[must_use]
    pub fn leading(&self) -> Option<&Z> {
        self.coefficients.last()
    }

    /// Whether it is the zero polynomial.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.coefficients.is_empty()
    }

    /// Its sign at `x`, as a comparison with zero, found without building a fraction.
    #[must_use]
    pub fn sign_at(&self, x: &Q) -> Ordering {
        self.homogeneous(x.numer(), x.denom()).cmp(&Z::zero())
    }

    /// Its value at `x`.
    #[must_use]
    pub fn at(&self, x: &Q) -> Q {
        let power = x.denom().pow(self.degree().map_or(0, exponent));
        Q::new(self.homogeneous(x.numer(), x.denom()), power)
    }

    /// `q^n p(x)` at `x = numerator / q`, by Horner's rule on the homogeneous form.
    pub(super) fn homogeneous(&self, numerator: &Z, q: &Z) -> Z {
        let mut power = Z::one();
        let mut value = Z::zero();
        for coefficient in self.coefficients.iter().rev() {
            value = value * numerator + coefficient * &power;
            power *= q;
        }
        value
    }

    /// An interval that holds every value on `[low, high]`, by Horner's rule on intervals.
    ///
    /// Its width tends to zero with that of `[low, high]`, at least in proportion.
    pub(super) fn range_on(&self, [low, high]: &[Q; 2]) -> [Q; 2] {
        let q = low.denom().lcm(high.denom());
        let (a, b) = (low.numer() * (&q / low.denom()), high.numer() * (&q / high.denom()));
        let mut power = Z::one();
        let mut range = [Z::zero(), Z::zero()];
        for (step, coefficient) in self.coefficients.iter().rev().enumerate() {
            if step > 0 {
                power *= &q;
            }
            let term = coefficient * &power;
            let mut ends = [&range[0] * &a, &range[0] * &b, &range[1] * &a, &range[1] * &b];
            ends.sort();
            let [least, .., greatest] = ends;
            range = [least + &term, greatest + term];
        }
        range.map(|end| Q::new(end, power.clone()))
    }

    /// The derivative.
    #[must_use]
    pub fn derivative(&self) -> Self {
        Self { coefficients: self.coefficients.iter().enumerate().skip(1).map(|(power, c)| c * power).collect() }
    }

    /// Divided by the greatest common divisor of its coefficients; the sign stays.
    #[must_use]
    pub fn primitive(mut self) -> Self {
        make_primitive(&mut self.coefficients);
        self
    }

    /// The quotient by `divisor` if that divides it over the integers, `None` otherwise and for a zero divisor.
    #[must_use]
    pub fn exact_quotient(&self, divisor: &Self) -> Option<Self> {
        let leading = divisor.leading()?;
        let mut rest = self.clone();
        let mut quotient = vec![Z::zero(); (self.coefficients.len() + 1).saturating_sub(divisor.coefficients.len())];
        while let Some(shift) = rest.coefficients.len().checked_sub(divisor.coefficients.len())
            && let Some(top) = rest.leading()
        {
            let (factor, remainder) = top.div_rem(leading);
            if !remainder.is_zero() {
                return None;
            }
            rest = rest.minus_shifted(divisor, &factor, shift);
            quotient[shift] = factor;
        }
        rest.is_zero().then(|| Self::new(quotient))
    }

    /// A positive multiple of the remainder by `divisor`: of lower degree, and of the same sign wherever `divisor` is zero.
    ///
    /// # Panics
    /// If `divisor` is the zero polynomial.
    #[must_use]
    pub fn pseudo_remainder(&self, divisor: &Self) -> Self {
        let leading = divisor.leading().expect("the divisor of a remainder is not zero");
        let mut rest = self.clone();
        while let Some(shift) = rest.coefficients.len().checked_sub(divisor.coefficients.len())
            && let Some(top) = rest.leading()
        {
            let common = top.gcd(leading) * leading.signum();
            let (factor, top) = (leading / &common, top / &common);
            rest.coefficients.iter_mut().for_each(|coefficient| *coefficient *= &factor);
            rest = rest.minus_shifted(divisor, &top, shift);
        }
        rest
    }

    /// `self - factor x^shift other`, where that cancels the highest power.
    fn minus_shifted(mut self, other: &Self, factor: &Z, shift: usize) -> Self {
        for (coefficient, theirs) in self.coefficients[shift..].iter_mut().zip(&other.coefficients) {
            *coefficient -= factor * theirs;
        }
        Self::new(self.coefficients)
    }

    /// The greatest common divisor over the rationals, primitive and with a positive leading coefficient.
    ///
    /// Remainders are made primitive at every step, so that coefficients stay as short as they can be. The gcd of two
    /// zero polynomials is zero.
    #[must_use]
    pub fn gcd(&self, other: &Self) -> Self {
        let (mut a, mut b) = (self.clone().primitive(), other.clone().primitive());
        // degrees of b fall at every step
        while !b.is_zero() {
            let rest = a.pseudo_remainder(&b).primitive();
            (a, b) = (b, rest);
        }
        if a.leading().is_some_and(Z::is_negative) { -a } else { a }
    }

    /// The primitive polynomial with the same roots, each of them simple, and a positive leading coefficient; zero for zero.
    #[must_use]
    pub fn square_free(&self) -> Self {
        let repeated = self.gcd(&self.derivative());
        let primitive = self.clone().primitive();
        let simple = primitive.exact_quotient(&repeated).unwrap_or_default();
        if simple.leading().is_some_and(Z::is_negative) { -simple } else { simple }
    }
}

fn exponent(degree: usize) -> u32 {
    u32::try_from(degree).expect("coefficients of a polynomial fit in memory")
}

impl<const N: usize> From<[i64; N]> for Polynomial {
    /// Coefficients low degree first.
    fn from(coefficients: [i64; N]) -> Self {
        Self::new(coefficients.map(Z::from).to_vec())
    }
}

impl Add for &Polynomial {
    type Output = Polynomial;

    fn add(self, other: Self) -> Polynomial {
        let (long, short) =
            if self.coefficients.len() < other.coefficients.len() { (other, self) } else { (self, other) };
        let mut sum = long.coefficients.clone();
        sum.iter_mut().zip(&short.coefficients).for_each(|(a, b)| *a += b);
        Polynomial::new(sum)
    }
}

impl Neg for Polynomial {
    type Output = Self;

    fn neg(mut self) -> Self {
        self.coefficients.iter_mut().for_each(|c| *c = -std::mem::take(c));
        self
    }
}

impl Sub for &Polynomial {
    type Output = Polynomial;

    fn sub(self, other: Self) -> Polynomial {
        self + &-other.clone()
    }
}

impl Mul for &Polynomial {
    type Output = Polynomial;

    fn mul(self, other: Self) -> Polynomial {
        let mut product = vec![Z::zero(); self.coefficients.len() + other.coefficients.len()];
        for (i, a) in self.coefficients.iter().enumerate() {
            for (j, b) in other.coefficients.iter().enumerate() {
                product[i + j] += a * b;
            }
        }
        Polynomial::new(product)
    }
}

impl fmt::Display for Polynomial {
    /// Powers of `x` from the highest down: `2 x^3 - x + 5`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let terms = self.coefficients.iter().enumerate().rev().filter(|(_, c)| !c.is_zero());
        for (n_written, (power, coefficient)) in terms.enumerate() {
            let sign = match (n_written, coefficient.is_negative()) {
                (0, false) => "",
                (0, true) => "-",
                (_, false) => " + ",
                (_, true) => " - ",
            };
            let size = coefficient.magnitude();
            match (power, size.is_one()) {
                (0, _) => write!(f, "{sign}{size}")?,
                (_, true) => write!(f, "{sign}")?,
                (_, false) => write!(f, "{sign}{size} ")?,
            }
            match power {
                0 => {}
                1 => write!(f, "x")?,
                _ => write!(f, "x^{power}")?,
            }
        }
        if self.is_zero() { write!(f, "0") } else { Ok(()) }
    }
}
