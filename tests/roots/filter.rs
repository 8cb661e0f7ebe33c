//! Doubles rounded outward against exact rationals.

use super::draw::{coefficients, polynomial, small};
use super::support::random::runs;
use super::support::{int, q};
use num_traits::{Signed, Zero};
use partplan::exact::{FloatInterval, Polynomial, Q, SignFilter, Z, from_float_exact};
use proptest::prelude::*;

/// From about 2^-1100 to 2^1100, beyond all doubles at both ends, and zero.
fn any_size() -> impl Strategy<Value = Q> {
    let scaled = (any::<i64>(), 1..=i64::MAX, -1_100..=1_100_i32).prop_map(|(p, q, bits)| {
        let power = Z::from(1) << bits.unsigned_abs();
        let value = Q::new(p.into(), q.into());
        if bits < 0 { value / power } else { value * power }
    });
    prop_oneof![6 => scaled, 3 => small(), 1 => Just(Q::zero())]
}

fn holds(interval: FloatInterval, value: &Q) -> bool {
    let [low, high] = interval.ends();
    assert!(low < f64::INFINITY && high > f64::NEG_INFINITY && low <= high);
    from_float_exact(low).is_none_or(|low| low <= *value) && from_float_exact(high).is_none_or(|high| high >= *value)
}

proptest! {
    #![proptest_config(runs(1000))]

    #[test]
    fn operations_on_intervals_hold_the_exact_result(a in any_size(), b in any_size(), c in any_size()) {
        let [x, y, z] = [&a, &b, &c].map(FloatInterval::of_rational);
        prop_assert!(holds(x, &a));
        prop_assert!(holds(-x, &-&a));
        prop_assert!(holds(x + y, &(&a + &b)));
        prop_assert!(holds(x - y, &(&a - &b)));
        prop_assert!(holds(x * y, &(&a * &b)));
        prop_assert!(holds((x + y) * z - x * y * (y - z), &((&a + &b) * &c - &a * &b * (&b - &c))));
        prop_assert!(holds(FloatInterval::of_integer(&a.to_integer()), &a.to_integer().into()));
        let hull = FloatInterval::between((&a).min(&b), (&a).max(&b));
        prop_assert!(holds(hull, &a) && holds(hull, &b));
        if let Some(sign) = (x * y + z).sign() {
            prop_assert_eq!(sign, (&a * &b + &c).cmp(&Q::zero()));
        }
    }

    /// Of two parts far beyond all doubles, whose ratio is not.
    #[test]
    fn long_rationals_have_narrow_intervals(p in 1..=i64::MAX, q in 1..=i64::MAX, digits in 300..700_u32) {
        let power = Z::from(10).pow(digits);
        for value in [Q::new(power.clone() * p + 1, power.clone() * q), Q::new(-(power.clone() * p), power * q - 1)] {
            let interval = FloatInterval::of_rational(&value);
            let [low, high] = interval.ends();
            prop_assert!(holds(interval, &value) && high - low <= 8.0 * f64::EPSILON * low.abs());
        }
    }

    /// Near a root and at it, and anywhere.
    #[test]
    fn filtered_signs_are_exact(p in coefficients(0..=6), x in any_size(), root in small(), digits in 1..40_u32) {
        let filter = SignFilter::default();
        let p = polynomial(&p);
        let product = &p * &Polynomial::new(vec![-root.numer(), root.denom().clone()]);
        let near = &root + Q::new(1.into(), Z::from(10).pow(digits));
        for x in [&x, &near, &root] {
            prop_assert_eq!(filter.sign_at(&product, x), product.sign_at(x));
        }
        prop_assert_eq!(filter.n_settled() + filter.n_exact(), 3);
        prop_assert!(filter.n_exact() > 0 || root.is_zero(), "a zero among rounded numbers is no certain sign");
    }

    #[test]
    fn filtered_signs_at_roots_are_exact(p in coefficients(1..=4), f in coefficients(0..=4)) {
        let filter = SignFilter::default();
        let (p, f) = (polynomial(&p), polynomial(&f));
        for mut root in p.real_roots(..).unwrap() {
            root.refine(&q("1e-18"));
            prop_assert_eq!(filter.sign_of(&f, &root), root.sign_of(&f));
            prop_assert!(filter.sign_of(&p, &root).is_eq());
        }
    }
}

#[test]
fn easy_signs_take_no_exact_arithmetic_and_zeros_do() {
    let filter = SignFilter::default();
    let p = Polynomial::from([-2, 0, 1]);
    for x in 2..=100 {
        assert!(filter.sign_at(&p, &int(x)).is_gt());
    }
    assert_eq!((filter.n_settled(), filter.n_exact()), (99, 0));
    // 99/70 is 7e-5 off the root, well within reach; a convergent of 40 digits is not
    assert!(filter.sign_at(&p, &q("99/70")).is_gt());
    let (mut a, mut b) = (Z::from(1), Z::from(1));
    while b.bits() < 70 {
        (a, b) = (&a + &b + &b, a + b);
    }
    let convergent = Q::new(a, b);
    let sign = (&convergent * &convergent - int(2)).is_positive();
    assert_eq!(filter.sign_at(&p, &convergent).is_gt(), sign);
    assert_eq!((filter.n_settled(), filter.n_exact()), (100, 1));
}

#[test]
fn zero_times_an_unbounded_interval_is_near_zero() {
    let huge = FloatInterval::of_integer(&(Z::from(1) << 1_100_u32));
    let anything = huge - huge;
    assert_eq!(anything.ends(), [f64::NEG_INFINITY, f64::INFINITY]);
    let product = FloatInterval::of_integer(&Z::from(0)) * anything;
    assert!(holds(product, &int(0)) && product.ends().iter().all(|end| end.abs() < 1e-300));
}
