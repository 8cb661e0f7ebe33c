//! The velocities at the end of a compliant step: one nonsmooth equation, by semismooth Newton steps.

use super::super::contact::{Contact, add_scaled, dot};
use super::super::mechanics::Mechanics;
use super::law::{Force, Law};
use super::solve::System;
use crate::model::{Entries, World};

/// A pair of features through a step.
#[derive(Debug, Clone, Copy)]
pub(in crate::dynamics) struct Joint<S: Mechanics> {
    /// As found at the start.
    pub start: Contact<S>,
    /// As it is at the velocities tried last.
    pub now: Contact<S>,
    /// Deformation δ along n, t and o before (m).
    pub delta: [f64; 3],
    /// Overlap that does not push (m).
    pub offset: f64,
    pub law: Law,
    /// The guess before, the force after.
    pub force: Force,
    /// Impulse of the stage before (N s).
    pub earlier: [f64; 3],
}

/// What the equation of a step is made of.
#[derive(Debug, Clone, Copy)]
pub(in crate::dynamics) struct Stage<'a, S: Mechanics> {
    pub world: &'a World<S>,
    pub outlines: &'a S::Outlines,
    /// Where the contacts were found.
    pub found: &'a [S::Pose],
    /// Where the bodies start, q.
    pub poses: &'a [S::Pose],
    /// ν + M⁻¹ h u.
    pub free: &'a [S::Velocity],
    pub h: f64,
}

/// What a solution took.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::dynamics) struct Work {
    /// Largest defect of a velocity, relative to the sizes of what adds up to it.
    pub residual: f64,
    pub iterations: usize,
}

/// Defects at which a solution is as good as rounding lets it be, and good enough, relative to the terms.
const ROUNDED: f64 = 4.0 * f64::EPSILON;
const ACCEPTED: f64 = 1e-12;
const MAX_ITERATIONS: usize = 40;
const MAX_HALVINGS: usize = 12;

/// Solves F(ν') = M (ν' - ν) - h u - h Σ W(q') λ = 0 with λ by [`Law::force`] and q' = q + h G ν'; keeps its memory.
#[derive(Debug)]
pub(in crate::dynamics) struct Newton<S: Mechanics> {
    pub joints: Vec<Joint<S>>,
    /// The guess before, the solution after.
    pub velocities: Vec<S::Velocity>,
    pub free: Vec<S::Velocity>,
    base: Vec<S::Velocity>,
    poses: Vec<S::Pose>,
    /// M⁻¹ F, and the sizes of its terms.
    defect: Vec<S::Velocity>,
    size: Vec<S::Velocity>,
    direction: Vec<f64>,
    system: System,
}

impl<S: Mechanics> Newton<S> {
    pub fn new() -> Self {
        Self {
            joints: Vec::new(),
            velocities: Vec::new(),
            free: Vec::new(),
            base: Vec::new(),
            poses: Vec::new(),
            defect: Vec::new(),
            size: Vec::new(),
            direction: Vec::new(),
            system: System::default(),
        }
    }

    /// Newton steps from the guess in `velocities`, each as long as it lessens the defect.
    pub fn solve(&mut self, stage: &Stage<'_, S>) -> Option<Work> {
        let mut merit = self.evaluate(stage);
        for iterations in 0..MAX_ITERATIONS {
            if !merit.is_finite() {
                return None;
            }
            let residual = self.residual();
            if residual <= ROUNDED {
                return Some(Work { residual, iterations });
            }
            let is_good = residual <= ACCEPTED;
            self.differentiate(stage);
            if !self.system.solve(&mut self.direction) {
                return is_good.then_some(Work { residual, iterations });
            }
            self.base.clone_from(&self.velocities);
            let mut length = 1.0;
            let found = (0..if is_good { 1 } else { MAX_HALVINGS }).find_map(|_| {
                self.go(length);
                let tried = self.evaluate(stage);
                // the energy of rounding on one body may hide what is still to be gained on another
                let is_less = tried <= (1.0 - 1e-4 * length) * merit || self.residual() <= 0.5 * residual;
                length *= 0.5;
                is_less.then_some(tried)
            });
            let Some(less) = found else {
                self.velocities.clone_from(&self.base);
                self.evaluate(stage);
                return is_good.then_some(Work { residual, iterations });
            };
            merit = less;
        }
        let residual = self.residual();
        (residual <= ACCEPTED).then_some(Work { residual, iterations: MAX_ITERATIONS })
    }

