//! Gaps and normals of boxes against distances by brute force.

use crate::space_made::{block, leaned, moved, world};
use partplan::answer::{ContactName, Feature};
use partplan::dynamics::Mechanics as _;
use partplan::model::{Spatial, World};
use proptest::prelude::*;

type Vector = [f64; 3];

/// A contact without its rows.
#[derive(Debug, Clone, Copy)]
struct Found {
    name: ContactName,
    gap: f64,
    normal: Vector,
}

fn contacts(scene: &World<Spatial>, poses: &[[f64; 7]], reach: f64) -> Vec<Found> {
    let mut contacts = Vec::new();
    Spatial::contacts(&mut (), scene, poses, reach, &mut contacts);
    contacts.iter().map(|contact| Found { name: contact.name, gap: contact.gap, normal: contact.normal }).collect()
}

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn minus(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn plus(a: Vector, by: f64, b: Vector) -> Vector {
    [a[0] + by * b[0], a[1] + by * b[1], a[2] + by * b[2]]
}

/// The axes of a pose by its rotation matrix, and its place.
fn frame(pose: &[f64; 7]) -> ([Vector; 3], Vector) {
    let [x, y, z, w, i, j, k] = *pose;
    let axes = [
        [1.0 - 2.0 * (j * j + k * k), 2.0 * (i * j + k * w), 2.0 * (i * k - j * w)],
        [2.0 * (i * j - k * w), 1.0 - 2.0 * (i * i + k * k), 2.0 * (j * k + i * w)],
        [2.0 * (i * k + j * w), 2.0 * (j * k - i * w), 1.0 - 2.0 * (i * i + j * j)],
    ];
    (axes, [x, y, z])
}

fn vertices(half: Vector, pose: &[f64; 7]) -> Vec<Vector> {
    let (axes, center) = frame(pose);
    let at = |signs: usize| {
        (0..3).fold(center, |p, i| plus(p, if signs >> i & 1 == 1 { half[i] } else { -half[i] }, axes[i]))
    };
    (0..8).map(at).collect()
}

/// Distance of a point from a box, 0 inside.
fn to_box(point: Vector, half: Vector, pose: &[f64; 7]) -> f64 {
    let (axes, center) = frame(pose);
    let out = (0..3).map(|i| (dot(axes[i], minus(point, center)).abs() - half[i]).max(0.0));
    out.map(|x| x * x).sum::<f64>().sqrt()
}

/// Distance of two segments: the least over their closest points, and over ends and the other segment.
fn segments([a, b]: [Vector; 2], [c, d]: [Vector; 2]) -> f64 {
    let (u, v, w) = (minus(b, a), minus(d, c), minus(a, c));
    let to_segment = |p: Vector, from: Vector, along: Vector| {
        let t = (dot(minus(p, from), along) / dot(along, along)).clamp(0.0, 1.0);
        let away = minus(p, plus(from, t, along));
        dot(away, away).sqrt()
    };
    let ends = [to_segment(a, c, v), to_segment(b, c, v), to_segment(c, a, u), to_segment(d, a, u)];
    let least = ends.into_iter().fold(f64::INFINITY, f64::min);
    let (uu, uv, vv) = (dot(u, u), dot(u, v), dot(v, v));
    let determinant = uu * vv - uv * uv;
    let (s, t) = ((uv * dot(v, w) - vv * dot(u, w)) / determinant, (uu * dot(v, w) - uv * dot(u, w)) / determinant);
    if determinant > 1e-12 * uu * vv && (0.0..=1.0).contains(&s) && (0.0..=1.0).contains(&t) {
        let away = minus(plus(a, s, u), plus(c, t, v));
        return least.min(dot(away, away).sqrt());
    }
    least
}

fn edges(vertices: &[Vector]) -> Vec<[Vector; 2]> {
    let pairs = (0..8_usize).flat_map(|i| (0..3).map(move |axis| (i, i | 1 << axis)));
    pairs.filter(|(i, j)| i != j).map(|(i, j)| [vertices[i], vertices[j]]).collect()
}

/// Distance of two boxes that do not overlap: over all vertices and boxes, all edges and edges.
fn distance(half: [Vector; 2], poses: &[[f64; 7]]) -> f64 {
    let all = [vertices(half[0], &poses[0]), vertices(half[1], &poses[1])];
    let one = all[0].iter().map(|v| to_box(*v, half[1], &poses[1]));
    let two = all[1].iter().map(|v| to_box(*v, half[0], &poses[0]));
    let least = one.chain(two).fold(f64::INFINITY, f64::min);
    let others = edges(&all[1]);
    edges(&all[0]).into_iter().flat_map(|a| others.iter().map(move |b| segments(a, *b))).fold(least, f64::min)
}

/// Least overlap along the 15 axes, by projecting all vertices; negative where an axis separates.
fn overlap(half: [Vector; 2], poses: &[[f64; 7]]) -> f64 {
    let all = [vertices(half[0], &poses[0]), vertices(half[1], &poses[1])];
    let (a, b) = (frame(&poses[0]).0, frame(&poses[1]).0);
    let cross =
        |a: Vector, b: Vector| [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    let mut axes: Vec<Vector> = a.iter().chain(&b).copied().collect();
    axes.extend(a.iter().flat_map(|a| b.iter().map(|b| cross(*a, *b))));
    let along = |axis: Vector| {
        let length = dot(axis, axis).sqrt();
        let extent = |of: &[Vector]| {
            of.iter()
                .map(|v| dot(*v, axis) / length)
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)))
        };
        let ((low, high), (other_low, other_high)) = (extent(&all[0]), extent(&all[1]));
        (length > 1e-6).then_some((high - other_low).min(other_high - low))
    };
    axes.into_iter().filter_map(along).fold(f64::INFINITY, f64::min)
}

