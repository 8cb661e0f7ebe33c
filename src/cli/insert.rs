//! `plan insert`: which pushes and tilts are guaranteed to seat the part.

use super::common::{Fixtured, Shown};
use super::input::Task;
use super::verified::{Verified, judged};
use super::{Failure, Outcome, input, limit, output, suggest};
use partplan::answer::{Insertion, Verification};
use partplan::model::Fixture;
use partplan::verify::{InsertTrials, Push};
use partplan::{planner, report};
use std::io::Write;

/// Find every push and tilt that is guaranteed to seat the part against its fixels
///
/// The part is near its seat, touching none, some or all of the fixels, and moves slowly. The plan holds for every
/// friction coefficient in the ranges of the case.
#[derive(Debug, clap::Args)]
#[command(after_help = "Example: plan insert cases/pawl.json --wrench=-1,0,0")]
pub struct Args {
    #[command(flatten)]
    fixtured: Fixtured,

    #[command(flatten)]
    shown: Shown,

    /// Propose N places for the fixels on the part's edges instead, those with the largest margin first
    ///
    /// The case gives the number of fixels and their friction; where they are does not matter.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1_000))]
    #[arg(conflicts_with_all = ["wrenches", "modes", "strict_s", "cells"])]
    suggest: Option<u16>,

    #[command(flatten)]
    verified: Verified,
}

/// Rounds of all unseated contact states by which a plan is verified unless it is told otherwise.
const ROUNDS: u64 = 4;

/// Plans an insertion.
pub fn run(args: &Args, out: &mut dyn Write) -> Result<Outcome, Failure> {
    let task = input::fixtured(&args.fixtured)?;
    if let Some(count) = args.suggest {
        return suggest::run(&task, &args.fixtured.common, count.into(), args.shown.svg.as_deref(), out);
    }
    let subject = task.subject();
    let Some(found) =
        limit::plan(&task, &args.fixtured, &args.shown.modes, planner::insertion, report::json::INSERT, out)?
    else {
        return Ok(limit::OVER);
    };
    if let Some(path) = &args.shown.svg {
        output::picture(path, &report::svg::insertion(&subject, &found))?;
    }
    let verification = verify(args, &task, &found)?;
    let said = |found: &Verification| report::text::verification(task.case.part.unit, found);
    output::answer(
        out,
        args.fixtured.common.format,
        || report::text::insertion(&subject, &found) + &verification.as_ref().map_or_else(String::new, said),
        || {
            let document = report::json::insertion(&subject, &found, args.shown.cells);
            report::json::verified(document, verification.as_ref())
        },
    )?;
    let outcome = if found.acyclic.is_empty() { Outcome::No } else { Outcome::Yes };
    Ok(judged(outcome, verification.as_ref()))
}

/// Puts the plan of the case, or else the one found, to the test.
fn verify(args: &Args, task: &Task<Fixture>, found: &Insertion) -> Result<Option<Verification>, Failure> {
    let (part, fixture) = (&task.case.part, &task.section);
    let given = task.case.given_push.as_ref().map(|given| Push::given(part, given));
    let Some(push) = given.or_else(|| found.plan.as_ref().map(|plan| Push::recommended(part, plan))) else {
        return Ok(None);
    };
    let trials = InsertTrials::new(part, fixture, push, 0, None);
    let trials = if task.case.given_push.is_some() { trials.given() } else { trials };
    let runs = ROUNDS * trials.n_states();
    args.verified.test(&args.fixtured.common, task.subject().name, runs, &trials, |trials, watch| {
        trials.farthest(runs, watch).into_iter().collect()
    })
}
