//! Force of one compliant contact at the end of a step: (14)-(17) with the deformation and the slip multiplier
//! eliminated.

use crate::model::{Compliance, Material};

/// The contact's numbers for steps of one length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Law {
    /// k = K + C/h along n, then along t and o (N/m).
    k: [f64; 2],
    stiffness: [f64; 2],
    /// C/h (N/m).
    drag: [f64; 2],
    friction: f64,
    gamma: f64,
    h: f64,
}

/// Force of a contact and how it changes with what moves the contact.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Force {
    /// λ along n, t and o (N).
    pub lambda: [f64; 3],
    /// -∂λ/∂(W ν') in the rows n, t, o (N s/m); the gap changes by h W_n ν'.
    pub slope: [[f64; 3]; 3],
    /// Sizes of the terms that make up λ (N): what its rounding is relative to.
    pub size: [f64; 3],
}

impl Law {
    /// The law of a material for steps of `h`; none without compliance.
    pub fn new(material: &Material, h: f64) -> Option<Self> {
        let Compliance { stiffness, damping, gamma } = material.compliance?;
        let drag = damping.map(|c| c / h);
        let k = [stiffness[0] + drag[0], stiffness[1] + drag[1]];
        Some(Self { k, stiffness, drag, friction: material.friction, gamma, h })
    }

    /// The same with this times the friction.
    pub fn with_friction(self, factor: f64) -> Self {
        Self { friction: factor * self.friction, ..self }
    }

    /// The force at gap Ψ(q') and slip W_t ν' (m/s, zeros where there is no o), from the deformation δ of before.
    ///
    /// Along n: 0 ≤ λ ⊥ δ' + Ψ ≥ 0 with λ = k δ' - (C/h) δ gives λ_n = max(0, -k Ψ - (C/h) δ_n). Along t and o no
    /// slip would need the trial force K δ - h k W ν'; slip opposes friction, so the force is the trial's projection
    /// on the disc of (6), |λ_t|² ≤ (μ λ_n)² + 2 γ μ λ_n. K and C of the normal enter only the disc's radius, so that
    /// the two directions may differ.
    ///
    /// `span` is the size of the coordinates that the gap is a difference of (m), `speed` that of the slip's terms.
    pub fn force(&self, gap: f64, slip: [f64; 2], delta: [f64; 3], span: f64, speed: f64) -> Force {
        let mut force = Force::default();
        let Self { k: [k_n, k_t], stiffness, drag, friction: mu, gamma, h } = *self;
        let normal = -k_n * gap - drag[0] * delta[0];
        if normal.is_nan() || normal <= 0.0 {
            return force;
        }
        force.lambda[0] = normal;
        force.slope[0][0] = h * k_n;
        force.size[0] = k_n * (gap.abs() + span) + drag[0] * delta[0].abs();
        let squared = mu * normal * (mu * normal + 2.0 * gamma);
        if squared.is_nan() || squared <= 0.0 {
            return force;
        }
        let radius = squared.sqrt();
        let trial = [0, 1].map(|i| stiffness[1] * delta[i + 1] - h * k_t * slip[i]);
        let length = (trial[0] * trial[0] + trial[1] * trial[1]).sqrt();
        if length <= radius {
            let size = stiffness[1] * (delta[1].abs() + delta[2].abs()) + h * k_t * speed;
            for (i, trial) in trial.into_iter().enumerate() {
                force.lambda[i + 1] = trial;
                force.slope[i + 1][i + 1] = h * k_t;
                force.size[i + 1] = size;
            }
            return force;
        }
        let along = trial.map(|x| x / length);
        // dR/dλ_n
        let growth = mu * (mu * normal + gamma) / radius;
        for i in 0..2 {
            force.lambda[i + 1] = radius * along[i];
            force.size[i + 1] = (radius + growth * force.size[0]) * along[i].abs();
            force.slope[i + 1][0] = growth * along[i] * h * k_n;
            for j in 0..2 {
                let across = if i == j { 1.0 - along[i] * along[i] } else { -along[i] * along[j] };
                force.slope[i + 1][j + 1] = radius / length * h * k_t * across;
            }
        }
        force
    }

    /// δ at the end of the step from λ = k δ' - (C/h) δ; without force it relaxes by C / (C + h K).
    pub fn deformed(&self, lambda: [f64; 3], delta: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|i| {
            let side = usize::from(i > 0);
            (lambda[i] + self.drag[side] * delta[i]) / self.k[side]
        })
    }
}

/// Energy of a deformation (J), ½ K |δ|².
pub(super) fn energy(compliance: &Compliance, delta: [f64; 3]) -> f64 {
    let [n, t] = compliance.stiffness;
    0.5 * (n * delta[0] * delta[0] + t * (delta[1] * delta[1] + delta[2] * delta[2]))
}

/// How far the trial lies inside the disc of friction, negative outside, as a part of its radius, from impulses.
pub(super) fn margin(material: &Material, impulse: [f64; 3], h: f64) -> f64 {
    let gamma = material.compliance.map_or(0.0, |compliance| compliance.gamma);
    let press = material.friction * impulse[0];
    let radius = (press * (press + 2.0 * gamma * h)).sqrt();
    if radius > 0.0 { 1.0 - (impulse[1] * impulse[1] + impulse[2] * impulse[2]).sqrt() / radius } else { -1.0 }
}
