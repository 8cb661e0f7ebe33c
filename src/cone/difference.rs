//! Differences and complements as disjoint convex pieces.

use super::nnc::{Cone, HalfSpaces};
use crate::exact::{Int, Overflow};

/// `piece \ hole` as disjoint convex cones; `[piece]` itself when the two do not meet.
///
/// # Errors
/// [`Overflow`] if a primitive row does not fit `T`.
pub fn subtract<T: Int>(piece: &Cone<T>, hole: &Cone<T>) -> Result<Vec<Cone<T>>, Overflow> {
    if piece.intersection(hole)?.is_none() {
        return Ok(vec![piece.clone()]);
    }
    let ambient = piece.closure().ambient();
    let mut pieces = Vec::new();
    let mut inside = piece.half_spaces()?;
    let mut split = |outside: Vec<Bound>, within: Bound, row: &[T]| -> Result<(), Overflow> {
        for bound in outside {
            let beyond = inside.clone().and(&bound.system(ambient, row));
            pieces.extend(Cone::from_half_spaces(&beyond)?);
        }
        inside = std::mem::replace(&mut inside, HalfSpaces::none(ambient)).and(&within.system(ambient, row));
        Ok(())
    };
    let conditions = hole.half_spaces()?;
    for row in conditions.equalities.rows() {
        split(vec![Bound::Above, Bound::Below], Bound::On, row)?;
    }
    for row in conditions.closed.rows() {
        split(vec![Bound::Above], Bound::AtMost, row)?;
    }
    for row in conditions.strict.rows() {
        split(vec![Bound::AtLeast], Bound::Below, row)?;
    }
    Ok(pieces)
}

/// Everything outside of all `holes`, as disjoint convex cones.
///
/// # Errors
/// [`Overflow`] if a primitive row does not fit `T`.
pub fn complement<T: Int>(ambient: usize, holes: &[Cone<T>]) -> Result<Vec<Cone<T>>, Overflow> {
    let mut pieces = vec![Cone::everything(ambient)?];
    for hole in holes {
        let mut rest = Vec::with_capacity(pieces.len());
        for piece in &pieces {
            rest.extend(subtract(piece, hole)?);
        }
        pieces = rest;
    }
    Ok(pieces)
}

/// Which side of the hyperplane `row · x = 0`.
#[derive(Clone, Copy)]
enum Bound {
    Below,
    AtMost,
    On,
    AtLeast,
    Above,
}

impl Bound {
    fn system<T: Int>(self, ambient: usize, row: &[T]) -> HalfSpaces<T> {
        let mut system = HalfSpaces::none(ambient);
        match self {
            Self::Below => system.strict.push(row),
            Self::AtMost => system.closed.push(row),
            Self::On => system.equalities.push(row),
            Self::AtLeast => system.closed.push_negated(row),
            Self::Above => system.strict.push_negated(row),
        }
        system
    }
}
