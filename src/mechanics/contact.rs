//! Contact frames as primitive integer rows in wrench space.

use super::frame::Frame;
use super::mode::Interaction;
use crate::exact::{Int, Overflow, Q, Z, make_primitive, on_rung, primitive_row};
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
        Frame::of(part, fixture)
            .iter()
            .map(|frame| {
                // one factor for both columns, then integers only
                let columns = primitive_row(&[frame.normal.clone(), frame.tangent.clone()].concat());
                let (normal, tangent) = columns.split_at(3);
                let balanced = |slope: &Q| {
                    let columns = normal.iter().zip(tangent);
                    primitive(columns.map(|(n, t)| -(n * slope.denom() + t * slope.numer())).collect())
                };
                let edges = |slopes: [Q; 2]| slopes.each_ref().map(balanced);
                let forces = |interaction| edges(frame.slopes(interaction).expect("these interactions transmit force"));
                Self {
                    normal_acceleration: acceleration_row(normal, &rho2),
                    tangent_acceleration: acceleration_row(tangent, &rho2),
                    static_forces: forces(Interaction::Roll),
                    sure_forces: edges(frame.sure_slopes()),
                    left_forces: forces(Interaction::SlideLeft),
                    right_forces: forces(Interaction::SlideRight),
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

fn acceleration_row(wrench: &[Z], rho2: &Q) -> Vec<Z> {
    primitive(vec![&wrench[0] * rho2.numer(), &wrench[1] * rho2.numer(), &wrench[2] * rho2.denom()])
}

fn primitive(mut row: Vec<Z>) -> Vec<Z> {
    make_primitive(&mut row);
    row
}

fn both<T: Int>(rows: &[Vec<Z>; 2]) -> Result<[Vec<T>; 2], Overflow> {
    Ok([on_rung(&rows[0])?, on_rung(&rows[1])?])
}
