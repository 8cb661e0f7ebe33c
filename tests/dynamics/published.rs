//! The published scenes and what is expected of them.

use partplan::answer::{ContactName, Event, Simulation, SolverStatistics};
use partplan::dynamics::{Mechanics, ModelKind, Options, simulate};
use partplan::model::{
    Body, Compliance, Material, Obstacle, Planar, PlanarShape, Restitution, Scene, Spatial, SpatialShape, World,
};
use serde_json::Value;

/// A published scene.
pub struct Published {
    pub name: String,
    pub model: ModelKind,
    pub scene: Scene,
}

/// Every published scene.
pub fn scenes() -> Vec<Published> {
    let all: Vec<Value> = serde_json::from_str(include_str!("scenes.json")).unwrap();
    all.iter().map(published).collect()
}

/// The scene of this name.
pub fn scene(name: &str) -> Published {
    scenes().into_iter().find(|scene| scene.name == name).unwrap_or_else(|| panic!("no scene {name}"))
}

/// What is expected, by name.
pub fn expected() -> Value {
    serde_json::from_str(include_str!("expected.json")).unwrap()
}

impl Published {
    /// Final poses and velocities, body after body, after `steps` of `h`.
    pub fn run(&self, h: f64, steps: usize) -> Outcome {
        let options = Options { model: self.model, step: Some(h), ..Options::default() };
        match &self.scene {
            Scene::Planar(world) => outcome(world, &options, h * steps as f64),
            Scene::Spatial(world) => outcome(world, &options, h * steps as f64),
        }
    }
}

/// The end of a run.
#[derive(Debug)]
pub struct Outcome {
    pub q: Vec<f64>,
    pub v: Vec<f64>,
    pub status: partplan::answer::Status,
    pub steps: usize,
    pub gain: f64,
    pub residual: f64,
    /// Everything else of the run.
    pub deltas: Vec<(ContactName, [f64; 3])>,
    pub events: Vec<Event>,
    pub notes: Vec<String>,
    pub solver: SolverStatistics,
}

fn outcome<S: Mechanics>(world: &World<S>, options: &Options, duration: f64) -> Outcome {
    let world = World { duration, ..world.clone() };
    let run: Simulation<S> = simulate(&world, options, &mut |_| true).unwrap();
    Outcome {
        q: run.last.poses.iter().flat_map(|pose| pose.as_ref().iter().copied()).collect(),
        v: run.last.velocities.iter().flat_map(|velocity| velocity.as_ref().iter().copied()).collect(),
        status: run.status,
        steps: run.solver.steps,
        gain: run.energy.largest_gain,
        residual: run.solver.residual,
        deltas: run.deformations,
        events: run.events,
        notes: run.notes,
        solver: run.solver,
    }
}

fn published(value: &Value) -> Published {
    let model = if value["model"] == "spk" { ModelKind::SongPangKumar } else { ModelKind::StewartTrinkle };
    let material = Material {
        friction: number(&value["friction"]),
        restitution: Restitution::Newton(0.0),
        compliance: value.get("contact").map(|contact| Compliance {
            stiffness: [number(&contact["K"]); 2],
            damping: [number(&contact["C"]); 2],
            gamma: number(&contact["gamma"]),
        }),
    };
    let scene = if value.get("sphere").is_some() {
        Scene::Spatial(spatial(value, material))
    } else {
        Scene::Planar(planar(value, material))
    };
    Published { name: value["name"].as_str().unwrap().to_string(), model, scene }
}

fn planar(value: &Value, material: Material) -> World<Planar> {
    let bodies: Vec<Body<Planar>> =
        list(&value["bodies"]).iter().enumerate().map(|(i, body)| planar_body(i, body)).collect();
    let fixed: Vec<Obstacle<Planar>> = list(&value["fixed"])
        .iter()
        .enumerate()
        .map(|(i, shape)| Obstacle {
            name: format!("fixed {i}"),
            shape: planar_shape(shape),
            surface_velocity: [0.0; 2],
        })
        .collect();
    World {
        gravity: value.get("gravity").map_or([0.0, -9.81], numbers),
        duration: 1.0,
        step: None,
        margin: value.get("margin").map(number),
        directions: 2,
        materials: vec![material; bodies.len() * (bodies.len() + fixed.len())],
        bodies,
        fixed,
    }
}

fn planar_body(index: usize, body: &Value) -> Body<Planar> {
    Body {
        name: format!("body {index}"),
        shape: planar_shape(&body["shape"]),
        mass: number(&body["mass"]),
        inertia: [number(&body["inertia"])],
        pose: numbers(&body["q"]),
        velocity: numbers(&body["v"]),
        is_kinematic: false,
        schedule: Vec::new(),
        finger: None,
    }
}

fn planar_shape(shape: &Value) -> PlanarShape {
    if let Some(vertices) = shape.get("polygon") {
        return PlanarShape::Polygon(list(vertices).iter().map(numbers).collect());
    }
    if let Some(circle) = shape.get("circle") {
        return PlanarShape::Circle { center: numbers(&circle["center"]), radius: number(&circle["radius"]) };
    }
    let plane = &shape["halfplane"];
    PlanarShape::HalfPlane { point: numbers(&plane["point"]), normal: numbers(&plane["normal"]) }
}

fn spatial(value: &Value, material: Material) -> World<Spatial> {
    let sphere = &value["sphere"];
    let (radius, mass) = (number(&sphere["radius"]), number(&sphere["mass"]));
    let [x, y, z]: [f64; 3] = numbers(&sphere["position"]);
    let v: [f64; 3] = numbers(&sphere["velocity"]);
    let omega: [f64; 3] = sphere.get("omega").map_or([0.0; 3], numbers);
    let fixed: Vec<Obstacle<Spatial>> = list(&value["planes"])
        .iter()
        .map(|plane| Obstacle {
            name: "plane".into(),
            shape: SpatialShape::HalfSpace { point: numbers(&plane["point"]), normal: numbers(&plane["normal"]) },
            surface_velocity: [0.0; 2],
        })
        .collect();
    World {
        gravity: value.get("gravity").map_or([0.0, 0.0, -9.81], numbers),
        duration: 1.0,
        step: None,
        margin: value.get("margin").map(number),
        directions: value.get("nl").map_or(16, |n| usize::try_from(n.as_u64().unwrap()).unwrap()),
        materials: vec![material; 1 + fixed.len()],
        bodies: vec![Body {
            name: "sphere".into(),
            shape: SpatialShape::Sphere { center: [0.0; 3], radius },
            mass,
            inertia: [0.4 * mass * radius * radius; 3],
            pose: [x, y, z, 1.0, 0.0, 0.0, 0.0],
            velocity: [v[0], v[1], v[2], omega[0], omega[1], omega[2]],
            is_kinematic: false,
            schedule: Vec::new(),
            finger: None,
        }],
        fixed,
    }
}

pub fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("not a number: {value}"))
}

pub fn list(value: &Value) -> &[Value] {
    value.as_array().map_or(&[], Vec::as_slice)
}

fn numbers<const N: usize>(value: &Value) -> [f64; N] {
    let all: Vec<f64> = list(value).iter().map(number).collect();
    all.try_into().unwrap_or_else(|_| panic!("not {N} numbers: {value}"))
}
