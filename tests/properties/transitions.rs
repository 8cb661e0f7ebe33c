//! The transition graph on sets of achieved contacts, by linear programs.

use crate::support::Wrench;
use crate::support::member::{in_cone, in_region, landmarks};
use crate::support::modes::Contacts;
use crate::support::random::{Setup, any_setup, runs, seatable, wrenches};
use partplan::answer::{CanonicalCone, Cone, Insertion};
use partplan::exact::ratio;
use partplan::mechanics::Mode;
use partplan::model::Range;
use partplan::planner::{Question, insertion, mode_cones};
use proptest::prelude::*;

fn answer((part, fixture): &Setup, wrenches: &[Wrench]) -> Insertion {
    let question = Question { wrenches: wrenches.to_vec(), ..Question::default() };
    insertion(part, fixture, &question).expect("no modes are asked for")
}

/// Wrenches on the faces of the sets' cells, evenly picked.
fn on_faces(answer: &Insertion, count: usize) -> Vec<Wrench> {
    let cells = answer.acyclic.cells.iter().chain(&answer.unrefuted.cells).chain(&answer.goal.cells);
    let points = cells.filter_map(|cell| if let Cone::Of(cone) = cell { Some(landmarks(cone)) } else { None });
    let points: Vec<Wrench> = points.flatten().collect();
    points.iter().step_by(points.len() / count + 1).cloned().collect()
}

/// Whether nothing refutes insertion from rest: no unseated state rests on its contacts, no seated contact can break.
fn is_unrefuted(contacts: &Contacts, g: &Wrench) -> bool {
    let n = contacts.list.len();
    let rests = |free: usize| {
        let mut list = contacts.list.clone();
        list.remove(free);
        for contact in &mut list {
            contact.friction.static_.min = contact.friction.static_.max.clone();
        }
        Contacts { list, rho2: contacts.rho2.clone() }.weak(g)
    };
    let breaks = |mode: &String| mode.contains('b') && contacts.consistent(mode, g);
    !(0..n).any(rests) && !contacts.feasible_modes("blrn").iter().any(breaks)
}

fn check(setup: &Setup, random: &[Wrench], faces: usize) -> Result<(), TestCaseError> {
    let contacts = Contacts::of(&setup.0, &setup.1);
    let mut probes = random.to_vec();
    probes.extend(on_faces(&answer(setup, &[]), faces));
    let answer = answer(setup, &probes);
    for (verdict, g) in answer.wrenches.iter().zip(&probes) {
        prop_assert_eq!(verdict.acyclic, contacts.acyclic(g), "acyclic {:?}", g);
        prop_assert_eq!(verdict.unrefuted, is_unrefuted(&contacts, g), "unrefuted {:?}", g);
        prop_assert_eq!(in_region(&answer.acyclic, g), verdict.acyclic, "cells of acyclic {:?}", g);
        prop_assert_eq!(in_region(&answer.unrefuted, g), verdict.unrefuted, "cells of unrefuted {:?}", g);
        prop_assert!(!verdict.goal || verdict.acyclic, "goal is inside acyclic: {:?}", g);
        prop_assert!(!verdict.acyclic || verdict.unrefuted, "acyclic is inside unrefuted: {:?}", g);
    }
    prop_assert!(answer.goal.volume_in_box <= answer.acyclic.volume_in_box);
    prop_assert!(answer.acyclic.volume_in_box <= answer.unrefuted.volume_in_box);
    prop_assert_eq!(answer.acyclic.is_empty(), answer.empty_because.is_some());
    prop_assert_eq!(answer.acyclic.is_empty(), answer.plan.is_none());
    Ok(())
}

/// Strictly inside every face of a full cone.
fn in_interior(cone: &CanonicalCone, g: &Wrench) -> bool {
    let mut open = cone.clone();
    open.faces.iter_mut().for_each(|face| face.strict = true);
    cone.dim == 3 && in_cone(&Cone::Of(open), g)
}

proptest! {
    #![proptest_config(runs(16))]

    #[test]
    fn transitions_are_those_of_the_definition(setup in any_setup(1..=3), random in wrenches(3)) {
        check(&setup, &random, 6)?;
    }

    #[test]
    fn transitions_of_fixtures_that_seat_are_those_of_the_definition(setup in seatable(), random in wrenches(2)) {
        check(&setup, &random, 7)?;
    }

    /// Without friction the graph has no cycle exactly inside the wrenches that press the seated part on every fixel.
    #[test]
    fn without_friction_acyclic_is_the_interior_of_what_holds_the_seat(
        setup in prop_oneof![any_setup(1..=3), seatable()],
        random in wrenches(4),
    ) {
        let (part, mut fixture) = setup;
        for fixel in &mut fixture.fixels {
            fixel.friction.static_ = Range::exactly(ratio(0, 1));
            fixel.friction.kinetic = Range::exactly(ratio(0, 1));
        }
        let setup = (part, fixture);
        let seated = Mode(vec![partplan::mechanics::Interaction::Maintain; setup.1.fixels.len()]);
        let question = Question { modes: vec![seated], ..Question::default() };
        let held = mode_cones(&setup.0, &setup.1, &question).expect("a letter per fixel").remove(0).1;
        let mut probes = random;
        probes.extend(on_faces(&answer(&setup, &[]), 12));
        if let Cone::Of(cone) = &held {
            probes.extend(landmarks(cone));
        }
        let answer = answer(&setup, &probes);
        let is_dependent = answer.empty_because.is_some();
        for (verdict, g) in answer.wrenches.iter().zip(&probes) {
            let inside = matches!(&held, Cone::Of(cone) if in_interior(cone, g));
            prop_assert_eq!(verdict.acyclic, inside && !is_dependent, "{:?}", g);
        }
    }
}
