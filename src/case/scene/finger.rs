//! A fingertip that presses on a body.

use super::super::kind::FaultKind;
use super::super::reader::{Path, Reader, span_of};
use super::double::Bound;
use crate::model::{Finger, PlanarShape};
use jsonc_parser::ast::Value;

pub const FINGER_HELP: &str =
    r#"write {"edge": 2, "at": [0.1, 0], "direction": [0, 1], "force": 1}; without "edge" on a disc"#;

impl Reader {
    /// A finger; `shape` is that of the body, if it could be read.
    pub fn finger(&mut self, value: &Value, path: &Path, shape: Option<&PlanarShape>) -> Option<Finger> {
        let fields = self.fields(value, path, &["edge", "at", "direction", "force"], FINGER_HELP)?;
        let at = self.require(&fields, "at", path, FINGER_HELP);
        let at = at.and_then(|value| self.doubles(value, &path.key("at"), "write [x, y], a point of its guide"));
        let direction = self.require(&fields, "direction", path, FINGER_HELP);
        let help = "write the vector along which it presses, like [0, 1]";
        let direction = direction.and_then(|value| self.direction(value, &path.key("direction"), help));
        self.require(&fields, "force", path, FINGER_HELP);
        let force = self.optional_double(&fields, "force", path, Bound::NotNegative);
        let edge = match shape? {
            PlanarShape::Polygon(vertices) => {
                let value = self.require(&fields, "edge", path, FINGER_HELP)?;
                Some(self.edge(value, &path.key("edge"), vertices.len())?)
            }
            PlanarShape::Circle { .. } if fields.get("edge").is_some() => {
                let help = "leave out \"edge\": the finger presses where its guide enters the disc";
                self.fault(FaultKind::EdgeOfCircle, fields.key_span("edge"), &path.key("edge"), help);
                return None;
            }
            PlanarShape::Circle { .. } => None,
            PlanarShape::HalfPlane { .. } | PlanarShape::Compound(_) => {
                let kind = FaultKind::WrongMotion { key: "finger", what: "polygonal and round" };
                self.fault(kind, span_of(value), path, "give the body one polygon or circle, or push it by a wrench");
                return None;
            }
        };
        Some(Finger { edge, at: at?, direction: direction?, force: force?? })
    }

    fn edge(&mut self, value: &Value, path: &Path, n_edges: usize) -> Option<usize> {
        let number = self.number(value, path)?;
        self.edge_number(&number, span_of(value), path, n_edges)
    }
}
