//! The scenes in the plane: x stays, the height z becomes y.

use crate::{Run, Setting, number, numbers};
use rapier2d_f64::pipeline::PhysicsWorld;
use rapier2d_f64::prelude::*;
use serde_json::Value;

pub struct World {
    world: PhysicsWorld,
    bodies: Vec<RigidBodyHandle>,
}

impl World {
    pub fn new(scene: &Value, setting: Setting, h: f64) -> Self {
        let mut world = PhysicsWorld::new();
        world.gravity = upright(&scene["gravity"]);
        world.integration_parameters.dt = h;
        if let Setting::Tuned = setting {
            let contact = SpringCoefficients::new(1e4, 1.0);
            let parameters = &mut world.integration_parameters;
            parameters.num_solver_iterations = 20;
            parameters.contact_softness = contact;
            parameters.static_contact_softness = contact;
            parameters.friction_in_bias_pass = true;
            parameters.contact_recycling = false;
        }
        let surface = |shape: ColliderBuilder| {
            // of both surfaces of a contact the mean counts
            shape.friction(number(&scene["mu"])).restitution(number(&scene["e"])).density(0.0)
        };
        for plane in scene["planes"].as_array().unwrap() {
            let normal = upright(&plane["normal"]).normalize();
            world.colliders.insert(
                surface(ColliderBuilder::new(SharedShape::halfspace(normal))).translation(upright(&plane["point"])),
            );
        }
        let mut bodies = Vec::new();
        for body in scene["bodies"].as_array().unwrap() {
            let inertia = MassProperties::new(Vector::ZERO, number(&body["mass"]), number(&body["I"][1]));
            let handle = world.bodies.insert(
                RigidBodyBuilder::dynamic()
                    .translation(upright(&body["pos"]))
                    .rotation(number(&body["th"]))
                    .linvel(upright(&body["vel"]))
                    .angvel(number(&body["om_planar"]))
                    .additional_mass_properties(inertia)
                    .can_sleep(false),
            );
            for shape in shapes(body) {
                world.colliders.insert_with_parent(surface(shape), handle, &mut world.bodies);
            }
            bodies.push(handle);
        }
        Self { world, bodies }
    }
}

impl Run for World {
    fn step(&mut self) {
        self.world.step();
    }

    fn state(&self) -> (Vec<[f64; 3]>, Vec<[f64; 3]>) {
        let bodies = self.bodies.iter().map(|&handle| &self.world.bodies[handle]);
        bodies
            .map(|body| {
                let (place, velocity) = (body.translation(), body.linvel());
                ([place.x, place.y, body.rotation().angle()], [velocity.x, velocity.y, body.angvel()])
            })
            .unzip()
    }
}

fn shapes(body: &Value) -> Vec<ColliderBuilder> {
    match body["shape"].as_str().unwrap() {
        "box" => {
            let half = upright(&body["half"]);
            vec![ColliderBuilder::cuboid(half.x, half.y)]
        }
        "sphere" => vec![ColliderBuilder::ball(number(&body["r"]))],
        "rod" => {
            let end = |x| ColliderBuilder::ball(number(&body["rho"])).translation(Vector::new(x, 0.0));
            vec![end(-number(&body["half"])), end(number(&body["half"]))]
        }
        other => panic!("no shape {other}"),
    }
}

fn upright(value: &Value) -> Vector {
    let [x, _, z] = numbers(value);
    Vector::new(x, z)
}
