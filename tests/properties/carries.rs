//! Accelerations of an arm that keep a grasp, by cones of wrenches, against the part on a moving arm in the time-stepper.

use crate::support::drawn::bodies;
use crate::support::random::runs;
use partplan::dynamics::{ModelKind, Options, observe};
use partplan::exact::{Q, ratio, to_f64};
use partplan::geometry::Polygon;
use partplan::mechanics::throwing::{Load, RestingEdge};
use partplan::model::{Body, Material, Planar, PlanarShape, Restitution, Timed, World};
use proptest::prelude::*;
use proptest::sample::Index;
use std::f64::consts::TAU;

/// Turn of the arm (rad), or fall over the size of the part, in a run, and its steps, which are also cut in four.
const SHORT: f64 = 0.004;
const STEPS: usize = 500;

/// Distance to the ends of the accelerations over what the arm's speed and gravity give the part.
const CLEAR: f64 = 0.1;

/// Motion that is as good as none, over that of an acceleration of [`CLEAR`] of what acts: levers make it less than one.
const LITTLE: f64 = 7e-4;

/// Where the arm is and how fast it turns.
#[derive(Debug, Clone)]
struct Arm {
    degrees: Q,
    rate: Q,
}

/// A part that an arm carries; lengths in metres.
#[derive(Debug, Clone)]
struct Carried {
    /// Corners about the center of mass.
    hull: Vec<[f64; 2]>,
    load: Load,
    edge: usize,
    arm: Arm,
    size: f64,
}

fn any_carried() -> impl Strategy<Value = Carried> {
    let numbers = (0..=6_i64, -4..=4_i64, 1..=8_i64, -36..=36_i64, -6..=6_i64);
    (bodies(), any::<Index>(), numbers).prop_map(|((outline, center), edge, (out, offset, friction, angle, rate))| {
        let polygon = Polygon::new(outline).expect("a simple polygon");
        let corners: Vec<[Q; 2]> = polygon.hull().iter().map(|k| polygon.vertices()[*k].clone()).collect();
        let corner = |[x, y]: &[Q; 2]| [to_f64(&(x - &center[0])), to_f64(&(y - &center[1]))];
        let hull: Vec<[f64; 2]> = corners.iter().map(corner).collect();
        let size = hull.iter().map(|[x, y]| x.hypot(*y)).fold(0.0, f64::max);
        let rational = |value: f64| Q::from_float(value).expect("a finite number");
        let rho2 = rational(size * size / 6.0);
        let edge = edge.index(corners.len());
        let load = Load {
            edge: RestingEdge::all(&corners, &center, &rho2).swap_remove(edge),
            radius: rational(size * (1.1 + 0.5 * out as f64)),
            offset: rational(0.25 * size * offset as f64),
            rho2,
            gravity: ratio(981, 100),
            friction: Some(ratio(friction, 5)),
        };
        let arm = Arm { degrees: ratio(5 * angle, 1), rate: rational(0.5 * rate as f64 * (9.81 / size).sqrt()) };
        Carried { hull, load, edge, arm, size }
    })
}

impl Carried {
    /// How far the part moves on the arm in a short while if steps are extrapolated to none, over what it would if it were
    /// off by [`CLEAR`] of what acts on it.
    fn moved(&self, acceleration: f64) -> f64 {
        let [rate, gravity] = [&self.arm.rate, &self.load.gravity].map(to_f64);
        let turn = (rate.abs() + acceleration.abs().sqrt()).max((gravity / self.size).sqrt());
        let duration = SHORT / turn;
        let [coarse, fine] = [STEPS, 4 * STEPS].map(|steps| self.moved_in(acceleration, duration, steps));
        let acts = gravity.max(self.size * (rate * rate).max(acceleration.abs()));
        (4.0 * fine - coarse) / 3.0 / (0.5 * CLEAR * acts * duration * duration)
    }

    /// How far the part has moved on the arm after a short while.
    fn moved_in(&self, acceleration: f64, duration: f64, steps: usize) -> f64 {
        let world = self.world(acceleration, duration, steps);
        let at_start = self.on_arm(&[world.bodies[0].pose, world.bodies[1].pose]);
        let options = Options { model: ModelKind::Moreau, frames: 2, ..Options::default() };
        let mut last = Vec::new();
        let ended = observe(&world, &options, &mut |moment| {
            last = moment.poses.to_vec();
            true
        });
        let end = ended.expect("a polygon and an arm").frames.pop().map_or(last, |frame| frame.poses);
        let now = self.on_arm(&[end[0], end[1]]);
        let off = [0, 1, 2].map(|i| now[i] - at_start[i]);
        off[0].hypot(off[1]) + self.size * off[2].abs()
    }

