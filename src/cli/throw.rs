//! `plan throw`: throws from an arm that bring a part into one motion pattern.

use super::common::{Common, count_within};
use super::input::Task;
use super::progress::Bar;
use super::stop::{Reason, Stop};
use super::sweep::{self, Controls};
use super::verified::{Verified, judged};
use super::{Failure, Outcome, input, output};
use partplan::answer::{Throw, Verification};
use partplan::exact::{LiteralError, Q, parse_literal};
use partplan::mechanics::throwing::Settling;
use partplan::model::Thrower;
use partplan::planner::{self, CarryQuestion, ThrowQuestion};
use partplan::report;
use partplan::verify::ThrowTrials;
use std::io::Write;
use std::path::PathBuf;

/// Tell where an arm that throws a part and catches it again and again takes it, and which sensor reads that
///
/// A state is an edge of the part's hull on the arm and the place of its center of mass along the arm. Grasps are exact; what
/// is said of repeated throws is computed in doubles, and proved by intervals where the answer says so.
#[derive(Debug, clap::Args)]
#[command(after_help = "Example: plan throw cases/throw_triangle.json --throw 0,20")]
pub struct Args {
    #[command(flatten)]
    common: Common,

    /// Also tell what a throw from this edge and radius does; may be repeated
    #[arg(long = "throw", value_name = "EDGE,R", value_parser = thrown, allow_hyphen_values = true)]
    throws: Vec<(usize, Q)>,

    /// Also tell which accelerations of the arm, at this angle and rate in radians per second, keep the part from moving on
    /// it; may be repeated
    #[arg(long = "carry", value_name = "EDGE,R,ANGLE_DEG,RATE", value_parser = carried, allow_hyphen_values = true)]
    carries: Vec<CarryQuestion>,

    /// When a part that rolls is taken to be at rest
    #[arg(long, value_enum, default_value_t = Settle::Full)]
    settle: Settle,

    /// Follow orbits from so many radii on each stable edge
    #[arg(long, value_name = "N", default_value_t = ThrowQuestion::default().starts, value_parser = count_within(1..=10_000))]
    starts: usize,

    /// Also try arms with these offsets and release speeds in degrees per second, and recommend one; what is left out stays as
    /// in the case
    #[arg(
        long,
        value_name = "offset=A..B,release=C..D",
        value_parser = sweep::controls,
        allow_hyphen_values = true
    )]
    sweep: Option<Controls>,

    /// Relative margin that a recommended arm keeps
    #[arg(
        long,
        value_name = "M",
        default_value = "0.05",
        value_parser = sweep::margin,
        requires = "sweep",
        allow_hyphen_values = true
    )]
    margin: Q,

    /// Try so many values of each control
    #[arg(long, value_name = "N", default_value_t = 24, value_parser = count_within(2..=1_000), requires = "sweep")]
    grid: usize,

    /// Draw the answer into this file
    #[arg(long, value_name = "FILE")]
    svg: Option<PathBuf>,

    /// Write a page that plays the throws into this file
    #[arg(long, value_name = "FILE")]
    html: Option<PathBuf>,

    #[command(flatten)]
    verified: Verified,
}

/// Throws of the pattern by which it is verified unless it is told otherwise.
const THROWS: u64 = 40;

/// When a part that rolls is at rest.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Settle {
    /// When it has not the energy to leave an edge
    Full,
    /// On the first stable edge that it lands on
    First,
}

/// Plans throws; what is found when a limit is reached is still told.
pub fn run(args: &Args, out: &mut dyn Write) -> Result<Outcome, Failure> {
    let task = input::thrown(&args.common)?;
    let question = args.question(&task.section);
    let (bar, mut stop) = (Bar::new(), Stop::new(args.common.limits));
    let found = planner::throw(&task.case.part, &task.section, &question, &mut |progress| {
        bar.show_throws(&progress);
        stop.goes_on()
    });
    bar.clear();
    let found = found?;
    if let Some(note) = stop.note() {
        output::complain(&format!("undecided: {note}"));
    }
    let toss = task.toss(args.settle == Settle::First);
    if let Some(path) = &args.svg {
        output::picture(path, &report::svg::throw(&toss, &found))?;
    }
    if let Some(path) = &args.html {
        output::picture(path, &report::html::throw(&toss, &found))?;
    }
    let verification = if stop.reason().is_some() { None } else { verify(args, &task, toss.name, &found)? };
    let said = |found: &Verification| report::text::verification(task.case.part.unit, found);
    output::answer(
        out,
        args.common.format,
        || report::text::throw(&toss, &found) + &verification.as_ref().map_or_else(String::new, said),
        || report::json::verified(report::json::throw(&toss, &found), verification.as_ref()),
    )?;
    Ok(match (stop.reason(), found.status()) {
        (Some(Reason::Interrupt), _) => Outcome::Interrupted,
        (_, "plan") => judged(Outcome::Yes, verification.as_ref()),
        (_, "no-plan") => Outcome::No,
        _ => Outcome::Undecided,
    })
}