    /// The defect of the velocities; returns twice its kinetic energy, the same in all units.
    fn evaluate(&mut self, stage: &Stage<'_, S>) -> f64 {
        let Stage { world, outlines, found, poses, free, h } = *stage;
        self.poses.clear();
        self.poses.extend(poses.iter().zip(&self.velocities).map(|(pose, velocity)| S::advanced(pose, velocity, h)));
        self.defect.clear();
        self.size.clear();
        for (velocity, free) in self.velocities.iter().zip(free) {
            let (mut defect, mut size) = (*velocity, *velocity);
            add_scaled(&mut defect, -1.0, free);
            for (size, free) in size.as_mut().iter_mut().zip(free.as_ref()) {
                *size = size.abs() + free.abs();
            }
            self.defect.push(defect);
            self.size.push(size);
        }
        for joint in &mut self.joints {
            joint.now = S::follow(outlines, world, &joint.start, found, &self.poses);
            let now = &joint.now;
            joint.force = force::<S>(joint, &self.velocities);
            if joint.force.lambda[0] == 0.0 {
                continue;
            }
            for (body, rows) in now.sides() {
                let (mut wrench, mut size) = (S::Velocity::default(), S::Velocity::default());
                for (row, (lambda, terms)) in rows.as_ref().iter().zip(joint.force.lambda.iter().zip(joint.force.size))
                {
                    add_scaled(&mut wrench, h * lambda, row);
                    add_scaled(&mut size, h * terms, &magnitude(row));
                }
                let (body_at, pose) = (&world.bodies[body], &poses[body]);
                add_scaled(&mut self.defect[body], -1.0, &S::weighed(body_at, pose, &wrench));
                add_scaled(&mut self.size[body], 1.0, &magnitude(&S::weighed(body_at, pose, &size)));
            }
        }
        let bodies = world.bodies.iter().zip(poses).zip(&self.defect);
        bodies.map(|((body, pose), defect)| dot(defect, &S::momentum(body, pose, defect))).sum()
    }

    fn residual(&self) -> f64 {
        let mut worst = 0.0_f64;
        for (defect, size) in self.defect.iter().zip(&self.size) {
            for (defect, size) in defect.as_ref().iter().zip(size.as_ref()).filter(|(defect, _)| **defect != 0.0) {
                worst = worst.max(defect.abs() / size);
            }
        }
        worst
    }

