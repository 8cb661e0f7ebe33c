//! The double description method in any dimension.

use super::adjacent::adjacent_pairs;
use super::bits::BitRows;
use super::linear::crossing;
use crate::exact::{Int, Matrix, Overflow};
use std::cmp::Ordering;

/// A simplicial cone cut by the normals `basis`: ray `i` lies on all of them but the `i`-th.
#[derive(Clone)]
pub(super) struct Simplex<T> {
    pub(super) rays: Matrix<T>,
    pub(super) basis: Vec<usize>,
}

/// The extreme rays of a pointed cone, and which of its normals matter.
pub(super) struct Faces<T> {
    /// Indices of normals that vanish on all rays: enough of them to span the complement of the cone.
    pub(super) flat: Vec<usize>,
    /// One index of a normal for each facet.
    pub(super) facets: Vec<usize>,
    pub(super) rays: Matrix<T>,
}

/// Extreme rays of a cone, and which of the normals that cut it they lie on.
pub(super) struct Description<T: Int> {
    pub(super) rays: Matrix<T>,
    /// The normals that cut something off when it was their turn, all facets among them and all that the cone's span
    /// takes.
    pub(super) cuts: Vec<usize>,
    /// For each ray the members of `cuts`, by their places in it, that it lies on.
    pub(super) on: BitRows,
    /// How much it took: words of the sets of pairs of rays looked at, and [`COMBINED`] for each entry of a ray computed.
    pub(super) effort: u64,
    /// Normals that adjacent rays have in common at least.
    needed: usize,
    step: Step<T>,
}

/// Effort of computing an entry of a ray, in words looked at.
const COMBINED: usize = 16;

/// Why a cone was not described.
pub(super) enum Stop {
    /// A primitive row does not fit the integers in use.
    Overflow,
    /// It would take more effort than allowed.
    Effort,
}

impl From<Overflow> for Stop {
    fn from(_: Overflow) -> Self {
        Self::Overflow
    }
}

impl<T: Int> Description<T> {
    /// Of a simplicial cone.
    pub(super) fn of(start: Simplex<T>) -> Self {
        let Simplex { rays, basis } = start;
        let mut on = BitRows::new(basis.len());
        for own in 0..basis.len() {
            on.push(basis.len(), |cut| cut != own);
        }
        let needed = basis.len().saturating_sub(2);
        let step = Step::new(rays.columns());
        Self { rays, cuts: basis, on, effort: 0, needed, step }
    }

    /// Cuts the cone by a normal that is not zero and has the index `row`.
    ///
    /// A normal that leaves a face only, so that the cone has no longer full dimension, is a cut as any other: the count of
    /// common normals that adjacent rays need does not depend on it, since those that vanish on all rays are among them.
    ///
    /// # Errors
    /// [`Stop::Effort`], with nothing but the effort changed, if that is to exceed `allowed`; [`Stop::Overflow`].
    pub(super) fn cut(&mut self, row: usize, normal: &[T], allowed: u64) -> Result<(), Stop> {
        let step = &mut self.step;
        step.sort(normal, &self.rays)?;
        if step.outside.is_empty() {
            return Ok(());
        }
        let compared = (step.inside.len() * step.outside.len() + self.rays.len()) * self.on.words();
        let effort = self.effort + compared as u64;
        if effort > allowed {
            return Err(Stop::Effort);
        }
        let cut = self.cuts.len();
        self.cuts.push(row);
        self.on.widen(self.cuts.len());
        step.level.iter().for_each(|ray| self.on.insert(*ray, cut));
        step.cross(&self.rays, &self.on, cut, self.needed)?;
        self.effort = effort + (COMBINED * step.fresh.len() * normal.len()) as u64;
        step.replace(&mut self.rays, &mut self.on);
        Ok(())
    }
}

