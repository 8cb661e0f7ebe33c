//! The document of `plan throw`.

use super::super::Toss;
use super::envelope_of;
use super::number::{range, rational, rationals};
use super::surd::{surd, surd_ratio};
use crate::answer::{
    Carry, Caught, Certificate, Component, Design, EdgeReach, EndedOrbit, Fate, GraspEdge, LimitSet, Piece, ProofLimit,
    Reach, Sensor, SensorWindow, Setting, Slide, Throw, ThrowQuery,
};
use serde_json::{Map, Value, json};
use std::collections::BTreeMap;

/// Schema of `plan throw`.
pub const THROW: &str = "plan.throw/1";

/// The document of `plan throw`.
///
/// Numbers of the edges and of the grasp are exact, those of the throw map doubles; `certificate` says what of it is proved.
#[must_use]
pub fn throw(toss: &Toss, answer: &Throw) -> Value {
    let mut result = context(toss);
    let mut insert = |key: &str, value: Value| result.insert(key.into(), value);
    insert("hull", answer.hull.iter().map(|corner| rationals(corner)).collect());
    insert("stable_edges", json!(answer.stable));
    insert("classes", json!(answer.classes));
    insert("edges", answer.edges.iter().map(edge).collect());
    insert("grasp", grasp(answer));
    insert("lambda", json!(answer.lambda));
    insert("part_radius", json!(answer.part_radius));
    insert("concave", json!(answer.concave));
    insert("Z", reach(&answer.reach));
    insert("hybrid", hybrid(answer));
    insert("limit_set", limit_set(answer));
    insert("sensor", answer.sensors.iter().map(sensor).collect());
    insert("certificate", certificate(&answer.certificate));
    insert("throws", answer.throws.iter().map(query).collect());
    insert("carries", answer.carries.iter().map(carry).collect());
    insert("design", answer.design.as_ref().map_or(Value::Null, design));
    insert("stopped", json!(answer.is_stopped));
    envelope_of(toss.name, toss.part, THROW, answer.status(), result)
}

/// What every result says about the task itself.
fn context(toss: &Toss) -> Map<String, Value> {
    let (part, thrower) = (toss.part, toss.thrower);
    let mut result = Map::new();
    result.insert("center_of_mass".into(), rationals(&part.center_of_mass));
    result.insert("rho2".into(), rational(&part.gyration2()));
    result.insert("offset".into(), rational(&thrower.offset));
    result.insert("release_deg_per_s".into(), rational(&thrower.release_deg_per_s));
    result.insert("gravity".into(), rational(&thrower.gravity));
    result.insert("friction".into(), thrower.friction.as_ref().map_or(Value::Null, range));
    result.insert("settle".into(), if toss.settles_first { "first" } else { "full" }.into());
    result.insert("warnings".into(), json!(toss.warnings));
    result
}

fn edge(edge: &GraspEdge) -> Value {
    let grasp = edge.grasp.as_ref();
    json!({
        "edge": edge.edge,
        "stable": edge.is_stable,
        "length2": edge.length2.to_string(),
        "u_left": surd(&edge.u_left),
        "u_right": surd(&edge.u_right),
        "d": surd(&edge.d),
        "energy_kept": edge.energy_kept.to_string(),
        "R_geom": grasp.map(|grasp| surd(&grasp.r_geom)),
        "R_grasp": grasp.map(|grasp| surd(&grasp.r_grasp)),
        "R_clear": grasp.map(|grasp| surd(&grasp.r_clear)),
        "mu_edge": grasp.and_then(|grasp| grasp.mu_edge.as_ref()).map(surd),
    })
}

fn grasp(answer: &Throw) -> Value {
    let (r_edge, r_common) = &answer.grasp.r_common;
    let (mu_common, mu_edgewise) = (answer.grasp.mu_common.as_ref(), answer.grasp.mu_edgewise.as_ref());
    json!({
        "R_common": surd(r_common),
        "R_common_edge": r_edge,
        "mu_common": mu_common.map(|(_, mu)| surd_ratio(mu)),
        "mu_common_edge": mu_common.map(|(edge, _)| edge),
        "mu_edgewise": mu_edgewise.map(|(_, mu)| surd(mu)),
        "mu_edgewise_edge": mu_edgewise.map(|(edge, _)| edge),
    })
}

fn reach(reach: &Reach) -> Value {
    json!({
        "scan_to": reach.scan_to,
        "edges": by_edge(reach.edges.iter().map(|edge| (edge.edge, edge_reach(edge)))),
        "invariant": reach.is_invariant,
        "proposition_IV_4": reach.proposition,
        "problems": reach.problems,
    })
}

