//! Both forms of `{x : E x = 0, H x ≤ 0}` by cutting one half-space after the other (double description).

use super::describe::{Faces, Simplex, Stop, describe};
use super::frame::Frame;
use super::lattice::flat_and_facets;
use super::linear::{Echelon, echelon, is_zero, negate};
use super::primal_dual::PrimalDual;
use super::spatial::faces;
use crate::exact::{Entries, Int, Matrix, Overflow};
use std::cmp::Ordering;

/// A cone by its face normals and by its generators: canonical, except that facets and rays are in any order.
pub(super) struct Cut<T> {
    pub(super) equalities: Matrix<T>,
    pub(super) facets: Matrix<T>,
    pub(super) lines: Matrix<T>,
    pub(super) rays: Matrix<T>,
}

/// Cuts the space by all equalities and normals.
///
/// Equalities and lines are taken out first, which leaves a pointed cone of full dimension `r` in coordinates of its own
/// ([`Frame`]). Normals cut it in lexicographic order of their magnitudes, whatever their order in the input. The first
/// `r` independent ones make a simplicial cone. For `r = 3` its rays form a cycle that each further normal clips, without
/// any adjacency test; otherwise two rays are adjacent iff no third lies on all normals that both lie on. Where that takes
/// long, few rays behind many normals are found by the primal-dual method.
///
/// # Cost
/// `r = 3`: O(m k) for m normals and k rays. Otherwise O(m k³) words in the worst case, O(m k²) when few pairs survive
/// the count of common normals.
///
/// # Errors
/// [`Overflow`] if a primitive row does not fit `T`.
pub(super) fn cut_space<T: Int>(equalities: &Matrix<T>, normals: &Matrix<T>) -> Result<Cut<T>, Overflow> {
    let mut equalities = echelon(equalities)?;
    let normals = distinct(&equalities, normals)?;
    let (lines, Faces { flat, facets, rays }) = lines_and_faces(&equalities, &normals)?;
    let chosen = |rows: Vec<usize>| Matrix::from_rows(normals.columns(), rows.into_iter().map(|row| normals.row(row)));
    let mut facets = chosen(facets);
    if !flat.is_empty() {
        // one ray or two are independent
        let span = if rays.len() < 3 { rays.len() } else { 0 } + lines.len();
        for row in flat {
            if equalities.rows.len() + span == normals.columns() {
                break;
            }
            equalities.insert(normals.row(row))?;
        }
        equalities.reduce_all(&mut facets)?;
    }
    Ok(Cut { equalities: equalities.rows, facets, lines, rays })
}

/// The normals modulo the equalities in lexicographic order of their magnitudes; zero rows and repetitions are left out.
fn distinct<T: Int>(equalities: &Echelon<T>, normals: &Matrix<T>) -> Result<Matrix<T>, Overflow> {
    let mut reduced = normals.clone();
    equalities.reduce_all(&mut reduced)?;
    let mut sorted: Vec<&[T]> = reduced.rows().filter(|row| !is_zero(row)).collect();
    sorted.sort_unstable_by(|a, b| {
        let mut magnitudes = a.iter().zip(*b).map(|(x, y)| by_magnitude(x, y));
        magnitudes.find(|order| order.is_ne()).unwrap_or_else(|| a.cmp(b))
    });
    sorted.dedup();
    Ok(Matrix::from_rows(normals.columns(), sorted))
}

fn by_magnitude<T: Int>(a: &T, b: &T) -> Ordering {
    match (a.sign().is_lt(), b.sign().is_lt()) {
        (false, false) => a.cmp(b),
        (true, true) => b.cmp(a),
        (true, false) => a.negated().cmp(b),
        (false, true) => a.cmp(&b.negated()),
    }
}

fn lines_and_faces<T: Int>(equalities: &Echelon<T>, rows: &Matrix<T>) -> Result<(Matrix<T>, Faces<T>), Overflow> {
    let outer = Frame::without_pivots(equalities);
    let normals = outer.restricted(rows);
    let Start { lines, rays, basis } = absorb_lines(&normals)?;
    if lines.pivots.is_empty() {
        let mut faces = pointed_faces(&normals, Simplex { rays, basis })?;
        faces.rays = outer.lifted(&faces.rays)?;
        return Ok((Matrix::new(rows.columns()), faces));
    }
    let inner = Frame::without_pivots(&lines);
    let start = Simplex { rays: inner.restricted(&rays), basis };
    let mut faces = pointed_faces(&inner.restricted(&normals), start)?;
    faces.rays = inner.padded(&faces.rays);
    if equalities.pivots.is_empty() {
        return Ok((lines.rows, faces));
    }
    let lines = echelon(&outer.lifted(&lines.rows)?)?;
    faces.rays = outer.lifted(&faces.rays)?;
    lines.reduce_all(&mut faces.rays)?;
    Ok((lines.rows, faces))
}

