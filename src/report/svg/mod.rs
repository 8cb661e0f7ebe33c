//! Drawings: the part, its fixels and their friction, where to push, how to tilt; pins over a conveyor.

mod canvas;
mod chart;
mod contact;
mod finger;
mod label;
mod legend;
mod pins;
mod plan;
mod scene;
mod simulation;
mod suggest;
mod throw;
mod tilt;
mod view;

pub(super) use canvas::At;
pub(super) use simulation::within;

pub use chart::{chart, failures};
pub use pins::pins;
pub use simulation::{feeder, simulation};
pub use suggest::suggestion;
pub use throw::throw;

use super::{Subject, phrase};
use crate::answer::{Insertion, Stability};
use canvas::{BLUE, GREEN, PINK};
use finger::Band;
use scene::Scene;

/// The drawing of `plan insert`: finger places, the recommended push, tilt directions.
#[must_use]
pub fn insertion(subject: &Subject, answer: &Insertion) -> String {
    let mut scene = Scene::new(subject);
    tilt::draw(&mut scene, &answer.acyclic_tilt, "tilts that seat the part");
    contact::draw_cones(&mut scene, subject);
    let band =
        Band { fingers: &answer.acyclic_fingers, colour: GREEN, meaning: "a finger here seats the part", lane: 0 };
    finger::draw(&mut scene, &[band]);
    contact::draw_fixels(&mut scene, subject);
    if let Some(plan) = &answer.plan {
        plan::draw(&mut scene, plan);
    }
    scene.finish(subject.name, &phrase::insertion(subject, answer))
}

/// The drawing of `plan stable`: where a finger closes the grasp, may hold the part, is certain to hold it.
#[must_use]
pub fn stability(subject: &Subject, answer: &Stability) -> String {
    let mut scene = Scene::new(subject);
    tilt::draw(&mut scene, &answer.strong_tilt, "tilts certain to hold the part");
    contact::draw_cones(&mut scene, subject);
    let bands = [
        Band {
            fingers: &answer.strong_fingers,
            colour: GREEN,
            meaning: "a finger here is certain to hold it",
            lane: 0,
        },
        Band { fingers: &answer.weak_fingers, colour: PINK, meaning: "the fixels can balance a finger here", lane: 1 },
        Band { fingers: &answer.closure_fingers, colour: BLUE, meaning: "a finger here closes the grasp", lane: 2 },
    ];
    finger::draw(&mut scene, &bands);
    contact::draw_fixels(&mut scene, subject);
    scene.finish(subject.name, &phrase::stability(answer))
}

#[cfg(test)]
mod tests;
