//! Contact frames as primitive integer rows in wrench space.

use crate::exact::{Int, Overflow, Q, Z, on_rung, primitive_row};
use crate::geometry::{cross, difference};
use crate::model::{Fixture, Part};

/// One contact: its acceleration rows and force rays, each up to a positive factor.
///
/// With `w = M v'` the wrench that would accelerate the part by the twist `v'`, the contact's accelerations are
/// `a_n = J_nᵀ M⁻¹ w` and `a_t = J_tᵀ M⁻¹ w`: linear in `w`, and up to the mass they depend on ρ² = inertia / mass only.
/// Forces enter as the external wrenches `-J c` that they balance. So accelerations and forces both live in the
/// three-dimensional space of wrenches `(fx, fy, torque about the center of mass)`.
///
/// # Source
/// Balkcom & Trinkle (2002), eqs. (3)-(6). Frames need no unit length: a factor on `n` scales each row positively.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ContactRows<T> {
    /// `a_n` as a row on `w`.
    pub normal_acceleration: Vec<T>,
    /// `a_t` as a row on `w`.
    pub tangent_acceleration: Vec<T>,
    /// `-J (1, ±μ)` for the largest static coefficient: the edges of the cone of `n` and `m`.
    pub static_forces: [Vec<T>; 2],
    /// `-J (1, ±μ)` for the least static coefficient, which every coefficient in the range can do.
    pub sure_forces: [Vec<T>; 2],
    /// `-J (1, -k)` for the least and largest kinetic coefficient: sliding left.
    pub left_forces: [Vec<T>; 2],
    /// `-J (1, k)` for the least and largest kinetic coefficient: sliding right.
    pub right_forces: [Vec<T>; 2],
}

/// A contact in integers of any size.
pub type Contact = ContactRows<Z>;

impl Contact {
    /// The contacts of a seated part, in file order.
    #[must_use]
    pub fn of(part: &Part, fixture: &Fixture) -> Vec<Self> {
        let rho2 = part.gyration2();
        fixture
            .fixels
            .iter()
            .map(|fixel| {
                let arm = difference(&part.center_of_mass, &fixel.point);
                let normal = wrench(&arm, &fixel.normal);
                let tangent = wrench(&arm, &[-&fixel.normal[1], fixel.normal[0].clone()]);
                let force = |share: &Q| {
                    let sum: Vec<Q> = normal.iter().zip(&tangent).map(|(n, t)| -(n + t * share)).collect();
                    primitive_row(&sum)
                };
                let friction = &fixel.friction;
                Self {
                    normal_acceleration: acceleration_row(&normal, &rho2),
                    tangent_acceleration: acceleration_row(&tangent, &rho2),
                    static_forces: [force(&-&friction.static_.max), force(&friction.static_.max)],
                    sure_forces: [force(&-&friction.static_.min), force(&friction.static_.min)],
                    left_forces: [force(&-&friction.kinetic.min), force(&-&friction.kinetic.max)],
                    right_forces: [force(&friction.kinetic.min), force(&friction.kinetic.max)],
                }
            })
            .collect()
    }

    /// The same rows on a rung of the integer ladder.
    ///
    /// # Errors
    /// [`Overflow`] if an entry does not fit.
    pub fn on_rung<T: Int>(&self) -> Result<ContactRows<T>, Overflow> {
        Ok(ContactRows {
            normal_acceleration: on_rung(&self.normal_acceleration)?,
            tangent_acceleration: on_rung(&self.tangent_acceleration)?,
            static_forces: both(&self.static_forces)?,
            sure_forces: both(&self.sure_forces)?,
            left_forces: both(&self.left_forces)?,
            right_forces: both(&self.right_forces)?,
        })
    }
}

/// Wrench of the force `direction` at `arm` from the center of mass: a column of J.
pub(super) fn wrench(arm: &[Q; 2], direction: &[Q; 2]) -> [Q; 3] {
    [direction[0].clone(), direction[1].clone(), cross(arm, direction)]
}

fn acceleration_row(wrench: &[Q; 3], rho2: &Q) -> Vec<Z> {
    primitive_row(&[wrench[0].clone(), wrench[1].clone(), &wrench[2] / rho2])
}

fn both<T: Int>(rows: &[Vec<Z>; 2]) -> Result<[Vec<T>; 2], Overflow> {
    Ok([on_rung(&rows[0])?, on_rung(&rows[1])?])
}
