//! Closest features of polygons in the plane; the one file that names parry.

use crate::answer::Feature;
use parry2d_f64::math::Vector;
use parry2d_f64::query::PointQueryWithLocation as _;
use parry2d_f64::shape::{Segment, SegmentPointLocation};

/// Where a point lies to a polygon.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Closest {
    /// Signed distance (m): negative inside.
    pub distance: f64,
    /// The nearest point of the outline.
    pub point: [f64; 2],
    /// Unit normal out of the polygon there.
    pub normal: [f64; 2],
    /// The nearest vertex or edge.
    pub feature: Feature,
}

/// A polygon in the world: vertices counter-clockwise, and the unit outward normal of the edge that follows each.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Outline {
    pub vertices: Vec<[f64; 2]>,
    pub normals: Vec<[f64; 2]>,
    /// Whether the outline turns left at a vertex.
    pub convex: Vec<bool>,
    /// Least and largest coordinates.
    pub bounds: [[f64; 2]; 2],
}

/// Cosine of the tolerance with which a normal lies in the normal cone of a vertex: 0.2 rad.
const CONE_COSINE: f64 = 0.980_066_577_841_241_6;

impl Outline {
    pub fn new(vertices: Vec<[f64; 2]>) -> Self {
        let n = vertices.len();
        let edge = |i: usize| sub(vertices[(i + 1) % n], vertices[i]);
        let normals = (0..n).map(|i| unit([edge(i)[1], -edge(i)[0]])).collect();
        let convex = (0..n).map(|i| cross(edge((i + n - 1) % n), edge(i)) > 0.0).collect();
        let mut outline = Self { vertices, normals, convex, bounds: [[0.0; 2]; 2] };
        outline.bound();
        outline
    }

    /// Takes the place of `body`'s outline turned by the angle of this cosine and sine, then moved.
    pub fn place(&mut self, body: &Self, [cosine, sine]: [f64; 2], by: [f64; 2]) {
        let turn = |v: [f64; 2]| [cosine * v[0] - sine * v[1], sine * v[0] + cosine * v[1]];
        for (vertex, own) in self.vertices.iter_mut().zip(&body.vertices) {
            let turned = turn(*own);
            *vertex = [turned[0] + by[0], turned[1] + by[1]];
        }
        for (normal, own) in self.normals.iter_mut().zip(&body.normals) {
            *normal = turn(*own);
        }
        self.bound();
    }

    fn bound(&mut self) {
        let mut bounds = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
        for v in &self.vertices {
            for axis in 0..2 {
                bounds[0][axis] = bounds[0][axis].min(v[axis]);
                bounds[1][axis] = bounds[1][axis].max(v[axis]);
            }
        }
        self.bounds = bounds;
    }

    /// Longer side of the box around the outline (m).
    pub fn size(&self) -> f64 {
        let [low, high] = self.bounds;
        (high[0] - low[0]).max(high[1] - low[1])
    }

    /// Whether a point is within `reach` of the box around the outline.
    pub fn is_near(&self, [x, y]: [f64; 2], reach: f64) -> bool {
        let [low, high] = self.bounds;
        x >= low[0] - reach && x <= high[0] + reach && y >= low[1] - reach && y <= high[1] + reach
    }

    /// Whether the boxes around two outlines are within `reach` of each other.
    pub fn is_near_box(&self, [low, high]: [[f64; 2]; 2], reach: f64) -> bool {
        let own = self.bounds;
        (0..2).all(|axis| low[axis] <= own[1][axis] + reach && own[0][axis] <= high[axis] + reach)
    }

