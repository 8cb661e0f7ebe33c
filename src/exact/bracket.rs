//! A simple root between two rationals, and how to narrow them.

use super::{Polynomial, Q, Z};
use num_integer::Integer as _;
use num_traits::{One as _, Signed as _, ToPrimitive as _, Zero as _};
use std::cmp::Ordering;

/// An open interval in which a square-free polynomial has exactly one root.
#[derive(Debug, Clone)]
pub(super) struct Bracket {
    polynomial: Polynomial,
    ends: [Q; 2],
    /// Of the polynomial at the lower end and up to the root; never zero.
    sign_below: Ordering,
}

impl Bracket {
    /// The one root of the square-free `polynomial` between the ends, which are no roots themselves.
    pub(super) fn new(polynomial: Polynomial, ends: [Q; 2]) -> Self {
        let sign_below = polynomial.sign_at(&ends[0]);
        debug_assert!(sign_below.is_ne() && polynomial.sign_at(&ends[1]) == sign_below.reverse());
        Self { polynomial, ends, sign_below }
    }

    pub(super) fn polynomial(&self) -> &Polynomial {
        &self.polynomial
    }

    pub(super) fn ends(&self) -> &[Q; 2] {
        &self.ends
    }

    /// The root compared with `x`.
    pub(super) fn compare(&self, x: &Q) -> Ordering {
        if x <= &self.ends[0] {
            return Ordering::Greater;
        }
        if x >= &self.ends[1] {
            return Ordering::Less;
        }
        match self.polynomial.sign_at(x) {
            Ordering::Equal => Ordering::Equal,
            sign if sign == self.sign_below => Ordering::Greater,
            _ => Ordering::Less,
        }
    }

    /// Replaces an end by zero if zero is inside; `side` is how the root compares with it, never equal.
    pub(super) fn cut_at_zero(&mut self, side: Ordering) {
        let [low, high] = &mut self.ends;
        if low.is_negative() && high.is_positive() {
            let end = if side.is_gt() { low } else { high };
            *end = Q::zero();
        }
    }

    /// Brings the ends to at most `width` apart; returns the root instead if it is met on the way.
    ///
    /// Quadratic interval refinement: a secant proposes one of `2^bits` equal parts; if the signs confirm it, the next
    /// proposal is among the square of as many, otherwise among the root of as many, down to bisection. Confirmed parts
    /// and bisections at least halve the interval and only finitely many refuted ones lie between them, so this ends.
    ///
    /// # Source
    /// Abbott, "Quadratic interval refinement for real roots" (2006), ACM Commun. Comput. Algebra 48 (2014).
    pub(super) fn narrow(&mut self, width: &Q) -> Option<Q> {
        debug_assert!(width.is_positive(), "an interval cannot be narrowed to nothing");
        let mut search = Search::new(self);
        let mut bits = 1;
        loop {
            let missing = search.halvings(width);
            if missing == 0 {
                break;
            }
            bits = bits.min(missing);
            match search.step(&self.polynomial, bits) {
                Step::Confirmed => bits *= 2,
                Step::Refuted => bits /= 2,
                Step::Root(root) => return Some(root),
            }
        }
        self.ends = search.ends();
        None
    }
}

/// Both ends over a common denominator, with the values there times `denominator^degree`.
struct Search {
    low: Z,
    high: Z,
    denominator: Z,
    at_low: Z,
    at_high: Z,
    degree: usize,
}

enum Step {
    Confirmed,
    Refuted,
    Root(Q),
}

impl Search {
    fn new(bracket: &Bracket) -> Self {
        let Bracket { polynomial, ends: [low, high], .. } = bracket;
        let denominator = low.denom().lcm(high.denom());
        let over = |end: &Q| end.numer() * (&denominator / end.denom());
        let (low, high) = (over(low), over(high));
        let at_low = polynomial.homogeneous(&low, &denominator);
        let at_high = polynomial.homogeneous(&high, &denominator);
        let degree = polynomial.degree().unwrap_or_default();
        Self { low, high, denominator, at_low, at_high, degree }
    }

    /// How often the interval must be halved to be at most `width` wide.
    fn halvings(&self, width: &Q) -> u64 {
        let ours = (&self.high - &self.low) * width.denom();
        let asked = &self.denominator * width.numer();
        let least = ours.bits().saturating_sub(asked.bits());
        if asked << least >= ours { least } else { least + 1 }
    }

    /// Keeps the part among `2^bits` that a secant proposes if the signs confirm it, else what they say.
    fn step(&mut self, polynomial: &Polynomial, bits: u64) -> Step {
        self.refine_grid(bits);
        let part = (&self.high - &self.low) >> bits;
        let index = if bits == 1 { Z::one() } else { self.secant(bits) };
        let middle = &self.low + &index * &part;
        let at_middle = polynomial.homogeneous(&middle, &self.denominator);
        if at_middle.is_zero() {
            return Step::Root(Q::new(middle, self.denominator.clone()));
        }
        let root_is_above = at_middle.sign() == self.at_low.sign();
        self.cut(middle, at_middle, root_is_above);
        if bits == 1 {
            return Step::Confirmed;
        }
        let neighbour = if root_is_above { &self.low + &part } else { &self.high - &part };
        let at_neighbour = polynomial.homogeneous(&neighbour, &self.denominator);
        if at_neighbour.is_zero() {
            return Step::Root(Q::new(neighbour, self.denominator.clone()));
        }
        let confirmed = (at_neighbour.sign() == self.at_low.sign()) != root_is_above;
        let root_is_above = at_neighbour.sign() == self.at_low.sign();
        self.cut(neighbour, at_neighbour, root_is_above);
        if confirmed { Step::Confirmed } else { Step::Refuted }
    }

    /// Multiplies the common denominator by `2^bits`.
    fn refine_grid(&mut self, bits: u64) {
        for number in [&mut self.low, &mut self.high, &mut self.denominator] {
            *number <<= bits;
        }
        let power = bits * self.degree.to_u64().expect("degrees fit 64 bits");
        self.at_low <<= power;
        self.at_high <<= power;
    }

    /// The grid point nearest to where the chord vanishes, strictly between the ends.
    fn secant(&self, bits: u64) -> Z {
        let parts = Z::one() << bits;
        let rise = self.at_low.abs() + self.at_high.abs();
        let nearest = ((self.at_low.abs() << (bits + 1)) + &rise) / (rise << 1_u32);
        nearest.clamp(Z::one(), parts - 1)
    }

    /// Makes `x` the lower end if the root is above it, else the upper end.
    fn cut(&mut self, x: Z, value: Z, root_is_above: bool) {
        if root_is_above {
            (self.low, self.at_low) = (x, value);
        } else {
            (self.high, self.at_high) = (x, value);
        }
    }

    fn ends(self) -> [Q; 2] {
        [Q::new(self.low, self.denominator.clone()), Q::new(self.high, self.denominator)]
    }
}
