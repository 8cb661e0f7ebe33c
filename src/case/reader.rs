//! Typed access to the syntax tree that collects faults instead of stopping at the first.

use super::fault::Fault;
use super::kind::FaultKind;
use super::show::clipped;
use super::suggest;
use super::text::{NUMBER_HELP, is_not_finite};
use crate::exact::{LiteralError, Q, parse_literal};
use jsonc_parser::ast::{Array, ObjectProp, Value};
use jsonc_parser::common::Ranged;
use std::collections::HashMap;
use std::fmt;
use std::ops::Range;

/// Most faults kept of one file.
const MAX_FAULTS: usize = 10_000;

/// Longest number literal, counting digits.
const MAX_LITERAL_DIGITS: usize = 20_000;

/// Digits and decimal places of all numbers of a file together, so that reading ends in bounded time.
const MAX_TOTAL_DIGITS: usize = 1_000_000;

/// What has been found out about a file so far.
#[derive(Default)]
pub(super) struct Reader {
    faults: Vec<Fault>,
    pub warnings: Vec<String>,
    digits: usize,
}

/// A place in the document, like `insert.fixels[1].friction`.
#[derive(Clone, Copy)]
pub(super) struct Path<'p> {
    parent: Option<&'p Self>,
    step: Step<'p>,
}

#[derive(Clone, Copy)]
enum Step<'p> {
    Document,
    Key(&'p str),
    Index(usize),
}

impl<'p> Path<'p> {
    pub fn document() -> Self {
        Path { parent: None, step: Step::Document }
    }

    pub fn key(&'p self, key: &'p str) -> Self {
        Path { parent: Some(self), step: Step::Key(key) }
    }

    pub fn index(&'p self, index: usize) -> Self {
        Path { parent: Some(self), step: Step::Index(index) }
    }
}

impl fmt::Display for Path<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Some(parent) = self.parent else {
            return Ok(());
        };
        parent.fmt(f)?;
        match self.step {
            Step::Document => Ok(()),
            Step::Index(index) => write!(f, "[{index}]"),
            Step::Key(key) if parent.parent.is_none() => f.write_str(&clipped(key)),
            Step::Key(key) => write!(f, ".{}", clipped(key)),
        }
    }
}

/// The properties of an object, each known key at most once.
pub(super) struct Fields<'v> {
    pub span: Range<usize>,
    properties: HashMap<&'v str, &'v ObjectProp<'v>>,
}

impl<'v> Fields<'v> {
    pub fn get(&self, key: &str) -> Option<&'v Value<'v>> {
        self.properties.get(key).map(|property| &property.value)
    }

    pub fn is_empty(&self) -> bool {
        self.properties.is_empty()
    }

    /// Bytes of the key itself.
    pub fn key_span(&self, key: &str) -> Range<usize> {
        self.properties.get(key).map_or(self.span.clone(), |property| span_of(&property.name))
    }
}

impl Reader {
    pub fn push(&mut self, fault: Fault) {
        if self.faults.len() < MAX_FAULTS {
            self.faults.push(fault);
        }
    }

    pub fn fault(&mut self, kind: FaultKind, span: Range<usize>, path: &Path, help: impl Into<String>) {
        self.push(Fault::new(kind).at(span).on(path.to_string()).help(help));
    }

    /// All faults by position.
    pub fn into_faults(mut self) -> Vec<Fault> {
        self.faults.sort_by_key(|fault| fault.span().map_or((0, 0), |span| (span.start, span.end)));
        self.faults
    }

    pub fn has_faults(&self) -> bool {
        !self.faults.is_empty()
    }