    /// Pose of the part in the frame of the arm.
    fn on_arm(&self, [part, arm]: &[[f64; 3]; 2]) -> [f64; 3] {
        let (sine, cosine) = arm[2].sin_cos();
        [cosine * part[0] + sine * part[1], cosine * part[1] - sine * part[0], part[2] - arm[2]]
    }

    fn world(&self, acceleration: f64, duration: f64, steps: usize) -> World<Planar> {
        let Self { hull, load, .. } = self;
        let [radius, offset, rho2, gravity] = [&load.radius, &load.offset, &load.rho2, &load.gravity].map(to_f64);
        let [angle, rate] = [to_f64(&self.arm.degrees).to_radians(), to_f64(&self.arm.rate)];
        let (sine, cosine) = angle.sin_cos();
        let [a, b] = [hull[self.edge], hull[(self.edge + 1) % hull.len()]];
        let down = (b[1] - a[1]).atan2(b[0] - a[0]);
        let up = offset + load.edge.d.to_f64();
        let place = [cosine * radius - sine * up, sine * radius + cosine * up];
        let h = duration / steps as f64;
        let still = |name: &str, shape, pose, velocity| Body {
            name: name.to_owned(),
            shape: PlanarShape::Polygon(shape),
            mass: 1.0,
            inertia: [rho2],
            pose,
            velocity,
            is_kinematic: false,
            schedule: Vec::new(),
            finger: None,
        };
        let turn = (angle - down) - TAU * ((angle - down) / TAU).round();
        let part = still("part", hull.clone(), [place[0], place[1], turn], [-rate * place[1], rate * place[0], rate]);
        let (low, far) = (offset - self.size, radius + 3.0 * self.size);
        let outline = vec![[-self.size, low], [far, low], [far, offset], [-self.size, offset]];
        // a step takes the velocity of its end
        let schedule = (0..steps).map(|step| Timed {
            time: (step as f64 - 0.5).max(0.0) * h,
            value: [0.0, 0.0, rate + acceleration * (step as f64 + 1.0) * h],
        });
        let arm = Body {
            is_kinematic: true,
            schedule: schedule.collect(),
            ..still("arm", outline, [0.0, 0.0, angle], [0.0, 0.0, rate])
        };
        let friction = to_f64(load.friction.as_ref().expect("a friction"));
        let material = Material { friction, restitution: Restitution::Newton(0.0), compliance: None };
        World {
            gravity: [0.0, -gravity],
            duration,
            step: Some(h),
            margin: None,
            directions: 2,
            bodies: vec![part, arm],
            fixed: Vec::new(),
            materials: vec![material; 2],
        }
    }

    /// Accelerations of the arm inside of the ends, and outside.
    fn samples(&self) -> [Vec<f64>; 2] {
        let [rate, radius, gravity] = [&self.arm.rate, &self.load.radius, &self.load.gravity].map(to_f64);
        let clear = CLEAR * (gravity / radius + rate * rate);
        let far = 4.0 * (gravity / radius + rate * rate);
        let Some(ends) = self.load.accelerations_at(&self.arm.degrees, &self.arm.rate) else {
            return [Vec::new(), vec![-far, 0.0, far]];
        };
        let [low, high] = ends.map(|end| end.map(|[end, _]| to_f64(&end)));
        // cones grow with the acceleration, and so does what is near to their sides
        let [below, above] =
            [low.map(|low| low - clear - CLEAR * low.abs()), high.map(|high| high + clear + CLEAR * high.abs())];
        let [from, to] = [
            low.map_or_else(|| high.unwrap_or(far).min(far) - far, |low| low + clear + CLEAR * low.abs()),
            high.map_or_else(|| low.unwrap_or(-far).max(-far) + far, |high| high - clear - CLEAR * high.abs()),
        ];
        let inside = if from <= to { vec![from, 0.5 * (from + to), to] } else { Vec::new() };
        // an arm that is jerked tells its part little of the rest
        let outside = below.into_iter().chain(above).filter(|end| end.abs() < 5.0 * far);
        [inside, outside.collect()]
    }
}

proptest! {
    #![proptest_config(runs(32))]

    /// Inside of the accelerations that keep a grasp the part does not move on the arm; outside it slips, tips or lifts off.
    #[test]
    fn arms_carry_what_cones_say(carried in any_carried()) {
        let [inside, outside] = carried.samples();
        for (accelerations, is_held) in [(inside, true), (outside, false)] {
            for acceleration in accelerations {

                let moved = carried.moved(acceleration);
                prop_assert_eq!(moved < LITTLE, is_held, "acceleration {}: moved {}", acceleration, moved);
            }
        }
    }
}
