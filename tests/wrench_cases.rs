//! The public wrench cases from file to JSON document, against results of independent exact implementations.

mod support;

use partplan::case::{Limits, read};
use partplan::mechanics::Mode;
use partplan::planner::{Question, insertion, mode_cones, stability};
use partplan::report::{Subject, json};
use serde_json::{Map, Value, json};
use support::cases::{FOUR, NAMES, expected, number, strings, text, wrench_of};

/// The documents of the three commands, and the cones with `s` strict.
struct Documents {
    insert: Value,
    stable: Value,
    cone: Value,
    strict_cone: Value,
}

fn documents(name: &str, expected: &Value) -> Documents {
    let case = read(text(name).as_bytes(), &Limits::default()).unwrap_or_else(|faults| panic!("{name}: {faults:?}"));
    let fixture = case.fixture.expect("every case has an insert section");
    let subject = Subject { name, part: &case.part, fixture: &fixture, warnings: &case.warnings };
    let modes = |key: &str| -> Vec<Mode> {
        expected[key].as_object().unwrap().keys().map(|mode| mode.parse().unwrap()).collect()
    };
    let wrenches = expected["wrenches"].as_array().unwrap().iter().map(|entry| wrench_of(&entry["g"])).collect();
    let question = Question { wrenches, modes: modes("modes"), robust: true, ..Question::default() };
    let strict = Question { modes: modes("modes_strict_s"), strict_s: true, ..Question::default() };
    let cones = |question: &Question| json::cones(&subject, &mode_cones(&case.part, &fixture, question).unwrap());
    Documents {
        insert: json::insertion(&subject, &insertion(&case.part, &fixture, &question).unwrap(), false),
        stable: json::stability(&subject, &stability(&case.part, &fixture, &question).unwrap(), false),
        cone: cones(&question),
        strict_cone: cones(&strict),
    }
}

/// One published value and ours, with the names to find them by.
struct Check<'a> {
    case: &'a str,
    key: String,
}

impl Check<'_> {
    fn of(&self, key: &str) -> Self {
        Self { case: self.case, key: format!("{}.{key}", self.key) }
    }

    fn same(&self, ours: &Value, expected: &Value) {
        let Self { case, key } = self;
        assert!(ours == expected, "case {case}, key {key}\n    ours: {ours}\nexpected: {expected}");
    }

    fn keys(&self, ours: &Value, expected: &Value, keys: &[&str]) {
        for key in keys {
            self.of(key).same(&ours[key], &expected[key]);
        }
    }

    fn cone(&self, ours: &Value, expected: &Value) {
        self.keys(ours, expected, &["empty", "dim", "equalities", "faces", "excluded", "lines", "rays"]);
    }

    fn cones(&self, ours: &Value, expected: &Value) {
        let names = |cones: &Value| cones.as_object().map(|map| map.keys().cloned().collect::<Value>());
        if expected != &Value::Object(Map::new()) {
            self.of("names").same(&json!(names(ours)), &json!(names(expected)));
        }
        for (mode, cone) in expected.as_object().unwrap() {
            self.of(mode).cone(&ours[mode], cone);
        }
    }

    fn region(&self, ours: &Value, expected: &Value) {
        self.keys(ours, expected, &["empty", "dim", "has_interior", "everything"]);
        if !expected["volume_in_box"].is_null() {
            self.keys(ours, expected, &["volume_in_box"]);
        }
        let approx = |document: &Value| document["volume_approx"].as_f64().expect("a decimal view of the volume");
        let (volume, theirs) = (approx(ours), approx(expected));
        let is_near = (volume - theirs).abs() <= 1e-9 * theirs.abs();
        assert!(is_near, "case {}, key {}.volume_approx: {volume}, expected {theirs}", self.case, self.key);
    }

    /// Places on edges, or directions; vertices are only named.
    fn fingers(&self, ours: &Value, expected: &Value) {
        match expected.as_array() {
            Some(edges) => {
                let numbered = |edges: &Value| edges.as_array().map(|e| e.iter().map(|e| e["edge"].clone()).collect());
                self.of("edges").same(&json!(numbered(ours) as Option<Vec<Value>>), &json!(numbered(expected)));
                for (i, edge) in edges.iter().enumerate() {
                    let check = self.of(&i.to_string());
                    let pieces = |edge: &Value| edge["intervals"].as_array().map_or(0, Vec::len);
                    check.of("intervals.length").same(&json!(pieces(&ours[i])), &json!(pieces(edge)));
                    for k in 0..pieces(edge) {
                        let check = check.of(&format!("intervals.{k}"));
                        check.keys(&ours[i]["intervals"][k], &edge["intervals"][k], &["s", "closed", "points"]);
                    }
                }
            }
            None => self.arcs(ours, expected),
        }
    }

    /// The order of arcs says nothing: it depends on the direction where the walk around starts.
    fn arcs(&self, ours: &Value, expected: &Value) {
        self.keys(ours, expected, &["all"]);
        let theirs = expected["arcs"].as_array().unwrap().iter().map(
            |arc| json!({ "from": arc["from"], "to": arc["to"], "closed": [arc["from_closed"], arc["to_closed"]] }),
        );
        let ours = ours["arcs"].as_array().expect("arcs").iter();
        let ours = ours.map(|arc| json!({ "from": arc["from"], "to": arc["to"], "closed": arc["closed"] }));
        self.of("arcs").same(&sorted(ours), &sorted(theirs));
    }

    fn wrenches(&self, ours: &Value, expected: &Value) {
        let theirs = expected.as_array().unwrap();
        self.of("length").same(&json!(ours.as_array().map(Vec::len)), &json!(theirs.len()));
        for (i, entry) in theirs.iter().enumerate() {
            let check = self.of(&i.to_string());
            check.keys(&ours[i], entry, &["g", "weak", "strong", "goal", "acyclic", "unrefuted"]);
            check.of("modes").same(&set(&ours[i]["modes"]), &set(&entry["modes"]));
        }
    }

    /// Contact points exactly; normals up to length, which means nothing.
    fn fixels(&self, ours: &Value, expected: &Value) {
        for (i, fixel) in expected.as_array().unwrap().iter().enumerate() {
            let check = self.of(&format!("fixels.{i}"));
            check.keys(&ours[i], fixel, &["at"]);
            let [ours, theirs] = [&ours[i], fixel].map(|f| [number(&f["normal"][0]), number(&f["normal"][1])]);
            let zero = number(&json!(0));
            let is_parallel = &ours[0] * &theirs[1] == &ours[1] * &theirs[0];
            let is_same_side = &ours[0] * &theirs[0] + &ours[1] * &theirs[1] > zero;
            assert!(is_parallel && is_same_side, "case {}, fixel {i}: normal {ours:?} {theirs:?}", self.case);
        }
    }
}

