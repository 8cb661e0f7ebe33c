//! Inputs on which conversions of polyhedra are known to go wrong.

use super::draw::{System, matrix, span};
use super::naive::{forms, forms_of_normals, integers, rationals};
use partplan::cone::{Cone, Generators, HalfSpaces, Pair, complement, subtract, volume_in_box};
use partplan::exact::{Matrix, Z, ratio};

fn from_normals(dim: usize, normals: &[Vec<i64>]) -> Pair<i128> {
    Pair::from_normals(&Matrix::new(dim), &matrix(dim, normals)).unwrap()
}

fn counts(pair: &Pair<i128>) -> [usize; 4] {
    [pair.equalities(), pair.facets(), pair.lines(), pair.rays()].map(Matrix::len)
}

fn assert_there_and_back(pair: &Pair<i128>) {
    let generators = Generators { lines: pair.lines().clone(), rays: pair.rays().clone() };
    assert_eq!(&Pair::from_generators(&generators).unwrap(), pair);
    assert_eq!(&Pair::from_normals(pair.equalities(), pair.facets()).unwrap(), pair);
}

#[test]
fn no_rows_are_the_whole_space_and_no_generators_the_origin() {
    for dim in 1..=6 {
        let everything = from_normals(dim, &[]);
        assert_eq!(counts(&everything), [0, 0, dim, 0]);
        assert_eq!(everything, *Cone::everything(dim).unwrap().closure());
        let origin = Pair::from_generators(&span::<i128>(dim, &[], &[])).unwrap();
        assert_eq!(counts(&origin), [dim, 0, 0, 0]);
        assert_eq!(origin, Pair::from_generators(&span(dim, &[], &[vec![0; dim]])).unwrap());
        assert_eq!(origin, Pair::from_generators(&span(dim, &[vec![0; dim]], &[])).unwrap());
        assert_eq!(everything, from_normals(dim, &[vec![0; dim], vec![0; dim]]));
        for pair in [everything, origin] {
            assert_there_and_back(&pair);
        }
    }
}

#[test]
fn lines_alone_span_a_subspace_and_rays_alone_the_whole_space() {
    let plane = Pair::from_generators(&span::<i128>(3, &[vec![1, 2, 3], vec![0, 0, 1], vec![2, 4, 7]], &[])).unwrap();
    assert_eq!(counts(&plane), [1, 0, 2, 0]);
    assert_eq!(integers(plane.equalities()), [[2, -1, 0].map(Z::from)]);
    assert_there_and_back(&plane);
    let opposite = Pair::from_generators(&span::<i128>(3, &[], &[vec![1, 2, 3], vec![-2, -4, -6]])).unwrap();
    assert_eq!(counts(&opposite), [2, 0, 1, 0]);
    for dim in 1..=6 {
        let mut rays: Vec<Vec<i64>> = (0..dim).map(|i| (0..dim).map(|j| i64::from(i == j)).collect()).collect();
        rays.push(vec![-1; dim]);
        let everything = Pair::from_generators(&span::<i128>(dim, &[], &rays)).unwrap();
        assert_eq!(everything, from_normals(dim, &[]));
    }
}

#[test]
fn all_sets_on_a_line_are_told_apart() {
    let of = |closed: &[&[i64]], strict: &[&[i64]]| {
        Cone::<i64>::from_half_spaces(&System::new(1, &[], closed, strict).half_spaces()).unwrap()
    };
    let sets = [of(&[], &[]), of(&[&[1]], &[]), of(&[&[-1]], &[]), of(&[], &[&[1]]), of(&[], &[&[-1]])];
    let expected =
        [[true, true, true], [true, true, false], [false, true, true], [true, false, false], [false, false, true]];
    for (set, expected) in sets.iter().zip(expected) {
        let set = set.as_ref().unwrap();
        assert_eq!([-1, 0, 1].map(|x| set.contains(&[x]).unwrap()), expected);
    }
    let origin = of(&[&[1], &[-1]], &[]).unwrap();
    assert_eq!([-1, 0, 1].map(|x| origin.contains(&[x]).unwrap()), [false, true, false]);
    assert_eq!(of(&[&[1]], &[&[-1]]), None);
    assert_eq!(of(&[], &[&[1], &[-1]]), None);
}

