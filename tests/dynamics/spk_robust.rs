//! The compliant model where it is hard: cold starts, heavy on light, overlap, soft contacts, scenes without compliance.

use crate::spk_accuracy::{planar, run, sphere};
use partplan::answer::{Simulation, Status};
use partplan::dynamics::{Mechanics, ModelKind, Options, SimulationError, simulate};
use partplan::model::{Body, Compliance, Material, Obstacle, Planar, PlanarShape, Restitution, World};

pub fn material(friction: f64, stiffness: f64, damping: f64, gamma: f64) -> Material {
    let compliance = Compliance { stiffness: [stiffness; 2], damping: [damping; 2], gamma };
    Material { friction, restitution: Restitution::Newton(0.0), compliance: Some(compliance) }
}

pub fn rectangle(half: [f64; 2]) -> PlanarShape {
    let [x, y] = half;
    PlanarShape::Polygon(vec![[-x, -y], [x, -y], [x, y], [-x, y]])
}

pub fn body(shape: PlanarShape, mass: f64, inertia: f64, pose: [f64; 3], velocity: [f64; 3]) -> Body<Planar> {
    let name = "part".into();
    Body {
        name,
        shape,
        mass,
        inertia: [inertia],
        pose,
        velocity,
        is_kinematic: false,
        schedule: Vec::new(),
        finger: None,
    }
}

pub fn world(bodies: Vec<Body<Planar>>, floor: PlanarShape, material: Material, duration: f64) -> World<Planar> {
    let materials = vec![material; bodies.len() * (bodies.len() + 1)];
    let fixed = vec![Obstacle { name: "floor".into(), shape: floor, surface_velocity: [0.0; 2] }];
    World { gravity: [0.0, -9.81], duration, step: None, margin: None, directions: 2, bodies, fixed, materials }
}

pub fn ground() -> PlanarShape {
    PlanarShape::HalfPlane { point: [0.0; 2], normal: [0.0, 1.0] }
}

/// A number in [0, 1), the same in every run.
pub fn draw(seed: u32, k: u32) -> f64 {
    let mixed = seed.wrapping_mul(7919).wrapping_add(k.wrapping_mul(104_729)).wrapping_mul(2_654_435_761);
    f64::from(mixed >> 8) / f64::from(1 << 24)
}

pub fn assert_plain<S: Mechanics>(run: &Simulation<S>, what: &str) {
    assert_eq!(run.status, Status::Complete, "{what}: {:?}", run.notes);
    let is_helped = run.solver.rungs.iter().any(|(name, _)| *name == "continued");
    assert!(run.solver.subdivided == 0 && !is_helped, "{what}: {:?}", run.solver);
    assert!(run.solver.residual < 1e-12, "{what}: residual {:e}", run.solver.residual);
}

/// Steps that start on one to four deep contacts with no force to guess from, for every smoothing of the cone.
#[test]
fn cold_starts_need_no_help() {
    let (mut problems, mut pivots) = (0, 0);
    for gamma in [1e-2, 1e-4, 1e-8, 1e-12, 1e-16, 0.0] {
        for seed in 0..300_u32 {
            let draw = |k: u32| draw(seed, k) - 0.5;
            let outline = [[-0.5, -0.1], [-0.16, -0.1], [0.16, -0.1], [0.5, -0.1], [0.5, 0.1], [-0.5, 0.1]];
            let (pose, velocity) =
                ([0.1, 0.1 - 0.004 * (draw(1) + 0.5), 0.02 * draw(2)], [3.0 * draw(3), 2.0 * draw(4), 20.0 * draw(5)]);
            let bodies = vec![body(PlanarShape::Polygon(outline.into()), 2.0, 0.2, pose, velocity)];
            let world =
                world(bodies, ground(), material(1.2 * (draw(6) + 0.5), 5e4, 200.0 * (draw(7) + 0.5), gamma), 4e-4);
            let run = run(&world, 2e-4, false);
            assert_plain(&run, &format!("gamma {gamma}, seed {seed}"));
            problems += run.solver.problems;
            pivots += run.solver.pivots;
        }
    }
    assert!(problems > 3000 && pivots < 5 * problems, "{problems} problems, {pivots} iterations");
}

