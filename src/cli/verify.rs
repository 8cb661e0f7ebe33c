//! `plan verify`: many runs of a plan, drawn from everything that its case leaves uncertain.

use super::common::{Common, count_within};
use super::progress::Bar;
use super::state::State;
use super::stop::{Reason, Stop};
use super::verified::{Clock, judged, save};
use super::{Failure, Outcome, input, output};
use partplan::answer::Tally;
use partplan::exact::{LiteralError, Q, parse_literal, to_f64};
use partplan::model::Part;
use partplan::planner::{self, PinQuestion, Question, ThrowQuestion};
use partplan::report;
use partplan::verify::{self, Experiment, InsertTrials, PinTrials, Push, Surface, ThrowTrials};
use std::io::Write;
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

/// Put a plan to the test of many runs of a time-stepper
///
/// Each run is drawn by its number and the seed from what the case leaves uncertain: pose, friction, center of mass, heights,
/// surface. The figures are the same however many jobs run them and however often they are interrupted.
#[derive(Debug, clap::Args)]
#[command(after_help = "Example: plan verify cases/pawl.json --task insert --runs 10000 --seed 1")]
pub struct Args {
    #[command(flatten)]
    common: Common,

    /// Which plan of the case
    #[arg(long, value_enum)]
    task: Task,

    /// How many runs
    #[arg(long, value_name = "N", default_value_t = 1_000, value_parser = count_within(1..=1_000_000_000))]
    runs: usize,

    /// From which the runs are drawn
    #[arg(long, value_name = "S", default_value_t = 0)]
    seed: u64,

    /// Run so many at a time; without it as many as there are processors
    #[arg(long, value_name = "J", value_parser = count_within(1..=1_024))]
    jobs: Option<usize>,

    /// Keep in this file what the runs came to so far, and go on from it
    #[arg(long, value_name = "FILE")]
    state: Option<PathBuf>,

    /// Save the scenes that refute the plan into this folder, with their pictures
    #[arg(long, value_name = "DIR")]
    save_refutation: Option<PathBuf>,

    /// Largest gap at the start of an insertion, as a share of the part's size
    #[arg(long, value_name = "SHARE", value_parser = share)]
    departure: Option<Q>,

    /// Least friction of the surface that catches a part that is thrown
    #[arg(long, value_name = "MU", value_parser = not_negative)]
    friction: Option<Q>,

    /// Largest restitution of the surface that catches a part that is thrown
    #[arg(long, value_name = "E", value_parser = share)]
    restitution: Option<Q>,
}

/// Which plan is put to the test.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Task {
    /// The push or tilt that seats the part
    Insert,
    /// The pins over a conveyor
    Pins,
    /// The throws of an arm
    Throw,
}

/// Runs between two looks at the clock and two writings of the state.
const CHUNK: u64 = 256;

/// Verifies a plan.
pub fn run(args: &Args, out: &mut dyn Write) -> Result<Outcome, Failure> {
    match args.task {
        Task::Insert => insert(args, out),
        Task::Pins => pins(args, out),
        Task::Throw => throw(args, out),
    }
}

fn insert(args: &Args, out: &mut dyn Write) -> Result<Outcome, Failure> {
    let task = input::seated(&args.common)?;
    let (part, fixture) = (&task.case.part, &task.section);
    let push = match &task.case.given_push {
        Some(given) => Some(Push::given(part, given)),
        None => {
            let found = planner::insertion(part, fixture, &Question::default())?;
            found.plan.map(|plan| Push::recommended(part, &plan))
        }
    };
    let departure = args.departure.as_ref().map(to_f64);
    let trials = push.map(|push| InsertTrials::new(part, fixture, push, args.seed, departure));
    let trials = if task.case.given_push.is_some() { trials.map(InsertTrials::given) } else { trials };
    conclude(args, task.subject().name, part, trials.as_ref(), out)
}

fn pins(args: &Args, out: &mut dyn Write) -> Result<Outcome, Failure> {
    let task = input::conveyed(&args.common)?;
    let part = &task.case.part;
    let found = planner::pins(part, &task.section, &PinQuestion::default())?;
    let trials = PinTrials::new(part, &task.section, &found, &task.case.given_pins, args.seed);
    conclude(args, task.ride(None, None).name, part, trials.as_ref(), out)
}

fn throw(args: &Args, out: &mut dyn Write) -> Result<Outcome, Failure> {
    let task = input::thrown(&args.common)?;
    let part = &task.case.part;
    let clock = Clock::new(args.common.limits);
    let found = planner::throw(part, &task.section, &ThrowQuestion::default(), &mut |_| clock.goes_on())?;
    let trials = ThrowTrials::new(part, &task.section, &found, None, args.seed);
    let trials = trials.map(|trials| trials.on(args.surface(trials.surface())));
    conclude(args, task.toss(false).name, part, trials.as_ref(), out)
}

