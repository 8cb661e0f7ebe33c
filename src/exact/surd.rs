//! Numbers a + b √n with rational a, b and n: lengths and heights over an edge of a polygon.

use super::{FloatInterval, Q, Z, to_f64};
use num_traits::{One as _, Signed as _, Zero as _};
use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// The number a + b √n; n is kept as it was given, and is zero where the number is rational.
///
/// Any two are compared exactly; only those of one n, or rational ones, are added, multiplied or divided.
///
/// # Examples
/// ```
/// use partplan::exact::{Surd, ratio};
/// let root = |n| Surd::new(ratio(0, 1), ratio(1, 1), ratio(n, 1));
/// assert_eq!(root(9).rational(), Some(&ratio(3, 1)));
/// assert_eq!(&root(2) * &root(2), Surd::from(ratio(2, 1)));
/// assert!(root(2) < root(3) && root(3) < Surd::from(ratio(7, 4)));
/// ```
#[derive(Debug, Clone)]
pub struct Surd {
    a: Q,
    b: Q,
    n: Q,
}

impl Surd {
    /// a + b √n.
    ///
    /// # Panics
    /// If n is negative.
    #[must_use]
    pub fn new(a: Q, b: Q, n: Q) -> Self {
        assert!(!n.is_negative(), "a root is of a number that is not negative");
        if b.is_zero() || n.is_zero() {
            return Self::from(a);
        }
        match rational_root(&n) {
            Some(root) => Self::from(a + b * root),
            None => Self { a, b, n },
        }
    }

    /// The number, if it is rational.
    #[must_use]
    pub fn rational(&self) -> Option<&Q> {
        self.b.is_zero().then_some(&self.a)
    }

    /// a, b and n.
    #[must_use]
    pub fn parts(&self) -> [&Q; 3] {
        [&self.a, &self.b, &self.n]
    }

    /// The sign, as a comparison with zero.
    #[must_use]
    pub fn sign(&self) -> Ordering {
        sign(&self.a, &self.b, &self.n)
    }

    /// The absolute value.
    #[must_use]
    pub fn abs(self) -> Self {
        if self.sign().is_lt() { -&self } else { self }
    }

    /// The double next to it, up to some units in the last place; for pictures and decimal views.
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        let [low, high] = self.enclosure().ends();
        if self.b.is_zero() { to_f64(&self.a) } else { 0.5 * (low + high) }
    }

    /// Doubles around it, some units in the last place apart.
    #[must_use]
    pub fn enclosure(&self) -> FloatInterval {
        let (a, b, n) = (&self.a, &self.b, &self.n);
        if b.is_zero() {
            return FloatInterval::of_rational(a);
        }
        let root = FloatInterval::of_rational(&(b * b * n)).sqrt();
        let root = if b.is_negative() { -root } else { root };
        let a_near = FloatInterval::of_rational(a);
        if a.is_zero() || a.is_negative() == b.is_negative() {
            a_near + root
        } else {
            // (a² - b² n) / (a - b √n), without cancellation
            FloatInterval::of_rational(&(a * a - b * b * n)) / (a_near - root)
        }
    }

    /// Rationals around it, at most `width` apart.
    ///
    /// # Panics
    /// If `width` is not positive.
    #[must_use]
    pub fn between(&self, width: &Q) -> [Q; 2] {
        assert!(width.is_positive(), "numbers between bounds need some room");
        if self.b.is_zero() {
            return [self.a.clone(), self.a.clone()];
        }
        let square = &self.b * &self.b * &self.n;
        // √(p / q) = √(p q s²) / (q s), rounded down and up
        let scale = (Q::one() / width / Q::from(square.denom().clone())).ceil().to_integer().max(Z::one());
        let floor = (square.numer() * square.denom() * &scale * &scale).sqrt();
        let unit = Q::from(square.denom() * scale);
        let [low, high] = [Q::from(floor.clone()) / &unit, Q::from(floor + 1) / unit];
        if self.b.is_negative() { [&self.a - high, &self.a - low] } else { [&self.a + low, &self.a + high] }
    }

    fn of_field(&self, other: &Self) -> Q {
        assert!(self.b.is_zero() || other.b.is_zero() || self.n == other.n, "numbers of two fields are not combined");
        if self.b.is_zero() { other.n.clone() } else { self.n.clone() }
    }
}

/// √n, if it is rational.
fn rational_root(n: &Q) -> Option<Q> {
    let [numerator, denominator] = [n.numer(), n.denom()].map(|part| (part, part.sqrt()));
    let is_square = |(part, root): &(&Z, Z)| *part == &(root * root);
    (is_square(&numerator) && is_square(&denominator)).then(|| Q::new(numerator.1, denominator.1))
}

/// Sign of a + b √n.
fn sign(a: &Q, b: &Q, n: &Q) -> Ordering {
    let (of_a, of_b) = (a.cmp(&Q::zero()), if n.is_zero() { Ordering::Equal } else { b.cmp(&Q::zero()) });
    match (of_a, of_b) {
        (of_a, of_b) if of_a == of_b || of_b.is_eq() => of_a,
        (Ordering::Equal, of_b) => of_b,
        (of_a, of_b) => match (a * a).cmp(&(b * b * n)) {
            Ordering::Greater => of_a,
            Ordering::Less => of_b,
            Ordering::Equal => Ordering::Equal,
        },
    }
}

impl From<Q> for Surd {
    fn from(a: Q) -> Self {
        Self { a, b: Q::zero(), n: Q::zero() }
    }
}

