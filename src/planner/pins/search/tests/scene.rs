//! Random bands of heights, and what pins in them make of sets, found by looking at every one.

use super::super::{Band, Wanted, plan};
use crate::answer::{Pin, PinPlan, Symmetry};
use crate::exact::{Q, ratio};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::select;
use std::collections::BTreeSet;

/// A set of places, by bits.
pub(super) type Mask = u32;

pub(super) type Outcome = Vec<Option<usize>>;

#[derive(Debug, Clone)]
pub(super) struct Scene {
    /// For each place the class.
    pub(super) classes: Vec<usize>,
    /// Ends, outcome, outcome at the lower end.
    pub(super) bands: Vec<(i64, i64, Outcome, Outcome)>,
}

/// What an orientation does at a pin.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Node {
    Stop,
    Go,
    Jam,
}

/// Follows every orientation down to a stop or a jam.
pub(super) fn walked(nodes: &[Node]) -> Outcome {
    let n = nodes.len();
    let walk = |from: usize| {
        let mut path = (0..n).map(|steps| (from + n - steps) % n).filter(|place| nodes[*place] != Node::Go);
        path.next().filter(|place| nodes[*place] == Node::Stop)
    };
    (0..n).map(walk).collect()
}

/// Outcomes of walks, with jams unless they are not wanted.
pub(super) fn walks(n: usize, with_jams: bool) -> impl Strategy<Value = Outcome> {
    let nodes = if with_jams {
        vec![Node::Stop, Node::Stop, Node::Go, Node::Go, Node::Jam]
    } else {
        vec![Node::Stop, Node::Go, Node::Go]
    };
    vec(select(nodes), n).prop_map(|nodes| walked(&nodes))
}

/// Any outcomes at all.
pub(super) fn anything(n: usize) -> impl Strategy<Value = Outcome> {
    vec(prop_oneof![1 => Just(None), 4 => (0..n).prop_map(Some)], n)
}

/// Bands with these outcomes, some of them next to each other and the same to some orientations.
pub(super) fn scenes(
    n: usize,
    outcome: BoxedStrategy<Outcome>,
    most_bands: usize,
    is_mixed: bool,
) -> impl Strategy<Value = Scene> {
    let classes = prop_oneof![3 => Just((0..n).collect()), 1 => vec(0..n, n).prop_map(numbered)];
    let band = (outcome, 0..=1_i64, 1..=9_i64, any::<bool>(), vec(any::<bool>(), n), vec(any::<bool>(), n));
    (classes, vec(band, 1..=most_bands)).prop_map(move |(classes, drawn)| {
        let mut bands: Vec<(i64, i64, Outcome, Outcome)> = Vec::new();
        for (outcome, gap, width, is_like, keeps, is_uncritical) in drawn {
            let below = bands.last().cloned();
            let low = below.as_ref().map_or(1, |below| below.1 + gap);
            let was = below.map(|below| below.2).unwrap_or_else(|| vec![None; outcome.len()]);
            // half of the bands do to some orientations, or to all, what the band below does
            let is_like = is_like && low > 1;
            let like = |place: usize| if is_like && (keeps[place] || !is_mixed) { was[place] } else { outcome[place] };
            let outcome: Outcome = (0..outcome.len()).map(like).collect();
            let at = |place: usize| outcome[place].filter(|to| was[place] == Some(*to) && is_uncritical[place]);
            let at_low = (0..outcome.len()).map(at).collect();
            bands.push((low, low + width, outcome, at_low));
        }
        Scene { classes, bands }
    })
}

/// Classes in the order of their first members.
fn numbered(drawn: Vec<usize>) -> Vec<usize> {
    let first = |class: usize| drawn.iter().position(|other| *other == class);
    let firsts: BTreeSet<Option<usize>> = drawn.iter().map(|class| first(*class)).collect();
    drawn.iter().map(|class| firsts.iter().position(|other| *other == first(*class)).expect("it is a first")).collect()
}

impl Scene {
    pub(super) fn n(&self) -> usize {
        self.classes.len()
    }

    /// Edges are not their places.
    pub(super) fn edge(place: usize) -> usize {
        2 * place + 1
    }

    pub(super) fn place(edge: usize) -> usize {
        (edge - 1) / 2
    }

    pub(super) fn stable(&self) -> Vec<usize> {
        (0..self.n()).map(Self::edge).collect()
    }

    pub(super) fn symmetry(&self) -> Symmetry {
        let n_classes = self.classes.iter().max().map_or(0, |last| last + 1);
        let mut classes = vec![Vec::new(); n_classes];
        self.classes.iter().enumerate().for_each(|(place, class)| classes[*class].push(Self::edge(place)));
        Symmetry { shift: 2 * self.n(), classes }
    }

