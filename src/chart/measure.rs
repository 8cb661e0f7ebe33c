//! Takes points and tiles down, and times what they are of.

use super::{ChartProgress, ChartQuestion};
use crate::answer::{Chart, ChartFamily, ChartMap, ChartPoint, ChartTile};
use cpu_time::ThreadTime;
use std::hint::black_box;

/// CPU time for a point (s), in a quick and in a whole chart.
const ENOUGH: [f64; 2] = [0.02, 0.2];

/// Fewest and most runs of a point, if they are not long.
const RUNS: [usize; 2] = [5, 101];

/// What is measured so far.
pub(super) struct Measure<'a> {
    pub(super) question: &'a ChartQuestion,
    watch: &'a dyn Fn(ChartProgress) -> bool,
    chart: Chart,
    is_stopped: bool,
}

/// A curve: a method on a piece of work.
#[derive(Debug, Clone, Copy)]
pub(super) struct Curve<'a> {
    pub(super) family: ChartFamily,
    pub(super) work: &'a str,
    pub(super) method: &'a str,
}

/// What runs of a method came to.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Outcome {
    pub(super) error: Option<f64>,
    pub(super) failed: u64,
    pub(super) of: u64,
}

impl<'a> Measure<'a> {
    pub(super) fn new(question: &'a ChartQuestion, watch: &'a dyn Fn(ChartProgress) -> bool) -> Self {
        Self { question, watch, chart: Chart::default(), is_stopped: false }
    }

    pub(super) fn into_chart(self) -> Chart {
        self.chart
    }

    /// One of two, for a quick and for a whole chart.
    pub(super) fn pick<T>(&self, quick: T, whole: T) -> T {
        if self.question.quick { quick } else { whole }
    }

    /// Whether something of these parts of an id is wanted, and there is time for it.
    pub(super) fn wants(&self, parts: &[&str]) -> bool {
        let id = parts.join("/");
        let is_wanted = match &self.question.only {
            None => true,
            Some(only) => id == *only || begins(&id, only) || begins(only, &id),
        };
        is_wanted && !self.is_stopped
    }

    /// Whether a map, or a family, is wanted at all.
    pub(super) fn wants_family(&self, family: ChartFamily) -> bool {
        self.wants(&[family.name()])
    }

    /// Asked on the way of long work whether to go on.
    pub(super) fn watch(&self, part: &'static str) -> impl Fn() -> bool + use<'a> {
        let (watch, done) = (self.watch, self.chart.points.len() + self.chart.tiles.len());
        move || watch(ChartProgress { done, part })
    }

    /// A point: `run` does all of its work once, asks on the way whether to go on, and says what came of it.
    pub(super) fn point(
        &mut self,
        curve: Curve,
        setting: &str,
        runs: u64,
        mut run: impl FnMut(&dyn Fn() -> bool) -> Outcome,
    ) {
        let Curve { family, work, method } = curve;
        if !self.wants(&[family.name(), work, method, setting]) || !self.goes_on(family.name()) {
            return;
        }
        let watch = self.watch(family.name());
        let outcome = run(&watch);
        let enough = self.pick(ENOUGH[0], ENOUGH[1]);
        let time = quartiles(enough, || {
            black_box(run(&watch));
        });
        // what was ended on its way says nothing
        if !self.goes_on(family.name()) {
            return;
        }
        self.chart.points.push(ChartPoint {
            family,
            work: work.to_owned(),
            method: method.to_owned(),
            setting: setting.to_owned(),
            // a run that blew up has none
            error: outcome.error.filter(|error| error.is_finite()),
            failed: outcome.failed,
            of: outcome.of,
            time: time.map(|time| time / runs.max(1) as f64),
            command: None,
        });
    }

    /// A tile: `run` says how many runs succeeded, had no single answer and said so, and failed.
    pub(super) fn tile(&mut self, map: ChartMap, method: &str, [x, y]: [f64; 2], run: impl FnOnce() -> [u64; 3]) {
        let mut tile = ChartTile { map, method: method.to_owned(), x, y, succeeded: 0, ambiguous: 0, failed: 0 };
        let id = tile.id();
        if !self.wants(&[&id]) || !self.goes_on(map.name()) {
            return;
        }
        [tile.succeeded, tile.ambiguous, tile.failed] = run();
        self.chart.tiles.push(tile);
    }

    pub(super) fn goes_on(&mut self, part: &'static str) -> bool {
        let done = self.chart.points.len() + self.chart.tiles.len();
        self.is_stopped = self.is_stopped || !(self.watch)(ChartProgress { done, part });
        !self.is_stopped
    }
}

/// Whether a name begins with another, up to a part's end.
fn begins(name: &str, with: &str) -> bool {
    name.strip_prefix(with).is_some_and(|rest| rest.starts_with('/') || with.ends_with('/'))
}

/// Lower quartile, median and upper quartile of the CPU time of runs that take about `enough` together (s).
fn quartiles(enough: f64, mut run: impl FnMut()) -> [f64; 3] {
    let (mut times, mut total) = (Vec::new(), 0.0);
    while times.len() < RUNS[1]
        && (total < enough || times.len() < RUNS[0])
        && (times.len() < 2 || total < 5.0 * enough)
    {
        let start = ThreadTime::now();
        run();
        let time = start.elapsed().as_secs_f64();
        total += time;
        times.push(time);
    }
    times.sort_by(f64::total_cmp);
    [1, 2, 3].map(|quarter| times[(times.len() - 1) * quarter / 4])
}
