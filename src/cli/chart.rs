//! `plan chart`: error against time for every method, and where methods fail.

use super::common::{Common, When};
use super::limit::Limits;
use super::output::Format;
use super::progress::Bar;
use super::stop::{Reason, Stop};
use super::{Failure, Outcome, input, output};
use clap::builder::NonEmptyStringValueParser;
use partplan::answer::{Chart, ChartFamily, ChartMap};
use partplan::chart::{self, ChartQuestion};
use partplan::model::Scene;
use partplan::report;
use std::cell::RefCell;
use std::io::Write;
use std::path::{Path, PathBuf};

/// Chart the error of every method against its time
///
/// Runs the methods of each family on the same work: time-steppers, the model ladder, contact problems, cones, toppling heights
/// and throws; then draws error against time, and maps of where methods fail. With cases, their scenes are the work. Errors and
/// failures are the same for a seed; times are quartiles of CPU times. Writes chart.html, chart.csv, chart.md and drawings into
/// a folder.
#[derive(Debug, clap::Args)]
#[command(after_help = "Example: plan chart --quick --out chart")]
pub struct Args {
    /// Files with scenes to be run instead of the built-in work
    #[arg(value_name = "CASE", value_parser = NonEmptyStringValueParser::new())]
    cases: Vec<String>,

    /// Write pages, tables and drawings into this folder
    #[arg(long, value_name = "DIR", default_value = "chart")]
    out: PathBuf,

    /// Fewer points and fewer runs: within a minute
    #[arg(long)]
    quick: bool,

    /// From which random work is drawn
    #[arg(long, value_name = "S", default_value_t = 0)]
    seed: u64,

    /// Only points and tiles whose ids begin like this, as in chart.csv
    #[arg(long, value_name = "ID")]
    only: Option<String>,

    /// Draw this chart.csv again instead of measuring
    #[arg(long, value_name = "FILE", conflicts_with_all = ["cases", "quick", "seed", "only"])]
    from: Option<PathBuf>,

    /// How the answer is written
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,

    /// Color of the messages
    #[arg(long, value_enum, default_value_t = When::Auto, value_name = "WHEN")]
    color: When,

    #[command(flatten)]
    limits: Limits,
}

/// Measures, or reads what was measured, and draws it.
pub fn run(args: &Args, out: &mut dyn Write) -> Result<Outcome, Failure> {
    let (chart, reason) = match &args.from {
        Some(path) => (read(path)?, None),
        None => measured(args)?,
    };
    std::fs::create_dir_all(&args.out).map_err(|source| Failure::Picture { path: args.out.clone(), source })?;
    let write = |name: &str, content: &str| output::picture(&args.out.join(name), content);
    write("chart.csv", &report::csv::chart(&chart))?;
    write("chart.md", &report::markdown::chart(&chart))?;
    for family in ChartFamily::ALL {
        if let Some(figure) = report::svg::chart(&chart, family) {
            write(&format!("{}.svg", family.name()), &figure)?;
        }
    }
    for map in ChartMap::ALL {
        if let Some(figure) = report::svg::failures(&chart, map) {
            write(&format!("{}.svg", map.name()), &figure)?;
        }
    }
    write("chart.html", &report::html::chart(&chart))?;
    output::answer(out, args.format, || report::text::chart(&chart), || report::json::chart(&chart))?;
    Ok(match reason {
        Some(Reason::Interrupt) => Outcome::Interrupted,
        Some(Reason::Limit(_)) => Outcome::Undecided,
        None => Outcome::Yes,
    })
}

fn read(path: &Path) -> Result<Chart, Failure> {
    let text = std::fs::read_to_string(path)
        .map_err(|source| Failure::Chart { path: path.to_owned(), why: source.to_string() })?;
    report::csv::read_chart(&text).map_err(|why| Failure::Chart { path: path.to_owned(), why: why.to_string() })
}

fn measured(args: &Args) -> Result<(Chart, Option<Reason>), Failure> {
    let scenes = args.cases.iter().map(|case| scene(args, case)).collect::<Result<_, _>>()?;
    let question = ChartQuestion { quick: args.quick, seed: args.seed, only: args.only.clone(), scenes };
    if cfg!(debug_assertions) {
        output::complain("warning: this is no release build: its times say little");
    }
    let (bar, stop) = (Bar::new(), RefCell::new(Stop::new(args.limits)));
    let mut chart = chart::chart(&question, &|progress| {
        bar.show_chart(&progress);
        stop.borrow_mut().goes_on()
    });
    bar.clear();
    let stop = stop.into_inner();
    if let (Some(only), [], []) = (&args.only, &chart.points[..], &chart.tiles[..])
        && stop.reason().is_none()
    {
        return Err(Failure::NoPart { only: only.clone(), parts: chart::parts().join(", ") });
    }
    if let Some(note) = stop.note() {
        output::complain(&format!("after {} points and {} tiles: {note}", chart.points.len(), chart.tiles.len()));
    }
    if let Some(Reason::Limit(limit)) = stop.reason() {
        chart.limit = Some(limit);
    }
    chart.conditions = conditions(args);
    Ok((chart, stop.reason()))
}

/// The scene of a case, by its name.
fn scene(args: &Args, case: &str) -> Result<(String, Scene), Failure> {
    let limits = partplan::case::Limits::default();
    let common = Common {
        case: case.to_owned(),
        format: args.format,
        color: args.color,
        limits: args.limits,
        max_vertices: limits.vertices,
        max_bytes: limits.bytes,
    };
    let task = input::scene(&common)?;
    Ok((task.name, task.case.scene))
}

/// Where and with what it is measured.
fn conditions(args: &Args) -> Vec<(String, String)> {
    let cpu = std::fs::read_to_string("/proc/cpuinfo").ok();
    let cpu = cpu.as_deref().and_then(|text| text.lines().find(|line| line.starts_with("model name")));
    let cpu = cpu.and_then(|line| line.split_once(':')).map_or("unknown", |(_, name)| name.trim());
    let processors = std::thread::available_parallelism().map_or(0, std::num::NonZero::get);
    let mut all = vec![
        ("run", if args.quick { "quick" } else { "whole" }.to_owned()),
        ("seed", args.seed.to_string()),
        ("plan", env!("CARGO_PKG_VERSION").to_owned()),
        ("build", if cfg!(debug_assertions) { "debug" } else { "release" }.to_owned()),
        ("system", format!("{} on {}", std::env::consts::OS, std::env::consts::ARCH)),
        ("processor", format!("{cpu}, {processors} of them; one is used")),
    ];
    if !args.cases.is_empty() {
        all.push(("cases", args.cases.iter().map(|case| report::csv::quoted(case)).collect::<Vec<_>>().join(" ")));
    }
    all.into_iter().map(|(name, value)| (name.to_owned(), value)).collect()
}
