//! The number of pins from arcs against the search over sets.

use super::super::Wanted;
use super::super::arcs::Arcs;
use super::super::layers::{Rule, search};
use super::super::moves::{Task, set_of};
use super::scene::{Mask, Outcome, Scene, scenes, walks};
use crate::exact::ratio;
use proptest::prelude::*;
use std::collections::BTreeSet;

/// Scenes without jams, of parts that turn onto themselves in some.
fn free_of_jams(most: usize) -> impl Strategy<Value = Scene> {
    (2..=most, 1..=3_usize).prop_flat_map(|(n, turns)| {
        scenes(n, walks(n, false).boxed(), 8, false).prop_map(move |scene| repeated(&scene, turns))
    })
}

/// The scene of a part that looks the same after each of so many turns.
fn repeated(scene: &Scene, turns: usize) -> Scene {
    let n = scene.n();
    let turned = |outcome: &Outcome| -> Outcome {
        let whole = n * turns;
        let to = |place: usize| {
            let to = outcome[place % n]?;
            // downward, so a stop above is that of the next turn
            Some((place + whole - (place % n + n - to) % n) % whole)
        };
        (0..whole).map(to).collect()
    };
    let bands = scene.bands.iter().map(|(low, high, outcome, at_low)| (*low, *high, turned(outcome), turned(at_low)));
    Scene { classes: (0..n * turns).map(|place| place % n).collect(), bands: bands.collect() }
}

/// The pins that one set needs, layer by layer.
fn needed(scene: &Scene, set: Mask, end: Option<usize>) -> Option<usize> {
    let mut known = BTreeSet::from([set]);
    let mut layer = known.clone();
    for n_pins in 0.. {
        if layer.iter().any(|set| scene.is_goal(*set, end)) {
            return Some(n_pins);
        }
        layer = layer
            .iter()
            .flat_map(|set| scene.pins(*set))
            .map(|(image, _)| image)
            .filter(|set| known.insert(*set))
            .collect();
        if layer.is_empty() {
            break;
        }
    }
    None
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 500, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn arcs_and_sets_agree(scene in free_of_jams(12), end in proptest::option::of(0..12_usize)) {
        let (stable, symmetry, bands) = (scene.stable(), scene.symmetry(), scene.given());
        let end = end.filter(|place| *place < scene.n()).map(Scene::edge);
        let task = Task::of(&stable, &symmetry, &bands, end);
        let arcs = Arcs::of(&task, &ratio(0, 1)).expect("nothing jams");
        let by_sets = search(&task, &Rule::default(), &mut || false);
        prop_assert_eq!(arcs.fewest(), by_sets.goals.first().map(|goal| by_sets.reached[*goal].n_pins));
        let plan = scene.plan(&Wanted { end, ..Wanted::default() });
        prop_assert!(plan.searched.by_arcs);
        prop_assert_eq!(plan.sequence.as_ref().map(Vec::len), arcs.fewest());
        if let Some(pins) = plan.sequence {
            let start = BTreeSet::from_iter(scene.stable());
            let last = pins.iter().fold(start, |now, pin| now.iter().map(|edge| pin.outcome[edge]).collect());
            prop_assert!(last.iter().all(|edge| plan.end.contains(edge)));
        }
    }

    #[test]
    fn arcs_tell_what_every_set_needs(scene in free_of_jams(4), end in proptest::option::of(0..4_usize)) {
        let (stable, symmetry, bands) = (scene.stable(), scene.symmetry(), scene.given());
        let end = end.filter(|place| *place < scene.n()).map(Scene::edge);
        let arcs = Arcs::of(&Task::of(&stable, &symmetry, &bands, end), &ratio(0, 1)).expect("nothing jams");
        for set in 1..=scene.everything().min(255) {
            let places = set_of(scene.n(), (0..scene.n()).filter(|place| set >> place & 1 == 1));
            prop_assert_eq!(arcs.needed(&places), needed(&scene, set, end), "{:b}", set);
        }
    }

    #[test]
    fn arcs_do_not_speak_where_a_pin_may_jam(scene in (2..=6_usize).prop_flat_map(|n| scenes(n, walks(n, true).boxed(), 6, false))) {
        let (stable, symmetry, bands) = (scene.stable(), scene.symmetry(), scene.given());
        let jams_some = scene.bands.iter().any(|band| band.2.contains(&None) && band.2.iter().any(Option::is_some));
        prop_assert!(!(jams_some && Arcs::of(&Task::of(&stable, &symmetry, &bands, None), &ratio(0, 1)).is_some()));
    }
}
