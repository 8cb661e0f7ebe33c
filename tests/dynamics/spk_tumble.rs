//! Compliant parts that tumble among polygons and each other: features change under load.

use crate::spk_accuracy::{planar, run};
use crate::spk_robust::{body, draw, material, rectangle, world};
use partplan::answer::Status;
use partplan::model::{Obstacle, Planar, PlanarShape, World};

/// A peg, a triangle and a disc fall into a funnel over a floor.
fn funnel(seed: u32) -> World<Planar> {
    let draw = |k: u32| draw(seed, k) - 0.5;
    let triangle = PlanarShape::Polygon(vec![[-0.03, -0.02], [0.03, -0.02], [0.0, 0.04]]);
    let disc = PlanarShape::Circle { center: [0.0, 0.0], radius: 0.02 };
    let bodies = vec![
        body(rectangle([0.05, 0.025]), 0.2, 2e-4, [0.02 * draw(1), 0.2, 3.0 * draw(2)], [draw(3), 0.0, 10.0 * draw(4)]),
        body(triangle, 0.1, 5e-5, [0.03 * draw(5), 0.35, 3.0 * draw(6)], [0.0; 3]),
        body(disc, 0.1, 2e-5, [0.03 * draw(7), 0.45, 0.0], [0.0; 3]),
    ];
    let material = material(0.3 + 0.3 * draw(8), 5e4, if seed.is_multiple_of(2) { 14.14 } else { 400.0 }, 1e-8);
    let left = PlanarShape::Polygon(vec![[-0.3, -0.2], [-0.02, -0.2], [-0.02, -0.1], [-0.3, 0.0]]);
    let right = PlanarShape::Polygon(vec![[0.02, -0.1], [0.02, -0.2], [0.3, -0.2], [0.3, 0.0]]);
    let floor = PlanarShape::HalfPlane { point: [0.0, -0.15], normal: [0.0, 1.0] };
    let mut world = world(bodies, left, material, 0.6);
    for shape in [right, floor] {
        world.fixed.push(Obstacle { name: "wall".into(), shape, surface_velocity: [0.0; 2] });
    }
    world.materials = vec![material; 3 * 6];
    world
}

/// Every step is solved at once, by few iterations, and pairs of features that replace each other bring no energy.
#[test]
fn features_change_without_harm() {
    let (mut problems, mut pivots) = (0, 0);
    for seed in 0..12 {
        for (h, second_order) in [(1e-3, false), (2e-4, false), (2e-4, true)] {
            let run = run(&funnel(seed), h, second_order);
            assert_eq!(run.status, Status::Complete, "seed {seed}: {:?}", run.notes);
            assert_eq!(run.solver.subdivided, 0, "seed {seed}");
            assert!(run.solver.residual < 1e-12, "seed {seed}: residual {:e}", run.solver.residual);
            // turning arms are not exactly dissipative: h² ω² against 1.5 J of fall
            assert!(run.energy.largest_gain < 1e-5, "seed {seed}: gain {:e} J", run.energy.largest_gain);
            assert!(run.penetration.0 < 6e-3, "seed {seed}: {} m deep", run.penetration.0);
            problems += run.solver.problems;
            pivots += run.solver.pivots;
        }
    }
    assert!(problems > 40_000 && pivots < 3 * problems, "{problems} problems, {pivots} iterations");
}

/// Contacts beyond the reach of a step cannot close: considering every pair changes nothing.
#[test]
fn considering_every_pair_changes_nothing() {
    for seed in [1, 2] {
        let near = World { duration: 0.35, ..funnel(seed) };
        // wide enough for what comes close, not so wide that a vertex meets the far side of a wall
        let wide = World { margin: Some(0.01), ..near.clone() };
        let [a, b] = [&near, &wide].map(|world| run(world, 2e-4, false).last.poses);
        for (a, b) in a.iter().flatten().zip(b.iter().flatten()) {
            assert!((a - b).abs() < 1e-9, "seed {seed}: {a} and {b}");
        }
    }
    let near = World { duration: 0.3, ..planar("spk_peg_mu1") };
    let every = World { margin: Some(10.0), ..near.clone() };
    let [a, b] = [&near, &every].map(|world| run(world, 2e-4, false).last.poses[0]);
    for (a, b) in a.iter().zip(b) {
        assert!((a - b).abs() < 1e-13, "{a} and {b}");
    }
}

/// The same run twice gives the same bits.
#[test]
fn runs_repeat_to_the_bit() {
    let [a, b] = [0, 1].map(|_| run(&funnel(3), 1e-3, true));
    assert_eq!(a, b);
}
