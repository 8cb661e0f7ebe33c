//! Witnesses and the modes that are consistent with a wrench, judged by arithmetic and by linear programs.

mod support;

use partplan::answer::Cone;
use partplan::model::{Fixture, Part};
use partplan::planner::{Question, insertion, stability};
use partplan::report::{Subject, json};
use proptest::prelude::*;
use serde_json::{Value, json};
use support::cases::{FOUR, NAMES, expected, seated, wrench_of};
use support::member::landmarks;
use support::random::{Setup, any_friction, any_setup, degenerate, discs, runs, seatable, wrenches};
use support::witness::{Check, Checker};
use support::{Wrench, wrench};

/// What `plan insert` says about each wrench.
fn entries((part, fixture): &Setup, wrenches: &[Wrench]) -> Vec<Value> {
    let question = Question { wrenches: wrenches.to_vec(), ..Question::default() };
    let answer = insertion(part, fixture, &question).expect("no modes are asked for");
    listed(&json::insertion(&subject(part, fixture), &answer, false))
}

fn subject<'a>(part: &'a Part, fixture: &'a Fixture) -> Subject<'a> {
    Subject { name: "", part, fixture, warnings: &[] }
}

fn listed(document: &Value) -> Vec<Value> {
    document["result"]["wrenches"].as_array().expect("wrenches were asked about").clone()
}

/// Every entry is shown rightly, and its modes are those that the programs find.
fn check(setup: &Setup, wrenches: &[Wrench]) -> Check {
    let checker = Checker::of(&setup.0, &setup.1);
    for (g, entry) in wrenches.iter().zip(entries(setup, wrenches)) {
        checker.entry(&entry).map_err(|fault| format!("{g:?}: {fault}\n{entry:#}"))?;
        let consistent = checker.consistent(g);
        if entry["consistent"] != json!(consistent) {
            return Err(format!("{g:?}: consistent with {consistent:?}, not {}", entry["consistent"]));
        }
        if consistent.is_empty() {
            return Err(format!("{g:?}: no mode is consistent"));
        }
    }
    Ok(())
}

/// Wrenches on the faces of the sets' cells, evenly picked, and some others.
fn probes(setup: &Setup, count: usize, others: Vec<Wrench>) -> Vec<Wrench> {
    let (part, fixture) = setup;
    let no_modes = "no modes are asked for";
    let insert = insertion(part, fixture, &Question::default()).expect(no_modes);
    let stable = stability(part, fixture, &Question::default()).expect(no_modes);
    let regions = [&insert.goal, &insert.acyclic, &insert.unrefuted, &stable.strong];
    let cells = regions.into_iter().flat_map(|region| &region.cells).chain([&stable.weak]);
    let points = cells.filter_map(|cell| if let Cone::Of(cone) = cell { Some(landmarks(cone)) } else { None });
    let points: Vec<Wrench> = points.flatten().collect();
    others.into_iter().chain(points.iter().step_by(points.len() / count + 1).cloned()).collect()
}

#[test]
fn every_verdict_on_the_public_wrenches_is_shown() {
    for name in NAMES.into_iter().chain([FOUR]) {
        // numbers of hundreds of digits cost a second a wrench
        let stride = if name == "n3_huge_rationals" { 7 } else { 2 };
        let expected = expected(name);
        let asked = expected["wrenches"].as_array().expect("a list").iter().step_by(stride);
        let asked: Vec<Wrench> = asked.map(|entry| wrench_of(&entry["g"])).collect();
        check(&seated(name), &asked).unwrap_or_else(|fault| panic!("{name}: {fault}"));
    }
}

#[test]
fn both_commands_show_the_same() {
    let setup = seated("n3_pawl_02");
    let question = Question { wrenches: vec![wrench(1, 2, 3), wrench(-3, 0, 1)], ..Question::default() };
    let answer = stability(&setup.0, &setup.1, &question).expect("no modes are asked for");
    let stable = listed(&json::stability(&subject(&setup.0, &setup.1), &answer, false));
    assert_eq!(stable, entries(&setup, &question.wrenches));
}

