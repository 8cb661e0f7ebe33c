//! Summands of points of a sum of cones, against their definition and exact linear programs.

use super::draw::{face_points, matrix, rows, runs, system, vector};
use super::naive::{rational, rationals};
use super::support::dot;
use super::support::lp::{Program, Relation};
use num_traits::{Signed, Zero};
use partplan::cone::{Cone, HalfSpaces, summands};
use partplan::exact::{Matrix, Q, Z, ratio};
use proptest::collection::vec;
use proptest::prelude::*;

proptest! {
    #![proptest_config(runs(150))]

    #[test]
    fn summands_exist_exactly_in_the_sum_and_are_what_they_claim(
        (system, rays, drawn) in (1..=4_usize)
            .prop_flat_map(|dim| (system(dim, 5), rows(dim, 3), vec(vector(dim), 4)))
    ) {
        let half_spaces = system.half_spaces::<i128>();
        let columns = rationals(&rays);
        let sum = Cone::from_half_spaces_plus(&half_spaces, &matrix(system.dim, &rays)).unwrap();
        let on_faces = sum.as_ref().map(|sum| face_points(sum.closure())).unwrap_or_default();
        let whole = |point: Vec<Z>| point.into_iter().map(Q::from_integer).collect::<Vec<Q>>();
        for point in on_faces.into_iter().map(whole).chain(drawn.iter().map(|row| rational(row))) {
            let mut program = Program::new(system.dim, rays.len());
            for axis in 0..system.dim {
                let unit = (0..system.dim).map(|other| ratio(i64::from(other == axis), 1));
                let row = unit.chain(columns.iter().map(|ray| ray[axis].clone())).collect();
                program.require(row, Relation::Equal, point[axis].clone());
            }
            let conditions =
                [(&system.equalities, Relation::Equal), (&system.closed, Relation::AtLeast), (&system.strict, Relation::Greater)];
            for (list, relation) in conditions {
                for row in rationals(list) {
                    let left = row.iter().map(|value| -value).chain(columns.iter().map(|_| Q::zero())).collect();
                    program.require(left, relation, Q::zero());
                }
            }
            let found = summands(&half_spaces, &columns, &point).unwrap();
            prop_assert_eq!(found.is_some(), program.is_feasible(), "{:?}", point);
            let Some(found) = found else { continue };
            let side = |row: &Vec<Q>| dot(row, &found.within);
            prop_assert!(rationals(&system.equalities).iter().all(|row| side(row).is_zero()));
            prop_assert!(rationals(&system.closed).iter().all(|row| !side(row).is_positive()));
            prop_assert!(rationals(&system.strict).iter().all(|row| side(row).is_negative()));
            prop_assert_eq!(found.weights.len(), rays.len());
            prop_assert!(found.weights.iter().all(|weight| !weight.is_negative()));
            for axis in 0..system.dim {
                let of_rays: Q = found.weights.iter().zip(&columns).map(|(weight, ray)| weight * &ray[axis]).sum();
                prop_assert_eq!(&found.within[axis] + of_rays, point[axis].clone());
            }
        }
    }
}

/// Beale's program, on which the simplex method with the steepest column cycles: its point is degenerate three times.
#[test]
fn degenerate_columns_do_not_make_the_method_cycle() {
    let [a, b] = [
        [ratio(1, 4), ratio(-60, 1), ratio(-1, 25), ratio(9, 1)],
        [ratio(1, 2), ratio(-90, 1), ratio(-1, 50), ratio(3, 1)],
    ];
    let mut columns: Vec<Vec<Q>> =
        (0..4).map(|k| vec![a[k].clone(), b[k].clone(), ratio(i64::from(k == 2), 1)]).collect();
    columns.extend((0..3).map(|slack| (0..3).map(|axis| ratio(i64::from(axis == slack), 1)).collect()));
    let nothing = HalfSpaces::<i64> { equalities: Matrix::identity(3), ..HalfSpaces::none(3) };
    let point = rational(&[0, 0, 1]);
    let found = summands(&nothing, &columns, &point).unwrap().expect("the slack columns hold the point");
    for axis in 0..3 {
        let sum: Q = found.weights.iter().zip(&columns).map(|(weight, column)| weight * &column[axis]).sum();
        assert_eq!(sum, point[axis]);
    }
}

/// Without conditions of strict rows the rays that contribute are independent: at most as many as coordinates.
#[test]
fn few_rays_contribute() {
    let nothing = HalfSpaces::<i64> { equalities: Matrix::identity(2), ..HalfSpaces::none(2) };
    let fan: Vec<Vec<Q>> = (-4..=4).map(|x| rational(&[x, 5])).collect();
    let found = summands(&nothing, &fan, &rational(&[1, 7])).unwrap().expect("the fan holds the point");
    assert!(found.weights.iter().filter(|weight| weight.is_positive()).count() <= 2);
}
