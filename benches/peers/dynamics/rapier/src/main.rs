//! Runs the scenes in Rapier (f64): `rapier-driver SCENES.json NAME…`
//!
//! One line of JSON a run: peer, scene, step, number of steps, CPU time of the steps (s), last poses and velocities,
//! and for the scenes that need it the way of the first body, as `compare.py` reads them.

mod plane;
mod space;

use cpu_time::ThreadTime;
use serde_json::{Value, json};

/// Settings of the rows of the comparison: as they are, and those that resting parts want.
#[derive(Clone, Copy)]
pub enum Setting {
    /// Four iterations, springs of 30 and 60 Hz as contacts, contacts kept while bodies move less than 5 cm.
    Default,
    /// Twenty iterations, springs of 10 kHz, friction in every pass, no contact kept.
    Tuned,
}

const STEPS: [f64; 8] = [5e-2, 2e-2, 1e-2, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4];

/// A scene, ready to be stepped.
pub trait Run {
    fn step(&mut self);
    /// Poses and velocities of all bodies.
    fn state(&self) -> (Vec<[f64; 3]>, Vec<[f64; 3]>);
}

fn main() {
    let mut arguments = std::env::args().skip(1);
    let path = arguments.next().expect("SCENES.json NAME…");
    let names: Vec<String> = arguments.collect();
    let all: Value = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    let wanted = |scene: &&Value| names.iter().any(|name| scene["name"] == name.as_str());
    for scene in all["scenes"].as_array().unwrap().iter().filter(wanted) {
        for (name, setting, h) in settings() {
            if scene["dim"] == "3d" {
                measure(&format!("Rapier3D {name}"), scene, h, || space::World::new(scene, setting, h));
            } else {
                measure(&format!("Rapier2D {name}"), scene, h, || plane::World::new(scene, setting, h));
            }
        }
    }
}

fn settings() -> impl Iterator<Item = (&'static str, Setting, f64)> {
    let settings = [("default", Setting::Default), ("tuned", Setting::Tuned)];
    settings.into_iter().flat_map(|(name, setting)| STEPS.map(|h| (name, setting, h)))
}

fn measure<R: Run>(peer: &str, scene: &Value, h: f64, build: impl Fn() -> R) {
    let steps = (number(&scene["T"]) / h).round() as usize;
    if (steps as f64 * h - number(&scene["T"])).abs() > 1e-9 {
        return; // no shorter last step
    }
    let mut world = build();
    let mut way = Vec::new();
    for _ in 0..steps {
        world.step();
        let (poses, velocities) = world.state();
        way.push(json!([poses[0][1], poses[0][2], velocities[0][2]]));
    }
    let (poses, velocities) = world.state();
    let traced = scene["name"] == "rocking_block" || scene["name"] == "popout_1mm";
    println!(
        "{}",
        json!({
            "peer": peer, "scene": scene["name"], "h": h, "steps": steps,
            "cpu": fastest(|| timed(build(), steps)), "poses": poses, "velocities": velocities,
            "way": if traced { way } else { Vec::new() },
        })
    );
}

fn timed(mut world: impl Run, steps: usize) -> f64 {
    let start = ThreadTime::now();
    for _ in 0..steps {
        world.step();
    }
    start.elapsed().as_secs_f64()
}

/// The run that others on the machine disturb least, of so many that they take a few hundredths of a second; one is
/// enough if it is long.
fn fastest(run: impl Fn() -> f64) -> f64 {
    let (mut times, mut total) = (Vec::new(), 0.0);
    while (times.len() < 5 || total < 0.03) && times.len() < 100 && total < 0.2 {
        times.push(run());
        total += times[times.len() - 1];
    }
    times.into_iter().fold(f64::INFINITY, f64::min)
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

fn numbers(value: &Value) -> [f64; 3] {
    [0, 1, 2].map(|i| number(&value[i]))
}
