//! `plan cone`: the wrenches consistent with a contact mode.

use super::common::Common;
use super::{Failure, Outcome, input, output};
use partplan::mechanics::Mode;
use partplan::{planner, report};
use std::io::Write;

/// Give the cone of wrenches that are consistent with a contact mode, faces and generators
#[derive(Debug, clap::Args)]
#[command(after_help = "Example: plan cone cases/peg_in_hole.json --mode lra --mode nnu")]
pub struct Args {
    #[command(flatten)]
    common: Common,

    /// Contact mode, one letter of s a u l r n m per fixel; may be repeated
    #[arg(long = "mode", value_name = "LETTERS", required = true)]
    modes: Vec<Mode>,
}

/// Computes mode cones.
pub fn run(args: &Args, out: &mut dyn Write) -> Result<Outcome, Failure> {
    let task = input::task(&args.common)?;
    let subject = task.subject();
    let question = args.common.question(&args.modes);
    let (modes, wrenches) = if question.wrenches.is_empty() {
        (planner::mode_cones(subject.part, subject.fixture, &question)?, Vec::new())
    } else {
        let found = planner::stability(subject.part, subject.fixture, &question)?;
        (found.modes, found.wrenches)
    };
    output::answer(
        out,
        args.common.format,
        || report::text::judged_cones(&subject, &modes, &wrenches),
        || report::json::judged_cones(&subject, &modes, &wrenches),
    )?;
    Ok(Outcome::Yes)
}
