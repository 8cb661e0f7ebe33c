//! Random parts, fixtures, modes and wrenches with small rational numbers, degenerate ones often.

use super::modes::Contacts;
use super::{Wrench, cross, dot, int};
use num_traits::{One, Signed, Zero};
use partplan::exact::{Q, ratio};
use partplan::geometry::Polygon;
use partplan::model::{Fixel, Fixture, Friction, LengthUnit, Part, Place, Range, Shape};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::select;
use proptest::test_runner::FileFailurePersistence;

pub type Setup = (Part, Fixture);

/// `cases` runs unless the environment says otherwise.
pub fn runs(cases: u32) -> ProptestConfig {
    runs_of("proptest-regressions/properties.txt", cases)
}

/// The same, for tests whose failures are kept in `file`.
pub fn runs_of(file: &'static str, cases: u32) -> ProptestConfig {
    let asked = std::env::var_os("PROPTEST_CASES").is_some();
    let default = ProptestConfig::default();
    let cases = if asked { default.cases } else { cases };
    ProptestConfig {
        cases,
        max_global_rejects: 64 * cases.max(256),
        max_local_rejects: 256 * cases.max(256),
        max_shrink_iters: 300,
        failure_persistence: Some(Box::new(FileFailurePersistence::Direct(file))),
        ..default
    }
}

pub fn wrenches(count: usize) -> impl Strategy<Value = Vec<Wrench>> {
    let component = (-12..=12_i64, select(vec![1_i64, 1, 2, 3])).prop_map(|(p, q)| ratio(p, q));
    vec([component.clone(), component.clone(), component], count)
}

fn coefficient() -> impl Strategy<Value = Q> {
    select(vec![(0, 1), (1, 10), (1, 4), (1, 2), (3, 4), (1, 1), (2, 1)]).prop_map(|(p, q)| ratio(p, q))
}

/// One number for each coefficient, kinetic at most static.
pub fn single_friction() -> impl Strategy<Value = Friction> {
    (coefficient(), coefficient()).prop_map(|(a, b)| {
        let (kinetic, static_) = if a <= b { (a, b) } else { (b, a) };
        Friction { static_: Range::exactly(static_), kinetic: Range::exactly(kinetic) }
    })
}

/// Ranges, kinetic ends at most static ends.
pub fn any_friction() -> impl Strategy<Value = Friction> {
    let ranges = vec(coefficient(), 4).prop_map(|mut ends| {
        ends.sort();
        let [a, b, c, d] = &ends[..] else { unreachable!("four ends were drawn") };
        let range = |min: &Q, max: &Q| Range { min: min.clone(), max: max.clone() };
        Friction { static_: range(b, d), kinetic: range(a, c) }
    });
    prop_oneof![single_friction(), ranges]
}

/// `inner` widened on every side that the model allows.
pub fn widened(inner: &Friction, by: &Q) -> Friction {
    let wide = |range: &Range| Range { min: (&range.min - by).max(Q::zero()), max: &range.max + by };
    Friction { static_: wide(&inner.static_), kinetic: wide(&inner.kinetic) }
}

pub fn polygon(points: &[(i64, i64)]) -> Polygon {
    Polygon::new(points.iter().map(|(x, y)| [int(*x), int(*y)]).collect()).expect("a simple polygon")
}

/// Counter-clockwise convex hulls of a few points, and an L.
fn outlines() -> impl Strategy<Value = Polygon> {
    let hulls = vec((-6..=6_i64, -6..=6_i64), 4..8).prop_filter_map("the points are on a line", |mut points| {
        points.sort_unstable();
        points.dedup();
        let mut hull = half_hull(points.iter().copied());
        hull.pop();
        hull.extend(half_hull(points.iter().rev().copied()));
        hull.pop();
        (hull.len() >= 3).then(|| polygon(&hull))
    });
    prop_oneof![6 => hulls, 1 => Just(polygon(&[(0, 0), (6, 0), (6, 2), (2, 2), (2, 5), (0, 5)]))]
}

fn half_hull(points: impl Iterator<Item = (i64, i64)>) -> Vec<(i64, i64)> {
    let mut chain: Vec<(i64, i64)> = Vec::new();
    for (x, y) in points {
        while let [.., a, b] = chain[..] {
            if (b.0 - a.0) * (y - a.1) - (b.1 - a.1) * (x - a.0) > 0 {
                break;
            }
            chain.pop();
        }
        chain.push((x, y));
    }
    chain
}

/// Where a fixel goes on a polygon, before the polygon is known.
#[derive(Debug, Clone)]
enum Spot {
    Share(usize, Q),
    /// The foot of the common point on the edge, so that normals meet.
    Foot(usize),
    /// At a convex vertex, with weights of the two edges' normals.
    Corner(usize, i64, i64),
}

