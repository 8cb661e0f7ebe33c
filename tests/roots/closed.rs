//! Polynomials whose roots are known.

use super::support::{int, q, sturm};
use partplan::exact::{Algebraic, Polynomial, Q, Z, ratio};
use std::cmp::Ordering;
use std::ops::Bound;

fn roots(p: &Polynomial) -> Vec<Algebraic> {
    p.real_roots(..).expect("not the zero polynomial")
}

/// Each root lies between the bounds asked for, which are close and hold a sign change or the root itself.
fn assert_enclosed(root: &Algebraic, width: &Q) {
    let [low, high] = root.enclosure(width);
    assert!(&high - &low <= *width);
    let p = root.polynomial();
    if low == high {
        assert_eq!(p.at(&low), int(0));
    } else {
        assert!(p.at(&low) * p.at(&high) < int(0));
        assert!(*root > low && *root < high);
    }
}

#[test]
fn the_root_of_two_is_enclosed_to_a_thousand_digits() {
    let root = roots(&Polynomial::from([-2, 0, 1])).remove(1);
    let width = Q::new(Z::from(1), Z::from(10).pow(1_000));
    let [low, high] = root.enclosure(&width);
    assert!(&high - &low <= width);
    assert!(&low * &low < int(2) && &high * &high > int(2));
    assert_eq!(root.rational(), None);
    assert!((root.to_f64() - 2_f64.sqrt()).abs() <= f64::EPSILON);
}

#[test]
fn the_golden_ratio_is_between_ratios_of_fibonacci_numbers() {
    let golden = roots(&Polynomial::from([-1, -1, 1])).remove(1);
    let (mut a, mut b) = (1_i64, 1_i64);
    for step in 0..80 {
        (a, b) = (b, a + b);
        assert_eq!(golden > ratio(b, a), step % 2 == 1, "{b}/{a}");
    }
    // φ² = φ + 1, and 1/φ = φ - 1
    let image = golden.image(&Polynomial::from([0, 0, 1]), &Polynomial::from([1]), &q("1e-30")).unwrap();
    assert!(golden > &image[0] - int(1) && golden < &image[1] - int(1));
    let image = golden.image(&Polynomial::from([1]), &Polynomial::from([0, 1]), &q("1e-30")).unwrap();
    assert!(golden > &image[0] + int(1) && golden < &image[1] + int(1));
    assert!(&image[1] - &image[0] <= q("1e-30"));
}

/// `T_n` has the roots `cos((2 k - 1) π / (2 n))`.
#[test]
fn chebyshev_polynomials_have_cosines_as_roots() {
    let (mut before, mut t) = (Polynomial::from([1]), Polynomial::from([0, 1]));
    for n in 1..=16_u32 {
        let found = roots(&t);
        assert_eq!(found.len(), n as usize);
        for (k, root) in (1..=n).rev().zip(&found) {
            let cosine = (f64::from(2 * k - 1) * std::f64::consts::PI / f64::from(2 * n)).cos();
            assert!((root.to_f64() - cosine).abs() < 1e-15, "{n}, {k}: {} {cosine}", root.to_f64());
            assert_enclosed(root, &q("1e-25"));
        }
        let next = &(&Polynomial::from([0, 2]) * &t) - &before;
        (before, t) = (t, next);
    }
}

#[test]
fn wilkinsons_polynomial_has_the_numbers_one_to_twenty() {
    let p = (1..=20_i64).fold(Polynomial::from([1]), |p, k| &p * &Polynomial::from([-k, 1]));
    let found: Vec<Option<Q>> = roots(&p).iter().map(Algebraic::rational).collect();
    assert_eq!(found, (1..=20).map(|k| Some(int(k))).collect::<Vec<_>>());
    // the famous change of the second highest coefficient by 2^-23 leaves ten real roots
    let mut coefficients: Vec<Q> = p.coefficients().iter().map(|c| Q::from(c.clone())).collect();
    coefficients[19] -= ratio(1, 1 << 23);
    let found = roots(&Polynomial::from_rationals(&coefficients));
    assert_eq!(found.len(), 10);
    assert!((found[9].to_f64() - 20.846_908_101_48).abs() < 1e-10);
    assert!((found[7].to_f64() - 8.007_267_603_45).abs() < 1e-10);
}

/// `x^n - 2 (a x - 1)²` has two roots within `a^{-(n + 2)/2}` of `1 / a`.
#[test]
fn mignottes_close_roots_are_told_apart() {
    let (n, a) = (17, 1_000_i64);
    let square = &Polynomial::from([-1, a]) * &Polynomial::from([-1, a]);
    let mut power = vec![Z::from(0); n];
    power.push(Z::from(1));
    let p = &Polynomial::new(power) - &(&square + &square);
    let found = roots(&p);
    let close: Vec<&Algebraic> = found.iter().filter(|root| (root.to_f64() - 1e-3).abs() < 1e-20).collect();
    assert_eq!(close.len(), 2);
    assert!(*close[0] < ratio(1, 1_000) && *close[1] > ratio(1, 1_000));
    assert!(close[0] < close[1]);
    let rational: Vec<Q> = p.coefficients().iter().map(|c| Q::from(c.clone())).collect();
    assert_eq!(found.len(), sturm::count_all(&rational));
    for root in &found {
        assert_enclosed(root, &q("1e-60"));
    }
}

