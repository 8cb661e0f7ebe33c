//! The `pins` section: the friction of a conveyor and of the pins over it.

use super::SMALLEST_PINS;
use super::friction::SINGLE_HELP;
use super::kind::FaultKind;
use super::reader::{Path, Reader};
use crate::exact::Q;
use crate::model::{Conveyor, Shape};
use jsonc_parser::ast::Value;
use std::ops::Range;

impl Reader {
    /// The conveyor, and the heights of pins given with it; `shape` is missing where it has faults of its own, `key` is where the section is named.
    pub fn conveyor(
        &mut self,
        value: &Value,
        key: Range<usize>,
        path: &Path,
        shape: Option<&Shape>,
    ) -> Option<(Conveyor, Vec<Q>)> {
        if let Some(Shape::Circle { .. }) = shape {
            let help = "pins turn a part from one edge to another: give it as a polygon, or leave the section out";
            self.fault(FaultKind::EdgeOfCircle, key, path, help);
        }
        let fields = self.fields(value, path, &["belt_friction", "pin_friction", "plan"], SMALLEST_PINS)?;
        let [belt_friction, pin_friction] = ["belt_friction", "pin_friction"].map(|name| {
            let value = self.require(&fields, name, path, SINGLE_HELP)?;
            self.single_friction(value, &path.key(name))
        });
        let plan = match fields.get("plan") {
            Some(plan) => self.given_pins(plan, &path.key("plan")),
            None => Some(Vec::new()),
        };
        Some((Conveyor { belt_friction: belt_friction?, pin_friction: pin_friction? }, plan?))
    }
}