fn spots() -> impl Strategy<Value = Spot> {
    let share = (0..8_usize, 1..6_i64).prop_map(|(edge, sixths)| Spot::Share(edge, ratio(sixths, 6)));
    let corner = (0..8_usize, 0..3_i64, 1..3_i64).prop_map(|(vertex, a, b)| Spot::Corner(vertex, a, b));
    prop_oneof![4 => share, 1 => (0..8_usize).prop_map(Spot::Foot), 1 => corner]
}

fn place(polygon: &Polygon, common: &[Q; 2], spot: &Spot, friction: Friction) -> Fixel {
    let count = polygon.vertices().len();
    let along = |edge: usize| {
        let [a, b] = polygon.edge(edge);
        [&b[0] - &a[0], &b[1] - &a[1]]
    };
    let inward = |edge: usize| {
        let [x, y] = along(edge);
        [-y, x]
    };
    let on_edge = |edge: usize, s: Q| {
        let ([a, _], d) = (polygon.edge(edge), along(edge));
        let point = [&a[0] + &s * &d[0], &a[1] + &s * &d[1]];
        Fixel { place: Place::Edge { edge, s }, point, normal: inward(edge), friction: friction.clone() }
    };
    match spot {
        Spot::Share(edge, s) => on_edge(edge % count, s.clone()),
        Spot::Foot(edge) => {
            let edge = edge % count;
            let ([a, _], d) = (polygon.edge(edge), along(edge));
            let s = dot(&d, &[&common[0] - &a[0], &common[1] - &a[1]]) / dot(&d, &d);
            let is_inside = s.is_positive() && s < Q::one();
            on_edge(edge, if is_inside { s } else { ratio(1, 2) })
        }
        Spot::Corner(vertex, a, b) => {
            let vertex = vertex % count;
            let before = (vertex + count - 1) % count;
            if !cross(&along(before), &along(vertex)).is_positive() {
                return on_edge(vertex, ratio(1, 2));
            }
            let (left, right) = (inward(before), inward(vertex));
            let normal = [0, 1].map(|i| &left[i] * int(*a) + &right[i] * int(*b));
            Fixel { place: Place::Vertex { vertex }, point: polygon.vertices()[vertex].clone(), normal, friction }
        }
    }
}

fn inertias() -> impl Strategy<Value = (Q, Q)> {
    (select(vec![(1, 1), (2, 1), (1, 3)]), 1..20_i64).prop_map(|((p, q), quarters)| {
        let mass = ratio(p, q);
        (mass.clone(), mass * ratio(quarters, 4))
    })
}

fn part(shape: Shape, center_of_mass: [Q; 2], (mass, inertia): (Q, Q)) -> Part {
    Part { unit: LengthUnit::Metre, shape, center_of_mass, center_of_mass_tolerance: Q::zero(), mass, inertia }
}

/// Polygons with `fixels` fixels on edges and at corners, some on top of each other or with normals that meet.
pub fn polygons(
    fixels: std::ops::RangeInclusive<usize>,
    friction: impl Strategy<Value = Friction>,
) -> impl Strategy<Value = Setup> {
    let center = vec(1..6_i64, 16);
    (outlines(), center, inertias(), vec((spots(), friction), fixels)).prop_map(
        |(polygon, weights, inertia, fixels)| {
            let vertices = polygon.vertices();
            let sum: i64 = weights[..vertices.len()].iter().sum();
            let mean = |axis: usize| vertices.iter().zip(&weights).map(|(v, w)| &v[axis] * ratio(*w, sum)).sum();
            let center: [Q; 2] = [mean(0), mean(1)];
            let fixels = fixels.into_iter().map(|(spot, friction)| place(&polygon, &center, &spot, friction)).collect();
            (part(Shape::Polygon(polygon), center, inertia), Fixture { fixels })
        },
    )
}

/// Discs: every normal passes through the center.
pub fn discs(
    fixels: std::ops::RangeInclusive<usize>,
    friction: impl Strategy<Value = Friction>,
) -> impl Strategy<Value = Setup> {
    let off_center = select(vec![(0, 0), (0, 0), (1, 4), (-1, 2)]).prop_map(|(x, y)| [ratio(x, 3), ratio(y, 3)]);
    let turn = (-4..=4_i64, 1..4_i64).prop_map(|(p, q)| ratio(p, q));
    (off_center, inertias(), vec((turn, friction), fixels)).prop_map(|(center_of_mass, inertia, fixels)| {
        let (center, radius) = ([int(1), int(-1)], int(2));
        let fixels = fixels.into_iter().map(|(half_tangent, friction)| {
            let square = &half_tangent * &half_tangent;
            let scale = (Q::one() + &square).recip();
            let direction = [(Q::one() - &square) * &scale, int(2) * &half_tangent * &scale];
            let point = [0, 1].map(|i| &center[i] + &radius * &direction[i]);
            Fixel { place: Place::Arc, point, normal: [-&direction[0], -&direction[1]], friction }
        });
        let fixture = Fixture { fixels: fixels.collect() };
        let center_of_mass = [0, 1].map(|i| &center[i] + &center_of_mass[i]);
        (part(Shape::Circle { center, radius }, center_of_mass, inertia), fixture)
    })
}

