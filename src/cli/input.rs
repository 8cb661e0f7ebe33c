//! Reading case files, never more than asked for.

use super::common::Common;
use super::{Failure, output};
use partplan::case::{self, Case};
use partplan::model::Fixture;
use partplan::report::Subject;
use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

/// A case that has the section its command needs.
pub struct Task {
    name: String,
    /// The case.
    pub case: Case,
    /// Its `insert` section.
    pub fixture: Fixture,
}

impl Task {
    /// What the report is about.
    pub fn subject(&self) -> Subject<'_> {
        Subject { name: &self.name, part: &self.case.part, fixture: &self.fixture, warnings: &self.case.warnings }
    }
}

/// Reads the case, says its warnings on standard error, and looks for its `insert` section.
pub fn task(common: &Common) -> Result<Task, Failure> {
    let shown = if common.case == "-" { "standard input" } else { &common.case };
    let bytes = bytes(&common.case, common.max_bytes, "part.json")?;
    let refuse = |faults: &[case::Fault]| Failure::Case(case::render(faults, shown, &bytes, common.color.on_stderr()));
    let mut case = case::read(&bytes, &common.case_limits()).map_err(|faults| refuse(&faults))?;
    let fixture = case.fixture.take().ok_or_else(|| refuse(&[case::missing_section("insert")]))?;
    for warning in &case.warnings {
        output::complain(&format!("warning: {shown}: {warning}"));
    }
    let name = case.name.clone().unwrap_or_else(|| stem(&common.case));
    Ok(Task { name, case, fixture })
}

/// One byte more than the limit is enough to know that there are too many.
///
/// `example` names a file that could be meant where a folder is given.
pub fn bytes(path: &str, limit: usize, example: &'static str) -> Result<Vec<u8>, Failure> {
    let limit = u64::try_from(limit).unwrap_or(u64::MAX).saturating_add(1);
    let mut bytes = Vec::new();
    let read = if path == "-" {
        io::stdin().lock().take(limit).read_to_end(&mut bytes)
    } else {
        if Path::new(path).is_dir() {
            return Err(Failure::Folder { path: path.trim_end_matches('/').to_owned(), example });
        }
        File::open(path).and_then(|file| file.take(limit).read_to_end(&mut bytes))
    };
    read.map_err(|source| Failure::Read { path: path.to_owned(), source })?;
    Ok(bytes)
}

/// The name of a file without folders and extension.
pub fn stem(path: &str) -> String {
    match Path::new(path).file_stem() {
        Some(stem) if path != "-" => stem.to_string_lossy().into_owned(),
        _ => "standard input".to_owned(),
    }
}
