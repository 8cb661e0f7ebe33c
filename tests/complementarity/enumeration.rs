//! Forces and velocities of all solutions told apart.

use crate::brute::{basic_solutions, lcp};
use partplan::complementarity::{Count, Enumeration, Factors, Images, Solutions, enumerate};
use partplan::exact::{Q, dot, ratio};

fn all(factors: &Factors<'_>) -> Solutions {
    match enumerate(&factors.to_exact().unwrap(), 20_000) {
        Enumeration::Complete(all) => all,
        Enumeration::Unfinished { cases } => panic!("{cases} cases were not enough"),
    }
}

/// A rod that slides with its tip ahead at mu = 2, above the threshold where `A_nn - mu A_nt` turns negative, and whose
/// tip is about to lift: it may lift off or catch.
#[test]
fn a_painleve_rod_has_several_velocities() {
    let factors = Factors {
        jacobian: &[0.0, 1.0, 0.5, 1.0, 0.0, -1.0, -1.0, 0.0, 1.0],
        inverse_mass: &[1.0, 1.0, 3.0],
        mu: &[2.0],
        directions: 2,
        q: &[0.125, -1.0, 1.0, 0.0],
    };
    let solutions = all(&factors);
    let map = factors.velocity_map().unwrap();
    let Images::Several(mut found) = solutions.images(&map) else { panic!("{:?}", solutions.images(&map)) };
    let image = |z: &Vec<Q>| map.iter().map(|row| dot(row, z)).collect::<Vec<Q>>();
    let mut expected: Vec<Vec<Q>> = basic_solutions(&factors.to_exact().unwrap()).iter().map(image).collect();
    expected.sort();
    expected.dedup();
    found.sort();
    assert_eq!(found, expected);
    assert!(found.contains(&vec![ratio(0, 1); 3]), "it may lift off");
}

/// Below the threshold the same rod only lifts off.
#[test]
fn below_the_threshold_the_rod_has_one_velocity() {
    let factors = Factors {
        jacobian: &[0.0, 1.0, 0.5, 1.0, 0.0, -1.0, -1.0, 0.0, 1.0],
        inverse_mass: &[1.0, 1.0, 3.0],
        mu: &[0.5],
        directions: 2,
        q: &[0.125, -1.0, 1.0, 0.0],
    };
    assert_eq!(all(&factors).images(&factors.velocity_map().unwrap()), Images::Unique(vec![ratio(0, 1); 3]));
}

/// A block that rests on four points with friction: forces are a continuum, and it stays where it is.
#[test]
fn a_block_on_four_points_stays() {
    let corners = [-1.0, -0.5, 0.5, 1.0];
    let mut jacobian: Vec<f64> = corners.iter().flat_map(|x| [0.0, 1.0, *x]).collect();
    jacobian.extend(corners.iter().flat_map(|_| [1.0, 0.0, 1.0, -1.0, 0.0, -1.0]));
    let mut q = vec![-0.0625; 4];
    q.extend([0.0; 12]);
    let factors = Factors { jacobian: &jacobian, inverse_mass: &[1.0, 1.0, 2.0], mu: &[0.5; 4], directions: 2, q: &q };
    let solutions = all(&factors);
    assert_eq!(solutions.count(), Count::Continuum);
    let still = vec![ratio(0, 1), ratio(1, 16), ratio(0, 1)];
    assert_eq!(solutions.images(&factors.velocity_map().unwrap()), Images::Unique(still));
    let range = solutions.range(0).unwrap();
    assert_eq!((range.min, range.max), (ratio(0, 1), Some(ratio(1, 32))));
    assert_eq!(solutions.range(1).unwrap().max, Some(ratio(1, 24)));
}

/// `z = 0` or any `z ≥ 1` on a line of solutions: pieces of different kinds.
#[test]
fn a_point_and_a_ray_are_both_found() {
    // w_0 = z_1 - 1 pairs with z_0: z_1 = 1 and z_0 free, or z_0 = 0
    let lcp = lcp(&[&[0, 1], &[0, 0]], &[-1, 0]);
    let Enumeration::Complete(all) = enumerate(&lcp, 100) else { panic!() };
    assert_eq!(all.count(), Count::Continuum);
    assert_eq!(all.pieces.len(), 2);
    assert_eq!(all.range(0).unwrap().max, None);
    assert_eq!(all.range(1).unwrap().min, ratio(1, 1));
    assert_eq!(all.images(&[vec![ratio(1, 1), ratio(0, 1)]]), Images::Continuum);
}

#[test]
fn a_limit_is_not_an_answer() {
    let lcp = lcp(&[&[-1, 0], &[0, -1]], &[1, 1]);
    assert_eq!(enumerate(&lcp, 2), Enumeration::Unfinished { cases: 2 });
    let Enumeration::Complete(all) = enumerate(&lcp, 100) else { panic!() };
    assert_eq!(all.count(), Count::Finite(4));
    assert_eq!(all.range(2), None);
}
