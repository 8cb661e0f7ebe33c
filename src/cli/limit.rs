//! Planning within a time limit.

use super::common::Common;
use super::input::Task;
use super::output::Format;
use super::{Failure, Outcome, output};
use partplan::mechanics::{Mode, ModeError};
use partplan::model::{Fixture, Part};
use partplan::planner::Question;
use partplan::report::json;
use serde_json::Value;
use std::io::Write;
use std::panic::resume_unwind;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

/// A planner: part, fixture and question to an answer.
type Planner<A> = fn(&Part, &Fixture, &Question) -> Result<A, ModeError>;

/// Runs `planner` on the task within the time limit; `None` when the time is over, which is then said.
pub fn plan<A: Send + 'static>(
    task: &Task,
    common: &Common,
    modes: &[Mode],
    planner: Planner<A>,
    schema: &str,
    out: &mut dyn Write,
) -> Result<Option<A>, Failure> {
    let (part, fixture, question) = (task.case.part.clone(), task.fixture.clone(), common.question(modes));
    if let Some(answer) = within(common.time_limit, move || planner(&part, &fixture, &question)) {
        return Ok(Some(answer?));
    }
    say_over(common.time_limit, common.format, || json::undecided(&task.subject(), schema), out)?;
    Ok(None)
}

/// Says that the time is over.
pub fn say_over(
    limit: Duration,
    format: Format,
    document: impl FnOnce() -> Value,
    out: &mut dyn Write,
) -> Result<(), Failure> {
    let said = || format!("undecided: no answer within {} s; --time-limit allows more\n", limit.as_secs_f64());
    output::answer(out, format, said, document)
}

/// How a run without an answer ends.
pub const OVER: Outcome = Outcome::Undecided;

/// Runs `work` on a thread of its own and waits for it no longer than `limit`; the process ends soon after.
pub fn within<T: Send + 'static>(limit: Duration, work: impl FnOnce() -> T + Send + 'static) -> Option<T> {
    let (done, wait) = channel();
    let worker = thread::spawn(move || done.send(work()));
    match wait.recv_timeout(limit) {
        Ok(answer) => Some(answer),
        Err(RecvTimeoutError::Timeout) => None,
        Err(RecvTimeoutError::Disconnected) => match worker.join() {
            Err(panic) => resume_unwind(panic),
            Ok(_) => unreachable!("a worker that ends has sent its answer"),
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn work_is_waited_for_until_the_limit() {
        assert_eq!(within(Duration::from_secs(3_600), || 5), Some(5));
        assert_eq!(within(Duration::from_millis(1), || thread::sleep(Duration::from_secs(3_600))), None);
    }
}
