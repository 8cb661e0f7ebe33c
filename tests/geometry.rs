//! Exact geometry: textbook figures, invariance, and brute force on small polygons.

use partplan::exact::{Q, Z, ratio, to_f64};
use partplan::geometry::{Location, Polygon, PolygonFault, direction_of_degrees};
use proptest::prelude::*;
use std::cmp::Ordering::{Greater, Less};

fn points(list: &[[i64; 2]]) -> Vec<[Q; 2]> {
    list.iter().map(|p| p.map(|x| ratio(x, 1))).collect()
}

fn polygon(list: &[[i64; 2]]) -> Polygon {
    Polygon::new(points(list)).unwrap()
}

fn faults(list: &[[i64; 2]]) -> Vec<PolygonFault> {
    Polygon::new(points(list)).unwrap_err()
}

/// An L with its reflex corner at vertex 3.
const ELL: [[i64; 2]; 6] = [[0, 0], [6, 0], [6, 2], [2, 2], [2, 5], [0, 5]];

#[test]
fn moments_of_textbook_figures() {
    let square = polygon(&[[0, 0], [6, 0], [6, 6], [0, 6]]).moments();
    assert_eq!((square.area, square.polar), (ratio(36, 1), ratio(6 * 6 * 6 * 6, 6)));
    let triangle = polygon(&[[0, 0], [3, 0], [0, 4]]).moments();
    assert_eq!(triangle.centroid, [ratio(1, 1), ratio(4, 3)]);
    // area (a² + b² + c²) / 36
    assert_eq!(triangle.polar, ratio(6 * (9 + 16 + 25), 36));
    // the L is a 6 by 2 and a 2 by 3 rectangle, joined by Steiner's theorem
    let ell = polygon(&ELL).moments();
    assert_eq!(ell.centroid, [ratio(12 * 3 + 6, 18), ratio(12 * 2 + 6 * 7, 36)]);
    let part = |area: i64, w: i64, h: i64, x: Q, y: Q| {
        let offset = [x - &ell.centroid[0], y - &ell.centroid[1]];
        ratio(area, 1) * (ratio(w * w + h * h, 12) + &offset[0] * &offset[0] + &offset[1] * &offset[1])
    };
    let expected = part(12, 6, 2, ratio(3, 1), ratio(1, 1)) + part(6, 2, 3, ratio(1, 1), ratio(7, 2));
    assert_eq!(ell.polar, expected);
}

#[test]
fn collinear_vertices_are_allowed_and_are_no_hull_corners() {
    let square = polygon(&[[2, 0], [4, 0], [4, 4], [0, 4], [0, 2], [0, 0]]);
    assert_eq!(square.hull(), [1, 2, 3, 5]);
    assert_eq!(polygon(&ELL).hull(), [0, 1, 2, 4, 5]);
}

#[test]
fn the_hull_contains_its_interior_only() {
    let ell = polygon(&ELL);
    // between the arms of the L, on the hull's slanted edge from (6, 2) to (2, 5), and beyond it
    assert!(ell.hull_contains(&[ratio(3, 1), ratio(3, 1)]));
    assert!(!ell.hull_contains(&[ratio(4, 1), ratio(7, 2)]));
    assert!(!ell.hull_contains(&[ratio(5, 1), ratio(4, 1)]));
    assert!(!ell.hull_contains(&[ratio(0, 1), ratio(0, 1)]));
}

#[test]
fn points_of_the_outline_are_located() {
    let ell = polygon(&ELL);
    assert_eq!(ell.locate(&[ratio(2, 1), ratio(2, 1)]), Some(Location::Vertex(3)));
    assert_eq!(ell.locate(&[ratio(2, 1), ratio(3, 1)]), Some(Location::Edge { edge: 3, s: ratio(1, 3) }));
    assert_eq!(ell.locate(&[ratio(2, 1), ratio(1, 1)]), None);
    assert_eq!(ell.locate(&[ratio(2, 1), ratio(6, 1)]), None);
}

