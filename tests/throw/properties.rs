//! What holds for throws of all parts.

use super::expected::{body, hull};
use partplan::case;
use partplan::exact::to_f64;
use partplan::mechanics::throwing::{Body, Catch, RestingEdge, Settling, Thrown};
use partplan::model::{Part, Thrower};
use partplan::planner::{self, ThrowQuestion};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use std::cell::Cell;

/// A part on an arm, as a case says it: lengths in thousandths of the unit.
#[derive(Debug, Clone)]
struct Arm {
    corners: Vec<[i64; 2]>,
    offset: i64,
    release: i64,
    gravity: i64,
}

impl Arm {
    fn read(&self, unit: &str) -> (Part, Thrower) {
        let corners: Vec<String> = self.corners.iter().map(|[x, y]| format!("[\"{x}/1000\", \"{y}/1000\"]")).collect();
        let Self { offset, release, gravity, .. } = self;
        let text = format!(
            "{{\"length_unit\": \"{unit}\", \"part\": {{\"shape\": {{\"polygon\": [{}]}}}}, \"throw\": {{\"offset\": \
             \"{offset}/1000\", \"release_deg_per_s\": {release}, \"gravity\": \"{gravity}/1000\"}}}}",
            corners.join(", ")
        );
        let case = case::read(text.as_bytes(), &case::Limits::default()).unwrap();
        (case.part, case.thrower.unwrap())
    }

    fn scaled(&self, factor: i64) -> Self {
        Self {
            corners: self.corners.iter().map(|corner| corner.map(|x| x * factor)).collect(),
            offset: self.offset * factor,
            gravity: self.gravity * factor,
            ..self.clone()
        }
    }

    fn body(&self) -> (Part, Body<f64>) {
        let (part, thrower) = self.read("cm");
        let body = body(&part, &thrower);
        (part, body)
    }

    /// For each edge, from where on all of the part is right of the pivot.
    fn clear(&self) -> Vec<f64> {
        let (part, _) = self.read("cm");
        let edges = RestingEdge::all(&hull(&part), &part.center_of_mass, &part.gyration2());
        edges.iter().map(|edge| edge.r_clear.to_f64() * (1.0 + 1e-3)).collect()
    }
}

/// Up to 8 cm further out.
fn radius(clear: f64, share: f64) -> f64 {
    clear + 8.0 * share
}

/// Corners about the origin, some 3 to 6 cm away, on an arm that throws them by some lengths.
fn arms(offset: std::ops::Range<i64>) -> impl Strategy<Value = Arm> {
    let corners = proptest::collection::vec((0.0..1.0_f64, 3_000.0..6_000.0_f64), 3..7).prop_map(|corners| {
        let n = corners.len() as f64;
        let at = |(k, (share, far)): (usize, &(f64, f64))| {
            let angle = (k as f64 + 0.6 * share) / n * std::f64::consts::TAU;
            [(far * angle.cos()).round() as i64, (far * angle.sin()).round() as i64]
        };
        corners.iter().enumerate().map(at).collect::<Vec<_>>()
    });
    (corners, offset, 150..350_i64, 600_000..1_200_000_i64).prop_map(|(corners, offset, release, gravity)| Arm {
        corners,
        offset,
        release,
        gravity,
    })
}

fn stable(body: &Body<f64>) -> Vec<usize> {
    (0..body.n_corners()).filter(|edge| body.is_stable(*edge)).collect()
}

fn caught(thrown: Thrown) -> Option<Catch> {
    if let Thrown::Caught(catch) = thrown { Some(catch) } else { None }
}

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-9 * a.abs().max(b.abs())
}

