//! The planar scenes on which other engines were measured, and how far a run is from their closed forms.

use partplan::answer::Simulation;
use partplan::model::{Body, Material, Obstacle, Planar, PlanarShape, Restitution, Spatial, SpatialShape, World};
use serde_json::Value;

/// A scene with a closed form.
pub struct Peer {
    pub name: String,
    pub world: World<Planar>,
    exact: Value,
}

/// Every scene that can be run in the plane: x stays, the height z becomes y.
pub fn scenes() -> Vec<Peer> {
    let all: Value = serde_json::from_str(include_str!("peer_scenes.json")).unwrap();
    let planar = list(&all["scenes"]).iter().filter(|scene| scene["dim"] == "both");
    planar
        .map(|scene| Peer { name: text(&scene["name"]), world: world(scene), exact: scene["exact"].clone() })
        .collect()
}

impl Peer {
    /// The error that the study measures: relative to the natural scale of the scene.
    pub fn error(&self, run: &Simulation<Planar>) -> f64 {
        let (poses, velocities) = (&run.last.poses, &run.last.velocities);
        let exact = |key: &str| number(&self.exact[key]);
        let velocity_error = |branch: &str| {
            let wanted = numbers::<3>(&self.exact[branch]);
            velocities[0].iter().zip(wanted).map(|(found, wanted)| (found - wanted).powi(2)).sum::<f64>().sqrt()
        };
        let drift = |body: usize, [x, y]: [f64; 2]| (poses[body][0] - x).abs().max((poses[body][1] - y).abs()) / 0.1;
        match self.name.as_str() {
            "slide_stop" | "incline_slip" => (poses[0][0] - exact("x_final")).abs() / exact("x_final"),
            "incline_stick" => poses[0][0].abs() / 0.1,
            "bounce_e08" => (poses[0][1] - exact("z_T")).abs() / 0.15,
            "backspin_57" => (poses[0][0] - exact("x_T")).abs(),
            "rocking_block" => (second_swing(run) - exact("theta_next_apex")).abs() / exact("theta_next_apex"),
            "peg_drop_mu0" | "peg_drop_mu0.2" | "peg_drop_mu1" => (poses[0][0] - exact("x_T")).abs() / 0.1,
            "painleve_inconsistent" => velocity_error("v_after_jam"),
            "painleve_indeterminate" => velocity_error("v_after_jam").min(velocity_error("detach_v")),
            "vgroove_mu0.5" | "vgroove_mu1.2" => drift(0, [0.0, exact("z_T")]),
            "stack4" | "mass_ratio_100" | "mass_ratio_1000" => {
                let heights = list(&self.exact["z"]).iter().enumerate();
                heights.map(|(body, z)| drift(body, [0.0, number(z)])).fold(0.0, f64::max)
            }
            "flat_landing" => drift(0, [0.0, exact("z_T")]).max(poses[0][2].abs()),
            "cradle3" => {
                let found = velocities.iter().map(|velocity| velocity[0]);
                let wanted = numbers::<3>(&self.exact["v_simultaneous_newton"]);
                found.zip(wanted).map(|(found, wanted)| (found - wanted).abs()).fold(0.0, f64::max)
            }
            "popout_1mm" => {
                let highest = run.frames.iter().map(|frame| frame.poses[0][1]).fold(0.0, f64::max);
                (highest - 0.05).max(0.0) / 0.1
            }
            other => panic!("no measure for {other}"),
        }
    }
}

/// The one scene in space: the sphere of Fig. 3 with Newton's restitution.
pub fn sphere() -> World<Spatial> {
    let all: Value = serde_json::from_str(include_str!("peer_scenes.json")).unwrap();
    let scene = list(&all["scenes"]).iter().find(|scene| scene["name"] == "seed_sphere").unwrap();
    let (body, [x, y, z]) = (&scene["bodies"][0], numbers::<3>(&scene["bodies"][0]["pos"]));
    let (v, w) = (numbers::<3>(&body["vel"]), numbers::<3>(&body["om"]));
    World {
        gravity: numbers(&scene["gravity"]),
        duration: number(&scene["T"]),
        step: None,
        margin: None,
        directions: 16,
        bodies: vec![Body {
            name: "sphere".into(),
            shape: SpatialShape::Sphere { center: [0.0; 3], radius: number(&body["r"]) },
            mass: number(&body["mass"]),
            inertia: numbers(&body["I"]),
            pose: [x, y, z, 1.0, 0.0, 0.0, 0.0],
            velocity: [v[0], v[1], v[2], w[0], w[1], w[2]],
            is_kinematic: false,
            schedule: Vec::new(),
            finger: None,
        }],
        fixed: vec![Obstacle {
            name: "plane".into(),
            shape: SpatialShape::HalfSpace { point: [0.0; 3], normal: [0.0, 0.0, 1.0] },
            surface_velocity: [0.0; 2],
        }],
        materials: vec![material(scene); 2],
    }
}

