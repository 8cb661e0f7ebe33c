//! When a run ends early: at a limit, or on Ctrl-C.

use super::failure::INTERRUPTED;
use super::limit::Limits;
use partplan::answer::Limit;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

/// Memory is read once in so many questions.
const SELDOM: u64 = 1 << 10;

/// Why a run ended early.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reason {
    /// A limit.
    Limit(Limit),
    /// Ctrl-C.
    Interrupt,
}

/// Watches over a run.
pub struct Stop {
    limits: Limits,
    start: Instant,
    interrupted: Arc<AtomicBool>,
    asked: u64,
    reason: Option<Reason>,
}

impl Stop {
    /// Starts the clock; from now on Ctrl-C ends the run, and once more the process.
    pub fn new(limits: Limits) -> Self {
        let interrupted = Arc::new(AtomicBool::new(false));
        let flag = Arc::clone(&interrupted);
        // without a handler Ctrl-C ends the process at once
        let _ = ctrlc::set_handler(move || {
            if flag.swap(true, Ordering::Relaxed) {
                std::process::exit(INTERRUPTED.into());
            }
        });
        Self { limits, start: Instant::now(), interrupted, asked: 0, reason: None }
    }

    /// Whether the run goes on.
    pub fn goes_on(&mut self) -> bool {
        self.asked += 1;
        self.reason = if self.interrupted.load(Ordering::Relaxed) {
            Some(Reason::Interrupt)
        } else if self.start.elapsed() >= self.limits.time {
            Some(Reason::Limit(Limit::Time))
        } else if self.asked.is_multiple_of(SELDOM) && self.limits.is_memory_over() {
            Some(Reason::Limit(Limit::Memory))
        } else {
            None
        };
        self.reason.is_none()
    }

    /// Why it did not.
    pub fn reason(&self) -> Option<Reason> {
        self.reason
    }

    /// That in words.
    pub fn note(&self) -> Option<String> {
        Some(match self.reason? {
            Reason::Interrupt => "interrupted".to_owned(),
            Reason::Limit(Limit::Time) => {
                format!("the time limit of {} s was reached; --time-limit allows more", self.limits.time.as_secs_f64())
            }
            Reason::Limit(Limit::Memory) => {
                format!("the memory limit of {} was reached; --memory-limit allows more", self.limits.memory)
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use bytesize::ByteSize;
    use std::time::Duration;

    #[test]
    fn a_run_ends_at_the_first_limit() {
        let stop = |time, memory| Stop::new(Limits { time, memory });
        let (hour, much) = (Duration::from_secs(3_600), ByteSize::gib(1 << 20));
        let mut free = stop(hour, much);
        assert!((0..3 * SELDOM).all(|_| free.goes_on()) && free.note().is_none());
        let mut late = stop(Duration::ZERO, much);
        assert!(!late.goes_on());
        assert_eq!(late.reason(), Some(Reason::Limit(Limit::Time)));
        let mut large = stop(hour, ByteSize::kib(1));
        assert!((0..3 * SELDOM).any(|_| !large.goes_on()));
        assert!(large.note().is_some_and(|note| note.contains("--memory-limit")));
        let mut interrupted = stop(hour, much);
        interrupted.interrupted.store(true, Ordering::Relaxed);
        assert!(!interrupted.goes_on());
        assert_eq!(interrupted.reason(), Some(Reason::Interrupt));
    }
}
