//! Case files: JSON text read exactly, every fault reported at once.

mod conveyor;
mod expression;
mod fault;
mod fixels;
mod friction;
mod given;
mod kind;
mod part;
mod reader;
mod render;
mod scene;
mod show;
mod suggest;
mod text;
mod thrower;

pub use fault::{Fault, Related};
pub use kind::{FaultKind, PairFault, SyntaxFault};
pub use render::render;
pub use scene::{FeederCase, SceneCase, read_feeder, read_scene};

use crate::exact::Q;
use crate::model::{Conveyor, Fixture, GivenPush, LengthUnit, Part, Thrower};
use jsonc_parser::ast::Value;
use reader::{Path, Reader, span_of};
use show::clipped;
use text::SMALLEST_CASE;

/// The smallest `insert` section.
const SMALLEST_INSERT: &str = r#""insert": {"fixels": [{"at": [0.5, 0], "friction": 0.2}]}"#;

/// The smallest `pins` section.
const SMALLEST_PINS: &str = r#""pins": {"belt_friction": 0.5, "pin_friction": 0.1}"#;

/// The smallest `throw` section.
const SMALLEST_THROW: &str = r#""throw": {"offset": -0.5, "release_deg_per_s": 320}"#;

/// The keys of a case.
const KEYS: [&str; 9] = ["name", "comment", "length_unit", "part", "insert", "pins", "throw", "scene", "feeder"];

/// A section of a case that says what a task needs besides the part.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Section {
    /// Fixels: `insert`.
    Insert,
    /// Conveyor and pins: `pins`.
    Pins,
    /// The arm: `throw`.
    Throw,
}

impl Section {
    /// Every section that is read.
    pub const ALL: [Self; 3] = [Self::Insert, Self::Pins, Self::Throw];

    /// Its key in a case.
    #[must_use]
    pub fn key(self) -> &'static str {
        match self {
            Self::Insert => "insert",
            Self::Pins => "pins",
            Self::Throw => "throw",
        }
    }
}

/// What a case file says.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Case {
    /// Its name, if given.
    pub name: Option<String>,
    /// The part.
    pub part: Part,
    /// The `insert` section, if present.
    pub fixture: Option<Fixture>,
    /// The plan that the `insert` section brings along, if any.
    pub given_push: Option<GivenPush>,
    /// The `pins` section, if present.
    pub conveyor: Option<Conveyor>,
    /// Heights of the pins that the `pins` section brings along, in the order met; may be empty.
    pub given_pins: Vec<Q>,
    /// The `throw` section, if present.
    pub thrower: Option<Thrower>,
    /// Things worth knowing that are not errors: points moved onto the outline, an inertia taken about another point.
    pub warnings: Vec<String>,
}

/// Bounds on what a case may hold, so that reading and planning end in bounded time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Limits {
    /// Largest file, in bytes.
    pub bytes: usize,
    /// Most vertices of the part.
    pub vertices: usize,
    /// Most fixels.
    pub fixels: usize,
    /// Most bodies of a scene, and most of what is fixed there.
    pub bodies: usize,
}

impl Default for Limits {
    fn default() -> Self {
        Self { bytes: 16 << 20, vertices: 10_000, fixels: 64, bodies: 200 }
    }
}

/// Reads a case file, every section of it.
///
/// # Errors
/// Every fault of the file at once, by position; a text that is not JSON has one.
///
/// # Examples
/// ```
/// use partplan::case::{Limits, read};
/// let case = read(br#"{"part": {"shape": {"polygon": [[0, 0], [1, 0], [0, 1]]}}}"#, &Limits::default()).unwrap();
/// assert_eq!(case.fixture, None);
/// let faults = read(br#"{"part": {"shap": 1}}"#, &Limits::default()).unwrap_err();
/// assert_eq!(faults.iter().map(|fault| fault.code()).collect::<Vec<_>>(), ["C014", "C011"]);
/// ```
pub fn read(bytes: &[u8], limits: &Limits) -> Result<Case, Vec<Fault>> {
    read_sections(bytes, &Section::ALL, limits)
}

