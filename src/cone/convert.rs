//! Conversion, redundancy and projection of polyhedra.
//!
//! A polyhedron is the slice `x0 = 1` of a cone: that of its rows together with `x0 ≥ 0`, or the one that its points and
//! rays span. Columns are reversed on the way in, so that the bases of equalities take their pivots from the last
//! variables and the row of `x0` stays what it is.

use super::bits::{BitRows, Set, count, has, intersect, is_subset};
use super::lattice::incidence;
use super::linear::{echelon, is_zero};
use super::pair::Pair;
use super::polyhedron::{Polyhedron, Representation};
use crate::exact::{Int, Ladder, Matrix, Overflow, Q, Rung, climb, primitive_row};
use num_traits::{One as _, Zero as _};
use std::collections::HashMap;

/// A polyhedron computed from another one.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Converted {
    /// The rows; linear ones come first.
    pub polyhedron: Polyhedron,
    /// Dimension of the smallest affine space around the polyhedron; `None` if it has no point.
    pub dimension: Option<usize>,
    /// For each row the rows adjacent to it, from zero: facets that share a ridge, or generators that span an edge. Edges
    /// and ridges at infinity count: two rays may be adjacent, and parallel facets that share rays. Linear rows have
    /// none.
    pub adjacency: Option<Vec<Vec<usize>>>,
    /// For each row the input rows, from zero, that it lies on.
    pub incidence: Option<Vec<Vec<usize>>>,
    /// What became of the input rows, if redundant ones were dropped.
    pub fates: Option<Fates>,
}

/// What became of the rows of the input; all counted from zero.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Fates {
    /// For each row of the output its row in the input.
    pub kept: Vec<usize>,
    /// Rows that the others imply.
    pub redundant: Vec<usize>,
    /// Rows that were not said to be linear but are: implicit equalities, rays along lines.
    pub implicit: Vec<usize>,
}

/// What is wanted besides the rows.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Extras {
    /// [`Converted::adjacency`].
    pub adjacency: bool,
    /// [`Converted::incidence`].
    pub incidence: bool,
}

/// The other representation, minimal and canonical: equal polyhedra have equal results.
///
/// Lines or equalities are a basis in reduced row echelon form with pivots from the last column on. Points precede
/// rays, both sorted. Inequalities and equalities are coprime integers. An empty polyhedron has no generators; its only
/// inequality is `-1 ≥ 0`.
#[must_use]
pub fn convert(polyhedron: &Polyhedron, extras: Extras) -> Converted {
    climb(&Job { polyhedron, side: Side::Other, extras }, Rung::Word).0
}

/// The same representation, minimal and canonical as that of [`convert`]; there is no incidence.
#[must_use]
pub fn canonical(polyhedron: &Polyhedron, extras: Extras) -> Converted {
    climb(&Job { polyhedron, side: Side::Same, extras }, Rung::Word).0
}

/// The rows of the input that are not redundant, as they stand there, linear ones first; there is no incidence.
///
/// Of equal rows, and of rows equal modulo the linear ones, the first is kept. All rows of an empty polyhedron give way
/// to its canonical form.
#[must_use]
pub fn without_redundancy(polyhedron: &Polyhedron, extras: Extras) -> Converted {
    climb(&Job { polyhedron, side: Side::Kept, extras }, Rung::Word).0
}

/// The projection to some variables, counted from zero, in their order: the representation of the input, canonical.
///
/// Inequalities are converted to generators, which lose their other variables, and back.
///
/// # Panics
/// If a variable is out of range.
#[must_use]
pub fn project(polyhedron: &Polyhedron, variables: &[usize], extras: Extras) -> Converted {
    match polyhedron.representation() {
        Representation::Generators => canonical(&polyhedron.with_variables(variables), extras),
        Representation::Inequalities => {
            let generators = convert(polyhedron, Extras::default()).polyhedron;
            convert(&generators.with_variables(variables), Extras { incidence: false, ..extras })
        }
    }
}

/// Which rows are the answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Side {
    Other,
    Same,
    Kept,
}

struct Job<'a> {
    polyhedron: &'a Polyhedron,
    side: Side,
    extras: Extras,
}

/// The cone over a polyhedron as the kernel wants it: normals of the cone, or of its polar for generators.
struct Cone<T> {
    linear: Matrix<T>,
    others: Matrix<T>,
    /// Row of the input for each of `others`; none for the row of `x0` and for an origin that goes without saying.
    sources: Vec<Option<usize>>,
}

