//! Planning within limits of time and memory.

use super::common::Fixtured;
use super::input::Task;
use super::output::Format;
use super::{Failure, Outcome, output};
use bytesize::ByteSize;
use partplan::answer::Limit;
use partplan::mechanics::{Mode, ModeError};
use partplan::model::{Fixture, Part};
use partplan::planner::Question;
use partplan::report::json;
use serde_json::Value;
use std::io::Write;
use std::panic::resume_unwind;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::{Duration, Instant};

/// What a run may spend.
#[derive(Debug, Clone, Copy, clap::Args)]
pub struct Limits {
    /// Longest time to look for an answer; exit status 3 when it is over
    #[arg(long = "time-limit", value_name = "SECONDS", default_value = "600", value_parser = seconds)]
    pub time: Duration,

    /// Most memory to look for an answer in; exit status 3 when more is in use
    #[arg(long = "memory-limit", value_name = "SIZE", default_value = "4GiB", value_parser = size)]
    pub memory: ByteSize,
}

/// How often the memory in use is read.
const WATCH: Duration = Duration::from_millis(10);

/// A planner: part, fixture and question to an answer.
type Planner<A> = fn(&Part, &Fixture, &Question) -> Result<A, ModeError>;

/// Runs `planner` on the task within the limits; `None` when one is reached, which is then said.
pub fn plan<A: Send + 'static>(
    task: &Task<Fixture>,
    args: &Fixtured,
    modes: &[Mode],
    planner: Planner<A>,
    schema: &str,
    out: &mut dyn Write,
) -> Result<Option<A>, Failure> {
    let (part, fixture, question) = (task.case.part.clone(), task.section.clone(), args.question(modes));
    match args.common.limits.within(move || planner(&part, &fixture, &question)) {
        Ok(answer) => Ok(Some(answer?)),
        Err(reached) => {
            let document = || json::undecided(&task.subject(), schema, reached);
            args.common.limits.say_reached(reached, args.common.format, document, out)?;
            Ok(None)
        }
    }
}

/// How a run without an answer ends.
pub const OVER: Outcome = Outcome::Undecided;

impl Limits {
    /// Runs `work` on a thread of its own and waits for it until a limit is reached; the process ends soon after.
    ///
    /// Where the system does not tell how much memory is in use, only the time is limited.
    pub fn within<T: Send + 'static>(&self, work: impl FnOnce() -> T + Send + 'static) -> Result<T, Limit> {
        let start = Instant::now();
        let (done, wait) = channel();
        let worker = thread::spawn(move || done.send(work()));
        loop {
            let left = self.time.saturating_sub(start.elapsed());
            match wait.recv_timeout(left.min(WATCH)) {
                Ok(answer) => return Ok(answer),
                Err(RecvTimeoutError::Timeout) if left <= WATCH => return Err(Limit::Time),
                Err(RecvTimeoutError::Timeout) if self.is_memory_over() => return Err(Limit::Memory),
                Err(RecvTimeoutError::Timeout) => {}
                Err(RecvTimeoutError::Disconnected) => match worker.join() {
                    Err(panic) => resume_unwind(panic),
                    Ok(_) => unreachable!("a worker that ends has sent its answer"),
                },
            }
        }
    }

    /// Says which limit was reached.
    pub fn say_reached(
        &self,
        reached: Limit,
        format: Format,
        document: impl FnOnce() -> Value,
        out: &mut dyn Write,
    ) -> Result<(), Failure> {
        let said = || match reached {
            Limit::Time => {
                format!("undecided: no answer within {} s; --time-limit allows more\n", self.time.as_secs_f64())
            }
            Limit::Memory => {
                format!("undecided: no answer within {} of memory; --memory-limit allows more\n", self.memory)
            }
        };
        output::answer(out, format, said, document)
    }

    /// Whether more memory is in use than allowed.
    pub fn is_memory_over(&self) -> bool {
        memory_stats::memory_stats().is_some_and(|stats| stats.physical_mem as u64 > self.memory.as_u64())
    }
}

/// Reads a time limit.
fn seconds(text: &str) -> Result<Duration, String> {
    let number: f64 = text.parse().map_err(|_| "expected a number of seconds, 0.5 or 60 for instance".to_owned())?;
    Duration::try_from_secs_f64(number).map_err(|_| "a time is not negative and not endless".to_owned())
}

/// Reads a size of memory.
fn size(text: &str) -> Result<ByteSize, String> {
    text.parse().map_err(|_| "expected a size, 500MB or 2GiB for instance".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn work_is_waited_for_until_the_limit() {
        let limits = |time| Limits { time, memory: ByteSize::gib(4) };
        assert_eq!(limits(Duration::from_secs(3_600)).within(|| 5), Ok(5));
        let asleep = || thread::sleep(Duration::from_secs(3_600));
        assert_eq!(limits(Duration::from_millis(1)).within(asleep), Err(Limit::Time));
        assert_eq!(limits(Duration::from_millis(100)).within(asleep), Err(Limit::Time));
        let narrow = Limits { time: Duration::from_secs(3_600), memory: ByteSize::kib(1) };
        assert_eq!(narrow.within(asleep), Err(Limit::Memory));
    }

    #[test]
    fn limits_are_read_with_their_units() {
        assert_eq!(seconds("0.5"), Ok(Duration::from_millis(500)));
        assert!(seconds("-1").is_err() && seconds("inf").is_err() && seconds("soon").is_err());
        assert_eq!((size("500MB"), size("2 GiB")), (Ok(ByteSize::mb(500)), Ok(ByteSize::gib(2))));
        assert!(size("much").is_err() && size("-1GB").is_err());
    }
}