proptest! {
    #[test]
    fn throws_grow_with_the_part(arm in arms(-2_000..2_000), factor in 2..50_i64, share in 0.0..1.0_f64) {
        let (_, body) = arm.body();
        let (_, larger) = arm.scaled(factor).body();
        let clear = arm.clear();
        for edge in stable(&body) {
            let radius = radius(clear[edge], share);
            let [a, b] = [(&body, radius), (&larger, radius * factor as f64)]
                .map(|(body, radius)| caught(body.throw(edge, radius, Settling::Full)));
            prop_assert_eq!(a.is_some(), b.is_some());
            let (Some(a), Some(b)) = (a, b) else { continue };
            prop_assert_eq!((a.edge, a.steps, a.impact_vertex), (b.edge, b.steps, b.impact_vertex));
            prop_assert!(close(a.radius * factor as f64, b.radius) && close(a.slope, b.slope));
        }
    }

    #[test]
    fn throws_do_not_depend_on_the_unit(arm in arms(-2_000..2_000), share in 0.0..1.0_f64) {
        let (part, thrower) = arm.read("cm");
        let (in_mm, throws_mm) = arm.scaled(10).read("mm");
        let [small, large] = [body::<f64>(&part, &thrower), body(&in_mm, &throws_mm)];
        let clear = arm.clear();
        for edge in stable(&small) {
            let radius = radius(clear[edge], share);
            let [a, b] = [(&small, radius), (&large, 10.0 * radius)]
                .map(|(body, radius)| caught(body.throw(edge, radius, Settling::Full)));
            let (Some(a), Some(b)) = (a, b) else { continue };
            prop_assert_eq!((a.edge, a.steps), (b.edge, b.steps));
            prop_assert!(close(10.0 * a.radius, b.radius));
        }
    }

    /// f depends on gravity and release speed by λ = |g| / w² only.
    #[test]
    fn a_faster_throw_in_stronger_gravity_is_the_same(arm in arms(-2_000..2_000), factor in 2..9_i64, share in 0.0..1.0_f64) {
        let (_, body) = arm.body();
        let faster = Arm { release: arm.release * factor, gravity: arm.gravity * factor * factor, ..arm.clone() };
        let (_, faster) = faster.body();
        let clear = arm.clear();
        for edge in stable(&body) {
            let radius = radius(clear[edge], share);
            let [a, b] = [&body, &faster].map(|body| caught(body.throw(edge, radius, Settling::Full)));
            let (Some(a), Some(b)) = (a, b) else { continue };
            prop_assert_eq!((a.edge, a.steps), (b.edge, b.steps));
            prop_assert!(close(a.radius, b.radius) && close(a.flight_rotation, b.flight_rotation));
        }
    }

    /// The throw has a side, so that only the geometry of a mirrored part is that of the part.
    #[test]
    fn a_mirrored_part_rests_on_the_mirrored_edges(arm in arms(-2_000..2_000)) {
        let mirrored = Arm { corners: arm.corners.iter().rev().map(|[x, y]| [-x, *y]).collect(), ..arm.clone() };
        let all = |arm: &Arm| {
            let (part, _) = arm.read("cm");
            let corners = hull(&part);
            let edges = RestingEdge::all(&corners, &part.center_of_mass, &part.gyration2());
            let key = |edge: &RestingEdge| (edge.d.to_f64(), edge.u_left.to_f64());
            (corners.len(), { let mut edges = edges; edges.sort_by(|a, b| key(a).partial_cmp(&key(b)).unwrap()); edges })
        };
        let ((n, edges), (m, others)) = (all(&arm), all(&mirrored));
        prop_assert_eq!(n, m);
        for edge in &edges {
            let is_mirror = |other: &&RestingEdge| {
                (&other.d, &other.u_left, &other.u_right) == (&edge.d, &-&edge.u_right, &-&edge.u_left)
            };
            let Some(other) = others.iter().find(is_mirror) else { panic!("{edge:?} has no mirror image") };
            prop_assert_eq!((&edge.energy_kept, &edge.length2, edge.is_stable()), (&other.energy_kept, &other.length2, other.is_stable()));
        }
    }

    /// Neither impacts nor rolling add energy: the part never rises higher than what it had left lifts it.
    #[test]
    fn energy_never_increases(arm in arms(-2_000..2_000), share in 0.0..1.0_f64, settles_first in any::<bool>()) {
        let (part, body) = arm.body();
        let settling = if settles_first { Settling::First } else { Settling::Full };
        let (offset, gravity, rate) = (arm.offset as f64 / 1e3, arm.gravity as f64 / 1e3, body.rate());
        let (rho2, center) = (to_f64(&part.gyration2()), part.center_of_mass.each_ref().map(to_f64));
        let corners = hull(&part);
        let clear = arm.clear();
        for edge in stable(&body) {
            let radius = radius(clear[edge], share);
            let Some(catch) = caught(body.throw(edge, radius, settling)) else { continue };
            let height = offset + body.height(edge);
            let at_release = 0.5 * rate * rate * (radius * radius + height * height + rho2) + gravity * height;
            let time = catch.flight_rotation / rate;
            let at_impact = height + radius * rate * time - 0.5 * gravity * time * time;
            let vertex = corners[catch.impact_vertex].each_ref().map(to_f64);
            let far2 = (vertex[0] - center[0]).powi(2) + (vertex[1] - center[1]).powi(2);
            let omega = catch.omega_after * rate;
            let after = 0.5 * omega * omega * (rho2 + far2) + gravity * at_impact;
            prop_assert!(after <= at_release * (1.0 + 1e-12) + 1e-9, "{} {}", after, at_release);
            let at_rest = gravity * (offset + body.height(catch.edge));
            prop_assert!(at_rest <= after * (1.0 + 1e-9) + 1e-9 * gravity, "{} {}", at_rest, after);
            body.play(edge, radius, settling, |moment| {
                let allowed = if moment.time < time * (1.0 - 1e-9) { at_release } else { after };
                // the swings are integrated to some thousandths
                assert!(gravity * moment.at[1] <= allowed + 5e-3 * gravity * 6.0, "{moment:?} {allowed}");
            });
        }
    }
}

