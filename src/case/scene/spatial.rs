//! Shapes, poses and inertia in space.

use super::super::Limits;
use super::super::kind::FaultKind;
use super::super::reader::{Path, Reader, span_of};
use super::double::{Bound, normalized};
use super::shape::{Dimension, Role, Solid};
use crate::model::{Finger, Spatial, SpatialShape};
use jsonc_parser::ast::Value;

const BODY_HELP: &str = r#"write {"sphere": {"radius": 0.05}} or {"box": {"half": [0.1, 0.05, 0.02]}}"#;
const FIXED_HELP: &str = r#"write {"half_space": {"point": [0, 0, 0], "normal": [0, 0, 1]}}, {"sphere": {"center": [0, 0, 0], "radius": 0.05}} or {"box": {"half": [0.1, 0.05, 0.02]}}"#;
const TRIPLE_HELP: &str = "write [x, y, z]";
const INERTIA_HELP: &str = "write one number, or the three principal moments [Ix, Iy, Iz]";

/// Euler parameters may be this far from unit length without a warning.
const NEARLY_UNIT: f64 = 1e-6;

impl Dimension for Spatial {
    const GRAVITY: [f64; 3] = [0.0, 0.0, -9.81];
    const GRAVITY_HELP: &'static str = "write [0, 0, -9.81]";
    const POSE_HELP: &'static str = "write [x, y, z, e0, ex, ey, ez]; upright is e0 = 1, ex = ey = ez = 0";
    const VELOCITY_HELP: &'static str = "write [vx, vy, vz, wx, wy, wz], in m/s and rad/s";
    const WRENCH_HELP: &'static str =
        r#"write [fx, fy, fz, tx, ty, tz], or [{"from": 0, "wrench": [fx, fy, fz, tx, ty, tz]}] for one that changes"#;
    const SHAPE_HELP: &'static str = BODY_HELP;
    const DIRECTIONS: usize = 16;

    fn shape(reader: &mut Reader, value: &Value, path: &Path, role: Role, _limits: &Limits) -> Option<Solid<Self>> {
        let help = if role == Role::Body { BODY_HELP } else { FIXED_HELP };
        let known = ["sphere", "box", "half_space"];
        let fields = reader.fields(value, path, &known, help)?;
        let key = reader.one_of(&fields, &known, path, help)?;
        let (value, inner) = (fields.get(key)?, path.key(key));
        match key {
            "sphere" => reader.sphere(value, &inner, help),
            "box" => reader.cuboid(value, &inner, help),
            _ if reader.fixed_only(&fields, key, path, role, help) => reader.half_space(value, &inner, help),
            _ => None,
        }
    }

    fn pose(reader: &mut Reader, value: &Value, path: &Path) -> Option<[f64; 7]> {
        let mut pose: [f64; 7] = reader.doubles(value, path, Self::POSE_HELP)?;
        let Some((unit, length)) = normalized(&pose[3..]) else {
            reader.fault(FaultKind::NoOrientation, span_of(value), path, Self::POSE_HELP);
            return None;
        };
        if (length - 1.0).abs() > NEARLY_UNIT {
            let said = format!("{path}: the Euler parameters have length {length}, not 1; they are divided by it");
            reader.warnings.push(said);
        }
        pose[3..].copy_from_slice(&unit);
        Some(pose)
    }

    fn inertia(reader: &mut Reader, value: &Value, path: &Path) -> Option<[f64; 3]> {
        let Value::Array(array) = value else {
            return reader.double(value, path, "inertia", Bound::Positive).map(|inertia| [inertia; 3]);
        };
        if array.elements.len() != 3 {
            let kind = FaultKind::WrongLength { expected: 3, found: array.elements.len() };
            reader.fault(kind, span_of(value), path, INERTIA_HELP);
            return None;
        }
        let mut moment =
            |axis: usize| reader.double(&array.elements[axis], &path.index(axis), "inertia", Bound::Positive);
        let [x, y, z] = [moment(0), moment(1), moment(2)];
        let moments = [x?, y?, z?];
        let (sum, largest) = (moments.iter().sum::<f64>(), moments.iter().copied().fold(0.0, f64::max));
        if largest > (sum - largest) * (1.0 + 1e-9) {
            let said = format!("{path}: no rigid body has these moments: the largest exceeds the sum of the other two");
            reader.warnings.push(said);
        }
        Some(moments)
    }

