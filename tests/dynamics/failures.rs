//! The scenes in which rigid contact fails or is hard, each with the answer that is honest: forces and motions that do
//! not exist or are not unique.

use partplan::answer::{Simulation, Status};
use partplan::case::{Limits, read_scene};
use partplan::dynamics::{ModelKind, Options, simulate};
use partplan::model::{Compliance, Planar, Restitution, Scene, World};

pub const AUTO: ModelKind = ModelKind::Auto;
pub const ST: ModelKind = ModelKind::StewartTrinkle;
pub const MOREAU: ModelKind = ModelKind::Moreau;

/// A scene of the folder of hard scenes.
pub fn stability(name: &str) -> World<Planar> {
    let path = format!("{}/cases/stability/{name}.json", env!("CARGO_MANIFEST_DIR"));
    let case = read_scene(&std::fs::read(path).unwrap(), &Limits::default()).unwrap();
    let Scene::Planar(world) = case.scene else { panic!("{name} is spatial") };
    world
}

/// A run with its frames, at the step of the scene, of the ladder or of 1 ms.
pub fn run(world: &World<Planar>, model: ModelKind) -> Simulation<Planar> {
    at(world, model, None)
}

pub fn at(world: &World<Planar>, model: ModelKind, step: Option<f64>) -> Simulation<Planar> {
    let options = Options { model, step, frames: 200_000, forces: true, ..Options::default() };
    simulate(world, &options, &mut |_| true).unwrap()
}

pub fn with_friction(mut world: World<Planar>, friction: f64) -> World<Planar> {
    world.materials.iter_mut().for_each(|material| material.friction = friction);
    world
}

fn with_compliance(mut world: World<Planar>) -> World<Planar> {
    let compliance = Compliance { stiffness: [5e4; 2], damping: [14.142; 2], gamma: 1e-8 };
    world.materials.iter_mut().for_each(|material| material.compliance = Some(compliance));
    world
}

pub fn says(run: &Simulation<Planar>, what: &str) -> bool {
    run.notes.iter().any(|note| note.contains(what))
}

/// Painlevé's rod, tan θ = 2, μ = 2: no finite force exists. Every rigid scheme answers with the impulse that stops the
/// slip without a collision, and says so; as h falls the impulse tends to (0.29966, 0.39733).
#[test]
fn the_inconsistent_rod_is_said_to_have_no_force() {
    let world = stability("painleve_inconsistent");
    for model in [AUTO, ST, MOREAU] {
        let run = run(&world, model);
        assert_eq!(run.status, Status::Inconsistent, "{model:?}");
        assert!(says(&run, "no finite force") && says(&run, "impulse over step is not a force"), "{:?}", run.notes);
    }
    for model in [ST, MOREAU] {
        for h in [1e-3, 1e-4, 1e-5, 1e-6] {
            let run = at(&World { duration: h, ..world.clone() }, model, Some(h));
            let [touch] = &run.last.touches[..] else { panic!("{:?}", run.last) };
            let [n, t, _] = touch.impulse;
            let off = (n - 0.299_661_243_602).abs().max((t.abs() - 0.397_327_198_241).abs());
            // the weight acts for the step, g h, on both
            assert!(off <= 9.81 * h, "{model:?}, h {h}: impulse ({n}, {t})");
        }
    }
}

/// With contacts that give way the same rod has forces: they grow far beyond the weight, and end the slip.
#[test]
fn a_compliant_rod_is_stopped_by_a_growing_force() {
    let world = with_compliance(stability("painleve_inconsistent"));
    let run = at(&world, ModelKind::SongPangKumar, Some(1e-5));
    assert_eq!(run.status, Status::Complete, "{:?}", run.notes);
    let forces = run.frames.iter().flat_map(|frame| &frame.touches).map(|touch| touch.impulse[0] / 1e-5);
    let largest = forces.fold(0.0, f64::max);
    // 57 N at the first stop of the slip in 11 ms are known for this stiffness; 9.81 N is the weight
    assert!(largest > 5.0 * 9.81, "{largest} N");
    let tip = |frame: &partplan::answer::Frame<Planar>| {
        let ([_, y, _], [vx, _, spin]) = (frame.poses[0], frame.velocities[0]);
        vx + spin * y
    };
    assert!((tip(&run.frames[0]) + 1.0).abs() < 1e-12 && tip(&run.last).abs() < 0.15, "{}", tip(&run.last));
    // and the ladder takes it, because rigid contacts have no unique motion
    let ladder = at(&world, AUTO, None);
    assert_eq!((ladder.status, ladder.model.chosen), (Status::Complete, "spk"));
    assert!(ladder.model.why.iter().any(|why| why.contains("no unique motion")), "{:?}", ladder.model.why);
}

