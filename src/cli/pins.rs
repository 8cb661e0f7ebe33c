//! `plan pins`: pins over a conveyor that turn a part into one orientation.

use super::common::Common;
use super::input::Task;
use super::verified::{Verified, judged};
use super::{Failure, Outcome, input, limit, output};
use num_traits::Signed as _;
use partplan::answer::{Pins, Verification};
use partplan::exact::{LiteralError, Q, parse_literal, to_f64};
use partplan::model::Conveyor;
use partplan::planner::{self, PinQuestion};
use partplan::report;
use partplan::verify::PinTrials;
use std::io::Write;
use std::path::PathBuf;

/// Find the fewest pins over a conveyor that turn a part into one orientation, or prove that none do
///
/// Parts ride on the belt on any edge of their hull on which they rest, and pass under each pin, are toppled by it, or jam.
/// The plan holds for every friction coefficient and center of mass in the ranges of the case.
#[derive(Debug, clap::Args)]
#[command(after_help = "Example: plan pins cases/three_pins.json --height 3")]
pub struct Args {
    #[command(flatten)]
    common: Common,

    /// Also tell what a pin at this height above the belt does; may be repeated
    #[arg(long = "height", value_name = "H", value_parser = height, allow_hyphen_values = true)]
    heights: Vec<Q>,

    /// Let the part end with this edge of its hull down
    #[arg(long, value_name = "EDGE", value_parser = whole)]
    end: Option<usize>,

    /// Use so many pins at most
    #[arg(long, value_name = "N", value_parser = whole)]
    max_pins: Option<usize>,

    /// Also give the widest tolerance that more pins allow
    #[arg(long)]
    pareto: bool,

    /// Also tell how far friction and center of mass may be off before the pins fail, which takes about a second
    #[arg(long)]
    margins: bool,

    /// Draw the answer into this file
    #[arg(long, value_name = "FILE")]
    svg: Option<PathBuf>,

    #[command(flatten)]
    verified: Verified,

    /// Let the belt of the dynamic verification move at this speed, in the length unit of the case a second
    ///
    /// Without it the belt is so slow that parts move quasi-statically, as the plan assumes.
    #[arg(long, value_name = "V", value_parser = height, conflicts_with = "no_verify")]
    belt_speed: Option<Q>,
}

/// Rounds of all orientations by which a plan is verified unless it is told otherwise.
const ROUNDS: u64 = 4;

/// Plans pins.
pub fn run(args: &Args, out: &mut dyn Write) -> Result<Outcome, Failure> {
    let (common, task) = (&args.common, input::conveyed(&args.common)?);
    let ride = task.ride(args.end, args.max_pins);
    let (part, conveyor, question) = (task.case.part.clone(), task.section.clone(), args.question());
    let found = match common.limits.within(move || planner::pins(&part, &conveyor, &question)) {
        Ok(found) => found?,
        Err(reached) => {
            common.limits.say_reached(reached, common.format, || report::json::undecided_pins(&ride, reached), out)?;
            return Ok(limit::OVER);
        }
    };
    if let Some(path) = &args.svg {
        output::picture(path, &report::svg::pins(&ride, &found))?;
    }
    let verification = verify(args, &task, ride.name, &found)?;
    let said = |found: &Verification| report::text::verification(task.case.part.unit, found);
    output::answer(
        out,
        common.format,
        || report::text::pins(&ride, &found) + &verification.as_ref().map_or_else(String::new, said),
        || report::json::verified(report::json::pins(&ride, &found), verification.as_ref()),
    )?;
    let outcome = match (&found.plan.sequence, found.plan.is_decided()) {
        (Some(_), _) => Outcome::Yes,
        (None, true) => Outcome::No,
        (None, false) => Outcome::Undecided,
    };
    Ok(judged(outcome, verification.as_ref()))
}

/// Puts the pins of the case, or else those found, to the test.
fn verify(args: &Args, task: &Task<Conveyor>, name: &str, found: &Pins) -> Result<Option<Verification>, Failure> {
    let (part, given) = (&task.case.part, &task.case.given_pins);
    let Some(mut trials) = PinTrials::new(part, &task.section, found, given, 0) else {
        return Ok(None);
    };
    if let Some(speed) = &args.belt_speed {
        trials = trials.at_speed(to_f64(&(speed * part.unit.metres())));
    }
    let runs = ROUNDS * trials.n_orientations();
    args.verified.test(&args.common, name, runs, &trials, |trials, watch| trials.fastest(watch).into_iter().collect())
}

impl Args {
    fn question(&self) -> PinQuestion {
        PinQuestion {
            heights: self.heights.clone(),
            end: self.end,
            max_pins: self.max_pins,
            pareto: self.pareto,
            margins: self.margins,
            curves: self.svg.is_some(),
        }
    }
}

/// Reads the height of a pin.
fn height(text: &str) -> Result<Q, HeightError> {
    let height = parse_literal(text.trim())?;
    if height.is_positive() { Ok(height) } else { Err(HeightError::NotAbove) }
}

/// Reads a number of edges or pins.
fn whole(text: &str) -> Result<usize, &'static str> {
    text.trim().parse().map_err(|_| "expected a whole number, 2 for instance")
}

/// Why a text is not the height of a pin.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
enum HeightError {
    #[error("{0}; write 0.125, 1e-3 or 1/3")]
    Number(#[from] LiteralError),
    #[error("pins are above the belt; write a height above 0")]
    NotAbove,
}

#[cfg(test)]
mod tests {
    use super::*;
    use partplan::exact::ratio;

    #[test]
    fn heights_are_read_exactly_and_above_the_belt() {
        assert_eq!(height("1/3"), Ok(ratio(1, 3)));
        assert_eq!(height("2.50"), Ok(ratio(5, 2)));
        assert_eq!((height("0"), height("-1e-9")), (Err(HeightError::NotAbove), Err(HeightError::NotAbove)));
        let message = |text| height(text).unwrap_err().to_string();
        assert_eq!(message("7/0"), "the denominator is zero; write 0.125, 1e-3 or 1/3");
        assert!(message("high").starts_with("expected a decimal number or a fraction"));
    }
}
