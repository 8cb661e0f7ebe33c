//! The `insert` section: fixels, moved exactly onto the outline.

use super::fault::Fault;
use super::friction::FRICTION_HELP;
use super::kind::FaultKind;
use super::reader::{Fields, Path, Reader, span_of};
use super::show;
use super::{Limits, SMALLEST_INSERT};
use crate::exact::{Q, ratio};
use crate::geometry::{Location, Polygon, cross, difference, dot, rational_point_on_circle, shortened};
use crate::model::{Fixel, Fixture, GivenPush, Place, Shape};
use jsonc_parser::ast::Value;
use num_traits::{One as _, Signed as _, ToPrimitive as _, Zero as _};
use std::ops::Range;

const PLACE_HELP: &str = r#"write {"at": [x, y], ...} or {"edge": 3, "s": "1/4", ...}"#;

/// Where a fixel touches the outline.
struct Contact {
    place: Place,
    point: [Q; 2],
}

impl Reader {
    /// The fixture, and the plan given with it; `shape` is missing where it has faults of its own.
    pub fn fixture(
        &mut self,
        value: &Value,
        path: &Path,
        shape: Option<&Shape>,
        limits: &Limits,
    ) -> Option<(Fixture, Option<GivenPush>)> {
        let fields = self.fields(value, path, &["fixels", "plan"], SMALLEST_INSERT)?;
        let plan = match fields.get("plan") {
            Some(plan) => self.given_push(plan, &path.key("plan"), shape).map(Some),
            None => Some(None),
        };
        let fixture = self.fixels(&fields, path, shape, limits);
        fixture.zip(plan)
    }

    fn fixels(&mut self, fields: &Fields, path: &Path, shape: Option<&Shape>, limits: &Limits) -> Option<Fixture> {
        let list = self.require(fields, "fixels", path, SMALLEST_INSERT)?;
        let path = path.key("fixels");
        let elements = &self.array(list, &path, SMALLEST_INSERT)?.elements;
        if elements.is_empty() {
            self.fault(FaultKind::NoFixels, span_of(list), &path, SMALLEST_INSERT);
            return None;
        }
        if elements.len() > limits.fixels {
            let kind = FaultKind::TooManyFixels { fixels: elements.len(), limit: limits.fixels };
            self.fault(kind, span_of(list), &path, "raise the limit with --max-fixels");
            return None;
        }
        let fixels: Vec<Option<Fixel>> =
            elements.iter().enumerate().map(|(i, element)| self.fixel(element, &path.index(i), shape)).collect();
        fixels.into_iter().collect::<Option<Vec<_>>>().map(|fixels| Fixture { fixels })
    }

    fn fixel(&mut self, value: &Value, path: &Path, shape: Option<&Shape>) -> Option<Fixel> {
        let fields = self.fields(value, path, &["at", "edge", "s", "normal", "friction"], SMALLEST_INSERT)?;
        let contact = self.contact(&fields, path, shape);
        let normal = match fields.get("normal") {
            Some(value) => self.normal(value, &path.key("normal")).map(Some),
            None => Some(None),
        };
        let friction = self.require(&fields, "friction", path, FRICTION_HELP);
        let friction = friction.and_then(|value| self.friction(value, &path.key("friction")));
        let (contact, normal) = (contact?, normal?);
        let normal_span = fields.get("normal").map(span_of);
        let normal = match shape? {
            Shape::Polygon(polygon) => match contact.place {
                Place::Vertex { vertex } => self.vertex_normal(polygon, vertex, normal, normal_span, &fields, path),
                Place::Edge { edge, .. } => self.fixed_normal(polygon.inward_normal(edge), normal, normal_span, path),
                Place::Arc => None,
            },
            Shape::Circle { center, .. } => {
                self.fixed_normal(shortened(&difference(&contact.point, center)), normal, normal_span, path)
            }
        };
        Some(Fixel { place: contact.place, point: contact.point, normal: normal?, friction: friction? })
    }

    fn contact(&mut self, fields: &Fields, path: &Path, shape: Option<&Shape>) -> Option<Contact> {
        let is_mixed = self.exclude(fields, ["at", "edge"], path, PLACE_HELP)
            || (fields.get("edge").is_none() && self.exclude(fields, ["at", "s"], path, PLACE_HELP));
        let at = fields.get("at").map(|value| (value, self.pair(value, &path.key("at"))));
        if fields.get("at").is_none() && fields.get("edge").is_none() && fields.get("s").is_none() {
            self.require(fields, "at", path, PLACE_HELP);
            return None;
        }
        if is_mixed {
            return None;
        }
        if let Some((value, at)) = at {
            return self.contact_at(at?, span_of(value), &path.key("at"), shape?);
        }
        let edge_value = self.require(fields, "edge", path, PLACE_HELP);
        let edge = edge_value.and_then(|value| Some((span_of(value), self.number(value, &path.key("edge"))?)));
        let s = self.require(fields, "s", path, PLACE_HELP).and_then(|value| self.share(value, &path.key("s")));
        let (span, edge) = edge?;
        let polygon = match shape? {
            Shape::Polygon(polygon) => polygon,
            Shape::Circle { .. } => {
                let help = r#"write {"at": [x, y], ...}"#;
                self.fault(FaultKind::EdgeOfCircle, fields.key_span("edge"), &path.key("edge"), help);
                return None;
            }
        };
        let number = self.edge_number(&edge, span, &path.key("edge"), polygon.n_edges())?;
        let location = polygon.location(number, s?);
        Some(contact_on(polygon, location))
    }

