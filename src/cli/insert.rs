//! `plan insert`: which pushes and tilts are guaranteed to seat the part.

use super::common::{Fixtured, Shown};
use super::{Failure, Outcome, input, limit, output, suggest};
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

    /// Skip the dynamic verification, which this version does not have yet
    #[arg(long)]
    no_verify: bool,
}

/// Plans an insertion.
pub fn run(args: &Args, out: &mut dyn Write) -> Result<Outcome, Failure> {
    let _ = args.no_verify;
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
    output::answer(
        out,
        args.fixtured.common.format,
        || report::text::insertion(&subject, &found),
        || report::json::insertion(&subject, &found, args.shown.cells),
    )?;
    Ok(if found.acyclic.is_empty() { Outcome::No } else { Outcome::Yes })
}
