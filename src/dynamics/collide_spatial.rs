//! Closest features of boxes, and of boxes and balls, in space.
//!
//! All of it is in closed form, and parry is not asked: its contact manifolds have no gaps beyond a prediction distance and
//! drop points of a patch, its closest points have no signed gap where shapes overlap, and neither names features
//! that last from step to step. A point against a box is a clamp; two edges are a system of two equations.

use super::turning::{UPRIGHT, along, cross, dot, length, placed, scaled, sub, turned};
use crate::answer::Feature;

/// Sine of the tolerance with which a normal lies in the normal cone of a vertex or edge: 0.2 rad.
const CONE_SINE: f64 = 0.198_669_330_795_061_22;

/// Sine of the angle below which edges count as parallel, and vertices on them tell all.
const PARALLEL: f64 = 1e-9;

/// Edges that cross at less than this cosine from the normal do not meet along it.
const LEAST_COSINE: f64 = 0.5;

/// A box in the world.
///
/// Vertex `i` lies at +half along the axes of the bits set in `i`. Edge `4 a + i` runs along axis `a`, and bits 0 and 1 of
/// `i` say on which side of the next axes. Face `1 + 2 a` looks down axis `a`, face `2 + 2 a` up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Cuboid {
    center: [f64; 3],
    axes: [[f64; 3]; 3],
    half: [f64; 3],
}

/// The feature of a box that is closest to something.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Near {
    /// Signed distance (m): negative inside.
    pub distance: f64,
    /// The nearest point of the feature.
    pub point: [f64; 3],
    /// Unit normal out of the box there.
    pub normal: [f64; 3],
    pub feature: Feature,
}

/// Two edges where they cross, as seen along the normal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Crossing {
    pub gap: f64,
    /// The points on the one edge and on the other.
    pub points: [[f64; 3]; 2],
    /// Unit normal from the other into the one.
    pub normal: [f64; 3],
    /// Whether both points are between the ends of their edges.
    pub is_inside: bool,
}

impl Cuboid {
    /// A box of these halves at a pose; upright at the origin without one.
    pub fn new(pose: Option<&[f64; 7]>, half: [f64; 3]) -> Self {
        let pose = pose.unwrap_or(&UPRIGHT);
        let axis = |i: usize| turned(pose, std::array::from_fn(|j| f64::from(u8::from(i == j))));
        Self { center: placed(pose, [0.0; 3]), axes: [axis(0), axis(1), axis(2)], half }
    }

    /// Whether no point of the box is within `reach` of a ball.
    pub fn is_far(&self, center: [f64; 3], radius: f64, reach: f64) -> bool {
        length(sub(self.center, center)) > length(self.half) + radius + reach
    }

    /// Whether no points of the boxes are within `reach` of each other, by the balls about them.
    pub fn is_far_from(&self, other: &Self, reach: f64) -> bool {
        self.is_far(other.center, length(other.half), reach)
    }

    /// The longest side (m).
    pub fn size(&self) -> f64 {
        2.0 * self.half.iter().copied().fold(0.0, f64::max)
    }

    pub fn vertex(&self, vertex: u32) -> [f64; 3] {
        self.placed(std::array::from_fn(|i| sign(vertex, i) * self.half[i]))
    }

    fn placed(&self, own: [f64; 3]) -> [f64; 3] {
        (0..3).fold(self.center, |point, i| along(point, own[i], self.axes[i]))
    }

    fn own(&self, point: [f64; 3]) -> [f64; 3] {
        let away = sub(point, self.center);
        self.axes.map(|axis| dot(axis, away))
    }

    /// The face or edge or vertex closest to `point`, by exact regions; from inside the nearest face.
    pub fn closest(&self, point: [f64; 3]) -> Near {
        let own = self.own(point);
        let excess: [f64; 3] = std::array::from_fn(|i| own[i].abs() - self.half[i]);
        let outside = excess.map(|excess| excess > 0.0);
        let nearest = (1..3).fold(0, |best, i| if excess[i] > excess[best] { i } else { best });
        let feature = match outside.iter().filter(|outside| **outside).count() {
            0 | 1 => Feature::Surface(face(nearest, own)),
            2 => Feature::Edge(edge(outside.iter().position(|outside| !outside).unwrap_or(0), own)),
            _ => Feature::Vertex(vertex(own)),
        };
        self.nearest_on(feature, point)
    }

    /// Where `point` lies to a feature: to the whole plane of a face, the whole line of an edge.
    pub fn nearest_on(&self, feature: Feature, point: [f64; 3]) -> Near {
        let own = self.own(point);
        let mut nearest = own;
        match feature {
            Feature::Surface(number) => {
                let (axis, sign) = face_axis(number);
                let distance = sign * own[axis] - self.half[axis];
                let normal = scaled(sign, self.axes[axis]);
                return Near { distance, point: along(point, -distance, normal), normal, feature };
            }
            Feature::Edge(number) => {
                let (_, sides) = edge_sides(number);
                for (axis, sign) in sides {
                    nearest[axis] = sign * self.half[axis];
                }
            }
            Feature::Vertex(number) => nearest = std::array::from_fn(|i| sign(number, i) * self.half[i]),
        }
        let nearest = self.placed(nearest);
        let away = sub(point, nearest);
        let distance = length(away);
        let normal = if distance > 0.0 { away.map(|x| x / distance) } else { self.ridge(feature) };
        Near { distance, point: nearest, normal, feature }
    }

