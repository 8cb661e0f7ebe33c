//! Proposed places for the fixels: what is claimed of them, planned again from scratch, and against brute force.

mod support;

use num_traits::Signed as _;
use partplan::answer::{Action, EmptyReason, Limit, Proposal, Suggestion};
use partplan::case::{self, Limits};
use partplan::exact::{Q, ratio};
use partplan::geometry::Polygon;
use partplan::model::{Fixel, Fixture, Friction, LengthUnit, Part, Place, Range, Shape};
use partplan::planner::{Question, Stage, SuggestError, insertion, suggest};
use partplan::report::{Subject, json, svg, text};
use serde_json::Value;
use support::int;
use support::random::{Setup, polygon};

fn friction(static_: Q) -> Friction {
    Friction { static_: Range::exactly(static_.clone()), kinetic: Range::exactly(static_) }
}

/// A part of mass 1 with fixels of these coefficients; where they are is left to the search.
fn task(outline: &[(i64, i64)], center: [Q; 2], inertia: Q, coefficients: &[Q]) -> Setup {
    let polygon = polygon(outline);
    let places: Vec<(usize, Q)> = coefficients.iter().map(|_| (0, ratio(1, 2))).collect();
    let frictions: Vec<Friction> = coefficients.iter().cloned().map(friction).collect();
    let fixture = fixture(&polygon, &places, &frictions);
    let part = Part {
        unit: LengthUnit::Metre,
        shape: Shape::Polygon(polygon),
        center_of_mass: center,
        center_of_mass_tolerance: int(0),
        mass: int(1),
        inertia,
    };
    (part, fixture)
}

fn fixture(polygon: &Polygon, places: &[(usize, Q)], frictions: &[Friction]) -> Fixture {
    let fixels = places.iter().zip(frictions).map(|((edge, s), friction)| {
        let [a, b] = polygon.edge(*edge);
        let along = [&b[0] - &a[0], &b[1] - &a[1]];
        Fixel {
            place: Place::Edge { edge: *edge, s: s.clone() },
            point: [&a[0] + s * &along[0], &a[1] + s * &along[1]],
            normal: [-&along[1], along[0].clone()],
            friction: friction.clone(),
        }
    });
    Fixture { fixels: fixels.collect() }
}

fn square(coefficients: &[Q]) -> Setup {
    task(&[(0, 0), (4, 0), (4, 4), (0, 4)], [int(2), int(2)], ratio(8, 3), coefficients)
}

fn triangle(coefficients: &[Q]) -> Setup {
    task(&[(0, 0), (6, 0), (1, 5)], [ratio(7, 3), ratio(5, 3)], ratio(31, 9), coefficients)
}

fn shipped(name: &str) -> Setup {
    let path = format!("{}/cases/{name}.json", env!("CARGO_MANIFEST_DIR"));
    let case = case::read(&std::fs::read(path).unwrap(), &Limits::default()).unwrap_or_else(|_| panic!("{name}"));
    (case.part, case.fixture.expect("a fixture"))
}

fn proposed((part, fixture): &Setup, count: usize) -> Suggestion {
    suggest(part, fixture, count, &mut |_| {}).expect("a polygon")
}

/// The margin of the push or tilt that is recommended; none if neither will do.
fn margin2(part: &Part, fixture: &Fixture) -> Option<Q> {
    let plan = insertion(part, fixture, &Question::default()).expect("no modes are asked for").plan?;
    (!matches!(plan.action, Action::Wrench)).then_some(plan.margin2)
}

fn edges(proposal: &Proposal) -> Vec<usize> {
    let mut edges: Vec<usize> = proposal.places.iter().map(|(edge, _)| *edge).collect();
    edges.sort_unstable();
    edges
}

