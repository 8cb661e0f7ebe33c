//! Critical friction in words.

use super::super::decimal::percent_up_to;
use super::super::phrase;
use crate::answer::{CriticalFactor, CriticalFriction, End, FrictionLimit, NearestChange};

/// How much friction the plan bears, and how much any wrench does; `None` without a plan.
pub(super) fn critical(critical: &CriticalFriction) -> Option<String> {
    let plan = match critical.plan.as_ref()? {
        FrictionLimit::Always => return None,
        FrictionLimit::Never => return Some("the plan works whatever the friction".to_owned()),
        FrictionLimit::Finite(plan) => plan,
    };
    let any = match &critical.acyclic {
        FrictionLimit::Finite(end) if end.factor == plan.factor => match end.jam {
            Some([first, second]) => format!("no wrench beyond, where fixels {first} and {second} jam the part"),
            None => "no wrench beyond".to_owned(),
        },
        FrictionLimit::Finite(end) => format!("some wrench up to {}, {}", share(end), beyond(end)),
        FrictionLimit::Always | FrictionLimit::Never => "some wrench whatever it is".to_owned(),
    };
    Some(format!("the plan works up to {} of the friction given, {any}", share(plan)))
}

/// What would open an empty set; `None` if no change of friction and no fixel left out would.
pub(super) fn change(change: &NearestChange) -> Option<String> {
    if let Some(all) = &change.all {
        let single = change.single.iter().map(|(fixel, end)| format!(", or {} of fixel {fixel}'s alone", share(end)));
        return Some(format!("at most {} of the friction given{}", share(all), single.collect::<String>()));
    }
    let fixels: Vec<String> = change.without.iter().map(usize::to_string).collect();
    (!fixels.is_empty()).then(|| format!("leave out fixel {}", phrase::joined(&fixels, "or")))
}

fn share(end: &CriticalFactor) -> String {
    format!("{} %", percent_up_to(&end.factor, end.is_attained == Some(true)))
}

fn beyond(end: &CriticalFactor) -> String {
    match (end.jam, end.end) {
        (Some([first, second]), _) => format!("beyond which fixels {first} and {second} jam the part"),
        (None, Some(End::Jumps)) => "where the set ends abruptly".to_owned(),
        (None, _) => "where the set shrinks to nothing".to_owned(),
    }
}
