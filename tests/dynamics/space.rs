//! Boxes and balls in space: closed forms, balances, symmetries.

use crate::space_made::{about, ball, block, fixed, floor, leaned, moved, run, world};
use partplan::answer::{ContactState, Feature, Simulation, Status};
use partplan::dynamics::{Mechanics as _, ModelKind, Options, SimulationError, simulate};
use partplan::model::{
    Body, Compliance, Material, Obstacle, Planar, PlanarShape, Restitution, Spatial, SpatialShape, World,
};

const G: f64 = 9.81;
const RIGID: [ModelKind; 2] = [ModelKind::Moreau, ModelKind::StewartTrinkle];

fn pose(run: &Simulation<Spatial>, body: usize) -> [f64; 7] {
    run.last.poses[body]
}

/// How far a body has moved in its worst coordinate.
fn shift(run: &Simulation<Spatial>, world: &World<Spatial>, body: usize) -> f64 {
    let from = world.bodies[body].pose;
    pose(run, body).iter().zip(from).map(|(to, from)| (to - from).abs()).fold(0.0, f64::max)
}

/// A box dropped flat loses m g H and v = √(2 g H) at once, does not turn, and carries its weight on its corners.
#[test]
fn a_box_dropped_flat_rests_on_a_plane_and_on_a_box() {
    let half = [0.1, 0.06, 0.04];
    for (under, top) in [(floor(), 0.0), (fixed([0.5, 0.4, 0.05]), 0.05), (fixed([0.02, 0.4, 0.05]), 0.05)] {
        let start = moved(0.01, 0.02, top + half[2] + 0.05);
        let scene = World { directions: 4, ..world(vec![block(half, start)], vec![under], 0.116, 0.3) };
        for model in RIGID {
            let run = run(&scene, model, 4e-3);
            assert_eq!(run.status, Status::Complete, "{:?}", run.notes);
            let end = pose(&run, 0);
            assert!((end[2] - top - half[2]).abs() < 1e-8, "{model:?}: {}", end[2]);
            assert!((end[0] - 0.01).abs() < 1e-9 && (end[1] - 0.02).abs() < 1e-9);
            assert!(end[3] > 1.0 - 1e-12, "turned: {end:?}");
            // which corners carry is not determined: a diagonal may do
            assert!((2..=4).contains(&run.last.touches.len()), "{:?}", run.last.touches);
            let weight: f64 = run.last.touches.iter().map(|touch| touch.impulse[0]).sum();
            assert!((weight / 4e-3 - G).abs() < 1e-6);
            if model == ModelKind::Moreau {
                assert!((run.solver.fastest_impact - (2.0 * G * 0.05_f64).sqrt()).abs() < 1e-6);
                assert!((run.energy.dissipated - G * 0.05).abs() < 1e-6);
            }
        }
    }
}

/// Compliant corners sink by m g / 4 K each, on a plane and on a box.
#[test]
fn a_box_sinks_into_another_as_its_springs_say() {
    let half = [0.1, 0.06, 0.04];
    for (under, top) in [(floor(), 0.0), (fixed([0.5, 0.4, 0.05]), 0.05)] {
        let mut scene = world(vec![block(half, moved(0.0, 0.0, top + half[2] + 1e-3))], vec![under], 0.5, 0.3);
        let compliance = Compliance { stiffness: [5e4; 2], damping: [300.0; 2], gamma: 1e-8 };
        scene.materials.iter_mut().for_each(|material| material.compliance = Some(compliance));
        let run = run(&scene, ModelKind::SongPangKumar, 5e-4);
        assert_eq!(run.status, Status::Complete, "{:?}", run.notes);
        let sunk = top + half[2] - pose(&run, 0)[2];
        assert!((sunk - G / (4.0 * 5e4)).abs() < 1e-9, "sunk by {sunk}");
        assert!(run.energy.largest_gain < 1e-9);
    }
}

