//! The document of `plan pins`.

use super::super::Ride;
use super::envelope_of;
use super::number::{algebraic, range, rational, rationals};
use crate::answer::{
    ActionInterval, HeightQuery, Limit, Obstacle, Orientation, OtherFriction, Pin, PinAction, PinPlan, PinSearch, Pins,
    ToppleInterval, Wiper,
};
use crate::exact::Algebraic;
use serde_json::{Map, Value, json};
use std::collections::BTreeMap;

/// Schema of `plan pins`.
pub const PINS: &str = "plan.pins/1";

/// The document of `plan pins`.
///
/// Heights that are not rational are `{"value", "lower", "upper", "polynomial"}`; `value` is a number, the others are exact.
/// Keys of what is not there are `null`: `action` where it depends on what is uncertain in the case, `to` where there is no
/// end, `sequence` without a plan, what hinders one with a plan.
#[must_use]
pub fn pins(ride: &Ride, answer: &Pins) -> Value {
    let mut result = context(ride);
    result.insert("hull".into(), answer.hull.iter().map(|corner| rationals(corner)).collect());
    result.insert("stable".into(), json!(answer.stable));
    let symmetry = &answer.symmetry;
    result.insert("symmetry".into(), json!({ "shift": symmetry.shift, "classes": symmetry.classes }));
    result.insert("orientations".into(), answer.orientations.iter().map(orientation).collect());
    result.insert("plan".into(), plan(&answer.plan));
    result.insert("queries".into(), answer.queries.iter().map(query).collect());
    let decisions = &answer.decisions;
    result.insert("decisions".into(), json!({ "filtered": decisions.filtered, "exact": decisions.exact }));
    let status = match (&answer.plan.sequence, answer.plan.is_decided()) {
        (Some(_), _) => "plan",
        (None, true) => "no-plan",
        (None, false) => "undecided",
    };
    envelope_of(ride.name, ride.part, PINS, status, result)
}

/// The document of `plan pins` when a limit was reached before an answer.
#[must_use]
pub fn undecided_pins(ride: &Ride, reached: Limit) -> Value {
    let mut result = context(ride);
    result.insert("limit".into(), reached.name().into());
    envelope_of(ride.name, ride.part, PINS, "undecided", result)
}

/// What every result says about the task itself.
fn context(ride: &Ride) -> Map<String, Value> {
    let (part, conveyor) = (ride.part, ride.conveyor);
    let mut result = Map::new();
    result.insert("center_of_mass".into(), rationals(&part.center_of_mass));
    result.insert("center_of_mass_tolerance".into(), rational(&part.center_of_mass_tolerance));
    result.insert("belt_friction".into(), range(&conveyor.belt_friction));
    result.insert("pin_friction".into(), range(&conveyor.pin_friction));
    result.insert("asked".into(), json!({ "end": ride.end, "max_pins": ride.max_pins }));
    result.insert("warnings".into(), json!(ride.warnings));
    result
}

fn orientation(orientation: &Orientation) -> Value {
    let dip = |[from, to]: &[Algebraic; 2]| json!({ "from": algebraic(from), "to": algebraic(to) });
    let dip = orientation.repeat_over_dip.as_ref().map(dip);
    json!({
        "edge": orientation.edge,
        "next": orientation.next,
        "pivots": orientation.pivots,
        "theta_t_deg": orientation.theta_t_deg,
        "theta_1_deg": orientation.theta_1_deg,
        "height": algebraic(&orientation.height),
        "intervals": orientation.intervals.iter().map(interval).collect::<Value>(),
        "topple": orientation.topple.iter().map(topple).collect::<Value>(),
        "repeat_over_dip": dip,
    })
}

fn interval(interval: &ActionInterval) -> Value {
    json!({
        "from": algebraic(&interval.from),
        "to": interval.to.as_ref().map(algebraic),
        "action": interval.action.map(PinAction::name),
    })
}