pub fn any_setup(fixels: std::ops::RangeInclusive<usize>) -> impl Strategy<Value = Setup> {
    prop_oneof![4 => polygons(fixels.clone(), any_friction()), 1 => discs(fixels, any_friction())]
}

/// How a contact lies with regard to the first one.
#[derive(Debug, Clone, Copy)]
enum Lie {
    Free,
    /// Its normal is the first one times a factor.
    Parallel,
    /// So it is, and both are on one line.
    InLine,
    /// So it is, at one point.
    Repeated,
    /// At one point.
    Corner,
    /// Its line passes through a point of the first normal's line, the same for all.
    Concurrent,
}

/// Contacts anywhere on a part of any outline, with one coefficient each: parallel, concurrent, opposed, repeated and
/// frictionless ones often.
pub fn loose(contacts: std::ops::RangeInclusive<usize>) -> impl Strategy<Value = Setup> {
    let point = || {
        let coordinate = (-4..=4_i64, select(vec![1_i64, 1, 2, 3])).prop_map(|(p, q)| ratio(p, q));
        [coordinate.clone(), coordinate]
    };
    let normal = [-3..=3_i64, -3..=3_i64].prop_filter("a normal has a direction", |normal| normal != &[0, 0]);
    let lie = prop_oneof![
        5 => Just(Lie::Free),
        1 => Just(Lie::Parallel),
        1 => Just(Lie::InLine),
        1 => Just(Lie::Repeated),
        1 => Just(Lie::Corner),
        2 => Just(Lie::Concurrent),
    ];
    let factor = select(vec![(1, 1), (2, 1), (1, 3), (-1, 1), (-3, 2)]).prop_map(|(p, q)| ratio(p, q));
    let contact = (point(), normal.prop_map(|normal| normal.map(int)), lie, factor, coefficient());
    let inertia = (1..=6_i64, 1..=4_i64, 1..=12_i64, 1..=4_i64).prop_map(|(p, q, r, s)| (ratio(p, q), ratio(r, s)));
    (point(), inertia, prop::bool::weighted(0.1), vec(contact, contacts)).prop_map(
        |(center, inertia, smooth, drawn)| {
            let beyond = |from: &[Q; 2], along: &[Q; 2], by: &Q| [0, 1].map(|i| &from[i] + by * &along[i]);
            let (start, first) = (drawn[0].0.clone(), drawn[0].1.clone());
            let meet = beyond(&start, &first, &Q::one());
            let fixels = drawn.into_iter().enumerate().map(|(index, (free, own, lie, factor, mu))| {
                let along_first = first.each_ref().map(|entry| entry * &factor);
                let (point, normal) = match lie {
                    _ if index == 0 => (free, own),
                    Lie::Free => (free, own),
                    Lie::Parallel => (free, along_first),
                    Lie::InLine => (beyond(&meet, &first, &factor), along_first),
                    Lie::Repeated => (start.clone(), along_first),
                    Lie::Corner => (start.clone(), own),
                    Lie::Concurrent => (beyond(&meet, &own, &factor), own),
                };
                let mu = Range::exactly(if smooth { Q::zero() } else { mu });
                Fixel { place: Place::Arc, point, normal, friction: Friction { static_: mu.clone(), kinetic: mu } }
            });
            let fixture = Fixture { fixels: fixels.collect() };
            (part(Shape::Circle { center: center.clone(), radius: Q::one() }, center, inertia), fixture)
        },
    )
}

/// Three fixels of little friction that seat a rectangle or a pawl for many wrenches.
pub fn seatable() -> impl Strategy<Value = Setup> {
    let rectangle = polygon(&[(0, 0), (6, 0), (6, 4), (0, 4)]);
    let pawl = polygon(&[(0, 0), (9, -2), (12, 0), (11, 3), (8, 2), (6, 4), (3, 5), (0, 4), (-1, 2)]);
    let kinds = select(vec![(rectangle, [0, 0, 3], [int(3), int(2)]), (pawl, [1, 4, 7], [int(6), ratio(3, 2)])]);
    let end = (0..=6_i64).prop_map(|p| ratio(p, 30));
    let friction = (end.clone(), end).prop_map(|(a, b)| {
        let range = Range { min: (&a).min(&b).clone(), max: a.max(b) };
        Friction { static_: range.clone(), kinetic: range }
    });
    let shares = [1..=9_i64, 11..=19_i64, 5..=15_i64];
    (kinds, shares, vec(friction, 3), inertias()).prop_map(|((polygon, edges, center), shares, frictions, inertia)| {
        let spots = edges.into_iter().zip(shares).map(|(edge, s)| Spot::Share(edge, ratio(s, 20)));
        let fixels = spots.zip(frictions).map(|(spot, friction)| place(&polygon, &center, &spot, friction)).collect();
        (part(Shape::Polygon(polygon), center, inertia), Fixture { fixels })
    })
}

