//! Heights and tolerances as a machinist types them.

use super::super::tolerance::{inside, rounded_down, short};
use crate::exact::{Algebraic, Polynomial, Q, Z, parse_literal, ratio};
use proptest::prelude::*;

fn q(text: &str) -> Q {
    parse_literal(text).unwrap()
}

fn decimals(value: &Q) -> u32 {
    (0..).find(|decimals| (value * Q::from(Z::from(10).pow(*decimals))).is_integer()).unwrap()
}

#[test]
fn decimals_are_as_few_as_keep_the_width() {
    // ends of the three pins of the case of that name, to eight digits
    assert_eq!(short(&q("3.6673129"), &q("4.0808973")), (q("3.874"), q("0.206")));
    assert_eq!(short(&q("3"), &q("4")), (q("3.5"), q("0.499")));
    assert_eq!(short(&q("1000"), &q("3000")), (q("2000"), q("999")));
    assert_eq!(short(&q("0"), &q("1e-6")), (q("0.0000005"), q("0.000000499")));
}

#[test]
fn ends_are_enclosed_to_the_last_part_of_the_room() {
    // the golden ratio against a convergent of its continued fraction
    let golden = Polynomial::from([-1, -1, 1]).real_roots(ratio(0, 1)..).unwrap().remove(0);
    let convergent = Algebraic::from(ratio(2_178_309, 1_346_269));
    let (low, high) = if golden < convergent { (golden, convergent) } else { (convergent, golden) };
    let [from, to] = inside(&low, &high).unwrap();
    assert!(low <= from && high >= to);
    let slack = (&to - &from) * q("1e-12");
    assert!(low > &from - &slack && high < &to + &slack);
    assert!(inside(&high, &low).is_none() && inside(&low, &low.clone()).is_none());
}

#[test]
fn twelve_digits_are_kept() {
    assert_eq!(rounded_down(&ratio(2, 3)), q("0.666666666666"));
    assert_eq!(rounded_down(&ratio(200, 3)), q("66.6666666666"));
    assert_eq!(rounded_down(&q("0.5")), q("0.5"));
}

proptest! {
    #[test]
    fn short_heights_stay_inside_and_lose_a_hundredth(low in 0..1_000_000_i64, width in 1..1_000_000_i64, by in 1..1_000_000_i64) {
        let (low, high) = (ratio(low, by), ratio(low + width, by));
        let (height, tolerance) = short(&low, &high);
        prop_assert!(&height - &tolerance > low && &height + &tolerance < high);
        prop_assert!(&tolerance * ratio(200, 99) >= &high - &low);
        // no decimals that the width has no use for
        let finest = Q::from(Z::from(10).pow(decimals(&height).max(decimals(&tolerance)))).recip();
        prop_assert!(finest == ratio(1, 1) || finest * ratio(10_000, 1) >= &high - &low);
    }
}
