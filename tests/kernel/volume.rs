//! Volumes inside boxes against closed forms and against polygons clipped on the faces of the box.

use super::draw::{matrix, rows, runs, system, vector};
use super::naive::rationals;
use super::support::{cross, int};
use num_traits::{One, Signed, Zero};
use partplan::cone::{Cone, Pair, volume_in_box};
use partplan::exact::{Long, Matrix, Q, ratio};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::select;

fn closed(dim: usize, normals: &[Vec<i64>]) -> Cone<Long> {
    Pair::from_normals(&Matrix::new(dim), &matrix(dim, normals)).unwrap().into()
}

fn reach(dim: usize) -> impl Strategy<Value = Vec<Q>> {
    vec((1..=5_i64, 1..=4_i64).prop_map(|(p, q)| ratio(p, q)), dim)
}

/// The part of a polygon in the plane where `normal x + constant <= 0`.
fn clipped(polygon: &[[Q; 2]], normal: [&Q; 2], constant: &Q) -> Vec<[Q; 2]> {
    let value = |p: &[Q; 2]| normal[0] * &p[0] + normal[1] * &p[1] + constant;
    let mut kept = Vec::new();
    for (i, here) in polygon.iter().enumerate() {
        let there = &polygon[(i + 1) % polygon.len()];
        let (a, b) = (value(here), value(there));
        if !a.is_positive() {
            kept.push(here.clone());
        }
        if (&a * &b).is_negative() {
            let t = &a / (&a - &b);
            kept.push([0, 1].map(|k| &here[k] + &t * (&there[k] - &here[k])));
        }
    }
    kept
}

fn area(polygon: &[[Q; 2]]) -> Q {
    let crosses = (0..polygon.len()).map(|i| cross(&polygon[i], &polygon[(i + 1) % polygon.len()]));
    crosses.sum::<Q>().abs() / int(2)
}

fn rectangle(x: &Q, y: &Q) -> Vec<[Q; 2]> {
    [(-1, -1), (1, -1), (1, 1), (-1, 1)].map(|(i, j)| [x * int(i), y * int(j)]).to_vec()
}

/// The rectangle clipped by all normals, and its area.
fn fraction_in_plane(normals: &[Vec<i64>], reach: &[Q]) -> Q {
    let mut polygon = rectangle(&reach[0], &reach[1]);
    for normal in rationals(normals) {
        polygon = clipped(&polygon, [&normal[0], &normal[1]], &Q::zero());
    }
    area(&polygon) / (int(4) * &reach[0] * &reach[1])
}

