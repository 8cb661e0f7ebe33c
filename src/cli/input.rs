//! Reading case files, never more than asked for.

use super::common::{Common, Fixtured};
use super::state::digest;
use super::{Failure, output};
use partplan::case::{self, Case, FeederCase, SceneCase, Section};
use partplan::model::{Conveyor, Fixture, Thrower};
use partplan::report::{Ride, Subject, Toss};
use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

/// A case and the section that its command needs.
pub struct Task<S> {
    name: String,
    /// The case.
    pub case: Case,
    /// Its section.
    pub section: S,
}

impl Task<Fixture> {
    /// What the report is about.
    pub fn subject(&self) -> Subject<'_> {
        Subject { name: &self.name, part: &self.case.part, fixture: &self.section, warnings: &self.case.warnings }
    }
}

impl Task<Conveyor> {
    /// What the report is about; the answer is asked to end on this edge, and with so many pins at most.
    pub fn ride(&self, end: Option<usize>, max_pins: Option<usize>) -> Ride<'_> {
        Ride {
            name: &self.name,
            part: &self.case.part,
            conveyor: &self.section,
            warnings: &self.case.warnings,
            end,
            max_pins,
        }
    }
}

impl Task<Thrower> {
    /// What the report is about; a part is at rest on the first stable edge that it lands on, or not before it cannot leave it.
    pub fn toss(&self, settles_first: bool) -> Toss<'_> {
        Toss {
            name: &self.name,
            part: &self.case.part,
            thrower: &self.section,
            warnings: &self.case.warnings,
            settles_first,
        }
    }
}

/// Reads a case with an `insert` section.
pub fn fixtured(args: &Fixtured) -> Result<Task<Fixture>, Failure> {
    task(&args.common, &args.case_limits(), Section::Insert, |case| case.fixture.take())
}

/// The same for a command that has none of the other arguments on fixtures.
pub fn seated(common: &Common) -> Result<Task<Fixture>, Failure> {
    task(common, &common.case_limits(), Section::Insert, |case| case.fixture.take())
}

/// Reads a case with a `pins` section.
pub fn conveyed(common: &Common) -> Result<Task<Conveyor>, Failure> {
    task(common, &common.case_limits(), Section::Pins, |case| case.conveyor.take())
}

/// Reads a case with a `throw` section.
pub fn thrown(common: &Common) -> Result<Task<Thrower>, Failure> {
    task(common, &common.case_limits(), Section::Throw, |case| case.thrower.take())
}

/// Reads the case, says its warnings on standard error, and looks for its section.
fn task<S>(
    common: &Common,
    limits: &case::Limits,
    section: Section,
    take: impl FnOnce(&mut Case) -> Option<S>,
) -> Result<Task<S>, Failure> {
    let (mut case, bytes) = read(common, "part.json", |bytes| case::read_for(section, bytes, limits))?;
    let section = take(&mut case).ok_or_else(|| refused(common, &bytes, &[case::missing_section(section.key())]))?;
    warn(common, &case.warnings);
    let name = named(common, case.name.as_deref());
    Ok(Task { name, case, section })
}

/// Warnings shown of a scene, which may have one for each body.
const MOST_WARNINGS: usize = 5;

/// A scene and what it is called.
pub struct SceneTask {
    /// Its name, or that of its file.
    pub name: String,
    /// The scene.
    pub case: SceneCase,
}

/// Reads a case with a `scene` section and says its warnings on standard error.
pub fn scene(common: &Common) -> Result<SceneTask, Failure> {
    let (case, _) = read(common, "scene.json", |bytes| case::read_scene(bytes, &common.case_limits()))?;
    warn(common, &case.warnings[..case.warnings.len().min(MOST_WARNINGS)]);
    if let Some(more) = case.warnings.len().checked_sub(MOST_WARNINGS).filter(|more| *more > 0) {
        warn(common, &[format!("and {more} warnings more (--format json lists all)")]);
    }
    Ok(SceneTask { name: named(common, case.name.as_deref()), case })
}

/// A device and what it is called.
pub struct FeederTask {
    /// Its name, or that of its file.
    pub name: String,
    /// The device.
    pub case: FeederCase,
    /// Tells its text from other texts.
    pub digest: String,
}

/// Reads a case with a `feeder` section and says its warnings on standard error.
pub fn feeder(common: &Common) -> Result<FeederTask, Failure> {
    let (case, bytes) = read(common, "feeder.json", |bytes| case::read_feeder(bytes, &common.case_limits()))?;
    warn(common, &case.warnings);
    let name = named(common, case.name.as_deref());
    Ok(FeederTask { name, case, digest: digest(&String::from_utf8_lossy(&bytes)) })
}

/// What a file says, and its bytes.
fn read<T>(
    common: &Common,
    example: &'static str,
    read: impl FnOnce(&[u8]) -> Result<T, Vec<case::Fault>>,
) -> Result<(T, Vec<u8>), Failure> {
    let bytes = bytes(&common.case, common.max_bytes, example)?;
    match read(&bytes) {
        Ok(case) => Ok((case, bytes)),
        Err(faults) => Err(refused(common, &bytes, &faults)),
    }
}

fn refused(common: &Common, bytes: &[u8], faults: &[case::Fault]) -> Failure {
    Failure::Case(case::render(faults, shown(common), bytes, common.color.on_stderr()))
}

fn warn(common: &Common, warnings: &[String]) {
    for warning in warnings {
        output::complain(&format!("warning: {}: {warning}", shown(common)));
    }
}

/// What messages call the file.
fn shown(common: &Common) -> &str {
    if common.case == "-" { "standard input" } else { &common.case }
}

/// The name of a case, or of its file.
fn named(common: &Common, name: Option<&str>) -> String {
    name.map_or_else(|| stem(&common.case), str::to_owned)
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
