//! The `part` section: shape, center of mass, mass and inertia.

use super::fault::Fault;
use super::kind::FaultKind;
use super::reader::{Fields, Path, Reader, span_of};
use super::show;
use super::{Limits, text::SMALLEST_CASE};
use crate::exact::{Q, ratio};
use crate::geometry::{Moments, Polygon, PolygonFault, difference, dot};
use crate::model::{LengthUnit, Part, Shape};
use jsonc_parser::ast::Value;
use num_traits::{One as _, Signed as _, Zero as _};
use std::ops::Range;

const SHAPE_HELP: &str =
    r#"write {"polygon": [[0, 0], [1, 0], [0, 1]]} or {"circle": {"center": [0, 0], "radius": 1}}"#;
const CENTER_HELP: &str = r#"write [x, y] or {"at": [x, y], "tolerance": 0.05}"#;
const INERTIA_HELP: &str = "give one of the two, or neither for a uniform lamina";

/// A center of mass as the file gives it.
struct Center {
    at: [Q; 2],
    tolerance: Q,
}

impl Reader {
    /// The part, whose shape is returned as well when the rest is faulty.
    pub fn part(
        &mut self,
        value: &Value,
        path: &Path,
        unit: LengthUnit,
        limits: &Limits,
    ) -> (Option<Shape>, Option<Part>) {
        let known = ["shape", "center_of_mass", "mass", "inertia", "radius_of_gyration"];
        let Some(fields) = self.fields(value, path, &known, SMALLEST_CASE) else {
            return (None, None);
        };
        let shape = self.require(&fields, "shape", path, SHAPE_HELP);
        let shape = shape.and_then(|value| self.shape(value, &path.key("shape"), limits));
        let center = fields.get("center_of_mass").map(|value| (value, self.center(value, &path.key("center_of_mass"))));
        let mass = self.optional_positive(&fields, "mass", path);
        let inertia = self.optional_positive(&fields, "inertia", path);
        let gyration = self.optional_positive(&fields, "radius_of_gyration", path);
        let is_doubled = self.exclude(&fields, ["inertia", "radius_of_gyration"], path, INERTIA_HELP);
        let Some(shape) = shape else {
            return (None, None);
        };
        let moments = moments(&shape);
        let center = match center {
            None => Some(Center { at: moments.centroid.clone(), tolerance: Q::zero() }),
            Some((value, Some(center))) => self.inside(center, &shape, span_of(value), &path.key("center_of_mass")),
            Some((_, None)) => None,
        };
        let (Some(center), Some(mass), Some(inertia), Some(gyration), false) =
            (center, mass, inertia, gyration, is_doubled)
        else {
            return (Some(shape), None);
        };
        let mass = mass.unwrap_or_else(Q::one);
        if inertia.is_none() && gyration.is_none() && center.at != moments.centroid {
            let centroid = show::point(&moments.centroid);
            self.warnings.push(format!(
                "inertia defaults to the uniform lamina's about its centroid {centroid}, but center_of_mass is \
                 elsewhere; give inertia or radius_of_gyration"
            ));
        }
        let inertia = match (inertia, gyration) {
            (Some(inertia), _) => inertia,
            (None, Some(radius)) => &mass * &radius * &radius,
            (None, None) => &mass * &moments.polar / &moments.area,
        };
        let part = Part {
            unit,
            shape: shape.clone(),
            center_of_mass: center.at,
            center_of_mass_tolerance: center.tolerance,
            mass,
            inertia,
        };
        (Some(shape), Some(part))
    }

    fn shape(&mut self, value: &Value, path: &Path, limits: &Limits) -> Option<Shape> {
        let fields = self.fields(value, path, &["polygon", "circle"], SHAPE_HELP)?;
        if self.exclude(&fields, ["polygon", "circle"], path, SHAPE_HELP) {
            return None;
        }
        if let Some(circle) = fields.get("circle") {
            return self.circle(circle, &path.key("circle"));
        }
        let vertices = self.require(&fields, "polygon", path, SHAPE_HELP)?;
        self.polygon(vertices, &path.key("polygon"), limits).map(Shape::Polygon)
    }

    fn circle(&mut self, value: &Value, path: &Path) -> Option<Shape> {
        let fields = self.fields(value, path, &["center", "radius"], SHAPE_HELP)?;
        let center = self.require(&fields, "center", path, SHAPE_HELP);
        let center = center.and_then(|value| self.pair(value, &path.key("center")));
        self.require(&fields, "radius", path, SHAPE_HELP);
        let radius = self.optional_positive(&fields, "radius", path)?;
        Some(Shape::Circle { center: center?, radius: radius? })
    }

    /// A simple polygon, counter-clockwise.
    pub fn polygon(&mut self, value: &Value, path: &Path, limits: &Limits) -> Option<Polygon> {
        let elements = &self.array(value, path, SHAPE_HELP)?.elements;
        if elements.len() > limits.vertices {
            let kind = FaultKind::TooManyVertices { vertices: elements.len(), limit: limits.vertices };
            self.fault(kind, span_of(value), path, "raise the limit with --max-vertices");
            return None;
        }
        let pairs: Vec<Option<[Q; 2]>> =
            elements.iter().enumerate().map(|(i, element)| self.pair(element, &path.index(i))).collect();
        let vertices = pairs.into_iter().collect::<Option<Vec<_>>>()?;
        match Polygon::new(vertices) {
            Ok(polygon) => Some(polygon),
            Err(faults) => {
                let spans: Vec<Range<usize>> = elements.iter().map(span_of).collect();
                for fault in faults {
                    self.push(polygon_fault(fault, &spans, span_of(value), path));
                }
                None
            }
        }
    }