/// Pyramids from the apex over the part of each face of the box in the cone.
fn fraction_in_space(normals: &[Vec<i64>], reach: &[Q]) -> Q {
    let mut volume = Q::zero();
    for axis in 0..3 {
        let [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
        for side in [-1, 1] {
            let height = int(side) * &reach[axis];
            let mut polygon = rectangle(&reach[u], &reach[v]);
            for normal in rationals(normals) {
                polygon = clipped(&polygon, [&normal[u], &normal[v]], &(&normal[axis] * &height));
            }
            volume += &reach[axis] * area(&polygon) / int(3);
        }
    }
    volume / (int(8) * &reach[0] * &reach[1] * &reach[2])
}

proptest! {
    #![proptest_config(runs(150))]

    #[test]
    fn planar_volumes_agree_with_a_clipped_rectangle((normals, reach) in (rows(2, 3), reach(2))) {
        prop_assert_eq!(volume_in_box(&closed(2, &normals), &reach).unwrap(), fraction_in_plane(&normals, &reach));
    }

    #[test]
    fn volumes_in_space_agree_with_clipped_faces((normals, reach) in (rows(3, 4), reach(3))) {
        prop_assert_eq!(volume_in_box(&closed(3, &normals), &reach).unwrap(), fraction_in_space(&normals, &reach));
    }
}

proptest! {
    #![proptest_config(runs(30))]

    /// Up to five dimensions by one cone in the plane and one in the plane or in space.
    #[test]
    fn the_fraction_of_a_product_is_the_product_of_the_fractions(
        (first, second, reach) in select(vec![2_usize, 3]).prop_flat_map(|d| (rows(2, 2), rows(d, 3), reach(2 + d)))
    ) {
        let dim = reach.len();
        let mut normals: Vec<Vec<i64>> = first.iter().map(|row| [&row[..], &vec![0; dim - 2]].concat()).collect();
        normals.extend(second.iter().map(|row| [&[0, 0], &row[..]].concat()));
        let other = if dim == 4 { fraction_in_plane } else { fraction_in_space };
        let expected = fraction_in_plane(&first, &reach[..2]) * other(&second, &reach[2..]);
        prop_assert_eq!(volume_in_box(&closed(dim, &normals), &reach).unwrap(), expected);
    }

    /// Any hyperplane through the apex cuts a cone into two whose fractions add up.
    #[test]
    fn fractions_of_two_halves_add_up(
        (normals, cut, reach) in (1..=4_usize).prop_flat_map(|d| (rows(d, 4), vector(d), reach(d)))
    ) {
        let dim = reach.len();
        prop_assume!(cut.iter().any(|v| *v != 0));
        let with = |sign: i64| {
            let mut normals = normals.clone();
            normals.push(cut.iter().map(|v| v * sign).collect());
            volume_in_box(&closed(dim, &normals), &reach).unwrap()
        };
        prop_assert_eq!(with(1) + with(-1), volume_in_box(&closed(dim, &normals), &reach).unwrap());
    }

    /// Stretched, reflected and permuted axes, of the cone and of the box alike.
    #[test]
    fn fractions_do_not_depend_on_the_axes(
        (normals, reach, factors, signs) in (1..=4_usize).prop_flat_map(|d| {
            (rows(d, 4), reach(d), vec(1..=3_i64, d), vec(any::<bool>(), d))
        })
    ) {
        let dim = reach.len();
        let moved: Vec<Vec<i64>> = normals
            .iter()
            .map(|row| (0..dim).rev().map(|i| row[i] * factors[i] * if signs[i] { -1 } else { 1 }).collect())
            .collect();
        let shrunk: Vec<Q> = (0..dim).rev().map(|i| &reach[i] / int(factors[i])).collect();
        let expected = volume_in_box(&closed(dim, &normals), &reach).unwrap();
        prop_assert_eq!(volume_in_box(&closed(dim, &moved), &shrunk).unwrap(), expected);
    }

    #[test]
    fn missing_faces_have_no_volume((system, reach) in (1..=3_usize).prop_flat_map(|d| (system(d, 4), reach(d)))) {
        let Some(cone) = Cone::<Long>::from_half_spaces(&system.half_spaces()).unwrap() else { return Ok(()) };
        let whole: Cone<Long> = cone.closure().clone().into();
        prop_assert_eq!(volume_in_box(&cone, &reach).unwrap(), volume_in_box(&whole, &reach).unwrap());
    }
}

fn unequal(dim: usize) -> Vec<Q> {
    (0..dim as i64).map(|i| ratio(2 * i + 1, i + 2)).collect()
}

fn unit(dim: usize, axis: usize) -> Vec<i64> {
    (0..dim).map(|i| i64::from(i == axis)).collect()
}

#[test]
fn the_whole_space_fills_the_box_and_a_half_space_half_of_it() {
    for dim in 1..=5 {
        let everything = Cone::<Long>::everything(dim).unwrap();
        assert_eq!(volume_in_box(&everything, &unequal(dim)).unwrap(), Q::one());
        let normal: Vec<i64> = (0..dim as i64).map(|i| i * i - 3 * i + 1).collect();
        assert_eq!(volume_in_box(&closed(dim, &[normal]), &unequal(dim)).unwrap(), ratio(1, 2));
    }
}

#[test]
fn an_orthant_fills_an_equal_share() {
    for dim in 1..=5 {
        let normals: Vec<Vec<i64>> = (0..dim).map(|axis| unit(dim, axis)).collect();
        assert_eq!(volume_in_box(&closed(dim, &normals), &unequal(dim)).unwrap(), ratio(1, 1 << dim));
    }
}

/// One of the orders of `dim` numbers, and one of the orders of their absolute values with signs.
#[test]
fn sorted_points_fill_their_share_of_a_cube() {
    let mut orders = 1;
    for dim in 1..=5 {
        orders *= dim as i64;
        let cube = vec![ratio(2, 3); dim];
        let mut normals: Vec<Vec<i64>> =
            (1..dim).map(|i| unit(dim, i - 1).iter().zip(unit(dim, i)).map(|(a, b)| a - b).collect()).collect();
        assert_eq!(volume_in_box(&closed(dim, &normals), &cube).unwrap(), ratio(1, orders));
        normals.push(unit(dim, 0).iter().map(|v| -v).collect());
        assert_eq!(volume_in_box(&closed(dim, &normals), &cube).unwrap(), ratio(1, orders << dim));
    }
}

/// `sum of |x_i| over the others <= x_0` holds in one of `2 dim` cones over a cross polytope of volume `2^k / k!`.
#[test]
fn a_cone_over_a_cross_polytope_has_its_pyramid() {
    let mut pyramid = Q::one();
    for dim in 1..=5_usize {
        let others = dim - 1;
        if others > 0 {
            pyramid *= ratio(2, others as i64);
        }
        let signs = (0..1_usize << others).map(|signs| {
            let sign = |i: usize| if signs >> i & 1 == 1 { 1 } else { -1 };
            [-1].into_iter().chain((0..others).map(sign)).collect::<Vec<i64>>()
        });
        let normals: Vec<Vec<i64>> = signs.collect();
        let expected = &pyramid / int(dim as i64 * (1 << dim));
        assert_eq!(volume_in_box(&closed(dim, &normals), &vec![Q::one(); dim]).unwrap(), expected);
    }
}

#[test]
fn a_flat_cone_has_no_volume() {
    for dim in 1..=5 {
        let opposite = [unit(dim, dim - 1), unit(dim, dim - 1).iter().map(|v| -v).collect()];
        assert_eq!(volume_in_box(&closed(dim, &opposite), &unequal(dim)).unwrap(), Q::zero());
        let origin: Cone<Long> = Pair::from_normals(&Matrix::identity(dim), &Matrix::new(dim)).unwrap().into();
        assert_eq!(volume_in_box(&origin, &unequal(dim)).unwrap(), Q::zero());
    }
}

/// A tall thin box: the wedge `|y| <= x` leaves it through the side until `x` reaches `y`'s bound.
#[test]
fn a_wedge_in_an_unequal_box_is_a_triangle_and_a_rectangle() {
    let wedge = closed(2, &[vec![-1, 1], vec![-1, -1]]);
    let [x, y] = [int(3), ratio(1, 7)];
    let expected = (&y * &y + (&x - &y) * &y * int(2)) / (int(4) * &x * &y);
    assert_eq!(volume_in_box(&wedge, &[x, y]).unwrap(), expected);
}