    /// The feature closest to a vertex of another box that can meet it there.
    ///
    /// What is not past a face by more than `rounding` counts as not past it. A face, or an edge, is met only if its normal is
    /// in the normal cone of the vertex, and not if the other box just grazes its border from outside: a box that slides over
    /// the seam of two others does not run into the second. Where the vertex is inside, the nearest of the faces met counts.
    pub fn closest_to_vertex(&self, of: &Self, number: u32, rounding: f64) -> Option<Near> {
        let point = of.vertex(number);
        let own = self.own(point);
        let excess: [f64; 3] = std::array::from_fn(|i| own[i].abs() - self.half[i]);
        let outside = excess.map(|excess| excess > rounding);
        let grazes = |i: usize| {
            let outward = scaled(1.0_f64.copysign(own[i]), self.axes[i]);
            excess[i].abs() <= rounding && (0..3).all(|k| sign(number, k) * dot(of.axes[k], outward) <= 1e-6)
        };
        let meets = |near: &Near, met: [bool; 3]| {
            of.sees(number, near.normal.map(|x| -x)) && (0..3).all(|i| met[i] || !grazes(i))
        };
        let to_face = |axis: usize| {
            let near = self.nearest_on(Feature::Surface(face(axis, own)), point);
            meets(&near, std::array::from_fn(|i| i == axis)).then_some(near)
        };
        match outside {
            [false, false, false] => (0..3).filter_map(to_face).max_by(|a, b| a.distance.total_cmp(&b.distance)),
            [true, false, false] => to_face(0),
            [false, true, false] => to_face(1),
            [false, false, true] => to_face(2),
            _ => {
                let inside = outside.iter().position(|outside| !outside);
                let feature = inside.map_or(Feature::Vertex(vertex(own)), |axis| Feature::Edge(edge(axis, own)));
                Some(self.nearest_on(feature, point)).filter(|near| meets(near, outside))
            }
        }
    }

    /// Whether something that lies along the unit direction `d` from a vertex meets that vertex first: `d` is in its
    /// normal cone, up to 0.2 rad.
    fn sees(&self, vertex: u32, d: [f64; 3]) -> bool {
        let below = (0..3).map(|i| (sign(vertex, i) * dot(self.axes[i], d)).min(0.0));
        below.map(|x| x * x).sum::<f64>() <= CONE_SINE * CONE_SINE
    }

    /// Whether `d` is in the normal cone of an edge, up to 0.2 rad.
    fn is_edge_toward(&self, number: u32, d: [f64; 3]) -> bool {
        let (_, sides) = edge_sides(number);
        sides.into_iter().all(|(axis, sign)| sign * dot(self.axes[axis], d) >= -CONE_SINE)
    }

    /// The direction out of the box in the middle of the normal cone of a feature, of unit length.
    fn ridge(&self, feature: Feature) -> [f64; 3] {
        let signs = match feature {
            Feature::Vertex(number) => [0, 1, 2].map(|i| sign(number, i)),
            Feature::Edge(number) => {
                let mut signs = [0.0; 3];
                edge_sides(number).1.into_iter().for_each(|(axis, sign)| signs[axis] = sign);
                signs
            }
            Feature::Surface(number) => {
                let (axis, sign) = face_axis(number);
                std::array::from_fn(|i| if i == axis { sign } else { 0.0 })
            }
        };
        let sum = (0..3).fold([0.0; 3], |sum, i| along(sum, signs[i], self.axes[i]));
        scaled(1.0 / length(sum), sum)
    }

    /// The normal of the face that bounds the normal cone of an edge, where `d` is beyond it.
    fn bound(&self, number: u32, d: [f64; 3]) -> Option<[f64; 3]> {
        let (_, [first, second]) = edge_sides(number);
        let [a, b] = [first, second].map(|(axis, sign)| scaled(sign, self.axes[axis]));
        if dot(a, d) < 0.0 {
            Some(b)
        } else if dot(b, d) < 0.0 {
            Some(a)
        } else {
            None
        }
    }

    /// Middle of an edge, and its direction.
    fn line(&self, number: u32) -> ([f64; 3], usize) {
        let (axis, sides) = edge_sides(number);
        let mut own = [0.0; 3];
        for (side, sign) in sides {
            own[side] = sign * self.half[side];
        }
        (self.placed(own), axis)
    }
}

