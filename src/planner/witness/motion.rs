//! One motion in a contact mode: accelerations and forces that satisfy Newton's law.

use crate::answer::{ContactMotion, Motion};
use crate::cone::{HalfSpaces, summands};
use crate::exact::{Int, Matrix, Overflow, Q, dot};
use crate::mechanics::{ContactRows, Frame, Interaction, Mode, acceleration_system};
use crate::model::Part;
use num_traits::{Signed as _, Zero as _};

/// A wrench on the part, and the contacts that it may have.
pub(super) struct Pushed<'a, T> {
    pub(super) part: &'a Part,
    pub(super) frames: &'a [Frame],
    pub(super) contacts: &'a [ContactRows<T>],
    pub(super) wrench: &'a [Q; 3],
}

/// Least and largest `c_t / c_n` of each contact that may bear a force.
type Slopes = Vec<Option<[Q; 2]>>;

impl<T: Int> Pushed<'_, T> {
    /// A motion in `mode`, if the wrench is consistent with it.
    pub(super) fn motion(&self, mode: &[Interaction], strict_s: bool) -> Result<Option<Motion>, Overflow> {
        self.within(&acceleration_system(self.contacts, mode, strict_s), mode)
    }

    /// A motion with the forces of `mode` whose `M v'` satisfies `system`.
    pub(super) fn within(&self, system: &HalfSpaces<T>, mode: &[Interaction]) -> Result<Option<Motion>, Overflow> {
        let slopes = self.frames.iter().zip(mode).map(|(frame, interaction)| frame.slopes(*interaction));
        self.solution(mode, system, slopes.collect())
    }

    /// Forces of `mode` under which the part stays at rest.
    pub(super) fn rest(&self, mode: &[Interaction]) -> Result<Option<Motion>, Overflow> {
        self.within(&still(), mode)
    }

    /// Forces at all contacts, at their least static friction, under which the part stays at rest.
    pub(super) fn balance(&self) -> Result<Option<Motion>, Overflow> {
        let slopes = self.frames.iter().map(|frame| Some(frame.sure_slopes())).collect();
        self.solution(&vec![Interaction::Roll; self.frames.len()], &still(), slopes)
    }

    fn solution(
        &self,
        mode: &[Interaction],
        system: &HalfSpaces<T>,
        slopes: Slopes,
    ) -> Result<Option<Motion>, Overflow> {
        let edges = |(frame, slopes): (&Frame, &Option<[Q; 2]>)| {
            let slopes = slopes.iter().flatten();
            slopes.map(|slope| frame.balanced(slope).to_vec()).collect::<Vec<_>>()
        };
        let rays: Vec<Vec<Q>> = self.frames.iter().zip(&slopes).flat_map(edges).collect();
        let Some(found) = summands(system, &rays, self.wrench)? else { return Ok(None) };
        let diagonal = [&self.part.mass, &self.part.mass, &self.part.inertia];
        let acceleration: [Q; 3] = std::array::from_fn(|axis| &found.within[axis] / diagonal[axis]);
        let mut weights = found.weights.iter();
        let mut share = || weights.next().cloned().unwrap_or_default();
        let contact = |((frame, interaction), slopes): ((&Frame, &Interaction), &Option<[Q; 2]>)| {
            let mut force = [Q::zero(), Q::zero()];
            for slope in slopes.iter().flatten() {
                let share = share();
                force[1] += &share * slope;
                force[0] += share;
            }
            ContactMotion {
                acceleration: [&frame.normal, &frame.tangent].map(|column| dot(column, &acceleration)),
                friction: friction(frame, *interaction, &force),
                force,
            }
        };
        Ok(Some(Motion {
            mode: Mode(mode.to_vec()).to_string(),
            contacts: self.frames.iter().zip(mode).zip(&slopes).map(contact).collect(),
            acceleration,
        }))
    }
}

/// No acceleration.
pub(super) fn still<T: Int>() -> HalfSpaces<T> {
    HalfSpaces { equalities: Matrix::identity(3), ..HalfSpaces::none(3) }
}

/// The coefficient that bears `force`; none is needed without a force.
fn friction(frame: &Frame, interaction: Interaction, force: &[Q; 2]) -> Option<Q> {
    let [normal, tangent] = force;
    let needed = (!normal.is_zero()).then(|| tangent.abs() / normal)?;
    Some(match interaction {
        Interaction::Roll | Interaction::Maintain => needed.max(frame.friction.static_.min.clone()),
        _ => needed,
    })
}