fn sorted(values: impl Iterator<Item = Value>) -> Value {
    let mut values: Vec<Value> = values.collect();
    values.sort_by_key(Value::to_string);
    values.into()
}

fn set(names: &Value) -> Value {
    sorted(strings(names).into_iter().map(Value::from))
}

fn agrees(name: &str) {
    let expected = expected(name);
    let Documents { insert, stable, cone, strict_cone } = documents(name, &expected);
    let (insert, stable) = (&insert["result"], &stable["result"]);
    let check = Check { case: name, key: "result".into() };
    for document in [insert, stable] {
        check.keys(document, &expected, &["center_of_mass", "rho2", "box"]);
        check.of("wrenches").wrenches(&document["wrenches"], &expected["wrenches"]);
        check.of("modes").cones(&document["modes"], &expected["modes"]);
    }
    check.of("modes").cones(&cone["result"]["modes"], &expected["modes"]);
    check.of("modes_strict_s").cones(&strict_cone["result"]["modes"], &expected["modes_strict_s"]);
    check
        .of("strong.feasible_modes")
        .same(&set(&stable["strong"]["feasible_modes"]), &set(&expected["feasible_modes"]));
    check.of("weak.cone").cone(&stable["weak"]["cone"], &expected["weak"]["cone"]);
    check.of("weak").keys(&stable["weak"], &expected["weak"], &["force_closure"]);
    check.of("strong").region(&stable["strong"], &expected["strong"]);
    check.of("goal").region(&insert["goal"], &expected["goal"]);
    check.of("hold").region(&insert["hold"], &expected["hold"]);
    check.of("acyclic").region(&insert["acyclic"], &expected["acyclic"]);
    check.of("unrefuted").region(&insert["unrefuted"], &expected["unrefuted"]);
    for key in ["closure", "weak", "strong"] {
        check.of("fingers").of(key).fingers(&stable["fingers"][key], &expected["fingers"][key]);
    }
    check.of("fingers.goal").fingers(&insert["fingers"]["goal"], &expected["fingers"]["goal"]);
    check.of("fingers.acyclic").fingers(&insert["fingers"]["acyclic"], &expected["fingers"]["acyclic"]);
    for key in ["weak", "strong"] {
        check.of("tilt").of(key).arcs(&stable["tilt"][key], &expected["tilt"][key]);
    }
    check.of("tilt.goal").arcs(&insert["tilt"]["goal"], &expected["tilt"]["goal"]);
    check.of("tilt.acyclic").arcs(&insert["tilt"]["acyclic"], &expected["tilt"]["acyclic"]);
    check.fixels(&insert["fixels"], &expected["fixels"]);
}

#[test]
fn one_fixel_agrees_with_the_published_results() {
    ["n1_edge", "n1_vertex"].into_iter().for_each(agrees);
}

#[test]
fn two_fixels_agree_with_the_published_results() {
    NAMES.into_iter().filter(|name| name.starts_with("n2")).for_each(agrees);
}

#[test]
fn three_fixels_agree_with_the_published_results() {
    NAMES.into_iter().filter(|name| name.starts_with("n3") && !name.contains("huge")).for_each(agrees);
}

#[test]
fn numbers_of_hundreds_of_digits_agree_with_the_published_results() {
    agrees("n3_huge_rationals");
}

#[test]
fn four_fixels_agree_with_the_published_results() {
    agrees(FOUR);
}
