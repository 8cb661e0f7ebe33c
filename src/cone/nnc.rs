//! Cones that need not be closed: a closed cone less some of its faces.

use super::bits::count;
use super::cut::cut_space;
use super::faces::{Summand, faces_of_strict_normals, missing_faces, rays_of_missing};
use super::lattice::incidence;
use super::linear::{dot_sign, positive_combination};
use super::pair::{Generators, Pair};
use crate::exact::{Int, Matrix, Overflow};

/// A system of linear conditions on `x`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct HalfSpaces<T> {
    /// Rows with `row · x = 0`.
    pub equalities: Matrix<T>,
    /// Rows with `row · x ≤ 0`.
    pub closed: Matrix<T>,
    /// Rows with `row · x < 0`.
    pub strict: Matrix<T>,
}

impl<T: Int> HalfSpaces<T> {
    /// No condition in a space of dimension `ambient`.
    #[must_use]
    pub fn none(ambient: usize) -> Self {
        Self { equalities: Matrix::new(ambient), closed: Matrix::new(ambient), strict: Matrix::new(ambient) }
    }

    /// All normals, strict or not: those of the closure, if anything satisfies the system.
    pub(super) fn normals(&self) -> Matrix<T> {
        let mut normals = Matrix::with_capacity(self.closed.columns(), self.closed.len() + self.strict.len());
        normals.append(&self.closed);
        normals.append(&self.strict);
        normals
    }

    /// The conditions of both.
    #[must_use]
    pub fn and(mut self, other: &Self) -> Self {
        self.equalities.append(&other.equalities);
        self.closed.append(&other.closed);
        self.strict.append(&other.strict);
        self
    }
}

/// A non-empty convex cone, not necessarily closed, in canonical form: equal sets are equal values.
///
/// The set is the closed cone [`Cone::closure`] less its missing faces. The empty set is `None` wherever a cone may be
/// empty; a cone need not contain its apex.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Cone<T> {
    closure: Pair<T>,
    missing: Vec<Vec<usize>>,
}

impl<T: Int> Cone<T> {
    /// The whole space.
    ///
    /// # Errors
    /// Never in practice; the signature is that of every construction.
    pub fn everything(ambient: usize) -> Result<Self, Overflow> {
        Ok(Pair::from_normals(&Matrix::new(ambient), &Matrix::new(ambient))?.into())
    }

    /// The set that satisfies `system`, or `None` if nothing does.
    ///
    /// # Errors
    /// [`Overflow`] if a primitive row does not fit `T`.
    pub fn from_half_spaces(system: &HalfSpaces<T>) -> Result<Option<Self>, Overflow> {
        let closure = Pair::from_normals(&system.equalities, &system.normals())?;
        let missing = faces_of_strict_normals(&closure, &system.strict)?;
        Ok(missing.map(|missing| Self { closure, missing }))
    }

    /// The closure.
    #[must_use]
    pub fn closure(&self) -> &Pair<T> {
        &self.closure
    }

    /// The missing faces, maximal ones only, each as the sorted set of facets of the closure that contain it.
    #[must_use]
    pub fn missing(&self) -> &[Vec<usize>] {
        &self.missing
    }

    /// Whether facet `facet` of the closure is missing.
    #[must_use]
    pub fn is_strict(&self, facet: usize) -> bool {
        self.missing.iter().any(|tight| tight.as_slice() == [facet])
    }

    /// Whether the set is the whole space.
    #[must_use]
    pub fn is_everything(&self) -> bool {
        self.closure.lines().len() == self.closure.ambient()
    }

    /// A system that describes the set, minimal.
    ///
    /// # Errors
    /// [`Overflow`] if the normal of a missing lower face does not fit `T`.
    pub fn half_spaces(&self) -> Result<HalfSpaces<T>, Overflow> {
        let ambient = self.closure.ambient();
        let facets = self.closure.facets();
        let mut system = HalfSpaces::none(ambient);
        system.equalities = self.closure.equalities().clone();
        for (index, normal) in facets.rows().enumerate() {
            if self.is_strict(index) { &mut system.strict } else { &mut system.closed }.push(normal);
        }
        for tight in self.missing.iter().filter(|tight| tight.len() > 1) {
            system.strict.push(&positive_combination(ambient, tight.iter().map(|facet| facets.row(*facet)))?);
        }
        Ok(system)
    }

