//! The `scene` section: bodies, obstacles and what acts between them.

mod body;
mod dimensions;
mod double;
mod feeder;
mod finger;
mod material;
mod planar;
mod resolve;
mod shape;
mod spatial;
mod template;

pub(super) use feeder::SMALLEST_FEEDER;
pub use feeder::{FeederCase, read_feeder};

use super::kind::FaultKind;
use super::reader::{Fields, Path, Reader, span_of};
use super::{Fault, KEYS, Limits, missing_section, show, text};
use crate::exact::ratio;
use crate::model::{Planar, Scene, Spatial, World};
use double::Bound;
use jsonc_parser::ast::Value;
use num_traits::ToPrimitive as _;
use shape::Dimension;

/// The smallest `scene` section.
pub(super) const SMALLEST_SCENE: &str = r#""scene": {"duration": 1, "friction": 0.2, "bodies": [{"shape": {"circle": {"center": [0, 0], "radius": 0.05}}, "mass": 1, "pose": [0, 1, 0]}], "fixed": [{"shape": {"half_plane": {"point": [0, 0], "normal": [0, 1]}}}]}"#;

/// Most edges of a friction cone.
const MOST_DIRECTIONS: usize = 256;

/// What a file with a scene says.
#[derive(Debug, Clone, PartialEq)]
pub struct SceneCase {
    /// Its name, if given.
    pub name: Option<String>,
    /// The scene, in SI units.
    pub scene: Scene,
    /// Things worth knowing that are not errors.
    pub warnings: Vec<String>,
}

/// Reads the scene of a case file, whatever its other sections hold.
///
/// Numbers are read exactly and rounded once to the nearest double.
///
/// # Errors
/// Every fault of the section at once, by position; a text that is not JSON, and one without a scene, has one.
///
/// # Examples
/// ```
/// use partplan::case::{Limits, read_scene};
/// use partplan::model::Scene;
/// let text = br#"{"scene": {"duration": 1, "friction": "1/3",
///     "bodies": [{"shape": {"circle": {"center": [0, 0], "radius": 0.05}}, "mass": 1, "pose": [0, 1, 0]}],
///     "fixed": [{"shape": {"half_plane": {"point": [0, 0], "normal": [0, 2]}}}]}}"#;
/// let Scene::Planar(world) = read_scene(text, &Limits::default()).unwrap().scene else { panic!() };
/// assert_eq!(world.material(0, 1).friction, 1.0 / 3.0);
/// ```
pub fn read_scene(bytes: &[u8], limits: &Limits) -> Result<SceneCase, Vec<Fault>> {
    let text = text::decode(bytes, limits.bytes).map_err(|fault| vec![fault])?;
    let tree = text::parse(text).map_err(|fault| vec![fault])?;
    let mut reader = Reader::default();
    match reader.scene_case(&tree, limits) {
        Some((name, scene)) if !reader.has_faults() => Ok(SceneCase { name, scene, warnings: reader.warnings }),
        _ => Err(reader.into_faults()),
    }
}

impl Reader {
    fn scene_case(&mut self, tree: &Value, limits: &Limits) -> Option<(Option<String>, Scene)> {
        let path = Path::document();
        let fields = self.fields(tree, &path, &KEYS, SMALLEST_SCENE)?;
        let name =
            fields.get("name").map(|value| self.string(value, &path.key("name"), "write \"name\": \"peg drop\""));
        let is_other_unit = matches!(fields.get("length_unit"), Some(Value::StringLit(unit)) if unit.value != "m");
        if is_other_unit {
            self.warnings
                .push("a scene is in metres, kilograms and seconds; length_unit is for the part only".to_owned());
        }
        let Some(value) = fields.get("scene") else {
            self.push(missing_section("scene").at(fields.span.clone()));
            return None;
        };
        let scene = self.scene(value, &path.key("scene"), limits)?;
        Some((name.flatten().map(String::from), scene))
    }

