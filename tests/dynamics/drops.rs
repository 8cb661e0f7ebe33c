//! Random planar scenes: convex parts and discs dropped on a floor, some between walls.

use partplan::answer::Simulation;
use partplan::dynamics::{ModelKind, Options, simulate};
use partplan::model::{Body, Material, Obstacle, Planar, PlanarShape, Restitution, World};
use proptest::prelude::*;

/// A run with every step kept.
pub fn run(world: &World<Planar>, model: ModelKind, h: f64) -> Simulation<Planar> {
    let options = Options { model, step: Some(h), frames: 1_000_000, ..Options::default() };
    simulate(world, &options, &mut |_| true).unwrap()
}

/// One to `most` bodies in a column, clear of each other and of the walls at the start; nothing restitutes.
pub fn drops(most: usize) -> impl Strategy<Value = World<Planar>> {
    let bodies = prop::collection::vec(part(), 1..=most);
    (bodies, prop::bool::ANY, prop_oneof![Just(0.0), 0.0..2.0]).prop_map(|(parts, has_walls, friction)| {
        let mut fixed = vec![half_plane("floor", [0.0, 0.0], [0.0, 1.0])];
        if has_walls {
            fixed.push(half_plane("left wall", [-0.12, 0.0], [1.0, 0.0]));
            fixed.push(half_plane("right wall", [0.12, 0.0], [-1.0, 0.0]));
        }
        let bodies: Vec<Body<Planar>> = parts.into_iter().enumerate().map(|(i, part)| placed(i, part)).collect();
        world(bodies, fixed, friction, 0.4)
    })
}

/// A world with one material and gravity downwards.
pub fn world(bodies: Vec<Body<Planar>>, fixed: Vec<Obstacle<Planar>>, friction: f64, duration: f64) -> World<Planar> {
    let material = Material { friction, restitution: Restitution::Newton(0.0), compliance: None };
    let materials = vec![material; bodies.len() * (bodies.len() + fixed.len())];
    World { gravity: [0.0, -9.81], duration, step: None, margin: None, directions: 2, bodies, fixed, materials }
}

pub fn half_plane(name: &str, point: [f64; 2], normal: [f64; 2]) -> Obstacle<Planar> {
    Obstacle { name: name.into(), shape: PlanarShape::HalfPlane { point, normal }, surface_velocity: [0.0; 2] }
}

type Part = (PlanarShape, f64, [f64; 3], [f64; 3]);

/// Outline within 0.05 m of its center of mass, mass, pose within the column's cell, velocity.
fn part() -> impl Strategy<Value = Part> {
    let polygon = (3_usize..7, 0.0_f64..1.0, 0.4_f64..1.0, prop::array::uniform6(0.0_f64..0.6)).prop_map(
        |(n, turn, flat, jitter)| {
            let corner = |i: usize| {
                let angle: f64 = std::f64::consts::TAU * (i as f64 + turn + jitter[i]) / n as f64;
                [0.05 * angle.cos(), 0.05 * flat * angle.sin()]
            };
            PlanarShape::Polygon((0..n).map(corner).collect())
        },
    );
    let disc = (0.02..0.05).prop_map(|radius| PlanarShape::Circle { center: [0.0; 2], radius });
    let shape = prop_oneof![3 => polygon, 1 => disc];
    let pose = (-0.05..0.05, 0.0..0.05, -3.0..3.0).prop_map(|(x, y, angle)| [x, y, angle]);
    let velocity = (-1.0..1.0, -1.0..0.0, -10.0..10.0).prop_map(|(x, y, spin)| [x, y, spin]);
    (shape, 0.05..2.0, pose, velocity)
}

fn placed(index: usize, (shape, mass, [x, y, angle], velocity): Part) -> Body<Planar> {
    Body {
        name: format!("part {index}"),
        shape,
        mass,
        inertia: [mass * 8e-4],
        pose: [x, 0.07 + 0.16 * index as f64 + y, angle],
        velocity,
        is_kinematic: false,
        schedule: Vec::new(),
        finger: None,
    }
}