/// A box slides v²/(2 μ g) far whatever the direction: friction is bounded by a disc.
#[test]
fn a_sliding_box_stops_where_coulomb_says() {
    for (under, top, angles) in [(floor(), 0.0, vec![0.0, 30.0, 90.0]), (fixed([1.0, 1.0, 0.05]), 0.05, vec![30.0])] {
        for degrees in angles {
            let (sine, cosine) = libm::sincos(f64::to_radians(degrees));
            let mut scene =
                world(vec![block([0.1, 0.06, 0.04], moved(0.0, 0.0, top + 0.04))], vec![under.clone()], 0.12, 0.3);
            scene.bodies[0].velocity = [0.3 * cosine, 0.3 * sine, 0.0, 0.0, 0.0, 0.0];
            let run = run(&scene, ModelKind::Moreau, 4e-3);
            let (end, far) = (pose(&run, 0), 0.09 / (2.0 * 0.3 * G));
            assert!((end[0] - far * cosine).abs() < 1e-4, "{degrees}: {} for {}", end[0], far * cosine);
            assert!((end[1] - far * sine).abs() < 1e-4, "{degrees}: {} for {}", end[1], far * sine);
            assert!(end[3] > 1.0 - 1e-10, "turned: {end:?}");
            assert!(run.last.touches.iter().all(|touch| touch.state == ContactState::Stick));
        }
    }
}

/// Three boxes on each other, of one size, and of three, the second turned, stay.
#[test]
fn a_stack_stays() {
    for sides in [[0.1, 0.1, 0.1], [0.1, 0.08, 0.12]] {
        let mut bodies = Vec::new();
        let mut height = 0.0;
        for (i, side) in sides.into_iter().enumerate() {
            let turn = if sides[0] == sides[1] || i != 1 { 0.0 } else { 0.4 };
            bodies.push(block([side, side, 0.05], about([0.0, 0.0, 1.0], turn, [0.0, 0.0, height + 0.05])));
            height += 0.1;
        }
        let scene = World { directions: 4, ..world(bodies, vec![floor()], 0.06, 0.3) };
        for model in RIGID {
            let run = run(&scene, model, 4e-3);
            assert_eq!(run.status, Status::Complete, "{:?}", run.notes);
            for body in 0..3 {
                assert!(shift(&run, &scene, body) < 1e-8, "{model:?} {body}: {:?}", pose(&run, body));
            }
        }
    }
}

/// A ball put on the middle of a box stays; one that rolls leaves over the edge, as fast as it came.
#[test]
fn a_ball_on_a_box_stays_or_rolls_off() {
    let mut scene = world(vec![ball(0.05, moved(0.0, 0.0, 0.1))], vec![fixed([0.1, 0.1, 0.05])], 0.5, 0.4);
    for model in RIGID {
        assert!(shift(&run(&scene, model, 1e-3), &scene, 0) < 1e-9);
    }
    scene.bodies[0].velocity = [0.5, 0.0, 0.0, 0.0, 10.0, 0.0];
    for model in RIGID {
        let run = run(&scene, model, 1e-3);
        let (end, velocity) = (pose(&run, 0), run.last.velocities[0]);
        assert!(end[0] > 0.15 && end[2] < 0.0, "{model:?}: {end:?}");
        assert!(velocity[0] >= 0.5 && end[1].abs() < 1e-12, "{model:?}: {velocity:?}");
        assert!(run.energy.largest_gain < 1e-3, "{model:?}: {}", run.energy.largest_gain);
    }
}

/// A ball in the slot between two boxes lies on both edges, each pushing with m g / (2 cos α), sin α = w / r.
#[test]
fn a_ball_rests_between_two_boxes() {
    let (r, w) = (0.05_f64, 0.03_f64);
    let height = (r * r - w * w).sqrt();
    let held = |x: f64| Body { is_kinematic: true, ..block([0.1; 3], moved(x, 0.0, -0.1)) };
    let scene =
        world(vec![held(-0.1 - w), ball(r, moved(0.0, 0.01, height + 1e-3)), held(0.1 + w)], Vec::new(), 0.3, 0.0);
    for model in RIGID {
        let run = run(&scene, model, 1e-3);
        assert!((pose(&run, 1)[2] - height).abs() < 1e-7, "{model:?}: {}", pose(&run, 1)[2]);
        assert_eq!(run.last.touches.len(), 2);
        for touch in &run.last.touches {
            assert!((touch.impulse[0] / 1e-3 - G / (2.0 * height / r)).abs() < 1e-4, "{:?}", touch.impulse);
        }
    }
}

