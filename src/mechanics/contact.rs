//! Contact frames as primitive integer rows in wrench space.

use crate::exact::{Int, Overflow, Q, Z, on_rung};
use crate::geometry::difference;
use crate::model::{Fixture, Part};
use num_integer::Integer as _;

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
                let (arm, denominator) = integers(&difference(&part.center_of_mass, &fixel.point));
                let (direction, _) = integers(&fixel.normal);
                let [x, y] = &direction;
                let normal = wrench(&arm, &denominator, &direction);
                let tangent = wrench(&arm, &denominator, &[-y, x.clone()]);
                let force = |share: &Q| {
                    let entry = |axis: usize| -(&normal[axis] * share.denom() + &tangent[axis] * share.numer());
                    primitive((0..3).map(entry).collect())
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

/// Wrench of the force `direction` at `arm / denominator` from the center of mass, times the denominator: a column of J.
fn wrench(arm: &[Z; 2], denominator: &Z, direction: &[Z; 2]) -> [Z; 3] {
    let [x, y] = direction;
    [x * denominator, y * denominator, &arm[0] * y - &arm[1] * x]
}

fn acceleration_row([x, y, torque]: &[Z; 3], rho2: &Q) -> Vec<Z> {
    primitive(vec![x * rho2.numer(), y * rho2.numer(), torque * rho2.denom()])
}

/// The vector as integers over a common denominator.
fn integers(vector: &[Q; 2]) -> ([Z; 2], Z) {
    let denominator = vector[0].denom().lcm(vector[1].denom());
    (vector.each_ref().map(|value| value.numer() * (&denominator / value.denom())), denominator)
}

fn primitive(mut row: Vec<Z>) -> Vec<Z> {
    Z::make_primitive(&mut row);
    row
}

fn both<T: Int>(rows: &[Vec<Z>; 2]) -> Result<[Vec<T>; 2], Overflow> {
    Ok([on_rung(&rows[0])?, on_rung(&rows[1])?])
}
