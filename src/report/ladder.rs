//! How far the automatic choice of a model is from the cheapest that would have done.

use super::decimal::{duration, near, percent_of};
use crate::answer::{Chart, ChartFamily, ChartPoint};
use std::fmt::Write as _;

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
    /// The cheapest point of a rung with an error no larger than that of the choice; `None` too if it has no answer.
    pub(super) envelope: Option<&'a ChartPoint>,
    /// The cheapest point of a rung within the tolerance of the choice.
    pub(super) enough: Option<&'a ChartPoint>,
}

impl LadderRow<'_> {
    /// Time of the choice over that of a point; `None` for a point that took no time that can be measured.
    pub(super) fn ratio(&self, to: Option<&ChartPoint>) -> Option<f64> {
        to.map(|point| self.auto.time[1] / point.time[1]).filter(|ratio| ratio.is_finite())
    }

    /// The cells of a table under [`HEADINGS`].
    pub(super) fn cells(&self) -> [String; 6] {
        let ChartPoint { work, setting, error, failed, of, time, .. } = self.auto;
        let beside = |to: Option<&ChartPoint>| match (to, self.ratio(to)) {
            (Some(point), Some(ratio)) => format!("{} ({}, {})", near(ratio, 2), point.method, point.setting),
            (Some(point), None) => format!("no time measured ({}, {})", point.method, point.setting),
            (None, _) if error.is_none() => "-".to_owned(),
            (None, _) => "no rung is".to_owned(),
        };
        let mut error = error.map_or_else(|| "no answer".to_owned(), |error| near(error, 2));
        if *failed > 0 {
            let _ = write!(error, ", {} fail", percent_of(*failed, *of));
        }
        [work.clone(), setting.clone(), error, duration(time[1]), beside(self.envelope), beside(self.enough)]
    }
}

/// A row for each automatic choice, in order.
pub(super) fn rows(chart: &Chart) -> Vec<LadderRow<'_>> {
    let points = || chart.points.iter().filter(|point| point.family == ChartFamily::Ladder);
    let autos = points().filter(|point| point.method == "auto");
    let allowed = |auto: &ChartPoint, error: f64| {
        // where both are right to rounding neither is nearer
        [error.max(ROUNDING), tolerance(auto).unwrap_or(error).max(error)]
    };
    autos
        .map(|auto| {
            let rungs =
                || points().filter(|point| point.work == auto.work && point.method != "auto" && point.failed == 0);
            let cheapest = |most: f64| {
                let good = rungs().filter(|point| point.error.is_some_and(|error| error <= most));
                good.min_by(|a, b| a.time[1].total_cmp(&b.time[1]))
            };
            let [envelope, enough] = auto.error.map_or([None, None], |error| allowed(auto, error).map(cheapest));
            LadderRow { auto, envelope, enough }
        })
        .collect()
}

/// An error that is rounding (m).
const ROUNDING: f64 = 1e-12;

/// The tolerance that the setting of a choice names.
fn tolerance(auto: &ChartPoint) -> Option<f64> {
    auto.setting.strip_prefix("tolerance ")?.split(':').next()?.parse().ok()
}
