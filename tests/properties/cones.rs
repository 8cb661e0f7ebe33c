//! Cones of single modes.

use crate::support::member::{in_cone, landmarks};
use crate::support::modes::{Contacts, breaking};
use crate::support::random::{Setup, any_setup, degenerate, mode_choices, polygons, runs, single_friction, wrenches};
use crate::support::{Wrench, paper};
use partplan::answer::{CanonicalCone, Cone};
use partplan::mechanics::Mode;
use partplan::planner::{Question, mode_cones, stability};
use proptest::prelude::*;

/// The planner's cones of `modes`.
pub fn ours((part, fixture): &Setup, modes: &[String], strict_s: bool) -> Vec<Cone> {
    let modes: Vec<Mode> = modes.iter().map(|mode| mode.parse().expect("letters")).collect();
    let question = Question { modes, strict_s, ..Question::default() };
    mode_cones(part, fixture, &question).expect("one letter per fixel").into_iter().map(|(_, cone)| cone).collect()
}

fn in_the_letters_of_the_oracle(mode: &str, strict_s: bool) -> String {
    if strict_s { breaking(mode) } else { mode.to_owned() }
}

/// Excluded faces come in no order that a contract fixes.
fn ordered(cone: Cone) -> Cone {
    match cone {
        Cone::Of(CanonicalCone { mut excluded, dim, equalities, faces, lines, rays }) => {
            excluded.sort_by(|a, b| a.tight.cmp(&b.tight));
            Cone::Of(CanonicalCone { excluded, dim, equalities, faces, lines, rays })
        }
        Cone::Empty => Cone::Empty,
    }
}

/// Random wrenches, and where the cone has generators the sums of those.
fn probes(cone: &Cone, random: &[Wrench]) -> Vec<Wrench> {
    let mut probes = random.to_vec();
    if let Cone::Of(cone) = cone {
        let landmarks = landmarks(cone);
        probes.extend(landmarks.iter().step_by(landmarks.len() / 12 + 1).cloned());
        probes.extend(landmarks.last().cloned());
    }
    probes
}

fn check_against_programs(
    setup: &Setup,
    modes: &[String],
    strict_s: bool,
    random: &[Wrench],
) -> Result<(), TestCaseError> {
    let contacts = Contacts::of(&setup.0, &setup.1);
    for (mode, cone) in modes.iter().zip(ours(setup, modes, strict_s)) {
        let mode = in_the_letters_of_the_oracle(mode, strict_s);
        for g in probes(&cone, random) {
            prop_assert_eq!(
                in_cone(&cone, &g),
                contacts.consistent(&mode, &g),
                "mode {} wrench {:?} {:?}",
                mode,
                g,
                cone
            );
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(runs(60))]

    /// The Minkowski sum of the allowed accelerations and forces is the paper's `K^F P`, Theorem 1.
    #[test]
    fn direct_cones_equal_the_papers_construction(
        setup in polygons(1..=6, single_friction()),
        choices in mode_choices(4),
        strict_s in any::<bool>(),
    ) {
        let contacts = Contacts::of(&setup.0, &setup.1);
        let modes: Vec<String> = choices.iter().map(|choice| choice.letters(&contacts)).collect();
        for (mode, cone) in modes.iter().zip(ours(&setup, &modes, strict_s)) {
            let theirs = paper::mode_cone(&contacts, &in_the_letters_of_the_oracle(mode, strict_s));
            prop_assert_eq!(ordered(cone), ordered(theirs), "mode {}", mode);
        }
    }

    /// Forces may vanish, so a mode has wrenches exactly when it has accelerations.
    #[test]
    fn a_cone_is_empty_exactly_when_no_acceleration_has_the_mode(
        setup in any_setup(1..=6),
        choices in mode_choices(6),
        strict_s in any::<bool>(),
    ) {
        let contacts = Contacts::of(&setup.0, &setup.1);
        let modes: Vec<String> = choices.iter().map(|choice| choice.letters(&contacts)).collect();
        for (mode, cone) in modes.iter().zip(ours(&setup, &modes, strict_s)) {
            let feasible = contacts.feasible(&in_the_letters_of_the_oracle(mode, strict_s));
            prop_assert_eq!(cone == Cone::Empty, !feasible, "mode {}", mode);
        }
    }
}

proptest! {
    #![proptest_config(runs(40))]

    #[test]
    fn a_wrench_is_in_a_mode_cone_exactly_when_motion_and_forces_exist(
        setup in any_setup(1..=5),
        choices in mode_choices(2),
        strict_s in any::<bool>(),
        random in wrenches(4),
    ) {
        let contacts = Contacts::of(&setup.0, &setup.1);
        let modes: Vec<String> = choices.iter().map(|choice| choice.letters(&contacts)).collect();
        check_against_programs(&setup, &modes, strict_s, &random)?;
    }

    #[test]
    fn mode_cones_of_degenerate_fixtures_are_right(
        (_, setup) in degenerate(),
        choices in mode_choices(3),
        strict_s in any::<bool>(),
        random in wrenches(3),
    ) {
        let contacts = Contacts::of(&setup.0, &setup.1);
        let modes: Vec<String> = choices.iter().map(|choice| choice.letters(&contacts)).collect();
        check_against_programs(&setup, &modes, strict_s, &random)?;
    }

    /// With static friction at least kinetic every wrench has a solution, so the modes cover everything.
    #[test]
    fn mode_cones_together_are_everything(setup in polygons(1..=5, single_friction()), random in wrenches(6)) {
        let modes = stability(&setup.0, &setup.1, &Question::default()).expect("no modes are asked for").feasible_modes;
        let cones = ours(&setup, &modes, true);
        let mut probes = random;
        for cone in &cones {
            if let Cone::Of(cone) = cone {
                probes.extend(landmarks(cone).into_iter().take(8));
            }
        }
        for g in probes {
            prop_assert!(cones.iter().any(|cone| in_cone(cone, &g)), "no mode of {:?} allows {:?}", modes, g);
        }
    }

    #[test]
    fn feasible_modes_are_those_that_some_acceleration_has(setup in any_setup(1..=5)) {
        let ours = stability(&setup.0, &setup.1, &Question::default()).expect("no modes are asked for").feasible_modes;
        let mut theirs: Vec<String> = Contacts::of(&setup.0, &setup.1)
            .feasible_modes("blrn")
            .iter()
            .map(|mode| mode.replace('b', "s"))
            .collect();
        theirs.sort();
        prop_assert_eq!(ours, theirs);
    }
}