    fn finger(reader: &mut Reader, value: &Value, path: &Path, _: Option<&SpatialShape>) -> Option<Finger> {
        let kind = FaultKind::WrongMotion { key: "finger", what: "planar" };
        reader.fault(kind, span_of(value), path, "push it by a wrench");
        None
    }

    fn surface_velocity(reader: &mut Reader, value: &Value, path: &Path) -> Option<[f64; 2]> {
        reader.doubles(value, path, "write [along t, along o], in m/s; for a normal along +z these are +x and +y")
    }
}

impl Reader {
    fn sphere(&mut self, value: &Value, path: &Path, help: &str) -> Option<Solid<Spatial>> {
        let fields = self.fields(value, path, &["center", "radius"], help)?;
        let center = self.optional_doubles::<[f64; 3]>(&fields, "center", path, TRIPLE_HELP);
        self.require(&fields, "radius", path, help);
        let (radius, center) =
            (self.optional_double(&fields, "radius", path, Bound::Positive)??, center?.unwrap_or_default());
        let away2: f64 = center.iter().map(|c| c * c).sum();
        // products of inertia vanish for a center on an axis only
        let is_principal = center.iter().filter(|c| **c != 0.0).count() <= 1;
        let gyration2 = center.map(|c| 0.4 * radius * radius + away2 - c * c);
        let is_off = away2 > 0.0;
        Some(Solid {
            shape: SpatialShape::Sphere { center, radius },
            n_vertices: 1,
            gyration2: is_principal.then_some(gyration2),
            offset: is_off.then(|| format!("the center of its sphere is at {center:?}")),
            outside: (away2.sqrt() >= radius).then(|| "outside of its sphere".to_owned()),
        })
    }

    fn cuboid(&mut self, value: &Value, path: &Path, help: &str) -> Option<Solid<Spatial>> {
        let fields = self.fields(value, path, &["half", "size"], help)?;
        let key = self.one_of(&fields, &["half", "size"], path, help)?;
        let (value, path) = (fields.get(key)?, path.key(key));
        let lengths: [f64; 3] = self.doubles(value, &path, "write three lengths")?;
        if let Some(bad) = lengths.iter().find(|length| **length <= 0.0) {
            let kind = FaultKind::NotPositive { name: key, value: bad.to_string() };
            self.fault(kind, span_of(value), &path, "write three numbers above 0");
            return None;
        }
        let half = lengths.map(|length| if key == "half" { length } else { length / 2.0 });
        let [x2, y2, z2] = half.map(|h| h * h / 3.0);
        Some(Solid {
            shape: SpatialShape::Box { half },
            n_vertices: 8,
            gyration2: Some([y2 + z2, z2 + x2, x2 + y2]),
            offset: None,
            outside: None,
        })
    }

    fn half_space(&mut self, value: &Value, path: &Path, help: &str) -> Option<Solid<Spatial>> {
        let fields = self.fields(value, path, &["point", "normal"], help)?;
        let point = self.require(&fields, "point", path, help);
        let point = point.and_then(|value| self.doubles(value, &path.key("point"), TRIPLE_HELP));
        let normal = self.require(&fields, "normal", path, help);
        let normal_help = "write a vector out of the material, like [0, 0, 1]";
        let normal = normal.and_then(|value| self.direction(value, &path.key("normal"), normal_help));
        let shape = SpatialShape::HalfSpace { point: point?, normal: normal? };
        Some(Solid { shape, n_vertices: 1, gyration2: None, offset: None, outside: None })
    }
}
