//! Plans that a case brings along.

use super::kind::FaultKind;
use super::reader::{Path, Reader, span_of};
use super::show;
use crate::exact::Q;
use crate::model::{GivenPush, Shape};
use jsonc_parser::ast::Value;
use num_traits::{Signed as _, Zero as _};

const PUSH_HELP: &str =
    r#"write {"edge": 2, "s": "1/2"}, {"from": [x, y]} on a circle, {"tilt": [x, y]} or {"wrench": [fx, fy, torque]}"#;

const PINS_HELP: &str = "write the heights of the pins in the order met, like [3.9, 3.3]";

impl Reader {
    /// A push, a tilt or a wrench; `shape` is missing where it has faults of its own.
    pub fn given_push(&mut self, value: &Value, path: &Path, shape: Option<&Shape>) -> Option<GivenPush> {
        let fields = self.fields(value, path, &["edge", "s", "from", "tilt", "wrench"], PUSH_HELP)?;
        let ways = ["edge", "from", "tilt", "wrench"].into_iter().filter(|key| fields.get(key).is_some());
        let ways: Vec<&'static str> = ways.collect();
        let [way] = ways[..] else {
            match ways[..] {
                [first, second, ..] => {
                    self.exclude(&fields, [first, second], path, PUSH_HELP);
                }
                _ => {
                    self.require(&fields, "edge", path, PUSH_HELP);
                }
            }
            return None;
        };
        let given = fields.get(way)?;
        let inner = path.key(way);
        match (way, shape?) {
            ("edge", Shape::Polygon(polygon)) => {
                let edge = self.number(given, &inner)?;
                let edge = self.edge_number(&edge, span_of(given), &inner, polygon.n_edges());
                let s = self.require(&fields, "s", path, PUSH_HELP);
                let s = s.and_then(|value| self.share(value, &path.key("s")))?;
                Some(GivenPush::Edge { edge: edge?, s })
            }
            ("edge", Shape::Circle { .. }) | ("from", Shape::Polygon(_)) => {
                let kind = if way == "edge" { FaultKind::EdgeOfCircle } else { FaultKind::FromOnPolygon };
                self.fault(kind, fields.key_span(way), &inner, PUSH_HELP);
                None
            }
            ("from", Shape::Circle { .. }) => self.not_zero(given, &inner).map(GivenPush::Circle),
            ("tilt", _) => self.not_zero(given, &inner).map(GivenPush::Tilt),
            _ => self.not_zero(given, &inner).map(GivenPush::Wrench),
        }
    }

    /// Heights above the belt.
    pub fn given_pins(&mut self, value: &Value, path: &Path) -> Option<Vec<Q>> {
        let elements = &self.array(value, path, PINS_HELP)?.elements;
        let heights: Vec<Option<Q>> = elements
            .iter()
            .enumerate()
            .map(|(index, element)| {
                let path = path.index(index);
                let height = self.number(element, &path)?;
                if height.is_positive() {
                    return Some(height);
                }
                let kind = FaultKind::NotPositive { name: "a height", value: show::number(&height) };
                self.fault(kind, span_of(element), &path, "pins are above the belt");
                None
            })
            .collect();
        heights.into_iter().collect()
    }

    /// A vector that is not zero.
    fn not_zero<const N: usize>(&mut self, value: &Value, path: &Path) -> Option<[Q; N]> {
        let elements = &self.array(value, path, PUSH_HELP)?.elements;
        if elements.len() != N {
            let kind = FaultKind::WrongLength { expected: N, found: elements.len() };
            self.fault(kind, span_of(value), path, PUSH_HELP);
            return None;
        }
        let entries: Vec<Option<Q>> =
            elements.iter().enumerate().map(|(index, element)| self.number(element, &path.index(index))).collect();
        let entries: [Q; N] = entries.into_iter().collect::<Option<Vec<_>>>()?.try_into().ok()?;
        if entries.iter().all(Q::is_zero) {
            self.fault(FaultKind::ZeroPush, span_of(value), path, PUSH_HELP);
            return None;
        }
        Some(entries)
    }
}