#[test]
fn the_nearest_point_is_a_foot_or_a_vertex() {
    let triangle = polygon(&[[0, 0], [3, 0], [0, 4]]);
    let (location, point, distance2) = triangle.nearest(&[ratio(3, 1), ratio(4, 1)]);
    // the altitude on the hypotenuse is 12/5
    assert_eq!(distance2, ratio(144, 25));
    assert_eq!(point, [ratio(27, 25), ratio(64, 25)]);
    assert_eq!(location, Location::Edge { edge: 1, s: ratio(16, 25) });
    let (location, _, distance2) = triangle.nearest(&[ratio(-1, 1), ratio(-1, 1)]);
    assert_eq!((location, distance2), (Location::Vertex(0), ratio(2, 1)));
}

#[test]
fn inward_normals_are_coprime_and_point_left_of_the_edge() {
    let pawl = polygon(&[[0, 0], [9, -2], [12, 0], [11, 3]]);
    assert_eq!(pawl.inward_normal(0), [ratio(2, 1), ratio(9, 1)]);
    assert_eq!(pawl.inward_normal(1), [ratio(-2, 1), ratio(3, 1)]);
    let thirds = Polygon::new(vec![[ratio(0, 1), ratio(0, 1)], [ratio(2, 3), ratio(1, 3)], [ratio(0, 1), ratio(1, 1)]]);
    assert_eq!(thirds.unwrap().inward_normal(0), [ratio(-1, 1), ratio(2, 1)]);
}

#[test]
fn each_fault_names_the_vertices_and_edges_of_the_list() {
    assert_eq!(faults(&[[0, 0], [1, 0]]), [PolygonFault::TooFewVertices { vertices: 2 }]);
    assert_eq!(faults(&[[0, 0], [2, 0], [1, 0]]), [PolygonFault::ZeroArea]);
    assert_eq!(faults(&[[0, 0], [2, 0], [0, 2], [0, 0]]), [PolygonFault::RepeatedVertex { first: 0, second: 3 }]);
    assert_eq!(faults(&[[0, 0], [4, 0], [4, 6], [4, 4], [0, 4]]), [PolygonFault::Spike { vertex: 2 }]);
    let bow = [[0, 0], [3, 3], [3, 0], [0, 3]];
    let at = [ratio(3, 2), ratio(3, 2)];
    assert_eq!(faults(&bow), [PolygonFault::Crossing { first: 0, second: 2, at }]);
    // two edges along one line that overlap
    let overlap = faults(&[[0, 0], [4, 0], [4, 2], [6, 2], [6, 0], [2, 0], [2, -2], [0, -2]]);
    assert!(overlap.iter().any(|fault| matches!(fault, PolygonFault::Crossing { first: 0, second: 4, .. })));
}

#[test]
fn a_list_of_many_crossings_is_reported_up_to_a_limit() {
    let star: Vec<[i64; 2]> = (0..199).map(|i| [(i * 37) % 199, (i * i) % 199]).collect();
    assert_eq!(faults(&star).len(), partplan::geometry::MAX_REPORTED_FAULTS);
}

#[test]
fn ten_thousand_vertices_are_checked_exactly() {
    let comb: Vec<[i64; 2]> =
        (0..9_998).map(|i| [i, 1_000_000 * (i % 2)]).chain([[10_000, 2_000_000], [-1, 2_000_000]]).collect();
    assert_eq!(polygon(&comb).n_edges(), 10_000);
    let mut broken = comb;
    broken[5_000][1] = -1;
    broken[9_999] = [-1, 0];
    broken[9_998] = [10_000, 0];
    // the last edge now runs along y = 0 through the teeth
    assert_eq!(faults(&broken).len(), partplan::geometry::MAX_REPORTED_FAULTS);
}

