//! How much friction a guarantee bears, and what would open an empty set.

mod change;
mod collapse;
mod determinants;
mod events;
mod family;
mod jam;
mod limit;
mod search;

pub(in crate::planner) use change::nearest_change;

use crate::answer::{CriticalFriction, FrictionLimit, Insertion};
use crate::exact::primitive_row;
use crate::mechanics::Contact;
use crate::model::{Fixture, Part};
use family::{Family, Set};
use limit::{Known, of_plan, of_set};

/// Up to which common factor on all coefficients the sets and the plan of `answer` last.
pub(super) fn critical_friction(part: &Part, fixture: &Fixture, answer: &Insertion) -> CriticalFriction {
    let family = Family::of(part, fixture, &Contact::of(part, fixture));
    let jams = Some(fixture);
    let goal = of_set(&family, jams, Set::Goal, &Known { holds_now: !answer.goal.is_empty(), above: None });
    let above = if let FrictionLimit::Finite(limit) = &goal { Some(limit) } else { None };
    let acyclic = of_set(&family, jams, Set::Acyclic, &Known { holds_now: !answer.acyclic.is_empty(), above });
    let plan = answer.plan.as_ref().map(|plan| of_plan(&family, &primitive_row(&plan.wrench), &acyclic));
    CriticalFriction { goal, acyclic, plan }
}
