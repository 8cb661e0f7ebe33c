//! Scenes whose ends are known; those of rigid bodies are the ones on which other engines were measured.

use crate::model::{Body, Compliance, Material, Obstacle, Planar, PlanarShape, Restitution, Space, World};

/// A scene and where its bodies end.
pub(super) struct Known {
    pub(super) name: &'static str,
    pub(super) world: World<Planar>,
    /// Centers of mass at the end (m).
    pub(super) end: Vec<[f64; 2]>,
}

/// Half of the height of a box and radius of a ball, and half of the length of a box (m).
const SIZE: f64 = 0.05;
const LONG: f64 = 0.1;
const GRAVITY: f64 = 9.81;

/// A box that slides to a stop: v²/(2 μ g).
pub(super) fn slide() -> Known {
    let (mu, speed) = (0.3, 3.0);
    let world = World { duration: 1.5, ..on_floor(block([0.0, SIZE], [speed, 0.0, 0.0]), mu) };
    Known { name: "box slides to a stop", world, end: vec![[speed * speed / (2.0 * mu * GRAVITY), SIZE]] }
}

/// A box on an incline of slope 0.505, its floor along x: (sin a - μ cos a) g t²/2.
pub(super) fn incline(mu: f64) -> Known {
    let (slope, time) = (0.505_f64, 2.0);
    let cosine = 1.0 / (1.0 + slope * slope).sqrt();
    let world = World {
        gravity: [GRAVITY * slope * cosine, -GRAVITY * cosine],
        duration: time,
        ..on_floor(block([0.0, SIZE], [0.0; 3]), mu)
    };
    let end = vec![[0.5 * GRAVITY * (slope - mu) * cosine * time * time, SIZE]];
    Known { name: if mu == 0.0 { "box on ice" } else { "box slips on an incline" }, world, end }
}

/// A ball with backspin, which slips until it rolls back at 3/7 of its speed.
pub(super) fn backspin() -> Known {
    let (mu, speed, spin, time) = (0.3, 1.0, 80.0, 2.0);
    let slips = (speed + SIZE * spin) / (3.5 * mu * GRAVITY);
    let rolls_at = speed - mu * GRAVITY * slips;
    let x = speed * slips - 0.5 * mu * GRAVITY * slips * slips + rolls_at * (time - slips);
    let world = World { duration: time, ..on_floor(ball(0.2, [0.0, SIZE], [speed, 0.0, spin]), mu) };
    Known { name: "ball with backspin", world, end: vec![[x, SIZE]] }
}

/// A ball that bounces with a coefficient of restitution of 0.8.
pub(super) fn bounce() -> Known {
    let (e, height, time) = (0.8, 0.15, 0.82);
    let mut world = World { duration: time, ..on_floor(ball(0.2, [0.0, SIZE + height], [0.0; 3]), 0.0) };
    world.materials.iter_mut().for_each(|material| material.restitution = Restitution::Newton(e));
    let mut since = time - (2.0 * height / GRAVITY).sqrt();
    let mut speed = e * (2.0 * height * GRAVITY).sqrt();
    while since > 2.0 * speed / GRAVITY {
        since -= 2.0 * speed / GRAVITY;
        speed *= e;
    }
    Known { name: "ball bounces", world, end: vec![[0.0, SIZE + speed * since - 0.5 * GRAVITY * since * since]] }
}

/// A ball that lands on a floor of this stiffness and is still pressed in at the end, as a damped oscillator.
pub(super) fn landing(stiffness: f64) -> Known {
    let (drop, damping): (f64, f64) = (0.02, 0.1);
    let omega = stiffness.sqrt();
    let falls = (2.0 * drop / GRAVITY).sqrt();
    // half of the time for which it is pressed in, about
    let pressed = 0.5 * std::f64::consts::PI / omega;
    let sag = GRAVITY / stiffness;
    let damped = omega * (1.0 - damping * damping).sqrt();
    let (sine, cosine) = libm::sincos(damped * pressed);
    let b = (GRAVITY * falls - damping * omega * sag) / damped;
    let deep = sag + libm::exp(-damping * omega * pressed) * (b * sine - sag * cosine);
    let mut world = World { duration: falls + pressed, ..on_floor(ball(1.0, [0.0, SIZE + drop], [0.0; 3]), 0.2) };
    comply(&mut world, stiffness, 2.0 * damping * omega);
    Known { name: "ball lands on a soft floor", world, end: vec![[0.0, SIZE - deep]] }
}