    fn scene(&mut self, value: &Value, path: &Path, limits: &Limits) -> Option<Scene> {
        let known = [
            "dimension",
            "gravity",
            "duration",
            "step",
            "margin",
            "directions",
            "bodies",
            "fixed",
            "friction",
            "restitution",
            "contact",
            "pairs",
        ];
        let fields = self.fields(value, path, &known, SMALLEST_SCENE)?;
        match self.dimension(&fields, path)? {
            2 => self.world::<Planar>(&fields, path, limits).map(Scene::Planar),
            _ => self.world::<Spatial>(&fields, path, limits).map(Scene::Spatial),
        }
    }

    /// A scene that must be one in the plane.
    fn planar(&mut self, value: &Value, path: &Path, limits: &Limits) -> Option<World<Planar>> {
        match self.scene(value, path, limits)? {
            Scene::Planar(world) => Some(world),
            Scene::Spatial(_) => {
                self.wrong_type("a scene in the plane", value, path, "leave `dimension` out");
                None
            }
        }
    }

    fn dimension(&mut self, fields: &Fields, path: &Path) -> Option<u8> {
        let Some(value) = fields.get("dimension") else {
            return Some(2);
        };
        let path = path.key("dimension");
        let number = self.number(value, &path)?;
        if number == ratio(2, 1) || number == ratio(3, 1) {
            return number.to_u8();
        }
        let kind = FaultKind::OutOfRange { name: "`dimension`", range: "2 or 3".into(), value: show::number(&number) };
        self.fault(kind, span_of(value), &path, "write 2 for the plane, 3 for space");
        None
    }

    fn world<S: Dimension>(&mut self, fields: &Fields, path: &Path, limits: &Limits) -> Option<World<S>> {
        let gravity = self.optional_doubles::<S::Vector>(fields, "gravity", path, S::GRAVITY_HELP);
        self.require(fields, "duration", path, "write \"duration\": 1, in seconds");
        let duration = self.optional_double(fields, "duration", path, Bound::Positive);
        let step = self.optional_double(fields, "step", path, Bound::Positive);
        let margin = self.optional_double(fields, "margin", path, Bound::NotNegative);
        let directions = self.directions::<S>(fields, path);
        let bodies = self.bodies::<S>(fields, path, limits);
        let fixed = self.obstacles::<S>(fields, path, limits);
        let (bodies, fixed) = (bodies?, fixed?);
        self.count_vertices(&bodies, &fixed, fields, path, limits);
        let materials = self.materials(&bodies, &fixed, fields, path);
        Some(World {
            gravity: gravity?.unwrap_or(S::GRAVITY),
            duration: duration??,
            step: step?,
            margin: margin?,
            directions: directions?,
            bodies: bodies.into_iter().map(|item| item.thing).collect::<Option<Vec<_>>>()?,
            fixed: fixed.into_iter().map(|item| item.thing).collect::<Option<Vec<_>>>()?,
            materials: materials?,
        })
    }

    /// Edges of the friction cone.
    fn directions<S: Dimension>(&mut self, fields: &Fields, path: &Path) -> Option<usize> {
        let Some(value) = fields.get("directions") else {
            return Some(S::DIRECTIONS);
        };
        let path = path.key("directions");
        let number = self.number(value, &path)?;
        let count = number.is_integer().then(|| number.to_usize()).flatten();
        let is_right = |count: &usize| match S::DIRECTIONS {
            2 => *count == 2,
            _ => count.is_multiple_of(2) && (4..=MOST_DIRECTIONS).contains(count),
        };
        if let Some(count) = count.filter(is_right) {
            return Some(count);
        }
        let (range, help) = match S::DIRECTIONS {
            2 => ("2 in the plane".to_owned(), "leave it out"),
            _ => (format!("even, from 4 to {MOST_DIRECTIONS}"), "write 16"),
        };
        let kind = FaultKind::OutOfRange { name: "`directions`", range, value: show::number(&number) };
        self.fault(kind, span_of(value), &path, help);
        None
    }
}
