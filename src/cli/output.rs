//! Writing: answers, warnings, and files that are whole or absent.

use super::Failure;
use serde_json::Value;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::Path;

/// How an answer is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum Format {
    /// For people: the answer in the first line
    Text,
    /// One JSON document, every number exact
    Json,
}

/// Writes the answer in the format that was asked for.
pub fn answer(
    out: &mut dyn Write,
    format: Format,
    text: impl FnOnce() -> String,
    json: impl FnOnce() -> Value,
) -> Result<(), Failure> {
    match format {
        Format::Text => out.write_all(text().as_bytes())?,
        Format::Json => out.write_all(partplan::report::json::document(&json()).as_bytes())?,
    }
    out.flush()?;
    Ok(())
}

/// Writes to standard error; if nobody listens, so be it.
pub fn complain(message: &str) {
    let _ = writeln!(io::stderr().lock(), "{message}");
}

/// Writes a drawing beside its final name first: whoever reads `path` sees the old file or the whole new one.
pub fn picture(path: &Path, content: &str) -> Result<(), Failure> {
    write_whole(path, content.as_bytes()).map_err(|source| Failure::Picture { path: path.to_owned(), source })
}

fn write_whole(path: &Path, content: &[u8]) -> io::Result<()> {
    let name = path.file_name().ok_or_else(|| io::Error::new(io::ErrorKind::InvalidInput, "not a file name"))?;
    if path.is_dir() {
        return Err(io::ErrorKind::IsADirectory.into());
    }
    let mut hidden = std::ffi::OsString::from(".");
    hidden.push(name);
    hidden.push(format!(".{}.tmp", std::process::id()));
    let temporary = path.with_file_name(hidden);
    let written = File::create(&temporary)
        .and_then(|mut file| file.write_all(content).and_then(|()| file.sync_all()))
        .and_then(|()| fs::rename(&temporary, path));
    if written.is_err() {
        let _ = fs::remove_file(&temporary);
    }
    written
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_replaces_the_old_one_and_leaves_nothing_else() {
        let folder = std::env::temp_dir().join(format!("plan-picture-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        let path = folder.join("a.svg");
        write_whole(&path, b"old").unwrap();
        write_whole(&path, b"new").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"new");
        assert!(write_whole(&folder, b"x").is_err());
        assert!(write_whole(&folder.join("missing").join("a.svg"), b"x").is_err());
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 1);
        fs::remove_dir_all(&folder).unwrap();
    }
}
