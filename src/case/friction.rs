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
const RANGE_HELP: &str = r#"write 0.2 or {"min": 0.1, "max": 0.3}"#;
const ANGLE_HELP: &str = r#"write {"angle_deg": 53} or {"angle_deg": {"min": 51, "max": 55}}"#;

impl Reader {
    /// Friction in any of its forms.
    pub fn friction(&mut self, value: &Value, path: &Path) -> Option<Friction> {
        if matches!(value, Value::NumberLit(_) | Value::StringLit(_)) {
            let coefficient = Range::exactly(self.coefficient(value, path)?);
            return Some(both(coefficient));
        }
        if !matches!(value, Value::Object(_)) {
            self.wrong_type("a number or an object", value, path, FRICTION_HELP);
            return None;
        }
        let fields = self.fields(value, path, &["static", "kinetic", "min", "max", "angle_deg"], FRICTION_HELP)?;
        let has = |key: &str| fields.get(key).is_some();
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
        if let Some(angle) = fields.get("angle_deg") {
            return self.angle(angle, &path.key("angle_deg")).map(both);
        }
        if has("min") || has("max") {
            return self.min_max(&fields, path, FRICTION_HELP, Self::coefficient).map(both);
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

    fn range(&mut self, value: &Value, path: &Path) -> Option<Range> {
        match value {
            Value::Object(_) => {
                let fields = self.fields(value, path, &["min", "max"], RANGE_HELP)?;
                self.min_max(&fields, path, RANGE_HELP, Self::coefficient)
            }
            Value::NumberLit(_) | Value::StringLit(_) => self.coefficient(value, path).map(Range::exactly),
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

    fn coefficient(&mut self, value: &Value, path: &Path) -> Option<Q> {
        let number = self.number(value, path)?;
        if number.is_negative() {
            let kind = FaultKind::Negative { name: "a friction coefficient", value: show::number(&number) };
            self.fault(kind, span_of(value), path, FRICTION_HELP);
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
