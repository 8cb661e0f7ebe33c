//! `plan feeder`: dimensions of a device through which parts fall as they are to.

use super::common::{Common, count_within};
use super::journal::Journal as File;
use super::progress::Bar;
use super::stop::{Reason, Stop};
use super::{Failure, Outcome, input, output};
use partplan::answer::{FeederPlan, Film, Limit};
use partplan::design::{self, Journal, Score, SearchOptions};
use partplan::report::{self, Chute};
use std::io::Write;
use std::path::PathBuf;
use std::sync::Mutex;

/// Design a device that turns parts as they fall through it
///
/// Searches the dimensions that the case leaves open for those with which the part leaves as it is to, from every entry and
/// soon, by runs of a time-stepper. The answer is the same for a seed, however many jobs run.
#[derive(Debug, clap::Args)]
#[command(after_help = "Example: plan feeder cases/feeder.json --html feeder.html")]
pub struct Args {
    #[command(flatten)]
    common: Common,

    /// Evaluate so many designs
    #[arg(long, value_name = "N", default_value_t = 1_000, value_parser = count_within(1..=10_000_000))]
    evaluations: usize,

    /// From which the search is drawn
    #[arg(long, value_name = "S", default_value_t = 0)]
    seed: u64,

    /// Run so many at a time; without it as many as there are processors
    #[arg(long, value_name = "J", value_parser = count_within(1..=1_024))]
    jobs: Option<usize>,

    /// Let the worst entry count, instead of all together
    #[arg(long)]
    worst: bool,

    /// Search what also holds where the case is uncertain; tell the yield, and how far each dimension may be off
    #[arg(long)]
    robust: bool,

    /// Draw what is uncertain so many times for the yield of --robust
    #[arg(long, value_name = "N", default_value_t = 400, value_parser = count_within(1..=1_000_000))]
    draws: usize,

    /// Draw the device before and after, and the search, into this file
    #[arg(long, value_name = "FILE")]
    svg: Option<PathBuf>,

    /// Write a page that plays the device before and after into this file
    #[arg(long, value_name = "FILE")]
    html: Option<PathBuf>,

    /// Write each evaluation into this file, and go on from it
    #[arg(long, value_name = "FILE")]
    state: Option<PathBuf>,
}

/// Draws of what is uncertain that a robust search tries each design with.
const TRIED: u64 = 6;

/// Designs a feeder.
pub fn run(args: &Args, out: &mut dyn Write) -> Result<Outcome, Failure> {
    let task = input::feeder(&args.common)?;
    let feeder = &task.case.feeder;
    let chute = Chute { name: &task.name, feeder, seed: args.seed, warnings: &task.case.warnings };
    let options = SearchOptions {
        evaluations: args.evaluations,
        seed: args.seed,
        worst: args.worst,
        draws: if args.robust { TRIED } else { 0 },
    };
    let key =
        format!("{} {} {:?}", env!("CARGO_PKG_VERSION"), task.digest, SearchOptions { evaluations: 0, ..options });
    let watch = Watch::new(args, File::open(args.state.as_deref(), &key)?);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(args.jobs.unwrap_or(0)).build();
    let pool = pool.map_err(|error| Failure::Threads(error.to_string()))?;
    let mut answer = pool.install(|| design::design(feeder, &options, &watch));
    if let (true, Some(best)) = (args.robust, &answer.best) {
        let draws = args.draws as u64;
        let measure =
            || design::robustness(feeder, &best.variables, args.seed.wrapping_add(1), draws, &|| watch.goes_on());
        answer.robust = pool.install(measure);
    }
    watch.bar.clear();
    let reason = watch.end(&mut answer)?;
    if args.svg.is_some() || args.html.is_some() {
        let designs = [("at first", Some(&answer.start)), ("designed", answer.best.as_ref())];
        let films = designs.into_iter().filter_map(|(name, design)| Some(design::films(feeder, design?, name)));
        let films: Vec<Film> = films.flatten().collect();
        if let Some(path) = &args.svg {
            output::picture(path, &report::svg::feeder(&chute, &answer, &films))?;
        }
        if let Some(path) = &args.html {
            output::picture(path, &report::html::feeder(&chute, &answer, &films))?;
        }
    }
    output::answer(
        out,
        args.common.format,
        || report::text::feeder(&chute, &answer),
        || report::json::feeder(&chute, &answer),
    )?;
    Ok(match reason {
        Some(Reason::Interrupt) => Outcome::Interrupted,
        _ if answer.best.is_some() => Outcome::Yes,
        _ => Outcome::Undecided,
    })
}

/// The state file, the bar and the limits, for many threads.
struct Watch<'a> {
    bar: Bar,
    of: usize,
    shared: Mutex<Shared<'a>>,
}

struct Shared<'a> {
    file: File,
    stop: Stop,
    best: f64,
    failure: Option<Failure>,
    args: &'a Args,
}

impl<'a> Watch<'a> {
    fn new(args: &'a Args, file: File) -> Self {
        let shared = Shared { file, stop: Stop::new(args.common.limits), best: f64::INFINITY, failure: None, args };
        Self { bar: Bar::new(), of: args.evaluations, shared: Mutex::new(shared) }
    }

    fn goes_on(&self) -> bool {
        self.shared.lock().is_ok_and(|mut shared| shared.stop.goes_on())
    }

    /// Why it ended early, if it did; says so.
    fn end(self, answer: &mut FeederPlan) -> Result<Option<Reason>, Failure> {
        let Ok(shared) = self.shared.into_inner() else { return Ok(None) };
        if let Some(failure) = shared.failure {
            return Err(failure);
        }
        if let Some(note) = shared.stop.note() {
            let kept = if shared.args.state.is_some() { "" } else { "; --state keeps them" };
            output::complain(&format!("after {} evaluations: {note}{kept}", answer.trace.len()));
        }
        answer.limit = match shared.stop.reason() {
            Some(Reason::Limit(limit)) => Some(limit),
            Some(Reason::Interrupt) | None => None::<Limit>,
        };
        Ok(shared.stop.reason())
    }
}

impl Journal for Watch<'_> {
    fn known(&self, variables: &[f64]) -> Option<Score> {
        self.shared.lock().ok()?.file.score(variables)
    }

    fn add(&self, variables: &[f64], score: Score, done: usize) -> bool {
        let Ok(mut shared) = self.shared.lock() else { return false };
        shared.best = shared.best.min(score.cost);
        self.bar.show_search(done, self.of, shared.best);
        if let Err(failure) = shared.file.add(variables, score) {
            shared.failure = Some(failure);
            return false;
        }
        shared.stop.goes_on()
    }
}
