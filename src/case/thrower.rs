//! The `throw` section: the arm, gravity, and the friction between arm and part.

use super::SMALLEST_THROW;
use super::kind::FaultKind;
use super::reader::{Path, Reader, span_of};
use super::show;
use crate::exact::{Q, ratio};
use crate::model::{LengthUnit, Shape, Thrower};
use jsonc_parser::ast::Value;
use num_traits::Signed as _;
use std::ops::Range;

const OFFSET_HELP: &str = "write the height of the arm's surface over its pivot, -0.5 for instance";
const RELEASE_HELP: &str = "write the arm's speed at release in degrees per second, 320 for instance";

impl Reader {
    /// The arm; `shape` is missing where it has faults of its own, `key` is where the section is named.
    pub fn thrower(
        &mut self,
        value: &Value,
        key: Range<usize>,
        path: &Path,
        shape: Option<&Shape>,
        unit: LengthUnit,
    ) -> Option<Thrower> {
        if let Some(Shape::Circle { .. }) = shape {
            let help = "a part is thrown from its edges: give it as a polygon, or leave the section out";
            self.fault(FaultKind::EdgeOfCircle, key, path, help);
        }
        let known = ["offset", "release_deg_per_s", "gravity", "friction"];
        let fields = self.fields(value, path, &known, SMALLEST_THROW)?;
        let offset = self.require(&fields, "offset", path, OFFSET_HELP);
        let offset = offset.and_then(|value| self.number(value, &path.key("offset")));
        let release = self.require(&fields, "release_deg_per_s", path, RELEASE_HELP).is_some();
        let release = if release { self.optional_positive(&fields, "release_deg_per_s", path) } else { None };
        let gravity = self.optional_positive(&fields, "gravity", path);
        let friction = match fields.get("friction") {
            None => Some(None),
            Some(value) => self.single_friction(value, &path.key("friction")).and_then(|range| {
                if range.min.is_positive() {
                    return Some(Some(range));
                }
                let kind = FaultKind::NotPositive { name: "friction", value: show::number(&range.min) };
                let help = "write a coefficient above 0, or leave friction out to learn how much is needed";
                self.fault(kind, span_of(value), &path.key("friction"), help);
                None
            }),
        };
        Some(Thrower {
            offset: offset?,
            release_deg_per_s: release??,
            gravity: gravity?.unwrap_or_else(|| standard_gravity(unit)),
            friction: friction?,
        })
    }
}

/// 9.81 m/s².
fn standard_gravity(unit: LengthUnit) -> Q {
    let units = match unit {
        LengthUnit::Metre => 1,
        LengthUnit::Centimetre => 100,
        LengthUnit::Millimetre => 1_000,
    };
    ratio(981 * units, 100)
}
