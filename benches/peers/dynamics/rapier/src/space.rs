//! The sphere in space: its pose is its place, its velocity that of its centre.

use crate::{Run, Setting, number, numbers};
use rapier3d_f64::pipeline::PhysicsWorld;
use rapier3d_f64::prelude::*;
use serde_json::Value;

pub struct World {
    world: PhysicsWorld,
    sphere: RigidBodyHandle,
}

impl World {
    pub fn new(scene: &Value, setting: Setting, h: f64) -> Self {
        let body = &scene["bodies"][0];
        let mut world = PhysicsWorld::new();
        world.gravity = vector(&scene["gravity"]);
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
        let surface =
            |shape: ColliderBuilder| shape.friction(number(&scene["mu"])).restitution(number(&scene["e"])).density(0.0);
        world.colliders.insert(surface(ColliderBuilder::new(SharedShape::halfspace(Vector::Z))));
        let inertia = MassProperties::new(Vector::ZERO, number(&body["mass"]), vector(&body["I"]));
        let sphere = world.bodies.insert(
            RigidBodyBuilder::dynamic()
                .translation(vector(&body["pos"]))
                .linvel(vector(&body["vel"]))
                .angvel(vector(&body["om"]))
                .additional_mass_properties(inertia)
                .can_sleep(false),
        );
        let ball = surface(ColliderBuilder::ball(number(&body["r"])));
        world.colliders.insert_with_parent(ball, sphere, &mut world.bodies);
        Self { world, sphere }
    }
}

impl Run for World {
    fn step(&mut self) {
        self.world.step();
    }

    fn state(&self) -> (Vec<[f64; 3]>, Vec<[f64; 3]>) {
        let body = &self.world.bodies[self.sphere];
        (vec![body.translation().into()], vec![body.linvel().into()])
    }
}

fn vector(value: &Value) -> Vector {
    numbers(value).into()
}
