//! Square roots, sines and cosines of intervals of doubles.

use super::FloatInterval;
use std::f64::consts::{FRAC_2_PI, TAU};

impl FloatInterval {
    /// The circle number.
    #[must_use]
    pub fn pi() -> Self {
        // the nearest double is below π
        Self::from_ends(std::f64::consts::PI, std::f64::consts::PI.next_up())
    }

    /// Of one double.
    ///
    /// # Panics
    /// If it is not a number.
    #[must_use]
    pub fn of_double(value: f64) -> Self {
        Self::from_ends(value, value)
    }

    /// The square root of what is not negative.
    #[must_use]
    pub fn sqrt(self) -> Self {
        let [low, high] = self.ends().map(|end| end.max(0.0).sqrt());
        Self::from_ends(low.next_down().max(0.0), high.next_up())
    }

    /// The square, which is not negative.
    #[must_use]
    pub fn square(self) -> Self {
        let [low, high] = (self * self).ends();
        Self::from_ends(low.max(0.0), high)
    }

    /// Sine and cosine.
    #[must_use]
    pub fn sin_cos(self) -> [Self; 2] {
        let [low, high] = self.ends();
        let all = Self::from_ends(-1.0, 1.0);
        if !(high - low < TAU && low.abs().max(high.abs()) < LARGEST_ANGLE) {
            return [all, all];
        }
        let ((sin_low, cos_low), (sin_high, cos_high)) = (libm::sincos(low), libm::sincos(high));
        let [mut sin, mut cos] = [around(sin_low, sin_high), around(cos_low, cos_high)];
        // quarters of a turn inside, and those too close to an end to tell
        let doubt = 1e-15 * (1.0 + low.abs().max(high.abs()));
        let (first, last) = ((low * FRAC_2_PI - doubt).ceil(), (high * FRAC_2_PI + doubt).floor());
        let mut quarter = first;
        while quarter <= last {
            match quarter.rem_euclid(4.0) {
                0.0 => cos[1] = 1.0,
                1.0 => sin[1] = 1.0,
                2.0 => cos[0] = -1.0,
                _ => sin[0] = -1.0,
            }
            quarter += 1.0;
        }
        [sin, cos].map(|[low, high]| Self::from_ends(low, high))
    }

    /// The numbers in both; `None` if there are none.
    #[must_use]
    pub fn meet(self, other: Self) -> Option<Self> {
        let ([a, b], [c, d]) = (self.ends(), other.ends());
        let (low, high) = (a.max(c), b.min(d));
        (low <= high).then(|| Self::from_ends(low, high))
    }

    /// The least interval that holds both.
    #[must_use]
    pub fn join(self, other: Self) -> Self {
        let ([a, b], [c, d]) = (self.ends(), other.ends());
        Self::from_ends(a.min(c), b.max(d))
    }

    /// Whether a double is inside.
    #[must_use]
    pub fn contains(self, value: f64) -> bool {
        let [low, high] = self.ends();
        low <= value && value <= high
    }
}

/// Beyond, quarters of a turn are not told apart safely.
const LARGEST_ANGLE: f64 = 1e6;

/// Between two values that are off by less than a unit in the last place each, as `libm` promises; two are allowed.
fn around(a: f64, b: f64) -> [f64; 2] {
    [a.min(b).next_down().next_down().max(-1.0), a.max(b).next_up().next_up().min(1.0)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sines_and_cosines_of_an_interval_hold_those_of_its_points() {
        for start in -40..40 {
            for width in 0..30 {
                let (low, width) = (0.377 * f64::from(start), 0.21 * f64::from(width));
                let [sin, cos] = FloatInterval::from_ends(low, low + width).sin_cos();
                let of = |part: u32| low + width * f64::from(part) / 64.0;
                assert!((0..=64).all(|part| sin.contains(of(part).sin()) && cos.contains(of(part).cos())));
            }
        }
    }

    #[test]
    fn sines_are_tight() {
        let [sin, cos] = FloatInterval::from_ends(0.1, 0.2).sin_cos();
        assert!((sin.ends()[0] - 0.1_f64.sin()).abs() < 1e-16 && (sin.ends()[1] - 0.2_f64.sin()).abs() < 1e-16);
        assert!((cos.ends()[1] - 0.1_f64.cos()).abs() < 1e-15);
        assert_eq!(FloatInterval::from_ends(1.0, 2.0).sin_cos()[0].ends()[1], 1.0);
        assert_eq!(FloatInterval::from_ends(3.0, 3.2).sin_cos()[1].ends()[0], -1.0);
    }

    #[test]
    fn roots_and_squares_enclose() {
        let two = FloatInterval::of_double(2.0).sqrt();
        assert!(two.square().contains(2.0) && two.ends()[1] - two.ends()[0] < 1e-15);
        assert_eq!(FloatInterval::from_ends(-1.0, 2.0).square().ends()[0], 0.0);
        assert!(FloatInterval::pi().sin_cos()[0].contains(0.0));
    }
}