/// A square on fixels that repeat, share an edge, meet in a point, oppose each other, or touch one corner; with names.
pub fn degenerate() -> impl Strategy<Value = (&'static str, Setup)> {
    let share = |edge, sixths| Spot::Share(edge, ratio(sixths, 6));
    let kinds = vec![
        ("one fixel twice", vec![share(0, 3), share(0, 3)]),
        ("one fixel twice and another", vec![share(0, 2), share(0, 2), share(3, 4)]),
        ("two on one edge", vec![share(0, 1), share(0, 5)]),
        ("three on one edge", vec![share(0, 1), share(0, 3), share(0, 5)]),
        ("three normals through one point", vec![share(0, 3), share(1, 3), share(2, 3)]),
        ("antipodal", vec![share(0, 3), share(2, 3)]),
        ("antipodal pair and another", vec![share(0, 3), share(2, 3), share(1, 1)]),
        ("two normals at one corner", vec![Spot::Corner(0, 1, 1), Spot::Corner(0, 0, 1)]),
        ("couple", vec![share(0, 2), share(2, 2), share(1, 2), share(3, 2)]),
    ];
    (select(kinds), vec(any_friction(), 4), any::<bool>()).prop_map(|((name, spots), frictions, smooth)| {
        let square = polygon(&[(0, 0), (4, 0), (4, 4), (0, 4)]);
        let center = [int(2), ratio(3, 2)];
        let zero = Friction { static_: Range::exactly(Q::zero()), kinetic: Range::exactly(Q::zero()) };
        let friction = |f: Friction| if smooth { zero.clone() } else { f };
        let fixels = spots.iter().zip(frictions).map(|(spot, f)| place(&square, &center, spot, friction(f))).collect();
        (name, (part(Shape::Polygon(square), center, (Q::one(), int(3))), Fixture { fixels }))
    })
}

/// How to choose a mode once the contacts are known.
#[derive(Debug, Clone)]
pub struct ModeChoice {
    /// An acceleration, or two columns of J that an acceleration is to be perpendicular to.
    kind: usize,
    acceleration: [i64; 3],
    columns: [usize; 2],
    letters: Vec<usize>,
}

pub fn mode_choices(count: usize) -> impl Strategy<Value = Vec<ModeChoice>> {
    let choice =
        (0..4_usize, [-3..=3_i64, -3..=3_i64, -3..=3_i64], [0..64_usize, 0..64_usize], vec(0..7 * 12_usize, 6));
    let choice =
        choice.prop_map(|(kind, acceleration, columns, letters)| ModeChoice { kind, acceleration, columns, letters });
    vec(choice, count)
}

impl ModeChoice {
    /// A mode of seven letters: any, or one that some chosen acceleration has.
    pub fn letters(&self, contacts: &Contacts) -> String {
        let columns: Vec<&Wrench> = contacts.list.iter().flat_map(|c| [&c.normal, &c.tangent]).collect();
        let [a, b] = self.columns.map(|c| columns[c % columns.len()]);
        let straight = self.acceleration.map(int);
        let acceleration = match self.kind {
            0 => return self.letters.iter().take(contacts.list.len()).map(|pick| pick_of("saulrnm", *pick)).collect(),
            1 => straight,
            2 => perpendicular(a, &straight),
            _ => perpendicular(a, b),
        };
        let letter = |(contact, pick): (&super::modes::Contact, &usize)| {
            let side = dot(&contact.normal, &acceleration);
            let slip = dot(&contact.tangent, &acceleration);
            let possible = if side.is_positive() {
                "sssu"
            } else if side.is_negative() {
                "aaau"
            } else if slip.is_positive() {
                "lllmsu"
            } else if slip.is_negative() {
                "rrrmsu"
            } else {
                "nnnmsu"
            };
            pick_of(possible, *pick)
        };
        contacts.list.iter().zip(&self.letters).map(letter).collect()
    }
}

fn pick_of(letters: &str, pick: usize) -> char {
    letters.chars().nth(pick % letters.len()).expect("the pick is below the length")
}

/// `a x b` in space.
pub fn perpendicular(a: &Wrench, b: &Wrench) -> Wrench {
    [0, 1, 2].map(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        &a[j] * &b[k] - &a[k] * &b[j]
    })
}