/// Coordinates that differ by one part in 10^40 are told apart although no machine number can.
#[test]
fn tiny_gaps_and_tiny_overlaps_are_decided_exactly() {
    let tiny = partplan::exact::parse_literal("1e-40").unwrap();
    let notch = |tip: Q| {
        let mut list = points(&[[0, 0], [4, 0], [4, 4], [2, 0], [0, 4]]);
        list[3][1] = tip;
        Polygon::new(list)
    };
    assert!(notch(tiny.clone()).is_ok());
    assert_eq!(notch(ratio(0, 1)).unwrap_err().len(), 2);
    let crossed = notch(-tiny).unwrap_err();
    assert_eq!(crossed.len(), 2);
    assert!(crossed.iter().all(|fault| matches!(fault, PolygonFault::Crossing { first: 0, .. })));
}

/// A star-shaped polygon about the origin with distinct directions is simple.
fn star_shaped() -> impl Strategy<Value = Vec<[Q; 2]>> {
    proptest::collection::vec((1_i64..40, 1_i64..6), 8).prop_map(|radii| {
        let directions = [[2, 0], [2, 2], [0, 2], [-2, 2], [-2, 0], [-2, -2], [0, -2], [2, -2]];
        let stretch = |(direction, (n, d)): ([i64; 2], (i64, i64))| direction.map(|x| ratio(x * n, d));
        directions.into_iter().zip(radii).map(stretch).collect()
    })
}

fn sub(a: &[Q; 2], b: &[Q; 2]) -> [Q; 2] {
    [&a[0] - &b[0], &a[1] - &b[1]]
}

fn cross(a: &[Q; 2], b: &[Q; 2]) -> Q {
    &a[0] * &b[1] - &a[1] * &b[0]
}

fn dot(a: &[Q; 2], b: &[Q; 2]) -> Q {
    &a[0] * &b[0] + &a[1] * &b[1]
}

/// Whether two segments share a point, by solving for it.
fn share_a_point(a: &[Q; 2], b: &[Q; 2], c: &[Q; 2], d: &[Q; 2]) -> bool {
    let (zero, one) = (ratio(0, 1), ratio(1, 1));
    let (ab, cd, ac) = (sub(b, a), sub(d, c), sub(c, a));
    let unit = zero.clone()..=one.clone();
    let determinant = cross(&ab, &cd);
    if determinant != zero {
        return unit.contains(&(cross(&ac, &cd) / &determinant)) && unit.contains(&(cross(&ac, &ab) / &determinant));
    }
    if cross(&ab, &ac) != zero {
        return false;
    }
    let along = |p: &[Q; 2]| dot(&sub(p, a), &ab) / dot(&ab, &ab);
    let (s, t) = (along(c), along(d));
    s.clone().min(t.clone()) <= one && s.max(t) >= zero
}

fn is_simple(list: &[[Q; 2]]) -> bool {
    let n = list.len();
    let at = |i: usize| &list[i % n];
    (0..n).all(|i| {
        let (before, after) = (sub(at(i + n - 1), at(i)), sub(at(i + 1), at(i)));
        at(i) != at(i + 1) && !(cross(&before, &after) == ratio(0, 1) && dot(&before, &after) > ratio(0, 1))
    }) && (0..n)
        .all(|i| (i + 2..n).all(|j| (i == 0 && j == n - 1) || !share_a_point(at(i), at(i + 1), at(j), at(j + 1))))
}

/// cos 60 = 1/2, and sin² 60 = 3/4, in all four quadrants.
#[test]
fn directions_hold_the_exact_cosine_and_sine() {
    for (degrees, is_opposite) in
        [(60, [false, false]), (120, [true, false]), (-120, [true, true]), (660, [false, true])]
    {
        let bounds = direction_of_degrees(&ratio(degrees, 1), 128);
        let [cosine, sine] = [0, 1].map(|k: usize| {
            let [low, high] = bounds[k].clone();
            if is_opposite[k] { [-high, -low] } else { [low, high] }
        });
        assert!(cosine[0] < ratio(1, 2) && ratio(1, 2) < cosine[1]);
        assert!(&sine[0] * &sine[0] < ratio(3, 4) && ratio(3, 4) < &sine[1] * &sine[1]);
    }
}

