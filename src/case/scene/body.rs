//! Bodies and what is fixed.

use super::super::Limits;
use super::super::kind::FaultKind;
use super::super::reader::{Fields, Path, Reader, span_of};
use super::super::show;
use super::SMALLEST_SCENE;
use super::double::Bound;
use super::material::Settings;
use super::shape::{Dimension, Role, Solid};
use crate::exact::from_float_exact;
use crate::model::{Body, Finger, Obstacle, Space, Timed};
use jsonc_parser::ast::Value;
use std::ops::Range;

/// Something of the scene, as far as it could be read.
pub struct Item<T> {
    pub name: String,
    /// Where it is in the file.
    pub span: Range<usize>,
    pub settings: Settings,
    /// Whether contacts can change its motion.
    pub is_free: bool,
    pub n_vertices: usize,
    /// `None` after a fault.
    pub thing: Option<T>,
}

impl Reader {
    pub fn bodies<S: Dimension>(
        &mut self,
        fields: &Fields,
        path: &Path,
        limits: &Limits,
    ) -> Option<Vec<Item<Body<S>>>> {
        let value = self.require(fields, "bodies", path, SMALLEST_SCENE)?;
        let path = path.key("bodies");
        let elements = &self.array(value, &path, SMALLEST_SCENE)?.elements;
        if elements.is_empty() {
            self.fault(FaultKind::NoBodies, span_of(value), &path, SMALLEST_SCENE);
            return None;
        }
        self.at_most(elements.len(), "bodies", limits, value, &path)?;
        let body = |(index, value): (usize, _)| self.body(value, &path.index(index), index, limits);
        all(elements.iter().enumerate().map(body))
    }

    pub fn obstacles<S: Dimension>(
        &mut self,
        fields: &Fields,
        path: &Path,
        limits: &Limits,
    ) -> Option<Vec<Item<Obstacle<S>>>> {
        let Some(value) = fields.get("fixed") else {
            return Some(Vec::new());
        };
        let path = path.key("fixed");
        let help = r#"write [{"name": "floor", "shape": {...}}], or leave it out"#;
        let elements = &self.array(value, &path, help)?.elements;
        self.at_most(elements.len(), "fixed things", limits, value, &path)?;
        let obstacle = |(index, value): (usize, _)| self.obstacle(value, &path.index(index), index, limits);
        all(elements.iter().enumerate().map(obstacle))
    }

    fn at_most(
        &mut self,
        bodies: usize,
        what: &'static str,
        limits: &Limits,
        value: &Value,
        path: &Path,
    ) -> Option<()> {
        if bodies <= limits.bodies {
            return Some(());
        }
        let kind = FaultKind::TooManyBodies { bodies, what, limit: limits.bodies };
        self.fault(kind, span_of(value), path, "simulate fewer at a time");
        None
    }

    fn body<S: Dimension>(
        &mut self,
        value: &Value,
        path: &Path,
        index: usize,
        limits: &Limits,
    ) -> Option<Item<Body<S>>> {
        let known = [
            "name",
            "shape",
            "mass",
            "inertia",
            "pose",
            "velocity",
            "kinematic",
            "motion",
            "wrench",
            "finger",
            "friction",
            "restitution",
            "contact",
        ];
        let fields = self.fields(value, path, &known, SMALLEST_SCENE)?;
        let name = self.item_name(&fields, path, || format!("body {index}"))?;
        let settings = self.settings(&fields, path);
        let is_kinematic = self.kinematic(&fields, path);
        let shape = self.require(&fields, "shape", path, S::SHAPE_HELP);
        let solid = shape.and_then(|value| S::shape(self, value, &path.key("shape"), Role::Body, limits));
        let n_vertices = solid.as_ref().map_or(0, |solid| solid.n_vertices);
        let pose = self.require(&fields, "pose", path, S::POSE_HELP);
        let pose = pose.and_then(|value| S::pose(self, value, &path.key("pose")));
        let velocity = self.optional_doubles::<S::Velocity>(&fields, "velocity", path, S::VELOCITY_HELP);
        let mass = self.mass(&fields, path, is_kinematic);
        let inertia = self.moments::<S>(&fields, path, &name, mass, solid.as_ref(), is_kinematic);
        let schedule = self.schedules::<S>(&fields, path, is_kinematic, velocity.flatten());
        let finger = self.pressing(&fields, path, solid.as_ref(), is_kinematic);
        let thing = (|| {
            let velocity = match schedule.as_deref() {
                // a kinematic body starts as it is told to move
                Some([first, ..]) if is_kinematic == Some(true) && first.time == 0.0 => first.value,
                _ => velocity?.unwrap_or_default(),
            };
            Some(Body {
                name: name.clone(),
                shape: solid?.shape,
                mass: mass?,
                inertia: inertia?,
                pose: pose?,
                velocity,
                is_kinematic: is_kinematic?,
                schedule: schedule?,
                finger: finger?,
            })
        })();
        let is_free = is_kinematic != Some(true);
        Some(Item { name, span: span_of(value), settings, is_free, n_vertices, thing })
    }