/// Blocks on an incline of slope 0.15, the top one heavier than the others: too flat to tip, one motion for all of them.
pub(super) fn stack(mu: f64, ratio: f64) -> Known {
    let (slope, time) = (0.15_f64, 0.25);
    let cosine = 1.0 / (1.0 + slope * slope).sqrt();
    let mut bodies: Vec<Body<Planar>> =
        (0..3).map(|level| block([0.0, SIZE * (1.0 + 2.0 * f64::from(level))], [0.0; 3])).collect();
    if let Some(top) = bodies.last_mut() {
        (top.mass, top.inertia) = (ratio, [ratio * top.inertia[0]]);
    }
    let x = 0.5 * GRAVITY * cosine * (slope - mu).max(0.0) * time * time;
    let end = bodies.iter().map(|body| [x, body.pose[1]]).collect();
    let gravity = [GRAVITY * cosine * slope, -GRAVITY * cosine];
    let materials = vec![material(mu); bodies.len() * (bodies.len() + 1)];
    let world = World { gravity, duration: time, bodies, materials, ..on_floor(block([0.0; 2], [0.0; 3]), mu) };
    Known { name: "stack on an incline", world, end }
}

/// A ball that falls onto a compliant floor and bounces; where it ends is not known in closed form.
pub(super) fn drop(stiffness: f64) -> World<Planar> {
    let mut world = World { duration: 0.3, ..on_floor(ball(1.0, [0.0, SIZE + 0.05], [0.0; 3]), 0.2) };
    comply(&mut world, stiffness, 0.2 * stiffness.sqrt());
    world
}

/// Gives all contacts the same compliance along and across.
pub(super) fn comply<S: Space>(world: &mut World<S>, stiffness: f64, damping: f64) {
    let compliance = Compliance { stiffness: [stiffness; 2], damping: [damping; 2], gamma: 1e-9 };
    world.materials.iter_mut().for_each(|material| material.compliance = Some(compliance));
}

/// One body over a floor at y = 0.
fn on_floor(body: Body<Planar>, mu: f64) -> World<Planar> {
    World {
        gravity: [0.0, -GRAVITY],
        duration: 1.0,
        step: None,
        margin: None,
        directions: 2,
        bodies: vec![body],
        fixed: vec![Obstacle {
            name: "floor".to_owned(),
            shape: PlanarShape::HalfPlane { point: [0.0; 2], normal: [0.0, 1.0] },
            surface_velocity: [0.0; 2],
        }],
        materials: vec![material(mu); 2],
    }
}

fn material(friction: f64) -> Material {
    Material { friction, restitution: Restitution::Newton(0.0), compliance: None }
}

fn block(at: [f64; 2], velocity: [f64; 3]) -> Body<Planar> {
    let corners = vec![[-LONG, -SIZE], [LONG, -SIZE], [LONG, SIZE], [-LONG, SIZE]];
    body(PlanarShape::Polygon(corners), [1.0, (LONG * LONG + SIZE * SIZE) / 3.0], at, velocity)
}

fn ball(mass: f64, at: [f64; 2], velocity: [f64; 3]) -> Body<Planar> {
    body(PlanarShape::Circle { center: [0.0; 2], radius: SIZE }, [mass, 0.4 * mass * SIZE * SIZE], at, velocity)
}

fn body(shape: PlanarShape, [mass, inertia]: [f64; 2], [x, y]: [f64; 2], velocity: [f64; 3]) -> Body<Planar> {
    Body {
        name: "body".to_owned(),
        shape,
        mass,
        inertia: [inertia],
        pose: [x, y, 0.0],
        velocity,
        is_kinematic: false,
        schedule: Vec::new(),
        finger: None,
    }
}
