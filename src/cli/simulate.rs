//! `plan simulate`: bodies that move, touch and slip.

use super::common::{Common, count};
use super::progress::Clock;
use super::stop::{Reason, Stop};
use super::{Failure, Outcome, input, output};
use partplan::answer::{Simulation, Status};
use partplan::dynamics::{self, Mechanics, ModelKind, Options, Policy, SimulationError};
use partplan::exact::{LiteralError, parse_literal, to_f64};
use partplan::model::{Scene, World};
use partplan::report::{self, Run, Shown};
use std::io::Write;
use std::path::{Path, PathBuf};

/// Simulate rigid bodies with contact and friction, in the plane or in space
///
/// The cheapest model that the scene allows is chosen unless one is asked for; the answer says which, why, and how far to
/// trust it. A run that a limit or Ctrl-C ends is reported as far as it came.
#[derive(Debug, clap::Args)]
#[command(after_help = "Example: plan simulate cases/peg_drop.json --html peg.html")]
pub struct Args {
    #[command(flatten)]
    common: Common,

    /// Which model steps
    #[arg(long, value_enum, default_value_t = Model::Auto)]
    model: Model,

    /// Which of several motions that a step allows is followed
    #[arg(long, value_enum, default_value_t = Pick::First)]
    policy: Pick,

    /// Step in seconds, instead of the scene's
    #[arg(long, value_name = "H", value_parser = positive, allow_hyphen_values = true)]
    step: Option<f64>,

    /// Error of the final poses in metres that the choice of the step aims at
    #[arg(long, value_name = "T", value_parser = positive, allow_hyphen_values = true)]
    tolerance: Option<f64>,

    /// Let overlaps recover at this speed in m/s at most
    #[arg(long, value_name = "V", value_parser = positive, allow_hyphen_values = true)]
    recovery_speed: Option<f64>,

    /// Keep so many frames for trajectories and pictures
    #[arg(long, value_name = "N", default_value_t = Options::default().frames, value_parser = count(2))]
    frames: usize,

    /// Take so many steps at most
    #[arg(long, value_name = "N", default_value_t = Options::default().max_steps, value_parser = count(1))]
    max_steps: usize,

    /// Write a row for each frame into this file, .csv or .jsonl
    #[arg(long, value_name = "FILE", value_parser = trajectory)]
    trajectory: Option<PathBuf>,

    /// Draw the motion into this file
    #[arg(long, value_name = "FILE")]
    svg: Option<PathBuf>,

    /// Write a page that plays the motion into this file
    #[arg(long, value_name = "FILE")]
    html: Option<PathBuf>,
}

/// Which model steps.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Model {
    /// The cheapest that the scene allows
    Auto,
    /// Leave friction out
    Frictionless,
    /// Stewart and Trinkle's: rigid contacts, a linear complementarity problem a step
    St,
    /// Moreau's: rigid contacts, impacts located inside the step
    Moreau,
    /// Song, Pang and Kumar's: visco-elastic contacts, a nonlinear complementarity problem a step
    Spk,
}

/// Which of several motions is followed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Pick {
    /// The one that the solver finds
    First,
    /// The one that leaves the largest gaps: for one free body in the plane, with --model st
    Adverse,
}

/// Simulates a scene.
pub fn run(args: &Args, out: &mut dyn Write) -> Result<Outcome, Failure> {
    let task = input::scene(&args.common)?;
    match &task.case.scene {
        Scene::Planar(world) => follow(args, &task, world, out),
        Scene::Spatial(world) => follow(args, &task, world, out),
    }
}

fn follow<S: Mechanics + Shown>(
    args: &Args,
    task: &input::SceneTask,
    world: &World<S>,
    out: &mut dyn Write,
) -> Result<Outcome, Failure> {
    let mut world = world.clone();
    if args.model == Model::Frictionless {
        world.materials.iter_mut().for_each(|material| material.friction = 0.0);
    }
    let (clock, mut stop) = (Clock::new(world.duration), Stop::new(args.common.limits));
    let answer = dynamics::simulate(&world, &args.options(), &mut |time| {
        clock.show(time);
        stop.goes_on()
    });
    clock.clear();
    let mut answer = answer.map_err(|error| refused(&world, error))?;
    if args.model == Model::Frictionless {
        answer.model.why.insert(0, "friction is left out, as asked".to_owned());
    }
    if answer.status == Status::Partial {
        let note = stop.note().or_else(|| steps_used_up(args, &answer));
        answer.notes.splice(0..0, note);
    }
    let run = Run { name: &task.name, world: &world, warnings: &task.case.warnings };
    write_files(args, &run, &answer)?;
    output::answer(
        out,
        args.common.format,
        || report::text::simulation(&run, &answer),
        || report::json::simulation(&run, &answer),
    )?;
    Ok(match (answer.status, stop.reason()) {
        (Status::Partial, Some(Reason::Interrupt)) => Outcome::Interrupted,
        (Status::Partial, _) => Outcome::Undecided,
        _ => Outcome::Yes,
    })
}

