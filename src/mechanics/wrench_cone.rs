//! The wrenches that are consistent with a contact mode.

use super::contact::ContactRows;
use super::mode::Interaction;
use crate::cone::{Cone, HalfSpaces, Pair};
use crate::exact::{Int, Matrix, Overflow};

/// The cone of wrenches `g` for which `mode` has a solution, or `None` if it has none for any wrench.
///
/// With `g = M v' - J c` a mode constrains `v'` and `c` separately, so its wrenches are the Minkowski sum of
/// `M {v' : acceleration constraints}` and `-J {c : force constraints}`, both three-dimensional.
///
/// `strict_s` reads the letter `s` as `a_n > 0` (a touching contact breaks) instead of `a_n ≥ 0` (an open gap stays).
///
/// # Source
/// Balkcom & Trinkle (2002), Table 2. The paper's construction converts a cone in 2n dimensions instead (§5.6), with the
/// same result; its printed signs of S (§5.4) are exchanged: Table 2 decides.
///
/// # Cost
/// O(n²) row operations for n contacts.
///
/// # Errors
/// [`Overflow`] if a primitive row does not fit `T`.
///
/// # Panics
/// If `mode` and `contacts` differ in length.
pub fn mode_cone<T: Int>(
    contacts: &[ContactRows<T>],
    mode: &[Interaction],
    strict_s: bool,
) -> Result<Option<Cone<T>>, Overflow> {
    Cone::from_half_spaces_plus(&acceleration_system(contacts, mode, strict_s), &force_rays(contacts, mode))
}

/// The constraints of `mode` on `w = M v'`.
///
/// # Panics
/// If `mode` and `contacts` differ in length.
#[must_use]
pub fn acceleration_system<T: Int>(contacts: &[ContactRows<T>], mode: &[Interaction], strict_s: bool) -> HalfSpaces<T> {
    assert_eq!(contacts.len(), mode.len(), "a mode has one letter per contact");
    let mut system = HalfSpaces::none(3);
    for (contact, interaction) in contacts.iter().zip(mode) {
        let (normal, tangent) = (&contact.normal_acceleration, &contact.tangent_acceleration);
        match interaction {
            Interaction::Separate if strict_s => system.strict.push_negated(normal),
            Interaction::Separate => system.closed.push_negated(normal),
            Interaction::Approach => system.strict.push(normal),
            Interaction::Unconstrained => {}
            Interaction::SlideLeft => {
                system.equalities.push(normal);
                system.strict.push_negated(tangent);
            }
            Interaction::SlideRight => {
                system.equalities.push(normal);
                system.strict.push(tangent);
            }
            Interaction::Roll => {
                system.equalities.push(normal);
                system.equalities.push(tangent);
            }
            Interaction::Maintain => system.equalities.push(normal),
        }
    }
    system
}

/// The edges of `-J {c : force constraints of mode}`.
#[must_use]
pub fn force_rays<T: Int>(contacts: &[ContactRows<T>], mode: &[Interaction]) -> Matrix<T> {
    let mut rays = Matrix::new(3);
    for (contact, interaction) in contacts.iter().zip(mode) {
        let edges = match interaction {
            Interaction::Roll | Interaction::Maintain => &contact.static_forces,
            Interaction::SlideLeft => &contact.left_forces,
            Interaction::SlideRight => &contact.right_forces,
            Interaction::Separate | Interaction::Approach | Interaction::Unconstrained => continue,
        };
        edges.iter().for_each(|ray| rays.push(ray));
    }
    rays
}

/// The wrenches that contact forces balance at zero acceleration whatever the coefficients: weak stability.
///
/// # Errors
/// [`Overflow`] if a primitive row does not fit `T`.
pub fn balanced_cone<T: Int>(contacts: &[ContactRows<T>]) -> Result<Cone<T>, Overflow> {
    let rays = Matrix::from_rows(3, contacts.iter().flat_map(|contact| &contact.sure_forces));
    Pair::from_rays(rays).map(Cone::from)
}