/// The rod that may lift off, slide on or jam: every rigid scheme shows one of these and says that there are others.
#[test]
fn the_indeterminate_rod_is_ambiguous() {
    for model in [AUTO, ST, MOREAU] {
        let run = run(&stability("painleve_indeterminate"), model);
        assert_eq!(run.status, Status::Ambiguous, "{model:?}");
        assert!(says(&run, "may lift off, keep sliding under a force, or jam"), "{:?}", run.notes);
    }
}

/// Four contacts under one block: its motion is unique, its forces are not, and only their sum is claimed.
#[test]
fn four_contacts_share_no_particular_force() {
    let world = stability("four_contacts");
    for model in [AUTO, ST, MOREAU] {
        let run = run(&world, model);
        assert_eq!(run.status, Status::Complete, "{model:?}");
        let h = run.model.step;
        for frame in &run.frames[1..] {
            let [x, y, angle] = frame.poses[0];
            assert!(x.abs() < 1e-12 && (y - 0.1).abs() < 1e-12 && angle.abs() < 1e-12, "{:?}", frame.poses[0]);
            let sum: f64 = frame.touches.iter().map(|touch| touch.impulse[0]).sum();
            assert!((sum - 2.0 * 9.81 * h).abs() < 1e-12, "{sum} N s");
        }
        assert!(says(&run, "not determined"), "{model:?}: {:?}", run.notes);
    }
}

/// A disc in a groove: wedged by any force from 3.1531 N on at μ = 1.2, held by 4.6245 to 13.8734 N at μ = 0.5.
#[test]
fn a_wedged_disc_has_an_interval_of_forces() {
    let world = stability("v_groove");
    for (friction, wanted) in [(1.2, "from 3.1531 N on"), (0.5, "from 4.6245 to 13.8734 N")] {
        for model in [AUTO, ST, MOREAU] {
            let run = run(&with_friction(world.clone(), friction), model);
            let said = run.notes.iter().filter(|note| note.contains(wanted)).count();
            assert_eq!(said, 2, "{model:?} at mu {friction}: {:?}", run.notes);
            let [x, y, angle] = run.last.poses[0];
            assert!(
                x.abs() < 1e-15 && (y - 0.02_f64.sqrt()).abs() < 1e-15 && angle.abs() < 1e-15,
                "{:?}",
                run.last.poses
            );
        }
    }
}

/// A slip that reverses inside the impact: laws of impact disagree, which the located impact says.
#[test]
fn a_reversed_slip_is_said() {
    let world = stability("slip_reversal");
    for model in [AUTO, MOREAU] {
        let run = run(&world, model);
        assert!(says(&run, "reverses inside an impact"), "{:?}", run.notes);
        let strike = run.frames.iter().find(|frame| !frame.touches.is_empty()).expect("it strikes the floor");
        let touch = &strike.touches[0];
        let [vx, _, spin] = strike.velocities[0];
        // the step's friction is that of the slip after the impact: it pushes on, μ times the normal impulse
        let slip = vx - spin * (touch.point[1] - strike.poses[0][1]);
        assert!(slip < -0.45, "{slip} m/s");
        assert!((touch.impulse[1] - 0.3 * touch.impulse[0]).abs() < 1e-9, "{touch:?}");
        assert!(says(&run, "-0.5976"), "{:?}", run.notes);
    }
}

/// Three balls in a row: rigid laws differ, and the simultaneous one of Newton is the one that acts.
#[test]
fn a_cradle_follows_newton_at_once() {
    for model in [AUTO, ST, MOREAU] {
        let run = run(&stability("cradle"), model);
        let wanted = [-1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0];
        for (velocity, wanted) in run.last.velocities.iter().zip(wanted) {
            assert!((velocity[0] - wanted).abs() < 1e-12, "{:?}", run.last.velocities);
        }
        assert_eq!(run.solver.impacts, 1);
    }
    // without restitution all three go on together
    let mut plastic = stability("cradle");
    plastic.materials.iter_mut().for_each(|material| material.restitution = Restitution::Newton(0.0));
    for model in [AUTO, ST, MOREAU] {
        let run = run(&plastic, model);
        let off = run.last.velocities.iter().map(|velocity| (velocity[0] - 1.0 / 3.0).abs()).fold(0.0, f64::max);
        // gaps of rounding, over the step: 1e-13 m / 1e-3 s
        assert!(off < 1e-10, "{model:?}: {:?}", run.last);
    }
}

