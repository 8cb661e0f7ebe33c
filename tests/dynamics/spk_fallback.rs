//! Steps that Newton's first attempts do not solve: rods that jam under strong friction, at long steps.

use crate::spk_accuracy::run;
use crate::spk_robust::{body, draw, ground, material, world};
use partplan::answer::{Simulation, Status};
use partplan::model::{Planar, PlanarShape};

/// A leaning rod thrown on its tip, as in Painlevé's example: friction up to 3.5.
fn rod(seed: u32, h: f64, stiffness: f64) -> Simulation<Planar> {
    let draw = |k: u32| draw(seed, k);
    let angle = 0.7 + 0.8 * draw(1);
    let outline = PlanarShape::Polygon(vec![[-1.0, -0.01], [1.0, -0.01], [1.0, 0.01], [-1.0, 0.01]]);
    let y = libm::sin(angle) + 0.01 * libm::cos(angle) + 0.01 * draw(2);
    let velocity = [-4.0 * (draw(3) - 0.5), -2.0 * draw(6), -8.0 * (draw(4) - 0.5)];
    let rod = body(outline, 1.0, 0.333, [0.0, y, angle], velocity);
    let damping = [0.0, 14.0, 4000.0][seed as usize % 3];
    run(&world(vec![rod], ground(), material(0.5 + 3.0 * draw(5), stiffness, damping, 1e-8), 0.4), h, false)
}

/// Problems solved, and of them those that other problems led to, and steps halved.
fn effort(seeds: u32, h: f64, stiffness: f64) -> [usize; 3] {
    let mut sums = [0; 3];
    for seed in 0..seeds {
        let run = rod(seed, h, stiffness);
        assert_eq!(run.status, Status::Complete, "seed {seed}: {:?}", run.notes);
        assert!(run.solver.residual < 1e-12, "seed {seed}: residual {:e}", run.solver.residual);
        let continued = run.solver.rungs.iter().filter(|(name, _)| *name == "continued").map(|(_, count)| count);
        for (sum, count) in sums.iter_mut().zip([run.solver.problems, continued.sum::<usize>(), run.solver.subdivided])
        {
            *sum += count;
        }
        assert_eq!(run.solver.subdivided > 0, run.notes.iter().any(|note| note.contains("halved")), "{:?}", run.notes);
    }
    sums
}

/// At a step of 1 ms the guesses reach all but a few steps in ten thousand, and those are halved.
#[test]
fn jamming_rods_are_solved() {
    let [problems, continued, halved] = effort(60, 1e-3, 5e8);
    assert!(continued > 0 && continued * 1000 < 2 * problems, "{continued} of {problems}");
    assert!(halved * 10_000 < 2 * problems, "{halved} of {problems}");
}

/// At 10 ms, thirty times too long for the springs, steps are halved, and the run says so.
#[test]
fn steps_too_long_are_halved_and_noted() {
    let [_, _, halved] = effort(8, 1e-2, 5e8);
    assert!(halved > 0);
}
