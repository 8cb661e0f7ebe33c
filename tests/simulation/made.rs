//! Runs made by hand: springs and dampers where corners are below the floor, small steps, no solver.

use partplan::answer::{
    ContactName, ContactState, Energy, Event, Feature, Frame, ModelChoice, Simulation, SolverStatistics, Status, Touch,
};
use partplan::case::{Limits, read_scene};
use partplan::model::{Planar, PlanarShape, Scene, Space, Spatial, SpatialShape, World};

const K: f64 = 5e4;
const C: f64 = 14.142_135_623_730_951;
const H: f64 = 1e-4;

pub fn planar(text: &str) -> World<Planar> {
    match read_scene(text.as_bytes(), &Limits::default()).unwrap().scene {
        Scene::Planar(world) => world,
        Scene::Spatial(_) => panic!("planar"),
    }
}

pub fn spatial(text: &str) -> World<Spatial> {
    match read_scene(text.as_bytes(), &Limits::default()).unwrap().scene {
        Scene::Spatial(world) => world,
        Scene::Planar(_) => panic!("spatial"),
    }
}

/// A run with these frames, and something in every field.
pub fn run<S: Space>(frames: Vec<Frame<S>>, events: Vec<Event>) -> Simulation<S> {
    let last = frames[frames.len() - 1].clone();
    Simulation {
        status: Status::Complete,
        time: last.time,
        last,
        frames,
        events,
        deformations: Vec::new(),
        energy: Energy { start: 0.3924, end: 0.0490, work: 0.0, dissipated: 0.3434, largest_gain: 2e-17 },
        penetration: (3.1e-4, 0.1725),
        solver: SolverStatistics {
            steps: 5_000,
            problems: 1_234,
            pivots: 2_468,
            rungs: vec![("lemke", 1_230), ("enumeration", 4)],
            residual: 3.2e-14,
            impacts: 0,
            fastest_impact: 0.0,
            subdivided: 1,
        },
        model: ModelChoice {
            chosen: "spk",
            step: 2e-4,
            why: vec!["the case gives stiffness and damping of the contacts".into(), "friction 0.2 at 1 pair".into()],
            error: Some(2.4e-5),
        },
        notes: Vec::new(),
    }
}

fn frame<S: Space>(step: usize, states: &[(S::Pose, S::Velocity)], touches: Vec<Touch<S>>) -> Frame<S> {
    let (poses, velocities) = states.iter().copied().unzip();
    Frame { time: step as f64 * H, poses, velocities, touches }
}

/// Convex polygons, each by itself, over a floor at height 0.
pub fn dropped(world: &World<Planar>) -> Simulation<Planar> {
    let mut states: Vec<([f64; 3], [f64; 3])> = world.bodies.iter().map(|body| (body.pose, body.velocity)).collect();
    let (mut frames, mut events, mut down) = (Vec::new(), Vec::new(), std::collections::BTreeSet::new());
    let steps = (world.duration / H).round() as usize;
    frames.push(frame(0, &states, Vec::new()));
    for step in 1..=steps {
        let mut touches = Vec::new();
        for (number, (body, (pose, velocity))) in world.bodies.iter().zip(&mut states).enumerate() {
            let PlanarShape::Polygon(corners) = &body.shape else { continue };
            let (sin, cos) = pose[2].sin_cos();
            let mut wrench = [0.0, -9.81 * body.mass, 0.0];
            for (corner, [u, v]) in corners.iter().enumerate() {
                let arm = [u * cos - v * sin, u * sin + v * cos];
                let (depth, sink) = (-(pose[1] + arm[1]), -(velocity[1] + velocity[2] * arm[0]));
                let name = ContactName {
                    body: number,
                    feature: Feature::Vertex(corner as u32),
                    other: world.bodies.len(),
                    other_feature: Feature::Surface(0),
                };
                let normal = if depth > 0.0 { (K * depth + C * sink).max(0.0) } else { 0.0 };
                let changes = if normal > 0.0 { down.insert(name) } else { down.remove(&name) };
                let [from, to] = if normal > 0.0 {
                    [ContactState::Open, ContactState::Slip]
                } else {
                    [ContactState::Slip, ContactState::Open]
                };
                if changes {
                    events.push(Event { time: step as f64 * H, contact: name, from, to });
                }
                if normal == 0.0 {
                    continue;
                }
                let slip = velocity[0] - velocity[2] * arm[1];
                let pull =
                    -world.material(number, world.bodies.len()).friction * normal * (slip / 0.01).clamp(-1.0, 1.0);
                wrench = [wrench[0] + pull, wrench[1] + normal, wrench[2] + arm[0] * normal - arm[1] * pull];
                touches.push(Touch {
                    contact: name,
                    state: to,
                    point: [pose[0] + arm[0], pose[1] + arm[1]],
                    normal: [0.0, 1.0],
                    impulse: [normal * H, pull * H, 0.0],
                });
            }
            for axis in 0..3 {
                velocity[axis] += H * wrench[axis] / if axis < 2 { body.mass } else { body.inertia[0] };
                pose[axis] += H * velocity[axis];
            }
        }
        if step.is_multiple_of(20) {
            frames.push(frame(step, &states, touches));
        }
    }
    run(frames, events)
}

