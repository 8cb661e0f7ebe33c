//! The sets made of several cones: weak, strong, goal, hold.

use crate::support::Wrench;
use crate::support::member::{in_cone, in_region, landmarks};
use crate::support::modes::{Contacts, unseating_modes};
use crate::support::random::{
    Setup, any_friction, any_setup, degenerate, discs, polygons, runs, seatable, widened, wrenches,
};
use partplan::answer::{Cone, EmptyReason, Insertion, Region, Stability};
use partplan::exact::ratio;
use partplan::planner::{Question, insertion, stability};
use proptest::prelude::*;

fn answers((part, fixture): &Setup, wrenches: &[Wrench]) -> (Insertion, Stability) {
    let question = Question { wrenches: wrenches.to_vec(), ..Question::default() };
    let no_modes = "no modes are asked for";
    (insertion(part, fixture, &question).expect(no_modes), stability(part, fixture, &question).expect(no_modes))
}

/// Wrenches on the faces of the sets' cells, evenly picked.
fn on_faces((goal, stable): &(Insertion, Stability), count: usize) -> Vec<Wrench> {
    let cells = goal.goal.cells.iter().chain(&stable.strong.cells).chain([&stable.weak]);
    let points = cells.filter_map(|cell| if let Cone::Of(cone) = cell { Some(landmarks(cone)) } else { None });
    let points: Vec<Wrench> = points.flatten().collect();
    points.iter().step_by(points.len() / count + 1).cloned().collect()
}

/// Every set's verdicts and cells against the programs, on random wrenches and on faces.
fn check_sets(setup: &Setup, random: &[Wrench], faces: usize) -> Result<(), TestCaseError> {
    let contacts = Contacts::of(&setup.0, &setup.1);
    let moving = contacts.moving_modes();
    let mut probes = random.to_vec();
    probes.extend(on_faces(&answers(setup, &[]), faces));
    let (goal, stable) = answers(setup, &probes);
    for (i, g) in probes.iter().enumerate() {
        let (weak, strong, seats) = (contacts.weak(g), contacts.strong(&moving, g), contacts.goal(g));
        for verdict in [&goal.wrenches[i], &stable.wrenches[i]] {
            prop_assert_eq!((verdict.weak, verdict.strong, verdict.goal), (weak, strong, seats), "verdicts on {:?}", g);
        }
        prop_assert_eq!(in_cone(&stable.weak, g), weak, "weak {:?}", g);
        prop_assert_eq!(in_region(&stable.strong, g), strong, "strong {:?}", g);
        prop_assert_eq!(in_region(&goal.goal, g), seats, "goal {:?}", g);
        prop_assert_eq!(in_region(&goal.hold, g), seats && strong, "hold {:?}", g);
    }
    Ok(())
}

/// What a region says about itself fits its cells.
fn check_summary(region: &Region) -> Result<(), TestCaseError> {
    let dimensions =
        region.cells.iter().filter_map(|cell| if let Cone::Of(cone) = cell { Some(cone.dim) } else { None });
    prop_assert_eq!(region.dim, dimensions.max());
    prop_assert_eq!(region.has_interior(), region.volume_in_box > ratio(0, 1));
    prop_assert!(region.volume_in_box <= ratio(1, 1));
    prop_assert!(!region.everything || region.volume_in_box == ratio(1, 1));
    Ok(())
}

proptest! {
    #![proptest_config(runs(24))]

    #[test]
    fn sets_hold_the_wrenches_that_the_programs_admit(setup in any_setup(1..=4), random in wrenches(5)) {
        check_sets(&setup, &random, 7)?;
    }

    #[test]
    fn sets_of_degenerate_fixtures_are_right((_, setup) in degenerate(), random in wrenches(3)) {
        check_sets(&setup, &random, 6)?;
    }

    #[test]
    fn sets_of_fixtures_that_seat_are_right(setup in seatable(), random in wrenches(3)) {
        check_sets(&setup, &random, 8)?;
    }

    #[test]
    fn sets_of_discs_are_right(setup in discs(1..=3, any_friction()), random in wrenches(4)) {
        check_sets(&setup, &random, 6)?;
    }
}