fn topple(interval: &ToppleInterval) -> Value {
    json!({ "edge": interval.edge, "from": algebraic(&interval.from), "to": algebraic(&interval.to) })
}

/// `final` is the edge on which the part ends, the first one where several look the same; `final_edges` are all of them.
fn plan(plan: &PinPlan) -> Value {
    let has_end = plan.sequence.is_some();
    let PinSearch { height_classes, distinct_outcome_maps, usable_first_pins, reachable_sets, by_arcs } = plan.searched;
    let obstacle = plan.obstacle.as_ref();
    let of = |part: fn(&Obstacle) -> Value| obstacle.map(part);
    let mut value = json!({
        "pins": plan.sequence.as_ref().map(Vec::len),
        "sequence": plan.sequence.as_ref().map(|pins| pins.iter().map(pin).collect::<Value>()),
        "needs": plan.needs,
        "final": plan.end.first().filter(|_| has_end),
        "final_edges": has_end.then_some(&plan.end),
        "smallest_sets": of(|obstacle| json!(obstacle.smallest_sets)),
        "inseparable_pairs": of(|obstacle| json!(obstacle.inseparable_pairs)),
        "never_moved": of(|obstacle| json!(obstacle.never_moved)),
        "wiper": obstacle.and_then(|obstacle| obstacle.wiper.as_ref()).map(wiper),
        "other_friction": obstacle.and_then(|obstacle| obstacle.friction.as_ref()).map(other_friction),
        "searched": {
            "height_classes": height_classes,
            "distinct_outcome_maps": distinct_outcome_maps,
            "usable_first_pins": usable_first_pins,
            "reachable_sets": reachable_sets,
            "by_arcs": by_arcs,
        },
        "complete": plan.limit.is_none(),
    });
    if let Some(limit) = plan.limit {
        value["limit"] = limit.name().into();
    }
    if !plan.pareto.is_empty() {
        let rows = plan.pareto.iter().map(|row| json!({ "pins": row.pins, "tolerance": rational(&row.tolerance) }));
        value["pareto"] = rows.collect();
    }
    if let Some(margins) = &plan.margins {
        value["margins"] = json!({
            "belt_friction": range(&margins.belt_friction),
            "pin_friction": range(&margins.pin_friction),
            "friction_tried": rational(&margins.friction_tried),
            "center_of_mass": rational(&margins.center_of_mass),
        });
    }
    value
}

fn pin(pin: &Pin) -> Value {
    json!({
        "height": rational(&pin.height),
        "low": algebraic(&pin.low),
        "high": algebraic(&pin.high),
        "tolerance": rational(&pin.tolerance),
        "outcome": by_edge(&pin.outcome, |end| json!(end)),
        "after": pin.after,
    })
}

/// `yielding` of the stable edges end on the one that is `kept`.
fn wiper(wiper: &Wiper) -> Value {
    json!({
        "pins": wiper.pins.iter().map(pin).collect::<Value>(),
        "discarded": wiper.discarded,
        "kept": wiper.kept,
        "yielding": wiper.yielding,
    })
}

fn other_friction(other: &OtherFriction) -> Value {
    json!({
        "belt_friction": range(&other.belt_friction),
        "pin_friction": range(&other.pin_friction),
        "pins": other.pins,
    })
}

fn query(query: &HeightQuery) -> Value {
    json!({
        "height": rational(&query.height),
        "actions": by_edge(&query.actions, |action| json!(action.map(PinAction::name))),
        "outcomes": by_edge(&query.outcomes, |end| json!(end)),
        "critical_for": query.critical_for,
    })
}

/// An object with the edges as keys.
fn by_edge<T: Copy>(values: &BTreeMap<usize, T>, value: impl Fn(T) -> Value) -> Value {
    values.iter().map(|(edge, of)| (edge.to_string(), value(*of))).collect::<Map<_, _>>().into()
}