    /// The properties of an object that knows the keys `known`.
    pub fn fields<'v>(
        &mut self,
        value: &'v Value<'v>,
        path: &Path,
        known: &[&'static str],
        example: &str,
    ) -> Option<Fields<'v>> {
        let Value::Object(object) = value else {
            self.wrong_type("an object", value, path, example);
            return None;
        };
        let mut fields = Fields { span: span_of(object), properties: HashMap::new() };
        for property in &object.properties {
            let (key, span) = (property.name.as_str(), span_of(&property.name));
            if let Some(first) = fields.properties.get(key) {
                let fault = Fault::new(FaultKind::DuplicateKey { key: clipped(key) });
                let fault = fault.at(span).on(path.key(key).to_string()).help("keep one of the two");
                self.push(fault.related(span_of(&first.name), "first given here"));
                continue;
            }
            fields.properties.insert(key, property);
            if !known.contains(&key) {
                let help = match suggest::nearest(key, known) {
                    Some(near) => format!("did you mean `{near}`?"),
                    None => format!("known keys here: {}", known.join(", ")),
                };
                self.fault(FaultKind::UnknownKey { key: clipped(key) }, span, &path.key(key), help);
            }
        }
        Some(fields)
    }

    /// The value of a required key.
    pub fn require<'v>(
        &mut self,
        fields: &Fields<'v>,
        key: &'static str,
        path: &Path,
        help: &str,
    ) -> Option<&'v Value<'v>> {
        let value = fields.get(key);
        if value.is_none() {
            self.fault(FaultKind::MissingKey { key }, fields.span.clone(), &path.key(key), help);
        }
        value
    }

    /// Reports two keys that exclude each other; whether both are there.
    pub fn exclude(&mut self, fields: &Fields, [first, second]: [&'static str; 2], path: &Path, help: &str) -> bool {
        if fields.get(first).is_none() || fields.get(second).is_none() {
            return false;
        }
        let (mut spans, mut keys) = ([first, second].map(|key| fields.key_span(key)), [first, second]);
        if spans[0].start > spans[1].start {
            spans.reverse();
            keys.reverse();
        }
        let [earlier, later] = spans;
        let kind = FaultKind::ExclusiveKeys { first: first.into(), second: second.into() };
        let fault = Fault::new(kind).at(later).on(path.key(keys[1]).to_string()).help(help);
        self.push(fault.related(earlier, format!("`{}` is given here", keys[0])));
        true
    }

    pub fn array<'v>(&mut self, value: &'v Value<'v>, path: &Path, help: &str) -> Option<&'v Array<'v>> {
        if let Value::Array(array) = value {
            return Some(array);
        }
        self.wrong_type("a list", value, path, help);
        None
    }

    pub fn string<'v>(&mut self, value: &'v Value<'v>, path: &Path, help: &str) -> Option<&'v str> {
        if let Value::StringLit(text) = value {
            return Some(&text.value);
        }
        self.wrong_type("a string", value, path, help);
        None
    }

    pub fn pair(&mut self, value: &Value, path: &Path) -> Option<[Q; 2]> {
        let help = "write two numbers like [0.5, \"1/3\"]";
        let array = self.array(value, path, help)?;
        if array.elements.len() != 2 {
            let kind = FaultKind::WrongLength { expected: 2, found: array.elements.len() };
            self.fault(kind, span_of(array), path, help);
            return None;
        }
        let x = self.number(&array.elements[0], &path.index(0));
        let y = self.number(&array.elements[1], &path.index(1));
        Some([x?, y?])
    }

    /// An exact number: a literal, or a string that holds one.
    pub fn number(&mut self, value: &Value, path: &Path) -> Option<Q> {
        let text = match value {
            Value::NumberLit(literal) => literal.value,
            Value::StringLit(literal) => &literal.value,
            _ => {
                self.wrong_type("a number", value, path, NUMBER_HELP);
                return None;
            }
        };
        if self.digits > MAX_TOTAL_DIGITS {
            // said once
            return None;
        }
        let number = self.weigh(text).and_then(|()| parse_literal(text).map_err(|reason| literal_fault(text, reason)));
        match number {
            Ok(number) => Some(number),
            Err(kind) => {
                let is_long = matches!(kind, FaultKind::TooManyDigits { .. });
                let help = if is_long { "round it to fewer digits" } else { NUMBER_HELP };
                self.fault(kind, span_of(value), path, help);
                None
            }
        }
    }

    pub fn wrong_type(&mut self, expected: &'static str, value: &Value, path: &Path, help: &str) {
        self.fault(FaultKind::WrongType { expected, found: type_name(value) }, span_of(value), path, help);
    }

    fn weigh(&mut self, text: &str) -> Result<(), FaultKind> {
        if text.len() > MAX_LITERAL_DIGITS {
            return Err(FaultKind::TooManyDigits {
                what: "the number has",
                digits: text.len(),
                limit: MAX_LITERAL_DIGITS,
            });
        }
        let places =
            text.find(['e', 'E']).and_then(|at| text[at + 1..].trim_start_matches(['+', '-']).parse::<usize>().ok());
        // a larger exponent is refused by the literal itself
        self.digits += text.len() + places.unwrap_or(0).min(MAX_LITERAL_DIGITS);
        if self.digits > MAX_TOTAL_DIGITS {
            return Err(FaultKind::TooManyDigits {
                what: "the numbers up to this one have",
                digits: self.digits,
                limit: MAX_TOTAL_DIGITS,
            });
        }
        Ok(())
    }
}

fn literal_fault(text: &str, reason: LiteralError) -> FaultKind {
    if is_not_finite(text.trim()) {
        return FaultKind::NotFinite { text: clipped(text) };
    }
    FaultKind::Literal { text: clipped(text), reason }
}

/// The bytes of a node.
pub(super) fn span_of(node: &impl Ranged) -> Range<usize> {
    let range = node.range();
    range.start..range.end
}

fn type_name(value: &Value) -> &'static str {
    match value {
        Value::StringLit(_) => "a string",
        Value::NumberLit(_) => "a number",
        Value::BooleanLit(_) => "a boolean",
        Value::Object(_) => "an object",
        Value::Array(_) => "a list",
        Value::NullKeyword(_) => "null",
    }
}
