//! The text: the answer first, and no number that promises too much.

use super::published::Published;
use super::support::cases::number;
use super::support::conveyed::{NAMES, edge, list};
use partplan::answer::{Limit, PinAction, PinPlan, Tradeoff, Wiper};
use partplan::exact::{Q, parse_literal, ratio};
use partplan::model::Range;
use partplan::report::{Ride, text};
use serde_json::Value;

fn words(published: &Published) -> String {
    text::pins(&published.ride(), &published.answer)
}

/// The answer without the heights that the public results sample.
fn unasked(name: &str) -> Published {
    let mut published = Published::new(name);
    published.answer.queries.clear();
    published
}

fn first_line(text: &str) -> &str {
    text.lines().next().unwrap()
}

/// What follows `label` in its line.
fn after<'a>(text: &'a str, label: &str) -> &'a str {
    let line = text.lines().find_map(|line| line.strip_prefix(&format!("  {label:<11} ")));
    line.unwrap_or_else(|| panic!("no {label} in\n{text}"))
}

#[test]
fn every_public_case_fits_a_screen() {
    for name in NAMES {
        let text = words(&unasked(name));
        assert!(text.lines().count() < 25 && text.lines().all(|line| line.chars().count() <= 160), "{text}");
    }
}

#[test]
fn the_answer_comes_first() {
    for (name, answer) in [
        ("three_pins", "3 pins turn all 4 orientations into edge 1 down"),
        ("hexagon_order_2", "1 pin turns all 3 orientations into edge 2 or 5 down, which look the same"),
        ("parallelogram_left", "1 pin turns both orientations into edge 0 or 2 down, which look the same"),
        ("square", "no pins are needed: the part looks the same on each of its 4 edges"),
        ("pentagon", "it is proved that no pins turn all 5 orientations into one"),
        ("kite", "it is proved that no pins turn both orientations into one"),
    ] {
        assert_eq!(first_line(&words(&Published::new(name))), answer);
    }
}

/// Rows of the table of pins: number, height, tolerance, lower and upper end, what happens.
fn rows(text: &str) -> Vec<(usize, [Q; 4], String)> {
    let lines = text.lines().skip(1).skip_while(|line| !line.starts_with("  pin ")).skip(1);
    let row = |line: &str| {
        let cells: Vec<&str> = line.split_whitespace().collect();
        let number: usize = cells.first()?.parse().ok()?;
        let numbers = [1, 2, 3, 4].map(|cell| parse_literal(cells[cell]).unwrap());
        Some((number, numbers, cells[5..].join(" ")))
    };
    lines.map_while(row).collect()
}

#[test]
fn the_table_keeps_within_the_published_heights() {
    let mut n_pins = 0;
    for name in NAMES {
        let published = Published::new(name);
        let pins = published.expected["plan"]["sequence"].as_array().cloned().unwrap_or_default();
        let rows = rows(&words(&published));
        assert_eq!(rows.len(), pins.len(), "{name}");
        for ((index, [height, tolerance, from, to], _), pin) in rows.iter().zip(&pins) {
            n_pins += 1;
            assert_eq!(number(&pins[index - 1]["height"]), number(&pin["height"]));
            let [low, high] = [number(&pin["from"][1]), number(&pin["to"][0])];
            assert!(low < *from && from < height && height < to && *to < high, "{name}");
            assert!(low <= height - tolerance && height + tolerance <= high, "{name}");
            // and gives little away
            assert!((to - from) > (&high - &low) * ratio(97, 100), "{name}");
            let room = (height - &low).min(&high - height);
            assert!(*tolerance > room * ratio(97, 100), "{name}");
        }
    }
    assert_eq!(n_pins, 5);
}

#[test]
fn the_table_says_which_edges_go_where() {
    let said: Vec<String> = rows(&words(&Published::new("three_pins"))).into_iter().map(|(_, _, said)| said).collect();
    assert_eq!(said, ["turns 2 to 1; leaves 1, 4 and 5", "turns 5 to 4; leaves 1 and 4", "turns 4 to 1; leaves 1"]);
    let said: Vec<String> = rows(&words(&Published::new("hexagon_order_2"))).into_iter().map(|row| row.2).collect();
    assert_eq!(said, ["turns 3 and 4 to 2; 0 and 1 to 5; leaves 2 and 5"]);
}

