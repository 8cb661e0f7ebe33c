//! The `feeder` section: a scene whose numbers are expressions in dimensions to be chosen.

use super::super::expression::{Expression, NoExpression, RESERVED};
use super::super::kind::FaultKind;
use super::super::reader::{Fields, Path, Reader, span_of};
use super::super::show::{self, clipped};
use super::super::{Fault, KEYS, Limits, missing_section, suggest, text};
use super::double::Bound;
use super::template::{self, Template};
use crate::model::{Feeder, Goal, Planar, Rest, Uncertain, Variable, World};
use jsonc_parser::ast::{ObjectProp, Value};

/// The smallest `feeder` section.
pub const SMALLEST_FEEDER: &str = r#""feeder": {"variables": {"gap": {"min": 0.01, "max": 0.05, "start": 0.02}}, "entries": [{"pose": [0, 1, 0]}], "goal": {"pose": [0, -1, 0]}, "scene": {"duration": 1, "friction": 0.2, "bodies": [{"shape": {"circle": {"center": [0, 0], "radius": 0.01}}, "mass": 1}], "fixed": [{"shape": {"polygon": [["gap", 0], [1, 0], [1, 0.1], ["gap", 0.1]]}}]}}"#;

const VARIABLES_HELP: &str = r#"write "variables": {"gap": {"min": 0.01, "max": 0.05, "start": 0.02}}"#;
const UNCERTAIN_HELP: &str = r#"write "uncertain": {"mu": {"value": 0.2, "off": 0.02}}"#;
const LET_HELP: &str = r#"write "let": {"half": "gap/2"}"#;
const ENTRIES_HELP: &str = r#"write "entries": [{"name": "upright", "pose": [0, "1 + gap", "PI/2"]}]"#;
const GOAL_HELP: &str = r#"write "goal": {"pose": [0, -0.1, -1.5708], "within": [0.01, 0.2], "weight": 5}"#;

/// What a file with a feeder says.
#[derive(Debug)]
pub struct FeederCase {
    /// Its name, if given.
    pub name: Option<String>,
    /// The device, in SI units.
    pub feeder: Feeder,
    /// Things worth knowing that are not errors.
    pub warnings: Vec<String>,
}

/// Reads the `feeder` section of a case file, whatever its other sections hold.
///
/// # Errors
/// Every fault of the section at once, by position, those of the scene as it is where the search starts.
pub fn read_feeder(bytes: &[u8], limits: &Limits) -> Result<FeederCase, Vec<Fault>> {
    let text = text::decode(bytes, limits.bytes).map_err(|fault| vec![fault])?;
    let tree = text::parse(text).map_err(|fault| vec![fault])?;
    let mut reader = Reader::default();
    match reader.feeder_case(text, &tree, limits) {
        Some((name, feeder)) if !reader.has_faults() => Ok(FeederCase { name, feeder, warnings: reader.warnings }),
        _ => Err(reader.into_faults()),
    }
}

impl Reader {
    fn feeder_case(&mut self, text: &str, tree: &Value, limits: &Limits) -> Option<(Option<String>, Feeder)> {
        let path = Path::document();
        let fields = self.fields(tree, &path, &KEYS, SMALLEST_FEEDER)?;
        let name = fields.get("name").map(|value| self.string(value, &path.key("name"), "write \"name\": \"chute\""));
        let Some(value) = fields.get("feeder") else {
            self.push(missing_section("feeder").at(fields.span.clone()));
            return None;
        };
        let feeder = self.feeder(text, value, &path.key("feeder"), limits)?;
        Some((name.flatten().map(String::from), feeder))
    }

