//! The public cases: bands from the actions that they state, and the answers that they state.

use super::super::{Band, Wanted, plan};
use crate::answer::{PinPlan, Symmetry};
use crate::exact::{Q, parse_literal, ratio};
use serde_json::Value;

macro_rules! cases {
    ($($name:literal),* $(,)?) => {
        [$(($name, include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/topple/", $name, ".expected.json")))),*]
    };
}

const CASES: [(&str, &str); 15] = cases![
    "com_exactly_over_left_vertex",
    "hexagon_order_2",
    "kite",
    "paper_fit_free_friction",
    "paper_fit_stated_friction",
    "paper_fit_within_2_degrees",
    "parallelogram_left",
    "pentagon",
    "pentagon_no_pin_friction",
    "pentagon_pin_rougher_than_belt",
    "rectangle_offset_com",
    "square",
    "three_pins",
    "triangle_345",
    "triangle_obtuse_unstable_edge",
];

/// What a case states of one orientation.
struct Stated {
    next: usize,
    /// Lower ends and actions, ascending.
    intervals: Vec<(Q, String)>,
}

struct Case {
    stable: Vec<usize>,
    symmetry: Symmetry,
    orientations: Vec<Stated>,
    plan: Value,
}

impl Case {
    fn of(text: &str) -> Self {
        let json: Value = serde_json::from_str(text).unwrap();
        let stable = edges(&json["stable"]);
        let interval = |value: &Value| (middle(&value["from"]), value["action"].as_str().unwrap().to_owned());
        let orientation = |value: &Value| Stated {
            next: stable.iter().position(|edge| value["next"] == *edge).unwrap(),
            intervals: value["intervals"].as_array().unwrap().iter().map(interval).collect(),
        };
        Self {
            orientations: json["orientations"].as_array().unwrap().iter().map(orientation).collect(),
            symmetry: Symmetry {
                shift: json["symmetry"]["shift"].as_u64().unwrap() as usize,
                classes: lists(&json["symmetry"]["classes"]),
            },
            plan: json["plan"].clone(),
            stable,
        }
    }

    /// The action at a height, and whether that is critical.
    fn action(&self, place: usize, height: &Q) -> (&str, bool) {
        let (from, action) = self.orientations[place].intervals.iter().rfind(|(from, _)| from <= height).unwrap();
        (action, from == height)
    }

    /// Where a place ends; `None` where it jams or meets a critical height.
    fn outcome(&self, start: usize, height: &Q) -> Option<usize> {
        let mut place = start;
        for _ in 0..=self.stable.len() {
            match self.action(place, height) {
                (_, true) | ("jam", _) => return None,
                ("pass", _) => return Some(self.orientations[place].next),
                ("repeat", _) => place = self.orientations[place].next,
                _ => return Some(place),
            }
        }
        None
    }

    fn bands(&self) -> Vec<Band> {
        let ends = self.orientations.iter().flat_map(|stated| stated.intervals.iter().map(|(from, _)| from.clone()));
        let mut ends: Vec<Q> = ends.collect();
        ends.sort();
        ends.dedup();
        let outcomes = |height: &Q| (0..self.stable.len()).map(|place| self.outcome(place, height)).collect();
        let band = |pair: &[Q]| Band {
            low: pair[0].clone().into(),
            high: pair[1].clone().into(),
            outcome: outcomes(&((&pair[0] + &pair[1]) / ratio(2, 1))),
            at_low: outcomes(&pair[0]),
        };
        ends.windows(2).map(band).collect()
    }

    fn plan(&self, wanted: &Wanted) -> PinPlan {
        plan(&self.stable, &self.symmetry, &self.bands(), wanted, &mut || false)
    }

    /// The edges on which parts are after the pins, checked at both ends of the heights that are allowed.
    fn replayed(&self, plan: &PinPlan) -> Vec<usize> {
        let mut now = self.stable.clone();
        for pin in plan.sequence.iter().flatten() {
            let place = |edge: &usize| self.stable.iter().position(|other| other == edge).unwrap();
            for edge in &now {
                for height in [&pin.height - &pin.tolerance, pin.height.clone(), &pin.height + &pin.tolerance] {
                    let to = self.outcome(place(edge), &height).map(|place| self.stable[place]);
                    assert_eq!(to, Some(pin.outcome[edge]), "edge {edge} at {height}");
                }
            }
            now = now.iter().map(|edge| pin.outcome[edge]).collect();
            now.sort_unstable();
            now.dedup();
            assert_eq!(now, pin.after);
        }
        now
    }
}

fn edges(value: &Value) -> Vec<usize> {
    value.as_array().unwrap().iter().map(|edge| edge.as_u64().unwrap() as usize).collect()
}

fn lists(value: &Value) -> Vec<Vec<usize>> {
    value.as_array().unwrap().iter().map(edges).collect()
}

fn middle(enclosure: &Value) -> Q {
    let end = |index: usize| parse_literal(enclosure[index].as_str().unwrap()).unwrap();
    (end(0) + end(1)) / ratio(2, 1)
}

#[test]
fn as_many_pins_as_stated_and_no_less_tolerant() {
    for (name, text) in CASES {
        let case = Case::of(text);
        let plan = case.plan(&Wanted::default());
        let n_pins = plan.sequence.as_ref().map(|pins| pins.len() as u64);
        assert_eq!(n_pins, case.plan["pins"].as_u64(), "{name}");
        let Some(stated) = case.plan["sequence"].as_array() else { continue };
        let last = case.replayed(&plan);
        assert!(last.iter().all(|edge| plan.end.contains(edge)), "{name}");
        assert!(case.symmetry.classes.contains(&plan.end), "{name}");
        assert!(edges(&case.plan["finals_at_this_length"]).iter().any(|edge| plan.end.contains(edge)), "{name}");
        let width = |pin: &Value| middle(&pin["to"]) - middle(&pin["from"]);
        let least = plan.sequence.iter().flatten().map(|pin| pin.tolerance.clone()).min();
        assert!(least >= stated.iter().map(|pin| width(pin) * ratio(99, 200)).min(), "{name}");
    }
}

#[test]
fn edges_to_end_on_are_those_stated() {
    for (name, text) in CASES {
        let case = Case::of(text);
        let reachable = case.plan.get("final_classes_reachable").map(edges).unwrap_or_default();
        for class in &case.symmetry.classes {
            let plan = case.plan(&Wanted { end: class.last().copied(), ..Wanted::default() });
            assert_eq!(plan.sequence.is_some(), reachable.contains(&class[0]), "{name}: {class:?}");
            assert_eq!(plan.obstacle.is_none(), plan.sequence.is_some(), "{name}: {class:?}");
        }
    }
}

#[test]
fn obstacles_are_those_stated() {
    let mut n_obstacles = 0;
    for (name, text) in CASES {
        let case = Case::of(text);
        let Some(obstacle) = case.plan(&Wanted::default()).obstacle else { continue };
        n_obstacles += 1;
        assert_eq!(obstacle.smallest_sets, lists(&case.plan["smallest_sets"]), "{name}");
        assert_eq!(obstacle.never_moved, edges(&case.plan["never_moved"]), "{name}");
        let pairs: Vec<Vec<usize>> = obstacle.inseparable_pairs.iter().map(|pair| pair.to_vec()).collect();
        assert_eq!(pairs, lists(&case.plan["inseparable_pairs"]), "{name}");
        let left = case.plan["fewest_classes_left"].as_u64().unwrap() as usize;
        let wiper = obstacle.wiper.unwrap();
        assert!(wiper.yielding >= case.stable.len().div_ceil(left), "{name}: the best of a few classes");
        assert!(wiper.discarded.len() + 1 >= left, "{name}");
    }
    assert_eq!(n_obstacles, 11);
}

#[test]
fn counts_are_those_stated() {
    for (name, text) in CASES {
        let case = Case::of(text);
        let counts = case.plan(&Wanted::default()).searched;
        let stated = |key: &str| case.plan[key].as_u64().map(|count| count as usize);
        assert_eq!(Some(counts.height_classes), stated("height_classes"), "{name}");
        assert_eq!(Some(counts.distinct_outcome_maps), stated("distinct_outcome_maps"), "{name}");
        assert_eq!(Some(counts.reachable_sets), stated("reachable_sets"), "{name}");
        if let Some(usable) = stated("usable_first_pins") {
            assert_eq!(counts.usable_first_pins, usable, "{name}");
        }
    }
}

#[test]
fn three_pins_are_too_many_for_two() {
    let case = Case::of(CASES.iter().find(|(name, _)| *name == "three_pins").unwrap().1);
    let plan = case.plan(&Wanted { max_pins: Some(2), ..Wanted::default() });
    assert!(plan.sequence.is_none() && plan.obstacle.is_none());
    assert_eq!(plan.needs, Some(3));
}

#[test]
fn a_search_that_is_over_says_nothing_that_it_has_not_proved() {
    let case = Case::of(CASES.iter().find(|(name, _)| *name == "three_pins").unwrap().1);
    let cut = plan(&case.stable, &case.symmetry, &case.bands(), &Wanted::default(), &mut || true);
    assert!(cut.sequence.is_none() && cut.obstacle.is_none() && cut.needs.is_none());
    // one pair is a proof, however little was searched
    let case = Case::of(CASES.iter().find(|(name, _)| *name == "pentagon").unwrap().1);
    let cut = plan(&case.stable, &case.symmetry, &case.bands(), &Wanted::default(), &mut || true);
    assert!(!cut.obstacle.unwrap().inseparable_pairs.is_empty());
}
