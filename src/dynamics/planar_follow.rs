//! A contact in the plane carried along by its bodies, and how thick outlines are.

use super::collide::{cross, dot, sub};
use super::contact::Contact;
use super::planar::{Kind, Piece, PlanarOutlines, pieces, rows};
use crate::answer::Feature;
use crate::model::{Planar, PlanarShape};

/// The same pair of features after the bodies moved from the poses `from`, where `contact` was found, to `to`.
///
/// Edges count as whole lines. Two vertices, or a disc at a concave corner, keep the normal that they had.
pub(super) fn follow(
    outlines: &PlanarOutlines,
    contact: &Contact<Planar>,
    from: &[[f64; 3]],
    to: &[[f64; 3]],
) -> Contact<Planar> {
    let name = contact.name;
    let other = outlines.own.get(name.other).or_else(|| outlines.fixed.get(name.other - outlines.own.len()));
    let [a, b] = [(outlines.own.get(name.body), name.feature), (other, name.other_feature)]
        .map(|(pieces, feature)| side(pieces.map_or(&[], Vec::as_slice), feature));
    let [moved, other_moved] = [name.body, name.other].map(|body| Motion::new(from.get(body), to.get(body)));
    let (n, gap) = (contact.normal, contact.gap);
    // a contact lies on the vertex, on the polygon that a disc meets, on the disc that a polygon meets
    let is_on_body = match (name.feature, b) {
        (Feature::Vertex(_), side) => !matches!(side, Side::Disc(_)),
        (Feature::Surface(_), Side::Line) => !matches!(name.other_feature, Feature::Edge(_)),
        _ => false,
    };
    let on_body = if is_on_body { contact.point } else { along(contact.point, gap, n) };
    let on_other = if is_on_body { along(contact.point, -gap, n) } else { contact.point };
    let (normal, gap, on_body, on_other) = match (a, b) {
        (Side::Line, _) => {
            let (radius, normal) = (b.radius(), moved.turned(n));
            let center = other_moved.carried(along(on_other, -radius, n));
            let gap = dot(normal, sub(moved.carried(on_body), center)) - radius;
            let on_other = along(center, radius, normal);
            (normal, gap, along(on_other, gap, normal), on_other)
        }
        (_, Side::Line) => {
            let (radius, normal) = (a.radius(), other_moved.turned(n));
            let center = moved.carried(along(on_body, radius, n));
            let gap = dot(normal, sub(center, other_moved.carried(on_other))) - radius;
            let on_body = along(center, -radius, normal);
            (normal, gap, on_body, along(on_body, -gap, normal))
        }
        _ => {
            let (radius, other_radius) = (a.radius(), b.radius());
            let (start, other_start) = (along(on_body, radius, n), along(on_other, -other_radius, n));
            let (center, other_center) = (moved.carried(start), other_moved.carried(other_start));
            let away = sub(center, other_center);
            let distance = dot(away, away).sqrt();
            let is_round = radius + other_radius > 0.0 && gap + radius + other_radius > 0.0 && distance > 0.0;
            let (normal, gap) = if is_round {
                ([away[0] / distance, away[1] / distance], distance - radius - other_radius)
            } else {
                (n, gap + dot(n, sub(sub(center, start), sub(other_center, other_start))))
            };
            let on_other = along(other_center, other_radius, normal);
            (normal, gap, along(center, -radius, normal), on_other)
        }
    };
    let point = if is_on_body { on_body } else { on_other };
    Contact {
        gap,
        point,
        normal,
        rows: rows(point, normal, &to[name.body], 1.0),
        other_rows: to.get(name.other).map(|pose| rows(point, normal, pose, -1.0)),
        ..*contact
    }
}

/// How a wrench on a body times a velocity changes as the body turns, its point of action with it; a row.
///
/// ∂(r × f)/∂θ = -(r · f).
pub(super) fn swing(point: &[f64; 2], pose: &[f64; 3], wrench: &[f64; 3], velocity: &[f64; 3]) -> [f64; 3] {
    let r = [point[0] - pose[0], point[1] - pose[1]];
    [0.0, 0.0, -dot(r, [wrench[0], wrench[1]]) * velocity[2]]
}

