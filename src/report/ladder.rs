//! How far the automatic choice of a model is from the cheapest that would have done.

use super::decimal::{duration, near};
use crate::answer::{Chart, ChartFamily, ChartPoint};

/// What a table of automatic choices tells.
pub(super) const HEADINGS: [&str; 6] = [
    "scene",
    "choice",
    "error (m)",
    "time",
    "over the cheapest rung as accurate",
    "over the cheapest within the tolerance",
];

/// An automatic choice beside the rungs of the ladder at fixed steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct LadderRow<'a> {
    /// The automatic choice.
    pub(super) auto: &'a ChartPoint,
    /// The cheapest point of a rung with an error no larger than that of the choice.
    pub(super) envelope: Option<&'a ChartPoint>,
    /// The cheapest point of a rung within the tolerance of the choice.
    pub(super) enough: Option<&'a ChartPoint>,
}

impl LadderRow<'_> {
    /// Time of the choice over that of a point.
    pub(super) fn ratio(&self, to: Option<&ChartPoint>) -> Option<f64> {
        to.map(|point| self.auto.time[1] / point.time[1])
    }

    /// The cells of a table under [`HEADINGS`].
    pub(super) fn cells(&self) -> [String; 6] {
        let ChartPoint { work, setting, error, time, .. } = self.auto;
        let beside = |to: Option<&ChartPoint>| match (to, self.ratio(to)) {
            (Some(point), Some(ratio)) => format!("{} ({}, {})", near(ratio, 2), point.method, point.setting),
            _ => "no rung is".to_owned(),
        };
        let error = error.map_or_else(|| "none".to_owned(), |error| near(error, 2));
        [work.clone(), setting.clone(), error, duration(time[1]), beside(self.envelope), beside(self.enough)]
    }
}

/// A row for each automatic choice, in order.
pub(super) fn rows(chart: &Chart) -> Vec<LadderRow<'_>> {
    let points = || chart.points.iter().filter(|point| point.family == ChartFamily::Ladder);
    let autos = points().filter(|point| point.method == "auto");
    let row = |auto: &'_ ChartPoint| -> (f64, f64) {
        let error = auto.error.unwrap_or(f64::INFINITY);
        // where both are right to rounding neither is nearer
        (error.max(ROUNDING), tolerance(auto).unwrap_or(error).max(error))
    };
    autos
        .map(|auto| {
            let rungs =
                || points().filter(|point| point.work == auto.work && point.method != "auto" && point.failed == 0);
            let cheapest = |most: f64| {
                let good = rungs().filter(|point| point.error.is_some_and(|error| error <= most));
                good.min_by(|a, b| a.time[1].total_cmp(&b.time[1]))
            };
            let (error, tolerance) = row(auto);
            LadderRow { auto, envelope: cheapest(error), enough: cheapest(tolerance) }
        })
        .collect()
}

/// An error that is rounding (m).
const ROUNDING: f64 = 1e-12;

/// The tolerance that the setting of a choice names.
fn tolerance(auto: &ChartPoint) -> Option<f64> {
    auto.setting.strip_prefix("tolerance ")?.split(':').next()?.parse().ok()
}