proptest! {
    #![proptest_config(runs(40))]

    #[test]
    fn regions_describe_their_cells(setup in any_setup(1..=4)) {
        let (goal, stable) = answers(&setup, &[]);
        for region in [&goal.goal, &goal.acyclic, &goal.hold, &goal.unrefuted, &stable.strong] {
            check_summary(region)?;
        }
        prop_assert!(goal.hold.volume_in_box <= goal.goal.volume_in_box);
        prop_assert!(goal.hold.volume_in_box <= stable.strong.volume_in_box);
        prop_assert_eq!(goal.acyclic.is_empty(), goal.empty_because.is_some());
        let is_everything = matches!(&stable.weak, Cone::Of(cone) if cone.lines.len() == 3);
        prop_assert_eq!(stable.force_closure, is_everything);
    }

    /// The reason given for an empty goal is itself a claim about wrenches: the modes named leave none out.
    #[test]
    fn an_empty_goal_has_a_true_reason(setup in any_setup(2..=4), random in wrenches(6)) {
        let contacts = Contacts::of(&setup.0, &setup.1);
        let blocking: Vec<String> = match answers(&setup, &[]).0.empty_because {
            None => return Ok(()),
            Some(EmptyReason::BlockingModes { modes }) => modes,
            Some(EmptyReason::DependentNormals) => unseating_modes(contacts.list.len()),
            Some(EmptyReason::PairForceClosure { fixels }) => {
                let pair = fixels.map(|i| contacts.list[i].clone()).to_vec();
                let mut pair = Contacts { list: pair, rho2: contacts.rho2 };
                for contact in &mut pair.list {
                    contact.friction.static_.min = contact.friction.static_.max.clone();
                }
                for g in &random {
                    prop_assert!(pair.weak(g), "fixels {:?} cannot balance {:?}", fixels, g);
                }
                return Ok(());
            }
        };
        for g in &random {
            let blocks = blocking.iter().any(|mode| contacts.consistent(mode, g));
            prop_assert!(blocks, "none of {:?} allows {:?}", blocking, g);
        }
    }

    /// More fixels than a plane body has freedoms cannot all be touched for certain.
    #[test]
    fn four_fixels_are_never_seated_for_certain(setup in polygons(4..=5, any_friction()), random in wrenches(2)) {
        let goal = answers(&setup, &random).0;
        prop_assert!(goal.goal.is_empty() && goal.hold.is_empty());
        prop_assert_eq!(goal.empty_because, Some(EmptyReason::DependentNormals));
        let contacts = Contacts::of(&setup.0, &setup.1);
        for g in &random {
            prop_assert!(!contacts.goal(g), "{:?} seats four fixels", g);
        }
    }

    #[test]
    fn three_fixels_on_a_disc_are_never_seated_for_certain(setup in discs(3..=3, any_friction()), random in wrenches(3)) {
        prop_assert!(answers(&setup, &[]).0.goal.is_empty());
        let contacts = Contacts::of(&setup.0, &setup.1);
        for g in &random {
            prop_assert!(!contacts.goal(g), "{:?} seats a disc on three fixels", g);
        }
    }

    /// A wider range admits more of every mode, and less certainty.
    #[test]
    fn wider_friction_ranges_never_enlarge_what_is_certain(
        setup in prop_oneof![any_setup(1..=3), seatable()],
        by in (1..5_i64).prop_map(|p| ratio(p, 7)),
        random in wrenches(6),
    ) {
        let mut wide = setup.clone();
        for fixel in &mut wide.1.fixels {
            fixel.friction = widened(&fixel.friction, &by);
        }
        let mut probes = random;
        probes.extend(on_faces(&answers(&wide, &[]), 20));
        probes.extend(on_faces(&answers(&setup, &[]), 20));
        let ((narrow_goal, narrow), (wide_goal, wide)) = (answers(&setup, &probes), answers(&wide, &probes));
        for (i, g) in probes.iter().enumerate() {
            prop_assert!(!wide_goal.wrenches[i].goal || narrow_goal.wrenches[i].goal, "goal {:?}", g);
            prop_assert!(!wide.wrenches[i].strong || narrow.wrenches[i].strong, "strong {:?}", g);
            prop_assert!(!wide.wrenches[i].weak || narrow.wrenches[i].weak, "weak {:?}", g);
        }
        prop_assert!(wide_goal.goal.volume_in_box <= narrow_goal.goal.volume_in_box);
        prop_assert!(wide.strong.volume_in_box <= narrow.strong.volume_in_box);
        prop_assert!(wide_goal.hold.volume_in_box <= narrow_goal.hold.volume_in_box);
    }
}
