//! The exact rungs: a solution, a proof that there is none, or the limit that was met.

use super::arbiter::{ExactEnd, lemke};
use super::cases::search;
use super::exact_basis::solution_of;
use super::farkas::{excluded, is_farkas};
use super::integral::Integral;
use super::{Basis, ExactLcp, Limits, Proof, Rung, Undecided};
use crate::exact::{Q, Z};
use num_traits::Zero as _;

/// The exact answer.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Decision {
    Solved { z: Vec<Q>, basis: Basis, rung: Rung },
    None(Proof),
    Undecided(Undecided),
}

/// Decides the problem, and says how many pivots that took.
///
/// The basis that doubles propose is tried first. A secondary ray proves nothing by itself. Its direction `v` is tried as Farkas multipliers, which succeeds for copositive-plus
/// **M**; then multipliers are searched for; and where the linear system has solutions, all complementary cases are.
pub(super) fn decide(lcp: &ExactLcp, proposed: Option<&Basis>, limits: Limits) -> (Decision, usize) {
    let integral = Integral::new(lcp);
    if let Some(basis) = proposed
        && let Some(z) = solution_of(&integral, basis)
    {
        return (Decision::Solved { z, basis: basis.clone(), rung: Rung::Exact }, 0);
    }
    let mut pivots = 0;
    let mut ray = None;
    if limits.first <= Rung::Exact {
        let (end, used) = lemke(&integral, limits.exact_pivots);
        pivots = used;
        match end {
            ExactEnd::Solved { z, basis } => return (Decision::Solved { z, basis, rung: Rung::Exact }, pivots),
            ExactEnd::Limit => return (Decision::Undecided(Undecided::Pivots(pivots)), pivots),
            ExactEnd::Ray { direction } if is_farkas(lcp, &direction) => {
                return (Decision::None(Proof::Farkas(direction)), pivots);
            }
            ExactEnd::Ray { direction } => ray = Some(direction),
        }
    }
    if let Some(case) = excluded(&integral, &[], &[]) {
        return (Decision::None(Proof::Farkas(case.multipliers)), pivots);
    }
    let limit = if lcp.size() <= limits.case_variables { limits.cases } else { 0 };
    let cases = search(&integral, limit);
    if let Some(choice) = cases.pieces.first() {
        let point = choice.generators.iter().find(|row| !row[0].is_zero());
        let value = |value: &Z, scale: &Z| Q::new(value.clone(), scale.clone());
        let z: Vec<Q> = point.map_or_else(Vec::new, |row| row[1..].iter().map(|entry| value(entry, &row[0])).collect());
        let z = integral.restore(&z);
        let basis = Basis::with(lcp.size(), (0..lcp.size()).filter(|i| !z[*i].is_zero()));
        return (Decision::Solved { z, basis, rung: Rung::Cases }, pivots);
    }
    if cases.is_complete {
        let proofs = cases.excluded.iter().map(|[zero_z, zero_w]| excluded(&integral, zero_z, zero_w));
        if let Some(proofs) = proofs.collect::<Option<Vec<_>>>() {
            return (Decision::None(Proof::Cases(proofs)), pivots);
        }
    }
    let direction = ray.unwrap_or_default();
    (Decision::Undecided(Undecided::Ray { direction, cases: cases.visited }), pivots)
}