/// A cube on its edge, past the balance, falls on its side; before it, back.
#[test]
fn a_cube_on_its_edge_tips_over() {
    let quarter = std::f64::consts::FRAC_PI_4;
    for (lean, end) in [(quarter + 0.2, 2.0 * quarter), (quarter - 0.2, 0.0)] {
        let (sine, cosine) = libm::sincos(lean);
        let start = about([0.0, 1.0, 0.0], lean, [0.0, 0.0, 0.06 * (sine + cosine)]);
        let scene = world(vec![block([0.06; 3], start)], vec![floor()], 0.3, 0.8);
        let run = run(&scene, ModelKind::Moreau, 5e-3);
        assert_eq!(run.status, Status::Complete, "{:?}", run.notes);
        let pose = pose(&run, 0);
        assert!((pose[2] - 0.06).abs() < 1e-7 && pose[1].abs() < 1e-9, "{lean}: {pose:?}");
        assert!((2.0 * libm::atan2(pose[5], pose[3]) - end).abs() < 1e-7, "{lean}: {pose:?}");
        assert!(run.last.velocities[0].iter().all(|v| v.abs() < 1e-6));
        assert!(run.energy.largest_gain < 1e-3, "{}", run.energy.largest_gain);
    }
}

/// A bar across another lies on the four crossings of their edges, a square on one turned by 45° on eight.
#[test]
fn crossed_boxes_touch_where_their_edges_cross() {
    for (half, count) in [([0.4, 0.05, 0.05], 4), ([0.2, 0.2, 0.05], 8)] {
        let start = about([0.0, 0.0, 1.0], std::f64::consts::FRAC_PI_4, [0.0, 0.0, 0.1 + 1e-4]);
        let scene = World { directions: 4, ..world(vec![block(half, start)], vec![fixed(half)], 0.02, 0.5) };
        let mut contacts = Vec::new();
        Spatial::contacts(&mut (), &scene, &[start], 1e-3, &mut contacts);
        assert_eq!(contacts.len(), count);
        for contact in &contacts {
            assert!((contact.gap - 1e-4).abs() < 1e-12);
            assert!((contact.normal[2] - 1.0).abs() < 1e-12, "{:?}", contact.normal);
            assert!(matches!((contact.name.feature, contact.name.other_feature), (Feature::Edge(_), Feature::Edge(_))));
        }
        for model in RIGID {
            let run = run(&scene, model, 4e-3);
            assert!((pose(&run, 0)[2] - 0.1).abs() < 1e-8);
            assert!((pose(&run, 0)[3] - start[3]).abs() < 1e-9);
        }
    }
}

/// An edge along x above an edge along y: one contact, above the lower edge, along z.
#[test]
fn two_edges_meet_in_a_point() {
    let half = [0.2, 0.1, 0.1];
    let diagonal = 0.1 * std::f64::consts::SQRT_2;
    let upper = about([1.0, 0.0, 0.0], std::f64::consts::FRAC_PI_4, [0.03, 0.02, 2.0 * diagonal + 0.005]);
    let lower = about([0.0, 1.0, 0.0], std::f64::consts::FRAC_PI_4, [0.0; 3]);
    let beneath = Body { is_kinematic: true, ..block([0.1, 0.2, 0.1], lower) };
    let scene = world(vec![block(half, upper), beneath], Vec::new(), 0.1, 0.5);
    let mut contacts = Vec::new();
    Spatial::contacts(&mut (), &scene, &[upper, lower], 0.02, &mut contacts);
    let [contact] = contacts.as_slice() else { panic!("{} contacts", contacts.len()) };
    assert!((contact.gap - 0.005).abs() < 1e-14);
    let away = [0.0, 0.02, diagonal + 0.005].into_iter().zip(contact.point).map(|(a, b)| (a - b).abs());
    assert!(away.fold(0.0, f64::max) < 1e-14, "{:?}", contact.point);
    assert!((contact.normal[2] - 1.0).abs() < 1e-14);
    let run = run(&scene, ModelKind::Moreau, 1e-3);
    assert!(run.solver.impacts >= 1 && run.penetration.0 < 1e-8, "{:?}", run.penetration);
}