/// Everything that is claimed of proposals, whatever the part.
fn check((part, case): &Setup, found: &Suggestion, count: usize) {
    let Shape::Polygon(polygon) = &part.shape else { panic!("discs have no proposals") };
    assert!(found.proposals.len() <= count && found.limit.is_none());
    assert_eq!(found.searched.choices, found.searched.of);
    let frictions: Vec<Friction> = case.fixels.iter().map(|fixel| fixel.friction.clone()).collect();
    for proposal in &found.proposals {
        assert!(proposal.places.iter().all(|(_, s)| s.is_positive() && *s < int(1)), "{:?}", proposal.places);
        let fixture = fixture(polygon, &proposal.places, &frictions);
        let parallel =
            |a: &[Q; 2], b: &[Q; 2]| &a[0] * &b[1] == &a[1] * &b[0] && (&a[0] * &b[0] + &a[1] * &b[1]).is_positive();
        for (ours, theirs) in fixture.fixels.iter().zip(&proposal.fixture.fixels) {
            assert_eq!((&ours.place, &ours.point, &ours.friction), (&theirs.place, &theirs.point, &theirs.friction));
            assert!(parallel(&ours.normal, &theirs.normal));
        }
        assert_eq!(margin2(part, &fixture).as_ref(), Some(&proposal.plan.margin2));
        let question = Question { wrenches: vec![proposal.plan.wrench.clone()], critical: true, ..Question::default() };
        let again = insertion(part, &fixture, &question).expect("no modes are asked for");
        assert_eq!(again.plan.as_ref(), Some(&proposal.plan));
        assert!(again.wrenches[0].acyclic);
        assert_eq!(again.critical_friction, proposal.critical_friction);
        assert!(proposal.critical_friction.is_some());
    }
    for (index, proposal) in found.proposals.iter().enumerate() {
        for better in &found.proposals[..index] {
            assert!(better.plan.margin2 >= proposal.plan.margin2, "the best first");
            assert_ne!(edges(better), edges(proposal), "one proposal for each combination of edges");
        }
    }
}

/// The largest margin of fixels at these shares of any edges.
fn brute_force((part, case): &Setup, shares: &[Q]) -> Option<Q> {
    let Shape::Polygon(polygon) = &part.shape else { panic!("only polygons are tried") };
    let frictions: Vec<Friction> = case.fixels.iter().map(|fixel| fixel.friction.clone()).collect();
    let spots: Vec<(usize, Q)> =
        (0..polygon.n_edges()).flat_map(|edge| shares.iter().map(move |s| (edge, s.clone()))).collect();
    let mut choices = vec![Vec::new()];
    for _ in &frictions {
        let extended = |choice: &Vec<(usize, Q)>| {
            spots.iter().map(|spot| [choice.as_slice(), std::slice::from_ref(spot)].concat()).collect::<Vec<_>>()
        };
        choices = choices.iter().flat_map(extended).collect();
    }
    // equal fixels change places without effect
    let are_equal = frictions.iter().all(|friction| *friction == frictions[0]);
    choices.retain(|places| !are_equal || places.is_sorted());
    choices.iter().filter_map(|places| margin2(part, &fixture(polygon, places, &frictions))).max()
}

#[test]
fn proposals_are_what_planning_them_again_says() {
    for (setup, count) in [
        (triangle(&[ratio(1, 10), ratio(1, 10), ratio(1, 10)]), 4),
        (square(&[ratio(1, 5), ratio(0, 1), ratio(1, 5)]), 3),
        (square(&[ratio(1, 4), ratio(1, 2)]), 20),
        (triangle(&[ratio(1, 2)]), 3),
    ] {
        let found = proposed(&setup, count);
        assert!(!found.proposals.is_empty());
        check(&setup, &found, count);
    }
}