/// Replays the pattern on surfaces of finite friction and restitution.
fn verify(args: &Args, task: &Task<Thrower>, name: &str, found: &Throw) -> Result<Option<Verification>, Failure> {
    let Some(trials) = ThrowTrials::new(&task.case.part, &task.section, found, None, 0) else {
        return Ok(None);
    };
    let runs = THROWS.min(trials.n_throws());
    args.verified.test(&args.common, name, runs, &trials, |trials, watch| trials.kept(runs, watch))
}

impl Args {
    fn question(&self, thrower: &Thrower) -> ThrowQuestion {
        ThrowQuestion {
            throws: self.throws.clone(),
            carries: self.carries.clone(),
            settling: match self.settle {
                Settle::Full => Settling::Full,
                Settle::First => Settling::First,
            },
            starts: self.starts,
            sweep: self.sweep.as_ref().map(|controls| controls.sweep(thrower, self.grid, &self.margin)),
            replay: self.html.is_some(),
            ..ThrowQuestion::default()
        }
    }
}

/// Reads `edge,radius`.
fn thrown(text: &str) -> Result<(usize, Q), StateError> {
    let [edge, radius] = numbers(text, "--throw=0,12.5")?;
    Ok((whole(edge)?, number("the radius", radius)?))
}

/// Reads `edge,radius,angle,rate`.
fn carried(text: &str) -> Result<CarryQuestion, StateError> {
    let [edge, radius, angle, rate] = numbers(text, "--carry=0,12.5,30,-2")?;
    Ok(CarryQuestion {
        edge: whole(edge)?,
        radius: number("the radius", radius)?,
        angle_deg: number("the angle", angle)?,
        rate: number("the rate", rate)?,
    })
}

fn numbers<'a, const N: usize>(text: &'a str, example: &'static str) -> Result<[&'a str; N], StateError> {
    let numbers: Vec<&str> = text.split(',').map(str::trim).collect();
    let count = numbers.len();
    numbers.try_into().map_err(|_| StateError::Count { count, needed: N, example })
}

fn whole(text: &str) -> Result<usize, StateError> {
    text.parse().map_err(|_| StateError::Edge { text: text.to_owned() })
}

fn number(name: &'static str, text: &str) -> Result<Q, StateError> {
    parse_literal(text).map_err(|reason| StateError::Number { name, text: text.to_owned(), reason })
}

/// Why a text does not name a state of part and arm.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
enum StateError {
    #[error("{count} numbers where {needed} are needed; write {example}")]
    Count { count: usize, needed: usize, example: &'static str },
    #[error("\"{text}\" is not the number of an edge; write 0, 1 or 2 for instance")]
    Edge { text: String },
    #[error("{name} is \"{text}\": {reason}; write 0.125, 1e-3 or 1/3")]
    Number { name: &'static str, text: String, reason: LiteralError },
}

#[cfg(test)]
mod tests {
    use super::*;
    use partplan::exact::ratio;

    #[test]
    fn states_are_read_exactly() {
        assert_eq!(thrown("2,1/3"), Ok((2, ratio(1, 3))));
        let carry = CarryQuestion { edge: 0, radius: ratio(25, 2), angle_deg: ratio(30, 1), rate: ratio(-2, 1) };
        assert_eq!(carried(" 0, 12.5 ,30,-2"), Ok(carry));
    }

    #[test]
    fn a_bad_state_is_told_by_its_bad_number() {
        let message = |text| thrown(text).unwrap_err().to_string();
        assert_eq!(message("2"), "1 numbers where 2 are needed; write --throw=0,12.5");
        assert_eq!(message("-1,5"), "\"-1\" is not the number of an edge; write 0, 1 or 2 for instance");
        assert!(message("0,far").starts_with("the radius is \"far\": expected a decimal number"));
        let message = |text| carried(text).unwrap_err().to_string();
        assert!(message("0,1,2").starts_with("3 numbers where 4 are needed; write --carry="));
        assert!(message("0,1,1/0,2").starts_with("the angle is \"1/0\": the denominator is zero"));
    }
}
