//! Plans put to the test of dynamics, and what refutes them written down.

use super::common::{Common, count_within};
use super::limit::Limits;
use super::progress::Bar;
use super::{Failure, Outcome, output};
use partplan::answer::{Quantity, Refutation, Verdict, Verification};
use partplan::dynamics::{self, ModelKind, Options, Policy};
use partplan::report::{self, Run, json};
use partplan::verify::{self, Experiment};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Instant;

/// How a plan is verified.
#[derive(Debug, clap::Args)]
pub struct Verified {
    /// Skip the dynamic verification
    #[arg(long)]
    pub no_verify: bool,

    /// Put the plan to the test of so many runs of a time-stepper
    #[arg(long, value_name = "N", value_parser = count_within(1..=1_000_000), conflicts_with = "no_verify")]
    pub verify: Option<usize>,

    /// Save the scenes that refute the plan into this folder, with their pictures
    #[arg(long, value_name = "DIR", conflicts_with = "no_verify")]
    pub save_refutation: Option<PathBuf>,
}

impl Verified {
    /// Runs an experiment `runs` times unless told how often, and looks how far the plan holds; `None` where that is not
    /// wanted, or where the time is over before it is known, which is then said.
    pub fn test<E: Experiment>(
        &self,
        common: &Common,
        name: &str,
        runs: u64,
        experiment: &E,
        limits: impl FnOnce(&E, &(dyn Fn() -> bool + Sync)) -> Vec<Quantity>,
    ) -> Result<Option<Verification>, Failure> {
        if self.no_verify {
            return Ok(None);
        }
        let runs = self.verify.map_or(runs, |runs| runs as u64);
        let (bar, done, clock) = (Bar::new(), AtomicU64::new(0), Clock::new(common.limits));
        let watch = || {
            bar.show_runs(done.fetch_add(1, Ordering::Relaxed) + 1, runs);
            clock.goes_on()
        };
        let tally = verify::tally(experiment, 0..runs, &watch);
        let found = tally.map(|tally| {
            let limits = if tally.confirmed == runs { limits(experiment, &|| clock.goes_on()) } else { Vec::new() };
            verify::verification(experiment, tally, limits)
        });
        bar.clear();
        match &found {
            None => output::complain("the time limit ended the verification; --no-verify leaves it out"),
            Some(found) => self.save(name, &found.refutations)?,
        }
        Ok(found)
    }

    /// Saves refuting scenes, if that is asked for.
    fn save(&self, name: &str, refutations: &[Refutation]) -> Result<(), Failure> {
        let Some(folder) = &self.save_refutation else { return Ok(()) };
        save(folder, name, refutations)
    }
}

/// Writes each refuting scene as a case for `plan simulate`, and its picture.
pub fn save(folder: &Path, name: &str, refutations: &[Refutation]) -> Result<(), Failure> {
    if refutations.is_empty() {
        return Ok(());
    }
    fs::create_dir_all(folder).map_err(|source| Failure::Picture { path: folder.to_owned(), source })?;
    let stem: String = name.chars().map(|c| if c.is_alphanumeric() { c } else { '_' }).collect();
    for refutation in refutations {
        let (replay, run) = (&refutation.replay, refutation.run);
        let title = format!("{name}, run {run}: {}", refutation.why);
        let path = folder.join(format!("{stem}_run_{run}.json"));
        output::picture(&path, &json::document(&json::scene(&title, &replay.world)))?;
        let options = Options {
            model: match replay.model {
                "moreau" => ModelKind::Moreau,
                "spk" => ModelKind::SongPangKumar,
                _ => ModelKind::StewartTrinkle,
            },
            policy: if replay.is_adverse { Policy::Adverse } else { Policy::First },
            ..Options::default()
        };
        let answer = dynamics::simulate(&replay.world, &options, &mut |_| true).map_err(Failure::Simulation)?;
        let run = Run { name: &title, world: &replay.world, warnings: &[] };
        output::picture(&path.with_extension("svg"), &report::svg::simulation(&run, &answer))?;
        let policy = if replay.is_adverse { " --policy adverse" } else { "" };
        let shown = path.display();
        output::complain(&format!("saved {shown}: plan simulate {shown} --model {}{policy} shows it", replay.model));
    }
    Ok(())
}

/// The exit status of a plan after its verification.
pub fn judged(outcome: Outcome, found: Option<&Verification>) -> Outcome {
    match found.map(Verification::verdict) {
        Some(Verdict::Refuted) if outcome == Outcome::Yes => Outcome::No,
        _ => outcome,
    }
}

/// Whether there is time left, for many threads to ask.
pub struct Clock {
    limits: Limits,
    start: Instant,
}

impl Clock {
    /// Starts it.
    pub fn new(limits: Limits) -> Self {
        Self { limits, start: Instant::now() }
    }

    /// Whether there is.
    pub fn goes_on(&self) -> bool {
        self.start.elapsed() < self.limits.time
    }
}
