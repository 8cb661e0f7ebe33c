//! Three-dimensional cones: every degenerate shape by brute force, and more faces than a word has bits.

use super::naive::{forms, forms_of_normals, rationals};
use partplan::cone::{Cone, HalfSpaces, Pair};
use partplan::exact::Matrix;
use std::collections::BTreeSet;

/// Opposite, parallel, coplanar and zero normals among those of an octant.
const POOL: [[i64; 3]; 9] =
    [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -2, 0], [0, 0, 1], [1, 1, 0], [-1, 1, 1], [0, 0, 0], [-1, -1, -1]];

#[test]
fn every_shape_has_the_forms_of_brute_force_in_any_order_of_normals() {
    let mut shapes = BTreeSet::new();
    for (size, stride) in [(0, 1), (1, 1), (2, 1), (3, 2), (4, 13), (5, 101)] {
        for code in (0..POOL.len().pow(size)).step_by(stride) {
            let normals: Vec<Vec<i64>> =
                (0..size).map(|place| POOL[code / POOL.len().pow(place) % POOL.len()].to_vec()).collect();
            for equalities in [vec![], vec![vec![1, 2, 0]], vec![vec![0, 0, -3], vec![0, 0, 1], vec![1, 0, 1]]] {
                let pair =
                    Pair::<i64>::from_normals(&Matrix::from_rows(3, &equalities), &Matrix::from_rows(3, &normals))
                        .unwrap();
                let expected = forms_of_normals(3, &rationals(&equalities), &rationals(&normals));
                assert_eq!(forms(&pair), expected, "{equalities:?} {normals:?}");
                shapes.insert((expected.equalities.len(), expected.lines.len()));
            }
        }
    }
    assert_eq!(shapes.len(), 10, "{shapes:?}");
}

/// The cone over the polygon with vertices `(k, k²)`: facet `k` holds the rays `k` and `k + 1`, the last one the first ray
/// and the last.
struct Parabola {
    facets: Vec<Vec<i64>>,
    rays: Vec<Vec<i64>>,
}

impl Parabola {
    fn of(vertices: i64) -> Self {
        let last = vertices - 1;
        let lower = (0..last).map(|k| vec![2 * k + 1, -1, -k * (k + 1)]);
        Self {
            facets: lower.chain([vec![-last, 1, 0]]).collect(),
            rays: (0..vertices).map(|k| vec![k, k * k, 1]).collect(),
        }
    }

    fn without(&self, strict: &[Vec<i64>]) -> Cone<i64> {
        let mut system = HalfSpaces::none(3);
        system.closed = Matrix::from_rows(3, &self.facets);
        system.strict = Matrix::from_rows(3, strict);
        Cone::from_half_spaces(&system).unwrap().expect("the inside is left")
    }
}

/// Up to 64 facets and rays are handled as bits of a word, more of them otherwise.
#[test]
fn faces_are_missing_whether_or_not_they_fit_a_word() {
    for vertices in [3, 10, 64, 65, 70] {
        let parabola = Parabola::of(vertices);
        let open = parabola.without(&parabola.facets);
        assert_eq!(open.missing().len(), parabola.facets.len());
        assert!(open.missing().iter().all(|face| face.len() == 1));
        // the tangent at ray 1 touches the cone there only
        let tangent = vec![2, -1, -1];
        let cut = parabola.without(std::slice::from_ref(&tangent));
        let [edge] = cut.missing() else { panic!("one edge is missing, not {:?}", cut.missing()) };
        let facets = edge.iter().map(|facet| cut.closure().facets().row(*facet).to_vec()).collect::<BTreeSet<_>>();
        assert_eq!(facets, BTreeSet::from([parabola.facets[0].clone(), parabola.facets[1].clone()]));
        for (index, ray) in parabola.rays.iter().enumerate() {
            assert!(!open.contains(ray).unwrap());
            assert_eq!(cut.contains(ray).unwrap(), index != 1);
        }
        let peak = parabola.without(&[vec![0, 0, -1]]);
        assert_eq!(peak.missing().len(), 1);
        assert_eq!(peak.missing()[0].len(), parabola.facets.len());
        assert!(!peak.contains(&[0, 0, 0]).unwrap());
        // what a face lacks on both sides or on one the sum lacks too
        let closed = parabola.without(&[]);
        assert!(closed.missing().is_empty());
        assert_eq!(open.sum(&closed).unwrap(), open);
        for other in [&closed, &peak, &cut] {
            assert_eq!(&cut.sum(other).unwrap(), &cut);
        }
    }
}

#[test]
fn facets_and_rays_of_a_large_cone_are_those_of_its_polygon() {
    let parabola = Parabola::of(40);
    // every seventeenth first: neighbours come far apart
    let order = (0..40).map(|place| place * 17 % 40);
    let shuffled = Matrix::from_rows(3, order.map(|facet| &parabola.facets[facet]));
    let pair = Pair::<i64>::from_normals(&Matrix::new(3), &shuffled).unwrap();
    let (mut facets, mut rays) = (parabola.facets, parabola.rays);
    facets.sort();
    rays.sort();
    assert_eq!(pair.facets(), &Matrix::from_rows(3, facets));
    assert_eq!(pair.rays(), &Matrix::from_rows(3, rays));
}
