//! Decimal views of exact numbers, rounded towards the side that keeps a statement true.

use crate::answer::{Arc, Interval};
use crate::exact::{Algebraic, Q, Z, from_float_exact, to_f64};
use num_traits::{One as _, Signed as _, ToPrimitive as _, Zero as _};

/// What a decimal view of an interval can say without saying too much.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Span {
    /// One value only, or an interval too narrow to show; the nearest decimal.
    Single(String),
    /// Both ends rounded inward: every value between them is allowed, ends included.
    Between(String, String),
}

/// The distances from an edge's first vertex that `interval` allows; `length2` is the edge's squared length.
pub(super) fn along_edge(length2: &Q, interval: &Interval) -> Span {
    let [from, to] = &interval.s;
    let width = to_f64(&(to - from)) * to_f64(length2).sqrt();
    let Some(step) = Step::hundredth_of(width) else {
        return Span::Single(near(to_f64(from) * to_f64(length2).sqrt(), 6));
    };
    let low = step.root_above(&(from * from * length2), interval.closed[0]);
    let high = step.root_below(&(to * to * length2), interval.closed[1]);
    Span::Between(step.show(&low), step.show(&high))
}

/// A distance along an edge near `s` with as many places as [`along_edge`] gives the ends of `interval`.
pub(super) fn place_on_edge(length2: &Q, interval: &Interval, s: &Q) -> String {
    let length = to_f64(length2).sqrt();
    match Step::hundredth_of(to_f64(&(&interval.s[1] - &interval.s[0])) * length) {
        Some(step) => step.show(&step.root_below(&(s * s * length2), true)),
        None => near(to_f64(s) * length, 6),
    }
}

/// The directions of an arc in degrees, counter-clockwise from the x axis.
pub(super) fn degrees(arc: &Arc) -> Span {
    let (start, sweep) = (angle(&arc.from), sweep(arc));
    let Some(step) = (sweep > 1e-9).then(|| Step::hundredth_of(sweep).map(|step| step.at_most(-1))).flatten() else {
        return Span::Single(near(start, 6));
    };
    let low = step.inside(start, is_exact(&arc.from), arc.closed[0], 1.0);
    let high = step.inside(start + sweep, is_exact(&arc.to), arc.closed[1], -1.0);
    Span::Between(step.show(&low), step.show(&high))
}

/// Degrees of a direction, in (-180, 180].
pub(super) fn angle(direction: &[Z; 2]) -> f64 {
    let excess = direction.iter().map(Z::bits).max().unwrap_or(0).saturating_sub(1000);
    let [x, y] = direction.each_ref().map(|v| (v >> excess).to_f64().unwrap_or(0.0));
    y.atan2(x).to_degrees()
}

/// Degrees from the first to the last direction of an arc, counter-clockwise; 360 for all directions but one.
pub(super) fn sweep(arc: &Arc) -> f64 {
    if arc.from == arc.to {
        return if arc.closed == [true, true] { 0.0 } else { 360.0 };
    }
    (angle(&arc.to) - angle(&arc.from)).rem_euclid(360.0)
}

/// A certified lower bound of `sqrt(square)` in percent, with three digits.
pub(super) fn percent_at_least(square: &Q) -> String {
    root_at_least(&(square * Q::from(Z::from(10_000))))
}

/// A certified lower bound of `sqrt(square)` with three digits.
pub(super) fn root_at_least(square: &Q) -> String {
    match Step::hundredth_of(to_f64(square).sqrt()) {
        Some(step) => step.show(&step.root_below(square, true)),
        None => "0".to_owned(),
    }
}

/// Radians in degrees, rounded down to three digits; `square` is that of the angle.
pub(super) fn degrees_at_least(square: &Q) -> String {
    // (180 / π)² = 3282.80635...
    root_at_least(&(square * Q::new(Z::from(328_280), Z::from(100))))
}

/// The angle whose sine is `sqrt(square)` in degrees, rounded down to three digits.
pub(super) fn arcsine_at_least(square: &Q) -> String {
    let angle = to_f64(square).sqrt().min(1.0).asin().to_degrees();
    // the squares whose angles have a rational number of degrees (Niven)
    let is_exact = (square * Q::from(Z::from(4))).is_integer();
    match Step::hundredth_of(angle) {
        Some(step) => step.show(&step.inside(angle, is_exact, true, -1.0)),
        None => "0".to_owned(),
    }
}

