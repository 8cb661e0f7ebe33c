//! What holds in every scene: balances, invariances, determinism.

use crate::drops::{drops, half_plane, run, world};
use partplan::answer::{Frame, Simulation, Status};
use partplan::dynamics::ModelKind::{Moreau, StewartTrinkle};
use partplan::dynamics::{ModelKind, Options, simulate};
use partplan::model::{Body, Planar, PlanarShape, World};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::{RngSeed, TestRunner};

const H: f64 = 2e-3;

/// Both rigid schemes.
const RIGID: [ModelKind; 2] = [StewartTrinkle, Moreau];

/// Moves every outline, pose and velocity of a world by the same maps.
fn mapped(
    world: &World<Planar>,
    place: impl Fn([f64; 2]) -> [f64; 2],
    turn: impl Fn([f64; 2]) -> [f64; 2],
    own: impl Fn(&PlanarShape) -> PlanarShape,
    [angle_sign, angle]: [f64; 2],
) -> World<Planar> {
    let mut world = world.clone();
    world.gravity = turn(world.gravity);
    for body in &mut world.bodies {
        let ([x, y, a], [vx, vy, w]) = (body.pose, body.velocity);
        let ([x, y], [vx, vy]) = (place([x, y]), turn([vx, vy]));
        (body.pose, body.velocity) = ([x, y, angle_sign * a + angle], [vx, vy, angle_sign * w]);
        body.shape = own(&body.shape);
    }
    for obstacle in &mut world.fixed {
        if let PlanarShape::HalfPlane { point, normal } = obstacle.shape {
            obstacle.shape = PlanarShape::HalfPlane { point: place(point), normal: turn(normal) };
        }
    }
    world
}

/// Largest difference of the last poses (m, rad).
fn apart<'a>(a: impl Iterator<Item = [f64; 3]>, b: impl Iterator<Item = &'a [f64; 3]>) -> f64 {
    let pairs = a.zip(b).flat_map(|(a, b)| (0..3).map(move |i| (a[i] - b[i]).abs()));
    pairs.fold(0.0, f64::max)
}

/// How far poses may be apart (m, rad). Stewart and Trinkle's step leaves rounding, which impacts magnify; the instants
/// of located impacts are known to a gap of half a billionth of the smallest part, which is magnified as well.
fn allowed(model: ModelKind) -> f64 {
    if model == StewartTrinkle { 1e-9 } else { 1e-8 }
}

/// The schemes whose ends can be compared: several parts that strike each other at instants that are off by the
/// tolerance of the location may take another course.
fn comparable(world: &World<Planar>) -> &'static [ModelKind] {
    if world.bodies.len() == 1 { &RIGID } else { &RIGID[..1] }
}

fn turned([cosine, sine]: [f64; 2]) -> impl Fn([f64; 2]) -> [f64; 2] {
    move |[x, y]| [cosine * x - sine * y, sine * x + cosine * y]
}