/// The peg with γ = 0: open contacts have no singular row, no step needs help, and the ladder takes compliant contacts.
#[test]
fn a_cone_without_smoothing_needs_no_help() {
    let world = stability("gamma_zero");
    for (model, step) in [(ModelKind::SongPangKumar, Some(2e-4)), (AUTO, None)] {
        let run = at(&world, model, step);
        assert_eq!(
            (run.status, run.model.chosen, run.solver.subdivided),
            (Status::Complete, "spk", 0),
            "{:?}",
            run.notes
        );
        assert!(run.solver.residual < 1e-12, "{:e}", run.solver.residual);
    }
}

/// A contact so soft that the ball would come out on the other side is refused before it touches; rigid it stops.
#[test]
fn a_wall_too_soft_is_refused() {
    let world = stability("soft_tunnel");
    for model in [AUTO, ModelKind::SongPangKumar] {
        let run = run(&world, model);
        assert_eq!(run.status, Status::Partial, "{model:?}");
        assert!(says(&run, "too soft to keep the bodies apart") && run.last.poses[0][0] < -0.002, "{:?}", run.notes);
    }
    for model in [ST, MOREAU] {
        let x = run(&world, model).last.poses[0][0];
        assert!((x + 0.002).abs() < 1e-12, "{model:?}: {x}");
    }
}

/// A ball that rests on a soft floor hits nothing, yet its weight presses it in by m g / K; a hard floor is left rigid.
#[test]
fn a_weight_presses_into_what_is_soft() {
    for (stiffness, chosen) in [(100.0, "spk"), (1e5, "moreau")] {
        let text = format!(
            r#"{{"scene": {{"gravity": [0, -9.81], "duration": 8, "friction": 0.2, "contact": {{"stiffness": {stiffness}, "damping": 10}},
            "bodies": [{{"shape": {{"circle": {{"center": [0, 0], "radius": 0.2}}}}, "mass": 1, "pose": [0, 0.2, 0]}}],
            "fixed": [{{"shape": {{"half_plane": {{"point": [0, 0], "normal": [0, 1]}}}}}}]}}}}"#
        );
        let Scene::Planar(world) = read_scene(text.as_bytes(), &Limits::default()).unwrap().scene else { panic!() };
        let run = run(&world, AUTO);
        assert_eq!(run.model.chosen, chosen, "{:?}", run.model.why);
        assert!((run.last.poses[0][1] - (0.2 - 9.81 / stiffness)).abs() < 1e-3, "{:?}", run.last);
    }
}

/// Overlaps of compliant contacts are springs: 1 mm lifts a block no higher than their 0.05 J, a peg 2 mm too wide is held
/// by friction where it stands, one 2 nm too wide falls as if free.
#[test]
fn compliant_overlaps_are_springs() {
    let at_end = |name: &str| {
        let run = at(&with_compliance(stability(name)), ModelKind::SongPangKumar, Some(1e-4));
        assert_eq!(run.status, Status::Complete, "{name}: {:?}", run.notes);
        assert!(run.energy.largest_gain < 1e-12, "{name}: {:e} J", run.energy.largest_gain);
        run
    };
    let highest = at_end("overlap").frames.iter().map(|frame| frame.poses[0][1]).fold(0.0, f64::max);
    assert!((0.05..=0.05 + 0.05 / 9.81).contains(&highest), "{highest}");
    // four corners, 50 N each, rub with up to 60 N; 0.1 kg at 0.1 m/s goes 0.07 mm against their tangential springs
    let [_, y, _] = at_end("jam").last.poses[0];
    assert!(y.abs() < 1e-4, "{y}");
    // 5e-5 N at each corner, 0.98 N of weight; the step adds h g T / 2
    let ([_, y, _], [_, vy, _]) = (at_end("snug").last.poses[0], at_end("snug").last.velocities[0]);
    assert!((vy + 1.081).abs() < 1e-4 && (y + 0.059_05 + 4.9e-5).abs() < 1e-5, "{y}, {vy}");
}
