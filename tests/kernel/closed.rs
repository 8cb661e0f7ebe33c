//! Closed cones: the two forms against each other and against brute force.

use super::draw::{System, closed_system, few_rows, matrix, rows, runs, span};
use super::naive::{Row, forms, forms_of_normals, integers, rank, rationals, rows_of};
use super::support::dot;
use num_traits::{Signed, Zero};
use partplan::cone::{Generators, Pair};
use partplan::exact::{Matrix, Z};
use proptest::prelude::*;

fn again_from_normals(pair: &Pair<i128>) -> Pair<i128> {
    Pair::from_normals(pair.equalities(), pair.facets()).unwrap()
}

fn again_from_generators(pair: &Pair<i128>) -> Pair<i128> {
    let generators = Generators { lines: pair.lines().clone(), rays: pair.rays().clone() };
    Pair::from_generators(&generators).unwrap()
}

fn on<'a>(rows: &'a [Row], x: &'a Row) -> impl Iterator<Item = Row> + 'a {
    rows.iter().filter(|row| dot(row, x).is_zero()).cloned()
}

/// Every row of `inner` is on the right side of every row of `outer`, and on so many of them that it is extreme.
fn assert_extreme(dim: usize, inner: (&[Row], &[Row]), outer: (&[Row], &[Row])) {
    let (basis, extreme) = inner;
    let (flat, sides) = outer;
    for row in extreme {
        assert!(flat.iter().all(|f| dot(f, row).is_zero()), "{row:?} leaves the span");
        assert!(sides.iter().all(|s| !dot(s, row).is_positive()), "{row:?} is outside");
        let tight: Vec<Row> = flat.iter().cloned().chain(on(sides, row)).collect();
        assert_eq!(rank(dim, &tight), dim - basis.len() - 1, "{row:?} is not extreme");
    }
    for (i, row) in extreme.iter().enumerate() {
        assert!(!extreme[..i].contains(row), "{row:?} appears twice");
    }
}

proptest! {
    #![proptest_config(runs(300))]

    /// Both conversions and back are the identity on canonical forms.
    #[test]
    fn a_cone_from_its_own_facets_or_its_own_generators_is_the_same_cone(system in closed_system(1..=6, 8)) {
        let pair = system.pair::<i128>();
        prop_assert_eq!(&again_from_normals(&pair), &pair);
        prop_assert_eq!(&again_from_generators(&pair), &pair);
    }

    #[test]
    fn a_spanned_cone_from_its_own_facets_or_its_own_generators_is_the_same_cone(system in closed_system(1..=6, 8)) {
        let pair = Pair::from_generators(&span::<i128>(system.dim, &system.equalities, &system.closed)).unwrap();
        prop_assert_eq!(&again_from_normals(&pair), &pair);
        prop_assert_eq!(&again_from_generators(&pair), &pair);
        prop_assert_eq!(&system.pair::<i128>().into_polar(), &pair);
    }

    /// Nothing given is lost and nothing is redundant, by ranks of the rows that vanish on one another.
    #[test]
    fn rays_and_facets_are_extreme_and_all_given_rows_hold(system in closed_system(1..=5, 8)) {
        let dim = system.dim;
        let pair = system.pair::<i64>();
        let [equalities, facets, lines, rays] =
            [pair.equalities(), pair.facets(), pair.lines(), pair.rays()].map(rows_of);
        assert_extreme(dim, (&lines, &rays), (&equalities, &facets));
        assert_extreme(dim, (&equalities, &facets), (&lines, &rays));
        prop_assert_eq!(rank(dim, &equalities), dim - pair.dim());
        prop_assert_eq!(rank(dim, &lines), pair.lines().len());
        for row in rationals(&system.equalities) {
            prop_assert!(lines.iter().chain(&rays).all(|g| dot(&row, g).is_zero()));
        }
        for row in rationals(&system.closed) {
            prop_assert!(lines.iter().all(|line| dot(&row, line).is_zero()));
            prop_assert!(rays.iter().all(|ray| !dot(&row, ray).is_positive()));
        }
    }

    /// Shuffled and scaled rows, negated and mixed equalities, and repeated rows describe the same cone.
    #[test]
    fn the_canonical_form_depends_on_the_set_alone(
        (system, shuffled, factors) in closed_system(1..=5, 7).prop_flat_map(|system| {
            let shuffled = Just(system.closed.clone()).prop_shuffle();
            (Just(system), shuffled, proptest::collection::vec(1..=5_i64, 12))
        })
    ) {
        let scaled = |rows: &[Vec<i64>]| -> Vec<Vec<i64>> {
            rows.iter().zip(&factors).map(|(row, factor)| row.iter().map(|v| v * factor).collect()).collect()
        };
        let mut other = System { closed: scaled(&shuffled), ..system.clone() };
        other.closed.extend(system.closed.first().cloned());
        if let [a, b] = &system.equalities[..] {
            let mixed = a.iter().zip(b).map(|(x, y)| 2 * x - 3 * y).collect();
            other.equalities = vec![mixed, a.iter().map(|v| -v).collect()];
        }
        prop_assert_eq!(other.pair::<i128>(), system.pair::<i128>());
    }

    /// An equality is two opposite inequalities.
    #[test]
    fn opposite_rows_are_an_equality(system in closed_system(1..=5, 6)) {
        let mut other = system.clone();
        for row in other.equalities.drain(..) {
            other.closed.push(row.iter().map(|v| -v).collect());
            other.closed.insert(0, row);
        }
        prop_assert_eq!(other.pair::<i128>(), system.pair::<i128>());
    }
}

