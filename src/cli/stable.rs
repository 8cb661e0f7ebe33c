//! `plan stable`: under which wrenches the seated part stays at rest.

use super::common::Common;
use super::{Failure, Outcome, input, limit, output};
use partplan::mechanics::Mode;
use partplan::{planner, report};
use std::io::Write;
use std::path::PathBuf;

/// Tell under which pushes and tilts the seated part can, and is certain to, stay at rest
#[derive(Debug, clap::Args)]
#[command(after_help = "Example: plan stable cases/force_closure.json")]
pub struct Args {
    #[command(flatten)]
    common: Common,

    /// Also give the cone of this contact mode, one letter of s a u l r n m per fixel; may be repeated
    #[arg(long = "mode", value_name = "LETTERS")]
    modes: Vec<Mode>,

    /// Add to the JSON the disjoint convex cells of every region
    #[arg(long)]
    cells: bool,

    /// Draw the answer into this file
    #[arg(long, value_name = "FILE")]
    svg: Option<PathBuf>,
}

/// Reports on stability.
pub fn run(args: &Args, out: &mut dyn Write) -> Result<Outcome, Failure> {
    let task = input::task(&args.common)?;
    let subject = task.subject();
    let Some(found) = limit::plan(&task, &args.common, &args.modes, planner::stability, report::json::STABLE, out)?
    else {
        return Ok(limit::OVER);
    };
    if let Some(path) = &args.svg {
        output::picture(path, &report::svg::stability(&subject, &found))?;
    }
    output::answer(
        out,
        args.common.format,
        || report::text::stability(&subject, &found),
        || report::json::stability(&subject, &found, args.cells),
    )?;
    Ok(Outcome::Yes)
}