/// Below R_flip a throw is a jog outward, by Proposition IV.4.
#[test]
fn jogs_in_the_range_of_the_proposition_go_outward() {
    let (n_parts, n_jogs) = (Cell::new(0), Cell::new(0));
    let rng = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    let mut runner = TestRunner::new_with_rng(Config::with_cases(60), rng);
    let strategy = (arms(-1_500..0), proptest::collection::vec(0.0..1.0_f64, 20));
    let check = |(arm, shares): (Arm, Vec<f64>)| {
        let (part, thrower) = arm.read("cm");
        let answer = planner::throw(&part, &thrower, &ThrowQuestion::default(), &mut |_| false).unwrap();
        if !answer.reach.proposition {
            return Ok(());
        }
        n_parts.set(n_parts.get() + 1);
        let body = body::<f64>(&part, &thrower);
        for reach in &answer.reach.edges {
            let r_flip = reach.r_flip.unwrap();
            for share in &shares {
                let radius = reach.r_low + (r_flip - reach.r_low) * share.max(1e-3);
                let Some(catch) = caught(body.throw(reach.edge, radius, Settling::Full)) else { panic!("lost") };
                prop_assert!(catch.steps == 0 && catch.radius > radius, "{radius} {catch:?}");
                n_jogs.set(n_jogs.get() + 1);
            }
        }
        Ok(())
    };
    runner.run(&strategy, check).unwrap();
    assert!(n_parts.get() >= 5 && n_jogs.get() >= 300, "{} parts, {} jogs", n_parts.get(), n_jogs.get());
}

/// Proposition IV.1: where all edges are stable and a part rests on the first edge that it lands on, every jog that goes
/// nowhere is unstable. There are none unless the arm's surface is above the pivot.
#[test]
fn fixed_points_of_jogs_are_unstable() {
    const SCANNED: usize = 400;
    let n_points = Cell::new(0);
    let mut runner = TestRunner::deterministic();
    let check = |arm: Arm| {
        let (_, body) = arm.body();
        if stable(&body).len() < body.n_corners() {
            return Ok(());
        }
        let clear = arm.clear();
        for edge in stable(&body) {
            let jog = |radius: f64| caught(body.throw(edge, radius, Settling::First)).filter(|catch| catch.steps == 0);
            let radii: Vec<f64> = (0..=SCANNED).map(|k| radius(clear[edge], 2.0 * k as f64 / SCANNED as f64)).collect();
            for pair in radii.windows(2) {
                let [mut low, mut high] = [pair[0], pair[1]];
                let (Some(a), Some(b)) = (jog(low), jog(high)) else { continue };
                if (a.radius - low) * (b.radius - high) >= 0.0 {
                    continue;
                }
                for _ in 0..60 {
                    let middle = 0.5 * (low + high);
                    let Some(catch) = jog(middle) else { panic!("a flip between jogs") };
                    let is_low = (catch.radius - middle) * (a.radius - pair[0]) > 0.0;
                    *if is_low { &mut low } else { &mut high } = middle;
                }
                let catch = jog(low).unwrap();
                prop_assert!((catch.radius - low).abs() < 1e-9 && catch.slope > 1.0, "{edge} {low} {catch:?}");
                n_points.set(n_points.get() + 1);
            }
        }
        Ok(())
    };
    runner.run(&arms(1..2_500), check).unwrap();
    assert!(n_points.get() >= 20, "{} fixed points", n_points.get());
}

/// At h <= 0 jogs of such parts always go outward.
#[test]
fn below_the_pivot_there_are_no_fixed_points() {
    let mut runner = TestRunner::deterministic();
    let check = |(arm, share): (Arm, f64)| {
        let (_, body) = arm.body();
        let clear = arm.clear();
        for edge in stable(&body).into_iter().filter(|_| stable(&body).len() == body.n_corners()) {
            let radius = radius(clear[edge], 2.0 * share);
            let jog = caught(body.throw(edge, radius, Settling::First)).filter(|catch| catch.steps == 0);
            prop_assert!(jog.is_none_or(|catch| catch.radius > radius), "{edge} {radius} {jog:?}");
        }
        Ok(())
    };
    runner.run(&(arms(-2_500..1), 0.0..1.0_f64), check).unwrap();
}