/// Half the least thickness, seen straight in from the middle of an edge (m); a disc's radius.
pub(super) fn half_thickness(shape: &PlanarShape) -> f64 {
    let of_piece = |piece: &Piece| match &piece.kind {
        // a disc of radius zero stands for a point
        Kind::Disc { radius, .. } if *radius > 0.0 => *radius,
        Kind::Disc { .. } | Kind::HalfPlane { .. } => f64::INFINITY,
        Kind::Polygon(outline) => {
            let (vertices, n) = (&outline.vertices, outline.vertices.len());
            let depth = |i: usize| {
                let (a, b) = (vertices[i], vertices[(i + 1) % n]);
                let (middle, inward) = ([0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])], outline.normals[i].map(|x| -x));
                let hits = (0..n).filter(|j| *j != i).filter_map(|j| {
                    let (c, edge) = (sub(vertices[j], middle), sub(vertices[(j + 1) % n], vertices[j]));
                    let across = cross(inward, edge);
                    let (far, at) = (cross(c, edge) / across, cross(c, inward) / across);
                    (far > 0.0 && (0.0..=1.0).contains(&at)).then_some(far)
                });
                hits.fold(f64::INFINITY, f64::min)
            };
            0.5 * (0..n).map(depth).fold(f64::INFINITY, f64::min)
        }
    };
    pieces(shape).iter().map(of_piece).fold(f64::INFINITY, f64::min)
}

/// What one side of a contact is.
#[derive(Debug, Clone, Copy)]
enum Side {
    Line,
    Vertex,
    Disc(f64),
}

impl Side {
    fn radius(self) -> f64 {
        if let Self::Disc(radius) = self { radius } else { 0.0 }
    }
}

fn side(pieces: &[Piece], feature: Feature) -> Side {
    match feature {
        Feature::Edge(_) => Side::Line,
        Feature::Vertex(_) => Side::Vertex,
        Feature::Surface(first) => match pieces.iter().find(|piece| piece.first == first).map(|piece| &piece.kind) {
            Some(Kind::Disc { radius, .. }) => Side::Disc(*radius),
            _ => Side::Line,
        },
    }
}

fn along(point: [f64; 2], by: f64, n: [f64; 2]) -> [f64; 2] {
    [point[0] + by * n[0], point[1] + by * n[1]]
}

/// How a body moved; an obstacle does not.
struct Motion {
    from: [f64; 2],
    to: [f64; 2],
    sine: f64,
    cosine: f64,
}

impl Motion {
    fn new(from: Option<&[f64; 3]>, to: Option<&[f64; 3]>) -> Self {
        let ([x, y, angle], [to_x, to_y, to_angle]) =
            (from.copied().unwrap_or_default(), to.copied().unwrap_or_default());
        let (sine, cosine) = if to_angle == angle { (0.0, 1.0) } else { libm::sincos(to_angle - angle) };
        Self { from: [x, y], to: [to_x, to_y], sine, cosine }
    }

    fn turned(&self, d: [f64; 2]) -> [f64; 2] {
        [self.cosine * d[0] - self.sine * d[1], self.sine * d[0] + self.cosine * d[1]]
    }

