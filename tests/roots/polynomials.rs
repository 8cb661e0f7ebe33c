//! Arithmetic of polynomials against rational arithmetic on values.

use super::draw::{coefficients, polynomial, small, sorted, with_roots};
use super::support::random::runs;
use super::support::sturm::value;
use num_traits::Zero;
use partplan::exact::{Polynomial, Q, Z};
use proptest::collection::vec;
use proptest::prelude::*;

/// The integer polynomial with exactly these integer coefficients.
fn integer(coefficients: &[Q]) -> Polynomial {
    Polynomial::new(coefficients.iter().map(Q::to_integer).collect())
}

proptest! {
    #![proptest_config(runs(300))]

    #[test]
    fn values_add_and_multiply(a in coefficients(0..=6), b in coefficients(0..=6), x in small()) {
        let (p, q) = (integer(&a), integer(&b));
        let (at_a, at_b) = (value(&a, &x), value(&b, &x));
        prop_assert_eq!(p.at(&x), at_a.clone());
        prop_assert_eq!(p.sign_at(&x), at_a.cmp(&Q::zero()));
        prop_assert_eq!((&p + &q).at(&x), &at_a + &at_b);
        prop_assert_eq!((&p - &q).at(&x), &at_a - &at_b);
        prop_assert_eq!((&p * &q).at(&x), &at_a * &at_b);
        prop_assert_eq!((&p * &q).exact_quotient(&q), Some(p.clone()));
        prop_assert!((&p - &p).is_zero());
    }

    /// `(p q)' = p' q + p q'`, and the derivative of `x^n` is known.
    #[test]
    fn derivatives_obey_the_product_rule(a in coefficients(0..=5), b in coefficients(0..=5)) {
        let (p, q) = (integer(&a), integer(&b));
        let expected = &(&p.derivative() * &q) + &(&p * &q.derivative());
        prop_assert_eq!((&p * &q).derivative(), expected);
        prop_assert_eq!(Polynomial::from([9, 4, 0, 5]).derivative(), Polynomial::from([4, 0, 15]));
    }

    /// It is on the ray of the remainder that division over the rationals leaves.
    #[test]
    fn a_pseudo_remainder_is_a_positive_multiple_of_the_remainder(a in coefficients(0..=7), b in coefficients(1..=4)) {
        let (p, q) = (integer(&a), integer(&b));
        let rest = p.pseudo_remainder(&q);
        prop_assert!(rest.degree() < q.degree());
        let exact = remainder(&a, &b);
        prop_assert_eq!(rest.primitive(), polynomial(&exact));
    }

    #[test]
    fn the_greatest_common_divisor_is_the_shared_part(
        shared in vec(small(), 0..4), a in vec(small(), 0..3), b in vec(small(), 0..3)
    ) {
        prop_assume!(a.iter().all(|root| !b.contains(root)));
        let p = with_roots(&[&shared[..], &a].concat());
        let q = with_roots(&[&shared[..], &b].concat());
        let minus_three = Polynomial::from([-3]);
        let found = polynomial(&p).gcd(&(&polynomial(&q) * &minus_three));
        prop_assert_eq!(found, polynomial(&with_roots(&shared)));
    }

    #[test]
    fn the_square_free_part_has_every_root_once(roots in vec(small(), 1..6), repeated in 1..4_usize) {
        let all = vec![roots.clone(); repeated].concat();
        let p = &polynomial(&with_roots(&all)) * &Polynomial::from([-2, 0, -2]);
        let expected = &polynomial(&with_roots(&sorted(roots))) * &Polynomial::from([1, 0, 1]);
        prop_assert_eq!(p.square_free(), expected);
    }
}

fn remainder(a: &[Q], b: &[Q]) -> Vec<Q> {
    let mut rest = a.to_vec();
    while rest.len() >= b.len() {
        let factor = &rest[rest.len() - 1] / &b[b.len() - 1];
        let shift = rest.len() - b.len();
        for (i, c) in b.iter().enumerate() {
            rest[shift + i] -= &factor * c;
        }
        rest.pop();
    }
    rest
}

#[test]
fn an_inexact_quotient_is_refused() {
    let p = Polynomial::from([1, 2, 1]);
    assert_eq!(p.exact_quotient(&Polynomial::from([1, 1])), Some(Polynomial::from([1, 1])));
    assert_eq!(p.exact_quotient(&Polynomial::from([2, 2])), None);
    assert_eq!(p.exact_quotient(&Polynomial::from([0, 1])), None);
    assert_eq!(p.exact_quotient(&Polynomial::default()), None);
    assert_eq!(Polynomial::default().exact_quotient(&p), Some(Polynomial::default()));
    assert_eq!(Polynomial::default().gcd(&Polynomial::default()), Polynomial::default());
    assert_eq!(Polynomial::new(vec![Z::from(4), Z::zero()]).degree(), Some(0));
}