/// Every height that an orientation's line gives to an action has it by the published intervals.
#[test]
fn the_heights_of_an_orientation_have_their_action() {
    let mut n_heights = 0;
    for name in NAMES {
        let published = Published::new(name);
        let text = words(&published);
        let firsts: Vec<usize> = published.answer.symmetry.classes.iter().map(|class| class[0]).collect();
        for orientation in list(&published.expected["orientations"]) {
            let edge = edge(&orientation["edge"]);
            if !firsts.contains(&edge) {
                continue;
            }
            let line = after(&text, &format!("edge {edge}"));
            let (_, actions) = line.split_once(": ").unwrap();
            for phrase in actions.split("; ") {
                let Some(action) =
                    ["pass under", "pass", "repeat", "fall back"].into_iter().find(|a| phrase.starts_with(a))
                else {
                    assert!(phrase == "else jam" || phrase.ends_with(" alike"), "{phrase}");
                    continue;
                };
                let heights = phrase[action.len()..].split([' ', ',']).filter_map(|word| parse_literal(word).ok());
                for height in heights {
                    n_heights += 1;
                    let name = action.replace(' ', "-");
                    assert_eq!(published_action(orientation, &height), name, "{height} in {line}");
                }
            }
        }
    }
    assert!(n_heights > 150, "{n_heights}");
}

fn published_action(orientation: &Value, height: &Q) -> String {
    let is_inside = |interval: &&Value| {
        number(&interval["from"][1]) < *height && (interval["to"].is_null() || number(&interval["to"][0]) > *height)
    };
    let interval = list(&orientation["intervals"]).iter().find(is_inside).expect("a height that is not critical");
    interval["action"].as_str().unwrap().to_owned()
}

#[test]
fn what_hinders_a_plan_is_named() {
    let text = words(&unasked("pentagon"));
    assert_eq!(after(&text, "because"), "pins leave edges 0 and 2 at best");
    assert_eq!(after(&text, "never one"), "no sequence of pins brings together 0 with 2, 3 and 4; 1 with 2, 3 and 4");
    assert!(after(&text, "never moved").starts_with("edges 0 and 2: no pin moves them without jamming"));
    assert!(text.contains("where it repeats about 7 to 7.6026 it ducks below the pin"));
    let text = words(&unasked("kite"));
    assert_eq!(after(&text, "because"), "no pin topples the part, whatever its height");
    assert_eq!(after(&text, "never one"), "no sequence of pins brings any two orientations together");
    let text = words(&unasked("paper_fit_stated_friction"));
    assert_eq!(after(&text, "because"), "no pin moves an orientation without jamming one that may come along");
}

#[test]
fn a_wiper_is_proposed_with_its_pins_and_yield() {
    let mut published = unasked("pentagon");
    let pins = unasked("hexagon_order_2").answer.plan.sequence.unwrap();
    let obstacle = published.answer.plan.obstacle.as_mut().unwrap();
    obstacle.wiper = Some(Wiper { pins, discarded: vec![2], kept: 0, yielding: 2 });
    let text = words(&published);
    let proposed =
        "1 pin and behind it a wiper that takes edge 2 off the belt: edge 0 is left, 2 of 5 orientations end there";
    assert_eq!(after(&text, "try"), proposed);
    assert_eq!(rows(&text).len(), 1);
    published.answer.plan.obstacle.as_mut().unwrap().wiper.as_mut().unwrap().pins.clear();
    let text = words(&published);
    assert!(after(&text, "try").starts_with("a wiper that takes edge 2 off the belt: "), "{text}");
    assert_eq!(rows(&text).len(), 0);
}

#[test]
fn what_was_asked_is_answered() {
    let mut published = unasked("three_pins");
    published.answer.plan = PinPlan { needs: Some(3), ..PinPlan::default() };
    let ride = Ride { max_pins: Some(2), ..published.ride() };
    let text = text::pins(&ride, &published.answer);
    assert_eq!(first_line(&text), "it takes 3 pins to turn all 4 orientations into one, more than the 2 allowed");
    assert_eq!(after(&text, "try"), "--max-pins 3");
    let mut published = unasked("pentagon");
    published.answer.plan.obstacle.as_mut().unwrap().smallest_sets = vec![vec![3]];
    let ride = Ride { end: Some(1), max_pins: Some(9), ..published.ride() };
    let text = text::pins(&ride, &published.answer);
    assert_eq!(first_line(&text), "it is proved that no pins turn all 5 orientations into edge 1 down");
    assert_eq!(after(&text, "because"), "pins can turn them into edge 3 down instead");
}

