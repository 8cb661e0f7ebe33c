//! A case whose expressions become numbers: the syntax tree of its text, filled in, is read like any scene.

use super::super::expression::Expression;
use super::super::reader::Reader;
use super::super::{Limits, text};
use super::dimensions::DimensionLine;
use crate::model::{Device, Dimension, Planar, World};
use jsonc_parser::ast::{NumberLit, Object, Value};
use jsonc_parser::common::Ranged as _;

/// The key of what is there only while an expression is positive.
const CONDITION: &str = "only_if_positive";

/// The text of a case and its expressions, in the order in which [`filled`] meets them.
#[derive(Debug)]
pub struct Template {
    pub text: String,
    pub lets: Vec<Expression>,
    pub expressions: Vec<Expression>,
    pub lines: Vec<DimensionLine>,
    pub limits: Limits,
}

impl Template {
    /// The values of all expressions as JSON, or the number of the first that has none.
    pub fn numbers(&self, variables: &[f64], uncertain: &[f64]) -> Result<Vec<String>, usize> {
        let values = self.values(variables, uncertain);
        let number = |(index, expression): (usize, &Expression)| {
            let value = expression.value(&values);
            if value.is_finite() { Ok(format!("{value:e}")) } else { Err(index) }
        };
        self.expressions.iter().enumerate().map(number).collect()
    }

    /// Of all names.
    fn values(&self, variables: &[f64], uncertain: &[f64]) -> Vec<f64> {
        let mut values = [variables, uncertain].concat();
        for expression in &self.lets {
            values.push(expression.value(&values));
        }
        values
    }
}

impl Device for Template {
    fn scenes(&self, variables: &[f64], uncertain: &[f64]) -> Result<Vec<World<Planar>>, String> {
        let numbers = self.numbers(variables, uncertain).map_err(|index| {
            let Expression { text, path, .. } = &self.expressions[index];
            format!("{path}: `{text}` has no finite value")
        })?;
        let tree = text::parse(&self.text).map_err(|fault| fault.kind().to_string())?;
        let mut reader = Reader::default();
        match reader.filled_scenes(tree, &numbers, &self.limits) {
            Some(worlds) if !reader.has_faults() => Ok(worlds),
            _ => Err(reader
                .into_faults()
                .first()
                .map_or_else(String::new, |fault| format!("{}: {}", fault.path(), fault.kind()))),
        }
    }

    fn dimensions(&self, variables: &[f64], uncertain: &[f64]) -> Vec<Dimension> {
        let values = self.values(variables, uncertain);
        self.lines.iter().filter_map(|line| line.at(&values)).collect()
    }
}

/// Whether strings at a key are names, not expressions.
pub fn is_name(key: Option<&str>) -> bool {
    matches!(key, Some("name" | "between"))
}

/// The entries and the scene of a document, with `numbers` in place of expressions.
pub fn filled<'t>(tree: &mut Value<'t>, numbers: &'t [String]) -> Option<(Vec<Value<'t>>, Value<'t>)> {
    let feeder = taken(tree, "feeder")?;
    let Value::Object(mut feeder) = feeder else { return None };
    let mut numbers = numbers.iter().map(String::as_str);
    let mut take = |key| {
        let at = feeder.properties.iter().position(|property| property.name.as_str() == key)?;
        let mut value = feeder.properties.swap_remove(at).value;
        fill(&mut value, None, &mut numbers);
        Some(value)
    };
    let Some(Value::Array(entries)) = take("entries") else { return None };
    Some((entries.elements, take("scene")?))
}

/// The scene with the pose and velocity of an entry in its first body.
pub fn with_entry<'t>(scene: &Value<'t>, entry: &Value<'t>) -> Value<'t> {
    let mut own = scene.clone();
    if let (Some(Value::Object(body)), Value::Object(entry)) = (first_body(&mut own), entry) {
        let moved = entry.properties.iter().filter(|property| property.name.as_str() != "name");
        body.properties.extend(moved.cloned());
    }
    own
}

fn first_body<'v, 't>(scene: &'v mut Value<'t>) -> Option<&'v mut Value<'t>> {
    let Value::Object(scene) = scene else { return None };
    let bodies = scene.properties.iter_mut().find(|property| property.name.as_str() == "bodies")?;
    let Value::Array(bodies) = &mut bodies.value else { return None };
    bodies.elements.first_mut()
}

fn taken<'t>(value: &mut Value<'t>, key: &str) -> Option<Value<'t>> {
    let Value::Object(object) = value else { return None };
    let at = object.properties.iter().position(|property| property.name.as_str() == key)?;
    Some(object.properties.swap_remove(at).value)
}

fn fill<'t>(value: &mut Value<'t>, key: Option<&str>, numbers: &mut impl Iterator<Item = &'t str>) {
    match value {
        Value::StringLit(literal) if !is_name(key) => {
            let range = literal.range();
            if let Some(number) = numbers.next() {
                *value = Value::NumberLit(NumberLit { range, value: number });
            }
        }
        Value::Array(array) if !is_name(key) => {
            array.elements.iter_mut().for_each(|element| fill(element, None, numbers));
            array.elements.retain_mut(|element| match element {
                Value::Object(object) => is_there(object),
                _ => true,
            });
        }
        Value::Object(object) => {
            for property in &mut object.properties {
                let key = property.name.as_str().to_owned();
                fill(&mut property.value, Some(&key), numbers);
            }
        }
        _ => {}
    }
}

/// Whether the condition of an object holds, if it has one; takes the condition away.
fn is_there(object: &mut Object) -> bool {
    let Some(at) = object.properties.iter().position(|property| property.name.as_str() == CONDITION) else {
        return true;
    };
    match &object.properties[at].value {
        Value::NumberLit(literal) => {
            let is_positive = literal.value.parse::<f64>().is_ok_and(|value| value > 0.0);
            object.properties.remove(at);
            is_positive
        }
        // what is no number stays and is refused as an unknown key
        _ => true,
    }
}
