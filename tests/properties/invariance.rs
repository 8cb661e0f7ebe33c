//! What must not matter: lengths of normals, units, mass, the frame, the order of fixels.

use crate::support::Wrench;
use crate::support::random::{Setup, any_friction, polygons, runs, wrenches};
use partplan::answer::{Cone, FingerSet, Insertion, Stability, StateModes, Witness};
use partplan::exact::{Q, Z, ratio};
use partplan::geometry::Polygon;
use partplan::model::Shape;
use partplan::planner::{Question, insertion, stability};
use proptest::prelude::*;

fn answers((part, fixture): &Setup, wrenches: Vec<Wrench>) -> (Insertion, Stability) {
    let question = Question { wrenches, ..Question::default() };
    let no_modes = "no modes are asked for";
    let insert = insertion(part, fixture, &question).expect(no_modes);
    let mut answers = (insert, stability(part, fixture, &question).expect(no_modes));
    for verdict in answers.0.wrenches.iter_mut().chain(&mut answers.1.wrenches) {
        verdict.witness = Witness::default(); // accelerations and forces are those of one mass, frame and order
    }
    answers
}

/// Modes consistent with each wrench, in the seated state and in the others.
fn consistent((part, fixture): &Setup, wrenches: &[Wrench]) -> Vec<(Vec<String>, Vec<StateModes>)> {
    let question = Question { wrenches: wrenches.to_vec(), ..Question::default() };
    let verdicts = stability(part, fixture, &question).expect("no modes are asked for").wrenches;
    let modes = |witness: Witness| (witness.consistent.into_iter().map(|motion| motion.mode).collect(), witness.states);
    verdicts.into_iter().map(|verdict| modes(verdict.witness)).collect()
}

/// The wrenches that change most verdicts: sums of generators of the weak cone and of the cells.
fn probes(setup: &Setup, random: &[Wrench]) -> Vec<Wrench> {
    let (insert, stable) = answers(setup, vec![]);
    let cells = insert.goal.cells.into_iter().chain(stable.strong.cells).chain([stable.weak]);
    let generators =
        cells.filter_map(|cell| if let Cone::Of(cone) = cell { Some([cone.rays, cone.lines].concat()) } else { None });
    let on_faces = generators.flatten().map(|ray: Vec<Z>| std::array::from_fn(|i| Q::from_integer(ray[i].clone())));
    random.iter().cloned().chain(on_faces).take(60).collect()
}

/// Exchanges the outline and the fixels for their images.
fn mapped(setup: &Setup, image: impl Fn(&[Q; 2]) -> [Q; 2], turned: impl Fn(&[Q; 2]) -> [Q; 2]) -> Setup {
    let (mut part, mut fixture) = setup.clone();
    let Shape::Polygon(polygon) = &part.shape else { panic!("only polygons are drawn here") };
    part.shape = Shape::Polygon(Polygon::new(polygon.vertices().iter().map(&image).collect()).expect("still simple"));
    part.center_of_mass = image(&part.center_of_mass);
    for fixel in &mut fixture.fixels {
        fixel.point = image(&fixel.point);
        fixel.normal = turned(&fixel.normal);
    }
    (part, fixture)
}

/// Shares of the edge and closed ends of the intervals of one edge.
type EdgeShares = (usize, Vec<([Q; 2], [bool; 2])>);

fn shares(fingers: &FingerSet) -> Vec<EdgeShares> {
    let FingerSet::Edges(edges) = fingers else { panic!("a polygon's finger places are on edges") };
    edges.iter().map(|e| (e.edge, e.intervals.iter().map(|i| (i.s.clone(), i.closed)).collect())).collect()
}

/// Verdicts, finger places and modes agree once each wrench is replaced by its image.
fn check_same(
    setup: &Setup,
    image: &Setup,
    random: &[Wrench],
    map: impl Fn(&Wrench) -> Wrench,
) -> Result<(), TestCaseError> {
    let probes = probes(setup, random);
    let images = probes.iter().map(map).collect();
    let ((insert, stable), (insert_image, stable_image)) = (answers(setup, probes), answers(image, images));
    for (ours, theirs) in insert.wrenches.iter().zip(&insert_image.wrenches) {
        let verdict = |v: &partplan::answer::WrenchVerdict| (v.weak, v.strong, v.goal);
        prop_assert_eq!(verdict(ours), verdict(theirs), "{:?} and its image {:?}", ours.wrench, theirs.wrench);
    }
    prop_assert_eq!(stable.feasible_modes, stable_image.feasible_modes);
    prop_assert_eq!(stable.force_closure, stable_image.force_closure);
    prop_assert_eq!(insert.empty_because, insert_image.empty_because);
    prop_assert_eq!(shares(&insert.goal_fingers), shares(&insert_image.goal_fingers));
    prop_assert_eq!(shares(&stable.weak_fingers), shares(&stable_image.weak_fingers));
    prop_assert_eq!(shares(&stable.strong_fingers), shares(&stable_image.strong_fingers));
    prop_assert_eq!(shares(&stable.closure_fingers), shares(&stable_image.closure_fingers));
    Ok(())
}

