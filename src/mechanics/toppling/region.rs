//! Turns and heights between curves, seen from the side: the heights that occur at some turn.

use super::curve::Curve;
use super::height::Height;
use super::signs::{Counter, Span};
use crate::exact::{Algebraic, Polynomial, SignFilter};
use std::cmp::Ordering;
use std::rc::Rc;

/// All `(t, h)` with `low(t) ≤ h ≤ high(t)` for every low and high curve.
pub(super) struct Region {
    /// Positive where the pin can touch the edge.
    reach: Polynomial,
    lows: Vec<Rc<Curve>>,
    highs: Vec<Rc<Curve>>,
}

impl Region {
    /// The first curves are the heights of the edge's ends: where they meet, the edge does not face the pin.
    pub(super) fn between(lows: &[&Rc<Curve>], highs: &[&Rc<Curve>]) -> Self {
        let reach = highs[0].less(lows[0]);
        let owned = |curves: &[&Rc<Curve>]| curves.iter().map(|curve| Rc::clone(curve)).collect();
        Self { reach, lows: owned(lows), highs: owned(highs) }
    }

    /// Closed intervals of heights, one for each connected part of the region over `span`.
    pub(super) fn heights(mut self, span: &Span, signs: &Signs) -> Vec<[Height; 2]> {
        if span.is_empty() || self.is_plainly_empty(span, signs) {
            return Vec::new();
        }
        keep_extremes(&mut self.lows, Ordering::Less, span, signs);
        keep_extremes(&mut self.highs, Ordering::Greater, span, signs);
        let turns = self.turns(span, signs);
        let cells: Vec<Option<[usize; 2]>> = turns.windows(2).map(|ends| self.cell(ends, signs)).collect();
        let mut parts = Vec::new();
        let mut open: Option<[Height; 2]> = None;
        for (index, turn) in turns.iter().enumerate() {
            let before = index.checked_sub(1).and_then(|cell| cells[cell]);
            let after = cells.get(index).copied().flatten();
            // on both sides of a turn the same heights bound the region there
            if let Some([low, high]) = before.or(after) {
                let here = [Height::of(&self.lows[low], turn), Height::of(&self.highs[high], turn)];
                open = Some(match open.take() {
                    Some([least, greatest]) => {
                        let [low, high] = here;
                        [least.min(low), greatest.max(high)]
                    }
                    None => here,
                });
            }
            if after.is_none() {
                parts.extend(open.take());
                if before.is_none() {
                    parts.extend(self.touching(turn, signs));
                }
            }
        }
        parts
    }

    fn is_plainly_empty(&self, span: &Span, signs: &Signs) -> bool {
        let mut pairs = self.lows.iter().flat_map(|low| self.highs.iter().map(move |high| (low, high)));
        pairs.any(|(low, high)| span.sign(&low.less(high), &signs.counter) == Some(Ordering::Greater))
    }

    /// Where the curves meet or turn, with the ends of the span.
    fn turns(&self, span: &Span, signs: &Signs) -> Vec<Rc<Algebraic>> {
        let curves: Vec<&Rc<Curve>> = self.lows.iter().chain(&self.highs).collect();
        let mut inside: Vec<Rc<Algebraic>> = Vec::new();
        for (index, curve) in curves.iter().enumerate() {
            inside.extend(span.roots(&curve.slope(), &signs.counter));
            for other in &curves[..index] {
                inside.extend(span.roots(&curve.less(other), &signs.counter));
            }
        }
        inside.sort();
        inside.dedup();
        let ends = [Rc::clone(&span.from), Rc::clone(&span.to)];
        let [from, to] = ends;
        std::iter::once(from).chain(inside).chain([to]).collect()
    }

    /// The highest low and the lowest high curve between neighboring turns, if there is anything between them.
    fn cell(&self, ends: &[Rc<Algebraic>], signs: &Signs) -> Option<[usize; 2]> {
        let span = Span { from: Rc::clone(&ends[0]), to: Rc::clone(&ends[1]) };
        let t = span.sample();
        let sign = |one: &Curve, other: &Curve| signs.filter.sign_at(&one.less(other), &t);
        let pick = |curves: &[Rc<Curve>], wanted: Ordering| {
            let better =
                |best: usize, next: usize| if sign(&curves[next], &curves[best]) == wanted { next } else { best };
            (1..curves.len()).fold(0, better)
        };
        let (low, high) = (pick(&self.lows, Ordering::Greater), pick(&self.highs, Ordering::Less));
        sign(&self.lows[low], &self.highs[high]).is_le().then_some([low, high])
    }

    /// The height at a single turn where low and high curves touch.
    fn touching(&self, turn: &Rc<Algebraic>, signs: &Signs) -> Option<[Height; 2]> {
        let sign = |polynomial: &Polynomial| signs.filter.sign_of(polynomial, turn);
        if sign(&self.reach).is_eq() {
            return None;
        }
        let is_in = self.lows.iter().all(|low| self.highs.iter().all(|high| sign(&low.less(high)).is_le()));
        is_in.then(|| {
            let at = |curve: &Rc<Curve>| Height::of(curve, turn);
            let low = self.lows.iter().map(at).max().expect("a region has a low curve");
            let finite = self.highs.iter().filter(|high| sign(high.lean()).is_ne());
            let high = finite.map(at).min().expect("corners have finite heights");
            [low, high]
        })
    }
}

/// Decides signs and counts how.
#[derive(Debug, Default)]
pub struct Signs {
    /// On intervals of turns.
    pub counter: Counter,
    /// At single turns.
    pub filter: SignFilter,
}

/// Drops curves that compare as `idle` with another one everywhere.
fn keep_extremes(curves: &mut Vec<Rc<Curve>>, idle: Ordering, span: &Span, signs: &Signs) {
    let mut index = 0;
    while index < curves.len() {
        let is_idle = (0..curves.len()).any(|other| {
            other != index && span.sign(&curves[index].less(&curves[other]), &signs.counter) == Some(idle)
        });
        if is_idle {
            curves.remove(index);
        } else {
            index += 1;
        }
    }
}
