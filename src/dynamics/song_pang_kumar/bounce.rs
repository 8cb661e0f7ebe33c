//! The restitution that a compliant contact amounts to: of the model, and of the scheme at its step.

use super::super::mechanics::Mechanics;
use super::super::state::State;
use super::super::stepper::Stepper;
use super::SongPangKumar;
use crate::model::{Body, Compliance, Material, Obstacle, Planar, PlanarShape, Restitution, Space, World};

/// Steps after which an impact that is not over counts as without end.
const MAX_STEPS: usize = 1_000_000;

/// Says for the first few bodies what their impacts restitute.
pub(in crate::dynamics) fn bounces<S: Mechanics>(world: &World<S>, h: f64, second_order: bool) -> Vec<String> {
    let mut notes: Vec<String> = Vec::new();
    let n = world.bodies.len() + world.fixed.len();
    for (at, body) in world.bodies.iter().enumerate().filter(|(_, body)| !body.is_kinematic) {
        let Some(compliance) = (at + 1..n).find_map(|other| world.material(at, other).compliance) else {
            continue;
        };
        let (limit, here) = (restitution(body.mass, &compliance), stepped(body.mass, compliance, h, second_order));
        let note = format!(
            "a central impact of {} ({} kg) restitutes {limit:.3} of its speed, {here:.3} at this step",
            body.name, body.mass
        );
        notes.push(note);
        if notes.len() == 3 {
            break;
        }
    }
    notes
}

/// Coefficient of restitution of a mass on λ = K δ + C δ̇, λ ≥ 0, as h → 0 and without gravity.
///
/// With ζ = C / (2 √(K m)) and r = √|1 - ζ²|: exp(-ζ/r atan2(2 ζ r, 2 ζ² - 1)) below critical damping and
/// exp(-ζ/r ln((ζ + r)/(ζ - r))) above it; e⁻² at it.
fn restitution(mass: f64, compliance: &Compliance) -> f64 {
    let (k, c) = (compliance.stiffness[0], compliance.damping[0]);
    let zeta = c / (2.0 * (k * mass).sqrt());
    let r = (1.0 - zeta * zeta).abs().sqrt();
    if r < 1e-6 {
        libm::exp(-2.0)
    } else if zeta < 1.0 {
        libm::exp(-zeta / r * libm::atan2(2.0 * zeta * r, 2.0 * zeta * zeta - 1.0))
    } else {
        libm::exp(-zeta / r * libm::log((zeta + r) / (zeta - r)))
    }
}

/// The same by the scheme itself at step `h`: a disc thrown onto a half plane at 1 m/s.
fn stepped(mass: f64, compliance: Compliance, h: f64, second_order: bool) -> f64 {
    let material = Material { friction: 0.0, restitution: Restitution::Newton(0.0), compliance: Some(compliance) };
    let radius = 10.0 * (mass / compliance.stiffness[0]).sqrt().max(h);
    let world = World::<Planar> {
        gravity: <Planar as Space>::Vector::default(),
        duration: 1.0,
        step: None,
        margin: None,
        directions: 2,
        bodies: vec![Body {
            name: String::new(),
            shape: PlanarShape::Circle { center: [0.0; 2], radius },
            mass,
            inertia: [mass * radius * radius],
            pose: [0.0, radius, 0.0],
            velocity: [0.0, -1.0, 0.0],
            is_kinematic: false,
            schedule: Vec::new(),
            finger: None,
        }],
        fixed: vec![Obstacle {
            name: String::new(),
            shape: PlanarShape::HalfPlane { point: [0.0; 2], normal: [0.0, 1.0] },
            surface_velocity: [0.0; 2],
        }],
        materials: vec![material; 2],
    };
    let mut stepper = SongPangKumar::new(&world, second_order);
    let mut state = State::start(&world);
    for _ in 0..MAX_STEPS {
        if stepper.step(&mut state, h).is_err() {
            break;
        }
        let is_over = stepper.touches().next().is_none_or(|(_, impulse)| impulse[0] == 0.0);
        if is_over {
            break;
        }
    }
    state.velocities[0][1].max(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    const SPHERE: Compliance = Compliance { stiffness: [5e4; 2], damping: [14.142_135_623_730_951; 2], gamma: 1e-8 };

    /// The readings of the paper's damping: 0.8084 with K in N/mm under the root, 0.0396 as printed, 0.1353 at critical
    /// damping.
    #[test]
    fn restitution_in_the_limit_is_the_closed_form() {
        let of = |c: f64| restitution(0.2, &Compliance { damping: [c; 2], ..SPHERE });
        for (c, e) in [(14.142_135_623_730_951, 0.8084), (4.472, 0.9331), (447.2, 0.0396), (200.0, 0.1353)] {
            assert!((of(c) - e).abs() < 1e-4, "C {c}: {} for {e}", of(c));
        }
    }

    /// The implicit Euler step loses energy by itself, 0.692 at h = 2e-4; two stages lose almost none.
    #[test]
    fn restitution_at_a_step_is_that_of_the_scheme() {
        assert!((stepped(0.2, SPHERE, 2e-4, false) - 0.692).abs() < 5e-3);
        assert!((stepped(0.2, SPHERE, 2e-4, true) - 0.8084).abs() < 2e-3);
        assert!((stepped(0.2, SPHERE, 1e-6, false) - 0.8084).abs() < 1e-3);
    }
}
