//! The document of `plan convert`.

use super::number::rationals;
use crate::answer::{Limit, Polyhedron};
use serde_json::{Map, Value, json};

/// Schema of `plan convert`.
pub const CONVERT: &str = "plan.convert/1";

/// The document of `plan convert`; rows are numbered from one.
#[must_use]
pub fn polyhedron(name: &str, warnings: &[String], answer: &Polyhedron) -> Value {
    let mut result = Map::new();
    result.insert("representation".into(), answer.representation.to_string().into());
    result.insert("columns".into(), answer.columns.into());
    result.insert("empty".into(), answer.dimension.is_none().into());
    result.insert("dimension".into(), answer.dimension.map_or(json!(-1), Value::from));
    result.insert("linearity".into(), (1..=answer.n_linear).collect());
    result.insert("rows".into(), answer.rows.iter().map(|row| rationals(row)).collect());
    if let Some(lists) = &answer.adjacency {
        result.insert("adjacency".into(), json!(lists));
    }
    if let Some(lists) = &answer.incidence {
        result.insert("incidence".into(), json!(lists));
    }
    if let Some(fates) = &answer.fates {
        result.insert("kept".into(), json!(fates.kept));
        result.insert("redundant".into(), json!(fates.redundant));
        result.insert("implicit_linearity".into(), json!(fates.implicit));
    }
    result.insert("warnings".into(), json!(warnings));
    envelope(name, "report", result)
}

/// The document of a conversion that reached its limit.
#[must_use]
pub fn undecided_polyhedron(name: &str, reached: Limit) -> Value {
    envelope(name, "undecided", Map::from_iter([("limit".to_owned(), reached.name().into())]))
}

fn envelope(name: &str, status: &str, result: Map<String, Value>) -> Value {
    json!({
        "schema": CONVERT,
        "version": env!("CARGO_PKG_VERSION"),
        "case": name,
        "status": status,
        "result": result,
    })
}