#[test]
fn roots_of_different_polynomials_that_share_a_factor_are_equal() {
    let factor = Polynomial::from([-3, 1, 0, 0, 1]);
    let a = roots(&(&factor * &Polynomial::from([-2, 0, 1])));
    let b = roots(&(&factor * &Polynomial::from([-5, 7, 0, 11])));
    let shared: Vec<&Algebraic> = a.iter().filter(|root| b.contains(root)).collect();
    assert_eq!(shared.len(), roots(&factor).len());
    assert!(shared.iter().zip(&roots(&factor)).all(|(a, b)| *a == b));
    // √2 and a root that agrees with it in 40 digits
    let close = Polynomial::from_rationals(&[-int(2) - q("1e-40"), int(0), int(1)]);
    assert!(roots(&close)[1] > roots(&Polynomial::from([-2, 0, 1]))[1]);
}

#[test]
fn rational_roots_of_higher_degree_are_recognised() {
    // (7 x - 3) (x² - 2), and a root that bisection cannot meet
    let p = &Polynomial::from([-3, 7]) * &Polynomial::from([-2, 0, 1]);
    let found: Vec<Option<Q>> = roots(&p).iter().map(Algebraic::rational).collect();
    assert_eq!(found, [None, Some(ratio(3, 7)), None]);
    assert_eq!(roots(&p)[1], ratio(3, 7));
    let huge = q("1234567890123456789012345678901/9876543210987654321098765432109876543");
    let p = &Polynomial::from_rationals(&[-&huge, int(1)]) * &Polynomial::from([-1, -1, 0, 1]);
    assert_eq!(roots(&p)[0].rational(), Some(huge));
    assert_eq!(roots(&p)[1].rational(), None);
}

#[test]
fn ends_belong_to_the_range_as_it_says() {
    let p = Polynomial::from([0, -1, 0, 1]); // -1, 0, 1
    let count = |low, high| p.real_roots((low, high)).unwrap().len();
    let at = |value: i64| int(value);
    assert_eq!(count(Bound::Included(at(-1)), Bound::Included(at(1))), 3);
    assert_eq!(count(Bound::Excluded(at(-1)), Bound::Included(at(1))), 2);
    assert_eq!(count(Bound::Excluded(at(-1)), Bound::Excluded(at(1))), 1);
    assert_eq!(count(Bound::Excluded(at(0)), Bound::Unbounded), 1);
    assert_eq!(count(Bound::Unbounded, Bound::Excluded(at(-1))), 0);
    assert_eq!(count(Bound::Included(at(1)), Bound::Included(at(1))), 1);
    assert_eq!(count(Bound::Included(at(100)), Bound::Unbounded), 0);
    assert_eq!(count(Bound::Included(at(1)), Bound::Included(at(-1))), 0);
    let ascending = p.real_roots(int(0)..int(100)).unwrap();
    assert_eq!(ascending, [int(0), int(1)]);
}

/// Bisection of these ranges does not meet zero.
#[test]
fn zero_is_found_as_such() {
    let p = Polynomial::from([0, -2, 0, 1]); // x³ - 2 x
    for (low, high) in [("-1", "2"), ("-1/3", "1")] {
        let found = p.real_roots(q(low)..=q(high)).unwrap();
        assert_eq!(found[0], int(0));
        assert_eq!(found[0].rational(), Some(int(0)));
        assert_eq!(found[0].to_f64(), 0.0);
        assert!(found[1..].iter().all(|root| root.bounds()[0] > int(0)));
    }
}

#[test]
fn constants_have_no_roots_and_zero_has_all() {
    assert_eq!(Polynomial::default().real_roots(..), None);
    assert_eq!(Polynomial::from([7]).real_roots(..), Some(Vec::new()));
    assert_eq!(Polynomial::from([1, 0, 1]).real_roots(..), Some(Vec::new()));
    assert_eq!(roots(&Polynomial::from([0, 0, 0, 5])), [int(0)]);
    assert_eq!(roots(&Polynomial::from([-3, 2])), [ratio(3, 2)]);
}

#[test]
fn signs_at_a_root_are_exact() {
    let root = roots(&Polynomial::from([-2, 0, 1])).remove(1);
    assert_eq!(root.sign_of(&Polynomial::from([-2, 0, 1])), Ordering::Equal);
    assert_eq!(root.sign_of(&Polynomial::from([-4, 0, 0, 0, 1])), Ordering::Equal);
    assert_eq!(root.sign_of(&Polynomial::default()), Ordering::Equal);
    // 99/70 and 577/408 are convergents, above; 239/169 below
    assert_eq!(root.sign_of(&Polynomial::from([-577, 408])), Ordering::Less);
    assert_eq!(root.sign_of(&Polynomial::from([-239, 169])), Ordering::Greater);
    let near = Polynomial::from_rationals(&[-int(4) + q("1e-50"), int(0), int(0), int(0), int(1)]);
    assert_eq!(root.sign_of(&near), Ordering::Greater);
    let one = Polynomial::from([1]);
    assert_eq!(root.image(&one, &Polynomial::from([2, 0, -1]), &q("1")), None);
    assert_eq!(Algebraic::from(int(3)).image(&one, &Polynomial::from([-3, 1]), &q("1")), None);
}

#[test]
fn polynomials_are_written_from_the_highest_power() {
    let written = |p: Polynomial| p.to_string();
    assert_eq!(written(Polynomial::from([5, -1, 0, 2])), "2 x^3 - x + 5");
    assert_eq!(written(Polynomial::from([0, 1])), "x");
    assert_eq!(written(Polynomial::from([-1, 0, -1])), "-x^2 - 1");
    assert_eq!(written(Polynomial::from([-7])), "-7");
    assert_eq!(written(Polynomial::default()), "0");
}
