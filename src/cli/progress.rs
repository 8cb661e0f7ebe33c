//! A bar on standard error while a search or a run goes on; nothing where standard error is no terminal.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use partplan::chart::{self, ChartProgress};
use partplan::planner::{Progress, Stage, ThrowProgress, ThrowStage};

/// Shows where a search stands, stage by stage.
#[derive(Debug, Clone)]
pub struct Bar(ProgressBar);

impl Bar {
    /// An empty bar.
    pub fn new() -> Self {
        let style = ProgressStyle::with_template("{msg:10} {bar:40} {pos} of {len}, {eta} left")
            .expect("the template has balanced braces");
        Self(ProgressBar::with_draw_target(Some(0), ProgressDrawTarget::stderr()).with_style(style))
    }

    /// Shows a step of a search for places.
    pub fn show(&self, progress: &Progress) {
        let stage = match progress.stage {
            Stage::Survey => "estimating",
            Stage::Plan => "planning",
            Stage::Friction => "friction",
        };
        self.set(stage, progress.done, progress.of);
    }

    /// Shows a step of planning throws.
    pub fn show_throws(&self, progress: &ThrowProgress) {
        let stage = match progress.stage {
            ThrowStage::Orbits => "throwing",
            ThrowStage::Proof => "proving",
            ThrowStage::Sweep => "settings",
        };
        self.set(stage, progress.done, progress.of);
    }

    /// Shows how many runs have ended.
    pub fn show_runs(&self, done: u64, of: u64) {
        self.set("verifying", usize::try_from(done).unwrap_or(usize::MAX), usize::try_from(of).unwrap_or(usize::MAX));
    }

    /// Shows how many designs have been evaluated, and the best cost.
    pub fn show_search(&self, done: usize, of: usize, best: f64) {
        if self.0.length() != Some(of as u64) {
            self.0.set_length(of as u64);
        }
        self.0.set_message(format!("cost {best:.3}"));
        self.0.set_position(done as u64);
    }

    /// Shows which part of a chart is measured.
    pub fn show_chart(&self, progress: &ChartProgress) {
        let parts = chart::parts();
        let done = parts.iter().position(|part| *part == progress.part).unwrap_or(parts.len());
        self.set(progress.part, done, parts.len());
    }

    fn set(&self, stage: &'static str, done: usize, of: usize) {
        if self.0.message() != stage {
            self.0.set_message(stage);
            self.0.reset();
        }
        self.0.set_length(of as u64);
        self.0.set_position(done as u64);
    }

    /// Removes the bar.
    pub fn clear(&self) {
        self.0.finish_and_clear();
    }
}

/// Shows how far a run is.
#[derive(Debug, Clone)]
pub struct Clock {
    bar: ProgressBar,
    duration: f64,
}

impl Clock {
    /// Parts of a run that are told apart.
    const PARTS: u64 = 1000;

    /// A bar for a run of `duration` seconds.
    pub fn new(duration: f64) -> Self {
        let style =
            ProgressStyle::with_template("{msg:20} {bar:40} {eta} left").expect("the template has balanced braces");
        let bar = ProgressBar::with_draw_target(Some(Self::PARTS), ProgressDrawTarget::stderr()).with_style(style);
        Self { bar, duration }
    }

    /// Shows the time reached (s).
    pub fn show(&self, time: f64) {
        // a step may be far shorter than what can be seen
        let part = (time / self.duration * Self::PARTS as f64) as u64;
        if part != self.bar.position() {
            self.bar.set_position(part);
            self.bar.set_message(format!("{time:.3} of {} s", self.duration));
        }
    }

    /// Removes the bar.
    pub fn clear(&self) {
        self.bar.finish_and_clear();
    }
}