/// Reads a case file for one task: the part and `section`, whatever the sections of other tasks hold.
///
/// # Errors
/// As [`read`]; a section that is not there is no fault, see [`missing_section`].
pub fn read_for(section: Section, bytes: &[u8], limits: &Limits) -> Result<Case, Vec<Fault>> {
    read_sections(bytes, &[section], limits)
}

fn read_sections(bytes: &[u8], sections: &[Section], limits: &Limits) -> Result<Case, Vec<Fault>> {
    let text = text::decode(bytes, limits.bytes).map_err(|fault| vec![fault])?;
    let tree = text::parse(text).map_err(|fault| vec![fault])?;
    let mut reader = Reader::default();
    match reader.case(&tree, sections, limits) {
        Some(case) if !reader.has_faults() => Ok(Case { warnings: reader.warnings, ..case }),
        _ => Err(reader.into_faults()),
    }
}

/// The fault of a case without the section that a task needs, showing the smallest one that would do.
#[must_use]
pub fn missing_section(section: &'static str) -> Fault {
    let example = match section {
        "part" => SMALLEST_CASE,
        "insert" => SMALLEST_INSERT,
        "pins" => SMALLEST_PINS,
        "scene" => scene::SMALLEST_SCENE,
        "feeder" => scene::SMALLEST_FEEDER,
        "throw" => SMALLEST_THROW,
        _ => "",
    };
    let fault = Fault::new(FaultKind::MissingSection { section }).on(section.to_string());
    if example.is_empty() { fault } else { fault.help(format!("the smallest one is {example}")) }
}

impl Reader {
    fn case(&mut self, tree: &Value, sections: &[Section], limits: &Limits) -> Option<Case> {
        let path = Path::document();
        let fields = self.fields(tree, &path, &KEYS, SMALLEST_CASE)?;
        let name = fields.get("name").map(|value| self.string(value, &path.key("name"), "write \"name\": \"bracket\""));
        let unit = match fields.get("length_unit") {
            Some(value) => self.length_unit(value, &path.key("length_unit")),
            None => Some(LengthUnit::default()),
        };
        let (shape, part) = match fields.get("part") {
            Some(value) => self.part(value, &path.key("part"), unit.unwrap_or_default(), limits),
            None => {
                self.push(missing_section("part").at(fields.span.clone()));
                (None, None)
            }
        };
        let section = |section: Section| fields.get(section.key()).filter(|_| sections.contains(&section));
        let fixture =
            section(Section::Insert).map(|value| self.fixture(value, &path.key("insert"), shape.as_ref(), limits));
        let conveyor = section(Section::Pins)
            .map(|value| self.conveyor(value, fields.key_span("pins"), &path.key("pins"), shape.as_ref()));
        let thrower = section(Section::Throw).map(|value| {
            let (key, path, unit) = (fields.key_span("throw"), path.key("throw"), unit.unwrap_or_default());
            self.thrower(value, key, &path, shape.as_ref(), unit)
        });
        unit?;
        let (fixture, given_push) = fixture.flatten().unzip();
        let (conveyor, given_pins) = conveyor.flatten().unzip();
        Some(Case {
            name: name.flatten().map(String::from),
            part: part?,
            fixture,
            given_push: given_push.flatten(),
            conveyor,
            given_pins: given_pins.unwrap_or_default(),
            thrower: thrower.flatten(),
            warnings: Vec::new(),
        })
    }

    fn length_unit(&mut self, value: &Value, path: &Path) -> Option<LengthUnit> {
        let help = "write \"m\", \"cm\" or \"mm\"";
        let text = self.string(value, path, help)?;
        let units = [LengthUnit::Metre, LengthUnit::Centimetre, LengthUnit::Millimetre];
        let unit = units.into_iter().find(|unit| unit.symbol() == text);
        if unit.is_none() {
            let kind = FaultKind::UnknownWord { what: "unit of length", text: clipped(text) };
            self.fault(kind, span_of(value), path, help);
        }
        unit
    }
}
