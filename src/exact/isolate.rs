//! Isolation of the real roots of a polynomial.

use super::bracket::Bracket;
use super::{Algebraic, Polynomial, Q, Z};
use num_traits::{One as _, Zero as _};
use std::ops::{Bound, RangeBounds};

impl Polynomial {
    /// Its distinct real roots in `range`, ascending; `None` for the zero polynomial, where every number is one.
    ///
    /// `..` asks for all of them. Ends belong to the range as the range says: `low..=high` is closed,
    /// `(Bound::Excluded(low), Bound::Excluded(high))` open. Roots met while bisecting are returned as rationals.
    ///
    /// # Source
    /// Descartes' rule of signs with bisection: Collins & Akritas, "Polynomial real root isolation using Descartes' rule
    /// of signs", SYMSAC 1976.
    ///
    /// # Cost
    /// O(n²) additions at every node of the bisection tree.
    ///
    /// # Examples
    /// ```
    /// use partplan::exact::{Polynomial, ratio};
    /// let p = Polynomial::from([0, -2, 0, 1]); // x³ - 2 x
    /// assert_eq!(p.real_roots(..).unwrap().len(), 3);
    /// assert_eq!(p.real_roots(ratio(0, 1)..ratio(1, 1)).unwrap(), [ratio(0, 1)]);
    /// ```
    #[must_use]
    pub fn real_roots(&self, range: impl RangeBounds<Q>) -> Option<Vec<Algebraic>> {
        let mut simple = self.square_free();
        let bound = root_bound(&simple)?;
        let low = end(range.start_bound(), -&bound);
        let high = end(range.end_bound(), bound);
        if low > high {
            return Some(Vec::new());
        }
        let mut found = Vec::new();
        if simple.sign_at(&low).is_eq() {
            simple = without_root(&simple, &low);
            if range.contains(&low) {
                found.push(Place::Point(low.clone()));
            }
        }
        let mut last = None;
        if simple.sign_at(&high).is_eq() {
            simple = without_root(&simple, &high);
            last = range.contains(&high).then(|| Place::Point(high.clone()));
        }
        if low < high {
            bisect(&simple, &low, &(&high - &low), &mut found);
        }
        found.extend(last);
        Some(as_numbers(simple, found))
    }
}

/// Where a root is.
enum Place {
    /// At a rational.
    Point(Q),
    /// The only one between two rationals.
    Between([Q; 2]),
}

fn end(bound: Bound<&Q>, unbounded: Q) -> Q {
    match bound {
        Bound::Included(end) | Bound::Excluded(end) => end.clone(),
        Bound::Unbounded => unbounded,
    }
}

/// A power of two that is larger than every root in absolute value; `None` for the zero polynomial.
///
/// Fujiwara's bound `2 max |c_{n-i} / c_n|^{1/i}`, with lengths of numbers in place of the numbers.
fn root_bound(polynomial: &Polynomial) -> Option<Q> {
    let length = |value: &Z| i128::from(value.bits());
    let leading = length(polynomial.leading()?);
    let lower = polynomial.coefficients().iter().rev().zip(0..).skip(1).filter(|(c, _)| !c.is_zero());
    // |c_{n-i} / c_n| < 2^(length + 1 - leading)
    let exponent = lower.map(|(c, i)| (length(c) + 1 - leading + i - 1).div_euclid(i) + 1).max().unwrap_or(0);
    let power = Z::one() << exponent.unsigned_abs();
    Some(if exponent < 0 { Q::new(Z::one(), power) } else { power.into() })
}

fn without_root(polynomial: &Polynomial, root: &Q) -> Polynomial {
    polynomial
        .exact_quotient(&Polynomial::vanishing_at(root))
        .expect("a root's linear factor divides over the integers")
}

