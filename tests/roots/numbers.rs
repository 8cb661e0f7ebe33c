//! Random real algebraic numbers against Sturm's theorem and known roots.

use super::draw::{coefficients, polynomial, small, sorted, with_roots};
use super::support::random::runs;
use super::support::{int, q, sturm};
use num_traits::Signed;
use partplan::exact::{Algebraic, Q, ratio};
use proptest::collection::vec;
use proptest::prelude::*;
use std::ops::Bound;

fn roots(p: &[Q]) -> Vec<Algebraic> {
    polynomial(p).real_roots(..).expect("not the zero polynomial")
}

proptest! {
    #![proptest_config(runs(200))]

    /// As many as Sturm counts, one in each enclosure, ascending.
    #[test]
    fn roots_are_isolated(p in coefficients(1..=9), ends in (small(), small())) {
        let found = roots(&p);
        prop_assert_eq!(found.len(), sturm::count_all(&p));
        for root in &found {
            let [low, high] = root.enclosure(&q("1e-9"));
            if low == high {
                prop_assert_eq!(sturm::value(&p, &low), int(0));
            } else {
                prop_assert_eq!(sturm::count(&p, &low, &high), 1);
                prop_assert_ne!(sturm::value(&p, &high), int(0));
            }
        }
        prop_assert!(found.is_sorted_by(|a, b| a < b));
        let (low, high) = ends;
        if low < high {
            let half_open = polynomial(&p).real_roots((Bound::Excluded(low.clone()), Bound::Included(high.clone()))).unwrap();
            prop_assert_eq!(half_open.len(), sturm::count(&p, &low, &high));
            let chosen: Vec<Algebraic> = found.into_iter().filter(|root| *root > low && *root <= high).collect();
            prop_assert_eq!(half_open, chosen);
        }
    }

    #[test]
    fn known_rational_roots_are_found(known in vec(small(), 1..7), others in coefficients(0..=3), x in small()) {
        let p = sturm::product(&with_roots(&known), &others);
        let found = roots(&p);
        for root in sorted(known) {
            let twin = found.iter().find(|number| **number == root).expect("a known root is found");
            prop_assert_eq!(twin.rational(), Some(root.clone()));
            prop_assert_eq!(twin.partial_cmp(&x), root.partial_cmp(&x));
            prop_assert_eq!(twin.cmp(&x.clone().into()), root.cmp(&x));
        }
        for number in &found {
            if let Some(value) = number.rational() {
                prop_assert_eq!(sturm::value(&p, &value), int(0));
            }
        }
    }

    /// Two polynomials with a common factor: equality by value against equality of the factor's roots.
    #[test]
    fn order_and_equality_agree_with_disjoint_enclosures(
        shared in coefficients(1..=3), a in coefficients(0..=3), b in coefficients(0..=3)
    ) {
        let (p, r) = (sturm::product(&shared, &a), sturm::product(&shared, &b));
        for x in &roots(&p) {
            for y in &roots(&r) {
                let [a, b] = [x, y].map(|number| number.enclosure(&q("1e-40")));
                let disjoint = a[1] < b[0] || b[1] < a[0];
                prop_assert_eq!(x == y, !disjoint);
                prop_assert_eq!(x < y, a[0] < b[0] && x != y);
                prop_assert_eq!(x.cmp(y), y.cmp(x).reverse());
            }
        }
        let both = roots(&p).iter().filter(|x| roots(&r).contains(x)).count();
        prop_assert!(both >= sturm::count_all(&shared));
    }

    /// The sign of `f` at a root of `p`, by a close enclosure on which Sturm counts no root of `f`, or by a shared one.
    #[test]
    fn signs_agree_with_sturm(p in coefficients(1..=6), f in coefficients(0..=5), share in any::<bool>()) {
        let f = if share { sturm::product(&f, &p[..]) } else { f };
        for root in &roots(&p) {
            let [low, high] = root.enclosure(&q("1e-40"));
            let vanishes = sturm::value(&f, &low) == int(0) || sturm::count(&f, &low, &high) > 0;
            let expected = if vanishes { int(0) } else { sturm::value(&f, &high) };
            prop_assert_eq!(root.sign_of(&polynomial(&f)), expected.cmp(&int(0)));
        }
    }

    /// Strictly between, and short where there is room.
    #[test]
    fn a_rational_separates_neighbours(p in coefficients(2..=7)) {
        let found = roots(&p);
        for pair in found.windows(2) {
            let between = pair[0].before(&pair[1]).expect("roots ascend");
            prop_assert!(pair[0] < between && pair[1] > between);
            prop_assert_eq!(pair[1].before(&pair[0]), None);
        }
        if let Some(root) = found.first() {
            let above: Algebraic = (root.bounds()[1].ceil() + int(8)).into();
            let between = root.before(&above).expect("the number is greater");
            prop_assert!(*root < between && above > between && *between.denom() <= 2.into());
        }
    }

    #[test]
    fn doubles_are_close(p in coefficients(1..=6)) {
        for root in &roots(&p) {
            let near = partplan::exact::from_float_exact(root.to_f64()).unwrap();
            let error = near.abs() * ratio(1, 1 << 52);
            prop_assert!(*root >= &near - &error && *root <= &near + &error);
        }
    }
}
