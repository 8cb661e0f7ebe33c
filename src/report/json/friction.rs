//! Critical friction in JSON.

use super::number::root;
use crate::answer::{CriticalFactor, CriticalFriction, End, FrictionLimit, NearestChange};
use crate::exact::{Q, Z};
use serde_json::{Value, json};

/// Widest bracket of a factor that is written down.
const WIDTH: (i64, i64) = (1, 1_000_000_000);

pub(super) fn critical_friction(critical: &CriticalFriction) -> Value {
    json!({
        "goal": limit(&critical.goal),
        "acyclic": limit(&critical.acyclic),
        "plan": critical.plan.as_ref().map(limit),
    })
}

pub(super) fn nearest_change(change: &NearestChange) -> Value {
    let single = |(fixel, end): &(usize, CriticalFactor)| {
        let mut value = factor(end);
        value["fixel"] = json!(fixel);
        value
    };
    json!({
        "all": change.all.as_ref().map(factor),
        "single": change.single.iter().map(single).collect::<Value>(),
        "without": change.without,
    })
}

fn limit(limit: &FrictionLimit) -> Value {
    match limit {
        FrictionLimit::Always => json!({ "kind": "always" }),
        FrictionLimit::Never => json!({ "kind": "never" }),
        FrictionLimit::Finite(end) => factor(end),
    }
}

fn factor(end: &CriticalFactor) -> Value {
    let mut value = root(&end.factor, &Q::new(Z::from(WIDTH.0), Z::from(WIDTH.1)));
    value["kind"] = json!("finite");
    value["attained"] = json!(end.is_attained);
    if let Some(end) = end.end {
        value["end"] = json!(match end {
            End::Shrinks => "shrinks",
            End::Jumps => "jumps",
        });
    }
    if let Some(fixels) = end.jam {
        value["jam"] = json!(fixels);
    }
    value
}