/// Cuts a simplicial cone by the other normals in their order, none of them zero. When its effort is to exceed `allowed`,
/// `allow` gives a new limit for what it took so far or ends it.
///
/// # Errors
/// [`Stop`], for any of its reasons.
pub(super) fn describe<T: Int>(
    start: Simplex<T>,
    normals: &Matrix<T>,
    mut allowed: u64,
    allow: &mut dyn FnMut(u64) -> Result<u64, Stop>,
) -> Result<Description<T>, Stop> {
    let is_basis = marked(normals.len(), &start.basis);
    let mut found = Description::of(start);
    for row in (0..normals.len()).filter(|row| !is_basis[*row]) {
        loop {
            match found.cut(row, normals.row(row), allowed) {
                Err(Stop::Effort) => allowed = allow(allowed)?,
                done => break done?,
            }
        }
    }
    Ok(found)
}

fn marked(universe: usize, members: &[usize]) -> Vec<bool> {
    let mut is_marked = vec![false; universe];
    members.iter().for_each(|member| is_marked[*member] = true);
    is_marked
}

/// What one cut needs, kept for the next.
struct Step<T: Int> {
    products: Vec<T::Wide>,
    inside: Vec<usize>,
    level: Vec<usize>,
    outside: Vec<usize>,
    pairs: Vec<(usize, usize)>,
    fresh: Matrix<T>,
    fresh_on: BitRows,
}

impl<T: Int> Step<T> {
    fn new(columns: usize) -> Self {
        Self {
            products: Vec::new(),
            inside: Vec::new(),
            level: Vec::new(),
            outside: Vec::new(),
            pairs: Vec::new(),
            fresh: Matrix::new(columns),
            fresh_on: BitRows::new(0),
        }
    }

    fn sort(&mut self, normal: &[T], rays: &Matrix<T>) -> Result<(), Overflow> {
        self.products.clear();
        [&mut self.inside, &mut self.level, &mut self.outside].into_iter().for_each(Vec::clear);
        for (index, ray) in rays.rows().enumerate() {
            let product = T::dot(normal, ray)?;
            match T::wide_sign(&product) {
                Ordering::Less => self.inside.push(index),
                Ordering::Equal => self.level.push(index),
                Ordering::Greater => self.outside.push(index),
            }
            self.products.push(product);
        }
        Ok(())
    }

    /// The rays where edges from inside to outside pierce the hyperplane of the normal `cut`.
    fn cross(&mut self, rays: &Matrix<T>, on: &BitRows, cut: usize, needed: usize) -> Result<(), Overflow> {
        self.pairs.clear();
        adjacent_pairs(on, &self.inside, &self.outside, needed, &mut self.pairs);
        self.fresh.clear();
        self.fresh_on.clear();
        self.fresh_on.widen(on.words() * 64);
        for (inside, outside) in self.pairs.iter().copied() {
            let (depth, height) = (&self.products[inside], &self.products[outside]);
            crossing(rays, inside, depth, outside, height, &mut self.fresh)?;
            self.fresh_on.push_words(on.row(inside).iter().zip(on.row(outside)).map(|(a, b)| a & b));
            self.fresh_on.insert(self.fresh.len() - 1, cut);
        }
        Ok(())
    }

    /// Puts the new rays in the places of those outside.
    fn replace(&mut self, rays: &mut Matrix<T>, on: &mut BitRows) {
        let n_fresh = self.fresh.len();
        let n_reused = n_fresh.min(self.outside.len());
        for (new, old) in self.outside[..n_reused].iter().copied().enumerate() {
            rays.row_mut(old).swap_with_slice(self.fresh.row_mut(new));
            on.set_row(old, self.fresh_on.row(new));
        }
        for new in n_reused..n_fresh {
            rays.push(self.fresh.row(new));
            on.push_words(self.fresh_on.row(new).iter().copied());
        }
        for old in self.outside[n_reused..].iter().rev().copied() {
            rays.swap_remove(old);
            on.swap_remove(old);
        }
    }
}
