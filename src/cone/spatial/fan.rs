//! Half-planes through a common point: normals that matter only modulo an axis.

use super::{Row, row, vanishes};
use crate::exact::{Int, Matrix};
use std::cmp::Ordering::{Equal, Greater, Less};

/// The normals among many that bound what all leave of the plane across an axis.
pub(super) enum Fan {
    /// All of the plane is left.
    All,
    /// A half-plane.
    One(usize),
    /// An angle; the first normal, the second and the axis have a positive determinant.
    Two([usize; 2]),
}

impl Fan {
    /// `Err` is a normal that vanishes on all that is left, but not modulo the axis.
    pub(super) fn about<T: Int>(axis: &Row<T>, normals: &Matrix<T>) -> Result<Self, usize> {
        let mut rows = normals.rows().map(row).enumerate();
        // sides to the left and to the right of a normal v are those of axis × v
        let Some((first, mut left)) = rows.find_map(|(index, normal)| {
            let left = T::minors(axis, normal);
            (!vanishes::<T>(&left)).then_some((index, left))
        }) else {
            return Ok(Self::All);
        };
        let (mut a, mut b) = (first, first);
        let mut right = left.clone();
        for (index, normal) in rows {
            let (from_a, to_b) = (T::side(normal, &left), T::side(normal, &right).reverse());
            match (from_a, to_b) {
                (Equal, Equal) if a != b => {}
                (Equal, Equal) => {
                    if is_opposed::<T>(&left, &T::minors(axis, normal)) {
                        return Err(index);
                    }
                }
                (Greater, Less) => (b, right) = (index, T::minors(axis, normal)),
                (Less, Greater) => (a, left) = (index, T::minors(axis, normal)),
                (Less | Equal, Less) | (Less, Equal) => return Err(index),
                (Greater | Equal, Greater) | (Greater, Equal) => {}
            }
        }
        Ok(if a == b { Self::One(a) } else { Self::Two([a, b]) })
    }
}

/// Whether one of two parallel vectors is a negative multiple of the other.
fn is_opposed<T: Int>(a: &[T::Minor; 3], b: &[T::Minor; 3]) -> bool {
    let signs = a.iter().zip(b).map(|(x, y)| (T::minor_sign(x), T::minor_sign(y)));
    signs.into_iter().any(|(x, y)| x.is_ne() && x == y.reverse())
}
