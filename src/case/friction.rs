//! The spellings of friction.

use super::fault::Fault;
use super::kind::FaultKind;
use super::reader::{Fields, Path, Reader, span_of};
use super::show;
use crate::exact::{Q, ratio};
use crate::geometry::tangent_of_degrees;
use crate::model::{Friction, Range};
use jsonc_parser::ast::Value;
use num_traits::Signed as _;

pub(super) const FRICTION_HELP: &str =
    r#"write 0.2, {"static": 0.3, "kinetic": 0.2}, {"min": 0.1, "max": 0.3} or {"angle_deg": 15}"#;
pub(super) const SINGLE_HELP: &str = r#"write 0.2, {"min": 0.1, "max": 0.3} or {"angle_deg": 15}"#;
const RANGE_HELP: &str = r#"write 0.2 or {"min": 0.1, "max": 0.3}"#;
const ANGLE_HELP: &str = r#"write {"angle_deg": 53} or {"angle_deg": {"min": 51, "max": 55}}"#;

/// Friction as it is written.
enum Spelling<'v> {
    Number(Q),
    Keys(Fields<'v>),
}

impl Reader {
    /// Friction in any of its forms.
    pub fn friction(&mut self, value: &Value, path: &Path) -> Option<Friction> {
        let fields = match self.spelling(value, path, FRICTION_HELP)? {
            Spelling::Number(coefficient) => return Some(both(Range::exactly(coefficient))),
            Spelling::Keys(fields) => fields,
        };
        for (present, other) in [("min", "static"), ("max", "static"), ("min", "kinetic"), ("max", "kinetic")] {
            if self.exclude(&fields, [present, other], path, FRICTION_HELP) {
                return None;
            }
        }
        for other in ["static", "kinetic", "min", "max"] {
            if self.exclude(&fields, ["angle_deg", other], path, FRICTION_HELP) {
                return None;
            }
        }
        if ["angle_deg", "min", "max"].iter().any(|key| fields.get(key).is_some()) {
            return self.keyed_range(&fields, path, FRICTION_HELP).map(both);
        }
        let static_value = self.require(&fields, "static", path, FRICTION_HELP);
        let static_ = static_value.and_then(|value| self.range(value, &path.key("static")));
        let Some(kinetic_value) = fields.get("kinetic") else {
            return static_.map(both);
        };
        let kinetic = self.range(kinetic_value, &path.key("kinetic"))?;
        let friction = Friction { static_: static_?, kinetic };
        let ends = |range: &Range| [range.min.clone(), range.max.clone()];
        let ends = ends(&friction.kinetic).into_iter().zip(ends(&friction.static_)).zip(["min", "max"]);
        let Some(((kinetic, static_), end)) = ends.into_iter().find(|((kinetic, static_), _)| kinetic > static_) else {
            return Some(friction);
        };
        let kind = FaultKind::KineticAboveStatic { kinetic: show::number(&kinetic), static_: show::number(&static_) };
        let fault = Fault::new(kind).at(span_of(kinetic_value)).on(path.key("kinetic").to_string());
        let fault = fault.help(format!("the {end} of kinetic friction must be at most that of static friction"));
        self.push(fault.related(span_of(static_value?), "static friction"));
        None
    }

    /// Friction in any form but a pair of a static and a kinetic coefficient: for contacts that may slide at any time.
    pub fn single_friction(&mut self, value: &Value, path: &Path) -> Option<Range> {
        let fields = match self.spelling(value, path, SINGLE_HELP)? {
            Spelling::Number(coefficient) => return Some(Range::exactly(coefficient)),
            Spelling::Keys(fields) => fields,
        };
        if let Some(key) = ["static", "kinetic"].into_iter().find(|key| fields.get(key).is_some()) {
            let help = r#"write one coefficient like 0.2, or {"min": 0.2, "max": 0.3} to cover both"#;
            self.fault(FaultKind::FrictionPair { key }, fields.key_span(key), &path.key(key), help);
            return None;
        }
        for other in ["min", "max"] {
            if self.exclude(&fields, ["angle_deg", other], path, SINGLE_HELP) {
                return None;
            }
        }
        self.keyed_range(&fields, path, SINGLE_HELP)
    }

