//! The compliant model in a mirror, in other units, beside another code order.

use crate::spk_accuracy::{planar, run};
use crate::spk_robust::{body, draw, ground, material, world};
use partplan::model::{Body, Planar, PlanarShape, World};
use proptest::prelude::*;

/// A peg and its mirror image move as mirror images.
#[test]
fn mirrored_scenes_move_mirrored() {
    for name in ["spk_peg_mu0", "spk_peg_mu1", "spk_peg_inelastic"] {
        let world = World { duration: 0.25, ..planar(name) };
        let mut mirrored = world.clone();
        let part = &mut mirrored.bodies[0];
        part.pose[2] = -part.pose[2];
        if let PlanarShape::Polygon(vertices) = &mut part.shape {
            vertices.iter_mut().for_each(|v| v[0] = -v[0]);
            vertices.reverse();
        }
        for second_order in [false, true] {
            let [a, b] = [&world, &mirrored].map(|world| run(world, 2e-4, second_order).last);
            let ([x, y, angle], [mx, my, m_angle]) = (a.poses[0], b.poses[0]);
            let off = (x + mx).abs().max((y - my).abs()).max((angle + m_angle).abs());
            assert!(off < 1e-11, "{name}: {:?} and {:?}", a.poses[0], b.poses[0]);
        }
    }
}

/// A random block on two to four corners.
fn block(seed: u32) -> World<Planar> {
    let draw = |k: u32| draw(seed, k) - 0.5;
    let outline = vec![[-0.5, -0.1], [-0.16, -0.1], [0.16, -0.1], [0.5, -0.1], [0.5, 0.1], [-0.5, 0.1]];
    let (pose, velocity) = ([0.1, 0.1 + 0.004 * draw(1), 0.02 * draw(2)], [3.0 * draw(3), draw(4), 5.0 * draw(5)]);
    let part = body(PlanarShape::Polygon(outline), 2.0, 0.2, pose, velocity);
    world(vec![part], ground(), material(0.5, 5e4, 50.0, 1e-4), 4e-3)
}

/// The world in other units of length, mass and time.
fn in_units(world: &World<Planar>, [length, mass, time]: [f64; 3]) -> World<Planar> {
    let mut scaled = world.clone();
    let force = mass * length / (time * time);
    scaled.duration *= time;
    scaled.gravity = scaled.gravity.map(|g| g * length / (time * time));
    let scale_body = |body: &mut Body<Planar>| {
        body.mass *= mass;
        body.inertia[0] *= mass * length * length;
        let ([x, y, angle], [vx, vy, spin]) = (body.pose, body.velocity);
        body.pose = [x * length, y * length, angle];
        body.velocity = [vx * length / time, vy * length / time, spin / time];
        if let PlanarShape::Polygon(vertices) = &mut body.shape {
            *vertices = vertices.iter().map(|v| v.map(|x| x * length)).collect();
        }
    };
    scaled.bodies.iter_mut().for_each(scale_body);
    for material in &mut scaled.materials {
        let compliance = material.compliance.as_mut().unwrap();
        compliance.stiffness = compliance.stiffness.map(|k| k * force / length);
        compliance.damping = compliance.damping.map(|c| c * force * time / length);
        compliance.gamma *= force;
    }
    scaled
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, ..ProptestConfig::default() })]

    /// Metres or millimetres, kilograms or grams, seconds or milliseconds: the same motion.
    #[test]
    fn units_do_not_matter(
        seed in 0_u32..10_000,
        length in prop::sample::select(vec![1.0, 1e3, 1e-2, 39.37]),
        mass in prop::sample::select(vec![1.0, 1e3, 1e-6, 2.2]),
        time in prop::sample::select(vec![1.0, 1e3, 1e-2, 60.0]),
    ) {
        let world = block(seed);
        let other = in_units(&world, [length, mass, time]);
        for second_order in [false, true] {
            let a = run(&world, 2e-4, second_order).last;
            let b = run(&other, 2e-4 * time, second_order).last;
            let scales = [length, length, 1.0];
            for (i, scale) in scales.into_iter().enumerate() {
                prop_assert!((a.poses[0][i] - b.poses[0][i] / scale).abs() < 1e-11);
                prop_assert!((a.velocities[0][i] - b.velocities[0][i] * time / scale).abs() < 1e-8);
            }
        }
    }
}
