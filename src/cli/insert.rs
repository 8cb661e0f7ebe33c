//! `plan insert`: which pushes and tilts are guaranteed to seat the part.

use super::common::Common;
use super::{Failure, Outcome, input, output};
use partplan::mechanics::Mode;
use partplan::{planner, report};
use std::io::Write;
use std::path::PathBuf;

/// Find every push and tilt that is guaranteed to seat the part against its fixels
///
/// The part is near its seat, touching none, some or all of the fixels, and moves slowly. The plan holds for every
/// friction coefficient in the ranges of the case.
#[derive(Debug, clap::Args)]
#[command(after_help = "Example: plan insert cases/pawl.json --wrench=-1,0,0")]
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

    /// Skip the dynamic verification, which this version does not have yet
    #[arg(long)]
    no_verify: bool,
}

/// Plans an insertion.
pub fn run(args: &Args, out: &mut dyn Write) -> Result<Outcome, Failure> {
    let _ = args.no_verify;
    let task = input::task(&args.common)?;
    let subject = task.subject();
    let found = planner::insertion(subject.part, subject.fixture, &args.common.question(&args.modes))?;
    if let Some(path) = &args.svg {
        output::picture(path, &report::svg::insertion(&subject, &found))?;
    }
    output::answer(
        out,
        args.common.format,
        || report::text::insertion(&subject, &found),
        || report::json::insertion(&subject, &found, args.cells),
    )?;
    Ok(if found.goal.is_empty() { Outcome::No } else { Outcome::Yes })
}