impl Args {
    /// The surface of the case, as smooth and as elastic as asked for.
    fn surface(&self, of_case: Surface) -> Surface {
        let friction = self.friction.as_ref().map_or(of_case.friction[0], to_f64);
        let restitution = self.restitution.as_ref().map_or(of_case.restitution[1], to_f64);
        Surface {
            friction: [friction, of_case.friction[1].max(friction)],
            restitution: [of_case.restitution[0], restitution],
            ..of_case
        }
    }
}

/// Runs what is left to run and tells the figures.
fn conclude<E: Experiment>(
    args: &Args,
    name: &str,
    part: &Part,
    trials: Option<&E>,
    out: &mut dyn Write,
) -> Result<Outcome, Failure> {
    let Some(trials) = trials else {
        return Err(Failure::NoPlan { name: name.to_owned() });
    };
    let (tally, reason) = all_runs(args, name, trials)?;
    let found = verify::verification(trials, tally, Vec::new());
    if let Some(folder) = &args.save_refutation {
        save(folder, name, &found.refutations)?;
    }
    let is_done = found.tally.runs() == args.runs as u64;
    output::answer(
        out,
        args.common.format,
        || report::text::verified(part.unit, &found, args.runs as u64),
        || report::json::verified_alone(name, &found, is_done),
    )?;
    Ok(match reason {
        Some(Reason::Interrupt) => Outcome::Interrupted,
        Some(Reason::Limit(_)) => Outcome::Undecided,
        None => judged(Outcome::Yes, Some(&found)),
    })
}

/// What all runs come to, those of the state included, or as many as a limit or Ctrl-C allows.
fn all_runs<E: Experiment>(args: &Args, name: &str, trials: &E) -> Result<(Tally, Option<Reason>), Failure> {
    let runs = args.runs as u64;
    let mut state = State::open(args.state.as_deref(), &args.key(name, trials), runs)?;
    let pool = rayon::ThreadPoolBuilder::new().num_threads(args.jobs.unwrap_or(0)).build();
    let pool = pool.map_err(|error| Failure::Threads(error.to_string()))?;
    let (bar, done) = (Bar::new(), AtomicU64::new(state.next()));
    let (mut stop, ends) = (Stop::new(args.common.limits), AtomicBool::new(false));
    while state.next() < runs && stop.goes_on() {
        let chunk = state.next()..runs.min(state.next() + CHUNK);
        let watch = || {
            bar.show_runs(done.fetch_add(1, Ordering::Relaxed) + 1, runs);
            !ends.load(Ordering::Relaxed)
        };
        if let Some(tally) = pool.install(|| verify::tally(trials, chunk, &watch)) {
            state.add(&tally)?;
        }
    }
    bar.clear();
    if let Some(note) = stop.note() {
        output::complain(&format!("{} of {runs} runs: {note}", state.next()));
    }
    Ok((state.tally, stop.reason()))
}

impl Args {
    /// What a state must agree on to be gone on from.
    fn key<E: Experiment>(&self, name: &str, trials: &E) -> String {
        let replay = report::json::scene(name, &trials.replay(0, 1.0).world);
        format!("{} {:?} seed {} {replay} {:?}", env!("CARGO_PKG_VERSION"), self.task, self.seed, trials.settings())
    }
}

/// Reads a share of one, above 0.
fn share(text: &str) -> Result<Q, ShareError> {
    let number = parse_literal(text.trim())?;
    let one = Q::from_integer(1.into());
    if number > Q::default() && number <= one { Ok(number) } else { Err(ShareError::Outside) }
}

/// Reads a number that is not negative.
fn not_negative(text: &str) -> Result<Q, ShareError> {
    let number = parse_literal(text.trim())?;
    if number >= Q::default() { Ok(number) } else { Err(ShareError::Negative) }
}

/// Why a text is not a number that is asked for.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
enum ShareError {
    #[error("{0}; write 0.125, 1e-3 or 1/3")]
    Number(#[from] LiteralError),
    #[error("write a number above 0, 1 at most")]
    Outside,
    #[error("write 0 or a number above 0")]
    Negative,
}

#[cfg(test)]
mod tests {
    use super::*;
    use partplan::exact::ratio;

    #[test]
    fn shares_are_above_zero_and_friction_is_not_negative() {
        assert_eq!((share("1/4"), share("1")), (Ok(ratio(1, 4)), Ok(ratio(1, 1))));
        assert_eq!((share("0"), share("1.01")), (Err(ShareError::Outside), Err(ShareError::Outside)));
        assert_eq!((not_negative("0"), not_negative("-1")), (Ok(ratio(0, 1)), Err(ShareError::Negative)));
        assert!(share("much").unwrap_err().to_string().ends_with("write 0.125, 1e-3 or 1/3"));
    }
}
