//! The plan against every sequence of pins.

use super::super::Wanted;
use super::scene::{Mask, Scene, anything, scenes, walks};
use crate::exact::{Q, ratio};
use num_traits::Zero as _;
use proptest::prelude::*;
use std::collections::BTreeSet;

/// The longest sequences that are tried one by one.
const LONGEST: usize = 4;

fn small() -> impl Strategy<Value = Scene> {
    (2..=5_usize).prop_flat_map(|n| {
        prop_oneof![
            2 => scenes(n, walks(n, true).boxed(), 6, true),
            1 => scenes(n, walks(n, false).boxed(), 4, true),
            1 => scenes(n, anything(n).boxed(), 5, true),
        ]
    })
}

/// Twice the widest least tolerance of all sequences of exactly `left` pins from `set` to a goal.
fn widest(scene: &Scene, set: Mask, left: usize, end: Option<usize>) -> Option<i64> {
    if left == 0 {
        return scene.is_goal(set, end).then_some(i64::MAX);
    }
    let with = |(image, width): (Mask, i64)| Some(width.min(widest(scene, image, left - 1, end)?));
    scene.pins(set).into_iter().filter_map(with).max()
}

/// The fewest pins to a goal, by sets layer by layer, none given up.
fn fewest(scene: &Scene, end: Option<usize>) -> Option<usize> {
    let mut layer = BTreeSet::from([scene.everything()]);
    // there are fewer sets than that, so a longer sequence repeats one
    for pins in 0..=1 << scene.n() {
        if layer.iter().any(|set| scene.is_goal(*set, end)) {
            return Some(pins);
        }
        layer = layer.iter().flat_map(|set| scene.pins(*set)).map(|(image, _)| image).collect();
    }
    None
}

/// A tolerance with few decimals keeps 99 % of the exact one.
fn is_near(short: &Q, twice_exact: i64) -> bool {
    let exact = ratio(twice_exact, 2);
    *short < exact && *short >= exact * ratio(99, 100)
}

/// Whether the pairs of all places without a sequence that makes them look the same are as said.
fn pairs(scene: &Scene) -> Vec<[usize; 2]> {
    let mut pairs = Vec::new();
    for (a, b) in (0..scene.n()).flat_map(|a| (a + 1..scene.n()).map(move |b| (a, b))) {
        if scene.reachable(1 << a | 1 << b).iter().all(|set| scene.classes_in(*set).len() == 2) {
            pairs.push([Scene::edge(a), Scene::edge(b)]);
        }
    }
    pairs
}

/// The inclusion-minimal of the sets with the fewest classes.
fn smallest(scene: &Scene) -> Vec<Vec<usize>> {
    let sets = scene.reachable(scene.everything());
    let n_classes = |set: &Mask| scene.classes_in(*set).len();
    let fewest = sets.iter().map(n_classes).min().expect("the set of everything is one");
    let small: Vec<Mask> = sets.into_iter().filter(|set| n_classes(set) == fewest).collect();
    let is_minimal = |set: &Mask| small.iter().all(|other| other == set || other & set != *other);
    let mut edges: Vec<Vec<usize>> = small.iter().filter(|set| is_minimal(set)).map(|set| scene.edges(*set)).collect();
    edges.sort_unstable();
    edges
}

/// Orientations that stay where they are in every reachable set at every pin that jams none of it.
fn never_moved(scene: &Scene) -> Vec<usize> {
    let sets = scene.reachable(scene.everything());
    let is_moved = |place: usize| {
        sets.iter().filter(|set| **set >> place & 1 == 1).any(|set| {
            let usable = (0..scene.bands.len()).filter(|band| scene.image(*band, *set).is_some());
            usable.into_iter().any(|band| scene.bands[band].2[place] != Some(place))
        })
    };
    (0..scene.n()).filter(|place| !is_moved(*place)).map(Scene::edge).collect()
}

