//! A contact of a step: a pair of features close enough to touch.

use crate::answer::ContactName;
use crate::model::{Material, Space};

/// A pair of features with its gap and the rows of W_n, W_t and W_o.
///
/// The normal points into the body, away from the other; in the plane `t = (n_y, -n_x)`, in space `(t, o, n)` is a
/// right-handed frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact<S: Space> {
    pub name: ContactName,
    /// Signed gap Ψ_n (m): negative where the features overlap.
    pub gap: f64,
    /// Where the features meet (m, world).
    pub point: S::Vector,
    pub normal: S::Vector,
    /// Rows for the body's velocity.
    pub rows: S::Rows,
    /// Rows for the other's velocity, where the other is a body.
    pub other_rows: Option<S::Rows>,
    /// Velocity of the other's surface along t and o (m/s), where the other is an obstacle.
    pub surface: [f64; 2],
    pub material: Material,
}

impl<S: Space> Contact<S> {
    /// The bodies that it joins, each with its rows.
    pub fn sides(&self) -> impl Iterator<Item = (usize, &S::Rows)> {
        let other = self.other_rows.as_ref().map(|rows| (self.name.other, rows));
        std::iter::once((self.name.body, &self.rows)).chain(other)
    }

    /// Velocity along n, t (and o) of the body relative to the other, row `row`.
    pub fn velocity(&self, row: usize, velocities: &[S::Velocity]) -> f64 {
        let mut sum = dot(&self.rows.as_ref()[row], &velocities[self.name.body]);
        if let Some(rows) = &self.other_rows {
            sum += dot(&rows.as_ref()[row], &velocities[self.name.other]);
        }
        if row == 0 { sum } else { sum - self.surface[row - 1] }
    }
}

impl<S: Space> Contact<S> {
    /// A bound of the speeds that meet at the contact (m/s): what a slip is compared with.
    pub fn speed(&self, velocities: &[S::Velocity]) -> f64 {
        let size = |rows: &S::Rows, velocity: &S::Velocity| -> f64 {
            let tangential = rows.as_ref().iter().skip(1);
            tangential.flat_map(|row| row.as_ref().iter().zip(velocity.as_ref())).map(|(a, b)| (a * b).abs()).sum()
        };
        self.sides().map(|(body, rows)| size(rows, &velocities[body])).sum()
    }
}

/// Deepest overlap of these contacts (m), not negative.
pub(super) fn deepest<S: Space>(contacts: &[Contact<S>]) -> f64 {
    contacts.iter().map(|contact| -contact.gap).fold(0.0, f64::max)
}

/// The product of two short arrays.
pub(super) fn dot<E: AsRef<[f64]>>(a: &E, b: &E) -> f64 {
    a.as_ref().iter().zip(b.as_ref()).map(|(a, b)| a * b).sum()
}

/// Adds `factor` times `b` to `a`.
pub(super) fn add_scaled<E: AsRef<[f64]> + AsMut<[f64]>>(a: &mut E, factor: f64, b: &E) {
    for (a, b) in a.as_mut().iter_mut().zip(b.as_ref()) {
        *a += factor * b;
    }
}
