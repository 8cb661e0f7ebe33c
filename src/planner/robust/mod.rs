//! The wrench with the largest ball inside the complement of closed cones.

mod frame;
mod hole;
mod search;

pub(super) use frame::dot;

use super::recommend::Margins;
use crate::answer::Robust;
use crate::cone::{Cone, nearest};
use crate::exact::{Int, Overflow, Q, Z, from_float_exact};
use frame::{Frame, exact};
use hole::Hole;
use num_traits::Zero as _;
use search::{Found, search};

/// Of [`Robust::TOLERANCE`], the part that rounding the direction to a short rational wrench may take.
const ROUNDING: f64 = 0.3 * Robust::TOLERANCE;

/// Rounded directions have at most this many decimal digits.
const MOST_DIGITS: u32 = 9;

/// The most robust wrench outside of the closures of `holes`, with `cells` their complement up to faces; `None` if there
/// is no cell or no hole, for then no ball or every ball fits. It is no worse than that `known` of a smaller set.
///
/// Floating point proposes the wrench, exact arithmetic measures it ([`nearest`]), and branch and bound over all
/// directions in outward-rounded floating point certifies that none is much better.
///
/// # Errors
/// [`Overflow`] if a dot product or a point of a cell does not fit `T`.
pub(super) fn robust<T: Int>(
    holes: &[&Cone<T>],
    cells: &[Cone<T>],
    rho2: &Q,
    known: Option<&Robust>,
) -> Result<Option<Robust>, Overflow> {
    if holes.is_empty() || cells.is_empty() {
        return Ok(None);
    }
    let frame = Frame::of(rho2);
    let margins = Margins::of(holes, rho2.clone());
    let solid: Vec<Hole> = holes.iter().map(|hole| Hole::of(hole.closure(), &frame)).collect::<Result<_, _>>()?;
    let inner = |cell: &Cone<T>| cell.inner_point().map(|point| exact(&point));
    let inner: Vec<[Z; 3]> = cells.iter().map(inner).collect::<Result<_, _>>()?;
    let seeds: Vec<[f64; 3]> = inner.iter().map(|point| frame.unit(point)).collect();
    let Found { direction, radius, upper } = search(&solid, &seeds);
    let short = |digits: u32| {
        let wrench = frame.wrench(&direction, digits);
        let unit = frame.unit(&wrench);
        let is_close = solid.iter().all(|hole| hole.distance_at_most(&unit) >= radius - ROUNDING);
        (is_close || digits == MOST_DIGITS).then_some(wrench)
    };
    let radius_upper = from_float_exact(upper).expect("bounds are finite");
    let measured = |wrench: [Z; 3]| {
        let nearest_first = by_distance(&solid, &frame.unit(&wrench));
        let radius2 = radius2(holes, &nearest_first, &margins, &wrench)?;
        Ok(Robust { wrench: wrench.map(Q::from), radius2, radius_upper: radius_upper.clone() })
    };
    let wrench = (0..=MOST_DIGITS).find_map(short).expect("the last is taken as it is");
    let mut found = measured(wrench)?;
    if let Some(known) = known.filter(|known| known.radius2 >= found.radius2) {
        found = measured(known.wrench.each_ref().map(Q::to_integer))?;
    }
    if !found.radius2.is_zero() {
        return Ok(Some(found));
    }
    // too slender for floating point: only the cells know where the set is
    let inner = inner.into_iter().map(measured).collect::<Result<Vec<_>, _>>()?;
    Ok(inner.into_iter().max_by(|a, b| a.radius2.cmp(&b.radius2)))
}

/// The holes' numbers, those that seem nearest first.
fn by_distance(holes: &[Hole], unit: &[f64; 3]) -> Vec<usize> {
    let mut order: Vec<(f64, usize)> = holes.iter().map(|hole| hole.distance_at_most(unit)).zip(0..).collect();
    order.sort_by(|a, b| a.0.total_cmp(&b.0));
    order.into_iter().map(|(_, hole)| hole).collect()
}

/// Squared distance of `wrench` from the nearest of the holes, over its squared length; the `order` of the holes only
/// decides how many distances are needed.
fn radius2<T: Int>(holes: &[&Cone<T>], order: &[usize], margins: &Margins, wrench: &[Z; 3]) -> Result<Q, Overflow> {
    let rho2 = &margins.rho2;
    let weights = [rho2.numer(), rho2.numer(), rho2.denom()].map(|weight| Q::from(weight.clone()));
    let point = wrench.each_ref().map(|value| Q::from(value.clone()));
    let norm2 = |v: &[Q]| v.iter().zip(&weights).map(|(x, weight)| x * x * weight).sum::<Q>();
    let mut least = norm2(&point);
    let length2 = least.clone();
    for hole in order {
        if margins.distance2(*hole, wrench) * rho2.numer() < least {
            let foot = nearest(holes[*hole].closure(), &weights, &point)?;
            let apart: Vec<Q> = point.iter().zip(&foot).map(|(x, y)| x - y).collect();
            least = least.min(norm2(&apart));
        }
    }
    Ok(least / length2)
}
