//! Differences and complements as disjoint convex pieces.

use super::linear::dot_sign;
use super::nnc::{Cone, HalfSpaces};
use crate::exact::{Int, Overflow};
use std::cmp::Ordering;

/// `piece \ hole` as disjoint convex cones; `[piece]` itself when the two do not meet.
///
/// # Errors
/// [`Overflow`] if a primitive row does not fit `T`.
pub fn subtract<T: Int>(piece: &Cone<T>, hole: &Cone<T>) -> Result<Vec<Cone<T>>, Overflow> {
    split(piece, &hole.half_spaces()?).map(|(_, outside)| outside)
}

/// Everything outside of all `holes`, as disjoint convex cones.
///
/// # Errors
/// [`Overflow`] if a primitive row does not fit `T`.
pub fn complement<T: Int>(ambient: usize, holes: &[Cone<T>]) -> Result<Vec<Cone<T>>, Overflow> {
    let mut pieces = vec![Cone::everything(ambient)?];
    for hole in simplest_first(holes) {
        let conditions = hole.half_spaces()?;
        let mut rest = Vec::with_capacity(pieces.len());
        for piece in pieces {
            rest.extend(split(&piece, &conditions)?.1);
        }
        pieces = rest;
    }
    Ok(pieces)
}

/// Everything outside of cones, one convex piece after the other: what [`complement`] lists, found only as
/// far as it is asked for.
pub struct Outside<T> {
    holes: Vec<HalfSpaces<T>>,
    /// Pieces, each with the number of holes that it is known to lie outside of.
    open: Vec<(Cone<T>, usize)>,
}

impl<T: Int> Outside<T> {
    /// Outside of all `holes`.
    ///
    /// # Errors
    /// [`Overflow`] if a primitive row does not fit `T`.
    pub fn of(ambient: usize, holes: &[Cone<T>]) -> Result<Self, Overflow> {
        let holes = simplest_first(holes).into_iter().map(Cone::half_spaces).collect::<Result<_, _>>()?;
        Ok(Self { holes, open: vec![(Cone::everything(ambient)?, 0)] })
    }

    /// One more piece, disjoint from all before; `None` when there are no others.
    ///
    /// # Errors
    /// [`Overflow`] if a primitive row does not fit `T`.
    pub fn next_piece(&mut self) -> Result<Option<Cone<T>>, Overflow> {
        while let Some((piece, n_left)) = self.open.pop() {
            let Some(hole) = self.holes.get(n_left) else { return Ok(Some(piece)) };
            let (_, rest) = split(&piece, hole)?;
            self.open.extend(rest.into_iter().map(|rest| (rest, n_left + 1)));
        }
        Ok(None)
    }
}

/// Simple full cones first: what half-spaces leave is small, and flat holes only cut.
fn simplest_first<T: Int>(holes: &[Cone<T>]) -> Vec<&Cone<T>> {
    let mut order: Vec<&Cone<T>> = holes.iter().collect();
    order.sort_by_key(|hole| (hole.closure().equalities().len(), hole.closure().facets().len()));
    order
}

/// The part of a cone that satisfies a system, if there is one, and the rest as disjoint convex cones.
pub type Split<T> = (Option<Cone<T>>, Vec<Cone<T>>);

/// Cuts `piece` into its part that satisfies `system` and the rest.
///
/// # Errors
/// [`Overflow`] if a primitive row does not fit `T`.
pub fn split<T: Int>(piece: &Cone<T>, system: &HalfSpaces<T>) -> Result<Split<T>, Overflow> {
    let mut cuts = Vec::new();
    for (rows, condition) in
        [(&system.equalities, Condition::On), (&system.closed, Condition::AtMost), (&system.strict, Condition::Below)]
    {
        for row in rows.rows() {
            match condition.at_a_glance(&Signs::of(row, piece)?, piece) {
                Some(true) => {}
                Some(false) => return Ok((None, vec![piece.clone()])),
                None => cuts.push((condition, row)),
            }
        }
    }
    if cuts.is_empty() {
        return Ok((Some(piece.clone()), Vec::new()));
    }
    let mut within = piece.half_spaces()?;
    let all = cuts.iter().fold(within.clone(), |system, (condition, row)| condition.added_to(system, row));
    let Some(common) = Cone::from_half_spaces(&all)? else { return Ok((None, vec![piece.clone()])) };
    let mut outside = Vec::new();
    for (condition, row) in cuts {
        for beyond in condition.denied_in(&within, row) {
            outside.extend(Cone::from_half_spaces(&beyond)?);
        }
        within = condition.added_to(within, row);
    }
    Ok((Some(common), outside))
}

/// On which sides of a hyperplane the rays lie; lines off it lie on both.
#[derive(Default)]
struct Signs {
    below: bool,
    zero: bool,
    above: bool,
}

impl Signs {
    fn of<T: Int>(row: &[T], piece: &Cone<T>) -> Result<Self, Overflow> {
        let mut signs = Self::default();
        for line in piece.closure().lines().rows() {
            if dot_sign(row, line)?.is_ne() {
                return Ok(Self { below: true, zero: true, above: true });
            }
        }
        for ray in piece.closure().rays().rows() {
            match dot_sign(row, ray)? {
                Ordering::Less => signs.below = true,
                Ordering::Equal => signs.zero = true,
                Ordering::Greater => signs.above = true,
            }
        }
        Ok(signs)
    }
}

/// A condition on `row · x`.
#[derive(Clone, Copy)]
enum Condition {
    /// `= 0`
    On,
    /// `≤ 0`
    AtMost,
    /// `< 0`
    Below,
}

impl Condition {
    fn added_to<T: Int>(self, mut system: HalfSpaces<T>, row: &[T]) -> HalfSpaces<T> {
        match self {
            Self::On => system.equalities.push(row),
            Self::AtMost => system.closed.push(row),
            Self::Below => system.strict.push(row),
        }
        system
    }

    /// The disjoint parts of `system` where the condition fails.
    fn denied_in<T: Int>(self, system: &HalfSpaces<T>, row: &[T]) -> Vec<HalfSpaces<T>> {
        let mut above = system.clone();
        match self {
            Self::Below => above.closed.push_negated(row),
            Self::AtMost | Self::On => above.strict.push_negated(row),
        }
        match self {
            Self::On => vec![above, Self::Below.added_to(system.clone(), row)],
            Self::AtMost | Self::Below => vec![above],
        }
    }

    /// Whether all of `piece` satisfies the condition (`true`) or none of it (`false`), where the signs alone show it.
    fn at_a_glance<T: Int>(self, signs: &Signs, piece: &Cone<T>) -> Option<bool> {
        // if any face is missing the lineality space is, and every point has a positive share of some ray
        let is_off = !piece.missing().is_empty() && !signs.zero;
        match self {
            Self::On if !signs.below && !signs.above => Some(true),
            Self::On => (is_off && signs.below != signs.above).then_some(false),
            Self::AtMost if !signs.above => Some(true),
            Self::AtMost => (is_off && !signs.below).then_some(false),
            Self::Below if !signs.below => Some(false),
            Self::Below => (is_off && !signs.above).then_some(true),
        }
    }
}
