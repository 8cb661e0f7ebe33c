//! The `plan` command: exact answers about feeding, orienting and fixturing parts.

mod cli;

use clap::Parser as _;
use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments = cli::Cli::parse();
    cli::end(arguments.run(&mut std::io::stdout().lock()))
}