fn edge_reach(edge: &EdgeReach) -> Value {
    json!({
        "R_low": edge.r_low,
        "R_flip": edge.r_flip,
        "R_max": edge.r_max,
        "lowest_image": edge.lowest_image,
        "pieces": edge.pieces.iter().map(piece).collect::<Value>(),
    })
}

fn piece(piece: &Piece) -> Value {
    json!({
        "from": piece.from,
        "to": piece.to,
        "impact_vertex": piece.impact_vertex,
        "edge": piece.landing.map(|(edge, _)| edge),
        "steps": piece.landing.map_or(json!("off_arm"), |(_, steps)| json!(steps)),
    })
}

fn hybrid(answer: &Throw) -> Value {
    let slide = |slide: &Slide| json!({ "slides_next_on": slide.next, "flips": slide.flips });
    json!({
        "next": by_edge(answer.hybrid.slides.iter().map(|from| (from.edge, slide(from)))),
        "cycles": answer.hybrid.cycles,
        "unique": answer.hybrid.cycles.len() == 1,
    })
}

fn limit_set(answer: &Throw) -> Value {
    json!({
        "sets": answer.limit.sets.iter().map(set).collect::<Value>(),
        "ended": answer.limit.ended.iter().map(ended).collect::<Value>(),
        "unique": answer.limit.is_unique,
        "unique_in_Z": answer.limit.is_unique_in_reach,
    })
}

fn set(set: &LimitSet) -> Value {
    json!({
        "period": set.period,
        "lyapunov_per_throw": set.lyapunov,
        "bands": by_edge(set.bands.iter().map(|(edge, band)| (*edge, json!(band)))),
        "share": by_edge(set.share.iter().map(|(edge, share)| (*edge, json!(share)))),
        "transitions": set.transitions.iter().map(|[from, to]| format!("{from}>{to}")).collect::<Vec<_>>(),
        "jogs_between_flips": by_edge(set.jogs.iter().map(|(edge, jogs)| (*edge, json!(jogs)))),
        "main_edge": set.main_edge,
        "throws_per_cycle": finite(set.throws_per_cycle),
        "pattern": set.pattern,
        "seconds_per_throw": finite(set.seconds_per_throw),
        "throws": set.throws,
        "transient": set.transient,
        "starts": set.starts,
        "orbit": set.orbit,
    })
}

fn ended(orbit: &EndedOrbit) -> Value {
    let mut value = json!({ "start": orbit.start, "after": orbit.after, "at": orbit.at });
    match &orbit.fate {
        Fate::Caught(caught) => {
            value["why"] = if caught.in_domain { "runs_away" } else { "leaves_domain" }.into();
            value["to"] = json!([caught.edge, caught.radius]);
        }
        fate => value["why"] = outcome(fate).into(),
    }
    value
}

fn sensor(sensor: &Sensor) -> Value {
    json!({
        "set": sensor.set,
        "footprints": by_edge(sensor.footprints.iter().map(|(edge, ends)| (*edge, json!(ends)))),
        "windows": sensor.windows.iter().map(|found| window(found, "sensor_at")).collect::<Value>(),
        "recommended": sensor.windows.iter().find(|window| window.proved.is_some()).map(|found| window(found, "sensor_at")),
        "footprint": sensor.windows.iter().max_by(|a, b| a.range[1].total_cmp(&b.range[1])).map(|found| window(found, "sensor_at")),
        "com_radius": sensor.beyond.as_ref().map(|beyond| window(beyond, "R_over")),
    })
}

/// The range under the key `name`.
fn window(window: &SensorWindow, name: &str) -> Value {
    json!({
        "edge": window.edges.first(),
        "edges": window.edges,
        name: window.range,
        "proved": window.proved,
        "at": window.at,
        "throws_per_part": finite(window.throws_per_part),
        "throws_from_start": finite(window.throws_from_start),
        "settle_throws": window.settle_throws,
    })
}

fn certificate(proof: &Certificate) -> Value {
    let limit = proof.limit.map(|limit| match limit {
        ProofLimit::Stopped => "stopped",
        ProofLimit::Resolution => "resolution",
    });
    let example = proof.counterexample.as_ref().map(|example| {
        json!({
            "edge": example.edge,
            "R": example.radii,
            "to_edge": example.landing.map(|(edge, _)| edge),
            "to_R": example.landing.map(|(_, radii)| radii),
            "leaves_domain": example.leaves_domain,
        })
    });
    json!({
        "Z": by_edge(proof.z.iter().map(|(edge, range)| (*edge, json!(range)))),
        "invariant": proof.is_invariant,
        "counterexample": example,
        "unique": proof.is_invariant && proof.is_unique,
        "starts": by_edge(proof.starts.iter().map(|(edge, ranges)| (*edge, json!(ranges)))),
        "unique_from_starts": proof.is_unique,
        "components": proof.components.iter().map(component).collect::<Value>(),
        "beyond": proof.beyond.map(|(edge, radius)| json!({ "edge": edge, "R_over": radius })),
        "cells": proof.cells,
        "width": proof.width,
        "images": proof.images,
        "limit": limit,
    })
}