proptest! {
    #![proptest_config(runs(120))]

    #[test]
    fn both_forms_agree_with_brute_force(system in closed_system(1..=4, 7)) {
        let (equalities, normals) = (rationals(&system.equalities), rationals(&system.closed));
        prop_assert_eq!(forms(&system.pair::<i64>()), forms_of_normals(system.dim, &equalities, &normals));
    }

    /// In three dimensions facets are clipped in cyclic order, with many of them that is a code path of its own.
    #[test]
    fn clipping_agrees_with_brute_force((equalities, normals) in (few_rows(3), rows(3, 14))) {
        let pair = Pair::<i64>::from_normals(&matrix(3, &equalities), &matrix(3, &normals)).unwrap();
        prop_assert_eq!(forms(&pair), forms_of_normals(3, &rationals(&equalities), &rationals(&normals)));
    }

    /// Times a ray, the cone has rank four and is no longer clipped; tilted into the graph of a form it still is.
    #[test]
    fn clipping_agrees_with_general_double_description((normals, form) in (rows(3, 14), super::draw::vector(3))) {
        let flat = Pair::<i128>::from_normals(&Matrix::new(3), &matrix(3, &normals)).unwrap();
        let lifted = |rows: &Matrix<i128>, last: fn(&[i128], &[i64]) -> i128| -> Vec<Vec<Z>> {
            let lift = |row: &[i128]| row.iter().map(|v| Z::from(*v)).chain([last(row, &form).into()]).collect();
            rows.rows().map(lift).collect()
        };
        let padded: Vec<Vec<i64>> = normals.iter().map(|row| [&row[..], &[0]].concat()).collect();

        let mut with_ray = padded.clone();
        with_ray.insert(normals.len() / 2, vec![0, 0, 0, -1]);
        let product = Pair::<i128>::from_normals(&Matrix::new(4), &matrix(4, &with_ray)).unwrap();
        let unit = [0, 0, 0, 1].map(Z::from).to_vec();
        let mut rays = lifted(flat.rays(), |_, _| 0);
        rays.push(unit.clone());
        rays.sort();
        let mut facets = lifted(flat.facets(), |_, _| 0);
        facets.push(unit.iter().map(|v| -v).collect());
        facets.sort();
        prop_assert_eq!(integers(product.rays()), rays);
        prop_assert_eq!(integers(product.facets()), facets);
        prop_assert_eq!(integers(product.lines()), lifted(flat.lines(), |_, _| 0));
        prop_assert_eq!(integers(product.equalities()), lifted(flat.equalities(), |_, _| 0));

        let graph = [&form[..], &[-1]].concat();
        let tilted = Pair::<i128>::from_normals(&matrix(4, &[graph]), &matrix(4, &padded)).unwrap();
        let at = |row: &[i128], form: &[i64]| row.iter().zip(form).map(|(v, f)| v * i128::from(*f)).sum();
        prop_assert_eq!(integers(tilted.rays()), lifted(flat.rays(), at));
        prop_assert_eq!(integers(tilted.lines()), lifted(flat.lines(), at));
    }

    /// The faces are exactly the sets of rays on which some facets vanish.
    #[test]
    fn faces_are_the_intersections_of_facets(system in closed_system(1..=4, 6)) {
        let pair = system.pair::<i64>();
        let [facets, rays] = [pair.facets(), pair.rays()].map(rows_of);
        prop_assume!(facets.len() <= 8);
        let mut expected: Vec<Vec<usize>> = (0..1_usize << facets.len())
            .map(|chosen| {
                let vanish = |ray: &Row| (0..facets.len()).all(|f| chosen >> f & 1 == 0 || dot(&facets[f], ray).is_zero());
                (0..rays.len()).filter(|ray| vanish(&rays[*ray])).collect()
            })
            .collect();
        expected.sort();
        expected.dedup();
        let mut faces = pair.faces().unwrap();
        faces.sort();
        prop_assert_eq!(faces, expected);
    }
}

proptest! {
    #![proptest_config(runs(25))]

    #[test]
    fn both_forms_agree_with_brute_force_in_five_dimensions(system in closed_system(5..=5, 8)) {
        let (equalities, normals) = (rationals(&system.equalities), rationals(&system.closed));
        prop_assert_eq!(forms(&system.pair::<i64>()), forms_of_normals(5, &equalities, &normals));
    }
}