    /// A number as that of one of `n_edges` edges.
    pub fn edge_number(&mut self, edge: &Q, span: Range<usize>, path: &Path, n_edges: usize) -> Option<usize> {
        let number = Some(edge).filter(|edge| edge.is_integer()).and_then(|edge| edge.to_usize());
        let number = number.filter(|number| *number < n_edges);
        if number.is_none() {
            let kind = FaultKind::NoSuchEdge { edge: show::number(edge), last: n_edges - 1 };
            self.fault(kind, span, path, "edge i runs from vertex i to the next one, counter-clockwise, from 0");
        }
        number
    }

    /// A share of an edge.
    pub fn share(&mut self, value: &Value, path: &Path) -> Option<Q> {
        let s = self.number(value, path)?;
        if s.is_negative() || s > Q::one() {
            let kind = FaultKind::OutOfRange { name: "s", range: "from 0 to 1".into(), value: show::number(&s) };
            self.fault(kind, span_of(value), path, "s is the share of the edge's length from its first vertex");
            return None;
        }
        Some(s)
    }

    fn contact_at(&mut self, at: [Q; 2], span: Range<usize>, path: &Path, shape: &Shape) -> Option<Contact> {
        let millionth = ratio(1, 1_000_000);
        let (contact, nearest, is_near, distance) = match shape {
            Shape::Polygon(polygon) => {
                if let Some(location) = polygon.locate(&at) {
                    return Some(contact_on(polygon, location));
                }
                let (location, point, distance2) = polygon.nearest(&at);
                let tolerance = polygon.extent() * millionth;
                let is_near = distance2 <= &tolerance * &tolerance;
                (contact_on(polygon, location), point, is_near, distance2)
            }
            Shape::Circle { center, radius } => {
                let gap = difference(center, &at);
                let distance2 = dot(&gap, &gap);
                if distance2 == radius * radius {
                    return Some(Contact { place: Place::Arc, point: at });
                }
                let tolerance = radius * ratio(2, 1) * millionth;
                let (inner, outer) = (radius - &tolerance, radius + &tolerance);
                let is_near = &inner * &inner <= distance2 && distance2 <= &outer * &outer;
                let point = rational_point_on_circle(center, radius, &at, &tolerance);
                let point = point.unwrap_or_else(|| [&center[0] + radius, center[1].clone()]);
                let moved = difference(&at, &point);
                (Contact { place: Place::Arc, point: point.clone() }, point, is_near, dot(&moved, &moved))
            }
        };
        let (old, new, distance) = (show::point(&at), show::point(&nearest), show::distance(&distance));
        if !is_near {
            let help = format!("write \"at\": {new}, or change the outline");
            let kind = FaultKind::OffTheBoundary { at: old, nearest: new, distance };
            self.fault(kind, span, path, help);
            return None;
        }
        self.warnings.push(format!("{path}: {old} is moved onto the boundary at {new}, {distance} away"));
        Some(contact)
    }

    fn normal(&mut self, value: &Value, path: &Path) -> Option<[Q; 2]> {
        let normal = self.pair(value, path)?;
        if normal.iter().all(Q::is_zero) {
            self.fault(FaultKind::ZeroNormal, span_of(value), path, "write a vector that points into the part");
            return None;
        }
        Some(shortened(&normal))
    }

    fn vertex_normal(
        &mut self,
        polygon: &Polygon,
        vertex: usize,
        normal: Option<[Q; 2]>,
        span: Option<Range<usize>>,
        fields: &Fields,
        path: &Path,
    ) -> Option<[Q; 2]> {
        let [before, after] = polygon.normals_at(vertex).map(|normal| show::point(&normal));
        let help = if before == after {
            format!("the only normal there is {before}")
        } else {
            format!("the normals there lie between {before} and {after}")
        };
        let path = path.key("normal");
        let (Some(normal), Some(span)) = (normal, span) else {
            let span = ["at", "s"].iter().find_map(|key| fields.get(key)).map_or(fields.span.clone(), span_of);
            self.fault(FaultKind::VertexNeedsNormal { vertex }, span, &path, help);
            return None;
        };
        if !polygon.admits_normal(vertex, &normal) {
            let kind = FaultKind::NormalOutsideCone { normal: show::point(&normal), vertex };
            self.fault(kind, span, &path, help);
            return None;
        }
        Some(normal)
    }

    /// The inward normal where the outline allows no other.
    fn fixed_normal(
        &mut self,
        inward: [Q; 2],
        normal: Option<[Q; 2]>,
        span: Option<Range<usize>>,
        path: &Path,
    ) -> Option<[Q; 2]> {
        if let (Some(normal), Some(span)) = (normal, span)
            && !(cross(&inward, &normal).is_zero() && dot(&inward, &normal).is_positive())
        {
            let kind = FaultKind::NormalNotInward { normal: show::point(&normal), inward: show::point(&inward) };
            let fault = Fault::new(kind).at(span).on(path.key("normal").to_string());
            self.push(fault.help("leave `normal` out: away from vertices it is the outline's"));
            return None;
        }
        Some(inward)
    }
}

fn contact_on(polygon: &Polygon, location: Location) -> Contact {
    let point = polygon.point(&location);
    let place = match location {
        Location::Vertex(vertex) => Place::Vertex { vertex },
        Location::Edge { edge, s } => Place::Edge { edge, s },
    };
    Contact { place, point }
}