    fn carried(&self, point: [f64; 2]) -> [f64; 2] {
        let turned = self.turned(sub(point, self.from));
        [self.to[0] + turned[0], self.to[1] + turned[1]]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::Mechanics;
    use crate::model::{Body, Material, Obstacle, Restitution, World};

    fn scene() -> World<Planar> {
        let body = |shape, pose| Body {
            name: String::new(),
            shape,
            mass: 1.0,
            inertia: [1.0],
            pose,
            velocity: [0.0; 3],
            is_kinematic: false,
            schedule: Vec::new(),
            finger: None,
        };
        let square = PlanarShape::Polygon(vec![[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]]);
        let disc = PlanarShape::Circle { center: [0.1, 0.0], radius: 0.3 };
        let bar = PlanarShape::Polygon(vec![[-2.0, -0.2], [2.0, -0.2], [2.0, 0.2], [-2.0, 0.2]]);
        let ground = PlanarShape::HalfPlane { point: [0.0, -0.2], normal: [0.0, 1.0] };
        let material = Material { friction: 0.5, restitution: Restitution::Newton(0.0), compliance: None };
        let bodies = vec![
            body(bar, [0.0, 0.0, 0.01]),
            body(square, [-1.0, 0.71, 0.02]),
            body(disc.clone(), [0.5, 0.48, 0.3]),
            body(disc, [1.02, 0.6, 0.2]),
        ];
        let obstacle = |shape| Obstacle { name: String::new(), shape, surface_velocity: [0.0; 2] };
        let post = PlanarShape::Circle { center: [-1.0, 1.35], radius: 0.13 };
        World {
            gravity: [0.0, -9.81],
            duration: 1.0,
            step: None,
            margin: None,
            directions: 2,
            materials: vec![material; bodies.len() * (bodies.len() + 2)],
            bodies,
            fixed: vec![obstacle(ground), obstacle(post)],
        }
    }

    /// Contacts carried along are the contacts found where the bodies have come to.
    #[test]
    fn following_is_finding_again() {
        let world = scene();
        let mut outlines = Planar::outlines(&world);
        let from: Vec<[f64; 3]> = world.bodies.iter().map(|body| body.pose).collect();
        let (mut before, mut after, mut compared) = (Vec::new(), Vec::new(), 0);
        Planar::contacts(&mut outlines, &world, &from, 0.1, &mut before);
        for round in 0..20 {
            let shift = |body: usize, i: usize| 1e-3 * libm::sin((1 + round * 12 + body * 3 + i) as f64 * 1.7);
            let to: Vec<[f64; 3]> =
                from.iter().enumerate().map(|(b, pose)| std::array::from_fn(|i| pose[i] + shift(b, i))).collect();
            Planar::contacts(&mut outlines, &world, &to, 0.1, &mut after);
            for contact in &before {
                let found = after.iter().find(|found| found.name == contact.name).expect("it moved by little");
                let carried = follow(&outlines, contact, &from, &to);
                compared += 1;
                let close = |a: f64, b: f64| (a - b).abs() < 1e-12;
                assert!(close(carried.gap, found.gap), "{:?}: {} for {}", contact.name, carried.gap, found.gap);
                for (carried, found) in carried.rows.iter().flatten().zip(found.rows.iter().flatten()) {
                    assert!(close(*carried, *found), "{:?}: {carried} for {found}", contact.name);
                }
                let rows = [carried.other_rows, found.other_rows].map(Option::unwrap_or_default);
                assert!(rows[0].iter().flatten().zip(rows[1].iter().flatten()).all(|(a, b)| close(*a, *b)));
            }
        }
        assert!(compared >= 20 * 7, "only {compared} contacts");
    }

    /// Thickness is seen straight in from the edges, also of an outline with many.
    #[test]
    fn thickness_of_outlines() {
        let around = |i: u32| libm::sincos(f64::from(i) / 32.0 * std::f64::consts::TAU);
        let round = PlanarShape::Polygon((0..32).map(around).map(|(sine, cosine)| [cosine, sine]).collect());
        assert!((half_thickness(&round) - 1.0).abs() < 0.01);
        let corner = [[0.0, 0.0], [3.0, 0.0], [3.0, 0.2], [0.5, 0.2], [0.5, 3.0], [0.0, 3.0]];
        assert_eq!(half_thickness(&PlanarShape::Polygon(corner.into())), 0.1);
        assert_eq!(half_thickness(&PlanarShape::Circle { center: [0.0; 2], radius: 0.3 }), 0.3);
        let ground = PlanarShape::HalfPlane { point: [0.0; 2], normal: [0.0, 1.0] };
        assert_eq!(half_thickness(&ground), f64::INFINITY);
    }
}