fn component(component: &Component) -> Value {
    json!({
        "cells": component.cells,
        "terminal": component.is_terminal,
        "bands": by_edge(component.bands.iter().map(|(edge, bands)| (*edge, json!(bands)))),
    })
}

/// The first outcome, and all of them under `branches` where a break of the map is near.
fn query(query: &ThrowQuery) -> Value {
    let mut value = json!({ "edge": query.edge, "R": rational(&query.radius) });
    if let Some(first) = query.fates.first() {
        merge(&mut value, fate(first));
    }
    value["ambiguous"] = json!(!query.is_certain);
    value["within"] = json!(query.within);
    if !query.is_certain {
        value["branches"] = query.fates.iter().map(fate).collect();
    }
    value
}

fn fate(fate: &Fate) -> Value {
    let mut value = json!({ "outcome": outcome(fate) });
    match fate {
        Fate::Caught(caught) => merge(&mut value, catch(caught)),
        Fate::OffArm { vertex, x } => merge(&mut value, json!({ "vertex": vertex, "x": x })),
        Fate::Balanced { vertex } => merge(&mut value, json!({ "vertex": vertex })),
        Fate::UnstableEdge | Fate::NoGrasp | Fate::Overhang => {}
    }
    value
}

fn outcome(fate: &Fate) -> &'static str {
    match fate {
        Fate::Caught(_) => "caught",
        Fate::UnstableEdge => "unstable_edge",
        Fate::NoGrasp => "no_grasp",
        Fate::Overhang => "overhang",
        Fate::OffArm { .. } => "off_arm",
        Fate::Balanced { .. } => "balanced",
    }
}

fn catch(caught: &Caught) -> Value {
    json!({
        "to_edge": caught.edge,
        "to_R": caught.radius,
        "kind": if caught.is_jog() { "jog" } else { "flip" },
        "steps": caught.steps,
        "flight_time": caught.flight_time,
        "flight_rotation": caught.flight_rotation,
        "impact_vertex": caught.impact_vertex,
        "impact_x": caught.impact_x,
        "omega_after": caught.omega_after,
        "slope": caught.slope,
        "in_domain": caught.in_domain,
    })
}

fn carry(carry: &Carry) -> Value {
    let end = |end: &Option<_>| end.as_ref().map(|ends: &[crate::exact::Q; 2]| rationals(ends));
    json!({
        "edge": carry.edge,
        "R": rational(&carry.radius),
        "angle_deg": rational(&carry.angle_deg),
        "rate": rational(&carry.rate),
        "friction": rational(&carry.friction),
        "grasped": carry.accelerations.is_some(),
        "from": carry.accelerations.as_ref().and_then(|[from, _]| end(from)),
        "to": carry.accelerations.as_ref().and_then(|[_, to]| end(to)),
    })
}

fn design(design: &Design) -> Value {
    let n = design.releases.len();
    let row = |(place, setting): (usize, &Setting)| {
        json!({
            "offset": design.offsets[place / n],
            "release_deg_per_s": design.releases[place % n],
            "kind": setting.kind.name(),
            "parts_per_throw": setting.parts_per_throw,
            "seconds_per_throw": finite(setting.seconds_per_throw),
            "edge": setting.edge,
            "window": setting.window,
            "grasp_margin": finite(setting.grasp_margin),
            "friction": finite(setting.friction),
            "parts_per_second": setting.rate(),
        })
    };
    let rows: Vec<Value> = design.settings.iter().enumerate().map(row).collect();
    json!({
        "offsets": design.offsets,
        "releases": design.releases,
        "margin": design.margin,
        "recommended": design.best.as_ref().map(|best| {
            let mut value = rows[best.place].clone();
            value["common_window"] = json!(best.window);
            value["proved"] = json!(best.is_proved);
            value
        }),
        "why_none": design.why_none,
        "settings": rows,
    })
}

/// JSON has no infinities.
fn finite(value: f64) -> Value {
    if value.is_finite() { value.into() } else { Value::Null }
}

fn merge(value: &mut Value, more: Value) {
    if let (Value::Object(value), Value::Object(more)) = (value, more) {
        value.extend(more);
    }
}

/// An object with the edges as keys.
fn by_edge(values: impl Iterator<Item = (usize, Value)>) -> Value {
    values
        .map(|(edge, value)| (edge.to_string(), value))
        .collect::<BTreeMap<_, _>>()
        .into_iter()
        .collect::<Map<_, _>>()
        .into()
}