#[test]
fn a_changed_witness_is_rejected() {
    let mut changes = 0;
    for name in
        ["n1_vertex", "n2_static_kinetic", "n2_disc_fig5", "n3_pawlB_range", "n3_acyclic_only", "n3_peg_jam", FOUR]
    {
        let setup = seated(name);
        let checker = Checker::of(&setup.0, &setup.1);
        let expected = expected(name);
        let asked = expected["wrenches"].as_array().expect("a list").iter().step_by(10);
        let asked: Vec<Wrench> = asked.map(|entry| wrench_of(&entry["g"])).collect();
        for entry in entries(&setup, &asked) {
            assert_eq!(checker.entry(&entry), Ok(()), "{name}");
            for changed in tampered(&entry) {
                assert!(checker.entry(&changed).is_err(), "{name}: accepted {changed:#}\nchanged from {entry:#}");
                changes += 1;
            }
        }
    }
    assert!(changes > 2_000, "only {changes} changes were tried");
}

/// The entry with one number, letter, verdict or part changed, in every way.
fn tampered(entry: &Value) -> Vec<Value> {
    let mut changed = Vec::new();
    for place in places(entry, "") {
        let old = entry.pointer(&place).expect("the place was listed");
        let mut replace = |new: Value| {
            let mut copy = entry.clone();
            *copy.pointer_mut(&place).expect("the place was listed") = new;
            changed.push(copy);
        };
        let is_mode = place.ends_with("/mode") || place.starts_with("/consistent");
        match old {
            Value::Bool(value) => replace(json!(!value)),
            Value::String(mode) if is_mode => {
                for index in 0..mode.len() {
                    for letter in "saulrnm".chars().filter(|letter| mode.chars().nth(index) != Some(*letter)) {
                        replace(json!(format!("{}{letter}{}", &mode[..index], &mode[index + 1..])));
                    }
                }
            }
            Value::Number(_) | Value::String(_) => {
                for step in [1, -1] {
                    let value = support::cases::number(old) + support::int(step);
                    replace(if value.is_integer() && place.contains("/from/") | place.contains("/to/") {
                        json!(value.to_integer().to_string().parse::<i64>().expect("the number of a contact"))
                    } else {
                        json!(value.to_string())
                    });
                }
            }
            Value::Null => {}
            // an empty state or list has nothing to lose
            Value::Array(list) if list.is_empty() => {}
            Value::Array(list) => replace(list[1..].into()),
            Value::Object(_) => replace(Value::Null),
        }
    }
    changed
}

/// Pointers to the verdicts and to every value below the witness, the list of modes and the motions.
fn places(value: &Value, path: &str) -> Vec<String> {
    let children: Vec<(String, &Value)> = match value {
        Value::Object(map) => map.iter().map(|(key, child)| (key.clone(), child)).collect(),
        Value::Array(list) => list.iter().enumerate().map(|(index, child)| (index.to_string(), child)).collect(),
        _ => Vec::new(),
    };
    let mut found = Vec::new();
    for (key, child) in children.into_iter().filter(|(key, _)| !(path.is_empty() && key == "modes")) {
        let place = format!("{path}/{key}");
        found.extend(places(child, &place));
        found.push(place);
    }
    found
}

proptest! {
    #![proptest_config(runs(8))]

    #[test]
    fn every_verdict_is_shown(setup in any_setup(1..=4), others in wrenches(4)) {
        check(&setup, &probes(&setup, 5, others)).map_err(TestCaseError::fail)?;
    }

    #[test]
    fn every_verdict_on_degenerate_fixtures_is_shown((_, setup) in degenerate(), others in wrenches(3)) {
        check(&setup, &probes(&setup, 5, others)).map_err(TestCaseError::fail)?;
    }

    #[test]
    fn every_verdict_on_fixtures_that_seat_is_shown(setup in seatable(), others in wrenches(2)) {
        check(&setup, &probes(&setup, 6, others)).map_err(TestCaseError::fail)?;
    }

    #[test]
    fn every_verdict_on_discs_is_shown(setup in discs(1..=3, any_friction()), others in wrenches(3)) {
        check(&setup, &probes(&setup, 4, others)).map_err(TestCaseError::fail)?;
    }
}
