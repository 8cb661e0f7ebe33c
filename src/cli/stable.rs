//! `plan stable`: under which wrenches the seated part stays at rest.

use super::common::{Fixtured, Shown};
use super::{Failure, Outcome, input, limit, output};
use partplan::{planner, report};
use std::io::Write;

/// Tell under which pushes and tilts the seated part can, and is certain to, stay at rest
#[derive(Debug, clap::Args)]
#[command(after_help = "Example: plan stable cases/force_closure.json")]
pub struct Args {
    #[command(flatten)]
    fixtured: Fixtured,

    #[command(flatten)]
    shown: Shown,
}

/// Reports on stability.
pub fn run(args: &Args, out: &mut dyn Write) -> Result<Outcome, Failure> {
    let task = input::fixtured(&args.fixtured)?;
    let subject = task.subject();
    let Some(found) =
        limit::plan(&task, &args.fixtured, &args.shown.modes, planner::stability, report::json::STABLE, out)?
    else {
        return Ok(limit::OVER);
    };
    if let Some(path) = &args.shown.svg {
        output::picture(path, &report::svg::stability(&subject, &found))?;
    }
    output::answer(
        out,
        args.fixtured.common.format,
        || report::text::stability(&subject, &found),
        || report::json::stability(&subject, &found, args.shown.cells),
    )?;
    Ok(Outcome::Yes)
}
