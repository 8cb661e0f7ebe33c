//! Where a polynomial vanishes on an interval: doubles rule out most of it, exact arithmetic decides the rest.

use super::curve::InDoubles;
use super::height::narrowed;
use crate::exact::{Algebraic, FloatInterval, Polynomial, Q, from_float_exact};
use std::cell::Cell;
use std::cmp::Ordering;
use std::rc::Rc;

/// Counts how the signs on intervals were decided.
#[derive(Debug, Default)]
pub struct Counter {
    filtered: Cell<u64>,
    exact: Cell<u64>,
}

impl Counter {
    /// Decisions by intervals of doubles.
    #[must_use]
    pub fn n_filtered(&self) -> u64 {
        self.filtered.get()
    }

    /// Decisions by exact arithmetic.
    #[must_use]
    pub fn n_exact(&self) -> u64 {
        self.exact.get()
    }

    fn count(&self, is_exact: bool) {
        let counter = if is_exact { &self.exact } else { &self.filtered };
        counter.set(counter.get() + 1);
    }
}

/// Turns from `from` to `to`.
#[derive(Debug, Clone)]
pub(super) struct Span {
    pub(super) from: Rc<Algebraic>,
    pub(super) to: Rc<Algebraic>,
}

/// Times a piece is halved before doubles give up on it.
const HALVINGS: u32 = 7;

impl Span {
    /// The sign that a polynomial has on all of the span, ends included, if doubles can tell.
    pub(super) fn sign(&self, polynomial: &Polynomial, counter: &Counter) -> Option<Ordering> {
        let in_doubles = InDoubles::of(polynomial);
        let mut sign = None;
        let is_plain = each_piece(self.ends(), &mut |piece, is_last| {
            let found = in_doubles.on(piece).sign().filter(|found| sign.is_none_or(|sign| sign == *found));
            if found.is_some() {
                sign = found;
            }
            match found {
                Some(_) => Verdict::Known,
                None if is_last => Verdict::Stop,
                None => Verdict::Halve,
            }
        });
        if is_plain {
            counter.count(false);
            return sign;
        }
        None
    }

    /// The roots strictly inside, ascending.
    pub(super) fn roots(&self, polynomial: &Polynomial, counter: &Counter) -> Vec<Rc<Algebraic>> {
        let in_doubles = InDoubles::of(polynomial);
        let mut doubtful: Vec<[f64; 2]> = Vec::new();
        each_piece(self.ends(), &mut |piece, is_last| {
            let is_known = in_doubles.on(piece).sign().is_some_and(Ordering::is_ne);
            if !is_known && is_last {
                let [low, high] = piece.ends();
                match doubtful.last_mut() {
                    Some(last) if last[1] >= low => last[1] = high,
                    _ => doubtful.push([low, high]),
                }
            }
            if is_known || is_last { Verdict::Known } else { Verdict::Halve }
        });
        counter.count(!doubtful.is_empty());
        let exact = |end: f64| from_float_exact(end).expect("pieces have finite ends");
        let roots = doubtful.into_iter().filter_map(|[low, high]| polynomial.real_roots(exact(low)..=exact(high)));
        roots.flatten().filter(|root| *root > *self.from && *root < *self.to).map(narrowed).collect()
    }

    /// What both spans have in common.
    pub(super) fn within(&self, other: &Self) -> Self {
        self.since(&other.from).until(&other.to)
    }

    /// The part up to a turn.
    pub(super) fn until(&self, turn: &Rc<Algebraic>) -> Self {
        let is_within = order(&self.to, turn).is_le();
        Self { from: Rc::clone(&self.from), to: Rc::clone(if is_within { &self.to } else { turn }) }
    }

    /// The part from a turn on.
    pub(super) fn since(&self, turn: &Rc<Algebraic>) -> Self {
        let is_within = order(&self.from, turn).is_ge();
        Self { from: Rc::clone(if is_within { &self.from } else { turn }), to: Rc::clone(&self.to) }
    }

    /// Whether there is nothing between the ends.
    pub(super) fn is_empty(&self) -> bool {
        order(&self.from, &self.to).is_ge()
    }

    /// Some rational strictly inside.
    pub(super) fn sample(&self) -> Q {
        self.from.before(&self.to).expect("a span is not empty")
    }

    fn ends(&self) -> [f64; 2] {
        let [low, _] = self.from.bounds();
        let [_, high] = self.to.bounds();
        let [least, _] = FloatInterval::of_rational(&low).ends();
        let [_, greatest] = FloatInterval::of_rational(&high).ends();
        [least, greatest]
    }
}

/// The order of two turns, most of which are known by where they are kept.
pub(super) fn order(one: &Rc<Algebraic>, other: &Rc<Algebraic>) -> Ordering {
    if Rc::ptr_eq(one, other) { Ordering::Equal } else { one.cmp(other) }
}

enum Verdict {
    Known,
    Halve,
    Stop,
}

/// Shows pieces to `judge` in ascending order, halves of those that it wants halved; `false` if it stopped.
fn each_piece(ends: [f64; 2], judge: &mut dyn FnMut(FloatInterval, bool) -> Verdict) -> bool {
    let mut open = vec![(ends, HALVINGS)];
    while let Some(([low, high], left)) = open.pop() {
        match judge(FloatInterval::from_ends(low, high), left == 0) {
            Verdict::Known => {}
            Verdict::Stop => return false,
            Verdict::Halve => {
                let middle = f64::midpoint(low, high);
                open.push(([middle, high], left - 1));
                open.push(([low, middle], left - 1));
            }
        }
    }
    true
}