/// A factor in percent, rounded down to three digits; below it if `at` is false.
pub(super) fn percent_up_to(factor: &Algebraic, at: bool) -> String {
    let near = factor.to_f64() * 100.0;
    let Some(step) = Step::hundredth_of(near) else { return "0".to_owned() };
    let [low, high] =
        factor.enclosure(&(from_float_exact(near).unwrap_or_default() * Q::new(Z::one(), Z::from(1 << 30))));
    let percent = &low * Q::from(Z::from(100));
    step.show(&step.root_below(&(&percent * &percent), at || low < high))
}

/// A share in percent, three digits, never rounded to 0 or 100 unless it is.
pub(super) fn percent(share: &Q) -> String {
    let percent = to_f64(share) * 100.0;
    if percent < 0.01 && share.is_positive() {
        "less than 0.01".to_owned()
    } else if percent > 99.99 && share < &Q::one() {
        "more than 99.99".to_owned()
    } else {
        near(percent, 3)
    }
}

/// The nearest decimal with `digits` significant digits, without trailing zeros.
pub(super) fn near(value: f64, digits: i32) -> String {
    if value == 0.0 || !value.is_finite() {
        return "0".to_owned();
    }
    let magnitude = value.abs().log10().floor() as i32;
    if !(-6..12).contains(&magnitude) {
        return format!("{value:.*e}", usize::try_from(digits - 1).unwrap_or(0));
    }
    let places = usize::try_from(digits - 1 - magnitude).unwrap_or(0);
    trim(format!("{value:.places$}"))
}

/// A time in the unit that suits it.
pub(super) fn duration(seconds: f64) -> String {
    let (unit, name) = match seconds {
        s if s < 1e-6 => (1e-9, "ns"),
        s if s < 1e-3 => (1e-6, "µs"),
        s if s < 1.0 => (1e-3, "ms"),
        _ => (1.0, "s"),
    };
    format!("{} {name}", near(seconds / unit, 3))
}

/// A share of a count, in percent; none and all are told from nearly none and nearly all.
pub(super) fn percent_of(part: u64, of: u64) -> String {
    let share = 100.0 * part as f64 / (of as f64).max(1.0);
    let whole = share.round();
    if (whole > 0.0 && whole < 100.0) || part == 0 || part == of {
        format!("{whole} %")
    } else {
        match share {
            share if share > 99.99 => "more than 99.99 %".to_owned(),
            share if whole > 0.0 => format!("{} %", near(share, 4)),
            share => format!("{} %", near(share, 2)),
        }
    }
}

/// A number exactly when that is short, else the nearest decimal.
pub(super) fn brief(value: &Q) -> String {
    let exact = value.to_string();
    let decimal = near(to_f64(value), 6);
    if crate::exact::parse_literal(&decimal).as_ref() == Ok(value) {
        decimal
    } else if exact.len() <= 9 {
        exact
    } else {
        decimal
    }
}

/// A power of ten whose multiples are shown.
#[derive(Clone, Copy)]
pub(super) struct Step {
    exponent: i32,
}

impl Step {
    /// The largest step that is at most a hundredth of `width`; `None` where doubles cannot tell.
    pub(super) fn hundredth_of(width: f64) -> Option<Self> {
        (width > 1e-290 && width.is_finite()).then(|| Self { exponent: width.log10().floor() as i32 - 2 })
    }

    fn at_most(self, exponent: i32) -> Self {
        Self { exponent: self.exponent.min(exponent) }
    }

    pub(super) fn size(self) -> Q {
        let power = Q::from(Z::from(10).pow(self.exponent.unsigned_abs()));
        if self.exponent < 0 { power.recip() } else { power }
    }

    /// The largest multiple at most `sqrt(square)`, or below it if `at` is false.
    fn root_below(self, square: &Q, at: bool) -> Z {
        let scaled = square / (self.size() * self.size());
        let root = scaled.floor().to_integer().sqrt();
        if !at && Q::from(&root * &root) == scaled { root - 1 } else { root }
    }

