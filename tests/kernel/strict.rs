//! Cones that need not be closed, against the definitions of their operations by exact linear programs.

use super::draw::{System, convert, face_points, matrix, rows, runs, system, vector};
use super::naive::{rational, rationals};
use super::support::dot;
use super::support::lp::{Program, Relation};
use partplan::cone::{Cone, HalfSpaces, Pair};
use partplan::exact::{Matrix, Q, Z};
use proptest::collection::vec;
use proptest::prelude::*;

fn cone(system: &System) -> Option<Cone<i128>> {
    Cone::from_half_spaces(&system.half_spaces()).unwrap()
}

fn holds(cone: &Cone<i128>, x: &[Z]) -> bool {
    cone.contains(&convert(x)).unwrap()
}

fn integers(x: &[i64]) -> Vec<Z> {
    x.iter().map(|v| Z::from(*v)).collect()
}

/// Requires that `sign y + shift` satisfies the system.
fn require(program: &mut Program, system: &System, sign: i64, shift: &[Q]) {
    let mut add = |rows: &[Vec<i64>], relation| {
        for row in rationals(rows) {
            let left = row.iter().map(|v| -v * Q::from_integer(sign.into())).collect();
            program.require(left, relation, dot(&row, shift));
        }
    };
    add(&system.equalities, Relation::Equal);
    add(&system.closed, Relation::AtLeast);
    add(&system.strict, Relation::Greater);
}

fn is_feasible(system: &System) -> bool {
    let mut program = Program::new(system.dim, 0);
    require(&mut program, system, 1, &rational(&vec![0; system.dim]));
    program.is_feasible()
}

fn fractions(x: &[Z]) -> Vec<Q> {
    x.iter().cloned().map(Q::from_integer).collect()
}

/// Whether `x = y + (x - y)` with `y` in one and the rest in the other.
fn is_in_sum(a: &System, b: &System, x: &[Z]) -> bool {
    let mut program = Program::new(a.dim, 0);
    require(&mut program, a, 1, &rational(&vec![0; a.dim]));
    require(&mut program, b, -1, &fractions(x));
    program.is_feasible()
}

fn is_in_image(of: &System, map: &[Vec<i64>], x: &[Z]) -> bool {
    let mut program = Program::new(of.dim, 0);
    require(&mut program, of, 1, &rational(&vec![0; of.dim]));
    for (row, value) in rationals(map).into_iter().zip(fractions(x)) {
        program.require(row, Relation::Equal, value);
    }
    program.is_feasible()
}

fn points(dim: usize) -> impl Strategy<Value = Vec<Vec<i64>>> {
    vec(vector(dim), 4)
}

/// The landmarks of the closure, and the points drawn.
fn all_points(cone: &Cone<i128>, drawn: &[Vec<i64>]) -> Vec<Vec<Z>> {
    let mut points = face_points(cone.closure());
    points.extend(drawn.iter().map(|x| integers(x)));
    points
}

fn without(system: &HalfSpaces<i128>, part: usize, row: usize) -> HalfSpaces<i128> {
    let mut other = system.clone();
    let rows = [&mut other.equalities, &mut other.closed, &mut other.strict];
    rows.into_iter().nth(part).unwrap().swap_remove(row);
    other
}

