//! Which directions of a plane of wrenches lie in a set: arcs between exact directions.

use crate::cone::HalfSpaces;
use crate::exact::{Entries, Int, Overflow};
use std::cmp::Ordering;

/// A union of cones seen from a plane: it holds the direction `d` if one of them holds `map · d`.
pub(super) struct PlanarSet<T> {
    parts: Vec<PlanarCone<T>>,
}

/// The conditions of one cone on directions of the plane.
struct PlanarCone<T> {
    conditions: Vec<(Ordering, bool, [T; 2])>,
}

/// Runs of directions that belong to a set.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Run<T> {
    pub(super) from: [T; 2],
    pub(super) to: [T; 2],
    pub(super) closed: [bool; 2],
}

impl<T: Int> PlanarSet<T> {
    pub(super) fn of(cells: &[HalfSpaces<T>], map: &[Vec<T>; 2]) -> Result<Self, Overflow> {
        Ok(Self { parts: cells.iter().map(|cell| PlanarCone::of(cell, map)).collect::<Result<_, _>>()? })
    }

    fn holds(&self, direction: &[T; 2]) -> Result<bool, Overflow> {
        for part in &self.parts {
            if part.holds(direction)? {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Directions where membership may change: both directions of every boundary line.
    fn breaks(&self) -> Vec<[T; 2]> {
        let mut breaks = Vec::new();
        for (_, _, [a, b]) in self.parts.iter().flat_map(|part| &part.conditions) {
            breaks.push([b.negated(), a.clone()]);
            breaks.push([b.clone(), a.negated()]);
        }
        breaks
    }

    /// The runs among the directions from `(1, 0)` to `(0, 1)`, both included.
    pub(super) fn runs_in_quadrant(&self) -> Result<Vec<Run<T>>, Overflow> {
        let (one, zero) = (T::unit(), T::default());
        let mut breaks = self.breaks();
        breaks.retain(|[x, y]| x.sign().is_ge() && y.sign().is_ge());
        breaks.extend([[one.clone(), zero.clone()], [zero, one]]);
        sort_around(&mut breaks);
        self.runs(&breaks, false).map(|(runs, _)| runs)
    }

    /// The runs around the whole circle of directions, and whether every direction belongs to the set.
    pub(super) fn runs_around(&self) -> Result<(Vec<Run<T>>, bool), Overflow> {
        let (one, zero) = (T::unit(), T::default());
        let mut breaks = self.breaks();
        breaks.extend([[one.clone(), zero.clone()], [one.negated(), zero.clone()]]);
        breaks.extend([[zero.clone(), one.clone()], [zero, one.negated()]]);
        sort_around(&mut breaks);
        self.runs(&breaks, true)
    }

    fn runs(&self, breaks: &[[T; 2]], is_circle: bool) -> Result<(Vec<Run<T>>, bool), Overflow> {
        let n = breaks.len();
        let n_arcs = if is_circle { n } else { n - 1 };
        // places in order: break 0, the arc after it, break 1, ...
        let mut inside = Vec::with_capacity(2 * n);
        for index in 0..n {
            inside.push(self.holds(&breaks[index])?);
            if index < n_arcs {
                inside.push(self.holds(&between(&breaks[index], &breaks[(index + 1) % n])?)?);
            }
        }
        if is_circle && inside.iter().all(|place| *place) {
            return Ok((Vec::new(), true));
        }
        let places = inside.len();
        let is_start =
            |place: usize| inside[place] && (place > 0 || is_circle) && !inside[(place + places - 1) % places];
        let starts = (0..places).filter(|place| is_start(*place) || (*place == 0 && !is_circle && inside[0]));
        let runs = starts.map(|start| {
            let mut end = start;
            while (is_circle || end + 1 < places) && inside[(end + 1) % places] {
                end += 1;
            }
            let from = breaks[start / 2].clone();
            let to = breaks[end.div_ceil(2) % n].clone();
            Run { from, to, closed: [start % 2 == 0, end % 2 == 0] }
        });
        Ok((runs.collect(), false))
    }
}

impl<T: Int> PlanarCone<T> {
    fn of(system: &HalfSpaces<T>, map: &[Vec<T>; 2]) -> Result<Self, Overflow> {
        let mut conditions = Vec::new();
        let kinds = [(&system.equalities, Ordering::Equal, true), (&system.closed, Ordering::Less, true)];
        for (rows, side, closed) in kinds.into_iter().chain([(&system.strict, Ordering::Less, false)]) {
            for row in rows.rows() {
                let row = spatial(row);
                let (x, y) = (T::product(row, spatial(&map[0]))?, T::product(row, spatial(&map[1]))?);
                let [x, y, _] = T::on_ray(&[x, y, T::Minor::default()])?;
                conditions.push((side, closed, [x, y]));
            }
        }
        Ok(Self { conditions })
    }

    fn holds(&self, direction: &[T; 2]) -> Result<bool, Overflow> {
        for (side, closed, row) in &self.conditions {
            let sign = T::side_of(&embedded(row), &embedded(direction));
            if sign != *side && !(*closed && sign.is_eq()) {
                return Ok(false);
            }
        }
        Ok(true)
    }
}

/// Sorts by angle from `(1, 0)` counter-clockwise; drops zeros and repeated directions.
fn sort_around<T: Int>(directions: &mut Vec<[T; 2]>) {
    directions.retain(|[x, y]| x.sign().is_ne() || y.sign().is_ne());
    directions.iter_mut().for_each(|direction| T::make_primitive(direction));
    directions.sort_by(|a, b| around(a, b));
    directions.dedup();
}

/// Compares angles in [0, 360) degrees.
fn around<T: Int>(a: &[T; 2], b: &[T; 2]) -> Ordering {
    let lower_half = |[x, y]: &[T; 2]| y.sign().is_lt() || (y.sign().is_eq() && x.sign().is_lt());
    lower_half(a).cmp(&lower_half(b)).then_with(|| turn(a, b).reverse())
}

/// Sign of the cross product `a × b`: greater if `b` lies counter-clockwise of `a`.
fn turn<T: Int>(a: &[T; 2], b: &[T; 2]) -> Ordering {
    T::side_of(&embedded(a), &embedded(&[b[1].clone(), b[0].negated()]))
}

fn embedded<T: Int>([x, y]: &[T; 2]) -> [T; 3] {
    [x.clone(), y.clone(), T::default()]
}

fn spatial<T>(row: &[T]) -> &[T; 3] {
    row.try_into().expect("wrenches have three components")
}

/// A direction strictly between two that are less than half a turn apart.
fn between<T: Int>(a: &[T; 2], b: &[T; 2]) -> Result<[T; 2], Overflow> {
    let one = T::unit().widen();
    let mut sum = Entries::new();
    T::combine(&one, a, &one, b, &mut sum)?;
    Ok([sum[0].clone(), sum[1].clone()])
}