    /// The closest feature to `point` within `reach` whose normal `accept` takes.
    ///
    /// A point on a corner lies on two edges and, by rounding, on either side of each: where the closest feature is not
    /// taken, an edge that is as close as rounding can tell may be.
    pub fn closest(&self, point: [f64; 2], reach: f64, accept: impl Fn([f64; 2]) -> bool) -> Option<Closest> {
        let mut best: Option<(f64, Closest)> = None;
        for edge in 0..self.vertices.len() {
            let within = best.map_or(reach * reach, |(squared, _)| squared);
            if let Some((squared, location, nearest)) = self.to_edge(edge, point, within) {
                best = Some((squared, self.found(edge, location, point, nearest, squared)));
            }
        }
        let (squared, closest) = best?;
        let rounding = 1e-6 * self.size();
        let is_corner = matches!(closest.feature, Feature::Vertex(_)) && squared <= rounding * rounding;
        if !is_corner && accept(closest.normal) {
            return Some(closest);
        }
        let tied =
            (0..self.vertices.len()).filter(|edge| squared <= rounding * rounding && accept(self.normals[*edge]));
        tied.filter_map(|edge| {
            let (squared, _, nearest) = self.to_edge(edge, point, rounding * rounding)?;
            Some((squared, self.on_edge(edge, point, nearest)))
        })
        .min_by(|(a, _), (b, _)| a.total_cmp(b))
        .map(|(_, closest)| closest)
    }

    /// Squared distance to an edge, where on it, and the nearest point, unless it is farther than `within` (squared).
    fn to_edge(&self, edge: usize, point: [f64; 2], within: f64) -> Option<(f64, SegmentPointLocation, [f64; 2])> {
        let (a, b) = (self.vertices[edge], self.vertices[if edge + 1 == self.vertices.len() { 0 } else { edge + 1 }]);
        // nearer than the line of an edge no point of it is
        let height = dot(self.normals[edge], sub(point, a));
        if height * height > within {
            return None;
        }
        let segment = Segment::new(Vector::new(a[0], a[1]), Vector::new(b[0], b[1]));
        let p = Vector::new(point[0], point[1]);
        let (projection, location) = segment.project_local_point_and_get_location(p, true);
        let squared = (p - projection.point).length_squared();
        (squared <= within).then_some((squared, location, [projection.point.x, projection.point.y]))
    }

    fn found(
        &self,
        edge: usize,
        location: SegmentPointLocation,
        point: [f64; 2],
        nearest: [f64; 2],
        squared: f64,
    ) -> Closest {
        let n = self.vertices.len();
        let SegmentPointLocation::OnVertex(end) = location else {
            return self.on_edge(edge, point, nearest);
        };
        let vertex = (edge + end as usize) % n;
        let sign = if self.convex[vertex] { 1.0 } else { -1.0 };
        let distance = squared.sqrt();
        if distance == 0.0 {
            return self.on_edge(edge, point, nearest);
        }
        let away = sub(point, nearest);
        let normal = [sign * away[0] / distance, sign * away[1] / distance];
        Closest { distance: sign * distance, point: nearest, normal, feature: feature(Feature::Vertex, vertex) }
    }

    fn on_edge(&self, edge: usize, point: [f64; 2], nearest: [f64; 2]) -> Closest {
        let normal = self.normals[edge];
        let distance = dot(normal, sub(point, self.vertices[edge]));
        Closest { distance, point: nearest, normal, feature: feature(Feature::Edge, edge) }
    }

    /// Whether something that lies along the unit direction `d` from a vertex meets that vertex first: `d` is in its
    /// normal cone, up to 0.2 rad.
    pub fn sees(&self, vertex: usize, d: [f64; 2]) -> bool {
        if !self.convex[vertex] {
            return false;
        }
        let n = self.normals.len();
        let (before, after) = (self.normals[(vertex + n - 1) % n], self.normals[vertex]);
        let is_between = cross(before, d) >= 0.0 && cross(d, after) >= 0.0;
        is_between || dot(before, d) >= CONE_COSINE || dot(after, d) >= CONE_COSINE
    }
}

fn feature(kind: fn(u32) -> Feature, index: usize) -> Feature {
    kind(u32::try_from(index).unwrap_or(u32::MAX))
}

pub(super) fn sub(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

pub(super) fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

pub(super) fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

pub(super) fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    let away = sub(a, b);
    dot(away, away).sqrt()
}

pub(super) fn unit(v: [f64; 2]) -> [f64; 2] {
    let length = dot(v, v).sqrt();
    [v[0] / length, v[1] / length]
}
