//! Compliant parts that tumble among polygons and each other: features change under load.

use crate::spk_accuracy::run;
use crate::spk_robust::{body, material, rectangle, world};
use partplan::answer::Status;
use partplan::model::{Obstacle, PlanarShape};

#[test]
fn stress() {
    let (mut steps, mut problems, mut pivots, mut halved, mut worst) = (0, 0, 0, 0, 0.0_f64);
    for seed in 0..30_u32 {
        let draw =
            |k: u32| f64::from((seed * 7919 + k * 104_729).wrapping_mul(2_654_435_761) >> 8) / f64::from(1 << 24) - 0.5;
        let mut bodies = vec![body(
            rectangle([0.05, 0.025]),
            0.2,
            2e-4,
            [0.02 * draw(1), 0.2, 3.0 * draw(2)],
            [draw(3), 0.0, 10.0 * draw(4)],
        )];
        bodies.push(body(
            PlanarShape::Polygon(vec![[-0.03, -0.02], [0.03, -0.02], [0.0, 0.04]]),
            0.1,
            5e-5,
            [0.03 * draw(5), 0.35, 3.0 * draw(6)],
            [0.0; 3],
        ));
        bodies.push(body(
            PlanarShape::Circle { center: [0.0, 0.0], radius: 0.02 },
            0.1,
            2e-5,
            [0.03 * draw(7), 0.45, 0.0],
            [0.0; 3],
        ));
        let left = PlanarShape::Polygon(vec![[-0.3, -0.2], [-0.02, -0.2], [-0.02, -0.1], [-0.3, 0.0]]);
        let right = PlanarShape::Polygon(vec![[0.02, -0.1], [0.02, -0.2], [0.3, -0.2], [0.3, 0.0]]);
        let floor = PlanarShape::HalfPlane { point: [0.0, -0.15], normal: [0.0, 1.0] };
        let m = material(0.3 + 0.3 * draw(8), 5e4, if seed % 2 == 0 { 14.14 } else { 400.0 }, 1e-8);
        let mut world = world(bodies, left, m, 1.0);
        for shape in [right, floor] {
            world.fixed.push(Obstacle { name: "f".into(), shape, surface_velocity: [0.0; 2] });
        }
        world.materials = vec![m; 3 * 6];
        for (h, so) in [(1e-3, false), (2e-4, false), (2e-4, true)] {
            let run = run(&world, h, so);
            if run.status != Status::Complete || run.solver.subdivided > 0 || run.energy.largest_gain > 1e-9 {
                println!(
                    "seed {seed} h {h} {so}: {:?} {:?} gain {:e} sub {} {:?} pen {:?} res {:e}",
                    run.status,
                    run.notes,
                    run.energy.largest_gain,
                    run.solver.subdivided,
                    run.solver.rungs,
                    run.penetration,
                    run.solver.residual
                );
            }
            steps += run.solver.steps;
            problems += run.solver.problems;
            pivots += run.solver.pivots;
            halved += run.solver.subdivided;
            if !so {
                worst = worst.max(run.energy.largest_gain);
            }
        }
    }
    println!("steps {steps} problems {problems} pivots {pivots} halved {halved} worst {worst:e}");
}