/// Two cubes and a ball that collide off center in free flight keep momentum, and energy never grows.
#[test]
fn collisions_keep_momentum() {
    let mut cube = block([0.1; 3], leaned([1.0, 2.0, 0.5], 0.6, [-0.4, 0.03, 0.02]));
    cube.velocity = [2.0, 0.0, 0.1, 0.5, -1.0, 2.0];
    let mut other = block([0.1; 3], leaned([0.3, -1.0, 0.7], 1.1, [0.1, 0.0, 0.0]));
    other.velocity = [-1.0, 0.2, 0.0, 0.0, 1.0, 0.0];
    let third = ball(0.1, moved(0.5, 0.05, 0.0));
    let mut scene = world(vec![cube, other, third], Vec::new(), 0.8, 0.3);
    scene.gravity = [0.0; 3];
    scene.materials.iter_mut().for_each(|material| material.restitution = Restitution::Newton(0.6));
    let totals = |poses: &[[f64; 7]], velocities: &[[f64; 6]]| {
        let mut sum = [0.0; 6];
        for ((body, pose), velocity) in scene.bodies.iter().zip(poses).zip(velocities) {
            let [px, py, pz, lx, ly, lz] = Spatial::momentum(body, pose, velocity);
            let [x, y, z, ..] = *pose;
            let all = [px, py, pz, lx + y * pz - z * py, ly + z * px - x * pz, lz + x * py - y * px];
            sum.iter_mut().zip(all).for_each(|(sum, part)| *sum += part);
        }
        sum
    };
    let start: Vec<_> = scene.bodies.iter().map(|body| (body.pose, body.velocity)).collect();
    let (poses, velocities): (Vec<_>, Vec<_>) = start.into_iter().unzip();
    let before = totals(&poses, &velocities);
    for (model, tolerance) in [(ModelKind::StewartTrinkle, 1e-12), (ModelKind::Moreau, 1e-5)] {
        let run = run(&scene, model, 1e-3);
        let after = totals(&run.last.poses, &run.last.velocities);
        for (after, before) in after.iter().zip(before) {
            assert!((after - before).abs() < tolerance, "{model:?}: {after} for {before}");
        }
        assert!(run.energy.largest_gain < 1e-9, "{model:?}: {}", run.energy.largest_gain);
        assert!(run.energy.dissipated > 0.01 && !run.events.is_empty(), "nothing collided");
    }
}

/// A rectangle in the plane and a box in space that fall on an edge and tumble move alike, but for how orientations advance.
#[test]
fn a_planar_scene_in_space_moves_as_in_the_plane() {
    let (half, angle, h) = ([0.1, 0.05], 0.5, 1e-4);
    let material = Material { friction: 0.4, restitution: Restitution::Newton(0.0), compliance: None };
    let inertia = (half[0] * half[0] + half[1] * half[1]) / 3.0;
    let corner = |x: f64, y: f64| [x * half[0], y * half[1]];
    let bar = [[-0.05, -0.2], [0.05, -0.2], [0.05, 0.0], [-0.05, 0.0]];
    let plane = World::<Planar> {
        gravity: [0.0, -G],
        duration: 0.2,
        step: None,
        margin: None,
        directions: 2,
        bodies: vec![Body {
            name: "peg".into(),
            shape: PlanarShape::Polygon(vec![
                corner(-1.0, -1.0),
                corner(1.0, -1.0),
                corner(1.0, 1.0),
                corner(-1.0, 1.0),
            ]),
            mass: 1.0,
            inertia: [inertia],
            pose: [0.02, 0.13, angle],
            velocity: [0.1, 0.0, 0.0],
            is_kinematic: false,
            schedule: Vec::new(),
            finger: None,
        }],
        fixed: vec![
            Obstacle { name: "bar".into(), shape: PlanarShape::Polygon(bar.into()), surface_velocity: [0.0; 2] },
            Obstacle {
                name: "floor".into(),
                shape: PlanarShape::HalfPlane { point: [0.0, -0.2], normal: [0.0, 1.0] },
                surface_velocity: [0.0; 2],
            },
        ],
        materials: vec![material; 3],
    };
    let options = Options { model: ModelKind::StewartTrinkle, step: Some(h), ..Options::default() };
    let flat = simulate(&plane, &options, &mut |_| true).unwrap().last;
    // planar y is z here; x to z turns about -y
    let start = about([0.0, -1.0, 0.0], angle, [0.02, 0.0, 0.23]);
    let mut body = block([half[0], 0.08, half[1]], start);
    body.inertia[1] = inertia;
    body.velocity = [0.1, 0.0, 0.0, 0.0, 0.0, 0.0];
    let mut low = floor();
    low.shape = SpatialShape::HalfSpace { point: [0.0, 0.0, -0.1], normal: [0.0, 0.0, 1.0] };
    // two directions of friction are those of the plane
    let obstacles = vec![fixed([0.05, 0.3, 0.1]), low];
    let scene = World { directions: 2, ..world(vec![body], obstacles, 0.2, 0.4) };
    let deep = run(&scene, ModelKind::StewartTrinkle, h).last;
    let end = deep.poses[0];
    let turned = -2.0 * libm::atan2(end[5], end[3]);
    let found = [end[0], end[2] - 0.1, turned];
    for (found, expected) in found.iter().zip(flat.poses[0]) {
        assert!((found - expected).abs() < 2e-6, "{found} for {expected}: {end:?} {:?}", flat.poses[0]);
    }
    assert!((flat.poses[0][2] - angle).abs() > 0.05, "it did not tumble");
    assert!(end[1].abs() < 1e-9);
}