fn factor() -> impl Strategy<Value = Q> {
    (1..9_i64, 1..9_i64).prop_map(|(p, q)| ratio(p, q))
}

proptest! {
    #![proptest_config(runs(24))]

    /// Only the direction of a contact frame means anything.
    #[test]
    fn lengths_of_normals_change_nothing(
        setup in polygons(1..=4, any_friction()),
        factors in proptest::collection::vec(factor(), 4),
        random in wrenches(2),
    ) {
        let mut scaled = setup.clone();
        for (fixel, factor) in scaled.1.fixels.iter_mut().zip(&factors) {
            fixel.normal = [&fixel.normal[0] * factor, &fixel.normal[1] * factor];
        }
        let probes = probes(&setup, &random);
        prop_assert_eq!(consistent(&scaled, &probes), consistent(&setup, &probes));
        prop_assert_eq!(answers(&scaled, probes.clone()), answers(&setup, probes));
    }

    /// A heavier part of the same outline accelerates less, in the same direction.
    #[test]
    fn mass_changes_nothing(setup in polygons(1..=4, any_friction()), factor in factor(), random in wrenches(2)) {
        let mut heavier = setup.clone();
        heavier.0.mass *= &factor;
        heavier.0.inertia *= &factor;
        let probes = probes(&setup, &random);
        prop_assert_eq!(consistent(&heavier, &probes), consistent(&setup, &probes));
        prop_assert_eq!(answers(&heavier, probes.clone()), answers(&setup, probes));
    }

    /// Lengths times c: torques times c, inertia times c^2.
    #[test]
    fn units_of_length_change_nothing(setup in polygons(1..=4, any_friction()), factor in factor(), random in wrenches(2)) {
        let mut image = mapped(&setup, |p| [&p[0] * &factor, &p[1] * &factor], Clone::clone);
        image.0.inertia *= &factor * &factor;
        check_same(&setup, &image, &random, |g| [g[0].clone(), g[1].clone(), &g[2] * &factor])?;
        let volumes = |setup: &Setup| {
            let (insert, stable) = answers(setup, vec![]);
            [insert.goal.volume_in_box, insert.hold.volume_in_box, stable.strong.volume_in_box]
        };
        prop_assert_eq!(volumes(&setup), volumes(&image));
    }

    /// The part and its fixels turned by a rational rotation and moved.
    #[test]
    fn frames_change_nothing(setup in polygons(1..=3, any_friction()), shift in -5..=5_i64, random in wrenches(2)) {
        let (c, s) = (ratio(3, 5), ratio(4, 5));
        let turned = |d: &[Q; 2]| [&c * &d[0] - &s * &d[1], &s * &d[0] + &c * &d[1]];
        let image = mapped(&setup, |p| turned(p).map(|x| x + ratio(shift, 3)), turned);
        check_same(&setup, &image, &random, |g| {
            let [x, y] = turned(&[g[0].clone(), g[1].clone()]);
            [x, y, g[2].clone()]
        })?;
    }

    #[test]
    fn the_order_of_fixels_changes_no_set(setup in polygons(2..=4, any_friction()), random in wrenches(2)) {
        let mut rotated = setup.clone();
        rotated.1.fixels.rotate_left(1);
        let probes = probes(&setup, &random);
        let ((insert, stable), (insert_rotated, stable_rotated)) = (answers(&setup, probes.clone()), answers(&rotated, probes));
        prop_assert_eq!(&insert.goal.volume_in_box, &insert_rotated.goal.volume_in_box);
        prop_assert_eq!(&insert.hold.volume_in_box, &insert_rotated.hold.volume_in_box);
        prop_assert_eq!(&stable.strong.volume_in_box, &stable_rotated.strong.volume_in_box);
        prop_assert_eq!(insert.wrenches, insert_rotated.wrenches);
        prop_assert_eq!(insert.goal_fingers, insert_rotated.goal_fingers);
        prop_assert_eq!(insert.goal_tilt, insert_rotated.goal_tilt);
        prop_assert_eq!(stable.weak, stable_rotated.weak);
        prop_assert_eq!(stable.strong_fingers, stable_rotated.strong_fingers);
        prop_assert_eq!(stable.strong_tilt, stable_rotated.strong_tilt);
    }

    /// A second fixel in the same place holds nothing more, and ends all certainty that both are touched.
    #[test]
    fn a_repeated_fixel_changes_what_holds_nowhere(setup in polygons(1..=3, any_friction()), random in wrenches(4)) {
        let mut doubled = setup.clone();
        let last = doubled.1.fixels.last().expect("at least one fixel").clone();
                doubled.1.fixels.push(last);
        let probes = probes(&setup, &random);
        let ((_, once), (insert, twice)) = (answers(&setup, probes.clone()), answers(&doubled, probes));
        prop_assert_eq!(&once.weak, &twice.weak);
        let strong = |stable: &Stability| -> Vec<bool> { stable.wrenches.iter().map(|v| v.strong).collect() };
        prop_assert_eq!(strong(&once), strong(&twice));
        prop_assert!(insert.goal.is_empty());
    }
}