/// Effort after which the primal-dual method is tried as well, each time for as much as double description has taken.
const EASY: u64 = 1 << 18;

/// Of the cone of normals of full rank: by double description, unless that takes long and the primal-dual method ends with
/// far less effort.
///
/// The choice depends on counts alone, so that it is the same in every run. Between them the two take
/// no more than about three times the effort of double description.
fn pointed_faces<T: Int>(normals: &Matrix<T>, start: Simplex<T>) -> Result<Faces<T>, Overflow> {
    if start.basis.len() == 3 {
        return faces(normals);
    }
    let may_have_few_rays = start.basis.len() > 3;
    let mut other: Option<Option<PrimalDual<T>>> = None;
    let mut answer = None;
    let found = describe(start, normals, EASY, &mut |allowed| {
        if may_have_few_rays {
            let other = match &mut other {
                Some(other) => other,
                None => other.insert(PrimalDual::new(normals)?),
            };
            if let Some(other) = other {
                answer = other.run(allowed)?;
            }
        }
        if answer.is_some() { Err(Stop::Effort) } else { Ok(2 * allowed) }
    });
    let found = match found {
        Ok(found) => found,
        Err(Stop::Overflow) => return Err(Overflow),
        Err(Stop::Effort) => return Ok(answer.expect("effort is limited only by an answer")),
    };
    let (flat, facets) = flat_and_facets(&found.on.transposed(found.cuts.len()), found.rays.len());
    let [flat, facets] = [flat, facets].map(|places| places.into_iter().map(|cut| found.cuts[cut]).collect());
    Ok(Faces { flat, facets, rays: found.rays })
}

/// A simplicial cone (modulo lines) cut by the normals `basis`: ray `i` lies on all of them but the `i`-th.
pub(super) struct Start<T> {
    pub(super) lines: Echelon<T>,
    /// Zero in the pivot columns of the lines.
    pub(super) rays: Matrix<T>,
    pub(super) basis: Vec<usize>,
}

/// Starts from the whole space; each normal not constant on the lines left turns one line into a ray.
///
/// The lines are the unit vectors at first, and it is always the last of those with a choice that is taken. So a line has
/// zeros before its own column and in those of all other lines left, and a ray has them in the columns of all lines left.
pub(super) fn absorb_lines<T: Int>(normals: &Matrix<T>) -> Result<Start<T>, Overflow> {
    let dim = normals.columns();
    let mut lines = Matrix::identity(dim);
    let mut pivots: Vec<usize> = (0..dim).collect();
    let mut scratch = Entries::new();
    let mut rays = Matrix::with_capacity(dim, dim);
    let mut basis = Vec::with_capacity(dim);
    for (row, normal) in normals.rows().enumerate() {
        if lines.is_empty() {
            break;
        }
        if let Some((line, inside)) = absorb(&mut lines, normal, &mut scratch)? {
            pivots.remove(line);
            flatten(&mut rays, &inside, normal, &mut scratch)?;
            rays.push(&inside);
            basis.push(row);
        }
    }
    Ok(Start { lines: Echelon { rows: lines, pivots }, rays, basis })
}

/// Takes the last line off the hyperplane of `normal` out, moves the others onto it, and returns the one taken, pointing to the
/// side `normal · x < 0`, with its index; `None` if all lines are on the hyperplane.
pub(super) fn absorb<T: Int>(
    lines: &mut Matrix<T>,
    normal: &[T],
    scratch: &mut Entries<T>,
) -> Result<Option<(usize, Entries<T>)>, Overflow> {
    for index in (0..lines.len()).rev() {
        let side = T::wide_sign(&T::dot(normal, lines.row(index))?);
        if side.is_eq() {
            continue;
        }
        let mut inside = lines.remove(index);
        if side.is_gt() {
            negate(&mut inside);
        }
        flatten(lines, &inside, normal, scratch)?;
        return Ok(Some((index, inside)));
    }
    Ok(None)
}

/// Moves each row along the line `inside` onto the hyperplane of `normal`.
pub(super) fn flatten<T: Int>(
    rows: &mut Matrix<T>,
    inside: &[T],
    normal: &[T],
    scratch: &mut Entries<T>,
) -> Result<(), Overflow> {
    let depth = T::wide_negated(&T::dot(normal, inside)?);
    for index in 0..rows.len() {
        let product = T::dot(normal, rows.row(index))?;
        if T::wide_sign(&product).is_ne() {
            scratch.clear();
            T::combine(&depth, rows.row(index), &product, inside, scratch)?;
            rows.row_mut(index).clone_from_slice(scratch);
        }
    }
    Ok(())
}