    /// The smallest multiple at least `sqrt(square)`, or above it if `at` is false.
    fn root_above(self, square: &Q, at: bool) -> Z {
        let scaled = square / (self.size() * self.size());
        let root = scaled.floor().to_integer().sqrt();
        if at && Q::from(&root * &root) == scaled { root } else { root + 1 }
    }

    /// The first multiple from `value` on in the direction `inward`; a value that is not `exact` may be off by an ulp.
    fn inside(self, value: f64, exact: bool, closed: bool, inward: f64) -> Z {
        let scaled = value * 10_f64.powi(-self.exponent);
        let nearest = scaled.round();
        let steps = if (scaled - nearest).abs() > 1e-6 {
            if inward > 0.0 { scaled.ceil() } else { scaled.floor() }
        } else if exact && closed {
            nearest
        } else {
            nearest + inward
        };
        Z::from(steps as i64)
    }

    pub(super) fn show(self, multiple: &Z) -> String {
        let Ok(places) = usize::try_from(-self.exponent) else {
            return (multiple * Z::from(10).pow(self.exponent.unsigned_abs())).to_string();
        };
        let digits = format!("{:0>width$}", multiple.magnitude(), width = places + 1);
        let (whole, fraction) = digits.split_at(digits.len() - places);
        let sign = if multiple.is_negative() { "-" } else { "" };
        if places == 0 { format!("{sign}{whole}") } else { trim(format!("{sign}{whole}.{fraction}")) }
    }
}

/// A direction with integer coordinates has a rational number of degrees only at multiples of 45 (Niven).
fn is_exact(direction: &[Z; 2]) -> bool {
    let [x, y] = direction;
    x.is_zero() || y.is_zero() || x.abs() == y.abs()
}

