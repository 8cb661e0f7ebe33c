//! Logarithmic axes.

use crate::report::decimal::duration;

/// A range of positive numbers, spread evenly by their logarithms.
#[derive(Debug, Clone, Copy)]
pub(super) struct Logarithmic {
    low: f64,
    high: f64,
}

/// Around the numbers shown, in decades, and over their range.
const SPARE: f64 = 0.18;
const SPARE_SHARE: f64 = 0.12;

/// Narrowest range, in decades.
const LEAST: f64 = 1.0;

/// Most decades with a tick each.
const MOST_TICKS: f64 = 8.0;

impl Logarithmic {
    /// A range that holds these, those that are not positive and finite left out; `None` if none are.
    pub(super) fn around(values: impl Iterator<Item = f64>) -> Option<Self> {
        let logarithms = values.filter(|value| *value > 0.0 && value.is_finite()).map(f64::log10);
        let (low, high) =
            logarithms.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
        let spare = SPARE.max(SPARE_SHARE * (high - low)).max(0.5 * (LEAST - (high - low)));
        (low <= high).then_some(Self { low: low - spare, high: high + spare })
    }

    /// Where a positive number lies, from 0 to 1.
    pub(super) fn place(&self, value: f64) -> f64 {
        ((value.max(f64::MIN_POSITIVE).log10() - self.low) / (self.high - self.low)).clamp(0.0, 1.0)
    }

    /// Numbers with ticks: powers of ten, or where these are few also twice and five times them.
    pub(super) fn ticks(&self) -> Vec<f64> {
        let stride = ((self.high - self.low) / MOST_TICKS).ceil().max(1.0) as usize;
        let decades = (self.low.floor() as i32..=self.high.ceil() as i32).step_by(stride);
        let factors: &[f64] = if self.high - self.low < 2.0 { &[1.0, 2.0, 5.0] } else { &[1.0] };
        let ticks = decades.flat_map(|decade| factors.iter().map(move |factor| factor * 10_f64.powi(decade)));
        ticks.filter(|tick| (self.low..=self.high).contains(&tick.log10())).collect()
    }
}

/// A time as a tick names it.
pub(super) fn time(seconds: f64) -> String {
    duration(seconds * (1.0 + 1e-12))
}

/// A number as a tick names it: 0.1, or 2·10⁻⁷.
pub(super) fn plain(value: f64) -> String {
    let decade = (value.log10() + 1e-9).floor();
    let factor = (value / 10_f64.powf(decade)).round();
    if (-2.0..4.0).contains(&decade) {
        return format!("{:.*}", (-decade).max(0.0) as usize, factor * 10_f64.powf(decade));
    }
    let decade = format!("{decade}");
    let digits = decade.chars().map(|digit| match digit {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        digit => char::from_u32('⁰' as u32 + digit.to_digit(10).unwrap_or(0)).unwrap_or(digit),
    });
    let power = format!("10{}", digits.collect::<String>());
    if factor == 1.0 { power } else { format!("{factor}·{power}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_read_at_a_glance() {
        let axis = Logarithmic::around([1e-6, 1e-3].into_iter()).unwrap();
        assert_eq!(axis.ticks().into_iter().map(time).collect::<Vec<_>>(), ["1 µs", "10 µs", "100 µs", "1 ms"]);
        let names = [1e-7, 2e-12, 0.05, 100.0, 1e10].map(plain);
        assert_eq!(names, ["10⁻⁷", "2·10⁻¹²", "0.05", "100", "10¹⁰"]);
    }

    #[test]
    fn odd_ranges_have_an_axis() {
        assert!(Logarithmic::around([0.0, -1.0, f64::NAN, f64::INFINITY].into_iter()).is_none());
        let one = Logarithmic::around([5.0].into_iter()).unwrap();
        assert!((one.place(5.0) - 0.5).abs() < 1e-9);
        assert!(!one.ticks().is_empty());
        let wide = Logarithmic::around([1e-300, 1e300].into_iter()).unwrap();
        let places = [1e-300, 1.0, 1e300].map(|value| wide.place(value));
        assert!(wide.ticks().len() <= 10 && places.is_sorted() && places[0] > 0.0 && places[2] < 1.0, "{places:?}");
    }
}