/// Where an edge of `a` and an edge of `b` cross; `None` if they are parallel.
///
/// The normal is that of both edges. Where it is outside of the normal cone of one of them, the normal of the face that
/// bounds the cone takes its place: with one face on another, the tilt that rounding leaves between them would turn the
/// common normal of nearly parallel edges anywhere.
pub(super) fn crossing(a: &Cuboid, on_a: u32, b: &Cuboid, on_b: u32) -> Option<Crossing> {
    let ((start, axis), (other_start, other_axis)) = (a.line(on_a), b.line(on_b));
    let (d, other_d) = (a.axes[axis], b.axes[other_axis]);
    let common = cross(d, other_d);
    let sine = length(common);
    if sine < PARALLEL {
        return None;
    }
    let ridges = [a.ridge(Feature::Edge(on_a)), b.ridge(Feature::Edge(on_b))];
    let common = scaled(dot(common, sub(ridges[1], ridges[0])).signum() / sine, common);
    let normal = b.bound(on_b, common).unwrap_or(common);
    let normal = a.bound(on_a, normal.map(|x| -x)).map_or(normal, |out| out.map(|x| -x));
    if dot(normal, common) < LEAST_COSINE {
        return None;
    }
    // start + s d and other_start + t other_d are one as seen along the normal
    let away = sub(start, other_start);
    let (across, other_across) = (cross(other_d, normal), cross(d, normal));
    let s = -dot(away, across) / dot(d, across);
    let t = dot(away, other_across) / dot(other_d, other_across);
    let points = [along(start, s, d), along(other_start, t, other_d)];
    Some(Crossing {
        gap: dot(normal, sub(points[0], points[1])),
        points,
        normal,
        is_inside: s.abs() <= a.half[axis] && t.abs() <= b.half[other_axis],
    })
}

/// Calls `found` with the numbers of every pair of edges that cross between their ends and have a common normal in the
/// normal cones of both, up to 0.2 rad.
pub(super) fn crossings(a: &Cuboid, b: &Cuboid, mut found: impl FnMut([u32; 2], Crossing)) {
    for (axis, other_axis) in (0..3).flat_map(|axis| (0..3).map(move |other| (axis, other))) {
        let common = cross(a.axes[axis], b.axes[other_axis]);
        let sine = length(common);
        if sine < PARALLEL {
            continue;
        }
        for common in [scaled(1.0 / sine, common), scaled(-1.0 / sine, common)] {
            let against = common.map(|x| -x);
            for on_a in (4 * axis as u32..).take(4).filter(|edge| a.is_edge_toward(*edge, against)) {
                for on_b in (4 * other_axis as u32..).take(4).filter(|edge| b.is_edge_toward(*edge, common)) {
                    let crossing = crossing(a, on_a, b, on_b).filter(|crossing| {
                        let Crossing { normal, is_inside, .. } = *crossing;
                        is_inside && dot(normal, common) > 0.0 && b.is_edge_toward(on_b, normal)
                    });
                    if let Some(crossing) = crossing {
                        found([on_a, on_b], crossing);
                    }
                }
            }
        }
    }
}

/// The largest distance between the boxes as seen along any normal of a face or common normal of edges (m), and that
/// direction from `b` to `a`: the separating axis if positive, the least overlap with its sign turned otherwise.
pub(super) fn separation(a: &Cuboid, b: &Cuboid) -> (f64, [f64; 3]) {
    let away = sub(a.center, b.center);
    let reach = |of: &Cuboid, d: [f64; 3]| -> f64 { (0..3).map(|i| of.half[i] * dot(of.axes[i], d).abs()).sum() };
    let faces = a.axes.into_iter().chain(b.axes);
    let pairs = a.axes.iter().flat_map(|d| b.axes.iter().map(move |other| cross(*d, *other)));
    let edges = pairs.filter_map(|common| {
        let sine = length(common);
        (sine > 1e-6).then(|| scaled(1.0 / sine, common))
    });
    let mut most = (f64::NEG_INFINITY, [0.0; 3]);
    for d in faces.chain(edges) {
        let along = dot(away, d);
        let distance = along.abs() - reach(a, d) - reach(b, d);
        if distance > most.0 {
            most = (distance, scaled(1.0_f64.copysign(along), d));
        }
    }
    most
}

/// -1 or 1: the side on which a vertex is along an axis.
fn sign(vertex: u32, axis: usize) -> f64 {
    if vertex >> axis & 1 == 1 { 1.0 } else { -1.0 }
}

fn vertex(own: [f64; 3]) -> u32 {
    (0..3).map(|i| u32::from(own[i] > 0.0) << i).sum()
}

fn face(axis: usize, own: [f64; 3]) -> u32 {
    1 + 2 * axis as u32 + u32::from(own[axis] > 0.0)
}

fn face_axis(face: u32) -> (usize, f64) {
    let number = face.saturating_sub(1);
    ((number / 2).min(2) as usize, if number % 2 == 1 { 1.0 } else { -1.0 })
}

/// The edge along `axis` on the side of `own`.
fn edge(axis: usize, own: [f64; 3]) -> u32 {
    let bit = |by: usize| u32::from(own[(axis + by) % 3] > 0.0);
    4 * axis as u32 + bit(1) + 2 * bit(2)
}

/// The axis of an edge, and on which side of the next axes it is.
fn edge_sides(edge: u32) -> (usize, [(usize, f64); 2]) {
    let axis = (edge / 4).min(2) as usize;
    (axis, [((axis + 1) % 3, sign(edge % 4, 0)), ((axis + 2) % 3, sign(edge % 4, 1))])
}
