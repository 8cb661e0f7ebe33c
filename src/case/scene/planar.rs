//! Shapes, poses and inertia in the plane.

use super::super::kind::FaultKind;
use super::super::reader::{Path, Reader, span_of};
use super::super::{Limits, show};
use super::double::{Bound, rounded};
use super::shape::{Dimension, Role, Solid};
use crate::exact::{Q, from_float_exact, to_f64};
use crate::geometry::{Moments, Polygon};
use crate::model::{Finger, Planar, PlanarShape};
use jsonc_parser::ast::Value;
use num_traits::Zero as _;
use std::f64::consts::PI;

const BODY_HELP: &str = r#"write {"polygon": [[-0.05, -0.02], [0.05, -0.02], [0, 0.04]]}, {"circle": {"center": [0, 0], "radius": 0.05}} or {"compound": [shapes]}"#;
const FIXED_HELP: &str = r#"write {"half_plane": {"point": [0, 0], "normal": [0, 1]}}, {"polygon": [[0, 0], [1, 0], [0, 1]]}, {"circle": {"center": [0, 0], "radius": 0.05}}, {"point": [0, 0]} or {"compound": [shapes]}"#;
const PAIR_HELP: &str = "write [x, y]";

/// An origin this much of the outline's size away from the centroid is meant to be there.
const CENTERED: f64 = 1e-6;

/// A shape that is not compound.
struct Piece {
    shape: PlanarShape,
    area: f64,
    centroid: [f64; 2],
    /// Second moment of area about the centroid.
    polar: f64,
    n_vertices: usize,
    /// Whether the origin is strictly inside the hull.
    is_around_origin: bool,
}

impl Dimension for Planar {
    const GRAVITY: [f64; 2] = [0.0, -9.81];
    const GRAVITY_HELP: &'static str = "write [0, -9.81]";
    const POSE_HELP: &'static str = "write [x, y, angle], in m and rad";
    const VELOCITY_HELP: &'static str = "write [vx, vy, omega], in m/s and rad/s";
    const WRENCH_HELP: &'static str =
        r#"write [fx, fy, torque], or [{"from": 0, "wrench": [fx, fy, torque]}] for one that changes"#;
    const SHAPE_HELP: &'static str = BODY_HELP;
    const DIRECTIONS: usize = 2;

    fn shape(reader: &mut Reader, value: &Value, path: &Path, role: Role, limits: &Limits) -> Option<Solid<Self>> {
        let pieces = reader.planar_pieces(value, path, role, limits, false)?;
        let mut solid = described(&pieces);
        let mut shapes: Vec<PlanarShape> = pieces.into_iter().map(|piece| piece.shape).collect();
        let is_compound = matches!(value, Value::Object(object) if object.get("compound").is_some());
        solid.shape = match shapes.pop() {
            Some(only) if shapes.is_empty() && !is_compound => only,
            last => PlanarShape::Compound(shapes.into_iter().chain(last).collect()),
        };
        Some(solid)
    }

    fn pose(reader: &mut Reader, value: &Value, path: &Path) -> Option<[f64; 3]> {
        reader.doubles(value, path, Self::POSE_HELP)
    }

    fn inertia(reader: &mut Reader, value: &Value, path: &Path) -> Option<[f64; 1]> {
        reader.double(value, path, "inertia", Bound::Positive).map(|inertia| [inertia])
    }

    fn finger(reader: &mut Reader, value: &Value, path: &Path, shape: Option<&PlanarShape>) -> Option<Finger> {
        reader.finger(value, path, shape)
    }

    fn surface_velocity(reader: &mut Reader, value: &Value, path: &Path) -> Option<[f64; 2]> {
        reader.double(value, path, "surface_velocity", Bound::Any).map(|speed| [speed, 0.0])
    }
}

impl Reader {
    fn planar_pieces(
        &mut self,
        value: &Value,
        path: &Path,
        role: Role,
        limits: &Limits,
        is_piece: bool,
    ) -> Option<Vec<Piece>> {
        let help = if role == Role::Body { BODY_HELP } else { FIXED_HELP };
        let known = ["polygon", "circle", "half_plane", "point", "compound"];
        let fields = self.fields(value, path, &known, help)?;
        let key = self.one_of(&fields, &known, path, help)?;
        let (value, inner) = (fields.get(key)?, path.key(key));
        let piece = match key {
            "polygon" => self.planar_polygon(value, &inner, limits),
            "circle" => self.planar_circle(value, &inner, help),
            "half_plane" if self.fixed_only(&fields, key, path, role, help) => self.half_plane(value, &inner, help),
            "point" if self.fixed_only(&fields, key, path, role, help) => {
                self.doubles(value, &inner, PAIR_HELP).map(|center| disc(center, 0.0))
            }
            "compound" => return self.planar_compound(value, &inner, role, limits, is_piece),
            _ => None,
        };
        piece.map(|piece| vec![piece])
    }