impl<T: Int> Cone<T> {
    fn over(polyhedron: &Polyhedron) -> Result<Self, Overflow> {
        let columns = polyhedron.columns();
        let is_inequalities = polyhedron.representation() == Representation::Inequalities;
        let mut cone = Self { linear: Matrix::new(columns), others: Matrix::new(columns), sources: Vec::new() };
        for (index, row) in polyhedron.rows().iter().enumerate() {
            let row = reversed(row)?;
            if polyhedron.is_linear(index) {
                cone.linear.push(&row);
                continue;
            }
            if is_inequalities {
                cone.others.push_negated(&row)
            } else {
                cone.others.push(&row)
            }
            cone.sources.push(Some(index));
        }
        let mut unit = vec![T::default(); columns];
        unit[columns - 1] = T::unit();
        let has_no_point = polyhedron.rows().iter().all(|row| row[0].is_zero());
        if is_inequalities {
            cone.others.push_negated(&unit);
            cone.sources.push(None);
        } else if has_no_point && !polyhedron.rows().is_empty() {
            cone.others.push(&unit);
            cone.sources.push(None);
        }
        Ok(cone)
    }
}

fn reversed<T: Int>(row: &[Q]) -> Result<Vec<T>, Overflow> {
    primitive_row(row).iter().rev().map(T::from_z).collect::<Option<_>>().ok_or(Overflow)
}

impl Ladder for Job<'_> {
    type Output = Converted;

    fn run<T: Int>(&self) -> Result<Converted, Overflow> {
        let cone = Cone::<T>::over(self.polyhedron)?;
        let pair = Pair::from_normals(&cone.linear, &cone.others)?;
        let (is_empty, dimension) = match self.polyhedron.representation() {
            Representation::Inequalities => {
                let at_infinity = |ray: &[T]| ray[ray.len() - 1].sign().is_eq();
                (pair.rays().rows().all(at_infinity), pair.dim())
            }
            Representation::Generators => (self.polyhedron.rows().is_empty(), pair.ambient() - pair.lines().len()),
        };
        if is_empty {
            return Ok(self.nothing());
        }
        let mut found = match self.side {
            Side::Other => self.other_side(&cone, &pair)?,
            Side::Same => self.same_side(&pair)?,
            Side::Kept => self.kept(&cone, &pair)?,
        };
        found.dimension = Some(dimension - 1);
        Ok(found)
    }
}

