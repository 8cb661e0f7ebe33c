//! Scenes as case files write them.

use crate::model::{Body, Compliance, Finger, Material, Obstacle, Planar, PlanarShape, Restitution, World};
use serde_json::{Map, Value, json};

/// A case file that reads back as this scene, to the last digit.
#[must_use]
pub fn scene(name: &str, world: &World<Planar>) -> Value {
    let mut scene = Map::new();
    let mut insert = |key: &str, value: Value| scene.insert(key.to_owned(), value);
    insert("gravity", json!(world.gravity));
    insert("duration", json!(world.duration));
    if let Some(step) = world.step {
        insert("step", json!(step));
    }
    if let Some(margin) = world.margin {
        insert("margin", json!(margin));
    }
    insert("bodies", world.bodies.iter().map(body).collect());
    insert("fixed", world.fixed.iter().map(obstacle).collect());
    insert("pairs", pairs(world));
    json!({ "name": name, "scene": scene })
}

fn body(body: &Body<Planar>) -> Value {
    let mut fields = Map::new();
    let mut insert = |key: &str, value: Value| fields.insert(key.to_owned(), value);
    insert("name", json!(body.name));
    insert("shape", shape(&body.shape));
    insert("mass", json!(body.mass));
    insert("inertia", json!(body.inertia[0]));
    insert("pose", json!(body.pose));
    let (key, value) = if body.is_kinematic { ("motion", "velocity") } else { ("wrench", "wrench") };
    if body.is_kinematic {
        insert("kinematic", json!(true));
    } else {
        insert("velocity", json!(body.velocity));
    }
    if !body.schedule.is_empty() {
        let entry = |timed: &crate::model::Timed<Planar>| json!({ "from": timed.time, value: timed.value });
        insert(key, body.schedule.iter().map(entry).collect());
    } else if body.is_kinematic {
        insert("velocity", json!(body.velocity));
    }
    if let Some(Finger { edge, at, direction, force }) = body.finger {
        let mut finger = json!({ "at": at, "direction": direction, "force": force });
        if let Some(edge) = edge {
            finger["edge"] = json!(edge);
        }
        insert("finger", finger);
    }
    fields.into()
}

fn obstacle(obstacle: &Obstacle<Planar>) -> Value {
    json!({
        "name": obstacle.name,
        "shape": shape(&obstacle.shape),
        "surface_velocity": obstacle.surface_velocity[0],
    })
}

fn shape(shape: &PlanarShape) -> Value {
    match shape {
        PlanarShape::Polygon(vertices) => json!({ "polygon": vertices }),
        PlanarShape::Circle { center, radius: 0.0 } => json!({ "point": center }),
        PlanarShape::Circle { center, radius } => json!({ "circle": { "center": center, "radius": radius } }),
        PlanarShape::HalfPlane { point, normal } => json!({ "half_plane": { "point": point, "normal": normal } }),
        PlanarShape::Compound(pieces) => json!({ "compound": pieces.iter().map(self::shape).collect::<Value>() }),
    }
}

/// What happens between every two that can touch and move.
fn pairs(world: &World<Planar>) -> Value {
    let names: Vec<&String> =
        world.bodies.iter().map(|body| &body.name).chain(world.fixed.iter().map(|fixed| &fixed.name)).collect();
    let is_held = |at: usize| world.bodies.get(at).is_none_or(|body| body.is_kinematic);
    let mut list = Vec::new();
    for a in 0..world.bodies.len() {
        for b in (a + 1..names.len()).filter(|b| !(is_held(a) && is_held(*b))) {
            let Material { friction, restitution, compliance } = *world.material(a, b);
            let mut pair = json!({ "between": [names[a], names[b]], "friction": friction });
            if restitution.coefficient() > 0.0 {
                pair["restitution"] = match restitution {
                    Restitution::Newton(e) => json!({ "newton": e }),
                    Restitution::Poisson(e) => json!({ "poisson": e }),
                };
            }
            if let Some(Compliance { stiffness, damping, gamma }) = compliance {
                pair["contact"] = json!({ "stiffness": stiffness, "damping": damping, "gamma": gamma });
            }
            list.push(pair);
        }
    }
    list.into()
}
