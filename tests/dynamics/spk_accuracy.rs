//! The compliant model against closed forms and continuous time: restitution, order of accuracy, forces at rest.

use crate::published::{Outcome, expected, list, number, scene};
use partplan::answer::{Frame, Simulation, Status};
use partplan::dynamics::{Mechanics, ModelKind, Options, simulate};
use partplan::model::{Planar, Scene, Spatial, World};
use serde_json::Value;

pub fn sphere(name: &str) -> World<Spatial> {
    match scene(name).scene {
        Scene::Spatial(world) => world,
        Scene::Planar(_) => panic!("{name} is planar"),
    }
}

pub fn planar(name: &str) -> World<Planar> {
    match scene(name).scene {
        Scene::Planar(world) => world,
        Scene::Spatial(_) => panic!("{name} is spatial"),
    }
}

/// A run with every frame kept.
pub fn run<S: Mechanics>(world: &World<S>, h: f64, second_order: bool) -> Simulation<S> {
    let model = ModelKind::SongPangKumar;
    let options = Options { model, step: Some(h), second_order, frames: 200_000, ..Options::default() };
    simulate(world, &options, &mut |_| true).unwrap()
}

/// Restitution of the first bounce after a fall of 0.15 m, by the energies of the fall and of the first free step.
fn restitution(damping: f64, h: f64, second_order: bool) -> f64 {
    let mut world = World { duration: 0.25, ..sphere("spk_sphere_fig3") };
    for material in &mut world.materials {
        material.compliance.as_mut().unwrap().damping = [damping; 2];
    }
    let run = run(&world, h, second_order);
    let mut frames = run.frames.iter().skip_while(|frame| frame.touches.is_empty());
    let Some(free) = frames.find(|frame| frame.touches.is_empty()) else {
        return 0.0;
    };
    let energy = free.velocities[0][2].powi(2) + 2.0 * 9.81 * (free.poses[0][2] - 0.05);
    (energy.max(0.0) / (2.0 * 9.81 * 0.15)).sqrt()
}

/// m = 0.2 kg, K = 5e4 N/m, C = 2 √50 N s/m: 0.8055 with gravity, of which the implicit step loses a part that goes
/// with h; two stages are within 0.001 of it.
#[test]
fn restitution_depends_on_the_step_as_derived() {
    let c = 2.0 * 50.0_f64.sqrt();
    for (h, e) in [(1e-3, 0.380), (5e-4, 0.550), (2e-4, 0.692), (1e-4, 0.746), (1e-5, 0.799)] {
        let found = restitution(c, h, false);
        assert!((found - e).abs() < if h < 1e-3 { 2e-3 } else { 5e-3 }, "h {h}: {found} for {e}");
    }
    for h in [2e-4, 1e-4, 5e-5, 1e-5] {
        let found = restitution(c, h, true);
        assert!((found - 0.8055).abs() < 1e-3, "two stages, h {h}: {found}");
    }
}

/// Stiff dashpots do not bounce, also where two stages would make them: h C / m is 3.5, 7 and 45 there.
#[test]
fn stiff_dashpots_do_not_bounce_in_two_stages() {
    for damping in [447.2, 1414.2, 3500.0, 7000.0, 44721.0] {
        let [e, plain] = [true, false].map(|second_order| restitution(damping, 2e-4, second_order));
        assert!(e < 0.05 && plain < 0.05, "C {damping}: {e} and {plain}");
    }
}

fn error(found: &Outcome, truth: &Value) -> f64 {
    let n_positions = list(&truth["q"]).len();
    let pairs = found.q[..n_positions].iter().zip(list(&truth["q"])).chain(found.v.iter().zip(list(&truth["v"])));
    pairs.map(|(found, truth)| (found - number(truth)).abs()).fold(0.0, f64::max)
}

/// The error against continuous time falls about fourfold from h to h/4: what is published at h and h/4 is within its
/// bound, and from h/4 to h/16 it falls between 3 and 5 times.
#[test]
fn errors_fall_with_the_step() {
    let (expected, mut compared) = (expected(), 0);
    for name in [
        "spk_restitution_C14",
        "spk_restitution_C1414",
        "spk_sphere_fig3",
        "spk_sphere_fig3_overdamped",
        "spk_peg_mu0",
        "spk_peg_mu1",
        "spk_slope_static",
    ] {
        let (scene, rows) = (scene(name), list(&expected[name]["rows"]));
        let row = rows.iter().find(|row| row["h"] == 5e-5).unwrap();
        let steps = usize::try_from(row["steps"].as_u64().unwrap()).unwrap();
        let coarse = error(&scene.run(5e-5, steps), &row["truth"]);
        let fine = error(&scene.run(1.25e-5, 4 * steps), &row["truth"]);
        assert!(coarse <= number(&row["truth"]["tol"]), "{name}: error {coarse}");
        assert!((3.0..5.0).contains(&(coarse / fine)), "{name}: errors {coarse} and {fine}");
        compared += 1;
    }
    assert_eq!(compared, 7);
}

