//! Rational functions of real algebraic numbers.

use super::draw::{coefficients, polynomial};
use super::support::random::runs;
use super::support::{int, q, sturm};
use partplan::exact::{Algebraic, Polynomial, Q, ratio};
use proptest::prelude::*;

fn roots(p: &Polynomial) -> Vec<Algebraic> {
    p.real_roots(..).expect("not the zero polynomial")
}

/// With exactly these integer coefficients.
fn integer(coefficients: &[Q]) -> Polynomial {
    Polynomial::new(coefficients.iter().map(Q::to_integer).collect())
}

#[test]
fn functions_of_square_roots_are_known() {
    let root = roots(&Polynomial::from([-2, 0, 1])).remove(1);
    let one = Polynomial::from([1]);
    assert_eq!(root.apply(&Polynomial::from([0, 0, 0, 0, 1]), &one).unwrap(), ratio(4, 1));
    // 1 / (1 + √2) = √2 - 1
    let [less, inverse] = [root.apply(&Polynomial::from([-1, 1]), &one), root.apply(&one, &Polynomial::from([1, 1]))];
    assert_eq!(less, inverse);
    assert_eq!(less.unwrap().polynomial(), Polynomial::from([-1, 2, 1]));
    let golden = roots(&Polynomial::from([-1, -1, 1])).remove(1);
    assert_eq!(golden.apply(&Polynomial::from([0, -1, 1]), &one).unwrap(), ratio(1, 1));
    assert_eq!(golden.apply(&Polynomial::default(), &one).unwrap(), int(0));
}

/// `T_2(cos x) = cos 2 x` takes the roots of `T_8` to those of `T_4`, each from two.
#[test]
fn doubled_angles_have_the_roots_of_the_halved_polynomial() {
    let chebyshev = |n: usize| {
        (1..n).fold((Polynomial::from([1]), Polynomial::from([0, 1])), |(before, t), _| {
            let next = &(&Polynomial::from([0, 2]) * &t) - &before;
            (t, next)
        })
    };
    let [eight, four] = [8, 4].map(|n| roots(&chebyshev(n).1));
    let images: Vec<Algebraic> =
        eight.iter().map(|root| root.apply(&Polynomial::from([-1, 0, 2]), &Polynomial::from([1])).unwrap()).collect();
    for (k, image) in images.iter().enumerate() {
        assert_eq!(*image, four[if k < 4 { 3 - k } else { k - 4 }]);
        assert_eq!(image.polynomial().degree(), Some(4));
    }
}

#[test]
fn a_pole_at_another_root_does_no_harm() {
    let p = &Polynomial::from([-3, 0, 1]) * &Polynomial::from([-1, 1]);
    let (one, pole) = (Polynomial::from([1]), Polynomial::from([-1, 1]));
    let found = roots(&p);
    assert_eq!(found[1].apply(&one, &pole), None);
    assert_eq!(found[1].image(&one, &pole, &int(1)), None);
    // 1 / (√3 - 1) = (√3 + 1) / 2
    assert_eq!(
        found[2].apply(&one, &pole).unwrap(),
        found[2].apply(&Polynomial::from([1, 1]), &Polynomial::from([2])).unwrap()
    );
}

proptest! {
    #![proptest_config(runs(120))]

    /// `g(x) / h(x)` at both ends of a much closer enclosure lies inside, unless the denominator vanishes at the root.
    #[test]
    fn images_hold_the_value(p in coefficients(1..=5), g in coefficients(0..=4), h in coefficients(0..=4)) {
        let width = q("1e-6");
        for root in &roots(&polynomial(&p)) {
            let Some([low, high]) = root.image(&integer(&g), &integer(&h), &width) else {
                prop_assert!(root.sign_of(&polynomial(&h)).is_eq());
                continue;
            };
            prop_assert!(&high - &low <= width);
            for x in root.enclosure(&q("1e-60")) {
                let value = sturm::value(&g, &x) / sturm::value(&h, &x);
                prop_assert!(value >= &low - q("1e-30") && value <= &high + q("1e-30"));
            }
        }
    }

    /// The inverse of a fractional linear function brings the number back.
    #[test]
    fn fractional_linear_functions_are_undone(p in coefficients(1..=5), m in proptest::array::uniform4(-5..=5_i64)) {
        let [a, b, c, d] = m;
        prop_assume!(a * d != b * c);
        for root in &roots(&polynomial(&p)) {
            let Some(image) = root.apply(&Polynomial::from([b, a]), &Polynomial::from([d, c])) else {
                prop_assert_eq!(root, &ratio(-d, c));
                continue;
            };
            let back = image.apply(&Polynomial::from([-b, d]), &Polynomial::from([a, -c]));
            prop_assert_eq!(back.as_ref(), Some(root));
        }
    }

    /// `m(a / b) b^n` vanishes at the root for the polynomial `m` of the image, and `m` has no other root near.
    #[test]
    fn the_polynomial_of_an_image_vanishes(p in coefficients(1..=4), g in coefficients(0..=3), h in coefficients(0..=3)) {
        let (a, b) = (integer(&g), integer(&h));
        for root in &roots(&polynomial(&p)) {
            let Some(image) = root.apply(&a, &b) else {
                prop_assert!(root.sign_of(&b).is_eq());
                continue;
            };
            let equation = image.polynomial();
            prop_assert!(equation.degree() <= Some(p.len() - 1));
            let n = equation.coefficients().len() - 1;
            let power = |base: &Polynomial, exponent| (0..exponent).fold(Polynomial::from([1]), |p, _| &p * base);
            let term = |(k, c)| &(&power(&a, k) * &power(&b, n - k)) * &Polynomial::new(vec![c]);
            let sum = equation.coefficients().iter().cloned().enumerate().map(term).fold(Polynomial::default(), |s, t| &s + &t);
            prop_assert!(root.sign_of(&sum).is_eq());
            let [low, high] = root.image(&a, &b, &q("1e-25")).unwrap();
            prop_assert!(image >= low && image <= high);
        }
    }
}
