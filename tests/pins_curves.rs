//! The curves of the toppling graph against corners turned by doubles and moments of forces.

mod support;

use partplan::answer::{CurveKind, Orientation};
use partplan::exact::{Q, to_f64};
use partplan::planner::{PinQuestion, pins};
use support::conveyed::{self, Public};

/// A published case, turned by doubles.
struct Case {
    name: &'static str,
    hull: Vec<[f64; 2]>,
    com: [f64; 2],
    /// Belt and pin.
    friction: [f64; 2],
    orientations: Vec<Orientation>,
}

fn cases() -> impl Iterator<Item = Case> {
    conveyed::all().map(case)
}

fn case(Public { name, part, conveyor, .. }: Public) -> Case {
    let answer = pins(&part, &conveyor, &PinQuestion { curves: true, ..PinQuestion::default() }).unwrap();
    let near = |point: &[Q; 2]| point.each_ref().map(to_f64);
    Case {
        name,
        hull: answer.hull.iter().map(near).collect(),
        com: near(&part.center_of_mass),
        friction: [&conveyor.belt_friction, &conveyor.pin_friction].map(|range| to_f64(&range.max)),
        orientations: answer.orientations,
    }
}

/// The corners and the center of mass after a turn, the pivot at the origin.
struct Turned {
    corners: Vec<[f64; 2]>,
    com: [f64; 2],
}

impl Case {
    fn turned(&self, edge: usize, degrees: f64) -> Turned {
        let n = self.hull.len();
        let (from, to) = (self.hull[edge], self.hull[(edge + 1) % n]);
        let (sin, cos) = (degrees.to_radians() - (to[1] - from[1]).atan2(to[0] - from[0])).sin_cos();
        let turn = |[x, y]: [f64; 2]| [x * cos - y * sin, x * sin + y * cos];
        let corners: Vec<[f64; 2]> = self.hull.iter().map(|corner| turn(*corner)).collect();
        let pivot = corners.iter().copied().min_by(|a, b| a[1].total_cmp(&b[1])).unwrap();
        let place = |[x, y]: [f64; 2]| [x - pivot[0], y - pivot[1]];
        Turned { corners: corners.into_iter().map(place).collect(), com: place(turn(self.com)) }
    }
}

impl Turned {
    /// Whether a pin at `height` on an edge stops the part: moments of its force about the pivot and about the upper corner
    /// of the triangle that belt friction spans under the center of mass.
    fn is_stopped(&self, edge: usize, height: f64, [belt, pin]: [f64; 2]) -> bool {
        let (from, to) = (self.corners[edge], self.corners[(edge + 1) % self.corners.len()]);
        let [x, y] = [to[0] - from[0], to[1] - from[1]];
        let length = x.hypot(y);
        let (along, inward) = ([x / length, y / length], [-y / length, x / length]);
        let place = from[0] + (height - from[1]) / along[1] * along[0];
        let is_right = place >= 0.0;
        let slip = if is_right { -pin } else { pin };
        let force = [inward[0] + slip * along[0], inward[1] + slip * along[1]];
        let about_pivot = place * force[1] - height * force[0];
        let about_upper = belt * about_pivot - self.com[0] * (belt * force[1] - force[0]);
        match self.com[0] > 0.0 {
            true => about_upper <= 0.0 || about_pivot <= 0.0,
            false => is_right && about_upper <= 0.0 && about_pivot <= 0.0,
        }
    }
}

/// Section IV-B: corners are on their curves, and whatever the turn, one curve is as high as the part: no corner that a
/// pin can touch is missing.
#[test]
fn corners_are_on_their_curves_and_the_highest_curve_is_the_height_of_the_part() {
    let mut checked = 0;
    for case in cases() {
        for orientation in &case.orientations {
            for step in 1..40 {
                let degrees = orientation.theta_1_deg * f64::from(step) / 40.0;
                let height = case.turned(orientation.edge, degrees).corners.iter().map(|c| c[1]).fold(0.0, f64::max);
                let vertices = orientation.curves.iter().filter(|curve| matches!(curve.kind, CurveKind::Vertex(_)));
                let reached = vertices.flat_map(|curve| curve.points.windows(2)).filter_map(|ends| {
                    let share = (degrees - ends[0][0]) / (ends[1][0] - ends[0][0]);
                    (0.0..=1.0).contains(&share).then(|| ends[0][1] + share * (ends[1][1] - ends[0][1]))
                });
                let highest = reached.fold(0.0, f64::max);
                // chords of arcs of a few degrees
                let close = (highest - height).abs() < 0.01 * height;
                assert!(close, "{}: edge {} at {degrees}: {highest} of {height}", case.name, orientation.edge);
            }
            for curve in &orientation.curves {
                for [degrees, height] in &curve.points {
                    let turned = case.turned(orientation.edge, *degrees);
                    let there = match curve.kind {
                        CurveKind::Vertex(corner) => turned.corners[corner][1],
                        CurveKind::Radius => turned.com[1],
                        CurveKind::Rolling(_) | CurveKind::Jamming(_) => continue,
                    };
                    assert!((height - there).abs() < 1e-6, "{}: {:?} at {degrees}", case.name, curve.kind);
                    checked += 1;
                }
            }
        }
    }
    assert!(checked > 1_000);
}

/// Sections IV-C and IV-D: just below H and J a pin stops the part, just above it does not.
#[test]
fn a_pin_stops_the_part_below_rolling_and_jamming_curves_and_not_above() {
    let mut checked = 0;
    for case in cases() {
        for orientation in &case.orientations {
            for curve in &orientation.curves {
                let (CurveKind::Rolling(edge) | CurveKind::Jamming(edge)) = curve.kind else { continue };
                for [degrees, height] in &curve.points {
                    let turned = case.turned(orientation.edge, *degrees);
                    let corners = [turned.corners[edge][1], turned.corners[(edge + 1) % case.hull.len()][1]];
                    let rolls = matches!(curve.kind, CurveKind::Rolling(_));
                    // nothing is just above or below a corner of the edge, and phases and pivots change in between
                    let is_flat = turned.corners.iter().filter(|corner| corner[1] < 1e-9).count() > 1;
                    let room = (height - corners[0]).min(corners[1] - height);
                    if room < 1e-5 || is_flat || (turned.com[0] > 0.0) != rolls {
                        continue;
                    }
                    let stopped = [-1e-6, 1e-6].map(|off| turned.is_stopped(edge, height + off, case.friction));
                    let at = format!("{}: edge {}, {:?} at {degrees}", case.name, orientation.edge, curve.kind);
                    assert_eq!(stopped, [true, false], "{at}");
                    checked += 1;
                }
            }
        }
    }
    assert!(checked > 500);
}