/// Change of momentum less that by gravity and by the contacts of the step, along x, y and about each center (N s, N m s).
fn imbalance(world: &World<Planar>, [before, after]: [&Frame<Planar>; 2]) -> f64 {
    let h = after.time - before.time;
    let mut left: Vec<[f64; 3]> = Vec::new();
    for (i, body) in world.bodies.iter().enumerate() {
        let (v, w) = (before.velocities[i], after.velocities[i]);
        let along = |axis: usize| body.mass * (w[axis] - v[axis] - h * world.gravity[axis]);
        left.push([along(0), along(1), body.inertia[0] * (w[2] - v[2])]);
    }
    for touch in &after.touches {
        let ([n, t], [x, y]) = (touch.impulse[..2].try_into().map(|[a, b]: [f64; 2]| [a, b]).unwrap(), touch.point);
        let [nx, ny] = touch.normal;
        let [px, py] = [n * nx + t * ny, n * ny - t * nx];
        for (body, sign) in [(touch.contact.body, 1.0), (touch.contact.other, -1.0)] {
            if let Some(left) = left.get_mut(body) {
                let [cx, cy, _] = before.poses[body];
                let torque = (x - cx) * py - (y - cy) * px;
                *left = [left[0] - sign * px, left[1] - sign * py, left[2] - sign * torque];
            }
        }
    }
    left.iter().flatten().map(|x| x.abs()).fold(0.0, f64::max)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, rng_seed: RngSeed::Fixed(1), ..ProptestConfig::default() })]

    /// Stewart and Trinkle's step: momentum changes by gravity and by the impulses at the contacts alone.
    #[test]
    fn momentum_is_balanced(world in drops(4)) {
        let run = run(&world, StewartTrinkle, H);
        // friction up to 2 may leave a sliding part without finite forces: its impulses balance all the same
        prop_assert!(run.status != Status::Partial, "{:?}", run.notes);
        for pair in run.frames.windows(2) {
            let off = imbalance(&world, [&pair[0], &pair[1]]);
            prop_assert!(off < 1e-12, "{:e} N s at {} s", off, pair[1].time);
        }
    }

    /// Stewart and Trinkle's step gains no energy on planes, where the linearised gap is never too large. Between parts
    /// that turn it lets them overlap, and undoes that at φ/h: the gain is at most what the deepest overlap explains.
    #[test]
    fn energy_grows_only_by_overlaps(world in drops(4)) {
        let run = run(&world, StewartTrinkle, H);
        let gain = run.energy.largest_gain;
        if world.bodies.len() == 1 {
            prop_assert!(gain <= 1e-14 * run.energy.start, "{gain:e} J of {:e} J", run.energy.start);
        }
        let mass: f64 = world.bodies.iter().map(|body| body.mass).sum();
        let speed = run.penetration.0 / H;
        let explained = mass * (0.5 * speed * speed + 9.81 * run.penetration.0);
        prop_assert!(gain <= explained + 1e-14 * run.energy.start, "{gain:e} J, {explained:e} J explained");
    }

    /// Turned and shifted with its gravity, a scene moves turned and shifted.
    #[test]
    fn frames_do_not_matter(world in drops(3), angle in -3.0_f64..3.0, shift in prop::array::uniform2(-1.0..1.0)) {
        let turn = turned([angle.cos(), angle.sin()]);
        let place = |p: [f64; 2]| { let [x, y] = turn(p); [x + shift[0], y + shift[1]] };
        let moved = mapped(&world, place, &turn, Clone::clone, [1.0, angle]);
        for &model in comparable(&world) {
            let [a, b] = [&world, &moved].map(|world| run(world, model, H));
            prop_assert_eq!(a.status, b.status);
            let expected = a.last.poses.iter().map(|[x, y, a]| { let [x, y] = place([*x, *y]); [x, y, a + angle] });
            let off = apart(expected, b.last.poses.iter());
            prop_assert!(off <= allowed(model), "{model:?}: {off:e}");
        }
    }

    /// Mirrored, a scene moves mirrored.
    #[test]
    fn mirrors_do_not_matter(world in drops(3)) {
        let flip = |[x, y]: [f64; 2]| [-x, y];
        let own = |shape: &PlanarShape| match shape {
            PlanarShape::Polygon(outline) => PlanarShape::Polygon(outline.iter().rev().map(|v| flip(*v)).collect()),
            other => other.clone(),
        };
        let mirrored = mapped(&world, flip, flip, own, [-1.0, 0.0]);
        for &model in comparable(&world) {
            let [a, b] = [&world, &mirrored].map(|world| run(world, model, H));
            let off = apart(a.last.poses.iter().map(|[x, y, a]| [-x, *y, -a]), b.last.poses.iter());
            prop_assert!(off <= allowed(model), "{model:?}: {off:e}");
        }
    }

    /// In other units of length, mass and time the poses are the same lengths.
    #[test]
    fn units_do_not_matter(world in drops(3), l in 0.01_f64..100.0, m in 0.01_f64..100.0, t in 0.01_f64..100.0) {
        let mut other = mapped(
            &world,
            |p| p.map(|x| l * x),
            |v| v,
            |shape| match shape {
                PlanarShape::Polygon(outline) => PlanarShape::Polygon(outline.iter().map(|v| v.map(|x| l * x)).collect()),
                PlanarShape::Circle { center, radius } => PlanarShape::Circle { center: *center, radius: l * radius },
                other => other.clone(),
            },
            [1.0, 0.0],
        );
        other.gravity = world.gravity.map(|g| g * l / (t * t));
        other.duration = world.duration * t;
        for body in &mut other.bodies {
            let [vx, vy, w] = body.velocity;
            body.velocity = [vx * l / t, vy * l / t, w / t];
            body.mass *= m;
            body.inertia[0] *= m * l * l;
        }
        for &model in comparable(&world) {
            let (a, b) = (run(&world, model, H), run(&other, model, H * t));
            let off = apart(b.last.poses.iter().map(|[x, y, a]| [x / l, y / l, *a]), a.last.poses.iter());
            prop_assert!(off <= allowed(model), "{model:?}: {off:e}");
        }
    }

    /// The order of a part's vertices and of what it touches changes nothing.
    #[test]
    fn order_does_not_matter(world in drops(1), by in 1_usize..6) {
        let mut other = world.clone();
        other.fixed.reverse();
        if let PlanarShape::Polygon(outline) = &mut other.bodies[0].shape {
            let by = by % outline.len();
            outline.rotate_left(by);
        }
        for &model in comparable(&world) {
            let [a, b] = [&world, &other].map(|world| run(world, model, H));
            let off = apart(a.last.poses.iter().copied(), b.last.poses.iter());
            prop_assert!(off <= allowed(model), "{model:?}: {off:e}");
        }
    }
}