#[test]
fn no_fixture_on_a_coarse_grid_is_better() {
    let thirds = [ratio(1, 3), ratio(2, 3)];
    let tenth = ratio(1, 10);
    for (setup, shares) in [
        (triangle(&[tenth.clone(), tenth.clone(), tenth.clone()]), &thirds[..]),
        (square(&[ratio(1, 5), ratio(1, 5), ratio(1, 5)]), &[ratio(1, 4), ratio(3, 4)]),
        (square(&[ratio(0, 1), ratio(3, 5)]), &[ratio(1, 4), ratio(1, 2), ratio(3, 4)]),
        (triangle(&[ratio(1, 2), ratio(1, 5)]), &[ratio(1, 4), ratio(1, 2), ratio(3, 4)]),
    ] {
        let (best, theirs) = (proposed(&setup, 1).proposals.remove(0), brute_force(&setup, shares));
        assert!(theirs.as_ref().is_some_and(|theirs| best.plan.margin2 >= *theirs), "{theirs:?} {best:?}");
    }
}

#[test]
fn two_frictionless_walls_at_right_angles_are_found() {
    // the best push into a corner is even: along the diagonal, at 45 degrees from both normals, and only a tilt has it
    let found = proposed(&square(&[int(0), int(0)]), 1);
    assert_eq!(found.proposals[0].plan.margin2, ratio(1, 2));
    assert!(matches!(found.proposals[0].plan.action, Action::Tilt { .. }));
}

#[test]
fn the_pawl_can_be_held_better_than_it_is() {
    let setup = shipped("pawl");
    let found = proposed(&setup, 1);
    check(&setup, &found, 1);
    let shipped = margin2(&setup.0, &setup.1).expect("the shipped fixels have a plan");
    assert!(found.proposals[0].plan.margin2 > shipped);
}

#[test]
fn the_same_case_gets_the_same_proposals_and_every_step_is_told_in_order() {
    let (part, fixture) = square(&[ratio(1, 5), ratio(1, 5)]);
    let mut told: Vec<(Stage, usize, usize)> = Vec::new();
    let first = suggest(&part, &fixture, 5, &mut |step| {
        assert!(step.done <= step.of && step.so_far.proposals.len() <= 5);
        if step.stage == Stage::Survey {
            assert!(step.so_far.proposals.is_empty());
        }
        told.push((step.stage, step.done, step.of));
    });
    assert_eq!(first, suggest(&part, &fixture, 5, &mut |_| {}));
    let stage = |stage: Stage| told.iter().filter(move |(other, ..)| *other == stage).map(|(_, done, _)| *done);
    // ten ways to choose two edges of four
    assert!(stage(Stage::Survey).eq(0..10));
    assert!(stage(Stage::Plan).enumerate().all(|(index, done)| index == done));
    assert_eq!(stage(Stage::Friction).count(), first.unwrap().proposals.len());
}

/// What a limit leaves is a list of the same kind, and says that it is not the end.
#[test]
fn a_search_that_is_cut_short_has_told_what_it_found() {
    let setup = triangle(&[ratio(1, 5), ratio(1, 5)]);
    let mut left = Suggestion::default();
    let whole = suggest(&setup.0, &setup.1, 2, &mut |step| {
        if step.stage == Stage::Plan && left.proposals.is_empty() {
            left = Suggestion { limit: Some(Limit::Time), ..step.so_far.clone() };
        }
    });
    assert!(whole.is_ok_and(|whole| whole.proposals.len() >= left.proposals.len() && whole.limit.is_none()));
    let [proposal] = &left.proposals[..] else { panic!("one at a time: {left:?}") };
    assert_eq!(margin2(&setup.0, &proposal.fixture).as_ref(), Some(&proposal.plan.margin2));
    let subject = Subject { name: "triangle", part: &setup.0, fixture: &setup.1, warnings: &[] };
    let (words, document) = (text::suggestion(&subject, &left), json::suggestion(&subject, &left));
    assert!(words.contains("the time limit ended the search"), "{words}");
    assert_eq!((&document["status"], &document["result"]["limit"]), (&"plan".into(), &"time".into()));
    assert_eq!(document["result"]["complete"], Value::Bool(false));

    let none = Suggestion { proposals: Vec::new(), ..left };
    assert_eq!(json::suggestion(&subject, &none)["status"], Value::from("undecided"));
}

