//! Closed cones in both forms, minimal and canonical.

use super::bits::has;
use super::cut::cut_space;
use super::lattice::{all_faces, incidence};
use super::linear::dot_sign;
use crate::exact::{Int, Matrix, Overflow};

/// A closed polyhedral cone by its face normals and by its generators, both minimal and canonical.
///
/// Equal cones are equal values: equalities and lines are bases in reduced row echelon form with positive pivots,
/// facet normals are zero in the pivot columns of the equalities and rays in those of the lines, all rows are coprime,
/// normals and rays are sorted.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Pair<T> {
    equalities: Matrix<T>,
    facets: Matrix<T>,
    lines: Matrix<T>,
    rays: Matrix<T>,
}

/// Span form of a cone: all `L y + R z` with `z ≥ 0`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Generators<T> {
    /// Lines, one a row.
    pub lines: Matrix<T>,
    /// Rays, one a row.
    pub rays: Matrix<T>,
}

impl<T: Int> Pair<T> {
    /// The cone `{x : equalities · x = 0, normals · x ≤ 0}`.
    ///
    /// # Errors
    /// [`Overflow`] if a primitive row does not fit `T`.
    pub fn from_normals(equalities: &Matrix<T>, normals: &Matrix<T>) -> Result<Self, Overflow> {
        let cut = cut_space(equalities, normals)?;
        let (facets, rays) = (sorted(cut.facets), sorted(cut.rays));
        Ok(Self { equalities: cut.equalities, facets, lines: cut.lines, rays })
    }

    /// The cone that `generators` span.
    ///
    /// # Errors
    /// [`Overflow`] if a primitive row does not fit `T`.
    pub fn from_generators(generators: &Generators<T>) -> Result<Self, Overflow> {
        Self::from_normals(&generators.lines, &generators.rays).map(Self::into_polar)
    }

    /// The cone that rays alone span.
    ///
    /// # Errors
    /// [`Overflow`] if a primitive row does not fit `T`.
    pub fn from_rays(rays: Matrix<T>) -> Result<Self, Overflow> {
        Self::from_generators(&Generators { lines: Matrix::new(rays.columns()), rays })
    }

    /// The polar cone `{h : h · x ≤ 0 for all x in the cone}`: the two forms change places.
    #[must_use]
    pub fn into_polar(self) -> Self {
        Self { equalities: self.lines, facets: self.rays, lines: self.equalities, rays: self.facets }
    }

    /// Dimension of the space around the cone.
    #[must_use]
    pub fn ambient(&self) -> usize {
        self.facets.columns()
    }

    /// Dimension of the cone's span.
    #[must_use]
    pub fn dim(&self) -> usize {
        self.ambient() - self.equalities.len()
    }

    /// Basis of the orthogonal complement of the span.
    #[must_use]
    pub fn equalities(&self) -> &Matrix<T> {
        &self.equalities
    }

    /// Outward facet normals: `normal · x ≤ 0`.
    #[must_use]
    pub fn facets(&self) -> &Matrix<T> {
        &self.facets
    }

    /// Basis of the lineality space.
    #[must_use]
    pub fn lines(&self) -> &Matrix<T> {
        &self.lines
    }

    /// Extreme rays modulo the lines.
    #[must_use]
    pub fn rays(&self) -> &Matrix<T> {
        &self.rays
    }

    /// All faces, the cone itself included, each as the indices of its rays (the lines belong to every face).
    ///
    /// # Errors
    /// [`Overflow`] if a dot product does not fit.
    pub fn faces(&self) -> Result<Vec<Vec<usize>>, Overflow> {
        let n_rays = self.rays.len();
        let on = incidence(&self.facets, &self.rays)?;
        let faces = all_faces(&on, n_rays);
        Ok(faces.iter().map(|face| (0..n_rays).filter(|ray| has(face, *ray)).collect()).collect())
    }

    /// Whether `x` satisfies all equalities and facets.
    ///
    /// # Errors
    /// [`Overflow`] if a dot product does not fit.
    ///
    /// # Panics
    /// If `x` has another number of coordinates than the space.
    pub fn contains(&self, x: &[T]) -> Result<bool, Overflow> {
        assert_eq!(x.len(), self.ambient(), "a point has as many coordinates as the space");
        for equality in self.equalities.rows() {
            if dot_sign(equality, x)?.is_ne() {
                return Ok(false);
            }
        }
        for facet in self.facets.rows() {
            if dot_sign(facet, x)?.is_gt() {
                return Ok(false);
            }
        }
        Ok(true)
    }
}

fn sorted<T: Int>(matrix: Matrix<T>) -> Matrix<T> {
    if matrix.rows().is_sorted() {
        return matrix;
    }
    let mut rows: Vec<&[T]> = matrix.rows().collect();
    rows.sort_unstable();
    Matrix::from_rows(matrix.columns(), rows)
}