    fn feeder(&mut self, text: &str, value: &Value, path: &Path, limits: &Limits) -> Option<Feeder> {
        let known = ["variables", "uncertain", "let", "entries", "goal", "rest", "dimensions", "scene"];
        let fields = self.fields(value, path, &known, SMALLEST_FEEDER)?;
        let mut names: Vec<String> = Vec::new();
        let variables = self.variables(&fields, path, &mut names);
        let uncertain = self.uncertain(&fields, path, &mut names);
        let lets = self.lets(&fields, path, &mut names);
        let goal = self.goal(&fields, path);
        let rest = self.rest(&fields, path);
        let entries = self.entries(&fields, path);
        let lines = self.dimensions(&fields, path, &names);
        let scene = self.require(&fields, "scene", path, SMALLEST_FEEDER);
        let mut expressions = Vec::new();
        for (key, value) in [("entries", fields.get("entries")), ("scene", scene)] {
            if let Some(value) = value {
                self.expressions(value, &path.key(key), None, &names, &mut expressions);
            }
        }
        let (variables, uncertain) = (variables?, uncertain?);
        let template = Template { text: text.to_owned(), lets: lets?, expressions, lines: lines?, limits: *limits };
        if self.has_faults() {
            return None;
        }
        let start: Vec<f64> = variables.iter().map(|variable| variable.start).collect();
        let nominal: Vec<f64> = uncertain.iter().map(|uncertain| uncertain.value).collect();
        self.scenes_at(&template, &start, &nominal);
        Some(Feeder { variables, uncertain, entries: entries?, goal: goal?, rest: rest?, device: Box::new(template) })
    }

    /// Reads the scenes as they are where the search starts, for their faults.
    fn scenes_at(&mut self, template: &Template, variables: &[f64], uncertain: &[f64]) {
        let numbers = match template.numbers(variables, uncertain) {
            Ok(numbers) => numbers,
            Err(at) => {
                let Expression { text, span, path, .. } = &template.expressions[at];
                let fault = Fault::new(FaultKind::NoValue { text: clipped(text) }).at(span.clone()).on(path.clone());
                self.push(fault.help("choose another start, or bounds that keep it finite"));
                return;
            }
        };
        if let Ok(tree) = text::parse(&template.text) {
            self.filled_scenes(tree, &numbers, &template.limits);
        }
    }