    fn center(&mut self, value: &Value, path: &Path) -> Option<Center> {
        match value {
            Value::Array(_) => Some(Center { at: self.pair(value, path)?, tolerance: Q::zero() }),
            Value::Object(_) => {
                let fields = self.fields(value, path, &["at", "tolerance"], CENTER_HELP)?;
                let at = self.require(&fields, "at", path, CENTER_HELP);
                let at = at.and_then(|value| self.pair(value, &path.key("at")));
                let tolerance_value = self.require(&fields, "tolerance", path, CENTER_HELP)?;
                let tolerance = self.number(tolerance_value, &path.key("tolerance"))?;
                if tolerance.is_negative() {
                    let kind = FaultKind::Negative { name: "a tolerance", value: show::number(&tolerance) };
                    self.fault(kind, span_of(tolerance_value), &path.key("tolerance"), CENTER_HELP);
                    return None;
                }
                Some(Center { at: at?, tolerance })
            }
            _ => {
                self.wrong_type("a list or an object", value, path, CENTER_HELP);
                None
            }
        }
    }

    fn inside(&mut self, center: Center, shape: &Shape, span: Range<usize>, path: &Path) -> Option<Center> {
        let (corners, t) = (box_corners(&center), &center.tolerance);
        let (is_inside, outline) = match shape {
            Shape::Polygon(polygon) => (polygon.hull_contains_all(&corners), "convex hull"),
            Shape::Circle { center, radius } => {
                let is_in_disc = |corner: &[Q; 2]| {
                    let gap = difference(center, corner);
                    dot(&gap, &gap) < radius * radius
                };
                (corners.iter().all(is_in_disc), "circle")
            }
        };
        if is_inside {
            return Some(center);
        }
        let mut point = show::point(&center.at);
        if t.is_positive() {
            point.push_str(&format!(" ± {}", show::number(t)));
        }
        let help = format!("leave it out for the area centroid {}", show::point(&moments(shape).centroid));
        self.fault(FaultKind::CenterOfMassOutside { point, outline }, span, path, help);
        None
    }

    /// `Some(None)` where the key is not given, `None` after a fault.
    pub(super) fn optional_positive(&mut self, fields: &Fields, key: &'static str, path: &Path) -> Option<Option<Q>> {
        let Some(value) = fields.get(key) else {
            return Some(None);
        };
        let path = path.key(key);
        let number = self.number(value, &path)?;
        if !number.is_positive() {
            let kind = FaultKind::NotPositive { name: key, value: show::number(&number) };
            self.fault(kind, span_of(value), &path, "write a number above 0");
            return None;
        }
        Some(Some(number))
    }
}

fn box_corners(center: &Center) -> Vec<[Q; 2]> {
    let ([x, y], t) = (&center.at, &center.tolerance);
    if t.is_zero() {
        return vec![center.at.clone()];
    }
    vec![[x - t, y - t], [x + t, y - t], [x + t, y + t], [x - t, y + t]]
}

/// Area, centroid and polar moment; those of a circle are divided by π.
fn moments(shape: &Shape) -> Moments {
    match shape {
        Shape::Polygon(polygon) => polygon.moments(),
        Shape::Circle { center, radius } => {
            let area = radius * radius;
            Moments { polar: &area * &area * ratio(1, 2), area, centroid: center.clone() }
        }
    }
}

fn polygon_fault(fault: PolygonFault, vertices: &[Range<usize>], whole: Range<usize>, path: &Path) -> Fault {
    let next = |edge: usize| (edge + 1) % vertices.len();
    let vertex = |index: usize| vertices[index].clone();
    // an edge is shown from its first vertex to its second, or by its first alone where the list closes
    let edge = |index: usize| vertices[index].start..vertices[next(index)].end.max(vertices[index].end).min(whole.end);
    let edge = |index: usize| if next(index) == 0 { vertex(index) } else { edge(index) };
    let kind = FaultKind::Polygon(Box::new(fault.clone()));
    match fault {
        PolygonFault::RepeatedVertex { first, second } => Fault::new(kind)
            .at(vertex(second))
            .on(path.index(second).to_string())
            .help("remove one of the two; the outline closes by itself")
            .related(vertex(first), format!("vertex {first}")),
        PolygonFault::Spike { vertex: at } => Fault::new(kind)
            .at(vertex(at))
            .on(path.index(at).to_string())
            .help("remove the vertex, or move it off the line"),
        PolygonFault::Crossing { first, second, at } => Fault::new(kind)
            .at(edge(second))
            .on(path.index(second).to_string())
            .help(format!(
                "edges {first} ({first} to {}) and {second} ({second} to {}) meet at {}; list the vertices in the order of \
                 the outline",
                next(first),
                next(second),
                show::point(&at)
            ))
            .related(edge(first), format!("edge {first}")),
        PolygonFault::ZeroArea => {
            Fault::new(kind).at(whole).on(path.to_string()).help("give at least three vertices that are not on one line")
        }
        PolygonFault::TooManyDigits { .. } => {
            Fault::new(kind).at(whole).on(path.to_string()).help("round the coordinates to fewer digits")
        }
        _ => Fault::new(kind).at(whole).on(path.to_string()).help("write [[0, 0], [1, 0], [0, 1]]"),
    }
}
