//! Witnesses in JSON: the terms of Newton's law, exact.

use super::number::{rational, rationals};
use crate::answer::{ContactMotion, Motion, Step, Witness};
use serde_json::{Map, Value, json};

/// What shows each verdict; `null` where there is nothing to show.
pub(super) fn witness(witness: &Witness) -> Value {
    json!({
        "weak": witness.weak.as_ref().map(motion),
        "strong": witness.strong.as_ref().map(motion),
        "goal": witness.goal.as_ref().map(step),
        "acyclic": witness.acyclic.as_ref().map(|steps| steps.iter().map(step).collect::<Value>()),
        "unrefuted": witness.unrefuted.as_ref().map(step),
    })
}

/// For each consistent mode one of its motions.
pub(super) fn motions(witness: &Witness) -> Map<String, Value> {
    witness.consistent.iter().map(|one| (one.mode.clone(), motion(one))).collect()
}

fn step(step: &Step) -> Value {
    let mut value = motion(&step.motion);
    value["from"] = json!(step.from);
    value["to"] = json!(step.to);
    value
}

fn motion(motion: &Motion) -> Value {
    json!({
        "mode": motion.mode,
        "acceleration": rationals(&motion.acceleration),
        "contacts": motion.contacts.iter().map(contact).collect::<Value>(),
    })
}

fn contact(contact: &ContactMotion) -> Value {
    let ([a_n, a_t], [c_n, c_t]) = (&contact.acceleration, &contact.force);
    json!({
        "a_n": rational(a_n),
        "a_t": rational(a_t),
        "c_n": rational(c_n),
        "c_t": rational(c_t),
        "friction": contact.friction.as_ref().map(rational),
    })
}
