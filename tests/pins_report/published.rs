//! Answers built from the published results of the public cases, without the planner.

use crate::support::cases::{number, numbers};
use crate::support::conveyed::{action, edge, edges, json, list, text};
use partplan::answer::{
    ActionInterval, Decisions, HeightQuery, Obstacle, Orientation, Pin, PinAction, PinPlan, PinSearch, Pins, Symmetry,
    ToppleInterval,
};
use partplan::case::{Case, Limits, read};
use partplan::exact::{Algebraic, Q};
use partplan::report::Ride;
use serde_json::Value;
use std::collections::BTreeMap;

/// A public case, its published results, and an answer that says the same.
pub struct Published {
    pub case: Case,
    pub expected: Value,
    pub answer: Pins,
}

impl Published {
    pub fn new(name: &str) -> Self {
        let case = read(text(name).as_bytes(), &Limits::default()).unwrap();
        let expected = json(&format!("{name}.expected"));
        let answer = answer(&expected);
        Self { case, expected, answer }
    }

    pub fn ride(&self) -> Ride<'_> {
        Ride {
            name: self.case.name.as_deref().unwrap(),
            part: &self.case.part,
            conveyor: self.case.conveyor.as_ref().unwrap(),
            warnings: &self.case.warnings,
            end: None,
            max_pins: None,
        }
    }
}

fn by_edge<T>(value: &Value, of: impl Fn(&Value) -> T) -> BTreeMap<usize, T> {
    value.as_object().unwrap().iter().map(|(edge, value)| (edge.parse().unwrap(), of(value))).collect()
}

/// A published height is a pair of decimals that enclose it; the upper one stands for it here.
fn height(value: &Value) -> Algebraic {
    number(&value[1]).into()
}

fn answer(expected: &Value) -> Pins {
    let orientations: Vec<Orientation> = list(&expected["orientations"]).iter().map(orientation).collect();
    let symmetry = &expected["symmetry"];
    Pins {
        hull: list(&expected["hull"]).iter().map(|corner| numbers(corner).try_into().unwrap()).collect(),
        stable: edges(&expected["stable"]),
        symmetry: Symmetry {
            shift: edge(&symmetry["shift"]),
            classes: list(&symmetry["classes"]).iter().map(edges).collect(),
        },
        plan: plan(expected, &orientations),
        queries: list(&expected["queries"]).iter().map(query).collect(),
        decisions: Decisions { filtered: 12, exact: 3 },
        orientations,
    }
}

fn orientation(expected: &Value) -> Orientation {
    let intervals = list(&expected["intervals"]).iter().map(|interval| ActionInterval {
        from: height(&interval["from"]),
        to: Some(&interval["to"]).filter(|to| !to.is_null()).map(height),
        action: Some(action(&interval["action"])),
    });
    let topple = list(&expected["topple"]).iter().map(|interval| ToppleInterval {
        edge: edge(&interval["edge"]),
        from: height(&interval["from"]),
        to: height(&interval["to"]),
    });
    let dip = expected.get("repeat_over_dip").map(|ends| [height(&ends[0]), height(&ends[1])]);
    Orientation {
        edge: edge(&expected["edge"]),
        next: edge(&expected["next"]),
        pivots: edges(&expected["pivots"]),
        theta_t_deg: expected["theta_t_deg"].as_f64().unwrap(),
        theta_1_deg: expected["theta_1_deg"].as_f64().unwrap(),
        height: height(&expected["height"]),
        intervals: intervals.collect(),
        topple: topple.collect(),
        repeat_over_dip: dip,
        curves: Vec::new(),
    }
}

fn query(expected: &Value) -> HeightQuery {
    let outcome = |end: &Value| Some(end).filter(|end| !end.is_null()).map(edge);
    HeightQuery {
        height: number(&expected["height"]),
        actions: by_edge(&expected["actions"], |value| Some(action(value))),
        outcomes: by_edge(&expected["outcomes"], outcome),
        critical_for: expected.get("critical_for").map_or_else(Vec::new, edges),
    }
}

fn plan(expected: &Value, orientations: &[Orientation]) -> PinPlan {
    let plan = &expected["plan"];
    let count = |key: &str| plan.get(key).map_or(0, edge);
    let searched = PinSearch {
        height_classes: count("height_classes"),
        distinct_outcome_maps: count("distinct_outcome_maps"),
        usable_first_pins: count("usable_first_pins"),
        reachable_sets: count("reachable_sets"),
        by_arcs: false,
    };
    if plan["pins"].is_null() {
        let pairs = list(&plan["inseparable_pairs"]).iter().map(|pair| edges(pair).try_into().unwrap());
        let obstacle = Obstacle {
            smallest_sets: list(&plan["smallest_sets"]).iter().map(edges).collect(),
            inseparable_pairs: pairs.collect(),
            never_moved: edges(&plan["never_moved"]),
            wiper: None,
            friction: None,
        };
        return PinPlan { obstacle: Some(obstacle), searched, ..PinPlan::default() };
    }
    let mut before: Vec<usize> = orientations.iter().map(|orientation| orientation.edge).collect();
    let pin = |expected: &Value| {
        let [low, high] = ["from", "to"].map(|end| number(&expected[end][1]));
        let height = number(&expected["height"]);
        let outcome = before.iter().map(|edge| (*edge, end(orientations, *edge, &height))).collect();
        before = edges(&expected["after"]);
        let tolerance = (&height - &low).min(&high - &height);
        Pin { low: low.into(), high: high.into(), tolerance, outcome, after: before.clone(), height }
    };
    let sequence: Vec<Pin> = list(&plan["sequence"]).iter().map(pin).collect();
    PinPlan { sequence: Some(sequence), end: before, searched, ..PinPlan::default() }
}

/// Where an edge ends at a height that jams nothing on the way.
fn end(orientations: &[Orientation], edge: usize, height: &Q) -> usize {
    let here = orientations.iter().find(|orientation| orientation.edge == edge).unwrap();
    let is_at =
        |interval: &&ActionInterval| interval.from < *height && interval.to.as_ref().is_none_or(|to| to > height);
    match here.intervals.iter().find(is_at).unwrap().action.unwrap() {
        PinAction::PassUnder | PinAction::FallBack => edge,
        PinAction::Pass => here.next,
        PinAction::Repeat => end(orientations, here.next, height),
        PinAction::Jam => panic!("{height} jams {edge}"),
    }
}
