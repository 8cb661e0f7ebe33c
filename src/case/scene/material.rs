//! Friction, restitution and compliance, as the scene, a body or a pair states them.

use super::super::kind::FaultKind;
use super::super::reader::{Fields, Path, Reader, span_of};
use super::super::show;
use super::double::{Bound, rounded};
use crate::exact::{Q, ratio};
use crate::geometry::tangent_of_degrees;
use crate::model::{Compliance, Restitution};
use jsonc_parser::ast::Value;
use num_traits::{One as _, Signed as _};
use std::ops::Range;

pub const FRICTION_HELP: &str = r#"write one coefficient like 0.2, or {"angle_deg": 15}"#;
const RESTITUTION_HELP: &str = r#"write 0.5, {"newton": 0.5} or {"poisson": 0.5}"#;
const CONTACT_HELP: &str = r#"write {"stiffness": 5e4, "damping": 14, "gamma": 1e-8}, in N/m, N s/m and N"#;

/// γ (N) of the smoothed friction cone where the file gives none.
const GAMMA: f64 = 1e-8;

/// A value that a place of the file may state.
#[derive(Debug, Clone, PartialEq)]
pub enum Setting<T> {
    Absent,
    Faulty,
    Given(T, Range<usize>),
}

/// What one place of the file states.
#[derive(Debug, Clone, PartialEq)]
pub struct Settings {
    pub friction: Setting<f64>,
    pub restitution: Setting<Restitution>,
    pub contact: Setting<Compliance>,
}

impl Reader {
    pub fn settings(&mut self, fields: &Fields, path: &Path) -> Settings {
        Settings {
            friction: self.setting(fields, "friction", path, Self::one_friction),
            restitution: self.setting(fields, "restitution", path, Self::restitution),
            contact: self.setting(fields, "contact", path, Self::compliance),
        }
    }

    fn setting<T>(
        &mut self,
        fields: &Fields,
        key: &'static str,
        path: &Path,
        read: impl FnOnce(&mut Self, &Value, &Path) -> Option<T>,
    ) -> Setting<T> {
        let Some(value) = fields.get(key) else {
            return Setting::Absent;
        };
        read(self, value, &path.key(key)).map_or(Setting::Faulty, |found| Setting::Given(found, span_of(value)))
    }

    /// One coefficient of friction.
    fn one_friction(&mut self, value: &Value, path: &Path) -> Option<f64> {
        if !matches!(value, Value::Object(_)) {
            let coefficient = self.coefficient(value, path, FRICTION_HELP)?;
            return self.nearest(&coefficient, value, path);
        }
        let fields = self.fields(value, path, &["angle_deg", "static", "kinetic", "min", "max"], FRICTION_HELP)?;
        if let Some(key) = ["static", "kinetic", "min", "max"].into_iter().find(|key| fields.get(key).is_some()) {
            self.fault(FaultKind::SeveralFrictions, fields.key_span(key), &path.key(key), FRICTION_HELP);
            return None;
        }
        let angle = self.require(&fields, "angle_deg", path, FRICTION_HELP)?;
        let path = path.key("angle_deg");
        if matches!(angle, Value::Object(_)) {
            self.fault(FaultKind::SeveralFrictions, span_of(angle), &path, FRICTION_HELP);
            return None;
        }
        let degrees = self.number(angle, &path)?;
        let Some(tangent) = tangent_of_degrees(&degrees).filter(|_| !degrees.is_negative() && degrees < ratio(90, 1))
        else {
            let range = "at least 0 and below 90 degrees".to_owned();
            let kind = FaultKind::OutOfRange { name: "a friction angle", range, value: show::number(&degrees) };
            self.fault(kind, span_of(angle), &path, FRICTION_HELP);
            return None;
        };
        self.nearest(&((tangent.lower + tangent.upper) / Q::from_integer(2.into())), angle, &path)
    }

    fn restitution(&mut self, value: &Value, path: &Path) -> Option<Restitution> {
        if !matches!(value, Value::Object(_)) {
            return self.share_of_one(value, path).map(Restitution::Newton);
        }
        let fields = self.fields(value, path, &["newton", "poisson"], RESTITUTION_HELP)?;
        let key = self.one_of(&fields, &["newton", "poisson"], path, RESTITUTION_HELP)?;
        let coefficient = self.share_of_one(fields.get(key)?, &path.key(key))?;
        Some(if key == "newton" { Restitution::Newton(coefficient) } else { Restitution::Poisson(coefficient) })
    }

    fn share_of_one(&mut self, value: &Value, path: &Path) -> Option<f64> {
        let number = self.number(value, path)?;
        if number.is_negative() || number > Q::one() {
            let kind = FaultKind::OutOfRange {
                name: "a coefficient of restitution",
                range: "between 0 and 1".to_owned(),
                value: show::number(&number),
            };
            self.fault(kind, span_of(value), path, RESTITUTION_HELP);
            return None;
        }
        self.nearest(&number, value, path)
    }

    fn compliance(&mut self, value: &Value, path: &Path) -> Option<Compliance> {
        let fields = self.fields(value, path, &["stiffness", "damping", "gamma"], CONTACT_HELP)?;
        let [stiffness, damping] =
            [("stiffness", Bound::Positive), ("damping", Bound::NotNegative)].map(|(key, bound)| {
                let value = self.require(&fields, key, path, CONTACT_HELP)?;
                self.normal_and_tangential(value, &path.key(key), key, bound)
            });
        let gamma = self.optional_double(&fields, "gamma", path, Bound::NotNegative);
        Some(Compliance { stiffness: stiffness?, damping: damping?, gamma: gamma?.unwrap_or(GAMMA) })
    }

    /// One number for both, or two.
    fn normal_and_tangential(
        &mut self,
        value: &Value,
        path: &Path,
        name: &'static str,
        bound: Bound,
    ) -> Option<[f64; 2]> {
        let Value::Array(array) = value else {
            return self.double(value, path, name, bound).map(|number| [number; 2]);
        };
        let [normal, tangential] = array.elements.as_slice() else {
            let kind = FaultKind::WrongLength { expected: 2, found: array.elements.len() };
            self.fault(kind, span_of(value), path, "write one number, or [normal, tangential]");
            return None;
        };
        let normal = self.double(normal, &path.index(0), name, bound);
        let tangential = self.double(tangential, &path.index(1), name, bound);
        Some([normal?, tangential?])
    }

    fn nearest(&mut self, number: &Q, value: &Value, path: &Path) -> Option<f64> {
        let near = rounded(number);
        if near.is_none() {
            let kind = FaultKind::NotADouble { value: show::number(number) };
            self.fault(kind, span_of(value), path, "write a number between 1e-300 and 1e300 in size");
        }
        near
    }
}