#[test]
fn a_limit_is_said_and_nothing_is_claimed() {
    let mut published = unasked("pentagon");
    published.answer.plan = PinPlan { limit: Some(Limit::Time), ..PinPlan::default() };
    let text = words(&published);
    let said = "undecided: the time limit ended the search for pins that turn all 5 orientations into one";
    assert_eq!(first_line(&text), said);
    assert!(!text.contains("proved"));
}

/// A sequence may be found, or none proved to exist, before the search is complete.
#[test]
fn a_limit_may_come_after_the_answer() {
    for name in ["three_pins", "pentagon"] {
        let mut published = unasked(name);
        let answer = first_line(&words(&published)).to_owned();
        published.answer.plan.limit = Some(Limit::Memory);
        let text = words(&published);
        assert_eq!(first_line(&text), answer);
        assert_eq!(after(&text, "incomplete"), "the memory limit ended the search: better ones may exist");
    }
}

#[test]
fn heights_that_were_asked_about_are_told_by_edge() {
    let text = words(&Published::new("three_pins"));
    assert_eq!(after(&text, "at 3 m"), "1: pass under; 2: pass, end on 1; 4: repeat, end on 1; 5: jam");
    assert_eq!(after(&text, "at 0.5 m"), "1 and 5: jam; 2 and 4: repeat, then jam");
    assert_eq!(after(&text, "at 4.3 m"), "1, 4 and 5: pass under; 2: fall back");
    let text = words(&Published::new("triangle_obtuse_unstable_edge"));
    assert!(text.contains("exactly critical for edge 0: "), "{text}");
}

#[test]
fn what_depends_on_uncertain_values_is_said() {
    let mut published = Published::new("three_pins");
    published.case.conveyor.as_mut().unwrap().pin_friction = Range { min: ratio(1, 20), max: ratio(1, 10) };
    published.answer.orientations[0].intervals[1].action = None;
    let query = &mut published.answer.queries[1];
    query.actions.insert(1, None);
    query.actions.insert(4, Some(PinAction::Repeat));
    let text = words(&published);
    assert!(
        after(&text, "edge 1").contains("depends on what is uncertain about 0.62111 to 1.6999; else jam"),
        "{text}"
    );
    let told = after(&text, "at 0.5 m");
    assert!(
        told.starts_with(
            "1: undetermined, it depends on what is uncertain; 2 and 4: repeat, then jam or it is uncertain"
        )
    );
    assert_eq!(after(&text, "friction"), "belt 20, pins 0.05 to 0.1: the plan holds for every value");
    published.case.part.center_of_mass_tolerance = ratio(1, 4);
    let text = words(&published);
    let said = "belt 20, pins 0.05 to 0.1; center of mass within ±0.25 m: the plan holds for every value";
    assert_eq!(after(&text, "friction"), said);
    let mut published = unasked("pentagon");
    published.case.part.center_of_mass_tolerance = ratio(1, 4);
    let text = words(&published);
    assert_eq!(first_line(&text), "it is proved that no pins are certain to turn all 5 orientations into one");
    assert!(after(&text, "friction").ends_with("no plan holds for every value, one may for narrower ranges"));
}

#[test]
fn more_pins_for_a_wider_tolerance_are_listed() {
    let mut published = unasked("three_pins");
    published.answer.plan.pareto =
        vec![Tradeoff { pins: 1, tolerance: ratio(1, 16) }, Tradeoff { pins: 5, tolerance: ratio(1, 9) }];
    let text = words(&published);
    assert_eq!(after(&text, "tolerance"), "±0.0625 m at the tightest of 1 pin");
    assert_eq!(after(&text, ""), "±0.111 m at the tightest of 5 pins");
}

/// A part with a hundred stable edges has a report that ends.
#[test]
fn many_orientations_are_counted() {
    let mut published = unasked("three_pins");
    let first = published.answer.orientations[0].clone();
    let answer = &mut published.answer;
    answer.stable = (0..100).collect();
    answer.symmetry.classes = (0..100).map(|edge| vec![edge]).collect();
    answer.orientations = (0..100).map(|edge| partplan::answer::Orientation { edge, ..first.clone() }).collect();
    let pin = &mut answer.plan.sequence.as_mut().unwrap()[0];
    pin.outcome = (0..100).map(|edge| (edge, 1)).collect();
    let text = words(&published);
    assert!(text.lines().count() < 25 && text.lines().all(|line| line.chars().count() <= 160), "{text}");
    assert!(text.contains("and 93 more (--format json lists all)"), "{text}");
    assert!(text.contains("turns 0, 2, 3, 4, 5, 6, 7 and 92 more to 1; leaves 1"), "{text}");
}
