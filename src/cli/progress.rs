//! A bar on standard error while a search goes on; nothing where standard error is no terminal.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use partplan::planner::{Progress, Stage};

/// Shows where a search of places stands.
#[derive(Debug, Clone)]
pub struct Bar(ProgressBar);

impl Bar {
    /// An empty bar.
    pub fn new() -> Self {
        let style = ProgressStyle::with_template("{msg:10} {bar:40} {pos} of {len}, {eta} left")
            .expect("the template has balanced braces");
        Self(ProgressBar::with_draw_target(Some(0), ProgressDrawTarget::stderr()).with_style(style))
    }

    /// Shows a step.
    pub fn show(&self, progress: &Progress) {
        let stage = match progress.stage {
            Stage::Survey => "estimating",
            Stage::Plan => "planning",
            Stage::Friction => "friction",
        };
        if self.0.message() != stage {
            self.0.set_message(stage);
            self.0.reset();
        }
        self.0.set_length(progress.of as u64);
        self.0.set_position(progress.done as u64);
    }

    /// Removes the bar.
    pub fn clear(&self) {
        self.0.finish_and_clear();
    }
}