/// A block a million times as heavy on a light one: both sink as the springs say, the load comes through.
#[test]
fn heavy_on_light() {
    let light = body(rectangle([0.05, 0.05]), 1e-3, 2e-6, [0.0, 0.05, 0.0], [0.0; 3]);
    let heavy = body(rectangle([0.04, 0.05]), 1e3, 2.0, [0.0, 0.15, 0.0], [0.0; 3]);
    let run = run(&world(vec![light, heavy], ground(), material(0.5, 1e8, 1e6, 1e-8), 1.0), 1e-3, false);
    assert_plain(&run, "heavy on light");
    let (weight, light_weight) = (1e3 * 9.81, 1e-3 * 9.81);
    let y = [run.last.poses[0][1], run.last.poses[1][1]];
    let low = 0.05 - (weight + light_weight) / 2e8;
    let high = low + 0.1 - weight / 2e8;
    assert!((y[0] - low).abs() < 1e-12 && (y[1] - high).abs() < 1e-12, "{y:?} for {low} and {high}");
    assert!(run.energy.largest_gain < 1e-11, "gain {:e} J of {:e} J", run.energy.largest_gain, run.energy.start);
}

/// A polygon for a floor acts as the half plane of its upper edge: the pairs of features found are the same.
#[test]
fn a_polygon_floor_is_a_floor() {
    let flat = World { duration: 0.4, ..planar("spk_peg_inelastic") };
    let slab = PlanarShape::Polygon(vec![[-1.0, -0.5], [1.0, -0.5], [1.0, 0.0], [-1.0, 0.0]]);
    let mut thick = flat.clone();
    thick.fixed[0].shape = slab;
    let [a, b] = [flat, thick].map(|world| run(&world, 2e-4, false));
    assert_plain(&b, "polygon floor");
    for (a, b) in a.last.poses[0].iter().zip(b.last.poses[0]) {
        assert!((a - b).abs() < 1e-9, "{a} and {b}");
    }
}

/// A part that starts 1 mm deep comes out with no more than the energy of the springs.
#[test]
fn overlap_gives_no_more_than_its_springs_hold() {
    let part = body(rectangle([0.1, 0.05]), 1.0, 4e-3, [0.0, 0.049, 0.0], [0.0; 3]);
    let world = world(vec![part], ground(), material(0.3, 5e4, 0.0, 1e-8), 0.3);
    for second_order in [false, true] {
        let run = run(&world, 1e-4, second_order);
        assert_plain(&run, "overlap");
        let top = run.frames.iter().map(|frame| frame.poses[0][1]).fold(0.0, f64::max);
        // two springs of 1 mm hold 0.05 J: 5.1 mm from the start
        assert!(top < 0.049 + 0.0051 && top > 0.049 + 0.004, "{top}");
    }
}

/// A ball of 4 mm at 20 m/s would be 89 mm deep in a post of 5 mm: refused before it meets it, whatever the step.
#[test]
fn a_ball_that_would_push_through_is_refused() {
    let disc = |radius| PlanarShape::Circle { center: [0.0; 2], radius };
    for h in [1e-3, 1e-5] {
        let ball = body(disc(0.004), 1.0, 8e-6, [-0.1, 0.0, 0.0], [20.0, 0.0, 0.0]);
        let world = world(vec![ball], disc(0.005), material(0.3, 5e4, 14.0, 1e-8), 0.02);
        let run = run(&world, h, false);
        assert_eq!(run.status, Status::Partial);
        assert!(run.last.poses[0][0] < -0.008 && run.notes.len() == 3, "{:?}", run.notes);
    }
}

/// A part heavier than its springs hold up is run, with a note.
#[test]
fn a_part_that_sinks_away_is_noted() {
    let heavy = body(rectangle([0.1, 0.05]), 1e3, 4.0, [0.0, 0.05, 0.0], [0.0; 3]);
    let run = run(&world(vec![heavy], ground(), material(0.3, 5e4, 14.0, 1e-8), 0.01), 1e-3, false);
    assert!(run.status == Status::Complete && run.notes[0].contains("sinks"), "{:?}", run.notes);
}

/// Without stiffness and damping the model cannot run, and says for which pair.
#[test]
fn a_scene_without_compliance_is_refused() {
    let options = Options { model: ModelKind::SongPangKumar, ..Options::default() };
    let mut world = sphere("spk_sphere_fig3");
    world.materials[1].compliance.as_mut().unwrap().stiffness[1] = 0.0;
    let found = simulate(&world, &options, &mut |_| true);
    assert_eq!(found, Err(SimulationError::Compliance { body: 0, other: 1 }));
    world.materials[1].compliance = None;
    let found = simulate(&world, &options, &mut |_| true);
    assert_eq!(found, Err(SimulationError::NoCompliance { body: 0, other: 1 }));
    assert!(simulate(&world, &Options::default(), &mut |_| false).is_ok());
}