/// The most starts that any sequence takes to one class, by all ways to track them.
fn largest_yield(scene: &Scene) -> usize {
    let start: Vec<usize> = (0..scene.n()).collect();
    let mut known = BTreeSet::from([start.clone()]);
    let mut open = vec![start];
    let mut most = 0;
    while let Some(now) = open.pop() {
        for class in 0..scene.n() {
            most = most.max(now.iter().filter(|place| scene.classes[**place] == class).count());
        }
        for (_, _, outcome, _) in &scene.bands {
            if let Some(next) = now.iter().map(|place| outcome[*place]).collect::<Option<Vec<usize>>>()
                && known.insert(next.clone())
            {
                open.push(next);
            }
        }
    }
    most
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1500, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn as_few_pins_as_any_sequence_has_and_as_wide(scene in small(), end in proptest::option::of(0..5_usize)) {
        let end = end.filter(|place| *place < scene.n()).map(Scene::edge);
        let plan = scene.plan(&Wanted { end, ..Wanted::default() });
        let length = plan.sequence.as_ref().map(Vec::len);
        prop_assert_eq!(length, fewest(&scene, end));
        prop_assert_eq!(plan.obstacle.is_some(), length.is_none());
        if let Some(pins) = &plan.sequence {
            let last = scene.replayed(scene.everything(), pins);
            prop_assert!(scene.is_goal(last, end));
            prop_assert!(scene.edges(last).iter().all(|edge| plan.end.contains(edge)));
            let same = |edge: &usize| scene.classes_in(last).contains(&scene.classes[Scene::place(*edge)]);
            prop_assert_eq!(&plan.end, &scene.stable().into_iter().filter(same).collect::<Vec<_>>());
            if (1..=LONGEST).contains(&pins.len()) {
                let exact = widest(&scene, scene.everything(), pins.len(), end).expect("so many pins do");
                let least = pins.iter().map(|pin| &pin.tolerance).min().expect("there are pins");
                prop_assert!(is_near(least, exact), "{} against {}/2", least, exact);
            }
        }
    }

    #[test]
    fn obstacles_are_what_enumeration_shows(scene in small()) {
        if let Some(obstacle) = scene.plan(&Wanted::default()).obstacle {
            prop_assert_eq!(obstacle.smallest_sets, smallest(&scene));
            prop_assert_eq!(obstacle.inseparable_pairs, pairs(&scene));
            prop_assert_eq!(obstacle.never_moved, never_moved(&scene));
            let wiper = obstacle.wiper.expect("without an edge that is asked for something can be kept");
            let left = scene.replayed(scene.everything(), &wiper.pins);
            let class = |edge: usize| scene.classes[Scene::place(edge)];
            let ends_there = |place: &usize| scene.is_goal(scene.replayed_one(*place, &wiper.pins), Some(wiper.kept));
            prop_assert_eq!(wiper.yielding, (0..scene.n()).filter(ends_there).count());
            prop_assert_eq!(wiper.yielding, largest_yield(&scene));
            let named: Vec<usize> = wiper.discarded.iter().chain([&wiper.kept]).map(|edge| class(*edge)).collect();
            prop_assert_eq!(named.iter().copied().collect::<BTreeSet<_>>(), scene.classes_in(left));
            prop_assert_eq!(named.len(), scene.classes_in(left).len());
        }
    }

    #[test]
    fn pins_are_not_more_than_allowed(scene in small(), most in 0..=3_usize) {
        let plan = scene.plan(&Wanted { max_pins: Some(most), ..Wanted::default() });
        let needed = fewest(&scene, None);
        prop_assert_eq!(plan.sequence.map(|pins| pins.len()), needed.filter(|needed| *needed <= most));
        prop_assert_eq!(plan.needs, needed.filter(|needed| *needed > most));
        prop_assert_eq!(plan.obstacle.is_some(), needed.is_none());
    }

    #[test]
    fn more_pins_are_listed_where_they_allow_more(scene in small(), end in proptest::option::of(0..5_usize)) {
        let end = end.filter(|place| *place < scene.n()).map(Scene::edge);
        let plan = scene.plan(&Wanted { end, max_pins: Some(LONGEST), pareto: true });
        let mut expected = Vec::new();
        let mut best = ratio(0, 1);
        if fewest(&scene, end) != Some(0) {
            for pins in 1..=LONGEST {
                let tolerance = widest(&scene, scene.everything(), pins, end).map_or_else(Q::zero, |twice| ratio(twice, 2));
                if tolerance > best {
                    best = tolerance.clone();
                    expected.push((pins, tolerance));
                }
            }
        }
        prop_assert_eq!(plan.pareto.into_iter().map(|entry| (entry.pins, entry.tolerance)).collect::<Vec<_>>(), expected);
    }
}
