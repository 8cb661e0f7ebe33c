//! `plan convert`: polyhedra from inequalities to generators and back.

use super::limit::Limits;
use super::output::Format;
use super::{Failure, Outcome, input, limit, output};
use clap::builder::NonEmptyStringValueParser;
use partplan::answer::{Polyhedron, RowFates};
use partplan::cone::{self, Converted, Extras, format};
use partplan::report;
use std::collections::HashSet;
use std::io::Write;

/// Convert a polyhedron between inequalities and generators, exactly
///
/// The file has the form of cddlib and lrslib (.ine, .ext); a row b a1 a2 .. of an H-representation means
/// b + a1 x1 + a2 x2 + .. >= 0, a row of a V-representation is a point 1 x1 x2 .. or a ray 0 x1 x2 .., and the rows of a
/// linearity line are equalities or lines. The other representation is written in the same form, minimal and canonical.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLE)]
pub struct Args {
    /// Polyhedron file, or - for standard input
    #[arg(value_name = "FILE", value_parser = NonEmptyStringValueParser::new())]
    file: String,

    /// Keep the representation and drop redundant rows; say which they are and which are implicitly linear
    #[arg(long)]
    redundancy: bool,

    /// Keep the representation and project to these variables, counted from 1
    #[arg(long, value_name = "COLUMNS", value_delimiter = ',', num_args = 1, value_parser = variable)]
    #[arg(conflicts_with = "redundancy")]
    project: Vec<usize>,

    /// List for each row the rows adjacent to it
    #[arg(long)]
    adjacency: bool,

    /// List for each row the input rows that it lies on
    #[arg(long, conflicts_with_all = ["redundancy", "project"])]
    incidence: bool,

    /// How the answer is written
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,

    #[command(flatten)]
    limits: Limits,

    /// Largest file accepted, in bytes
    #[arg(long, value_name = "N", default_value_t = 16 << 20)]
    max_bytes: usize,
}

const EXAMPLE: &str = "\
Lists of rows follow the matrix as comments and count from 1. Generators that span an edge are
adjacent, and facets that share a ridge; edges and ridges at infinity count.

Example: plan convert cases/corner.ine --adjacency";

/// Converts a polyhedron.
pub fn run(args: &Args, out: &mut dyn Write) -> Result<Outcome, Failure> {
    let bytes = input::bytes(&args.file, args.max_bytes, "cube.ine")?;
    let shown = if args.file == "-" { "standard input" } else { &args.file };
    if bytes.len() > args.max_bytes {
        return Err(Failure::TooLong { path: shown.to_owned(), limit: args.max_bytes });
    }
    let mut seen = HashSet::new();
    if let Some(variable) = args.project.iter().copied().find(|variable| !seen.insert(*variable)) {
        return Err(Failure::VariableTwice { variable });
    }
    let name = input::stem(&args.file);
    let wish = Wish { redundancy: args.redundancy, variables: args.project.clone(), extras: args.extras() };
    let found = match args.limits.within(move || wish.fulfil(&bytes)) {
        Ok(found) => found,
        Err(reached) => {
            let document = || report::json::undecided_polyhedron(&name, reached);
            args.limits.say_reached(reached, args.format, document, out)?;
            return Ok(limit::OVER);
        }
    };
    let (converted, warnings) = found.map_err(|refusal| refusal.into_failure(shown))?;
    for warning in &warnings {
        output::complain(&format!("warning: {shown}: {warning}"));
    }
    let answer = answer(&converted);
    output::answer(
        out,
        args.format,
        || format::write(&converted.polyhedron) + &report::text::polyhedron_notes(&answer),
        || report::json::polyhedron(&name, &warnings, &answer),
    )?;
    Ok(Outcome::Yes)
}

impl Args {
    fn extras(&self) -> Extras {
        Extras { adjacency: self.adjacency, incidence: self.incidence }
    }
}

/// What to do with the polyhedron.
struct Wish {
    redundancy: bool,
    /// Variables to keep, from one; all if there are none.
    variables: Vec<usize>,
    extras: Extras,
}

enum Refusal {
    Format(format::FormatError),
    NoVariable { variable: usize, count: usize },
}

impl Refusal {
    fn into_failure(self, path: &str) -> Failure {
        match self {
            Self::Format(fault) => Failure::Polyhedron { path: path.to_owned(), fault },
            Self::NoVariable { variable, count } => Failure::NoVariable { variable, count },
        }
    }
}

impl Wish {
    fn fulfil(&self, bytes: &[u8]) -> Result<(Converted, Vec<String>), Refusal> {
        let format::Document { polyhedron, warnings } = format::read(bytes).map_err(Refusal::Format)?;
        let count = polyhedron.columns() - 1;
        if let Some(variable) = self.variables.iter().copied().find(|variable| *variable > count) {
            return Err(Refusal::NoVariable { variable, count });
        }
        let converted = if self.redundancy {
            cone::without_redundancy(&polyhedron, self.extras)
        } else if self.variables.is_empty() {
            cone::convert(&polyhedron, self.extras)
        } else {
            let variables: Vec<usize> = self.variables.iter().map(|variable| variable - 1).collect();
            cone::project(&polyhedron, &variables, self.extras)
        };
        Ok((converted, warnings))
    }
}

/// The converted polyhedron as reports know it: rows counted from one.
fn answer(converted: &Converted) -> Polyhedron {
    let from_one = |rows: &Vec<usize>| -> Vec<usize> { rows.iter().map(|row| row + 1).collect() };
    let lists = |lists: &Option<Vec<Vec<usize>>>| lists.as_ref().map(|lists| lists.iter().map(from_one).collect());
    let polyhedron = &converted.polyhedron;
    Polyhedron {
        representation: polyhedron.representation().letter(),
        columns: polyhedron.columns(),
        dimension: converted.dimension,
        n_linear: polyhedron.linear().len(),
        rows: polyhedron.rows().to_vec(),
        adjacency: lists(&converted.adjacency),
        incidence: lists(&converted.incidence),
        fates: converted.fates.as_ref().map(|fates| RowFates {
            kept: from_one(&fates.kept),
            redundant: from_one(&fates.redundant),
            implicit: from_one(&fates.implicit),
        }),
    }
}

/// Reads the number of a variable.
fn variable(text: &str) -> Result<usize, String> {
    match text.trim().parse() {
        Ok(number) if number > 0 => Ok(number),
        _ => Err(format!("\"{text}\" is no variable; write their numbers from 1, as in --project 1,3")),
    }
}
