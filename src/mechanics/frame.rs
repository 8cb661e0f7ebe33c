//! Contact frames in exact rationals.

use super::mode::Interaction;
use crate::exact::Q;
use crate::geometry::{cross, difference};
use crate::model::{Fixture, Friction, Part};

/// The frame `(n, t)` of one contact as two columns of J, and its friction.
///
/// `n` has the length that the fixture gives it and `t` is `n` turned by +90 degrees. So `a_n = J_nᵀ v'` and
/// `a_t = J_tᵀ v'` are the accelerations along the frame times |n|, and `c_n`, `c_t` are the forces over |n|.
///
/// # Source
/// Balkcom & Trinkle (2002), eqs. (3)-(6).
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Frame {
    /// `J_n`, the wrench of the force `n` at the contact.
    pub normal: [Q; 3],
    /// `J_t`, the wrench of the force `t` at the contact.
    pub tangent: [Q; 3],
    /// Coulomb friction.
    pub friction: Friction,
}

impl Frame {
    /// The frames of a seated part's contacts, in file order.
    #[must_use]
    pub fn of(part: &Part, fixture: &Fixture) -> Vec<Self> {
        let frame = |fixel: &crate::model::Fixel| {
            let arm = difference(&part.center_of_mass, &fixel.point);
            let tangent = [-&fixel.normal[1], fixel.normal[0].clone()];
            Self {
                normal: wrench(&arm, &fixel.normal),
                tangent: wrench(&arm, &tangent),
                friction: fixel.friction.clone(),
            }
        };
        fixture.fixels.iter().map(frame).collect()
    }

    /// Least and largest `c_t / c_n` of an interaction; `None` if it transmits no force.
    #[must_use]
    pub fn slopes(&self, interaction: Interaction) -> Option<[Q; 2]> {
        let Friction { static_, kinetic } = &self.friction;
        match interaction {
            Interaction::Roll | Interaction::Maintain => Some([-&static_.max, static_.max.clone()]),
            Interaction::SlideLeft => Some([-&kinetic.max, -&kinetic.min]),
            Interaction::SlideRight => Some([kinetic.min.clone(), kinetic.max.clone()]),
            Interaction::Separate | Interaction::Approach | Interaction::Unconstrained => None,
        }
    }

    /// The slopes that a contact at rest can do whatever its coefficient.
    #[must_use]
    pub fn sure_slopes(&self) -> [Q; 2] {
        [-&self.friction.static_.min, self.friction.static_.min.clone()]
    }

    /// The external wrench `-J (1, slope)` that a unit of normal force balances.
    #[must_use]
    pub fn balanced(&self, slope: &Q) -> [Q; 3] {
        std::array::from_fn(|axis| -(&self.normal[axis] + &self.tangent[axis] * slope))
    }
}

/// Wrench of the force `direction` at `arm` from the center of mass.
fn wrench(arm: &[Q; 2], direction: &[Q; 2]) -> [Q; 3] {
    [direction[0].clone(), direction[1].clone(), cross(arm, direction)]
}
