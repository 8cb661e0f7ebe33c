//! The document says what the answer says, exactly.

use super::published::Published;
use super::support::cases::{number, numbers};
use super::support::conveyed::{NAMES, edge, edges, list};
use num_traits::Pow as _;
use partplan::answer::{Limit, Obstacle, PinAction, PinPlan, Tradeoff, Wiper};
use partplan::exact::{Algebraic, Polynomial, Q, ratio};
use partplan::model::Range;
use partplan::report::{Ride, json};
use serde_json::{Value, json};

fn document(published: &Published) -> Value {
    // as text and back: what a reader of the file has
    serde_json::from_str(&json::document(&json::pins(&published.ride(), &published.answer))).unwrap()
}

/// The published enclosure holds what the document says.
fn assert_encloses(enclosure: &Value, shown: &Value) {
    let [low, high] = [number(&enclosure[0]), number(&enclosure[1])];
    assert!((low..=high).contains(&number(shown)), "{shown} is not in {enclosure}");
}

#[test]
fn every_published_result_is_in_the_document_under_its_name() {
    for name in NAMES {
        let published = Published::new(name);
        let (document, expected) = (document(&published), &published.expected);
        let (result, plan) = (&document["result"], &document["result"]["plan"]);
        let status = if expected["plan"]["pins"].is_null() { "no-plan" } else { "plan" };
        assert_eq!(document["schema"], json!("plan.pins/1"), "{name}");
        assert_eq!((&document["case"], &document["status"]), (&json!(name), &json!(status)));
        for key in ["center_of_mass", "belt_friction", "pin_friction"] {
            assert_eq!(exact(&result[key]), exact(&expected[key]), "{name} {key}");
        }
        assert_eq!(result["stable"], expected["stable"], "{name}");
        assert_eq!(result["symmetry"], expected["symmetry"], "{name}");
        let corners = |hull: &Value| list(hull).iter().map(numbers).collect::<Vec<_>>();
        assert_eq!(corners(&result["hull"]), corners(&expected["hull"]), "{name}");
        compare_orientations(&result["orientations"], &expected["orientations"]);
        for key in ["pins", "smallest_sets", "inseparable_pairs", "never_moved"] {
            assert_eq!(&plan[key], expected["plan"].get(key).unwrap_or(&Value::Null), "{name} {key}");
        }
        compare_sequence(&plan["sequence"], &expected["plan"]["sequence"]);
        if status == "plan" {
            assert!(edges(&expected["plan"]["finals_at_this_length"]).contains(&edge(&plan["final"])));
        }
        compare_queries(&result["queries"], &expected["queries"]);
        assert_eq!(result["decisions"], json!({ "filtered": 12, "exact": 3 }));
    }
}

/// Numbers alone or in a list.
fn exact(value: &Value) -> Vec<Q> {
    if value.is_array() { numbers(value) } else { vec![number(value)] }
}

fn compare_orientations(shown: &Value, expected: &Value) {
    assert_eq!(list(shown).len(), list(expected).len());
    for (shown, expected) in list(shown).iter().zip(list(expected)) {
        for key in ["edge", "next", "pivots", "theta_t_deg", "theta_1_deg"] {
            assert_eq!(shown[key], expected[key]);
        }
        assert_encloses(&expected["height"], &shown["height"]);
        for (list_name, word) in [("intervals", "action"), ("topple", "edge")] {
            assert_eq!(list(&shown[list_name]).len(), list(&expected[list_name]).len());
            for (shown, expected) in list(&shown[list_name]).iter().zip(list(&expected[list_name])) {
                assert_eq!(shown[word], expected[word]);
                assert_encloses(&expected["from"], &shown["from"]);
                assert_eq!(shown["to"].is_null(), expected["to"].is_null());
                if !expected["to"].is_null() {
                    assert_encloses(&expected["to"], &shown["to"]);
                }
            }
        }
        match expected.get("repeat_over_dip") {
            None => assert_eq!(shown["repeat_over_dip"], Value::Null),
            Some(ends) => {
                assert_encloses(&ends[0], &shown["repeat_over_dip"]["from"]);
                assert_encloses(&ends[1], &shown["repeat_over_dip"]["to"]);
            }
        }
    }
}

