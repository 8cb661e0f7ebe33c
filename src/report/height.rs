//! Decimal views of heights of pins: what they show as safe is safe.

use super::decimal::{Span, Step, brief, near};
use crate::exact::{Algebraic, Q, Z, to_f64};
use num_traits::Signed as _;

/// The heights strictly between two, both ends rounded inward: every height between them is, ends included.
pub(super) fn between(low: &Algebraic, high: &Algebraic) -> Span {
    let steps =
        Step::hundredth_of(high.to_f64() - low.to_f64()).map(|step| (step, above(low, step), below(high, step)));
    match steps {
        Some((step, low, high)) if low < high => Span::Between(step.show(&low), step.show(&high)),
        _ => Span::Single(near(low.to_f64(), 12)),
    }
}

/// A height above `low`, near it.
pub(super) fn beyond(low: &Algebraic) -> String {
    Step::hundredth_of(low.to_f64() / 10.0).map_or_else(|| "0".to_owned(), |step| step.show(&above(low, step)))
}

/// A height and how far it may be off: what is shown lies within `tolerance` of `height`.
pub(super) fn with_tolerance(height: &Q, tolerance: &Q) -> [String; 2] {
    let Some(step) = Step::hundredth_of(to_f64(tolerance)) else { return [brief(height), "0".to_owned()] };
    let shown = (height / step.size()).round();
    let left = tolerance / step.size() - (height / step.size() - &shown).abs();
    [step.show(&shown.to_integer()), step.show(&left.floor().to_integer())]
}

/// The first multiple above `low`; the next one if the first is too close to tell.
fn above(low: &Algebraic, step: Step) -> Z {
    let [_, upper] = low.enclosure(&closeness(step));
    (upper / step.size()).floor().to_integer() + 1
}

/// The last multiple below `high`; the one before if the last is too close to tell.
fn below(high: &Algebraic, step: Step) -> Z {
    let [lower, _] = high.enclosure(&closeness(step));
    (lower / step.size()).ceil().to_integer() - 1
}

fn closeness(step: Step) -> Q {
    step.size() / Q::from(Z::from(1_000))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::{Polynomial, parse_literal, ratio};
    use proptest::prelude::*;

    fn root_of(square: i64) -> Algebraic {
        Polynomial::from([-square, 0, 1]).real_roots(ratio(0, 1)..).unwrap().remove(0)
    }

    fn ends(span: Span) -> [Q; 2] {
        let Span::Between(low, high) = span else { panic!("wide enough to show: {span:?}") };
        [low, high].map(|end| parse_literal(&end).unwrap())
    }

    #[test]
    fn ends_are_left_out_and_rounded_inward() {
        // 2.828427... and 3
        assert_eq!(between(&root_of(8), &ratio(3, 1).into()), Span::Between("2.829".into(), "2.999".into()));
        assert_eq!(between(&ratio(0, 1).into(), &ratio(7, 1).into()), Span::Between("0.01".into(), "6.99".into()));
        assert_eq!(beyond(&root_of(72)), "8.486");
        assert_eq!(beyond(&ratio(7, 1).into()), "7.001");
        assert_eq!(beyond(&ratio(0, 1).into()), "0");
    }

    #[test]
    fn ends_that_nothing_fits_between_are_one_place() {
        let end: Algebraic = ratio(1, 3).into();
        assert_eq!(between(&end, &end), Span::Single("0.333333333333".into()));
    }

    proptest! {
        #[test]
        fn what_is_shown_lies_between(a in 1_i64..4_000_000, width in 1_i64..10_000) {
            let (low, high) = (root_of(a), root_of(a + width));
            let [first, last] = ends(between(&low, &high));
            prop_assert!(low < first && first < last && high > last);
            let wide = ends(between(&low, &Algebraic::from(&last + ratio(1, 1))));
            prop_assert!(low < wide[0] && wide[1] < &last + ratio(1, 1));
            prop_assert!(low < parse_literal(&beyond(&low)).unwrap());
        }

        #[test]
        fn a_shown_height_keeps_within_its_tolerance(height in 1_i64..1_000_000, of in 1_i64..9_999, tolerance in 1_i64..1_000, per in 1_i64..99_999) {
            let (height, tolerance) = (ratio(height, of), ratio(tolerance, per));
            let [shown, off] = with_tolerance(&height, &tolerance).map(|text| parse_literal(&text).unwrap());
            prop_assert!(&shown - &off >= &height - &tolerance && &shown + &off <= &height + &tolerance);
            prop_assert!(off > &tolerance * ratio(9, 10));
        }
    }
}