    /// One scene for each entry, of a document whose expressions have these values.
    pub fn filled_scenes<'t>(
        &mut self,
        mut tree: Value<'t>,
        numbers: &'t [String],
        limits: &Limits,
    ) -> Option<Vec<World<Planar>>> {
        let (entries, scene) = template::filled(&mut tree, numbers)?;
        let document = Path::document();
        let path = document.key("feeder");
        let mut worlds = Vec::new();
        for entry in &entries {
            worlds.push(self.planar(&template::with_entry(&scene, entry), &path.key("scene"), limits));
            if self.has_faults() {
                // the scenes of other entries have the same faults
                return None;
            }
        }
        worlds.into_iter().collect()
    }

    /// Dimensions to be chosen.
    fn variables(&mut self, fields: &Fields, path: &Path, names: &mut Vec<String>) -> Option<Vec<Variable>> {
        let value = self.require(fields, "variables", path, VARIABLES_HELP)?;
        let path = path.key("variables");
        let properties = self.named(value, &path, VARIABLES_HELP, names)?;
        if properties.is_empty() {
            self.wrong_type("an object that names a dimension", value, &path, VARIABLES_HELP);
            return None;
        }
        let variable = |property: &ObjectProp| {
            let name = property.name.as_str();
            let path = path.key(name);
            let fields = self.fields(&property.value, &path, &["min", "max", "start", "meaning"], VARIABLES_HELP)?;
            for key in ["min", "max", "start"] {
                self.require(&fields, key, &path, VARIABLES_HELP);
            }
            let [low, high, start] =
                ["min", "max", "start"].map(|key| self.optional_double(&fields, key, &path, Bound::Any).flatten());
            let meaning = match fields.get("meaning") {
                Some(value) => Some(self.string(value, &path.key("meaning"), "say what it is")?.to_owned()),
                None => None,
            };
            let (low, high, start) = (low?, high?, start?);
            if low >= high || !(low..=high).contains(&start) {
                let kind = FaultKind::OutOfRange {
                    name: "`start`",
                    range: format!("from `min` {low} to a larger `max` {high}"),
                    value: start.to_string(),
                };
                self.fault(kind, span_of(&property.value), &path, VARIABLES_HELP);
                return None;
            }
            Some(Variable { name: name.to_owned(), meaning, low, high, start })
        };
        properties.into_iter().map(variable).collect()
    }

    /// What is only known within limits.
    fn uncertain(&mut self, fields: &Fields, path: &Path, names: &mut Vec<String>) -> Option<Vec<Uncertain>> {
        let Some(value) = fields.get("uncertain") else { return Some(Vec::new()) };
        let path = path.key("uncertain");
        let properties = self.named(value, &path, UNCERTAIN_HELP, names)?;
        let one = |property: &ObjectProp| {
            let name = property.name.as_str();
            let path = path.key(name);
            let fields = self.fields(&property.value, &path, &["value", "off"], UNCERTAIN_HELP)?;
            self.require(&fields, "value", &path, UNCERTAIN_HELP);
            let value = self.optional_double(&fields, "value", &path, Bound::Any)??;
            let off = self.optional_double(&fields, "off", &path, Bound::NotNegative)?.unwrap_or(0.0);
            Some(Uncertain { name: name.to_owned(), value, off })
        };
        properties.into_iter().map(one).collect()
    }

    /// Names for expressions in what is named before.
    fn lets(&mut self, fields: &Fields, path: &Path, names: &mut Vec<String>) -> Option<Vec<Expression>> {
        let Some(value) = fields.get("let") else { return Some(Vec::new()) };
        let path = path.key("let");
        let n_before = names.len();
        let properties = self.named(value, &path, LET_HELP, names)?;
        let mut lets = Vec::new();
        for (index, property) in properties.into_iter().enumerate() {
            let path = path.key(property.name.as_str());
            lets.push(self.expression(&property.value, &path, &names[..n_before + index]));
        }
        lets.into_iter().collect()
    }

    /// The properties of an object whose keys become names in expressions.
    fn named<'v>(
        &mut self,
        value: &'v Value<'v>,
        path: &Path,
        help: &str,
        names: &mut Vec<String>,
    ) -> Option<Vec<&'v ObjectProp<'v>>> {
        let Value::Object(object) = value else {
            self.wrong_type("an object", value, path, help);
            return None;
        };
        for property in &object.properties {
            let (name, span) = (property.name.as_str(), span_of(&property.name));
            let is_word = name.starts_with(|c: char| c.is_ascii_alphabetic())
                && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
            let kind = if !is_word || RESERVED.contains(&name) {
                FaultKind::BadName { name: clipped(name) }
            } else if names.iter().any(|known| known == name) {
                FaultKind::RepeatedName { name: clipped(name) }
            } else {
                names.push(name.to_owned());
                continue;
            };
            self.fault(kind, span, &path.key(name), "begin with a letter and go on with letters, digits and _");
            return None;
        }
        Some(object.properties.iter().collect())
    }

    /// All expressions of a value, in the order of the file.
    fn expressions(
        &mut self,
        value: &Value,
        path: &Path,
        key: Option<&str>,
        names: &[String],
        into: &mut Vec<Expression>,
    ) {
        match value {
            Value::StringLit(_) if !template::is_name(key) => into.extend(self.expression(value, path, names)),
            Value::Array(array) if !template::is_name(key) => {
                for (index, element) in array.elements.iter().enumerate() {
                    self.expressions(element, &path.index(index), None, names, into);
                }
            }
            Value::Object(object) => {
                for property in &object.properties {
                    let key = property.name.as_str();
                    self.expressions(&property.value, &path.key(key), Some(key), names, into);
                }
            }
            _ => {}
        }
    }

    pub fn expression(&mut self, value: &Value, path: &Path, names: &[String]) -> Option<Expression> {
        let text = match value {
            Value::StringLit(literal) => literal.value.as_ref(),
            Value::NumberLit(literal) => literal.value,
            _ => {
                self.wrong_type("a number or an expression", value, path, LET_HELP);
                return None;
            }
        };
        match Expression::new(text, names, span_of(value), path.to_string()) {
            Ok(expression) => Some(expression),
            Err(NoExpression::Syntax(why)) => {
                let kind = FaultKind::Expression { text: clipped(text), why };
                self.fault(kind, span_of(value), path, "write it like \"b/2 + c*tan(alpha)\"");
                None
            }
            Err(NoExpression::Name(name)) => {
                let known: Vec<&str> = names.iter().map(String::as_str).collect();
                let help = match suggest::nearest(&name, &known) {
                    Some(near) => format!("did you mean `{near}`?"),
                    None => format!("names known here: {}", known.join(", ")),
                };
                self.fault(FaultKind::UnknownName { name: clipped(&name) }, span_of(value), path, help);
                None
            }
        }
    }

    /// Names of the entries.
    fn entries(&mut self, fields: &Fields, path: &Path) -> Option<Vec<String>> {
        let value = self.require(fields, "entries", path, ENTRIES_HELP)?;
        let path = path.key("entries");
        let elements = &self.array(value, &path, ENTRIES_HELP)?.elements;
        if elements.is_empty() {
            self.wrong_type("a list that is not empty", value, &path, ENTRIES_HELP);
            return None;
        }
        let mut names = Vec::new();
        for (index, value) in elements.iter().enumerate() {
            let path = path.index(index);
            let fields = self.fields(value, &path, &["name", "pose", "velocity"], ENTRIES_HELP)?;
            self.require(&fields, "pose", &path, ENTRIES_HELP)?;
            names.push(match fields.get("name") {
                Some(value) => self.string(value, &path.key("name"), ENTRIES_HELP)?.to_owned(),
                None => format!("entry {index}"),
            });
        }
        Some(names)
    }

    fn goal(&mut self, fields: &Fields, path: &Path) -> Option<Goal> {
        let value = self.require(fields, "goal", path, GOAL_HELP)?;
        let path = path.key("goal");
        let fields = self.fields(value, &path, &["pose", "within", "weight"], GOAL_HELP)?;
        let pose = self.require(&fields, "pose", &path, GOAL_HELP);
        let pose = pose.and_then(|value| self.doubles::<[f64; 3]>(value, &path.key("pose"), GOAL_HELP));
        let within = self.optional_doubles::<[f64; 2]>(&fields, "within", &path, GOAL_HELP);
        let weight = self.optional_double(&fields, "weight", &path, Bound::Positive);
        let within = within?.unwrap_or([f64::MAX, 0.2]);
        if within.iter().any(|off| *off <= 0.0) {
            let kind = FaultKind::NotPositive { name: "`within`", value: show::number(&crate::exact::ratio(0, 1)) };
            self.fault(kind, fields.span.clone(), &path.key("within"), GOAL_HELP);
            return None;
        }
        Some(Goal { pose: pose?, within, weight: weight?.unwrap_or(5.0) })
    }

    fn rest(&mut self, fields: &Fields, path: &Path) -> Option<Rest> {
        let help = r#"write "rest": {"speed": 0.002, "time": 0.1}"#;
        let own = match fields.get("rest") {
            Some(value) => {
                let path = path.key("rest");
                let fields = self.fields(value, &path, &["speed", "time"], help)?;
                ["speed", "time"].map(|key| self.optional_double(&fields, key, &path, Bound::Positive))
            }
            None => [Some(None); 2],
        };
        let [speed, time] = own;
        Some(Rest { speed: speed?.unwrap_or(2e-3), time: time?.unwrap_or(0.1) })
    }
}
