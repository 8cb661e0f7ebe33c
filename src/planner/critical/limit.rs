//! The factors at which sets of wrenches become empty and a wrench leaves them.

use super::collapse::lasts;
use super::events::Rays;
use super::family::{Family, Set};
use super::jam::{first_jam, jam_at};
use super::search::{Falling, Loss, above, below, lost};
use crate::answer::{CriticalFactor, End, FrictionLimit};
use crate::exact::{Algebraic, Polynomial, Q, Z, ratio};
use crate::model::Fixture;
use num_traits::{One as _, Zero as _};

/// What is known before the search.
pub(super) struct Known<'a> {
    /// Whether the set holds a wrench at factor 1.
    pub(super) holds_now: bool,
    /// A factor that the set's is at least.
    pub(super) above: Option<&'a CriticalFactor>,
}

/// The factor at which `set` becomes empty; `jams` is the fixture if all of its coefficients follow the factor.
pub(super) fn of_set(family: &Family, jams: Option<&Fixture>, set: Set, known: &Known) -> FrictionLimit {
    let (zero, one) = (Q::zero(), Q::one());
    if !family.is_independent || (family.is_constant() && !known.holds_now) {
        return FrictionLimit::Always;
    }
    if family.is_constant() {
        return FrictionLimit::Never;
    }
    let condition = Possible { family, set, rays: Rays::of(family, None) };
    let (mut low, mut high) = (one.clone(), None);
    if !known.holds_now {
        if !condition.holds(&zero) {
            return FrictionLimit::Always;
        }
        (low, high) = (zero, Some(one));
    }
    // a pair that balances every wrench lets the part persist with a third fixel free
    if let Some((above, jam)) = jams.filter(|fixture| fixture.fixels.len() > 2).and_then(first_jam)
        && above >= low
        && high.as_ref().is_none_or(|high| above < *high)
    {
        if condition.holds(&above) {
            let end = Some(condition.end_at_rational(&above));
            return FrictionLimit::Finite(CriticalFactor {
                factor: above.into(),
                is_attained: Some(true),
                end,
                jam: Some(jam),
            });
        }
        high = Some(above);
    }
    if let Some(known) = known.above.filter(|known| known.factor > Q::zero()) {
        low = low.max(below(&known.factor));
        // often both sets end together
        let above = above(&known.factor);
        if high.as_ref().is_none_or(|high| above < *high) {
            if condition.holds(&above) { low = low.max(above) } else { high = Some(above) }
        }
    }
    match lost(&condition, low, high) {
        None => FrictionLimit::Never,
        Some(Loss { factor, before }) => FrictionLimit::Finite(condition.end_at(factor, &before, jams)),
    }
}

/// The factor at which `wrench`, which is in the acyclic set at factor 1, leaves it; the set itself ends at `set`.
pub(super) fn of_plan(family: &Family, wrench: &[Z], set: &FrictionLimit) -> FrictionLimit {
    if family.is_constant() {
        return FrictionLimit::Never;
    }
    let high =
        if let FrictionLimit::Finite(end) = set { Some(end.factor.bounds()[1].clone() * ratio(2, 1)) } else { None };
    let condition = Stays { family, wrench, rays: Rays::of(family, Some(wrench)) };
    match lost(&condition, Q::one(), high) {
        None => FrictionLimit::Never,
        Some(Loss { factor, .. }) => {
            let (factor, is_attained) = at_itself(&condition, factor);
            FrictionLimit::Finite(CriticalFactor { factor, is_attained, end: None, jam: None })
        }
    }
}

/// That a set holds some wrench.
struct Possible<'a> {
    family: &'a Family,
    set: Set,
    rays: Rays,
}

impl Falling for Possible<'_> {
    fn holds(&self, factor: &Q) -> bool {
        self.family.is_possible(self.set, factor)
    }

    fn events(&self, low: &Q, high: &Q) -> Vec<Polynomial> {
        self.rays.events(low, high, false)
    }

    fn beyond_all(&self) -> Q {
        self.rays.beyond_all()
    }
}

impl Possible<'_> {
    /// How the set ends at `factor`, with no event between `before` and there.
    ///
    /// A closed cone at a factor is the closure of its union below, for its rays are continuous and it grows. So what the
    /// sets below have in common has an interior iff the set at the factor itself has one; and the open set `goal` is
    /// empty there if not.
    fn end_at(&self, factor: Algebraic, before: &Q, jams: Option<&Fixture>) -> CriticalFactor {
        let (factor, attained) = at_itself(self, factor);
        let end = match (factor.rational(), attained) {
            (Some(value), Some(true)) => self.end_at_rational(&value),
            (Some(_), _) => End::Shrinks,
            (None, _) => self.end_at_root(&factor, before),
        };
        let is_attained = match end {
            End::Jumps => Some(true),
            End::Shrinks if self.set == Set::Goal => Some(false),
            End::Shrinks => attained,
        };
        let jam = jams.zip(factor.rational()).and_then(|(fixture, factor)| jam_at(fixture, &factor));
        CriticalFactor { factor, is_attained, end: Some(end), jam }
    }

    /// How the set ends that at `factor` still holds a wrench.
    fn end_at_rational(&self, factor: &Q) -> End {
        // the complement of closed cones has an interior
        let has_interior = self.set == Set::Goal || self.family.has_interior(self.set, factor);
        if has_interior { End::Jumps } else { End::Shrinks }
    }

    fn end_at_root(&self, factor: &Algebraic, before: &Q) -> End {
        // close bounds settle most signs at the factor
        let mut close = factor.clone();
        close.refine(&(before * ratio(1, 1_000_000_000_000)));
        let planes = self.rays.planes_at(before);
        let cells = self.family.cells(self.set, before);
        if cells.iter().any(|cell| lasts(cell, &planes, &close)) { End::Jumps } else { End::Shrinks }
    }
}

/// That the acyclic set holds one wrench.
struct Stays<'a> {
    family: &'a Family,
    wrench: &'a [Z],
    rays: Rays,
}

impl Falling for Stays<'_> {
    fn holds(&self, factor: &Q) -> bool {
        self.family.holds_acyclic(factor, self.wrench)
    }

    fn events(&self, low: &Q, high: &Q) -> Vec<Polynomial> {
        self.rays.events(low, high, true)
    }

    fn beyond_all(&self) -> Q {
        self.rays.beyond_all()
    }
}

/// The factor, as a rational if it is one, and then whether the condition holds there.
fn at_itself(condition: &impl Falling, factor: Algebraic) -> (Algebraic, Option<bool>) {
    match factor.rational() {
        Some(value) => {
            let holds = condition.holds(&value);
            (value.into(), Some(holds))
        }
        None => (factor, None),
    }
}
