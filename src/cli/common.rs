//! Arguments that the commands share.

use super::limit::Limits;
use super::output::Format;
use clap::builder::{NonEmptyStringValueParser, TypedValueParser};
use partplan::exact::{LiteralError, Q, parse_literal};
use partplan::mechanics::Mode;
use partplan::planner::Question;
use std::io::IsTerminal as _;
use std::ops::RangeInclusive;
use std::path::PathBuf;

/// What is read, how far, and how the answer is written.
#[derive(Debug, clap::Args)]
pub struct Common {
    /// Case file, or - for standard input
    #[arg(value_name = "CASE", value_parser = NonEmptyStringValueParser::new())]
    pub case: String,

    /// How the answer is written
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,

    /// Color of the messages
    #[arg(long, value_enum, default_value_t = When::Auto, value_name = "WHEN")]
    pub color: When,

    #[command(flatten)]
    pub limits: Limits,

    /// Largest number of vertices accepted
    #[arg(long, value_name = "N", default_value_t = partplan::case::Limits::default().vertices)]
    pub max_vertices: usize,

    /// Largest case accepted, in bytes
    #[arg(long, value_name = "N", default_value_t = partplan::case::Limits::default().bytes)]
    pub max_bytes: usize,
}

/// What the commands on fixtures share besides.
#[derive(Debug, clap::Args)]
pub struct Fixtured {
    #[command(flatten)]
    pub common: Common,

    /// Judge this wrench, torque about the center of mass; may be repeated
    #[arg(long = "wrench", value_name = "FX,FY,TORQUE", value_parser = wrench, allow_hyphen_values = true)]
    pub wrenches: Vec<[Q; 3]>,

    /// Let the letter s of --mode mean that the contact accelerates apart (a_n > 0, not a_n >= 0)
    #[arg(long)]
    pub strict_s: bool,

    /// Largest number of fixels accepted
    #[arg(long, value_name = "N", default_value_t = partplan::case::Limits::default().fixels)]
    pub max_fixels: usize,
}

/// What a report on sets of wrenches shows besides.
#[derive(Debug, clap::Args)]
pub struct Shown {
    /// Also give the cone of this contact mode, one letter of s a u l r n m per fixel; may be repeated
    #[arg(long = "mode", value_name = "LETTERS")]
    pub modes: Vec<Mode>,

    /// Add to the JSON the disjoint convex cells of every region
    #[arg(long)]
    pub cells: bool,

    /// Draw the answer into this file
    #[arg(long, value_name = "FILE")]
    pub svg: Option<PathBuf>,
}

impl Common {
    /// Bounds on the case.
    pub fn case_limits(&self) -> partplan::case::Limits {
        partplan::case::Limits { bytes: self.max_bytes, vertices: self.max_vertices, ..Default::default() }
    }
}

impl Fixtured {
    /// What to ask the planner, together with the modes of the command.
    pub fn question(&self, modes: &[Mode]) -> Question {
        Question {
            wrenches: self.wrenches.clone(),
            modes: modes.to_vec(),
            strict_s: self.strict_s,
            robust: true,
            critical: true,
        }
    }

    /// Bounds on the case.
    pub fn case_limits(&self) -> partplan::case::Limits {
        partplan::case::Limits { fixels: self.max_fixels, ..self.common.case_limits() }
    }
}

/// When messages are colored.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum When {
    /// On a terminal, unless NO_COLOR is set
    Auto,
    /// Always
    Always,
    /// Never
    Never,
}

impl When {
    /// Whether messages on standard error are colored.
    pub fn on_stderr(self) -> bool {
        match self {
            Self::Always => true,
            Self::Never => false,
            Self::Auto => {
                std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty()) && std::io::stderr().is_terminal()
            }
        }
    }
}

/// Reads a whole number from `least` on.
pub fn count(least: u64) -> impl TypedValueParser<Value = usize> {
    count_within(least..=u64::from(u32::MAX))
}

/// Reads a whole number in a range.
pub fn count_within(range: RangeInclusive<u64>) -> impl TypedValueParser<Value = usize> {
    clap::value_parser!(u64).range(range).map(|number| usize::try_from(number).unwrap_or(usize::MAX))
}

/// Reads `fx,fy,torque`.
fn wrench(text: &str) -> Result<[Q; 3], WrenchError> {
    let numbers: Vec<&str> = text.split(',').map(str::trim).collect();
    let count = numbers.len();
    let [fx, fy, torque] = <[&str; 3]>::try_from(numbers).map_err(|_| WrenchError::Count { count })?;
    let number = |name, text: &str| {
        parse_literal(text).map_err(|reason| WrenchError::Number { name, text: text.to_owned(), reason })
    };
    Ok([number("fx", fx)?, number("fy", fy)?, number("torque", torque)?])
}

/// Why a text is not a wrench.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
enum WrenchError {
    #[error("{count} numbers where three are needed; write --wrench=0,-1,1/3")]
    Count { count: usize },
    #[error("{name} is \"{text}\": {reason}; write 0.125, 1e-3 or 1/3")]
    Number { name: &'static str, text: String, reason: LiteralError },
}

#[cfg(test)]
mod tests {
    use super::*;
    use partplan::exact::ratio;

    #[test]
    fn wrenches_are_read_exactly() {
        assert_eq!(wrench("1/3,-0.1,1e2"), Ok([ratio(1, 3), ratio(-1, 10), ratio(100, 1)]));
        assert_eq!(wrench(" 0 , 0 , 0 "), Ok([ratio(0, 1), ratio(0, 1), ratio(0, 1)]));
    }

    #[test]
    fn a_bad_wrench_is_told_by_its_bad_number() {
        let message = |text| wrench(text).unwrap_err().to_string();
        assert_eq!(message("1,2"), "2 numbers where three are needed; write --wrench=0,-1,1/3");
        assert!(message("1,2,x").starts_with("torque is \"x\": expected a decimal number"));
        assert!(message("1,7/0,0").starts_with("fy is \"7/0\": the denominator is zero"));
        assert!(message("nan,0,0").starts_with("fx is \"nan\""));
    }
}
