//! What a drawing of a device measures: its `dimensions`.

use super::super::expression::Expression;
use super::super::reader::{Fields, Path, Reader};
use crate::model::Dimension;
use jsonc_parser::ast::Value;

const HELP: &str =
    r#"write "dimensions": [{"of": "gap", "from": [0, 0], "to": ["gap", 0]}], and for an angle its "corner""#;

/// A dimension whose points are expressions.
#[derive(Debug)]
pub struct DimensionLine {
    name: String,
    ends: [[Expression; 2]; 2],
    corner: Option<[Expression; 2]>,
}

impl DimensionLine {
    /// With these values of all names; `None` where a point has none.
    pub fn at(&self, values: &[f64]) -> Option<Dimension> {
        let point = |point: &[Expression; 2]| point.each_ref().map(|expression| expression.value(values));
        let (ends, corner) = (self.ends.each_ref().map(point), self.corner.as_ref().map(point));
        let is_finite = ends.iter().chain(&corner).flatten().all(|entry| entry.is_finite());
        is_finite.then(|| Dimension { name: self.name.clone(), ends, corner })
    }
}

impl Reader {
    /// The `dimensions` of a device, in these names.
    pub fn dimensions(&mut self, fields: &Fields, path: &Path, names: &[String]) -> Option<Vec<DimensionLine>> {
        let Some(value) = fields.get("dimensions") else { return Some(Vec::new()) };
        let path = path.key("dimensions");
        let elements = self.array(value, &path, HELP)?.elements.iter().enumerate();
        elements.map(|(index, value)| self.dimension_line(value, &path.index(index), names)).collect()
    }

    fn dimension_line(&mut self, value: &Value, path: &Path, names: &[String]) -> Option<DimensionLine> {
        let fields = self.fields(value, path, &["of", "from", "to", "corner"], HELP)?;
        let [of, from, to] = ["of", "from", "to"].map(|key| self.require(&fields, key, path, HELP));
        let name = self.string(of?, &path.key("of"), HELP)?.to_owned();
        let from = self.point(from?, &path.key("from"), names)?;
        let to = self.point(to?, &path.key("to"), names)?;
        let corner = match fields.get("corner") {
            Some(value) => Some(self.point(value, &path.key("corner"), names)?),
            None => None,
        };
        Some(DimensionLine { name, ends: [from, to], corner })
    }

    fn point(&mut self, value: &Value, path: &Path, names: &[String]) -> Option<[Expression; 2]> {
        match &self.array(value, path, HELP)?.elements[..] {
            [x, y] => Some([self.expression(x, &path.index(0), names)?, self.expression(y, &path.index(1), names)?]),
            _ => {
                self.wrong_type("two coordinates", value, path, HELP);
                None
            }
        }
    }
}