/// A sphere over a floor at height 0.
pub fn thrown(world: &World<Spatial>) -> Simulation<Spatial> {
    let body = &world.bodies[0];
    let SpatialShape::Sphere { radius, .. } = body.shape else { panic!("a sphere") };
    let (mut pose, mut velocity) = (body.pose, body.velocity);
    let mut frames = vec![frame(0, &[(pose, velocity)], Vec::new())];
    for step in 1..=(world.duration / H).round() as usize {
        let mut touches = Vec::new();
        let (depth, sink) = (radius - pose[2], -velocity[2]);
        let normal = if depth > 0.0 { (K * depth + C * sink).max(0.0) } else { 0.0 };
        let slip = [velocity[0] - radius * velocity[4], velocity[1] + radius * velocity[3]];
        let friction = world.material(0, 1).friction;
        let pull = slip.map(|s| -friction * normal * s / slip[0].hypot(slip[1]).max(0.01));
        let inertia = body.inertia[0];
        let force = [pull[0], pull[1], normal - 9.81 * body.mass];
        let torque = [radius * pull[1], -radius * pull[0], 0.0];
        for axis in 0..3 {
            velocity[axis] += H * force[axis] / body.mass;
            velocity[3 + axis] += H * torque[axis] / inertia;
            pose[axis] += H * velocity[axis];
        }
        turn(&mut pose, [velocity[3], velocity[4], velocity[5]]);
        if normal > 0.0 {
            touches.push(Touch {
                contact: ContactName {
                    body: 0,
                    feature: Feature::Surface(0),
                    other: 1,
                    other_feature: Feature::Surface(0),
                },
                state: ContactState::Slip,
                point: [pose[0], pose[1], 0.0],
                normal: [0.0, 0.0, 1.0],
                impulse: [normal * H, pull[0] * H, pull[1] * H],
            });
        }
        if step.is_multiple_of(20) {
            frames.push(frame(step, &[(pose, velocity)], touches));
        }
    }
    run(frames, Vec::new())
}

/// e' = (-ω·e, e0 ω + ω × e) / 2, renormalised.
fn turn(pose: &mut [f64; 7], w: [f64; 3]) {
    let [e0, x, y, z] = [pose[3], pose[4], pose[5], pose[6]];
    let rate = [
        -(w[0] * x + w[1] * y + w[2] * z),
        e0 * w[0] + w[1] * z - w[2] * y,
        e0 * w[1] + w[2] * x - w[0] * z,
        e0 * w[2] + w[0] * y - w[1] * x,
    ];
    for (entry, rate) in pose[3..].iter_mut().zip(rate) {
        *entry += H * rate / 2.0;
    }
    let length = pose[3..].iter().map(|entry| entry * entry).sum::<f64>().sqrt();
    pose[3..].iter_mut().for_each(|entry| *entry /= length);
}