/// Distance of the sphere from where it must be (m).
pub fn sphere_error(run: &Simulation<Spatial>) -> f64 {
    let (x, y) = (run.last.poses[0][0] - 0.764_076_179_936_853_2, run.last.poses[0][1] + 0.471_847_640_126_293_8);
    (x * x + y * y).sqrt()
}

fn material(scene: &Value) -> Material {
    Material { friction: number(&scene["mu"]), restitution: Restitution::Newton(number(&scene["e"])), compliance: None }
}

/// Largest angle between the second and the third time that the block stands upright.
fn second_swing(run: &Simulation<Planar>) -> f64 {
    let angles: Vec<f64> = run.frames.iter().map(|frame| frame.poses[0][2]).collect();
    let upright = angles.windows(2).position(|pair| pair[0] > 0.0 && pair[1] <= 0.0).unwrap_or(angles.len());
    let until = angles[upright.min(angles.len())..].windows(2).position(|pair| pair[0] < 0.0 && pair[1] >= 0.0);
    let swing = &run.frames[upright.min(angles.len())..until.map_or(angles.len(), |until| upright + until + 1)];
    // the angle where the spin changes its sign, by a cubic through the two frames around it
    let top = swing.windows(2).find(|pair| pair[0].velocities[0][2] < 0.0 && pair[1].velocities[0][2] >= 0.0);
    let Some([a, b]) = top else {
        return 0.0;
    };
    let (h, [wa, wb]) = (b.time - a.time, [a, b].map(|frame| frame.velocities[0][2]));
    let s = wa / (wa - wb);
    let at = |frame: &partplan::answer::Frame<Planar>| frame.poses[0][2];
    (at(a) + h * s * (wa + 0.5 * s * (wb - wa))).abs()
}

fn world(scene: &Value) -> World<Planar> {
    let bodies: Vec<Body<Planar>> =
        list(&scene["bodies"]).iter().enumerate().map(|(i, body)| planar_body(i, body)).collect();
    let fixed: Vec<Obstacle<Planar>> = list(&scene["planes"])
        .iter()
        .map(|plane| Obstacle {
            name: "plane".into(),
            shape: PlanarShape::HalfPlane { point: upright(&plane["point"]), normal: upright(&plane["normal"]) },
            surface_velocity: [0.0; 2],
        })
        .collect();
    World {
        gravity: if scene["name"] == "cradle3" { [0.0; 2] } else { upright(&scene["gravity"]) },
        duration: number(&scene["T"]),
        step: None,
        margin: None,
        directions: 2,
        materials: vec![material(scene); bodies.len() * (bodies.len() + fixed.len())],
        bodies,
        fixed,
    }
}

fn planar_body(index: usize, body: &Value) -> Body<Planar> {
    let (position, velocity) = (upright(&body["pos"]), upright(&body["vel"]));
    let disc = |x: f64, radius: f64| PlanarShape::Circle { center: [x, 0.0], radius };
    let shape = match body["shape"].as_str().unwrap() {
        "box" => {
            let [a, b] = upright(&body["half"]);
            PlanarShape::Polygon(vec![[-a, -b], [a, -b], [a, b], [-a, b]])
        }
        "sphere" => disc(0.0, number(&body["r"])),
        "rod" => {
            let (half, tip) = (number(&body["half"]), number(&body["rho"]));
            PlanarShape::Compound(vec![disc(-half, tip), disc(half, tip)])
        }
        other => panic!("no shape {other}"),
    };
    Body {
        name: format!("body {index}"),
        shape,
        mass: number(&body["mass"]),
        inertia: [number(&body["I"][1])],
        pose: [position[0], position[1], number(&body["th"])],
        velocity: [velocity[0], velocity[1], number(&body["om_planar"])],
        is_kinematic: false,
        schedule: Vec::new(),
        finger: None,
    }
}

/// The x and z of a triple.
fn upright(value: &Value) -> [f64; 2] {
    let [x, _, z] = numbers::<3>(value);
    [x, z]
}

fn text(value: &Value) -> String {
    value.as_str().unwrap().to_string()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("not a number: {value}"))
}

fn list(value: &Value) -> &[Value] {
    value.as_array().map_or(&[], Vec::as_slice)
}

fn numbers<const N: usize>(value: &Value) -> [f64; N] {
    let all: Vec<f64> = list(value).iter().map(number).collect();
    all.try_into().unwrap_or_else(|_| panic!("not {N} numbers: {value}"))
}