/// Why the scene is not simulated, by the names of its bodies.
fn refused<S: Shown>(world: &World<S>, error: SimulationError) -> Failure {
    let names = || world.bodies.iter().map(|body| &body.name).chain(world.fixed.iter().map(|fixed| &fixed.name));
    let name = |number: usize| names().nth(number).cloned().unwrap_or_default();
    match error {
        SimulationError::NoCompliance { body, other } => {
            Failure::NoCompliance { first: name(body), second: name(other) }
        }
        error => Failure::Simulation(error),
    }
}

/// Whether the steps allowed were too few; what else ends a run early is in its notes already.
fn steps_used_up<S: Shown>(args: &Args, answer: &Simulation<S>) -> Option<String> {
    let said = || format!("the limit of {} steps was reached; --max-steps allows more", args.max_steps);
    (answer.solver.steps >= args.max_steps).then(said)
}

fn write_files<S: Shown>(args: &Args, run: &Run<S>, answer: &Simulation<S>) -> Result<(), Failure> {
    if let Some(path) = &args.trajectory {
        let text =
            if is_csv(path) { report::trajectory::csv(run, answer) } else { report::trajectory::jsonl(run, answer) };
        output::picture(path, &text)?;
    }
    if let Some(path) = &args.svg {
        output::picture(path, &report::svg::simulation(run, answer))?;
    }
    if let Some(path) = &args.html {
        output::picture(path, &report::html::simulation(run, answer))?;
    }
    Ok(())
}

impl Args {
    fn options(&self) -> Options {
        let defaults = Options::default();
        Options {
            model: match self.model {
                Model::Auto | Model::Frictionless => ModelKind::Auto,
                Model::St => ModelKind::StewartTrinkle,
                Model::Moreau => ModelKind::Moreau,
                Model::Spk => ModelKind::SongPangKumar,
            },
            policy: match self.policy {
                Pick::First => Policy::First,
                Pick::Adverse => Policy::Adverse,
            },
            step: self.step,
            tolerance: self.tolerance.unwrap_or(defaults.tolerance),
            recovery_speed: self.recovery_speed,
            frames: self.frames,
            max_steps: self.max_steps,
            forces: true,
            ..defaults
        }
    }
}

fn is_csv(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("csv"))
}

/// Reads the name of a file for a trajectory.
fn trajectory(text: &str) -> Result<PathBuf, &'static str> {
    let path = PathBuf::from(text);
    let is_jsonl = path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("jsonl"));
    if is_csv(&path) || is_jsonl { Ok(path) } else { Err("a trajectory is a file that ends in .csv or .jsonl") }
}

/// Reads a number above 0.
fn positive(text: &str) -> Result<f64, NumberError> {
    let number = to_f64(&parse_literal(text.trim())?);
    if number > 0.0 && number < f64::MAX { Ok(number) } else { Err(NumberError::NotPositive) }
}

/// Why a text is not a number above 0.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
enum NumberError {
    #[error("{0}; write 0.125, 1e-3 or 1/3")]
    Number(#[from] LiteralError),
    #[error("write a number above 0")]
    NotPositive,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_positive_and_trajectories_end_in_what_they_are() {
        assert_eq!((positive("1e-3"), positive("1/4")), (Ok(1e-3), Ok(0.25)));
        assert_eq!((positive("0"), positive("-1")), (Err(NumberError::NotPositive), Err(NumberError::NotPositive)));
        assert!(positive("1e-999").is_err() && positive("1e999").is_err() && positive("fast").is_err());
        assert!(trajectory("a.csv").is_ok() && trajectory("b/a.JSONL").is_ok());
        assert!(trajectory("a.json").is_err() && trajectory("csv").is_err());
    }
}
