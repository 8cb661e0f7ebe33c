//! The data that a contact problem is made of, and **M** from them, in doubles and exactly.

use super::{ExactLcp, LcpError};
use crate::exact::{Q, from_float_exact};
use num_traits::{One as _, Zero as _};

/// A time step with contacts as Stewart and Trinkle state it: what **M** and `q` are made of.
///
/// `z = (p_n, p_f, β)`: normal impulses (`n_c`), friction impulses (`n_l` for each contact, contact by contact; planar: `+t`,
/// then `-t`), and the slip bounds (`n_c`). Without friction directions `z = p_n` and `mu` is not read.
///
/// | field | shape | unit |
/// |---|---|---|
/// | `jacobian` | (`n_c` + `n_c n_l`) × `n_v`, row-major | –, m: rows of `W_nᵀ`, then of `W_fᵀ` contact by contact |
/// | `inverse_mass` | `n_v` | 1/kg, 1/(kg m²): the diagonal of the inverse mass matrix |
/// | `mu` | `n_c` | – |
/// | `directions` | `n_l` | – |
/// | `q` | n | m/s, 0 for β |
///
/// # Source
/// Song, Pang and Kumar (2004), eqs. (10)-(13). Deviation: the paper gives `U` the structure of `E`; it is
/// `diag(mu)`, `n_c × n_c`.
#[derive(Debug, Clone, Copy)]
pub struct Factors<'a> {
    /// Rows of `W_nᵀ`, then of `W_fᵀ`.
    pub jacobian: &'a [f64],
    /// Diagonal of the inverse of the mass matrix.
    pub inverse_mass: &'a [f64],
    /// Coefficient of friction of each contact.
    pub mu: &'a [f64],
    /// Friction directions for each contact.
    pub directions: usize,
    /// The right side, one entry for each variable.
    pub q: &'a [f64],
}

impl Factors<'_> {
    /// Number of contacts.
    #[must_use]
    pub fn contacts(&self) -> usize {
        if self.directions == 0 { self.q.len() } else { self.q.len() / self.directions.saturating_add(2) }
    }

    /// Number of impulses, normal and tangential.
    #[must_use]
    pub fn impulses(&self) -> usize {
        self.contacts().saturating_mul(self.directions.saturating_add(1))
    }

    /// Whether the lengths fit each other and all entries are finite.
    ///
    /// # Errors
    /// [`LcpError`] says what is wrong.
    pub fn check(&self) -> Result<(), LcpError> {
        let contacts = self.contacts();
        let needed = |what, found, expected| {
            if found == expected { Ok(()) } else { Err(LcpError::Factor { what, found, expected }) }
        };
        if self.directions > 0 {
            needed("q", self.q.len(), contacts.saturating_mul(self.directions.saturating_add(2)))?;
            needed("mu", self.mu.len(), contacts)?;
        }
        needed("the jacobian", self.jacobian.len(), self.impulses().saturating_mul(self.inverse_mass.len()))?;
        let mut all = self.jacobian.iter().chain(self.inverse_mass).chain(self.mu).chain(self.q);
        if all.all(|value| value.is_finite()) { Ok(()) } else { Err(LcpError::NotFinite) }
    }

    /// Writes **M** (n × n, row-major) in doubles into `m`, which keeps its place.
    ///
    /// The product of two rows is the same number in both triangles, and opposite directions give opposite numbers.
    ///
    /// # Errors
    /// [`LcpError`] if the factors do not fit each other or are not finite.
    pub fn assemble(&self, m: &mut Vec<f64>) -> Result<(), LcpError> {
        self.check()?;
        let (n, impulses, velocities) = (self.q.len(), self.impulses(), self.inverse_mass.len());
        m.clear();
        m.resize(n * n, 0.0);
        let row = |index: usize| &self.jacobian[index * velocities..(index + 1) * velocities];
        for i in 0..impulses {
            for j in 0..=i {
                let terms = row(i).iter().zip(row(j)).zip(self.inverse_mass);
                let entry = terms.fold(0.0, |sum, ((a, b), inverse)| sum + a * b * inverse);
                m[i * n + j] = entry;
                m[j * n + i] = entry;
            }
        }
        self.for_each_cone_entry(|row, column, entry| m[row * n + column] = entry);
        Ok(())
    }

    /// The problem as it is, without rounding: all doubles are read as the dyadic rationals that they are.
    ///
    /// # Errors
    /// [`LcpError`] if the factors do not fit each other or are not finite.
    pub fn to_exact(&self) -> Result<ExactLcp, LcpError> {
        self.check()?;
        let (n, impulses, velocities) = (self.q.len(), self.impulses(), self.inverse_mass.len());
        let jacobian = exact(self.jacobian)?;
        let weighted = self.weighted(&jacobian)?;
        let mut m = vec![vec![Q::zero(); n]; n];
        let row = |index: usize| index * velocities..(index + 1) * velocities;
        for (i, j) in (0..impulses).flat_map(|i| (0..=i).map(move |j| (i, j))) {
            let entry = product(&jacobian[row(i)], &weighted[row(j)]);
            m[j][i] = entry.clone();
            m[i][j] = entry;
        }
        let mut entries = Vec::new();
        self.for_each_cone_entry(|row, column, entry| entries.push((row, column, entry)));
        for (row, column, entry) in entries {
            m[row][column] = from_float_exact(entry).ok_or(LcpError::NotFinite)?;
        }
        ExactLcp::new(m, exact(self.q)?)
    }

    /// The change of the velocities for each unit of each variable: `𝐌⁻¹ [W_n W_f 0]`, `n_v × n`.
    ///
    /// # Errors
    /// [`LcpError`] if the factors do not fit each other or are not finite.
    pub fn velocity_map(&self) -> Result<Vec<Vec<Q>>, LcpError> {
        self.check()?;
        let velocities = self.inverse_mass.len();
        let weighted = self.weighted(&exact(self.jacobian)?)?;
        let mut map = vec![vec![Q::zero(); self.q.len()]; velocities];
        for (index, entry) in weighted.into_iter().enumerate() {
            map[index % velocities][index / velocities] = entry;
        }
        Ok(map)
    }

    /// Each row of the jacobian times the inverse masses.
    fn weighted(&self, jacobian: &[Q]) -> Result<Vec<Q>, LcpError> {
        let inverse = exact(self.inverse_mass)?;
        Ok(jacobian.iter().zip(inverse.iter().cycle()).map(|(entry, by)| entry * by).collect())
    }

    /// `E` in the rows of the friction impulses, `U` and `-Eᵀ` in those of the slip bounds.
    fn for_each_cone_entry(&self, mut write: impl FnMut(usize, usize, f64)) {
        if self.directions == 0 {
            return;
        }
        let contacts = self.contacts();
        for (contact, mu) in self.mu.iter().enumerate() {
            let bound = self.impulses() + contact;
            write(bound, contact, *mu);
            for direction in 0..self.directions {
                let friction = contacts + contact * self.directions + direction;
                write(friction, bound, 1.0);
                write(bound, friction, -1.0);
            }
        }
    }
}

fn product(a: &[Q], b: &[Q]) -> Q {
    a.iter().zip(b).filter(|(x, y)| !x.is_zero() && !y.is_zero()).map(|(x, y)| x * y).sum()
}

/// The doubles as rationals.
pub(super) fn exact(values: &[f64]) -> Result<Vec<Q>, LcpError> {
    let read = |value: &f64| match *value {
        0.0 => Some(Q::zero()),
        1.0 => Some(Q::one()),
        other => from_float_exact(other),
    };
    values.iter().map(|value| read(value).ok_or(LcpError::NotFinite)).collect()
}
