//! The step against the printed form (17): deformations, forces and the multiplier β of slip as unknowns, its
//! complementarities by the Fischer-Burmeister function.

use crate::spk_accuracy::run;
use crate::spk_robust::{body, draw, ground, material, world};
use nalgebra::{DMatrix, DVector};
use partplan::answer::{Feature, Simulation};
use partplan::model::{Planar, PlanarShape, World};

const CORNERS: [[f64; 2]; 4] = [[-0.5, -0.1], [-0.16, -0.1], [0.16, -0.1], [0.5, -0.1]];
const H: f64 = 2e-4;

/// A block near its floor, K and C not the same along n and t.
fn block(seed: u32) -> World<Planar> {
    let draw = |k: u32| draw(seed, k) - 0.5;
    let mut outline = CORNERS.to_vec();
    outline.extend([[0.5, 0.1], [-0.5, 0.1]]);
    let tilt = if seed.is_multiple_of(4) { 2e-3 } else { 0.02 };
    let (pose, velocity) =
        ([0.1, 0.0995 + 0.004 * draw(1), tilt * draw(2)], [2.0 * draw(3), 2.0 * draw(4), 5.0 * draw(5)]);
    let gamma = [1.0, 1e-2, 1e-4][seed as usize % 3];
    let mut material = material(1.2 * (draw(6) + 0.5), 5e4, 0.0, gamma);
    let compliance = material.compliance.as_mut().unwrap();
    compliance.stiffness[1] = 2e4 + 6e4 * (draw(7) + 0.5);
    compliance.damping = [100.0 * (draw(8) + 0.5), 100.0 * (draw(9) + 0.5)];
    world(vec![body(PlanarShape::Polygon(outline), 2.0, 0.2, pose, velocity)], ground(), material, 0.0)
}

/// The unknowns of (17): ν', then λ_n, λ_t and β of every corner; forces in units of 100 N.
struct FullForm<'a> {
    world: &'a World<Planar>,
    before: &'a Simulation<Planar>,
    deltas: [[f64; 2]; 4],
}

const FORCE: f64 = 100.0;

impl FullForm<'_> {
    fn residual(&self, x: &DVector<f64>) -> DVector<f64> {
        let part = &self.world.bodies[0];
        let material = &self.world.materials[1];
        let (mu, compliance) = (material.friction, material.compliance.unwrap());
        let gamma = compliance.gamma;
        let (q, v) = (self.before.last.poses[0], self.before.last.velocities[0]);
        let end: [f64; 3] = std::array::from_fn(|i| q[i] + H * x[i]);
        let mut out = DVector::zeros(x.len());
        let masses = [part.mass, part.mass, part.inertia[0]];
        for i in 0..3 {
            out[i] = masses[i] * (x[i] - v[i]) - if i == 1 { -9.81 * H * part.mass } else { 0.0 };
        }
        let (sine, cosine) = end[2].sin_cos();
        for (c, corner) in CORNERS.iter().enumerate() {
            let at = 3 + 3 * c;
            let [normal, friction, beta] = [x[at], x[at + 1], x[at + 2]].map(|x| FORCE * x);
            let arm = [cosine * corner[0] - sine * corner[1], sine * corner[0] + cosine * corner[1]];
            let delta = |side: usize, force: f64| {
                let drag = compliance.damping[side] / H;
                (force + drag * self.deltas[c][side]) / (compliance.stiffness[side] + drag)
            };
            let open = delta(0, normal) + end[1] + arm[1];
            let slip = (delta(1, friction) - self.deltas[c][1]) / H + x[0] - arm[1] * x[2];
            let smooth = friction.hypot(gamma);
            out[1] -= H * normal;
            out[0] -= H * friction;
            out[2] -= H * (arm[0] * normal - arm[1] * friction);
            out[at] = fischer_burmeister(normal / FORCE, open * compliance.stiffness[0] / FORCE);
            out[at + 1] = (mu * normal * slip + beta * friction / smooth) / FORCE;
            out[at + 2] = fischer_burmeister(beta / FORCE, (mu * normal + gamma - smooth) / FORCE);
        }
        out
    }

    /// β of (17) at a solution: slip μ λ_n s = -β λ_t / √(λ_t² + γ²).
    fn with_beta(&self, mut x: DVector<f64>) -> DVector<f64> {
        for at in (3..15).step_by(3) {
            let rest = self.residual(&x)[at + 1];
            if x[at + 1] != 0.0 {
                let gamma = self.world.materials[1].compliance.unwrap().gamma / FORCE;
                x[at + 2] = (-rest * x[at + 1].hypot(gamma) / x[at + 1]).max(0.0);
            }
        }
        x
    }

    /// Newton steps by differences, damped where the matrix is singular, as it is at open contacts.
    fn solve(&self, mut x: DVector<f64>) -> Option<DVector<f64>> {
        let mut r = self.residual(&x);
        for _ in 0..200 {
            if r.amax() < 1e-12 {
                return Some(x);
            }
            let n = x.len();
            let mut jacobian = DMatrix::zeros(n, n);
            for j in 0..n {
                let step = 1e-7 * x[j].abs().max(1e-3);
                let [mut up, mut down] = [x.clone(), x.clone()];
                up[j] += step;
                down[j] -= step;
                jacobian.set_column(j, &((self.residual(&up) - self.residual(&down)) / (2.0 * step)));
            }
            let normal = jacobian.transpose() * &jacobian + DMatrix::identity(n, n) * (1e-12 * r.norm());
            let direction = normal.lu().solve(&(-(jacobian.transpose() * &r)))?;
            let lengths = (0..30).map(|k| 0.5_f64.powi(k));
            let better = lengths.map(|t| &x + t * &direction).find(|y| self.residual(y).norm() < r.norm())?;
            x = better;
            r = self.residual(&x);
        }
        None
    }
}

