//! The recommended push, pull or wrench as an arrow.

use super::canvas::{At, RED};
use super::legend::Swatch;
use super::scene::Scene;
use super::view::{self, Outline, direction};
use crate::answer::{Action, Recommendation};
use crate::report::decimal;
use num_traits::Zero as _;

const LENGTH: f64 = 62.0;
const WIDTH: f64 = 3.0;

/// Draws what `plan` recommends.
pub(super) fn draw(scene: &mut Scene, plan: &Recommendation) {
    match &plan.action {
        Action::PushEdge { point, direction: inward, .. } => {
            let tip = scene.view.at(point);
            arrow(scene, tip.along(direction(inward), -LENGTH), tip);
            scene.legend.add(Swatch::Push, "recommended push");
        }
        Action::PushArc { direction, .. } => {
            if let Outline::Circle { center, radius } = scene.view.outline {
                let outward = At::unit(decimal::angle(direction).to_radians());
                let tip = center.along(outward, radius);
                arrow(scene, tip.along(outward, LENGTH), tip);
            }
            scene.legend.add(Swatch::Push, "recommended push");
        }
        Action::Tilt { direction, .. } => {
            let toward = At::unit(decimal::angle(direction).to_radians());
            arrow(scene, scene.com, scene.com.along(toward, 1.25 * LENGTH));
            scene.legend.add(Swatch::Push, "recommended pull of gravity");
        }
        Action::Wrench => wrench(scene, plan),
    }
}

fn arrow(scene: &mut Scene, tail: At, tip: At) {
    scene.canvas.arrow(tail, tip, RED, WIDTH);
    scene.labels.avoid(&view::along(tail, tip));
}

/// The force at the center of mass and the sense of the torque about it.
fn wrench(scene: &mut Scene, plan: &Recommendation) {
    use std::f64::consts::PI;
    let [fx, fy, torque] = &plan.wrench;
    let center = scene.com;
    if !torque.is_zero() {
        let (radius, turn) = (24.0, if torque > &num_traits::zero() { 1.0 } else { -1.0 });
        let angle = |share: f64| PI / 2.0 + turn * PI * share;
        let points: Vec<At> =
            (0..=30).map(|k| center.along(At::unit(angle(f64::from(k) / 20.0 - 0.75)), radius)).collect();
        scene.canvas.line(&points, super::canvas::Pen::stroke(RED, WIDTH));
        let along = points[30].minus(points[29]).normalized();
        scene.canvas.arrow(points[30].along(along, -3.0), points[30].along(along, 10.0), RED, WIDTH);
    }
    if !(fx.is_zero() && fy.is_zero()) {
        let toward = direction(&[fx.clone(), fy.clone()]);
        arrow(scene, center, center.along(toward, 1.25 * LENGTH));
    }
    scene.legend.add(Swatch::Push, "recommended wrench: force and torque together");
}
