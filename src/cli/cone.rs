//! `plan cone`: the wrenches consistent with a contact mode.

use super::common::Fixtured;
use super::{Failure, Outcome, input, limit, output};
use partplan::answer::{Cone, WrenchVerdict};
use partplan::mechanics::{Mode, ModeError};
use partplan::model::{Fixture, Part};
use partplan::planner::{self, Question};
use partplan::report;
use std::io::Write;

/// Give the cone of wrenches that are consistent with a contact mode, faces and generators
#[derive(Debug, clap::Args)]
#[command(after_help = "Example: plan cone cases/peg_in_hole.json --mode lra --mode nnu")]
pub struct Args {
    #[command(flatten)]
    fixtured: Fixtured,

    /// Contact mode, one letter of s a u l r n m per fixel; may be repeated
    #[arg(long = "mode", value_name = "LETTERS", required = true)]
    modes: Vec<Mode>,
}

/// Computes mode cones.
pub fn run(args: &Args, out: &mut dyn Write) -> Result<Outcome, Failure> {
    let task = input::fixtured(&args.fixtured)?;
    let subject = task.subject();
    let Some((modes, wrenches)) = limit::plan(&task, &args.fixtured, &args.modes, judged, report::json::CONE, out)?
    else {
        return Ok(limit::OVER);
    };
    output::answer(
        out,
        args.fixtured.common.format,
        || report::text::judged_cones(&subject, &modes, &wrenches),
        || report::json::judged_cones(&subject, &modes, &wrenches),
    )?;
    Ok(Outcome::Yes)
}

/// The cones of the modes and the verdicts on the wrenches, if any are asked about.
fn judged(part: &Part, fixture: &Fixture, question: &Question) -> Result<Judged, ModeError> {
    if question.wrenches.is_empty() {
        return Ok((planner::mode_cones(part, fixture, question)?, Vec::new()));
    }
    let found = planner::stability(part, fixture, question)?;
    Ok((found.modes, found.wrenches))
}

type Judged = (Vec<(String, Cone)>, Vec<WrenchVerdict>);
