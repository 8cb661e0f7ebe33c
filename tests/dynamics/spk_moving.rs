//! The compliant model in space, on moving surfaces, against kinematic bodies, on senseless numbers.

use crate::spk_accuracy::{planar, run, sphere};
use crate::spk_robust::{assert_plain, body, ground, material, rectangle, world};
use partplan::answer::{ContactState, Status};
use partplan::model::{Body, Obstacle, Spatial, SpatialShape, World};

fn box_world(half: [f64; 3], pose: [f64; 7], velocity: [f64; 6]) -> World<Spatial> {
    let inertia = [[1, 2], [2, 0], [0, 1]].map(|[a, b]| (half[a] * half[a] + half[b] * half[b]) / 3.0);
    let part = Body {
        name: "box".into(),
        shape: SpatialShape::Box { half },
        mass: 1.0,
        inertia,
        pose,
        velocity,
        is_kinematic: false,
        schedule: Vec::new(),
        finger: None,
    };
    let floor = SpatialShape::HalfSpace { point: [0.0; 3], normal: [0.0, 0.0, 1.0] };
    World {
        gravity: [0.0, 0.0, -9.81],
        duration: 1.5,
        step: None,
        margin: None,
        directions: 16,
        bodies: vec![part],
        fixed: vec![Obstacle { name: "floor".into(), shape: floor, surface_velocity: [0.0; 2] }],
        materials: vec![material(0.4, 5e4, 300.0, 1e-8); 2],
    }
}

/// A box dropped turning comes to rest flat, each of four corners carrying m g / 4.
#[test]
fn a_tumbling_box_comes_to_rest() {
    for (k, angle) in [0.3, 0.7, 1.1].into_iter().enumerate() {
        let [s, c] = [(0.5_f64 * angle).sin(), (0.5_f64 * angle).cos()];
        let axis = [[0.6, 0.8, 0.0], [0.0, 0.6, 0.8], [0.48, 0.6, 0.64]][k];
        let pose = [0.0, 0.0, 0.25, c, s * axis[0], s * axis[1], s * axis[2]];
        let world = box_world([0.1, 0.06, 0.04], pose, [0.3, 0.0, 0.0, 2.0, -3.0, 1.0]);
        let run = run(&world, 2e-4, false);
        assert_plain(&run, "box");
        assert_eq!(run.last.touches.len(), 4);
        for touch in &run.last.touches {
            assert!((touch.impulse[0] / 2e-4 - 9.81 / 4.0).abs() < 1e-6, "{:?}", touch.impulse);
            assert_eq!(touch.state, ContactState::Stick);
        }
        let z = run.last.poses[0][2] + 9.81 / (4.0 * 5e4);
        assert!([0.1, 0.06, 0.04].iter().any(|half| (z - half).abs() < 1e-8), "{z}");
        // u is taken at the start of the step, which a free spin may gain from
        assert!(run.energy.largest_gain < 1e-6, "gain {:e}", run.energy.largest_gain);
    }
}

/// One ball on another, exactly above: both sink as the springs say and stay on the axis.
#[test]
fn balls_rest_on_balls() {
    let mut world = World { duration: 1.0, ..sphere("spk_sphere_fig3_overdamped") };
    world.bodies[0].velocity = [0.0; 6];
    world.bodies[0].pose[2] = 0.05;
    let mut upper = world.bodies[0].clone();
    upper.pose[2] = 0.15;
    world.bodies.push(upper);
    world.materials = vec![world.materials[1]; 6];
    let run = run(&world, 2e-4, false);
    assert_plain(&run, "balls");
    let weight = 0.2 * 9.81 / 5e4;
    let [lower, upper] = [run.last.poses[0], run.last.poses[1]];
    assert!((lower[2] - (0.05 - 2.0 * weight)).abs() < 1e-9 && (upper[2] - (0.15 - 3.0 * weight)).abs() < 1e-9);
    assert!(upper[0].abs() < 1e-15 && upper[1].abs() < 1e-15);
    assert!(run.energy.largest_gain < 1e-15, "{:e}", run.energy.largest_gain);
}

/// A belt takes a block along at mu g until it moves with the belt; the belt's work explains the energy.
#[test]
fn a_belt_takes_a_block_along() {
    let mut world = World { duration: 1.0, ..planar("spk_four_contacts") };
    world.fixed[0].surface_velocity = [1.0, 0.0];
    let run = run(&world, 2e-4, false);
    assert_plain(&run, "belt");
    let [x, _, _] = run.last.poses[0];
    let t = 1.0 / (0.4 * 9.81);
    assert!((run.last.velocities[0][0] - 1.0).abs() < 1e-6, "{:?}", run.last.velocities);
    assert!((x - (1.0 - 0.5 * t)).abs() < 2e-3, "{x} for {}", 1.0 - 0.5 * t);
    assert!(run.energy.largest_gain < 1e-9, "{:e}", run.energy.largest_gain);
    assert!(run.energy.work > 0.99, "{}", run.energy.work);
}

/// A pusher of given velocity pushes a block along its floor.
#[test]
fn a_pusher_pushes() {
    let block = body(rectangle([0.1, 0.05]), 1.0, 4e-3, [0.0, 0.05, 0.0], [0.0; 3]);
    let mut pusher = body(rectangle([0.05, 0.03]), 1.0, 1e-3, [-0.2, 0.04, 0.0], [0.1, 0.0, 0.0]);
    pusher.is_kinematic = true;
    let run = run(&world(vec![block, pusher], ground(), material(0.3, 5e4, 300.0, 1e-8), 1.0), 2e-4, false);
    assert_plain(&run, "pusher");
    assert!((run.last.velocities[0][0] - 0.1).abs() < 1e-6, "{:?}", run.last.velocities);
    let gap = run.last.poses[0][0] - run.last.poses[1][0] - 0.15;
    // mu m g on two springs
    assert!((gap + 0.3 * 9.81 / 1e5).abs() < 1e-6, "{gap}");
    assert!(run.energy.largest_gain < 1e-9, "{:e}", run.energy.largest_gain);
}

/// Numbers that overflow or are none end the run with a note, not in a panic.
#[test]
fn senseless_numbers_end_the_run() {
    for velocity in [f64::NAN, f64::INFINITY, 1e308, -1e200] {
        let mut world = World { duration: 0.01, ..planar("spk_peg_mu1") };
        world.bodies[0].velocity = [velocity; 3];
        for second_order in [false, true] {
            let run = run(&world, 2e-4, second_order);
            assert!(run.status == Status::Partial && !run.notes.is_empty(), "{velocity}: {:?}", run.status);
        }
    }
    for (stiffness, damping, gamma) in [(1e300, 0.0, 0.0), (1e-300, 1e300, 1e300), (5e4, 0.0, 1e-320)] {
        let mut world = World { duration: 0.2, ..planar("spk_peg_mu1") };
        world.materials = vec![material(1e3, stiffness, damping, gamma); 2];
        let run = run(&world, 2e-4, false);
        assert!(run.last.poses[0].iter().all(|x| x.is_finite()));
    }
}