#[test]
fn fixels_of_different_friction_are_not_interchanged() {
    // 16 choices of two edges for two different fixels, at most one proposal for each of the 10 combinations
    let found = proposed(&square(&[ratio(1, 5), ratio(1, 4)]), 100);
    assert_eq!(found.searched.of, 16);
    assert!(found.proposals.len() <= 10);
    let equal = proposed(&square(&[ratio(1, 5), ratio(1, 5)]), 100);
    assert_eq!(equal.searched.of, 10);
}

#[test]
fn more_than_three_fixels_are_known_to_have_no_plan() {
    let found = proposed(&square(&[int(0), int(0), int(0), int(0)]), 3);
    assert!(found.proposals.is_empty() && found.limit.is_none());
    assert_eq!(found.empty_because, Some(EmptyReason::DependentNormals));
}

#[test]
fn a_disc_has_no_edges() {
    let (part, fixture) = shipped("disc");
    assert_eq!(suggest(&part, &fixture, 3, &mut |_| {}), Err(SuggestError::Disc));
}

#[test]
fn nothing_is_found_where_every_pair_jams() {
    // two fixels of a triangle see each other inside such cones wherever they are
    let found = proposed(&triangle(&[int(40), int(40), int(40)]), 3);
    assert!(found.proposals.is_empty() && found.empty_because.is_none() && found.limit.is_none());
    assert_eq!(brute_force(&triangle(&[int(40), int(40), int(40)]), &[ratio(1, 4), ratio(3, 4)]), None);
}

/// `insert` of a proposal takes the place of the section in the case.
#[test]
fn the_document_can_be_planned_as_a_case() {
    let range = Range { min: ratio(1, 10), max: ratio(1, 5) };
    let (part, mut fixture) = square(&[ratio(1, 5), int(0)]);
    fixture.fixels[1].friction = Friction { static_: range.clone(), kinetic: Range::exactly(ratio(1, 20)) };
    let found = suggest(&part, &fixture, 2, &mut |_| {}).expect("a polygon");
    let subject = Subject { name: "square", part: &part, fixture: &fixture, warnings: &[] };
    let document = json::suggestion(&subject, &found);
    assert_eq!((&document["schema"], &document["status"]), (&"plan.suggest/1".into(), &"plan".into()));
    assert_eq!(document["result"]["complete"], Value::Bool(true));
    for (shown, proposal) in document["result"]["proposals"].as_array().expect("a list").iter().zip(&found.proposals) {
        let outline = serde_json::json!({ "polygon": [[0, 0], [4, 0], [4, 4], [0, 4]] });
        let case = serde_json::json!({
            "part": { "shape": outline, "inertia": "8/3", "mass": 1 },
            "insert": shown["insert"],
        });
        let case = case::read(case.to_string().as_bytes(), &Limits::default()).unwrap_or_else(|_| panic!("{case}"));
        assert_eq!(case.fixture.as_ref(), Some(&proposal.fixture));
        let plan = insertion(&case.part, &proposal.fixture, &Question::default()).expect("no modes").plan;
        assert_eq!(plan.as_ref(), Some(&proposal.plan));
        assert_eq!(shown["plan"]["margin2"], shown["margin2"]);
    }
}

#[test]
fn the_reports_show_every_proposal() {
    let (part, fixture) = square(&[ratio(1, 5), ratio(1, 5), ratio(1, 5)]);
    let found = suggest(&part, &fixture, 2, &mut |_| {}).expect("a polygon");
    let subject = Subject { name: "square", part: &part, fixture: &fixture, warnings: &[] };
    let (words, picture) = (text::suggestion(&subject, &found), svg::suggestion(&subject, &found));
    for number in 1..=2 {
        assert!(words.contains(&format!("proposal {number}")), "{words}");
        assert!(picture.contains(&format!("square: proposal {number} of 2")), "{picture}");
    }
    assert!(words.lines().next().is_some_and(|answer| answer.starts_with("put the fixels on edges ")), "{words}");
}
