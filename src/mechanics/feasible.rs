//! The contact modes that are kinematically feasible.

use super::contact::ContactRows;
use super::mode::Interaction;
use crate::cone::{Cone, Generators, HalfSpaces, Pair};
use crate::exact::{Int, Matrix, Overflow};
use std::collections::BTreeSet;

/// All modes over `s l r n` (with `s` strict) that some acceleration of the part realises, sorted by their letters.
///
/// Read off the arrangement of the contacts: each face of the cone `a_n ≥ 0` fixes which contacts persist, and the
/// tangential accelerations of those cut the face, at most two-dimensional, into cells. That gives Θ(n) modes for
/// contacts in general position, without trying 4ⁿ.
///
/// # Source
/// Balkcom & Trinkle (2002), §7, step 1, after Mason (2001), chapter 8.
///
/// # Errors
/// [`Overflow`] if a primitive row does not fit `T`.
pub fn feasible_modes<T: Int>(contacts: &[ContactRows<T>]) -> Result<Vec<Vec<Interaction>>, Overflow> {
    let mut separating = Matrix::with_capacity(3, contacts.len());
    contacts.iter().for_each(|contact| separating.push_negated(&contact.normal_acceleration));
    let reachable = Pair::from_normals(&Matrix::new(3), &separating)?;
    let mut modes = BTreeSet::new();
    for face in reachable.faces()? {
        let rays = Matrix::from_rows(3, face.iter().map(|ray| reachable.rays().row(*ray)));
        let mut persisting = Vec::new();
        for (index, contact) in contacts.iter().enumerate() {
            if vanishes(&contact.normal_acceleration, &rays)
                && vanishes(&contact.normal_acceleration, reachable.lines())
            {
                persisting.push(index);
            }
        }
        let face = Pair::from_generators(&Generators { lines: reachable.lines().clone(), rays })?;
        for (mut mode, _) in cells(contacts, &persisting, &face)? {
            mode.iter_mut().for_each(|letter| {
                letter.get_or_insert(Interaction::Separate);
            });
            modes.insert(mode.into_iter().flatten().collect::<Vec<_>>());
        }
    }
    let mut modes: Vec<_> = modes.into_iter().collect();
    modes.sort_by_key(|mode| mode.iter().map(|i| i.letter()).collect::<String>());
    Ok(modes)
}

type Cell<T> = (Vec<Option<Interaction>>, Cone<T>);

/// The relatively open face cut into cells by the tangential accelerations of the persisting contacts.
fn cells<T: Int>(contacts: &[ContactRows<T>], persisting: &[usize], face: &Pair<T>) -> Result<Vec<Cell<T>>, Overflow> {
    let mut relative_interior = HalfSpaces::none(3);
    relative_interior.equalities = face.equalities().clone();
    relative_interior.strict = face.facets().clone();
    let whole = Cone::from_half_spaces(&relative_interior)?.expect("a face has a relative interior");
    let mut cells = vec![(vec![None; contacts.len()], whole)];
    for contact in persisting {
        let tangent = &contacts[*contact].tangent_acceleration;
        let mut finer = Vec::new();
        for (mode, cell) in &cells {
            for letter in [Interaction::SlideLeft, Interaction::SlideRight, Interaction::Roll] {
                let mut side = HalfSpaces::none(3);
                match letter {
                    Interaction::SlideLeft => side.strict.push_negated(tangent),
                    Interaction::SlideRight => side.strict.push(tangent),
                    _ => side.equalities.push(tangent),
                }
                if let Some(part) = Cone::from_half_spaces(&cell.half_spaces()?.and(&side))? {
                    let mut mode = mode.clone();
                    mode[*contact] = Some(letter);
                    finer.push((mode, part));
                }
            }
        }
        cells = finer;
    }
    Ok(cells)
}

fn vanishes<T: Int>(row: &[T], on: &Matrix<T>) -> bool {
    let row = spatial(row);
    on.rows().all(|vector| T::side_of(row, spatial(vector)).is_eq())
}

fn spatial<T>(row: &[T]) -> &[T; 3] {
    row.try_into().expect("wrenches have three components")
}
