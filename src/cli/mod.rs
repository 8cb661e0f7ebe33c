//! All input and output of the `plan` command; one file a command.

mod chart;
mod common;
mod cone;
mod convert;
mod failure;
mod feeder;
mod input;
mod insert;
mod journal;
mod limit;
mod output;
mod pins;
mod progress;
mod simulate;
mod stable;
mod state;
mod stop;
mod suggest;
mod sweep;
mod throw;
mod verified;
mod verify;

pub use failure::{Failure, Outcome, end};

use clap::{Parser, Subcommand};
use std::io::Write;

/// Plan how parts are fed, oriented and fixtured, exactly
#[derive(Debug, Parser)]
#[command(name = "plan", version, arg_required_else_help = true, after_help = AFTER_HELP)]
pub struct Cli {
    #[command(subcommand)]
    command: Command,
}

const AFTER_HELP: &str = "\
Exit status: 0 a plan was found or a report made, 1 it is proved that there is no plan,
2 bad input or usage, 3 undecided at a limit, 130 interrupted. Answers go to standard output, everything else to standard error.

Example: plan insert cases/pawl.json";

#[derive(Debug, Subcommand)]
enum Command {
    Insert(insert::Args),
    Stable(stable::Args),
    Cone(cone::Args),
    Pins(pins::Args),
    Throw(Box<throw::Args>),
    Simulate(simulate::Args),
    Feeder(feeder::Args),
    Verify(verify::Args),
    Chart(chart::Args),
    Convert(convert::Args),
}

impl Cli {
    /// Runs the command and writes its answer to `out`.
    ///
    /// # Errors
    /// [`Failure`] for bad input and for output that cannot be written.
    pub fn run(&self, out: &mut dyn Write) -> Result<Outcome, Failure> {
        match &self.command {
            Command::Insert(args) => insert::run(args, out),
            Command::Stable(args) => stable::run(args, out),
            Command::Cone(args) => cone::run(args, out),
            Command::Pins(args) => pins::run(args, out),
            Command::Throw(args) => throw::run(args, out),
            Command::Simulate(args) => simulate::run(args, out),
            Command::Feeder(args) => feeder::run(args, out),
            Command::Verify(args) => verify::run(args, out),
            Command::Chart(args) => chart::run(args, out),
            Command::Convert(args) => convert::run(args, out),
        }
    }
}