    fn spelling<'v>(&mut self, value: &'v Value<'v>, path: &Path, help: &str) -> Option<Spelling<'v>> {
        match value {
            Value::NumberLit(_) | Value::StringLit(_) => self.coefficient(value, path, help).map(Spelling::Number),
            Value::Object(_) => {
                let known = ["static", "kinetic", "min", "max", "angle_deg"];
                self.fields(value, path, &known, help).map(Spelling::Keys)
            }
            _ => {
                self.wrong_type("a number or an object", value, path, help);
                None
            }
        }
    }

    /// The range of `angle_deg`, or of `min` and `max`.
    fn keyed_range(&mut self, fields: &Fields, path: &Path, help: &str) -> Option<Range> {
        match fields.get("angle_deg") {
            Some(angle) => self.angle(angle, &path.key("angle_deg")),
            None => self.min_max(fields, path, help, |reader, value, path| reader.coefficient(value, path, help)),
        }
    }

    fn range(&mut self, value: &Value, path: &Path) -> Option<Range> {
        match value {
            Value::Object(_) => {
                let fields = self.fields(value, path, &["min", "max"], RANGE_HELP)?;
                let coefficient =
                    |reader: &mut Self, value: &Value, path: &Path| reader.coefficient(value, path, FRICTION_HELP);
                self.min_max(&fields, path, RANGE_HELP, coefficient)
            }
            Value::NumberLit(_) | Value::StringLit(_) => {
                self.coefficient(value, path, FRICTION_HELP).map(Range::exactly)
            }
            _ => {
                self.wrong_type("a number or an object", value, path, RANGE_HELP);
                None
            }
        }
    }

    fn angle(&mut self, value: &Value, path: &Path) -> Option<Range> {
        let degrees = match value {
            Value::Object(_) => {
                let fields = self.fields(value, path, &["min", "max"], ANGLE_HELP)?;
                self.min_max(&fields, path, ANGLE_HELP, Self::degrees)
            }
            Value::NumberLit(_) | Value::StringLit(_) => self.degrees(value, path).map(Range::exactly),
            _ => {
                self.wrong_type("a number or an object", value, path, ANGLE_HELP);
                None
            }
        }?;
        let min = tangent_of_degrees(&degrees.min)?;
        let max = tangent_of_degrees(&degrees.max)?;
        Some(Range { min: min.lower, max: max.upper })
    }

    fn min_max(
        &mut self,
        fields: &Fields,
        path: &Path,
        help: &str,
        read: impl Fn(&mut Self, &Value, &Path) -> Option<Q>,
    ) -> Option<Range> {
        let min_value = self.require(fields, "min", path, help);
        let max_value = self.require(fields, "max", path, help);
        let min = min_value.and_then(|value| read(self, value, &path.key("min")));
        let max = max_value.and_then(|value| read(self, value, &path.key("max")));
        let range = Range { min: min?, max: max? };
        if range.min > range.max {
            let kind = FaultKind::EmptyRange { min: show::number(&range.min), max: show::number(&range.max) };
            let fault = Fault::new(kind).at(span_of(min_value?)).on(path.key("min").to_string());
            self.push(fault.help("swap the two").related(span_of(max_value?), "max"));
            return None;
        }
        Some(range)
    }

    pub fn coefficient(&mut self, value: &Value, path: &Path, help: &str) -> Option<Q> {
        let number = self.number(value, path)?;
        if number.is_negative() {
            let kind = FaultKind::Negative { name: "a friction coefficient", value: show::number(&number) };
            self.fault(kind, span_of(value), path, help);
            return None;
        }
        Some(number)
    }

    fn degrees(&mut self, value: &Value, path: &Path) -> Option<Q> {
        let number = self.number(value, path)?;
        if number.is_negative() || number >= ratio(90, 1) {
            let kind = FaultKind::OutOfRange {
                name: "a friction angle",
                range: "at least 0 and below 90 degrees".into(),
                value: show::number(&number),
            };
            self.fault(kind, span_of(value), path, ANGLE_HELP);
            return None;
        }
        Some(number)
    }
}

fn both(range: Range) -> Friction {
    Friction { static_: range.clone(), kinetic: range }
}