    fn obstacle<S: Dimension>(
        &mut self,
        value: &Value,
        path: &Path,
        index: usize,
        limits: &Limits,
    ) -> Option<Item<Obstacle<S>>> {
        let known = ["name", "shape", "surface_velocity", "friction", "restitution", "contact"];
        let fields = self.fields(value, path, &known, r#"write {"name": "floor", "shape": {...}}"#)?;
        let name = self.item_name(&fields, path, || format!("fixed {index}"))?;
        let settings = self.settings(&fields, path);
        let shape = self.require(&fields, "shape", path, S::SHAPE_HELP);
        let solid = shape.and_then(|value| S::shape(self, value, &path.key("shape"), Role::Fixed, limits));
        let surface = fields.get("surface_velocity");
        let surface_velocity = match surface {
            Some(value) => S::surface_velocity(self, value, &path.key("surface_velocity")),
            None => Some([0.0; 2]),
        };
        let n_vertices = solid.as_ref().map_or(0, |solid| solid.n_vertices);
        let thing = solid.zip(surface_velocity).map(|(solid, surface_velocity)| Obstacle {
            name: name.clone(),
            shape: solid.shape,
            surface_velocity,
        });
        Some(Item { name, span: span_of(value), settings, is_free: false, n_vertices, thing })
    }

    fn item_name(&mut self, fields: &Fields, path: &Path, default: impl FnOnce() -> String) -> Option<String> {
        match fields.get("name") {
            Some(value) => self.string(value, &path.key("name"), "write \"name\": \"peg\"").map(String::from),
            None => Some(default()),
        }
    }

    /// `None` after a fault.
    fn kinematic(&mut self, fields: &Fields, path: &Path) -> Option<bool> {
        match fields.get("kinematic") {
            None => Some(false),
            Some(Value::BooleanLit(literal)) => Some(literal.value),
            Some(value) => {
                let help = "write true for a body that moves as told, whatever it touches";
                self.wrong_type("true or false", value, &path.key("kinematic"), help);
                None
            }
        }
    }

    fn mass(&mut self, fields: &Fields, path: &Path, is_kinematic: Option<bool>) -> Option<f64> {
        if is_kinematic == Some(false) {
            self.require(fields, "mass", path, "write \"mass\": 0.2, in kg");
        }
        let mass = self.optional_double(fields, "mass", path, Bound::Positive)?;
        mass.or((is_kinematic == Some(true)).then_some(1.0))
    }

    /// Moments of inertia: as given, else those of the uniform solid.
    fn moments<S: Dimension>(
        &mut self,
        fields: &Fields,
        path: &Path,
        name: &str,
        mass: Option<f64>,
        solid: Option<&Solid<S>>,
        is_kinematic: Option<bool>,
    ) -> Option<S::Inertia> {
        let is_free = is_kinematic == Some(false);
        if let Some(outside) = solid.and_then(|solid| solid.outside.as_ref()).filter(|_| is_free) {
            let name = show::clipped(name);
            self.warnings
                .push(format!("{path}: the center of mass of `{name}`, the origin of its frame, is {outside}"));
        }
        if let Some(value) = fields.get("inertia") {
            return S::inertia(self, value, &path.key("inertia"));
        }
        let mut moments = S::Inertia::default();
        if !is_free {
            moments.as_mut().fill(1.0);
            return Some(moments);
        }
        let solid = solid?;
        let Some(gyration2) = &solid.gyration2 else {
            let help = "give it: the principal axes of the uniform solid are not along those of its frame";
            self.require(fields, "inertia", path, help);
            return None;
        };
        if let Some(offset) = &solid.offset {
            let name = show::clipped(name);
            self.warnings.push(format!(
                "{path}: the center of mass of `{name}` is the origin of its frame, but {offset}; its inertia defaults \
                 to the uniform solid's about the origin; move the shape or give inertia"
            ));
        }
        for (moment, gyration2) in moments.as_mut().iter_mut().zip(gyration2.as_ref()) {
            *moment = mass? * gyration2;
        }
        Some(moments)
    }

    /// The finger on a free body; `None` after a fault.
    fn pressing<S: Dimension>(
        &mut self,
        fields: &Fields,
        path: &Path,
        solid: Option<&Solid<S>>,
        is_kinematic: Option<bool>,
    ) -> Option<Option<Finger>> {
        let Some(value) = fields.get("finger") else {
            return Some(None);
        };
        if is_kinematic? {
            self.wrong_motion(fields, "finger", "free", path, "a kinematic body moves as told, whatever acts on it");
            return None;
        }
        S::finger(self, value, &path.key("finger"), solid.map(|solid| &solid.shape)).map(Some)
    }

    /// Wrenches on a free body, velocities of a kinematic one.
    fn schedules<S: Dimension>(
        &mut self,
        fields: &Fields,
        path: &Path,
        is_kinematic: Option<bool>,
        velocity: Option<S::Velocity>,
    ) -> Option<Vec<Timed<S>>> {
        let (key, help) = if is_kinematic? {
            self.wrong_motion(fields, "wrench", "free", path, "a kinematic body moves as told, whatever acts on it");
            let help = r#"write {"velocity": [...]}, or {"motion": [{"from": 0, "velocity": [...]}]}"#;
            self.exclude(fields, ["velocity", "motion"], path, help);
            ("motion", S::VELOCITY_HELP)
        } else {
            let help = "write \"kinematic\": true for a body that moves as told";
            self.wrong_motion(fields, "motion", "kinematic", path, help);
            ("wrench", S::WRENCH_HELP)
        };
        match fields.get(key) {
            Some(value) => self.schedule(value, &path.key(key), if key == "wrench" { key } else { "velocity" }, help),
            None if key == "motion" => Some(velocity.map(|value| Timed { time: 0.0, value }).into_iter().collect()),
            None => Some(Vec::new()),
        }
    }

    fn wrong_motion(&mut self, fields: &Fields, key: &'static str, what: &'static str, path: &Path, help: &str) {
        if fields.get(key).is_some() {
            self.fault(FaultKind::WrongMotion { key, what }, fields.key_span(key), &path.key(key), help);
        }
    }

    /// One value, or a list of values each from a time on.
    fn schedule<S: Space>(
        &mut self,
        value: &Value,
        path: &Path,
        key: &'static str,
        help: &str,
    ) -> Option<Vec<Timed<S>>> {
        let elements = &self.array(value, path, help)?.elements;
        if !matches!(elements.first(), Some(Value::Object(_))) {
            return self.doubles(value, path, help).map(|value| vec![Timed { time: 0.0, value }]);
        }
        let mut schedule: Vec<Timed<S>> = Vec::with_capacity(elements.len());
        let mut is_whole = true;
        for (index, element) in elements.iter().enumerate() {
            let path = path.index(index);
            let Some(fields) = self.fields(element, &path, &["from", key], help) else {
                is_whole = false;
                continue;
            };
            let from = self.require(&fields, "from", &path, "write \"from\": 0, in seconds");
            let time = from.and_then(|value| self.double(value, &path.key("from"), "from", Bound::NotNegative));
            let value = self.require(&fields, key, &path, help);
            let value = value.and_then(|value| self.doubles(value, &path.key(key), help));
            let (Some(time), Some(value)) = (time, value) else {
                is_whole = false;
                continue;
            };
            if let (Some(last), Some(from)) = (schedule.last().filter(|last| last.time >= time), from) {
                let shown = |time: f64| from_float_exact(time).as_ref().map_or_else(String::new, show::number);
                let kind = FaultKind::TimeOrder { previous: shown(last.time), time: shown(time) };
                self.fault(kind, span_of(from), &path.key("from"), "list the entries by time");
                is_whole = false;
            }
            schedule.push(Timed { time, value });
        }
        is_whole.then_some(schedule)
    }

    /// Checks that all shapes together have no more vertices than allowed.
    pub fn count_vertices<S: Dimension>(
        &mut self,
        bodies: &[Item<Body<S>>],
        fixed: &[Item<Obstacle<S>>],
        fields: &Fields,
        path: &Path,
        limits: &Limits,
    ) {
        let vertices: usize = bodies.iter().map(|body| body.n_vertices).sum();
        let vertices = vertices + fixed.iter().map(|fixed| fixed.n_vertices).sum::<usize>();
        if vertices > limits.vertices {
            let kind = FaultKind::TooManyVertices { vertices, limit: limits.vertices };
            self.fault(kind, fields.span.clone(), path, "raise the limit with --max-vertices");
        }
    }
}

/// Every item, if all are there; all are read even after one that is not.
fn all<T>(items: impl Iterator<Item = Option<T>>) -> Option<Vec<T>> {
    items.collect::<Vec<_>>().into_iter().collect()
}