proptest! {
    #![proptest_config(runs(150))]

    #[test]
    fn a_system_is_empty_iff_its_strict_program_is_infeasible(system in (1..=4_usize).prop_flat_map(|d| system(d, 6))) {
        prop_assert_eq!(cone(&system).is_some(), is_feasible(&system));
    }

    #[test]
    fn membership_is_that_of_the_given_rows(
        (system, drawn) in (1..=4_usize).prop_flat_map(|d| (system(d, 6), points(d)))
    ) {
        let Some(cone) = cone(&system) else { return Ok(()) };
        for x in all_points(&cone, &drawn) {
            prop_assert_eq!(holds(&cone, &x), system.holds(&x), "at {:?}", x);
        }
    }

    #[test]
    fn the_inner_point_is_off_every_facet(system in (1..=4_usize).prop_flat_map(|d| system(d, 6))) {
        let Some(cone) = cone(&system) else { return Ok(()) };
        let inner: Vec<Z> = cone.inner_point().unwrap().into_iter().map(Z::from).collect();
        prop_assert!(system.holds(&inner));
        for facet in cone.closure().facets().rows() {
            let side: Z = facet.iter().zip(&inner).map(|(a, b)| b * *a).sum();
            prop_assert!(side < Z::from(0));
        }
    }

    /// And no row of it can be left out.
    #[test]
    fn half_spaces_describe_the_same_cone_minimally(system in (1..=4_usize).prop_flat_map(|d| system(d, 6))) {
        let Some(cone) = cone(&system) else { return Ok(()) };
        let minimal = cone.half_spaces().unwrap();
        prop_assert_eq!(Cone::from_half_spaces(&minimal).unwrap(), Some(cone.clone()));
        for (part, rows) in [&minimal.equalities, &minimal.closed, &minimal.strict].into_iter().enumerate() {
            for row in 0..rows.len() {
                let fewer = Cone::from_half_spaces(&without(&minimal, part, row)).unwrap();
                prop_assert_ne!(fewer.as_ref(), Some(&cone), "row {} of part {} is redundant", row, part);
            }
        }
    }

    /// A strict row and its closed copy, positive multiples, and sums of rows change nothing.
    #[test]
    fn equal_sets_are_equal_values((system, factor) in (1..=4_usize).prop_flat_map(|d| (system(d, 5), 1..=4_i64))) {
        let mut other = system.clone();
        other.closed.extend(system.strict.iter().cloned());
        other.closed.reverse();
        if let [.., a] = &system.strict[..] {
            for b in &system.closed {
                other.strict.insert(0, a.iter().zip(b).map(|(x, y)| x * factor + y).collect());
            }
        }
        prop_assert_eq!(cone(&other), cone(&system));
    }

    #[test]
    fn an_intersection_holds_what_both_hold(
        (a, b, drawn) in (1..=4_usize).prop_flat_map(|d| (system(d, 4), system(d, 4), points(d)))
    ) {
        let (Some(one), Some(two)) = (cone(&a), cone(&b)) else { return Ok(()) };
        let mut both = a.clone();
        both.equalities.extend(b.equalities.iter().cloned());
        both.closed.extend(b.closed.iter().cloned());
        both.strict.extend(b.strict.iter().cloned());
        let Some(meet) = one.intersection(&two).unwrap() else {
            prop_assert!(!is_feasible(&both));
            return Ok(());
        };
        prop_assert_eq!(Some(meet.clone()), cone(&both));
        let mut points = all_points(&meet, &drawn);
        points.extend(face_points(one.closure()));
        points.extend(face_points(two.closure()));
        for x in points {
            prop_assert_eq!(holds(&meet, &x), a.holds(&x) && b.holds(&x), "at {:?}", x);
        }
    }
}

proptest! {
    #![proptest_config(runs(60))]

    #[test]
    fn a_sum_holds_what_splits_into_members(
        (a, b, drawn) in (1..=4_usize).prop_flat_map(|d| (system(d, 4), system(d, 4), points(d)))
    ) {
        let (Some(one), Some(two)) = (cone(&a), cone(&b)) else { return Ok(()) };
        let sum = one.sum(&two).unwrap();
        for x in all_points(&sum, &drawn) {
            prop_assert_eq!(holds(&sum, &x), is_in_sum(&a, &b, &x), "at {:?}", x);
        }
        prop_assert_eq!(two.sum(&one).unwrap(), sum);
    }

    /// `{x + y}` is the image of the pairs `(x, y)`.
    #[test]
    fn a_sum_is_an_image_of_the_product((a, b) in (1..=3_usize).prop_flat_map(|d| (system(d, 4), system(d, 3)))) {
        let (Some(one), Some(two)) = (cone(&a), cone(&b)) else { return Ok(()) };
        let dim = a.dim;
        let join = |first: &[Vec<i64>], second: &[Vec<i64>]| -> Vec<Vec<i64>> {
            let left = first.iter().map(|row| [&row[..], &vec![0; dim]].concat());
            left.chain(second.iter().map(|row| [&vec![0; dim], &row[..]].concat())).collect()
        };
        let product = System {
            dim: 2 * dim,
            equalities: join(&a.equalities, &b.equalities),
            closed: join(&a.closed, &b.closed),
            strict: join(&a.strict, &b.strict),
        };
        let add: Vec<Vec<i64>> = (0..dim).map(|i| (0..2 * dim).map(|j| i64::from(j % dim == i)).collect()).collect();
        let image = cone(&product).unwrap().image(&matrix(2 * dim, &add)).unwrap();
        prop_assert_eq!(image, one.sum(&two).unwrap());
    }

    #[test]
    fn an_image_holds_what_has_a_member_above_it(
        (a, map, drawn) in (1..=4_usize, 1..=4_usize)
            .prop_flat_map(|(d, e)| (system(d, 5), vec(vector(d), e), points(e)))
    ) {
        let Some(one) = cone(&a) else { return Ok(()) };
        let image = one.image(&matrix(a.dim, &map)).unwrap();
        prop_assert_eq!(image.closure().ambient(), map.len());
        for x in all_points(&image, &drawn) {
            prop_assert_eq!(holds(&image, &x), is_in_image(&a, &map, &x), "at {:?}", x);
        }
    }

    #[test]
    fn a_system_plus_rays_is_the_sum_with_their_cone(
        (a, rays) in (1..=4_usize).prop_flat_map(|d| (system(d, 5), rows(d, 4)))
    ) {
        let rays = matrix::<i128>(a.dim, &rays);
        let polar = Pair::from_normals(&Matrix::new(a.dim), &rays).unwrap();
        let spanned: Cone<i128> = polar.into_polar().into();
        let expected = cone(&a).map(|cone| cone.sum(&spanned).unwrap());
        prop_assert_eq!(Cone::from_half_spaces_plus(&a.half_spaces(), &rays).unwrap(), expected);
    }
}