/// Located impacts come to the end of every scene, however many features strike (in scene 253 features that replace each
/// other close 128 times in one step), and steps across corners gain at most a thousandth of the energy.
///
/// A corner that enters between two edges that neither sees is found only when it is millimetres deep: that ends the run
/// with the depth said, in at most one scene of fifty.
#[test]
fn located_impacts_come_to_an_end() {
    let (mut n_scenes, mut n_overlaps) = (0, 0);
    for seed in (0..100).chain([132, 136, 253]) {
        let config = ProptestConfig { rng_seed: RngSeed::Fixed(seed), ..ProptestConfig::default() };
        let world = drops(3).new_tree(&mut TestRunner::new(config)).unwrap().current();
        let run = run(&world, Moreau, H);
        n_scenes += 1;
        assert!(run.energy.largest_gain <= 1e-3 * run.energy.start, "scene {seed}: {:?}", run.energy);
        if run.notes.iter().any(|note| note.contains("nothing moves them apart")) {
            assert_eq!(run.status, Status::Inconsistent, "scene {seed}");
            n_overlaps += 1;
            continue;
        }
        assert!(run.status != Status::Partial && run.time == world.duration, "scene {seed}: {:?}", run.notes);
        assert!(run.penetration.0 <= 5e-3, "scene {seed}: {:?}", run.penetration);
    }
    assert!(n_overlaps * 50 <= n_scenes, "{n_overlaps} of {n_scenes}");
}

/// A block that slides, at rest on the floor from the start: x = v T - μ g T²/2.
fn slide(speed: f64, friction: f64, duration: f64) -> World<Planar> {
    let block = Body {
        name: "block".into(),
        shape: PlanarShape::Polygon(vec![[-0.1, -0.05], [0.1, -0.05], [0.1, 0.05], [-0.1, 0.05]]),
        mass: 1.0,
        inertia: [1.0 / 240.0],
        pose: [0.0, 0.05, 0.0],
        velocity: [speed, 0.0, 0.0],
        is_kinematic: false,
        schedule: Vec::new(),
        finger: None,
    };
    world(vec![block], vec![half_plane("floor", [0.0, 0.0], [0.0, 1.0])], friction, duration)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, rng_seed: RngSeed::Fixed(2), ..ProptestConfig::default() })]

    /// While a block slides, Stewart and Trinkle's step is short by μ g h T/2 exactly, so half the step halves the error;
    /// the midpoint step is exact.
    #[test]
    fn halving_the_step_halves_the_error(speed in 1.0_f64..3.0, friction in 0.05_f64..0.4, n in 10_usize..60) {
        let duration = 0.2;
        let exact = speed * duration - 0.5 * friction * 9.81 * duration * duration;
        let world = slide(speed, friction, duration);
        for n in [n, 2 * n] {
            let h = duration / n as f64;
            let [st, midpoint] = RIGID.map(|model| run(&world, model, h).last.poses[0][0] - exact);
            let short = 0.5 * friction * 9.81 * h * duration;
            prop_assert!((st + short).abs() < 1e-13 && midpoint.abs() < 1e-13, "{} for {}, {}", st, -short, midpoint);
        }
    }
}

/// Two parts between walls on a rough floor: impacts, slip, rest.
fn tumble() -> World<Planar> {
    let outlines = [
        PlanarShape::Polygon(vec![[-0.05, -0.025], [0.05, -0.025], [0.05, 0.025], [-0.05, 0.025]]),
        PlanarShape::Circle { center: [0.0; 2], radius: 0.03 },
    ];
    let bodies = outlines.into_iter().enumerate().map(|(i, shape)| Body {
        name: format!("part {i}"),
        shape,
        mass: 0.2 + 0.1 * i as f64,
        inertia: [2e-4],
        pose: [0.01 - 0.03 * i as f64, 0.15 + 0.15 * i as f64, 0.7],
        velocity: [0.3, 0.0, 2.0],
        is_kinematic: false,
        schedule: Vec::new(),
        finger: None,
    });
    let fixed = vec![
        half_plane("floor", [0.0, 0.0], [0.0, 1.0]),
        half_plane("left wall", [-0.12, 0.0], [1.0, 0.0]),
        half_plane("right wall", [0.12, 0.0], [-1.0, 0.0]),
    ];
    world(bodies.collect(), fixed, 0.3, 0.5)
}

/// FNV-1a over the bits of every pose and velocity of every frame.
fn fingerprint(run: &Simulation<Planar>) -> u64 {
    let frames = run.frames.iter().flat_map(|frame| frame.poses.iter().chain(&frame.velocities));
    let bytes = frames.flatten().flat_map(|x| x.to_bits().to_le_bytes());
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

/// The same scene gives the same bits: twice here, and on every platform, since sines are the crate's own and sums have
/// one order.
#[test]
fn runs_repeat_to_the_bit() {
    for (model, pinned) in [(Moreau, 0x02c5_e86c_7478_bf0d_u64), (StewartTrinkle, 0x64fc_1853_b12f_3ff8)] {
        let [a, b] = [0, 1].map(|_| run(&tumble(), model, H));
        assert_eq!(a, b, "{model:?}");
        assert!(a.events.len() > 10, "{model:?}: only {} events", a.events.len());
        assert_eq!(fingerprint(&a), pinned, "{model:?}: {:#x}", fingerprint(&a));
    }
    let [a, b] = [0, 1].map(|_| simulate(&tumble(), &Options::default(), &mut |_| true).unwrap());
    assert_eq!(a, b);
}