fn compare_sequence(shown: &Value, expected: &Value) {
    assert_eq!(shown.is_null(), expected.is_null());
    let pins = |sequence: &Value| sequence.as_array().cloned().unwrap_or_default();
    assert_eq!(pins(shown).len(), pins(expected).len());
    for (shown, expected) in pins(shown).iter().zip(pins(expected)) {
        assert_eq!(number(&shown["height"]), number(&expected["height"]));
        assert_encloses(&expected["from"], &shown["low"]);
        assert_encloses(&expected["to"], &shown["high"]);
        assert_eq!(shown["after"], expected["after"]);
        let mut ends: Vec<usize> = shown["outcome"].as_object().unwrap().values().map(edge).collect();
        ends.sort_unstable();
        ends.dedup();
        assert_eq!(ends, edges(&expected["after"]));
        assert!(number(&shown["tolerance"]) > ratio(0, 1));
    }
}

fn compare_queries(shown: &Value, expected: &Value) {
    assert_eq!(list(shown).len(), list(expected).len());
    for (shown, expected) in list(shown).iter().zip(list(expected)) {
        assert_eq!(number(&shown["height"]), number(&expected["height"]));
        for key in ["actions", "outcomes"] {
            assert_eq!(shown[key], expected[key]);
        }
        assert_eq!(shown["critical_for"], expected.get("critical_for").cloned().unwrap_or(json!([])));
    }
}

/// With edge 3 down the pentagon is 6 sqrt(2) high; a closed form of a published decimal.
#[test]
fn heights_that_are_not_rational_are_isolated_roots() {
    let mut published = Published::new("pentagon");
    let height = Polynomial::from([-72, 0, 1]).real_roots(ratio(0, 1)..).unwrap().remove(0);
    published.answer.orientations[3].height = height;
    let shown = &document(&published)["result"]["orientations"][3]["height"];
    assert_eq!(shown["polynomial"], json!([-72, 0, 1]));
    let [lower, upper] = [number(&shown["lower"]), number(&shown["upper"])];
    assert!(lower < upper && &lower * &lower < ratio(72, 1) && &upper * &upper > ratio(72, 1));
    assert!(&upper - &lower <= &lower * ratio(1, 10).pow(20_i32));
    assert!((shown["value"].as_f64().unwrap() - 72_f64.sqrt()).abs() < 4e-15);
    let published = number(&published.expected["orientations"][3]["height"][0]);
    assert!((&lower - &published) < ratio(1, 10).pow(18_i32) && (&published - &lower) < ratio(1, 10).pow(18_i32));
    assert!(shown["lower"].as_str().unwrap().contains('/'));
}

#[test]
fn a_rational_root_is_shown_as_the_rational_that_it_is() {
    let mut published = Published::new("pentagon");
    // (x - 7) (x² - 2) (x² + 1)
    let roots = Polynomial::from([14, -2, 7, -1, -7, 1]).real_roots(ratio(2, 1)..).unwrap();
    assert_eq!(roots.len(), 1);
    published.answer.orientations[0].height = roots[0].clone();
    assert_eq!(document(&published)["result"]["orientations"][0]["height"], json!(7));
}

#[test]
fn what_is_uncertain_is_null() {
    let mut published = Published::new("pentagon");
    published.answer.orientations[0].intervals[1].action = None;
    let query = &mut published.answer.queries[0];
    query.actions.insert(2, None);
    query.actions.insert(3, Some(PinAction::FallBack));
    let document = document(&published);
    assert_eq!(document["result"]["orientations"][0]["intervals"][1]["action"], Value::Null);
    let query = &document["result"]["queries"][0];
    assert_eq!((&query["actions"]["2"], &query["actions"]["3"]), (&Value::Null, &json!("fall-back")));
}