#[test]
fn the_only_point_of_the_space_without_dimensions_is_in_it() {
    let point = Cone::<i64>::everything(0).unwrap();
    assert!(point.contains(&[]).unwrap());
    assert_eq!(Cone::from_half_spaces(&point.half_spaces().unwrap()).unwrap(), Some(point.clone()));
    assert_eq!(point.inner_point().unwrap(), Vec::<i64>::new());
    assert_eq!(point.intersection(&point).unwrap(), Some(point.clone()));
    assert_eq!(point.sum(&point).unwrap(), point);
    assert_eq!(subtract(&point, &point).unwrap(), []);
    assert_eq!(complement(0, std::slice::from_ref(&point)).unwrap(), []);
    assert_eq!(point.closure().faces().unwrap(), [[0_usize; 0]]);
}

/// Rows that flatten the cone, one after the other, with rows between them that do not.
#[test]
fn equalities_that_appear_late_are_found() {
    let cases: [&[&[i64]]; 6] = [
        &[&[1, 0, 0], &[0, 1, 0], &[0, 0, 1], &[-1, 0, 0], &[0, -1, 1], &[0, 1, -2]],
        &[&[1, 0, 0], &[0, 1, 0], &[0, 0, 1], &[-1, -1, -1]],
        &[&[1, 0, 0], &[0, 1, 0], &[-1, -1, 0], &[0, 0, 1]],
        &[&[1, 0, 0, 0], &[0, 1, 0, 0], &[0, 0, 1, 0], &[0, 0, 0, 1], &[1, 1, -1, 0], &[-1, -1, 0, 0], &[0, 0, 1, -3]],
        &[&[1, 0, 0, 0], &[0, 1, 0, 0], &[0, 0, 1, 0], &[0, 0, 0, 1], &[0, 0, -1, 0], &[0, -1, 0, 0], &[-1, 0, 0, 0]],
        &[&[1, 1, 0, 0], &[-1, 1, 0, 0], &[0, -1, 1, 0], &[0, -1, -1, 0], &[0, 0, 0, 1], &[0, 0, 1, 0]],
    ];
    for rows in cases {
        let normals: Vec<Vec<i64>> = rows.iter().map(|row| row.to_vec()).collect();
        let dim = normals[0].len();
        let pair = from_normals(dim, &normals);
        assert!(pair.dim() < dim);
        assert_eq!(forms(&pair), forms_of_normals(dim, &[], &rationals(&normals)));
        assert_there_and_back(&pair);
    }
}

/// Points on the curve `(t, t^2, .., t^degree)`, homogenised: all are extreme and all small sets of them span faces.
fn curve(count: i64, degree: u32) -> Vec<Vec<i64>> {
    (0..count).map(|i| i - count / 2).map(|t| (0..=degree).map(|power| t.pow(power)).collect()).collect()
}

/// Sets of more than 64 and more than 128 rays and facets, clipped, and by general double description.
#[test]
fn wide_incidences_are_as_right_as_narrow_ones() {
    for count in [63_usize, 64, 65, 127, 128, 129] {
        let polygon = Pair::from_generators(&span::<i128>(3, &[], &curve(count as i64, 2))).unwrap();
        assert_eq!(counts(&polygon), [0, count, 0, count]);
        assert_eq!(polygon.faces().unwrap().len(), 2 * count + 2);
        assert_there_and_back(&polygon);
    }
    for count in [40_usize, 70] {
        let cyclic = Pair::from_generators(&span::<i128>(4, &[], &curve(count as i64, 3))).unwrap();
        assert_eq!(counts(&cyclic), [0, 2 * count - 4, 0, count]);
        assert_there_and_back(&cyclic);
    }
}