    /// Whether `x` belongs to the set.
    ///
    /// # Errors
    /// [`Overflow`] if a dot product does not fit.
    ///
    /// # Panics
    /// If `x` has another number of coordinates than the space.
    pub fn contains(&self, x: &[T]) -> Result<bool, Overflow> {
        if !self.closure.contains(x)? {
            return Ok(false);
        }
        for tight in &self.missing {
            let mut on_face = true;
            for facet in tight {
                on_face &= dot_sign(self.closure.facets().row(*facet), x)?.is_eq();
            }
            if on_face {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// A point of the relative interior, which always belongs to the set.
    ///
    /// # Errors
    /// [`Overflow`] if the point does not fit.
    pub fn inner_point(&self) -> Result<Vec<T>, Overflow> {
        positive_combination(self.closure.ambient(), self.closure.rays().rows()).map(|point| point.to_vec())
    }

    /// The intersection, or `None` if it is empty.
    ///
    /// # Errors
    /// [`Overflow`] if a primitive row does not fit `T`.
    pub fn intersection(&self, other: &Self) -> Result<Option<Self>, Overflow> {
        Self::from_half_spaces(&self.half_spaces()?.and(&other.half_spaces()?))
    }

    /// The Minkowski sum `{x + y}`.
    ///
    /// # Errors
    /// [`Overflow`] if a primitive row does not fit `T`.
    pub fn sum(&self, other: &Self) -> Result<Self, Overflow> {
        let mut generators = self.generators();
        generators.lines.append(other.closure.lines());
        generators.rays.append(other.closure.rays());
        let closure = Pair::from_generators(&generators)?;
        Self::with_missing_of(closure, &[self.summand()?, other.summand()?])
    }

    /// The Minkowski sum of the set that satisfies `system` and the closed cone that `rays` span, or `None` if the former
    /// is empty: as [`Cone::from_half_spaces`] and [`Cone::sum`] in one, without the facets of the former.
    ///
    /// # Errors
    /// [`Overflow`] if a primitive row does not fit `T`.
    pub fn from_half_spaces_plus(system: &HalfSpaces<T>, rays: &Matrix<T>) -> Result<Option<Self>, Overflow> {
        let cut = cut_space(&system.equalities, &system.normals())?;
        let missing = incidence(&system.strict, &cut.rays)?;
        if missing.rows().any(|face| count(face) == cut.rays.len()) {
            return Ok(None);
        }
        let mut generators = Generators { lines: cut.lines, rays: cut.rays.clone() };
        generators.rays.append(rays);
        let closure = Pair::from_generators(&generators)?;
        if system.strict.is_empty() {
            return Ok(Some(closure.into()));
        }
        Self::with_missing_of(closure, &[Summand { rays: cut.rays, missing }]).map(Some)
    }

    /// The image under the linear map `x -> map · x`, one row of `map` for each coordinate of the image.
    ///
    /// # Errors
    /// [`Overflow`] if a primitive row does not fit `T`.
    pub fn image(&self, map: &Matrix<T>) -> Result<Self, Overflow> {
        let lines = mapped(self.closure.lines(), map)?;
        let rays = mapped(self.closure.rays(), map)?;
        let closure = Pair::from_generators(&Generators { lines, rays: rays.clone() })?;
        let missing = rays_of_missing(&self.closure, &self.missing)?;
        Self::with_missing_of(closure, &[Summand { rays, missing }])
    }

    fn generators(&self) -> Generators<T> {
        Generators { lines: self.closure.lines().clone(), rays: self.closure.rays().clone() }
    }

    fn summand(&self) -> Result<Summand<T>, Overflow> {
        let missing = rays_of_missing(&self.closure, &self.missing)?;
        Ok(Summand { rays: self.closure.rays().clone(), missing })
    }

    fn with_missing_of(closure: Pair<T>, summands: &[Summand<T>]) -> Result<Self, Overflow> {
        let missing = missing_faces(&closure, summands)?;
        Ok(Self { closure, missing: missing.expect("a sum of non-empty cones is not empty") })
    }
}

impl<T: Int> From<Pair<T>> for Cone<T> {
    fn from(closure: Pair<T>) -> Self {
        Self { closure, missing: Vec::new() }
    }
}

/// Each row mapped and made primitive by a positive factor of its own.
fn mapped<T: Int>(rows: &Matrix<T>, map: &Matrix<T>) -> Result<Matrix<T>, Overflow> {
    let mut out = Matrix::new(map.len());
    for row in rows.rows() {
        let image = map.rows().map(|coordinate| T::dot(coordinate, row)).collect::<Result<Vec<_>, _>>()?;
        out.push_with(|entries| T::primitive(&image, entries))?;
    }
    Ok(out)
}