#[test]
fn ranges_tolerances_and_what_was_asked_are_in_the_document() {
    let mut published = Published::new("three_pins");
    published.case.part.center_of_mass_tolerance = ratio(1, 20);
    let conveyor = published.case.conveyor.as_mut().unwrap();
    conveyor.belt_friction = Range { min: ratio(1, 1), max: ratio(4, 3) };
    published.answer.plan.pareto =
        vec![Tradeoff { pins: 3, tolerance: ratio(1, 16) }, Tradeoff { pins: 5, tolerance: ratio(1, 9) }];
    let ride = Ride { end: Some(1), max_pins: Some(5), ..published.ride() };
    let result = &json::pins(&ride, &published.answer)["result"];
    assert_eq!(result["belt_friction"], json!({ "min": 1, "max": "4/3" }));
    assert_eq!((&result["pin_friction"], &result["center_of_mass_tolerance"]), (&json!("1/20"), &json!("1/20")));
    assert_eq!(result["asked"], json!({ "end": 1, "max_pins": 5 }));
    let pareto = json!([{ "pins": 3, "tolerance": "1/16" }, { "pins": 5, "tolerance": "1/9" }]);
    assert_eq!(result["plan"]["pareto"], pareto);
    assert_eq!((&result["plan"]["final"], &result["plan"]["final_edges"]), (&json!(1), &json!([1])));
}

#[test]
fn edges_that_look_the_same_are_all_final() {
    let document = document(&Published::new("hexagon_order_2"));
    let plan = &document["result"]["plan"];
    assert_eq!((&plan["final"], &plan["final_edges"]), (&json!(2), &json!([2, 5])));
}

#[test]
fn a_wiper_tells_its_pins_and_its_yield() {
    let mut published = Published::new("pentagon");
    let pins = Published::new("hexagon_order_2").answer.plan.sequence.unwrap();
    let wiper = Wiper { pins, discarded: vec![2], kept: 0, yielding: 2 };
    let obstacle = Obstacle { wiper: Some(wiper), ..published.answer.plan.obstacle.clone().unwrap() };
    published.answer.plan.obstacle = Some(obstacle);
    let wiper = &document(&published)["result"]["plan"]["wiper"];
    let told = [&wiper["discarded"], &wiper["kept"], &wiper["yielding"], &wiper["pins"][0]["height"]];
    assert_eq!(told, [&json!([2]), &json!(0), &json!(2), &json!("59/10")]);
}

#[test]
fn more_pins_than_are_allowed_are_no_plan() {
    let mut published = Published::new("three_pins");
    published.answer.plan = PinPlan { needs: Some(3), ..PinPlan::default() };
    let document = document(&published);
    assert_eq!(document["status"], json!("no-plan"));
    assert_eq!((&document["result"]["plan"]["needs"], &document["result"]["plan"]["pins"]), (&json!(3), &Value::Null));
}

#[test]
fn a_limit_leaves_the_question_open() {
    let mut published = Published::new("pentagon");
    published.answer.plan = PinPlan { limit: Some(Limit::Memory), ..PinPlan::default() };
    let open = document(&published);
    assert_eq!(open["status"], json!("undecided"));
    let plan = &open["result"]["plan"];
    assert_eq!((&plan["pins"], &plan["complete"], &plan["limit"]), (&Value::Null, &json!(false), &json!("memory")));
    let over = json::undecided_pins(&published.ride(), Limit::Time);
    assert_eq!((&over["status"], &over["schema"]), (&json!("undecided"), &json!("plan.pins/1")));
    assert_eq!((&over["result"]["limit"], &over["result"]["belt_friction"]), (&json!("time"), &json!("4/3")));
}

#[test]
fn the_least_height_is_zero_itself() {
    let mut published = Published::new("square");
    published.answer.orientations[0].intervals[0].from = Algebraic::from(ratio(0, 1));
    assert_eq!(document(&published)["result"]["orientations"][0]["intervals"][0]["from"], json!(0));
}
