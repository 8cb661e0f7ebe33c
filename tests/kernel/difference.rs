//! Differences and complements: disjoint, complete, and equal in volume to what they replace.

use super::draw::{System, convert, face_points, runs, system, vector};
use num_traits::{One, Zero};
use partplan::cone::{Cone, complement, subtract, volume_in_box};
use partplan::exact::{Q, Z, ratio};
use proptest::collection::vec;
use proptest::prelude::*;

fn cone(system: &System) -> Option<Cone<i128>> {
    Cone::from_half_spaces(&system.half_spaces()).unwrap()
}

fn holds(cone: &Cone<i128>, x: &[Z]) -> bool {
    cone.contains(&convert(x)).unwrap()
}

fn fraction(cone: &Cone<i128>) -> Q {
    let dim = cone.closure().ambient();
    let reach: Vec<Q> = (0..dim as i64).map(|i| ratio(i + 2, 3)).collect();
    volume_in_box(cone, &reach).unwrap()
}

fn fractions(cones: &[Cone<i128>]) -> Q {
    cones.iter().map(fraction).sum()
}

fn assert_disjoint(cones: &[Cone<i128>]) {
    for (i, a) in cones.iter().enumerate() {
        for b in &cones[..i] {
            assert_eq!(a.intersection(b).unwrap(), None, "two pieces meet");
        }
    }
}

fn points(dim: usize) -> impl Strategy<Value = Vec<Vec<i64>>> {
    vec(vector(dim), 6)
}

proptest! {
    #![proptest_config(runs(80))]

    #[test]
    fn the_pieces_of_a_difference_and_the_intersection_are_a_partition(
        (a, b, drawn) in (1..=4_usize).prop_flat_map(|d| (system(d, 4), system(d, 4), points(d)))
    ) {
        let (Some(piece), Some(hole)) = (cone(&a), cone(&b)) else { return Ok(()) };
        let pieces = subtract(&piece, &hole).unwrap();
        let meet = piece.intersection(&hole).unwrap();
        if meet.is_none() {
            prop_assert_eq!(&pieces[..], std::slice::from_ref(&piece));
        }
        assert_disjoint(&pieces);
        let mut points: Vec<Vec<Z>> = drawn.iter().map(|x| x.iter().map(|v| Z::from(*v)).collect()).collect();
        for own in pieces.iter().chain(&meet).chain([&piece, &hole]) {
            points.extend(face_points(own.closure()));
        }
        for own in &pieces {
            prop_assert_eq!(own.intersection(&hole).unwrap(), None);
            let inner: Vec<Z> = own.inner_point().unwrap().into_iter().map(Z::from).collect();
            prop_assert!(a.holds(&inner) && !b.holds(&inner));
        }
        for x in points {
            let count = pieces.iter().filter(|own| holds(own, &x)).count();
            prop_assert_eq!(count, usize::from(a.holds(&x) && !b.holds(&x)), "at {:?}", x);
        }
        prop_assert_eq!(fractions(&pieces) + meet.as_ref().map_or(Q::zero(), fraction), fraction(&piece));
    }
}

proptest! {
    #![proptest_config(runs(40))]

    #[test]
    fn a_complement_holds_exactly_what_no_hole_holds(
        (systems, drawn) in (1..=3_usize).prop_flat_map(|d| (vec(system(d, 4), 0..=3), points(d)))
    ) {
        let dim = drawn[0].len();
        let holes: Vec<Cone<i128>> = systems.iter().filter_map(cone).collect();
        let pieces = complement(dim, &holes).unwrap();
        assert_disjoint(&pieces);
        let mut points: Vec<Vec<Z>> = drawn.iter().map(|x| x.iter().map(|v| Z::from(*v)).collect()).collect();
        for own in pieces.iter().chain(&holes) {
            points.extend(face_points(own.closure()));
        }
        for x in points {
            let count = pieces.iter().filter(|own| holds(own, &x)).count();
            prop_assert_eq!(count, usize::from(!systems.iter().any(|hole| hole.holds(&x))), "at {:?}", x);
        }
        if let [hole] = &holes[..] {
            prop_assert_eq!(fractions(&pieces) + fraction(hole), Q::one());
        }
        // What no piece holds is the union of the holes.
        let covered = complement(dim, &pieces).unwrap();
        prop_assert_eq!(fractions(&pieces) + fractions(&covered), Q::one());
        for own in &covered {
            let inner: Vec<Z> = own.inner_point().unwrap().into_iter().map(Z::from).collect();
            prop_assert!(systems.iter().any(|hole| hole.holds(&inner)));
        }
    }
}

#[test]
fn nothing_is_left_of_a_cone_less_itself_or_less_everything() {
    let wedge = cone(&System::new(2, &[], &[&[1, 0], &[0, 1]], &[&[1, 1]])).unwrap();
    assert_eq!(subtract(&wedge, &wedge).unwrap(), []);
    assert_eq!(subtract(&wedge, &Cone::everything(2).unwrap()).unwrap(), []);
    assert_eq!(complement(2, &[Cone::<i128>::everything(2).unwrap()]).unwrap(), []);
    assert_eq!(complement::<i128>(2, &[]).unwrap(), [Cone::everything(2).unwrap()]);
}

#[test]
fn a_closed_quadrant_less_its_open_version_is_its_boundary() {
    let closed = cone(&System::new(2, &[], &[&[1, 0], &[0, 1]], &[])).unwrap();
    let open = cone(&System::new(2, &[], &[], &[&[1, 0], &[0, 1]])).unwrap();
    let boundary = subtract(&closed, &open).unwrap();
    assert_disjoint(&boundary);
    assert!(boundary.iter().all(|piece| piece.closure().dim() < 2));
    for (x, on) in [([0, 0], 1), ([-1, 0], 1), ([0, -1], 1), ([-1, -1], 0), ([1, 0], 0)] {
        assert_eq!(boundary.iter().filter(|piece| piece.contains(&x).unwrap()).count(), on, "at {x:?}");
    }
}

#[test]
fn a_plane_less_a_line_is_two_open_half_planes() {
    let line = cone(&System::new(2, &[&[1, -1]], &[], &[])).unwrap();
    let halves = complement(2, &[line]).unwrap();
    let sides = [&[1, -1], &[-1, 1]].map(|row| cone(&System::new(2, &[], &[], &[row])).unwrap());
    assert_eq!(halves.len(), 2);
    assert!(sides.iter().all(|side| halves.contains(side)));
}

#[test]
fn a_plane_less_its_origin_misses_only_the_origin() {
    let origin = cone(&System::new(2, &[&[1, 0], &[0, 1]], &[], &[])).unwrap();
    let rest = complement(2, &[origin]).unwrap();
    assert_disjoint(&rest);
    for x in [[0, 0], [1, 0], [-1, 0], [0, 1], [0, -1], [2, 3]] {
        let count = rest.iter().filter(|piece| piece.contains(&x).unwrap()).count();
        assert_eq!(count, usize::from(x != [0, 0]), "at {x:?}");
    }
}
