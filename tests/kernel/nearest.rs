//! Nearest points of closed cones, against the conditions that only the nearest point satisfies.

use super::draw::{closed_system, runs, vector};
use super::naive::rational;
use super::support::dot;
use num_traits::{Signed, Zero};
use partplan::cone::{Pair, nearest};
use partplan::exact::{Matrix, Q, ratio};
use proptest::collection::vec;
use proptest::prelude::*;

fn rationals(rows: &Matrix<i128>) -> Vec<Vec<Q>> {
    rows.rows().map(|row| row.iter().map(|value| Q::from_integer((*value).into())).collect()).collect()
}

proptest! {
    #![proptest_config(runs(300))]

    #[test]
    fn the_nearest_point_and_the_rest_are_in_the_cone_and_its_polar_and_orthogonal(
        (system, points, weights) in (1..=4_usize)
            .prop_flat_map(|dim| (closed_system(dim..=dim, 5), vec(vector(dim), 4), vec(1..=5_i64, dim)))
    ) {
        let pair: Pair<i128> = system.pair();
        let weights: Vec<Q> = weights.iter().map(|weight| ratio(*weight, 2)).collect();
        for point in points {
            let point = rational(&point);
            let foot = nearest(&pair, &weights, &point).unwrap();
            let rest: Vec<Q> = (0..point.len()).map(|i| (&point[i] - &foot[i]) * &weights[i]).collect();
            prop_assert!(rationals(pair.equalities()).iter().all(|row| dot(row, &foot).is_zero()));
            prop_assert!(rationals(pair.facets()).iter().all(|row| !dot(row, &foot).is_positive()));
            prop_assert!(rationals(pair.lines()).iter().all(|line| dot(line, &rest).is_zero()));
            prop_assert!(rationals(pair.rays()).iter().all(|ray| !dot(ray, &rest).is_positive()));
            prop_assert!(dot(&foot, &rest).is_zero());
        }
    }
}

#[test]
fn the_weights_decide_which_point_of_a_line_is_nearest() {
    let line = Pair::<i64>::from_normals(&Matrix::from_rows(2, [[1, -1]]), &Matrix::new(2)).unwrap();
    let point = rational(&[4, 0]);
    let half = |weights: [i64; 2]| nearest(&line, &rational(&weights), &point).unwrap();
    assert_eq!(half([1, 1]), rational(&[2, 2]));
    assert_eq!(half([3, 1]), rational(&[3, 3]));
}

#[test]
fn a_point_outside_of_the_apex_is_nearest_to_it() {
    let negative = Pair::<i64>::from_normals(&Matrix::new(3), &Matrix::identity(3)).unwrap();
    let unit = rational(&[1, 1, 1]);
    assert_eq!(nearest(&negative, &unit, &rational(&[1, 2, 3])).unwrap(), rational(&[0, 0, 0]));
    assert_eq!(nearest(&negative, &unit, &rational(&[1, -2, 3])).unwrap(), rational(&[0, -2, 0]));
}
