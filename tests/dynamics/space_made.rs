//! Scenes of boxes and balls in space.

use partplan::answer::Simulation;
use partplan::dynamics::{ModelKind, Options, simulate};
use partplan::model::{Body, Material, Obstacle, Restitution, Spatial, SpatialShape, World};

/// Upright at a place.
pub fn moved(x: f64, y: f64, z: f64) -> [f64; 7] {
    [x, y, z, 1.0, 0.0, 0.0, 0.0]
}

/// Turned by an angle about an axis of unit length, at a place.
pub fn about(axis: [f64; 3], angle: f64, [x, y, z]: [f64; 3]) -> [f64; 7] {
    let (sine, cosine) = libm::sincos(0.5 * angle);
    [x, y, z, cosine, sine * axis[0], sine * axis[1], sine * axis[2]]
}

/// Turned by an angle about any axis, at a place.
pub fn leaned(axis: [f64; 3], angle: f64, at: [f64; 3]) -> [f64; 7] {
    let length = axis.iter().map(|x| x * x).sum::<f64>().sqrt();
    about(axis.map(|x| x / length), angle, at)
}

/// A uniform box of 1 kg.
pub fn block(half: [f64; 3], pose: [f64; 7]) -> Body<Spatial> {
    let [x, y, z] = half.map(|h| h * h / 3.0);
    body("box", SpatialShape::Box { half }, [y + z, z + x, x + y], pose)
}

/// A uniform ball of 1 kg.
pub fn ball(radius: f64, pose: [f64; 7]) -> Body<Spatial> {
    body("ball", SpatialShape::Sphere { center: [0.0; 3], radius }, [0.4 * radius * radius; 3], pose)
}

fn body(name: &str, shape: SpatialShape, inertia: [f64; 3], pose: [f64; 7]) -> Body<Spatial> {
    Body {
        name: name.into(),
        shape,
        mass: 1.0,
        inertia,
        pose,
        velocity: [0.0; 6],
        is_kinematic: false,
        schedule: Vec::new(),
        finger: None,
    }
}

/// The plane z = 0.
pub fn floor() -> Obstacle<Spatial> {
    obstacle(SpatialShape::HalfSpace { point: [0.0; 3], normal: [0.0, 0.0, 1.0] })
}

/// A fixed box about the origin.
pub fn fixed(half: [f64; 3]) -> Obstacle<Spatial> {
    obstacle(SpatialShape::Box { half })
}

/// Something fixed.
pub fn obstacle(shape: SpatialShape) -> Obstacle<Spatial> {
    Obstacle { name: "fixed".into(), shape, surface_velocity: [0.0; 2] }
}

/// A scene with one coefficient of friction.
pub fn world(
    bodies: Vec<Body<Spatial>>,
    fixed: Vec<Obstacle<Spatial>>,
    duration: f64,
    friction: f64,
) -> World<Spatial> {
    let material = Material { friction, restitution: Restitution::Newton(0.0), compliance: None };
    World {
        gravity: [0.0, 0.0, -9.81],
        duration,
        step: None,
        margin: None,
        directions: 16,
        materials: vec![material; bodies.len() * (bodies.len() + fixed.len())],
        bodies,
        fixed,
    }
}

/// A run with one model at one step.
pub fn run(world: &World<Spatial>, model: ModelKind, h: f64) -> Simulation<Spatial> {
    let options = Options { model, step: Some(h), ..Options::default() };
    simulate(world, &options, &mut |_| true).unwrap()
}