fn direction() -> impl Strategy<Value = Vector> {
    (-1.0..1.0_f64, -1.0..1.0_f64, -1.0..1.0_f64).prop_filter_map("too short", |(x, y, z)| {
        let length = (x * x + y * y + z * z).sqrt();
        (length > 0.2).then(|| [x / length, y / length, z / length])
    })
}

/// Two boxes, turned anyhow or nearly alike, about `target` apart as seen along some direction.
fn pair() -> impl Strategy<Value = ([Vector; 2], [[f64; 7]; 2])> {
    let half = || [0.1..0.5_f64, 0.1..0.5_f64, 0.1..0.5_f64];
    let turn = || prop_oneof![3 => 0.0..3.0_f64, 1 => Just(0.0), 1 => 0.0..1e-3_f64];
    let turned = || (direction(), turn());
    (half(), half(), turned(), turned(), direction(), -0.03..0.1_f64).prop_map(|(a, b, one, two, away, target)| {
        let half = [a, b];
        let at = |far: f64| {
            [leaned(one.0, one.1, [0.0; 3]), leaned(two.0, two.1, [far * away[0], far * away[1], far * away[2]])]
        };
        let (mut low, mut high) = (0.0, 3.0);
        for _ in 0..40 {
            let middle = 0.5 * (low + high);
            if -overlap(half, &at(middle)) < target { low = middle } else { high = middle }
        }
        (half, at(high))
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    /// The least gap is the distance, and along its normal the boxes come apart; overlaps are seen as deep as they are.
    #[test]
    fn gaps_are_distances((half, poses) in pair()) {
        let scene = world(vec![block(half[0], poses[0]), block(half[1], poses[1])], Vec::new(), 1.0, 0.3);
        let found = contacts(&scene, &poses, 1.0);
        let deepest = found.iter().min_by(|a, b| a.gap.total_cmp(&b.gap));
        prop_assert!(deepest.is_some(), "no contact");
        let deepest = deepest.unwrap();
        for contact in &found {
            prop_assert!((dot(contact.normal, contact.normal) - 1.0).abs() < 1e-12);
        }
        let depth = overlap(half, &poses);
        if depth < -1e-5 {
            let expected = distance(half, &poses);
            prop_assert!((deepest.gap - expected).abs() < 1e-9, "{deepest:?} for {expected}");
            let mut nearer = poses;
            for (x, n) in nearer[0].iter_mut().zip(deepest.normal) {
                *x -= 0.5 * deepest.gap * n;
            }
            let left = distance(half, &nearer);
            prop_assert!((left - 0.5 * expected).abs() < 1e-9, "{left} left of {expected}");
        } else if depth > 1e-5 {
            prop_assert!(deepest.gap < 0.0, "{depth} deep and none of {found:?}");
            prop_assert!(deepest.gap > -4.0 * depth - 1e-6);
            let mut apart = poses;
            for contact in &found {
                prop_assert!(contact.gap > -4.0 * depth - 1e-6, "{contact:?} at {depth}");
            }
            for (x, n) in apart[0].iter_mut().zip(deepest.normal) {
                *x -= deepest.gap * n;
            }
            let left = overlap(half, &apart);
            prop_assert!(left < 0.5 * depth + 1e-6, "{left} left of {depth} {found:?}");
        }
        let mut names: Vec<_> = found.iter().map(|contact| contact.name).collect();
        names.sort_unstable();
        names.dedup();
        prop_assert_eq!(names.len(), found.len(), "a name twice");
    }

    /// A contact carried along is the contact found where the boxes have come to, as near as its features allow.
    #[test]
    fn following_is_finding_again((half, from) in pair(), by in prop::array::uniform12(-1e-4..1e-4_f64)) {
        let scene = world(vec![block(half[0], from[0]), block(half[1], from[1])], Vec::new(), 1.0, 0.3);
        let mut before = Vec::new();
        Spatial::contacts(&mut (), &scene, &from, 0.05, &mut before);
        let to: Vec<[f64; 7]> = (0..2).map(|body| {
            Spatial::advanced(&from[body], &std::array::from_fn(|i| by[6 * body + i]), 1.0)
        }).collect();
        let after = contacts(&scene, &to, 0.06);
        for contact in &before {
            let same = Spatial::follow(&(), &scene, contact, &from, &from);
            prop_assert!((same.gap - contact.gap).abs() < 1e-12 && minus(same.point, contact.point).map(f64::abs) < [1e-12; 3]);
            let carried = Spatial::follow(&(), &scene, contact, &from, &to);
            let Some(found) = after.iter().find(|found| found.name == contact.name) else { continue };
            let keeps_normal = matches!(
                (contact.name.feature, contact.name.other_feature),
                (Feature::Vertex(_), Feature::Vertex(_) | Feature::Edge(_)) | (Feature::Edge(_), Feature::Vertex(_))
            );
            let tolerance = if keeps_normal { 1e-6 / contact.gap.max(1e-3) } else { 1e-12 };
            prop_assert!((carried.gap - found.gap).abs() < tolerance, "{}: {found:?}", carried.gap);
        }
    }

    /// A ball meets a box, either way round, at the distance of its center less its radius.
    #[test]
    fn balls_meet_boxes_at_their_distance(
        (half, poses) in pair(), radius in 0.01..0.3_f64, is_ball_first in any::<bool>(), far in 0.0..0.3_f64, to in direction(),
    ) {
        let (_, center) = frame(&poses[0]);
        let reach = half[0].iter().map(|h| h * h).sum::<f64>().sqrt();
        let at = plus(center, reach + far, to);
        let round = crate::space_made::ball(radius, moved(at[0], at[1], at[2]));
        let mut bodies = vec![block(half[0], poses[0]), round];
        if is_ball_first {
            bodies.swap(0, 1);
        }
        let scene = world(bodies, Vec::new(), 1.0, 0.3);
        let places: Vec<[f64; 7]> = scene.bodies.iter().map(|body| body.pose).collect();
        let found = contacts(&scene, &places, 2.0);
        prop_assert_eq!(found.len(), 1);
        let expected = to_box(at, half[0], &poses[0]) - radius;
        prop_assert!((found[0].gap - expected).abs() < 1e-12);
        let outward = if is_ball_first { found[0].normal } else { found[0].normal.map(|x| -x) };
        let nearest = plus(at, -(expected + radius), outward);
        prop_assert!(to_box(nearest, half[0], &poses[0]) < 1e-9);
    }
}