impl Job<'_> {
    fn nothing(&self) -> Converted {
        let representation = self.representation();
        let columns = self.polyhedron.columns();
        let mut rows = Vec::new();
        if representation == Representation::Inequalities {
            rows.push((0..columns).map(|column| if column == 0 { -Q::one() } else { Q::zero() }).collect());
        }
        let lists = |is_wanted: bool| is_wanted.then(|| vec![Vec::new(); rows.len()]);
        Converted {
            adjacency: lists(self.extras.adjacency),
            incidence: lists(self.extras.incidence && self.side == Side::Other),
            polyhedron: Polyhedron::new(representation, columns, rows, &[]),
            dimension: None,
            fates: (self.side == Side::Kept).then(Fates::default),
        }
    }

    fn representation(&self) -> Representation {
        let given = self.polyhedron.representation();
        if self.side == Side::Other { given.other() } else { given }
    }

    fn other_side<T: Int>(&self, cone: &Cone<T>, pair: &Pair<T>) -> Result<Converted, Overflow> {
        let (order, mut converted) = self.canonical_rows(pair.lines(), pair.rays());
        let n_lines = pair.lines().len();
        if !self.extras.adjacency && !self.extras.incidence {
            return Ok(converted);
        }
        let on = incidence(pair.rays(), &cone.others)?;
        if self.extras.adjacency {
            converted.adjacency = Some(neighbors(&on, &order, n_lines, pair));
        }
        if self.extras.incidence {
            let mut lists = vec![(0..self.polyhedron.rows().len()).collect(); n_lines];
            for ray in order {
                let others = cone.sources.iter().enumerate().filter(|(row, _)| has(on.row(ray), *row));
                let others = others.filter_map(|(_, source)| *source);
                let mut list: Vec<usize> = self.polyhedron.linear().iter().copied().chain(others).collect();
                list.sort_unstable();
                lists.push(list);
            }
            converted.incidence = Some(lists);
        }
        Ok(converted)
    }

    fn same_side<T: Int>(&self, pair: &Pair<T>) -> Result<Converted, Overflow> {
        let (order, mut converted) = self.canonical_rows(pair.equalities(), pair.facets());
        if self.extras.adjacency {
            let on = incidence(pair.facets(), pair.rays())?;
            converted.adjacency = Some(neighbors(&on, &order, pair.equalities().len(), pair));
        }
        Ok(converted)
    }

    /// The rows of the answer from one side of the cone, and which of `others` each row after the linear ones is.
    fn canonical_rows<T: Int>(&self, linear: &Matrix<T>, others: &Matrix<T>) -> (Vec<usize>, Converted) {
        let representation = self.representation();
        // the kernel's normals point outward on one side, and its rays are normals of the polar on the other
        let is_negated = representation == Representation::Inequalities;
        let mut sorted: Vec<(usize, Vec<Q>)> = others.rows().map(|row| file_row(row, is_negated)).enumerate().collect();
        if representation == Representation::Generators {
            for (_, row) in &mut sorted {
                if !row[0].is_zero() {
                    let scale = row[0].clone();
                    row.iter_mut().for_each(|value| *value /= &scale);
                }
            }
            sorted.sort_by(|(_, a), (_, b)| b[0].cmp(&a[0]).then_with(|| a.cmp(b)));
        } else {
            sorted.retain(|(_, row)| row[1..].iter().any(|value| !value.is_zero()));
            sorted.sort_by(|(_, a), (_, b)| a.cmp(b));
        }
        let (order, sorted): (Vec<usize>, Vec<Vec<Q>>) = sorted.into_iter().unzip();
        let mut rows: Vec<Vec<Q>> = linear.rows().map(|row| file_row(row, false)).collect();
        rows.reverse();
        rows.extend(sorted);
        (order, self.plain(rows, linear.len()))
    }

    fn kept<T: Int>(&self, cone: &Cone<T>, pair: &Pair<T>) -> Result<Converted, Overflow> {
        let on = incidence(&cone.others, pair.rays())?;
        let facets = incidence(pair.facets(), pair.rays())?;
        let mut open: HashMap<&[u64], usize> = facets.rows().enumerate().map(|(facet, on)| (on, facet)).collect();
        if self.representation() == Representation::Inequalities {
            open.remove(on.row(cone.others.len() - 1));
        }
        let mut fates = Fates::default();
        let mut facet_rows = Vec::new();
        let mut linear: Vec<(usize, &[T])> = self.polyhedron.linear().iter().copied().zip(cone.linear.rows()).collect();
        for (row, source) in cone.sources.iter().enumerate() {
            let Some(source) = *source else { continue };
            if count(on.row(row)) == pair.rays().len() && !is_zero(cone.others.row(row)) {
                linear.push((source, cone.others.row(row)));
                fates.implicit.push(source);
            } else if let Some(facet) = open.remove(on.row(row)) {
                facet_rows.push((source, facet));
            } else {
                fates.redundant.push(source);
            }
        }
        let mut basis = echelon(&Matrix::new(cone.others.columns()))?;
        for (source, row) in linear {
            if basis.insert(row)? { &mut fates.kept } else { &mut fates.redundant }.push(source);
        }
        fates.redundant.sort_unstable();
        let mut n_linear = fates.kept.len();
        fates.kept.extend(facet_rows.iter().map(|(source, _)| *source));
        if fates.kept.is_empty() && self.representation() == Representation::Generators {
            // zero rows only: without the last of them the origin would be gone
            fates.redundant.retain(|row| *row != 0);
            fates.kept.push(0);
            n_linear = usize::from(self.polyhedron.is_linear(0));
        }
        let rows = fates.kept.iter().map(|row| self.polyhedron.rows()[*row].clone()).collect();
        let mut converted = self.plain(rows, n_linear);
        if self.extras.adjacency {
            let order: Vec<usize> = facet_rows.iter().map(|(_, facet)| *facet).collect();
            converted.adjacency = Some(neighbors(&facets, &order, fates.kept.len() - order.len(), pair));
        }
        converted.fates = Some(fates);
        Ok(converted)
    }

    fn plain(&self, rows: Vec<Vec<Q>>, n_linear: usize) -> Converted {
        let linear: Vec<usize> = (0..n_linear).collect();
        let polyhedron = Polyhedron::new(self.representation(), self.polyhedron.columns(), rows, &linear);
        Converted { polyhedron, dimension: None, adjacency: None, incidence: None, fates: None }
    }
}

fn file_row<T: Int>(row: &[T], is_negated: bool) -> Vec<Q> {
    row.iter()
        .rev()
        .map(|value| Q::from_integer(if is_negated { value.negated() } else { value.clone() }.to_z()))
        .collect()
}

/// For each row of the answer the rows adjacent to it: no third row is on everything that both are on.
///
/// `order` gives the set of each row after the linear ones; the side at infinity is no row of the answer, but in the way
/// all the same.
fn neighbors<T: Int>(on: &BitRows, order: &[usize], n_linear: usize, pair: &Pair<T>) -> Vec<Vec<usize>> {
    let needed = (pair.dim() - pair.lines().len()).saturating_sub(2);
    let mut lists = vec![Vec::new(); n_linear + order.len()];
    for (a, first) in order.iter().enumerate() {
        for (b, second) in order.iter().enumerate().skip(a + 1) {
            let common: Set = intersect(on.row(*first), on.row(*second));
            let is_between = |set: &[u64]| is_subset(&common, set);
            let others = || on.rows().enumerate().filter(|(row, _)| row != first && row != second);
            if count(&common) >= needed && !others().any(|(_, set)| is_between(set)) {
                lists[n_linear + a].push(n_linear + b);
                lists[n_linear + b].push(n_linear + a);
            }
        }
    }
    lists.iter_mut().for_each(|list| list.sort_unstable());
    lists
}