fn fischer_burmeister(a: f64, b: f64) -> f64 {
    // a + b - √(a² + b²) without cancellation
    if a + b > 0.0 { 2.0 * a * b / (a + b + a.hypot(b)) } else { a + b - a.hypot(b) }
}

#[test]
fn the_closed_form_solves_the_printed_one() {
    let (mut counts, mut slips, mut returned, mut tried) = ([0; 5], 0, 0, 0);
    for seed in 0..400 {
        let world = block(seed);
        // the third step: deformed along both directions by then
        let [before, after] = [2.0, 3.0].map(|steps| run(&World { duration: steps * H, ..world.clone() }, H, false));
        let corner = |feature| if let Feature::Vertex(i) = feature { i as usize } else { 9 };
        let mut deltas = [[0.0; 2]; 4];
        for (name, delta) in &before.deformations {
            deltas[corner(name.feature)] = [delta[0], delta[1]];
        }
        let mut x = DVector::zeros(15);
        x.as_mut_slice()[..3].copy_from_slice(&after.last.velocities[0]);
        for touch in &after.last.touches {
            let at = 3 + 3 * corner(touch.contact.feature);
            x[at] = touch.impulse[0] / (H * FORCE);
            x[at + 1] = touch.impulse[1] / (H * FORCE);
        }
        let form = FullForm { world: &world, before: &before, deltas };
        let x = form.with_beta(x);
        let residual = form.residual(&x);
        assert!(residual.amax() < 1e-10, "seed {seed}: {residual}");
        counts[after.last.touches.len()] += 1;
        slips += (5..15).step_by(3).filter(|at| x[*at] > 1e-9).count();
        // the printed form finds it again from near by
        tried += 1;
        let near = x.map(|x| 1.03 * x);
        if let Some(found) = form.solve(near) {
            returned += 1;
            for i in 0..3 {
                assert!((found[i] - x[i]).abs() < 1e-8, "seed {seed}: {} and {}", found[i], x[i]);
            }
        }
    }
    assert!(counts[1..].iter().all(|count| *count > 10) && slips > 100, "{counts:?}, {slips} slip");
    assert!(returned == tried, "{returned} of {tried}");
}