/// The cyclic polytope with `n` vertices in four dimensions has `n (n - 3) / 2` facets.
#[test]
fn a_cyclic_polytope_has_the_facets_of_gales_evenness_condition() {
    for count in [6_usize, 10, 16] {
        let cyclic = Pair::from_generators(&span::<i128>(5, &[], &curve(count as i64, 4))).unwrap();
        assert_eq!(counts(&cyclic), [0, count * (count - 3) / 2, 0, count]);
        for facet in cyclic.facets().rows() {
            let on: Vec<bool> = curve(count as i64, 4)
                .iter()
                .map(|ray| facet.iter().zip(ray).map(|(a, b)| a * i128::from(*b)).sum::<i128>() == 0)
                .collect();
            let off: Vec<usize> = (0..count).filter(|i| !on[*i]).collect();
            assert_eq!(off.len(), count - 4);
            assert!(off.windows(2).all(|pair| (pair[1] - pair[0] - 1) % 2 == 0), "{on:?}");
        }
        assert_there_and_back(&cyclic);
    }
}

/// A missing face whose rays are spread over three words.
#[test]
fn a_strict_row_cuts_a_late_edge_of_a_wide_cone() {
    let rays = curve(130, 2);
    let polygon = Pair::from_generators(&span::<i128>(3, &[], &rays)).unwrap();
    let last = rays.last().unwrap();
    let t = i128::from(last[1]);
    let strict = [-t * t, 2 * t, -1];
    let mut system = HalfSpaces::none(3);
    system.closed = polygon.facets().clone();
    system.strict.push(&strict);
    let cone = Cone::from_half_spaces(&system).unwrap().unwrap();
    assert_eq!(cone.closure(), &polygon);
    for ray in &rays {
        let x: Vec<i128> = ray.iter().map(|v| i128::from(*v)).collect();
        assert_eq!(cone.contains(&x).unwrap(), ray != last, "{ray:?}");
    }
    assert_eq!(Cone::from_half_spaces(&cone.half_spaces().unwrap()).unwrap(), Some(cone.clone()));
    assert_eq!(cone.sum(&cone).unwrap(), cone);
    assert_eq!(cone.image(&Matrix::identity(3)).unwrap(), cone);
}

/// `-x <= 0` with `x <= 0` and the row `x_0 >= 0` at infinity: empty is not the same as the origin.
#[test]
fn an_empty_polyhedron_has_only_rays_at_infinity() {
    let empty = from_normals(2, &[vec![1, 1], vec![0, -1], vec![-1, 0]]);
    assert_eq!(counts(&empty), [2, 0, 0, 0]);
    let origin = from_normals(2, &[vec![0, 1], vec![0, -1], vec![-1, 0]]);
    assert_eq!(counts(&origin), [1, 1, 0, 1]);
    let mut strict = HalfSpaces::none(2);
    strict.closed = matrix::<i128>(2, &[vec![1, 1], vec![0, -1]]);
    strict.strict = matrix(2, &[vec![-1, 0]]);
    assert_eq!(Cone::from_half_spaces(&strict).unwrap(), None);
}

#[test]
fn the_order_of_the_rows_does_not_show() {
    let mut rays = curve(9, 3);
    let expected = Pair::from_generators(&span::<i64>(4, &[], &rays)).unwrap();
    for _ in 0..rays.len() {
        rays.rotate_left(4);
        rays.swap(0, 5);
        assert_eq!(Pair::from_generators(&span(4, &[], &rays)).unwrap(), expected);
    }
}

/// In a space of one point a row can still say `0 < 0`.
#[test]
fn the_space_of_one_point_tells_its_point_from_nothing() {
    let point = Cone::<i64>::everything(0).unwrap();
    assert_eq!(volume_in_box(&point, &[]).unwrap(), ratio(1, 1));
    let mut impossible = HalfSpaces::<i64>::none(0);
    impossible.strict.push(&[]);
    assert_eq!(Cone::from_half_spaces(&impossible).unwrap(), None);
    let mut open = HalfSpaces::<i64>::none(1);
    open.strict.push(&[1]);
    let below = Cone::from_half_spaces(&open).unwrap().unwrap();
    assert_eq!(below.image(&Matrix::new(1)).unwrap(), point);
}

#[test]
#[should_panic(expected = "positive half-width")]
fn a_box_without_width_has_no_fractions() {
    let _ = volume_in_box(&Cone::<i64>::everything(2).unwrap(), &[ratio(0, 1), ratio(1, 1)]);
}

#[test]
#[should_panic(expected = "coordinates")]
fn a_point_of_another_space_is_refused() {
    let _ = Cone::<i64>::everything(3).unwrap().contains(&[1]);
}