    pub(super) fn given(&self) -> Vec<Band> {
        let band = |(low, high, outcome, at_low): &(i64, i64, Outcome, Outcome)| Band {
            low: ratio(*low, 1).into(),
            high: ratio(*high, 1).into(),
            outcome: outcome.clone(),
            at_low: at_low.clone(),
        };
        self.bands.iter().map(band).collect()
    }

    pub(super) fn plan(&self, wanted: &Wanted) -> PinPlan {
        plan(&self.stable(), &self.symmetry(), &self.given(), wanted, &mut || false)
    }

    pub(super) fn everything(&self) -> Mask {
        (1 << self.n()) - 1
    }

    pub(super) fn classes_in(&self, set: Mask) -> BTreeSet<usize> {
        (0..self.n()).filter(|place| set >> place & 1 == 1).map(|place| self.classes[place]).collect()
    }

    pub(super) fn is_goal(&self, set: Mask, end: Option<usize>) -> bool {
        let classes = self.classes_in(set);
        classes.len() == 1 && end.is_none_or(|edge| classes.contains(&self.classes[Self::place(edge)]))
    }

    pub(super) fn edges(&self, set: Mask) -> Vec<usize> {
        (0..self.n()).filter(|place| set >> place & 1 == 1).map(Self::edge).collect()
    }

    /// What a pin in a band makes of a set.
    pub(super) fn image(&self, band: usize, set: Mask) -> Option<Mask> {
        let outcome = &self.bands[band].2;
        (0..self.n())
            .filter(|place| set >> place & 1 == 1)
            .try_fold(0, |image, place| Some(image | 1 << outcome[place]?))
    }

    /// What every interval of heights that does one thing to a set makes of it, and twice its tolerance.
    pub(super) fn pins(&self, set: Mask) -> Vec<(Mask, i64)> {
        let members = || (0..self.n()).filter(move |place| set >> place & 1 == 1);
        let mut pins = Vec::new();
        for first in 0..self.bands.len() {
            let Some(image) = self.image(first, set) else { continue };
            for last in first..self.bands.len() {
                let (band, below) = (&self.bands[last], &self.bands[last.max(1) - 1]);
                let is_joined =
                    |place: usize| band.2[place] == self.bands[first].2[place] && band.3[place] == band.2[place];
                if last > first && !(band.0 == below.1 && members().all(is_joined)) {
                    break;
                }
                pins.push((image, band.1 - self.bands[first].0));
            }
        }
        pins
    }

    /// All sets that pins make of one.
    pub(super) fn reachable(&self, start: Mask) -> BTreeSet<Mask> {
        let mut sets = BTreeSet::from([start]);
        let mut open = vec![start];
        while let Some(set) = open.pop() {
            for image in (0..self.bands.len()).filter_map(|band| self.image(band, set)) {
                if sets.insert(image) {
                    open.push(image);
                }
            }
        }
        sets
    }

    /// Where the places of `set` are after the pins, each of which must do what it says at all heights that it allows.
    pub(super) fn replayed(&self, set: Mask, pins: &[Pin]) -> Mask {
        let mut now = set;
        for pin in pins {
            assert!(pin.tolerance > ratio(0, 1));
            let [low, high] = [&pin.height - &pin.tolerance, &pin.height + &pin.tolerance];
            assert!(pin.low < low && pin.high > high, "the tolerance is inside of the ends");
            let mut next = 0;
            for place in (0..self.n()).filter(|place| now >> place & 1 == 1) {
                let to = pin.outcome[&Self::edge(place)];
                self.check_all_heights(place, &low, &high, Self::place(to));
                next |= 1 << Self::place(to);
            }
            assert_eq!(pin.outcome.keys().copied().collect::<Vec<_>>(), self.edges(now));
            assert_eq!(pin.after, self.edges(next));
            now = next;
        }
        now
    }

    /// Where one place is after the pins.
    pub(super) fn replayed_one(&self, place: usize, pins: &[Pin]) -> Mask {
        1 << pins.iter().fold(place, |place, pin| Self::place(pin.outcome[&Self::edge(place)]))
    }

    fn check_all_heights(&self, place: usize, low: &Q, high: &Q, to: usize) {
        let mut covered = low.clone();
        for (from, until, outcome, at_low) in &self.bands {
            let (from, until) = (ratio(*from, 1), ratio(*until, 1));
            if &from < high && until > covered {
                assert!(from <= covered, "heights between bands are not allowed");
                assert_eq!(outcome[place], Some(to));
                assert!(from < *low || at_low[place] == Some(to), "a critical height is not allowed");
                covered = until;
            }
        }
        assert!(covered > *high, "all heights are in bands");
    }
}