proptest! {
    /// Bounds are as close as their places allow, hold what doubles say, and 1 = cos² + sin².
    #[test]
    fn directions_are_enclosed_closely(thousandths in -800_000..800_000_i64, bits in 64..400_usize) {
        let degrees = ratio(thousandths, 1_000);
        let bounds = direction_of_degrees(&degrees, bits);
        let (sine, cosine) = to_f64(&degrees).to_radians().sin_cos();
        let (mut least, mut most) = (ratio(0, 1), ratio(0, 1));
        for ([low, high], near) in bounds.iter().zip([cosine, sine]) {
            prop_assert!(low <= high && (high - low) * Q::from(Z::from(1) << (bits - 12)) <= ratio(1, 1));
            prop_assert!((to_f64(low) - near).abs() < 1e-14);
            let squares = [low * low, high * high];
            least += squares.iter().min().unwrap();
            most += squares.iter().max().unwrap();
        }
        prop_assert!(least <= ratio(1, 1) && ratio(1, 1) <= most);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn the_sweep_agrees_with_brute_force(list in proptest::collection::vec([0_i64..7, 0_i64..7], 3..9)) {
        let list = points(&list);
        prop_assert_eq!(Polygon::new(list.clone()).is_ok(), is_simple(&list));
    }

    /// Beyond 64 bits the same answers come from ranks, doubtful turns from rationals.
    #[test]
    fn the_answer_does_not_depend_on_the_scale(list in proptest::collection::vec([0_i64..6, 0_i64..6], 3..8), shift in any::<bool>()) {
        let (list, huge) = (points(&list), ratio(i64::MAX, 1));
        let offset = if shift { &huge * &huge } else { ratio(0, 1) };
        let scaled: Vec<[Q; 2]> = list.iter().map(|p| [&p[0] * &huge + &offset, &p[1] * &huge / ratio(3, 1)]).collect();
        let normalised = |faults: Vec<PolygonFault>| {
            let no_point = |fault| match fault {
                PolygonFault::Crossing { first, second, .. } => (first, second),
                PolygonFault::RepeatedVertex { first, second } => (first + 100, second),
                PolygonFault::Spike { vertex } => (200, vertex),
                _ => (300, 300),
            };
            faults.into_iter().map(no_point).collect::<Vec<_>>()
        };
        let (small, large) = (Polygon::new(list), Polygon::new(scaled));
        prop_assert_eq!(small.map(|p| p.hull()).map_err(normalised), large.map(|p| p.hull()).map_err(normalised));
    }

    #[test]
    fn both_windings_are_one_polygon(list in star_shaped()) {
        let mut reversed = list.clone();
        reversed[1..].reverse();
        prop_assert_eq!(Polygon::new(list).unwrap(), Polygon::new(reversed).unwrap());
    }

    #[test]
    fn moments_move_and_scale_with_the_polygon(list in star_shaped(), dx in -50_i64..50, dy in -50_i64..50, k in 1_i64..9) {
        let before = Polygon::new(list.clone()).unwrap().moments();
        let (scale, shift) = (ratio(k, 3), [ratio(dx, 7), ratio(dy, 2)]);
        let image = |p: &[Q; 2]| [&p[0] * &scale + &shift[0], &p[1] * &scale + &shift[1]];
        let after = Polygon::new(list.iter().map(image).collect()).unwrap().moments();
        let square = &scale * &scale;
        prop_assert_eq!(after.area, &before.area * &square);
        prop_assert_eq!(after.centroid, image(&before.centroid));
        prop_assert_eq!(after.polar, before.polar * &square * &square);
    }

    /// Moments add up over the triangles from the origin, which lies inside.
    #[test]
    fn moments_are_the_sum_over_triangles(list in star_shaped()) {
        let whole = Polygon::new(list.clone()).unwrap().moments();
        let origin = [ratio(0, 1), ratio(0, 1)];
        let (mut area, mut polar) = (ratio(0, 1), ratio(0, 1));
        for i in 0..list.len() {
            let piece = Polygon::new(vec![origin.clone(), list[i].clone(), list[(i + 1) % list.len()].clone()]).unwrap().moments();
            let offset = sub(&piece.centroid, &whole.centroid);
            polar += piece.polar + &piece.area * dot(&offset, &offset);
            area += piece.area;
        }
        prop_assert_eq!((whole.area, whole.polar), (area, polar));
    }

    /// A hull corner is a vertex that lies strictly to one side of some line through it; here by all triangles.
    #[test]
    fn the_hull_is_what_no_triangle_of_vertices_contains(list in star_shaped()) {
        let polygon = Polygon::new(list).unwrap();
        let all = polygon.vertices();
        let is_covered = |p: usize| {
            let inside = |a: usize, b: usize, c: usize| {
                let turn = |u: usize, v: usize| cross(&sub(&all[v], &all[u]), &sub(&all[p], &all[u]));
                let turns = [turn(a, b), turn(b, c), turn(c, a)];
                let has = |order: std::cmp::Ordering| turns.iter().any(|t| t.cmp(&ratio(0, 1)) == order);
                has(Less) != has(Greater)
            };
            let others: Vec<usize> = (0..all.len()).filter(|i| *i != p).collect();
            let pairs = |a: usize, b: usize| others[b + 1..].iter().any(|c| inside(others[a], others[b], *c));
            (0..others.len()).any(|a| (a + 1..others.len()).any(|b| pairs(a, b)))
        };
        let corners: Vec<usize> = (0..all.len()).filter(|p| !is_covered(*p)).collect();
        prop_assert_eq!(polygon.hull(), corners);
    }

    /// A point of the outline is found where it was made, and is its own nearest point.
    #[test]
    fn locations_round_trip(list in star_shaped(), edge in 0_usize..8, n in 0_i64..=12) {
        let polygon = Polygon::new(list).unwrap();
        let location = polygon.location(edge, ratio(n, 12));
        let point = polygon.point(&location);
        prop_assert_eq!(polygon.locate(&point), Some(location));
        prop_assert_eq!(polygon.nearest(&point).2, ratio(0, 1));
    }

    /// The nearest point is on the outline, and no sampled point of the outline is nearer.
    #[test]
    fn no_point_of_the_outline_is_nearer_than_the_nearest(list in star_shaped(), x in -90_i64..90, y in -90_i64..90) {
        let polygon = Polygon::new(list).unwrap();
        let point = [ratio(x, 2), ratio(y, 2)];
        let (location, nearest, distance2) = polygon.nearest(&point);
        prop_assert_eq!(polygon.locate(&nearest), Some(location));
        let gap = sub(&nearest, &point);
        prop_assert_eq!(dot(&gap, &gap), distance2.clone());
        for edge in 0..polygon.n_edges() {
            for n in 0..8 {
                let gap = sub(&polygon.point(&polygon.location(edge, ratio(n, 8))), &point);
                prop_assert!(dot(&gap, &gap) >= distance2);
            }
        }
    }

    /// Inward normals are perpendicular to their edges and point to the left.
    #[test]
    fn normals_point_inward(list in star_shaped(), edge in 0_usize..8) {
        let polygon = Polygon::new(list).unwrap();
        let [a, b] = polygon.edge(edge);
        let (along, normal) = (sub(b, a), polygon.inward_normal(edge));
        prop_assert_eq!(dot(&along, &normal), ratio(0, 1));
        prop_assert!(cross(&along, &normal) > ratio(0, 1));
        prop_assert!(normal.iter().all(Q::is_integer));
    }

    /// A combination of the two normals is admitted, its opposite is not.
    #[test]
    fn combinations_of_the_adjacent_normals_are_admitted(list in star_shaped(), vertex in 0_usize..8, p in 0_i64..5, q in 1_i64..5) {
        let polygon = Polygon::new(list).unwrap();
        let [before, after] = polygon.normals_at(vertex);
        let mix = |s: i64| [0, 1].map(|axis| (&before[axis] * ratio(p, 1) + &after[axis] * ratio(q, 1)) * ratio(s, 1));
        prop_assert!(polygon.admits_normal(vertex, &mix(1)));
        prop_assert!(!polygon.admits_normal(vertex, &mix(-1)));
    }
}
