//! Heights as functions of the turn of a part, in `t = tan(angle / 2)`.

use crate::exact::{Algebraic, FloatInterval, Polynomial, Z};
use std::cmp::Ordering;

/// The rational function `numerator / (scale (1 + t²)^power lean)`, its denominator positive wherever it is used.
#[derive(Debug)]
pub(super) struct Curve {
    numerator: Polynomial,
    scale: Z,
    power: u32,
    lean: Polynomial,
    in_doubles: [InDoubles; 2],
}

impl Curve {
    /// `scale` is positive.
    pub(super) fn new(numerator: Polynomial, scale: Z, power: u32) -> Self {
        Self::leaning(numerator, scale, power, Polynomial::from([1]))
    }

    /// With another factor of the denominator.
    pub(super) fn leaning(numerator: Polynomial, scale: Z, power: u32, lean: Polynomial) -> Self {
        let denominator = denominator(&scale, power, &lean);
        let in_doubles = [InDoubles::of(&numerator), InDoubles::of(&denominator)];
        Self { numerator, scale, power, lean, in_doubles }
    }

    /// A polynomial with the sign of this curve less `other`.
    pub(super) fn less(&self, other: &Self) -> Polynomial {
        let power = self.power.max(other.power);
        let term = |one: &Self, other: &Self| {
            let factor = denominator(&other.scale, power - one.power, &other.lean);
            &one.numerator * &factor
        };
        &term(self, other) - &term(other, self)
    }

    /// A polynomial with the sign of the derivative by `t`.
    pub(super) fn slope(&self) -> Polynomial {
        let numerator = &(&self.numerator.derivative() * &self.lean) - &(&self.numerator * &self.lean.derivative());
        let growth = &numerator * &round();
        let decline = Polynomial::new(vec![Z::from(0), Z::from(2 * self.power)]);
        &growth - &(&(&decline * &self.numerator) * &self.lean)
    }

    /// The exact height at `t`.
    pub(super) fn at(&self, t: &Algebraic) -> Algebraic {
        let denominator = denominator(&self.scale, self.power, &self.lean);
        t.apply(&self.numerator, &denominator).expect("the denominator is positive where a curve is used")
    }

    /// Whether the height is zero throughout.
    pub(super) fn is_zero(&self) -> bool {
        self.numerator.is_zero()
    }

    /// The sign of the height at `t`.
    pub(super) fn sign_at(&self, t: &Algebraic) -> Ordering {
        t.sign_of(&self.numerator)
    }

    /// An interval that holds the heights at all of `t`.
    pub(super) fn near(&self, t: FloatInterval) -> FloatInterval {
        let [numerator, denominator] = &self.in_doubles;
        numerator.on(t) / denominator.on(t)
    }

    /// The factor of the denominator that may be zero at an end of where the curve is used.
    pub(super) fn lean(&self) -> &Polynomial {
        &self.lean
    }

    /// Whether both are the same function in the same form.
    pub(super) fn is(&self, other: &Self) -> bool {
        std::ptr::eq(self, other)
            || (self.power == other.power
                && self.lean == other.lean
                && self.scale == other.scale
                && self.numerator == other.numerator)
    }
}

/// `1 + t²`.
pub(super) fn round() -> Polynomial {
    Polynomial::from([1, 0, 1])
}

fn denominator(scale: &Z, power: u32, lean: &Polynomial) -> Polynomial {
    let scaled = lean * &Polynomial::new(vec![scale.clone()]);
    (0..power).fold(scaled, |product, _| &product * &round())
}

/// A polynomial with coefficients in intervals of doubles.
#[derive(Debug)]
pub(super) struct InDoubles(Vec<FloatInterval>);

impl InDoubles {
    pub(super) fn of(polynomial: &Polynomial) -> Self {
        Self(polynomial.coefficients().iter().map(FloatInterval::of_integer).collect())
    }

    /// An interval that holds all values on `t`.
    pub(super) fn on(&self, t: FloatInterval) -> FloatInterval {
        let zero = FloatInterval::of_integer(&Z::from(0));
        self.0.iter().rev().fold(zero, |value, coefficient| value * t + *coefficient)
    }
}