fn assert_members(cone: &Cone<i128>, inside: &[&[i128]], outside: &[&[i128]]) {
    for x in inside {
        assert!(cone.contains(x).unwrap(), "{x:?} belongs to the set");
    }
    for x in outside {
        assert!(!cone.contains(x).unwrap(), "{x:?} does not belong to the set");
    }
}

#[test]
fn a_redundant_strict_row_cuts_the_apex_of_a_quadrant() {
    let quadrant = cone(&System::new(2, &[], &[&[1, 0], &[0, 1]], &[&[1, 1]])).unwrap();
    assert_eq!(quadrant.missing().iter().map(|face| face.as_slice()).collect::<Vec<_>>(), [[0, 1]]);
    assert!(!quadrant.is_strict(0) && !quadrant.is_strict(1));
    assert_members(&quadrant, &[&[-1, 0], &[0, -1], &[-1, -1]], &[&[0, 0], &[1, -1]]);
    assert_eq!(quadrant.sum(&quadrant).unwrap(), quadrant);
}

#[test]
fn a_redundant_strict_row_cuts_an_edge_of_an_octant() {
    let closed: [&[i64]; 3] = [&[1, 0, 0], &[0, 1, 0], &[0, 0, 1]];
    let octant = cone(&System::new(3, &[], &closed, &[&[1, 1, 0]])).unwrap();
    assert_eq!(octant.missing().len(), 1);
    assert_eq!(octant.missing()[0].len(), 2);
    assert_members(&octant, &[&[-1, 0, 0], &[0, -1, 0], &[0, -1, -5]], &[&[0, 0, 0], &[0, 0, -1]]);
    let no_apex = cone(&System::new(3, &[], &closed, &[&[1, 2, 3]])).unwrap();
    assert_members(&no_apex, &[&[-1, 0, 0], &[0, -1, 0], &[0, 0, -1]], &[&[0, 0, 0]]);
    let no_facet = cone(&System::new(3, &[], &closed[1..], &[&[1, 0, 0], &[1, 2, 3]])).unwrap();
    assert_eq!(no_facet, cone(&System::new(3, &[], &closed, &[&[1, 0, 0]])).unwrap());
    assert!((0..3).any(|facet| no_facet.is_strict(facet)));
}

#[test]
fn a_strict_row_cuts_the_lineality_space() {
    let wedge = cone(&System::new(3, &[], &[&[1, 0, 0], &[0, 1, 0]], &[&[1, 1, 0]])).unwrap();
    assert_members(&wedge, &[&[-1, 0, 7], &[0, -1, -7]], &[&[0, 0, 0], &[0, 0, 7], &[0, 0, -7]]);
}

#[test]
fn a_strict_row_that_vanishes_on_the_closure_leaves_nothing() {
    let empty = [
        System::new(1, &[], &[&[-1]], &[&[1]]),
        System::new(1, &[], &[], &[&[0]]),
        System::new(2, &[&[1, 0]], &[], &[&[1, 0]]),
        System::new(2, &[&[1, 0]], &[], &[&[0, 1], &[1, -1]]),
        System::new(2, &[], &[&[1, 1], &[-1, -1]], &[&[2, 2]]),
        System::new(2, &[], &[], &[&[1, 0], &[0, 1], &[-1, -1]]),
        System::new(3, &[&[1, 0, 0], &[0, 1, 0], &[0, 0, 1]], &[], &[&[1, 1, 1]]),
    ];
    for system in empty {
        let rays = Matrix::identity(system.dim);
        assert_eq!(cone(&system), None, "{system:?}");
        assert_eq!(Cone::from_half_spaces_plus(&system.half_spaces::<i128>(), &rays).unwrap(), None, "{system:?}");
    }
}

#[test]
fn sets_that_touch_only_in_missing_faces_do_not_meet() {
    let below = cone(&System::new(2, &[], &[], &[&[0, 1]])).unwrap();
    let above = cone(&System::new(2, &[], &[&[0, -1]], &[])).unwrap();
    assert_eq!(below.intersection(&above).unwrap(), None);
    let left = cone(&System::new(2, &[], &[&[1, 0], &[0, 1]], &[&[1, 1]])).unwrap();
    let right = cone(&System::new(2, &[], &[&[-1, 0], &[0, -1]], &[])).unwrap();
    assert_eq!(left.intersection(&right).unwrap(), None);
}

#[test]
fn a_sum_can_regain_a_missing_face() {
    let open = cone(&System::new(2, &[], &[], &[&[1, 0]])).unwrap();
    let axis = cone(&System::new(2, &[&[0, 1]], &[], &[])).unwrap();
    assert!(open.sum(&axis).unwrap().is_everything());
    assert_eq!(open.sum(&axis).unwrap(), Cone::everything(2).unwrap());
    let upright = cone(&System::new(2, &[&[1, 0]], &[], &[])).unwrap();
    assert_eq!(open.sum(&upright).unwrap(), open);
}