/// A part of the interval, brought onto (0, 1).
struct Node {
    /// Of a positive multiple of the polynomial, low degree first.
    coefficients: Vec<Z>,
    /// The part is `index` to `index + 1` of `2^depth`.
    index: Z,
    depth: u64,
}

/// Appends the roots in the open interval, ascending; neither of its ends is one.
///
/// On an interval so short that the two discs through its ends which Obreshkoff's theorem names hold at most one root,
/// Descartes' rule is exact. The roots of a square-free polynomial keep a least distance, so bisection ends.
fn bisect(simple: &Polynomial, low: &Q, width: &Q, found: &mut Vec<Place>) {
    let place = |index: &Z, depth: u64| low + width * Q::new(index.clone(), Z::one() << depth);
    let mut open = vec![Node { coefficients: onto_unit(simple, low, width), index: Z::zero(), depth: 0 }];
    while let Some(mut node) = open.pop() {
        if node.coefficients[0].is_zero() {
            found.push(Place::Point(place(&node.index, node.depth)));
            node.coefficients.remove(0);
        }
        match positive_roots_at_most(&node.coefficients) {
            0 => {}
            1 => found.push(Place::Between([place(&node.index, node.depth), place(&(node.index + 1), node.depth)])),
            _ => {
                let [left, right] = halves(node);
                open.push(right);
                open.push(left);
            }
        }
    }
}

/// The coefficients of a positive multiple of `p(low + width x)`.
fn onto_unit(polynomial: &Polynomial, low: &Q, width: &Q) -> Vec<Z> {
    let denominator = low.denom() * width.denom();
    let line = Polynomial::new(vec![low.numer() * width.denom(), width.numer() * low.denom()]);
    let mut power = Z::one();
    let mut value = Polynomial::default();
    for coefficient in polynomial.coefficients().iter().rev() {
        value = &(&value * &line) + &Polynomial::new(vec![coefficient * &power]);
        power *= &denominator;
    }
    value.primitive().coefficients().to_vec()
}

/// Sign changes of `(1 + x)^n q(1 / (1 + x))`: at least the number of roots of `q` in (0, 1), and equal if below two.
fn positive_roots_at_most(coefficients: &[Z]) -> usize {
    let mut transformed: Vec<Z> = coefficients.iter().rev().cloned().collect();
    shift_by_one(&mut transformed);
    let signs: Vec<bool> = transformed.iter().filter(|c| !c.is_zero()).map(|c| c > &Z::zero()).collect();
    signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
}

/// `2^n q(x / 2)` and `2^n q((x + 1) / 2)`.
fn halves(node: Node) -> [Node; 2] {
    let Node { mut coefficients, index, depth } = node;
    let degree = coefficients.len() - 1;
    for (power, coefficient) in coefficients.iter_mut().enumerate() {
        *coefficient <<= degree - power;
    }
    let mut shifted = coefficients.clone();
    shift_by_one(&mut shifted);
    let index = index << 1_u32;
    let right = Node { coefficients: shifted, index: &index + 1, depth: depth + 1 };
    [Node { coefficients, index, depth: depth + 1 }, right]
}

/// The Taylor shift `q(x + 1)`.
fn shift_by_one(coefficients: &mut [Z]) {
    for start in 0..coefficients.len() {
        for power in (start + 1..coefficients.len()).rev() {
            let (below, above) = coefficients.split_at_mut(power);
            below[power - 1] += &above[0];
        }
    }
}

/// The roots as numbers, each interval with the polynomial that all the points are divided out of.
fn as_numbers(mut simple: Polynomial, places: Vec<Place>) -> Vec<Algebraic> {
    for place in &places {
        if let Place::Point(root) = place
            && simple.sign_at(root).is_eq()
        {
            simple = without_root(&simple, root);
        }
    }
    let number = |place| match place {
        Place::Point(root) => root.into(),
        Place::Between(ends) => Algebraic::bracketed(Bracket::new(simple.clone(), ends)),
    };
    places.into_iter().map(number).collect()
}
