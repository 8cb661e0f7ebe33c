//! How a run ends.

use partplan::cone::format::FormatError;
use partplan::dynamics::SimulationError;
use partplan::mechanics::ModeError;
use partplan::planner::{PinsError, SuggestError, ThrowError};
use std::io;
use std::path::PathBuf;
use std::process::ExitCode;

/// As shells report a process that Ctrl-C ended.
pub const INTERRUPTED: u8 = 130;

/// How a run that was not stopped by bad input ended; the only place where exit codes are written down.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outcome {
    /// A plan was found or a report made: 0.
    Yes,
    /// It is proved that no plan exists: 1. (2 is every failure, as in clap.)
    No,
    /// A limit was reached before an answer: 3.
    Undecided,
    /// The run was interrupted; what it had found is written: 130.
    Interrupted,
}

/// Why there is no answer: exit status 2.
#[derive(Debug, thiserror::Error)]
pub enum Failure {
    /// The case file is wrong; the faults are already set in type.
    #[error("{0}")]
    Case(String),
    /// The case file cannot be read.
    #[error("error: cannot read {path}: {source}")]
    Read { path: String, source: io::Error },
    /// A folder was given.
    #[error("error: {path} is a folder; give one file, for example {path}/{example}")]
    Folder { path: String, example: &'static str },
    /// A mode does not fit the case.
    #[error("error: {0}")]
    Mode(#[from] ModeError),
    /// Places for the fixels cannot be proposed.
    #[error("error: {0}")]
    Suggest(#[from] SuggestError),
    /// The model asked for needs to know how two bodies give way.
    #[error(
        "error: `{first}` and `{second}` can touch, but no stiffness and damping is given for the two, which --model spk \
         needs; write \"contact\": {{\"stiffness\": 5e4, \"damping\": 14}} in the scene"
    )]
    NoCompliance { first: String, second: String },
    /// The model asked for does not fit the scene.
    #[error("error: {0}")]
    Simulation(SimulationError),
    /// Pins cannot be planned.
    #[error("error: {0}")]
    Pins(#[from] PinsError),
    /// Throws cannot be planned.
    #[error("error: {0}")]
    Throw(#[from] ThrowError),
    /// A polyhedron file is wrong.
    #[error("error: {path}:{fault}")]
    Polyhedron { path: String, fault: FormatError },
    /// A file is too long.
    #[error("error: {path} has more than {limit} bytes; raise the limit with --max-bytes")]
    TooLong { path: String, limit: usize },
    /// There is no such variable to project to.
    #[error("error: there is no variable {variable} to keep; the file has {count}, numbered from 1")]
    NoVariable { variable: usize, count: usize },
    /// A variable is named twice.
    #[error("error: variable {variable} is to be kept twice; name it once")]
    VariableTwice { variable: usize },
    /// A drawing, or what is kept of a search, cannot be written.
    #[error("error: cannot write {}: {source}", path.display())]
    Picture { path: PathBuf, source: io::Error },
    /// There is nothing to put to the test.
    #[error("error: {name} has no plan to verify; its command tells why, and \"plan\" in its section may give one")]
    NoPlan { name: String },
    /// The file with what many runs came to is not theirs, or not whole.
    #[error("error: {} cannot be gone on from: {why}; give --state another file", path.display())]
    State { path: PathBuf, why: String },
    /// A file is not one of a chart.
    #[error("error: {}: {why}; give --from the chart.csv that plan chart wrote", path.display())]
    Chart { path: PathBuf, why: String },
    /// Nothing of a chart is called so.
    #[error(
        "error: no point or tile is called \"{only}\"; write one of {parts}, or an id as the commands in chart.csv do"
    )]
    NoPart { only: String, parts: String },
    /// Threads cannot be started.
    #[error("error: cannot start so many jobs: {0}; write a smaller number for --jobs")]
    Threads(String),
    /// Standard output cannot be written.
    #[error("error: cannot write the answer: {0}")]
    Write(#[from] io::Error),
}

/// Says on standard error what failed, if anything, and gives the exit status.
///
/// A reader that closes the pipe has seen enough: that is no failure.
pub fn end(result: Result<Outcome, Failure>) -> ExitCode {
    match result {
        Ok(Outcome::Yes) => ExitCode::SUCCESS,
        Ok(Outcome::No) => ExitCode::from(1),
        Ok(Outcome::Undecided) => ExitCode::from(3),
        Ok(Outcome::Interrupted) => ExitCode::from(INTERRUPTED),
        Err(Failure::Write(error)) if error.kind() == io::ErrorKind::BrokenPipe => ExitCode::SUCCESS,
        Err(failure) => {
            super::output::complain(failure.to_string().trim_end());
            ExitCode::from(2)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn status(result: Result<Outcome, Failure>) -> String {
        format!("{:?}", end(result))
    }

    #[test]
    fn answers_are_not_errors_and_a_closed_pipe_is_no_failure() {
        let code = |code: u8| format!("{:?}", ExitCode::from(code));
        assert_eq!(status(Ok(Outcome::Yes)), code(0));
        assert_eq!(status(Ok(Outcome::No)), code(1));
        assert_eq!(status(Ok(Outcome::Undecided)), code(3));
        assert_eq!(status(Ok(Outcome::Interrupted)), code(130));
        assert_eq!(status(Err(Failure::Write(io::ErrorKind::BrokenPipe.into()))), code(0));
        assert_eq!(status(Err(Failure::Write(io::ErrorKind::StorageFull.into()))), code(2));
        assert_eq!(status(Err(Failure::Folder { path: "cases".to_owned(), example: "part.json" })), code(2));
    }
}
