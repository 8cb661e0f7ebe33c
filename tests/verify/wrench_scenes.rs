//! Runs with outcomes computed elsewhere: a part pushed by a wrench towards three fixels, with gaps at the start, the
//! contact problems answered by the solution found first or by the most adverse one.

use nalgebra::{Matrix3, Vector3};
use partplan::case::{Limits, read};
use partplan::dynamics::{ModelKind, Options, Policy, observe};
use partplan::exact::to_f64;
use partplan::model::{Body, Fixture, Material, Obstacle, Part, Planar, PlanarShape, Restitution, Shape, Timed, World};
use serde_json::Value;
use std::path::Path;

/// Gaps up to this are closed; the gaps at the start are near 0.01.
const CLOSED: f64 = 1e-5;

#[test]
fn from_every_state_whatever_solution_is_picked() {
    check("1_every_state.json");
}

#[test]
fn jams_of_wedged_parts() {
    check("3_jams.json");
}

fn check(file: &str) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests");
    let document: Value =
        serde_json::from_slice(&std::fs::read(folder.join("verify/wrench_scenes").join(file)).unwrap()).unwrap();
    let case = document["case"].as_str().unwrap().trim_start_matches("../");
    let case = read(&std::fs::read(folder.join(case)).unwrap(), &Limits::default()).unwrap();
    let fixture = case.fixture.unwrap();
    let runs = document["runs"].as_array().unwrap();
    assert!(runs.len() > 10);
    let faults: Vec<String> = runs.iter().filter_map(|run| fault(&case.part, &fixture, run)).collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// What differs from the expected outcome.
fn fault(part: &Part, fixture: &Fixture, run: &Value) -> Option<String> {
    let numbers = |key: &str| -> [f64; 3] {
        let list = run[key].as_array().unwrap();
        std::array::from_fn(|i| list[i].as_f64().unwrap())
    };
    let seat = Seat::new(part, fixture);
    let friction = match run["mu"].as_str() {
        Some(text) => to_f64(&super::support::q(text)),
        None => to_f64(&fixture.fixels[0].friction.static_.min),
    };
    let world = seat.world(numbers("wrench"), numbers("gaps"), friction, run["T"].as_f64().unwrap());
    let options = Options {
        model: ModelKind::StewartTrinkle,
        policy: if run["policy"] == "adverse" { Policy::Adverse } else { Policy::First },
        step: run["h"].as_f64(),
        ..Options::default()
    };
    let mut is_lost = false;
    let answer = observe(&world, &options, &mut |moment| {
        is_lost = seat.gaps(&moment.poses[0]).iter().any(|gap| *gap > 0.5);
        !is_lost
    })
    .unwrap();
    let gaps = seat.gaps(&answer.last.poses[0]);
    let state: String = gaps.iter().map(|gap| if *gap < CLOSED { '1' } else { '0' }).collect();
    let [vx, vy, spin] = answer.last.velocities[0];
    let speed = vx.hypot(vy) + 10.0 * spin.abs();
    let found = match (is_lost, state.as_str(), speed < 1e-6) {
        (true, _, _) => "lost",
        (false, "111", true) => "seated",
        (false, _, true) => "stuck",
        (false, _, false) => "moving",
    };
    let is_right = found == run["expect"] && run["final"].as_str().is_none_or(|expected| expected == state);
    (!is_right).then(|| format!("{}: {found} in {state} at {gaps:?}, speed {speed:e}", run["name"]))
}

/// The part's frame: the center of mass at the origin.
struct Seat {
    outline: Vec<[f64; 2]>,
    /// Fixels and unit normals.
    fixels: Vec<([f64; 2], [f64; 2])>,
    mass: f64,
    inertia: f64,
}

impl Seat {
    fn new(part: &Part, fixture: &Fixture) -> Self {
        let com = part.center_of_mass.each_ref().map(to_f64);
        let own = |point: &[_; 2]| [to_f64(&point[0]) - com[0], to_f64(&point[1]) - com[1]];
        let Shape::Polygon(polygon) = &part.shape else { panic!() };
        let fixels = fixture.fixels.iter().map(|fixel| {
            let [x, y] = fixel.normal.each_ref().map(to_f64);
            (own(&fixel.point), [x / x.hypot(y), y / x.hypot(y)])
        });
        Self {
            outline: polygon.vertices().iter().map(own).collect(),
            fixels: fixels.collect(),
            mass: to_f64(&part.mass),
            inertia: to_f64(&part.inertia),
        }
    }

    /// Distances of the fixels from the lines of their edges.
    fn gaps(&self, [x, y, angle]: &[f64; 3]) -> Vec<f64> {
        let (sine, cosine) = angle.sin_cos();
        let gap = |([px, py], [nx, ny]): &([f64; 2], [f64; 2])| {
            let normal = [cosine * nx - sine * ny, sine * nx + cosine * ny];
            let point = [x + cosine * px - sine * py, y + sine * px + cosine * py];
            normal[0] * (point[0] - px) + normal[1] * (point[1] - py)
        };
        self.fixels.iter().map(gap).collect()
    }

    fn world(&self, wrench: [f64; 3], gaps: [f64; 3], friction: f64, duration: f64) -> World<Planar> {
        let row = |([px, py], [nx, ny]): &([f64; 2], [f64; 2])| Vector3::new(*nx, *ny, px * ny - py * nx).transpose();
        let rows = Matrix3::from_rows(&[row(&self.fixels[0]), row(&self.fixels[1]), row(&self.fixels[2])]);
        let back = rows.try_inverse().unwrap();
        let mut pose = Vector3::zeros();
        for _ in 0..10 {
            let now = self.gaps(&[pose.x, pose.y, pose.z]);
            pose += back * Vector3::from_fn(|i, _| gaps[i] - now[i]);
        }
        let body = Body {
            name: "part".to_owned(),
            shape: PlanarShape::Polygon(self.outline.clone()),
            mass: self.mass,
            inertia: [self.inertia],
            pose: [pose.x, pose.y, pose.z],
            velocity: [0.0; 3],
            is_kinematic: false,
            schedule: vec![Timed { time: 0.0, value: wrench }],
            finger: None,
        };
        let fixel = |(at, _): &([f64; 2], [f64; 2])| Obstacle {
            name: format!("{at:?}"),
            shape: PlanarShape::Circle { center: *at, radius: 0.0 },
            surface_velocity: [0.0; 2],
        };
        let material = Material { friction, restitution: Restitution::Newton(0.0), compliance: None };
        World {
            gravity: [0.0; 2],
            duration,
            step: None,
            margin: Some(0.05),
            directions: 2,
            bodies: vec![body],
            fixed: self.fixels.iter().map(fixel).collect(),
            materials: vec![material; 4],
        }
    }
}
