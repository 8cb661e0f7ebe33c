//! Fixels outside the part, their friction cones inside it.

use super::super::Subject;
use super::canvas::{At, INK, MUTED, ORANGE, Pen};
use super::legend::Swatch;
use super::scene::Scene;
use super::view::{self, direction};
use crate::exact::{Q, to_f64};
use crate::model::Fixel;

const HEIGHT: f64 = 20.0;
const HALF_BASE: f64 = 6.5;
const CONE: f64 = 50.0;

/// Draws friction cones, then the outline over them.
pub(super) fn draw_cones(scene: &mut Scene, subject: &Subject) {
    for fixel in &subject.fixture.fixels {
        cone(scene, fixel);
    }
    scene.outline();
}

/// Draws the fixels, above finger places that they interrupt.
pub(super) fn draw_fixels(scene: &mut Scene, subject: &Subject) {
    for (number, fixel) in subject.fixture.fixels.iter().enumerate() {
        body(scene, number, fixel);
    }
    scene.legend.add(Swatch::Fixel, "fixel, numbered");
    let ranges = subject.fixture.fixels.iter().any(|fixel| fixel.friction.static_.min != fixel.friction.static_.max);
    if ranges {
        scene.legend.add(Swatch::FrictionRange, "friction cone, least and largest");
    } else {
        scene.legend.add(Swatch::Friction, "friction cone");
    }
}

fn cone(scene: &mut Scene, fixel: &Fixel) {
    let (tip, normal) = (scene.view.at(&fixel.point), direction(&fixel.normal));
    let friction = &fixel.friction.static_;
    let middle = (-normal.y).atan2(normal.x);
    let mut sector = |coefficient: &Q, opacity: f64| {
        let half = to_f64(coefficient).atan();
        scene.canvas.arc(tip, CONE, middle - half, 2.0 * half, true, Pen::fill(ORANGE, opacity));
    };
    if friction.min != friction.max {
        sector(&friction.max, 0.25);
    }
    sector(&friction.min, 0.45);
    scene.canvas.line(&[tip, tip.along(normal, CONE)], Pen::stroke(MUTED, 0.8).dashed());
}

fn body(scene: &mut Scene, number: usize, fixel: &Fixel) {
    let (tip, normal) = (scene.view.at(&fixel.point), direction(&fixel.normal));
    let base = tip.along(normal, -HEIGHT);
    let side = normal.turned();
    let corners = [tip, base.along(side, HALF_BASE), base.along(side, -HALF_BASE)];
    scene.canvas.polygon(&corners, Pen::fill(INK, 1.0).outlined(INK, 1.0));
    for pair in [[0, 1], [1, 2], [2, 0]] {
        scene.labels.avoid(&view::along(corners[pair[0]], corners[pair[1]]));
    }
    let outward = At::new(-normal.x, -normal.y);
    scene.labels.want(base, outward, 9.0, INK, true, number.to_string());
}
