//! What drives bodies besides gravity: belts, kinematic bodies, wrenches over time, restitution.

use crate::peers;
use partplan::answer::{Simulation, Status};
use partplan::dynamics::{ModelKind, Options, simulate};
use partplan::model::{Body, Material, Obstacle, Planar, PlanarShape, Restitution, Timed, World};

const G: f64 = 9.81;

fn run(world: &World<Planar>, model: ModelKind, step: f64) -> Simulation<Planar> {
    let options = Options { model, step: Some(step), ..Options::default() };
    let run = simulate(world, &options, &mut |_| true).unwrap();
    assert_eq!(run.status, Status::Complete, "{:?}", run.notes);
    run
}

fn rectangle(a: f64, b: f64) -> PlanarShape {
    PlanarShape::Polygon(vec![[-a, -b], [a, -b], [a, b], [-a, b]])
}

fn body(name: &str, shape: PlanarShape, pose: [f64; 3]) -> Body<Planar> {
    Body {
        name: name.into(),
        shape,
        mass: 1.0,
        inertia: [1.0 / 240.0],
        pose,
        velocity: [0.0; 3],
        is_kinematic: false,
        schedule: Vec::new(),
        finger: None,
    }
}

/// A world over a floor whose surface moves; friction everywhere the same.
fn world(bodies: Vec<Body<Planar>>, belt: f64, friction: f64, duration: f64) -> World<Planar> {
    let material = Material { friction, restitution: Restitution::Newton(0.0), compliance: None };
    World {
        gravity: [0.0, -G],
        duration,
        step: None,
        margin: None,
        directions: 2,
        materials: vec![material; bodies.len() * (bodies.len() + 1)],
        bodies,
        fixed: vec![Obstacle {
            name: "floor".into(),
            shape: PlanarShape::HalfPlane { point: [0.0; 2], normal: [0.0, 1.0] },
            surface_velocity: [belt, 0.0],
        }],
    }
}

/// A box put on a belt slides until it is as fast: x = s² / (2 μ g) and then s t. The belt does the work m s², half of which
/// friction takes.
#[test]
fn a_belt_takes_a_box_along() {
    let (belt, friction, duration) = (0.5, 0.3, 0.5);
    let world = world(vec![body("box", rectangle(0.1, 0.05), [0.0, 0.05, 0.0])], belt, friction, duration);
    let sliding = belt / (friction * G);
    let wanted = belt * sliding / 2.0 + belt * (duration - sliding);
    // both schemes end the slip at a step, so that x is wrong by up to s h; the midpoint by μ g h² at most
    for (model, tolerance) in [(ModelKind::StewartTrinkle, 1e-3), (ModelKind::Moreau, 3e-6)] {
        let run = run(&world, model, 1e-3);
        assert!((run.last.poses[0][0] - wanted).abs() < tolerance, "{model:?}: {} for {wanted}", run.last.poses[0][0]);
        assert!((run.last.velocities[0][0] - belt).abs() < 1e-12);
        assert!((run.energy.work - belt * belt).abs() < 1e-9, "{:?}", run.energy);
        assert!(run.energy.largest_gain < 1e-12, "{:?}", run.energy);
    }
}

/// A kinematic body is not stopped by what it pushes.
#[test]
fn a_kinematic_finger_pushes_at_its_own_speed() {
    let mut finger = body("finger", PlanarShape::Circle { center: [0.0; 2], radius: 0.02 }, [-0.2, 0.05, 0.0]);
    finger.is_kinematic = true;
    finger.velocity = [0.2, 0.0, 0.0];
    finger.schedule = vec![Timed { time: 1.0, value: [0.0; 3] }];
    let bodies = vec![finger, body("box", rectangle(0.1, 0.05), [0.0, 0.05, 0.0])];
    let world = world(bodies, 0.0, 0.1, 2.0);
    for model in [ModelKind::StewartTrinkle, ModelKind::Moreau] {
        let run = run(&world, model, 1e-3);
        let [finger, part] = [run.last.poses[0], run.last.poses[1]];
        assert!(finger[0].abs() < 1e-9, "{model:?}: {finger:?}");
        // pushed 0.12 m behind the finger's center, then it slides on by v² / (2 μ g)
        let wanted = 0.12 + 0.2 * 0.2 / (2.0 * 0.1 * G);
        assert!((part[0] - wanted).abs() < 5e-4, "{model:?}: {part:?} for {wanted}");
        assert!(run.last.velocities[1].iter().all(|v| v.abs() < 1e-9));
        assert!(run.energy.largest_gain < 1e-9, "{:?}", run.energy);
    }
}

/// 2 N for half a second on 1 kg, then nothing; in free flight the midpoint step is exact.
#[test]
fn a_wrench_acts_from_its_time_on() {
    let mut part = body("part", rectangle(0.1, 0.05), [0.0, 1.0, 0.0]);
    part.schedule = vec![Timed { time: 0.0, value: [2.0, G, 0.01] }, Timed { time: 0.5, value: [0.0, G, 0.0] }];
    let world = world(vec![part], 0.0, 0.3, 1.0);
    let run = run(&world, ModelKind::Moreau, 1e-2);
    let ([x, y, angle], [vx, vy, spin]) = (run.last.poses[0], run.last.velocities[0]);
    let turned = 0.01 * 240.0;
    for (found, wanted) in
        [(x, 0.25 + 0.5), (y, 1.0), (angle, turned * (0.125 + 0.25)), (vx, 1.0), (vy, 0.0), (spin, turned * 0.5)]
    {
        assert!((found - wanted).abs() < 1e-12, "{found} for {wanted}");
    }
    // 1/2 m v² + 1/2 J ω² from nothing
    let kinetic = 0.5 + 0.5 * spin * spin / 240.0;
    assert!((run.energy.work - kinetic).abs() < 1e-12 && run.energy.dissipated.abs() < 1e-12, "{:?}", run.energy);
}

/// Newton's and Poisson's laws agree on a ball that falls on a floor, and ST stopped at impacts converges to first order.
#[test]
fn bounces_follow_the_law_of_impact() {
    let scene = peers::scenes().into_iter().find(|scene| scene.name == "bounce_e08").unwrap();
    let mut poisson = scene.world.clone();
    poisson.materials.iter_mut().for_each(|material| material.restitution = Restitution::Poisson(0.8));
    for world in [&scene.world, &poisson] {
        let error = |model, step| scene.error(&run(world, model, step));
        assert!(error(ModelKind::Moreau, 1e-2) < 1e-8);
        let [coarse, fine] = [1e-3, 1e-4].map(|step| error(ModelKind::StewartTrinkle, step));
        assert!(coarse < 6e-2 && fine < coarse / 5.0, "{coarse} {fine}");
    }
}