    /// 1 + h M⁻¹ Σ W (-∂λ/∂ν') - h M⁻¹ Σ (∂W/∂ν') λ, and the defect with its sign turned.
    ///
    /// Of the arms, those of points that turn with their body are differentiated; what is left out is h times smaller
    /// than what is kept, and only slows the last digits.
    fn differentiate(&mut self, stage: &Stage<'_, S>) {
        let Stage { world, poses, h, .. } = *stage;
        let dof = S::Velocity::default().as_ref().len();
        let n = dof * world.bodies.len();
        let Self { joints, velocities, poses: ends, defect, direction, system, .. } = self;
        direction.clear();
        direction.extend(defect.iter().flat_map(|defect| defect.as_ref()).map(|x| -x));
        system.reset(n);
        for joint in joints.iter().filter(|joint| joint.force.lambda[0] > 0.0) {
            let (now, Force { lambda, slope, .. }) = (&joint.now, &joint.force);
            let n_rows = 1 + S::TANGENTS;
            let turning = turns(now).then_some(now.name.body);
            let swing = |body: usize, row: &S::Velocity, velocity: &S::Velocity| {
                S::swing(&now.point, &ends[body], row, velocity)
            };
            let mut add = |row: usize, column: usize, weighed: &S::Velocity, by: &S::Velocity| {
                for (i, weighed) in weighed.as_ref().iter().enumerate().filter(|(_, weighed)| **weighed != 0.0) {
                    let start = (row * dof + i) * n + column * dof;
                    for (entry, by) in system.matrix[start..start + dof].iter_mut().zip(by.as_ref()) {
                        *entry += h * weighed * by;
                    }
                }
            };
            for (body, columns) in now.sides() {
                // W ν' changes by (W + h ∂(W ν')/∂q) dν' along the tangents; the gap by h W_n dν' alone
                let mut moved = *columns;
                for row in moved.as_mut()[1..].iter_mut().filter(|_| turning == Some(body)) {
                    let turn = swing(body, row, &velocities[body]);
                    add_scaled(row, h, &turn);
                }
                for (other, rows) in now.sides() {
                    for (r, row) in rows.as_ref().iter().enumerate() {
                        let mut by = S::Velocity::default();
                        for (slope, moved) in slope[r][..n_rows].iter().zip(moved.as_ref()) {
                            add_scaled(&mut by, *slope, moved);
                        }
                        add(other, body, &S::weighed(&world.bodies[other], &poses[other], row), &by);
                    }
                }
            }
            if let Some(body) = turning {
                let mut wrench = S::Velocity::default();
                for (row, lambda) in now.rows.as_ref().iter().zip(lambda) {
                    add_scaled(&mut wrench, *lambda, row);
                }
                for i in 0..dof {
                    let mut unit = S::Velocity::default();
                    unit.as_mut()[i] = 1.0;
                    let by = swing(body, &wrench, &unit);
                    if by.as_ref().iter().any(|x| *x != 0.0) {
                        let mut minus = S::Velocity::default();
                        add_scaled(&mut minus, -h, &by);
                        add(body, body, &S::weighed(&world.bodies[body], &poses[body], &unit), &minus);
                    }
                }
            }
        }
    }

    /// `base` plus `length` times the direction.
    fn go(&mut self, length: f64) {
        self.velocities.clone_from(&self.base);
        let dof = S::Velocity::default().as_ref().len();
        for (velocity, step) in self.velocities.iter_mut().zip(self.direction.chunks_exact(dof)) {
            for (x, step) in velocity.as_mut().iter_mut().zip(step) {
                *x += length * step;
            }
        }
    }
}

fn force<S: Mechanics>(joint: &Joint<S>, velocities: &[S::Velocity]) -> Force {
    let now = &joint.now;
    let mut slip = [0.0; 2];
    for (row, slip) in (1..=S::TANGENTS).zip(&mut slip) {
        *slip = now.velocity(row, velocities);
    }
    let span = largest(&now.point);
    let mut speed = now.surface[0].abs() + now.surface[1].abs();
    for (body, rows) in now.sides() {
        let rows = rows.as_ref()[1..].iter();
        speed += rows.map(|row| dot(&magnitude(row), &magnitude(&velocities[body]))).sum::<f64>();
    }
    joint.law.force(now.gap + joint.offset, slip, joint.delta, span, speed)
}

/// Whether the point of a contact turns with its body.
fn turns<S: Mechanics>(contact: &Contact<S>) -> bool {
    use crate::answer::Feature;
    matches!(contact.name.feature, Feature::Vertex(_)) && !matches!(contact.name.other_feature, Feature::Vertex(_))
}

fn magnitude<E: Entries>(of: &E) -> E {
    let mut size = *of;
    size.as_mut().iter_mut().for_each(|x| *x = x.abs());
    size
}

fn largest<E: Entries>(of: &E) -> f64 {
    of.as_ref().iter().fold(0.0, |largest, x| x.abs().max(largest))
}
