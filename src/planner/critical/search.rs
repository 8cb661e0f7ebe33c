//! Up to which factor something holds that, once lost, stays lost.

use crate::exact::{Algebraic, Polynomial, Q, Z, approximate, ratio};
use num_traits::{One as _, Zero as _};

/// A condition on the factor that holds up to some factor and at none beyond.
pub(super) trait Falling {
    /// Whether it holds at `factor`.
    fn holds(&self, factor: &Q) -> bool;

    /// Different polynomials of which one is zero at every factor above `low` and at most `high` at which it may be lost.
    fn events(&self, low: &Q, high: &Q) -> Vec<Polynomial>;

    /// A factor beyond which nothing changes any more.
    fn beyond_all(&self) -> Q;
}

/// Where a condition is lost: it holds below a factor and not above.
#[derive(Debug)]
pub(super) struct Loss {
    pub(super) factor: Algebraic,
    /// A factor where it holds, with no event above it and below the other; the same if it is lost there, which only a
    /// rational can be.
    pub(super) before: Q,
}

/// Events are looked for once the bracket is this narrow, relative to its end.
const FIRST_LOOK: i64 = 512;

/// More events than this are left for a bracket this many times narrower, unless that leaves as many.
const MANY: usize = 8;
const NARROWER: i64 = 16;

/// Where `condition` is lost, which holds at `low` and, if it is given, not at `high`; `None` if it never is.
///
/// Exact tests narrow the bracket until few events are left in it, whose real roots are the only factors in question;
/// exact tests between these single one out.
pub(super) fn lost(condition: &impl Falling, low: Q, high: Option<Q>) -> Option<Loss> {
    let [mut low, mut high] = bracket(condition, low, high)?;
    let smallest = ratio(1, 1 << 24);
    let mut look = ratio(1, FIRST_LOOK);
    let mut last = usize::MAX;
    loop {
        while &high - &low > &high * &look && high > smallest {
            let middle = middle(&low, &high);
            if condition.holds(&middle) { low = middle } else { high = middle }
        }
        let events = condition.events(&low, &high);
        if events.len() <= MANY || events.len() == last {
            return Some(single_out(condition, &low, &high, &events));
        }
        last = events.len();
        look /= ratio(NARROWER, 1);
    }
}

/// Ends where the condition holds and where it does not, the latter positive; `None` if it is never lost.
fn bracket(condition: &impl Falling, mut low: Q, high: Option<Q>) -> Option<[Q; 2]> {
    let Some(high) = high else {
        let mut step = ratio(2, 1);
        let unit = if low.is_zero() { Q::one() } else { low.clone() };
        for _ in 0..5 {
            let next = &unit * &step;
            if !condition.holds(&next) {
                return Some([low, next]);
            }
            low = next;
            step = &step * &step;
        }
        let last = condition.beyond_all().max(&low + Q::one());
        return (!condition.holds(&last)).then_some([low, last]);
    };
    Some([low, high])
}

/// The root at which the condition, which holds at `low` but not at `high`, is lost.
fn single_out(condition: &impl Falling, low: &Q, high: &Q, events: &[Polynomial]) -> Loss {
    let range = (std::ops::Bound::Excluded(low.clone()), std::ops::Bound::Included(high.clone()));
    let mut roots: Vec<Algebraic> =
        events.iter().filter_map(|event| event.real_roots(range.clone())).flatten().collect();
    // of several polynomials the simplest speaks for a root
    roots.sort_by(|a, b| a.cmp(b).then_with(|| a.polynomial().degree().cmp(&b.polynomial().degree())));
    roots.dedup();
    // it holds at `low` and just above as far as the first root, unless it is lost at `low` itself
    let (mut held, mut gone, mut before) = (0, roots.len() + 1, low.clone());
    while gone - held > 1 {
        let middle = usize::midpoint(held, gone);
        let last = if middle == 1 { Algebraic::from(low.clone()) } else { roots[middle - 2].clone() };
        let between = last.before(&roots[middle - 1]).expect("different roots in ascending order, above `low`");
        if condition.holds(&between) { (held, before) = (middle, between) } else { gone = middle }
    }
    let factor = if held == 0 { low.clone().into() } else { roots[held - 1].clone() };
    Loss { factor, before }
}

/// A short rational between two ends, by their logarithms where these are far apart.
fn middle(low: &Q, high: &Q) -> Q {
    if low.is_zero() {
        return if *high < Q::one() { high * high * ratio(1, 2) } else { high * ratio(1, 2) };
    }
    let octaves = (high / low).to_integer().bits();
    if octaves > 3 { low * Q::from(Z::one() << (octaves / 2)) } else { between(low, high) }
}

/// A short rational below a positive number, so near that no search between them needs to narrow them first.
pub(super) fn below(number: &Algebraic) -> Q {
    let low = near(number)[0].clone();
    between(&(&low * (Q::one() - ratio(1, 4 * FIRST_LOOK))), &low)
}

/// A short rational above a positive number, as near.
pub(super) fn above(number: &Algebraic) -> Q {
    let high = near(number)[1].clone();
    between(&high, &(&high * (Q::one() + ratio(1, 4 * FIRST_LOOK))))
}

fn near(number: &Algebraic) -> [Q; 2] {
    let [_, high] = number.bounds();
    number.enclosure(&(high * ratio(1, 8 * FIRST_LOOK)))
}

/// A rational with a short numerator and denominator in the middle half of an interval.
fn between(low: &Q, high: &Q) -> Q {
    let width = high - low;
    approximate(&(low + &width * ratio(1, 2)), &(width * ratio(1, 4)))
}