impl Ord for Surd {
    /// Exact, for numbers of two fields too: signs of a + b √n + c √m by squares.
    fn cmp(&self, other: &Self) -> Ordering {
        if self.b.is_zero() || other.b.is_zero() || self.n == other.n {
            return (self - other).sign();
        }
        let (b, c) = (&self.b, -&other.b);
        let a = &self.a - &other.a;
        let squares = b * b * &self.n + &c * &c * &other.n;
        let cross = Q::from(Z::from(2)) * b * &c;
        let product = &self.n * &other.n;
        // the roots together: the longer one decides where their signs differ
        let of_roots = match (b.cmp(&Q::zero()), c.cmp(&Q::zero())) {
            (of_b, of_c) if of_b == of_c => of_b,
            (of_b, of_c) => match (b * b * &self.n).cmp(&(&c * &c * &other.n)) {
                Ordering::Greater => of_b,
                Ordering::Less => of_c,
                Ordering::Equal => Ordering::Equal,
            },
        };
        let of_a = a.cmp(&Q::zero());
        match (of_a, of_roots) {
            (of_a, of_roots) if of_a == of_roots || of_roots.is_eq() => of_a,
            (Ordering::Equal, of_roots) => of_roots,
            // a² against (b √n + c √m)²
            (of_a, of_roots) => match sign(&(&a * &a - squares), &-cross, &product) {
                Ordering::Greater => of_a,
                Ordering::Less => of_roots,
                Ordering::Equal => Ordering::Equal,
            },
        }
    }
}

/// Of values, not of spellings: √12 is 2 √3.
impl PartialEq for Surd {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Surd {}

impl PartialOrd for Surd {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Add for &Surd {
    type Output = Surd;

    fn add(self, other: Self) -> Surd {
        Surd::new(&self.a + &other.a, &self.b + &other.b, self.of_field(other))
    }
}

impl Sub for &Surd {
    type Output = Surd;

    fn sub(self, other: Self) -> Surd {
        Surd::new(&self.a - &other.a, &self.b - &other.b, self.of_field(other))
    }
}

impl Neg for &Surd {
    type Output = Surd;

    fn neg(self) -> Surd {
        Surd { a: -&self.a, b: -&self.b, n: self.n.clone() }
    }
}

impl Mul for &Surd {
    type Output = Surd;

    fn mul(self, other: Self) -> Surd {
        let n = self.of_field(other);
        Surd::new(&self.a * &other.a + &self.b * &other.b * &n, &self.a * &other.b + &self.b * &other.a, n)
    }
}

impl Div for &Surd {
    type Output = Surd;

    /// # Panics
    /// If the divisor is zero.
    fn div(self, divisor: Self) -> Surd {
        let n = self.of_field(divisor);
        let norm = &divisor.a * &divisor.a - &divisor.b * &divisor.b * &n;
        let conjugate = Surd { a: &divisor.a / &norm, b: -(&divisor.b / &norm), n: divisor.n.clone() };
        self * &conjugate
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::ratio;
    use proptest::prelude::*;

    fn surd() -> impl Strategy<Value = Surd> {
        (-40..40_i64, 1..5_i64, -40..40_i64, 1..5_i64, 0..60_i64, 1..4_i64)
            .prop_map(|(a, c, b, d, n, e)| Surd::new(ratio(a, c), ratio(b, d), ratio(n, e)))
    }

    /// Thirty digits.
    fn middle(surd: &Surd) -> Q {
        let [low, high] = surd.between(&(Q::one() / Q::from(Z::from(10).pow(60))));
        (low + high) / ratio(2, 1)
    }

    proptest! {
        /// Numbers of two fields are ordered as their first digits are, unless they are equal.
        #[test]
        fn comparison_agrees_with_digits(x in surd(), y in surd()) {
            let difference = middle(&x) - middle(&y);
            let is_close = difference.abs() < Q::one() / Q::from(Z::from(10).pow(55));
            prop_assert_eq!(x.cmp(&y), if is_close { Ordering::Equal } else { difference.cmp(&Q::zero()) });
        }

        /// Sums, products and quotients in one field are those of their digits.
        #[test]
        fn arithmetic_agrees_with_digits(x in surd(), b in -9..9_i64, a in -9..9_i64) {
            let y = Surd::new(ratio(a, 2), ratio(b, 3), x.n.clone());
            let tiny = Q::one() / Q::from(Z::from(10).pow(50));
            prop_assert!((middle(&(&x + &y)) - middle(&x) - middle(&y)).abs() < tiny);
            prop_assert!((middle(&(&x * &y)) - middle(&x) * middle(&y)).abs() < tiny);
            if y.sign().is_ne() {
                prop_assert_eq!(&(&(&x / &y) * &y), &x);
            }
        }

        /// Doubles enclose the number closely, under cancellation too.
        #[test]
        fn enclosures_hold_the_number(x in surd()) {
            let [low, high] = x.enclosure().ends();
            let near = middle(&x);
            let [from, to] = [low, high].map(|end| crate::exact::from_float_exact(end).unwrap());
            let tiny = Q::one() / Q::from(Z::from(10).pow(58));
            prop_assert!(from <= &near + &tiny && &near - &tiny <= to);
            prop_assert!(high - low <= 1e-14 * low.abs().max(high.abs()));
        }
    }

    #[test]
    fn equal_numbers_of_two_spellings_are_equal() {
        let root = |b, n| Surd::new(ratio(1, 3), ratio(b, 1), ratio(n, 1));
        assert_eq!(root(2, 3).cmp(&root(1, 12)), Ordering::Equal);
        assert_eq!(root(2, 3), root(1, 12));
        assert_ne!(root(2, 3), root(1, 13));
        assert_eq!(root(-2, 3).cmp(&root(-1, 12)), Ordering::Equal);
        assert_eq!(Surd::new(ratio(0, 1), ratio(3, 1), ratio(4, 9)), Surd::from(ratio(2, 1)));
    }
}
