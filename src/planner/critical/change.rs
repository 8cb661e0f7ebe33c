//! What would open an empty set.

use super::family::{Family, Set};
use super::limit::{Known, of_set};
use crate::answer::{CriticalFriction, FrictionLimit, NearestChange};
use crate::exact::Q;
use crate::mechanics::Contact;
use crate::model::{Fixture, Part};
use num_traits::One as _;

/// The changes that would open the empty acyclic set, whose limit `critical` tells.
pub(in crate::planner) fn nearest_change(part: &Part, fixture: &Fixture, critical: &CriticalFriction) -> NearestChange {
    let family = Family::of(part, fixture, &Contact::of(part, fixture));
    let FrictionLimit::Finite(all) = &critical.acyclic else {
        let without = (0..fixture.fixels.len()).filter(|fixel| opens_without(part, fixture, *fixel)).collect();
        return NearestChange { all: None, single: Vec::new(), without };
    };
    let known = Known { holds_now: false, above: None };
    let limit = |fixel: usize| match of_set(&family.of_fixel(fixel), None, Set::Acyclic, &known) {
        FrictionLimit::Finite(limit) => Some((fixel, limit)),
        FrictionLimit::Always | FrictionLimit::Never => None,
    };
    let mut single: Vec<_> = (0..fixture.fixels.len()).filter_map(limit).collect();
    single.sort_by(|(_, a), (_, b)| b.factor.cmp(&a.factor));
    NearestChange { all: Some(all.clone()), single, without: Vec::new() }
}

fn opens_without(part: &Part, fixture: &Fixture, fixel: usize) -> bool {
    // more than three have dependent normals
    if !(2..=4).contains(&fixture.fixels.len()) {
        return false;
    }
    let mut rest = fixture.clone();
    rest.fixels.remove(fixel);
    Family::of(part, &rest, &Contact::of(part, &rest)).is_possible(Set::Acyclic, &Q::one())
}