fn trim(text: String) -> String {
    let text = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::{Polynomial, parse_literal, ratio};

    fn interval(from: Q, to: Q, closed: [bool; 2]) -> Interval {
        let origin = || [ratio(0, 1), ratio(0, 1)];
        Interval { s: [from, to], closed, points: [origin(), origin()] }
    }

    fn between(low: &str, high: &str) -> Span {
        Span::Between(low.to_owned(), high.to_owned())
    }

    #[test]
    fn distances_along_an_edge_are_rounded_inward() {
        // sqrt(2) / 3 = 0.47140..., 2 sqrt(2) / 3 = 0.94280...
        let third = interval(ratio(1, 3), ratio(2, 3), [true, true]);
        assert_eq!(along_edge(&ratio(2, 1), &third), between("0.472", "0.942"));
    }

    #[test]
    fn an_open_end_is_never_shown_as_allowed() {
        let open = interval(ratio(0, 1), ratio(1, 2), [false, false]);
        assert_eq!(along_edge(&ratio(100, 1), &open), between("0.01", "4.99"));
        let closed = interval(ratio(0, 1), ratio(1, 2), [true, true]);
        assert_eq!(along_edge(&ratio(100, 1), &closed), between("0", "5"));
    }

    #[test]
    fn narrow_intervals_get_more_digits_instead_of_crossing() {
        let narrow = interval(parse_literal("0.5").unwrap(), parse_literal("0.500001").unwrap(), [false, true]);
        assert_eq!(along_edge(&ratio(3, 1), &narrow), between("0.86602541", "0.86602713"));
    }

    #[test]
    fn a_single_place_is_shown_as_one() {
        let single = interval(ratio(2, 3), ratio(2, 3), [true, true]);
        assert_eq!(along_edge(&ratio(36, 1), &single), Span::Single("4".to_owned()));
    }

    #[test]
    fn every_shown_place_lies_in_its_interval() {
        for numerator in 1..60_i64 {
            for length2 in [2, 3, 4, 85, 1_000_003] {
                let (from, to) = (ratio(numerator, 97), ratio(numerator + 1 + numerator % 7, 97));
                let range = interval(from.clone(), to.clone(), [false, false]);
                let length2 = ratio(length2, 1);
                let Span::Between(low, high) = along_edge(&length2, &range) else { panic!("wide enough to show") };
                let (low, high) = (parse_literal(&low).unwrap(), parse_literal(&high).unwrap());
                assert!(&low * &low > &from * &from * &length2 && &high * &high < &to * &to * &length2 && low < high);
                let middle = (&from + &to) / ratio(2, 1);
                let shown = parse_literal(&place_on_edge(&length2, &range, &middle)).unwrap();
                assert!(low <= shown && shown <= high);
            }
        }
    }

    #[test]
    fn degrees_are_rounded_inward_and_exact_at_the_axes() {
        let arc = |from: [i64; 2], to: [i64; 2], closed| Arc { from: from.map(Z::from), to: to.map(Z::from), closed };
        // atan2(-7, -1) = -98.130..., atan2(-7, 1) = -81.869...
        assert_eq!(degrees(&arc([-1, -7], [1, -7], [false, false])), between("-98.1", "-81.9"));
        assert_eq!(degrees(&arc([1, 0], [0, 1], [true, true])), between("0", "90"));
        assert_eq!(degrees(&arc([1, 0], [0, 1], [false, false])), between("0.1", "89.9"));
        assert_eq!(degrees(&arc([0, 1], [0, -1], [true, false])), between("90", "269.9"));
        assert_eq!(degrees(&arc([1, 1], [1, 1], [true, true])), Span::Single("45".to_owned()));
    }

    #[test]
    fn margins_are_lower_bounds() {
        assert_eq!(percent_at_least(&ratio(1, 50)), "14.1");
        assert_eq!(percent_at_least(&ratio(1, 4)), "50");
        assert_eq!(percent_at_least(&ratio(0, 1)), "0");
        // 180 / 2π = 28.647..., asin(1/3) = 19.471...
        assert_eq!(degrees_at_least(&ratio(1, 4)), "28.6");
        assert_eq!(arcsine_at_least(&ratio(1, 9)), "19.4");
        let angles = [(0, "0"), (1, "30"), (2, "45"), (3, "60"), (4, "90")];
        for (quarters, angle) in angles {
            assert_eq!(arcsine_at_least(&ratio(quarters, 4)), angle);
        }
    }

    #[test]
    fn factors_in_percent_are_rounded_down() {
        let golden = Polynomial::from([-1, -1, 1]).real_roots(ratio(0, 1)..).unwrap().remove(0);
        assert_eq!(percent_up_to(&golden, false), "161");
        assert_eq!(percent_up_to(&ratio(1, 3).into(), true), "33.3");
        assert_eq!(percent_up_to(&ratio(5, 1).into(), true), "500");
        assert_eq!(percent_up_to(&ratio(5, 1).into(), false), "499");
        assert_eq!(percent_up_to(&ratio(0, 1).into(), true), "0");
    }

    #[test]
    fn shares_do_not_round_to_nothing_or_everything() {
        assert_eq!(percent(&ratio(1, 1_000_000)), "less than 0.01");
        assert_eq!(percent(&ratio(999_999, 1_000_000)), "more than 99.99");
        assert_eq!(percent(&ratio(0, 1)), "0");
        assert_eq!(percent(&ratio(1, 28)), "3.57");
        assert_eq!(percent(&ratio(1, 1)), "100");
    }

    #[test]
    fn brief_numbers_are_exact_when_they_can_be() {
        assert_eq!(brief(&ratio(1, 5)), "0.2");
        assert_eq!(brief(&ratio(-4, 3)), "-4/3");
        assert_eq!(brief(&ratio(1_234_567, 891_011)), "1.38558");
        assert_eq!(brief(&ratio(12_000, 1)), "12000");
    }

    #[test]
    fn times_and_shares_have_their_units() {
        assert_eq!([2.5e-9, 1e-6, 0.5, 90.0].map(duration), ["2.5 ns", "1 µs", "500 ms", "90 s"]);
        let shares = [(0, 300), (1, 300), (1, 2), (299, 300), (300, 300), (0, 0), (999_999, 1_000_000)]
            .map(|(part, of)| percent_of(part, of));
        assert_eq!(shares, ["0 %", "0.33 %", "50 %", "99.67 %", "100 %", "0 %", "more than 99.99 %"]);
    }
}