    fn planar_compound(
        &mut self,
        value: &Value,
        path: &Path,
        role: Role,
        limits: &Limits,
        is_piece: bool,
    ) -> Option<Vec<Piece>> {
        let help = r#"write {"compound": [{"circle": {"center": [0, 0], "radius": 0.05}}, ...]}"#;
        let elements = &self.array(value, path, help)?.elements;
        if elements.is_empty() || is_piece {
            self.fault(FaultKind::Compound, span_of(value), path, help);
            return None;
        }
        if elements.len() > limits.vertices {
            let kind = FaultKind::TooManyVertices { vertices: elements.len(), limit: limits.vertices };
            self.fault(kind, span_of(value), path, "raise the limit with --max-vertices");
            return None;
        }
        let pieces: Vec<Option<Vec<Piece>>> = elements
            .iter()
            .enumerate()
            .map(|(index, element)| self.planar_pieces(element, &path.index(index), role, limits, true))
            .collect();
        pieces.into_iter().collect::<Option<Vec<_>>>().map(|pieces| pieces.into_iter().flatten().collect())
    }

    fn planar_polygon(&mut self, value: &Value, path: &Path, limits: &Limits) -> Option<Piece> {
        let polygon = self.polygon(value, path, limits)?;
        let corners: Option<Vec<[f64; 2]>> =
            polygon.vertices().iter().map(|[x, y]| Some([rounded(x)?, rounded(y)?])).collect();
        let Some(corners) = corners else {
            let kind = FaultKind::NotADouble { value: format!("a length of {}", show::number(&polygon.extent())) };
            self.fault(kind, span_of(value), path, "write lengths in metres");
            return None;
        };
        let exact = |[x, y]: &[f64; 2]| Some([from_float_exact(*x)?, from_float_exact(*y)?]);
        let near = corners.iter().map(exact).collect::<Option<Vec<_>>>().and_then(|list| Polygon::new(list).ok());
        if near.is_none_or(|near| near.n_edges() != corners.len()) {
            self.fault(FaultKind::RoundedPolygon, span_of(value), path, "drop vertices that nearly coincide");
            return None;
        }
        let Moments { area, centroid, polar } = polygon.moments();
        Some(Piece {
            n_vertices: corners.len(),
            shape: PlanarShape::Polygon(corners),
            area: to_f64(&area),
            centroid: centroid.each_ref().map(to_f64),
            polar: to_f64(&polar),
            is_around_origin: polygon.hull_contains_all(&[[Q::zero(), Q::zero()]]),
        })
    }

    fn planar_circle(&mut self, value: &Value, path: &Path, help: &str) -> Option<Piece> {
        let fields = self.fields(value, path, &["center", "radius"], help)?;
        let center = self.optional_doubles(&fields, "center", path, PAIR_HELP);
        self.require(&fields, "radius", path, help);
        let radius = self.optional_double(&fields, "radius", path, Bound::Positive)?;
        Some(disc(center?.unwrap_or_default(), radius?))
    }

    fn half_plane(&mut self, value: &Value, path: &Path, help: &str) -> Option<Piece> {
        let fields = self.fields(value, path, &["point", "normal"], help)?;
        let point = self.require(&fields, "point", path, help);
        let point = point.and_then(|value| self.doubles(value, &path.key("point"), PAIR_HELP));
        let normal = self.require(&fields, "normal", path, help);
        let normal_help = "write a vector out of the material, like [0, 1]";
        let normal = normal.and_then(|value| self.direction(value, &path.key("normal"), normal_help));
        let shape = PlanarShape::HalfPlane { point: point?, normal: normal? };
        Some(Piece { shape, area: 0.0, centroid: [0.0; 2], polar: 0.0, n_vertices: 2, is_around_origin: false })
    }
}

fn disc(center: [f64; 2], radius: f64) -> Piece {
    let area = PI * radius * radius;
    Piece {
        shape: PlanarShape::Circle { center, radius },
        area,
        centroid: center,
        polar: area * radius * radius / 2.0,
        n_vertices: 1,
        is_around_origin: center[0].hypot(center[1]) < radius,
    }
}

/// Everything but the shape.
fn described(pieces: &[Piece]) -> Solid<Planar> {
    let area: f64 = pieces.iter().map(|piece| piece.area).sum();
    let share = |piece: &Piece| piece.area / area;
    let centroid = [0, 1].map(|axis| pieces.iter().map(|piece| share(piece) * piece.centroid[axis]).sum::<f64>());
    let away = |piece: &Piece| piece.centroid[0].powi(2) + piece.centroid[1].powi(2);
    let gyration2 = pieces.iter().map(|piece| piece.polar / area + share(piece) * away(piece)).sum::<f64>();
    let is_off = centroid[0].hypot(centroid[1]) > CENTERED * gyration2.sqrt();
    let is_outside = matches!(pieces, [only] if !only.is_around_origin);
    Solid {
        shape: PlanarShape::Compound(Vec::new()),
        n_vertices: pieces.iter().map(|piece| piece.n_vertices).sum(),
        gyration2: (gyration2.is_finite() && gyration2 > 0.0).then_some([gyration2]),
        offset: is_off
            .then(|| format!("the centroid of its shape is at [{}, {}]", brief(centroid[0]), brief(centroid[1]))),
        outside: is_outside.then(|| "outside of the convex hull of its shape".to_owned()),
    }
}

/// A coordinate, shortened.
fn brief(value: f64) -> String {
    from_float_exact(value).as_ref().map_or_else(|| value.to_string(), show::number)
}