/// A box that spins freely keeps angular momentum to first order in the step; its energy to second by the midpoint rule,
/// measured as ratios of 2.0 and 4.0.
#[test]
fn free_rotation_keeps_momentum_and_energy_to_the_order_of_the_scheme() {
    let mut part = block([0.2, 0.1, 0.05], leaned([1.0, 1.0, 0.3], 0.4, [0.0; 3]));
    part.velocity = [0.0, 0.0, 0.0, 3.0, 1.0, 2.0];
    let mut scene = world(vec![part], Vec::new(), 1.0, 0.0);
    scene.gravity = [0.0; 3];
    let momentum = |pose: &[f64; 7], velocity: &[f64; 6]| Spatial::momentum(&scene.bodies[0], pose, velocity);
    let start = momentum(&scene.bodies[0].pose, &scene.bodies[0].velocity);
    let size = start[3..].iter().map(|l| l * l).sum::<f64>().sqrt();
    for model in RIGID {
        let errors = [4e-3, 2e-3, 1e-3].map(|h| {
            let run = run(&scene, model, h);
            let end = momentum(&pose(&run, 0), &run.last.velocities[0]);
            let off = end.iter().zip(start).map(|(end, start)| (end - start).abs()).fold(0.0, f64::max) / size;
            (off, (run.energy.end / run.energy.start - 1.0).abs())
        });
        let energy = if model == ModelKind::Moreau { 3.7 } else { 1.8 };
        for pair in errors.windows(2) {
            assert!(pair[0].0 > 1.8 * pair[1].0 && pair[0].1 > energy * pair[1].1, "{model:?}: {errors:?}");
        }
        assert!(errors[2].0 < 1e-2 && errors[2].1 < 1e-2, "{model:?}: {errors:?}");
    }
}

/// A scene turned about the vertical does the same, turned.
#[test]
fn turning_a_scene_about_the_vertical_turns_its_result() {
    let scene = |turn: f64| {
        let (sine, cosine) = libm::sincos(turn);
        let about_z = |v: [f64; 3]| [cosine * v[0] - sine * v[1], sine * v[0] + cosine * v[1], v[2]];
        let axis = about_z([0.6, 0.8, 0.0]);
        let lean = leaned(axis, 0.3, about_z([0.05, 0.0, 0.16]));
        // after leaning about a turned axis, the box itself is turned first
        let mut part = block([0.1, 0.06, 0.04], composed(lean, turn));
        let velocity = about_z([0.4, -0.2, 0.0]);
        part.velocity[..3].copy_from_slice(&velocity);
        let lower = block([0.1, 0.1, 0.03], composed(moved(0.0, 0.0, 0.03), turn));
        world(vec![part, Body { is_kinematic: true, ..lower }], vec![floor()], 0.15, 0.4)
    };
    let straight = run(&scene(0.0), ModelKind::Moreau, 2e-3).last;
    for turn in [0.7, 2.0] {
        let turned = run(&scene(turn), ModelKind::Moreau, 2e-3).last;
        let (sine, cosine) = libm::sincos(turn);
        for (a, b) in straight.poses.iter().zip(&turned.poses) {
            let expected = [cosine * a[0] - sine * a[1], sine * a[0] + cosine * a[1], a[2]];
            for (found, expected) in b.iter().zip(expected) {
                assert!((found - expected).abs() < 1e-6, "{turn}: {b:?} for {expected:?}");
            }
        }
    }
}

/// A pose turned about z in its own frame first.
fn composed(pose: [f64; 7], turn: f64) -> [f64; 7] {
    let (s, c) = libm::sincos(0.5 * turn);
    let [x, y, z, e0, e1, e2, e3] = pose;
    [x, y, z, e0 * c - e3 * s, e1 * c + e2 * s, e2 * c - e1 * s, e3 * c + e0 * s]
}

/// Only fixed things are half spaces: nothing would find what such a body touches.
#[test]
fn a_body_without_another_side_is_refused() {
    let mut scene = world(vec![ball(0.1, moved(0.0, 0.0, 1.0)), ball(0.1, moved(0.0, 0.0, 2.0))], vec![], 0.1, 0.0);
    scene.bodies[1].shape = SpatialShape::HalfSpace { point: [0.0; 3], normal: [0.0, 0.0, 1.0] };
    let found = simulate(&scene, &Options::default(), &mut |_| true).map(|_| ());
    assert_eq!(found, Err(SimulationError::FixedOnly { body: 1 }));
}