/// Two stages are of second order in flight and contact: an eighth of the step's error is far below a quarter.
#[test]
fn two_stages_are_more_accurate() {
    let expected = expected();
    for name in ["spk_sphere_fig3", "spk_peg_mu0", "spk_peg_mu1"] {
        let rows = list(&expected[name]["rows"]);
        let truth = &rows.iter().find(|row| row["h"] == 2e-4).unwrap()["truth"];
        let error = |run: [Vec<f64>; 2]| {
            let n_positions = list(&truth["q"]).len();
            let wanted = list(&truth["q"]).iter().chain(list(&truth["v"]));
            let found = run[0][..n_positions].iter().chain(&run[1]);
            found.zip(wanted).map(|(found, truth)| (found - number(truth)).abs()).fold(0.0, f64::max)
        };
        let last = |h: f64, second_order: bool| match scene(name).scene {
            Scene::Planar(world) => flat(&run(&World { duration: 0.2, ..world }, h, second_order).last),
            Scene::Spatial(world) => flat(&run(&World { duration: 0.2, ..world }, h, second_order).last),
        };
        let [plain, staged, fine] = [(2e-4, false), (2e-4, true), (2.5e-5, true)].map(|(h, so)| error(last(h, so)));
        assert!(staged < 0.2 * plain, "{name}: {staged} against {plain}");
        assert!(fine < 0.05 * staged, "{name}: {fine} against {staged}");
    }
}

fn flat<S: Mechanics>(frame: &Frame<S>) -> [Vec<f64>; 2] {
    let q = frame.poses.iter().flat_map(|pose| pose.as_ref().to_vec()).collect();
    [q, frame.velocities.iter().flat_map(|velocity| velocity.as_ref().to_vec()).collect()]
}

/// Four contacts in a row carry m g / 4 each: compliance makes the forces unique.
#[test]
fn four_contacts_share_the_load() {
    let run = run(&World { duration: 1.0, ..planar("spk_four_contacts") }, 2e-4, false);
    assert_eq!(run.last.touches.len(), 4);
    for touch in &run.last.touches {
        let force = touch.impulse[0] / 2e-4;
        assert!((force - 4.905).abs() < 1e-9, "{force}");
    }
}

/// A block on a slope below its friction angle yields elastically and then stays, to rounding.
#[test]
fn a_block_on_a_slope_does_not_creep() {
    let world = planar("spk_slope_static");
    let [early, late] = [0.5, 2.0].map(|duration| run(&World { duration, ..world.clone() }, 2e-4, false).last.poses[0]);
    for (early, late) in early.iter().zip(late) {
        assert!((early - late).abs() < 1e-12, "{early} then {late}");
    }
}

/// The smoothing of the cone moves the answer in proportion to gamma.
#[test]
fn gamma_has_a_linear_effect() {
    let mut world = World { duration: 0.2, ..planar("spk_peg_mu1") };
    let mut angle = |gamma: f64| {
        world.materials.iter_mut().for_each(|material| material.compliance.as_mut().unwrap().gamma = gamma);
        run(&world, 2e-4, false).last.poses[0][2]
    };
    let sharp = angle(0.0);
    let [first, second, third] = [1e-4, 1e-5, 1e-6].map(|gamma| (angle(gamma) - sharp) / gamma);
    assert!((first / second - 1.0).abs() < 0.05 && (second / third - 1.0).abs() < 0.05, "{first} {second} {third}");
    // 1e-8 N: what the published runs have
    assert!((angle(1e-8) - sharp).abs() < 1.5e-8);
}

/// Invariants of a ball on one horizontal plane, the energy and the length of the Euler parameters, at every step.
#[test]
fn invariants_hold_at_every_step() {
    for (name, second_order) in [
        ("spk_sphere_fig3", false),
        ("spk_sphere_fig3_overdamped", false),
        ("spk_sphere_rest", false),
        ("spk_sphere_fig3", true),
    ] {
        let world = World { duration: 0.6, ..sphere(name) };
        let run = run(&world, 2e-4, second_order);
        assert_eq!((run.status, run.frames.len()), (Status::Complete, 3001));
        for frame in &run.frames {
            let [vx, vy, _, wx, wy, _] = frame.velocities[0];
            let off = (vx + 0.4 * 0.05 * wy - 0.5).abs().max((vy - 0.4 * 0.05 * wx + 0.4).abs());
            assert!(off < 1e-14, "{name} at {} s: {off:e}", frame.time);
            let length: f64 = frame.poses[0][3..].iter().map(|e| e * e).sum();
            assert!((length - 1.0).abs() < 1e-14);
        }
        if !second_order {
            assert!(run.energy.largest_gain < 1e-15, "{name}: {:e}", run.energy.largest_gain);
        }
        let Simulation { energy, .. } = &run;
        assert!((energy.start + energy.work - energy.dissipated - energy.end).abs() < 1e-12);
    }
}
