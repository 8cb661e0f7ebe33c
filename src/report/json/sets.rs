//! Sets in JSON: canonical cones, regions, finger places, directions.

use super::number::{integers, rational, rationals};
use crate::answer::{Arc, ArcSet, Cone, EdgeFingers, FingerSet, Interval, Region};
use crate::exact::to_f64;
use crate::model::{Part, Shape};
use serde_json::{Map, Value, json};

pub(super) fn cone(cone: &Cone) -> Value {
    let Cone::Of(cone) = cone else { return json!({ "empty": true }) };
    let faces = cone.faces.iter().map(|face| json!({ "normal": integers(&face.normal), "strict": face.strict }));
    let excluded = cone.excluded.iter().map(|face| json!({ "normal": integers(&face.normal), "tight": face.tight }));
    json!({
        "empty": false,
        "dim": cone.dim,
        "equalities": cone.equalities.iter().map(|row| integers(row)).collect::<Value>(),
        "faces": faces.collect::<Value>(),
        "excluded": excluded.collect::<Value>(),
        "lines": cone.lines.iter().map(|row| integers(row)).collect::<Value>(),
        "rays": cone.rays.iter().map(|row| integers(row)).collect::<Value>(),
    })
}

pub(super) fn region(region: &Region, cells: bool) -> Map<String, Value> {
    let mut value = Map::new();
    value.insert("empty".into(), region.is_empty().into());
    value.insert("dim".into(), region.dim.map_or(json!(-1), Value::from));
    value.insert("has_interior".into(), region.has_interior().into());
    value.insert("everything".into(), region.everything.into());
    value.insert("volume_in_box".into(), rational(&region.volume_in_box));
    value.insert("volume_approx".into(), to_f64(&region.volume_in_box).into());
    if cells {
        value.insert("cells".into(), region.cells.iter().map(cone).collect());
    }
    value
}

pub(super) fn fingers(part: &Part, fingers: &FingerSet) -> Value {
    match fingers {
        FingerSet::Edges(edges) => edges.iter().map(|edge| edge_fingers(part, edge)).collect(),
        FingerSet::Arcs(arcs) => arc_set(arcs),
    }
}

pub(super) fn interval(interval: &Interval) -> Value {
    json!({
        "s": rationals(&interval.s),
        "closed": interval.closed,
        "points": interval.points.iter().map(|point| rationals(point)).collect::<Value>(),
    })
}

pub(super) fn arc_set(set: &ArcSet) -> Value {
    json!({ "all": set.all, "arcs": set.arcs.iter().map(arc).collect::<Value>() })
}

pub(super) fn arc(arc: &Arc) -> Value {
    json!({ "from": integers(&arc.from), "to": integers(&arc.to), "closed": arc.closed })
}

fn edge_fingers(part: &Part, fingers: &EdgeFingers) -> Value {
    let mut value = json!({
        "edge": fingers.edge,
        "intervals": fingers.intervals.iter().map(interval).collect::<Value>(),
    });
    if let Shape::Polygon(polygon) = &part.shape {
        let [from, to] = polygon.edge(fingers.edge);
        value["from_vertex"] = rationals(from);
        value["to_vertex"] = rationals(to);
    }
    value
}
