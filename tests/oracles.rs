//! The oracles against results of independent implementations, before they judge the planner.

mod support;

use num_traits::Zero;
use partplan::answer::{CanonicalCone, Cone, Face};
use partplan::model::Range;
use serde_json::Value;
use support::cases::{FOUR, NAMES, contacts, expected, rows, strings, wrench_of};
use support::lp::{Program, Relation};
use support::modes::{Contacts, breaking};
use support::{int, paper, q};

#[test]
fn a_strict_program_is_feasible_only_off_its_boundary() {
    let triangle = |relation| {
        let mut program = Program::new(1, 1);
        program.require(vec![int(1), int(1)], relation, int(2));
        program.require(vec![int(-1), int(1)], relation, int(-2));
        program.require(vec![int(0), int(-1)], relation, int(0));
        program
    };
    assert_eq!(triangle(Relation::AtLeast).witness(), Some(vec![int(2), int(0)]));
    assert_eq!(triangle(Relation::Equal).witness(), Some(vec![int(2), int(0)]));
    assert!(!triangle(Relation::Greater).is_feasible());
}

#[test]
fn free_variables_may_be_negative_and_the_others_may_not() {
    let mut program = Program::new(1, 1);
    program.require(vec![int(2), int(0)], Relation::Equal, int(-3));
    program.require(vec![int(0), int(1)], Relation::AtLeast, int(-5));
    assert_eq!(program.witness().map(|x| x[0].clone()), Some(q("-3/2")));
    program.require(vec![int(0), int(-1)], Relation::Greater, Zero::zero());
    assert!(!program.is_feasible());
}

#[test]
fn redundant_equalities_are_dropped_and_contradicting_ones_found() {
    let mut program = Program::new(2, 0);
    for scale in [1, 2, -3] {
        program.require(vec![int(scale), int(scale)], Relation::Equal, int(scale));
    }
    program.require(vec![int(1), int(-1)], Relation::Greater, int(7));
    assert!(program.is_feasible());
    program.require(vec![int(1), int(1)], Relation::Equal, int(2));
    assert!(!program.is_feasible());
}

#[test]
fn linear_programs_reach_the_published_verdict_on_every_wrench() {
    for name in NAMES.into_iter().chain([FOUR]) {
        let (contacts, expected) = (contacts(name), expected(name));
        let moving = contacts.moving_modes();
        // numbers of hundreds of digits cost a second a wrench
        let stride = if name == "n3_huge_rationals" { 7 } else { 1 };
        for entry in expected["wrenches"].as_array().unwrap().iter().step_by(stride) {
            let g = wrench_of(&entry["g"]);
            let verdict = |key: &str, ours: bool| assert_eq!(Value::Bool(ours), entry[key], "{name} {key} {g:?}");
            verdict("weak", contacts.weak(&g));
            verdict("strong", contacts.strong(&moving, &g));
            verdict("goal", contacts.goal(&g));
            let modes = expected["modes"].as_object().unwrap().keys();
            let mut consistent: Vec<String> = modes.filter(|mode| contacts.consistent(mode, &g)).cloned().collect();
            let mut theirs = strings(&entry["modes"]);
            consistent.sort();
            theirs.sort();
            assert_eq!(consistent, theirs, "{name} modes {g:?}");
        }
    }
}

#[test]
fn kinematic_programs_find_the_published_feasible_modes() {
    for name in NAMES.into_iter().chain([FOUR]) {
        let mut ours: Vec<String> =
            contacts(name).feasible_modes("blrn").iter().map(|mode| mode.replace('b', "s")).collect();
        ours.sort();
        assert_eq!(ours, strings(&expected(name)["feasible_modes"]), "{name}");
    }
}

#[test]
fn the_papers_construction_gives_the_published_canonical_cones() {
    for name in NAMES.into_iter().chain([FOUR]) {
        let (contacts, expected) = (contacts(name), expected(name));
        for (mode, cone) in expected["modes"].as_object().unwrap() {
            if !has_ranges(&contacts) {
                assert_eq!(paper::mode_cone(&contacts, mode), published(cone), "{name} {mode}");
            }
        }
        for (mode, cone) in expected["modes_strict_s"].as_object().unwrap() {
            if !has_ranges(&contacts) {
                let ours = paper::mode_cone(&contacts, &breaking(mode));
                assert_eq!(ours, published(cone), "{name} {mode} with s strict");
            }
        }
    }
}

/// The paper's construction takes single friction numbers only.
fn has_ranges(contacts: &Contacts) -> bool {
    let single = |range: &Range| range.min == range.max;
    !contacts.list.iter().all(|c| single(&c.friction.static_) && single(&c.friction.kinetic))
}

fn published(cone: &Value) -> Cone {
    if cone["empty"] == Value::Bool(true) {
        return Cone::Empty;
    }
    let faces = cone["faces"].as_array().unwrap();
    let normals: Value = faces.iter().map(|face| face["normal"].clone()).collect();
    assert_eq!(cone["excluded"], Value::Array(vec![]), "no published cone misses a lower face");
    Cone::Of(CanonicalCone {
        dim: usize::try_from(cone["dim"].as_u64().unwrap()).unwrap(),
        equalities: rows(&cone["equalities"]),
        faces: (rows(&normals).into_iter().zip(faces))
            .map(|(normal, face)| Face { normal, strict: face["strict"] == Value::Bool(true) })
            .collect(),
        excluded: vec![],
        lines: rows(&cone["lines"]),
        rays: rows(&cone["rays"]),
    })
}
