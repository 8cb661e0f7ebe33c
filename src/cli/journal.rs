//! Evaluations of a search, written down one by one: a kill at any moment loses those in flight only.

use super::Failure;
use super::state::digest;
use partplan::design::Score;
use serde_json::{Value, json};
use std::collections::HashMap;
use std::fs::{self, File};
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

/// Scores by the bits of the design, and the file that they are added to.
pub struct Journal {
    known: HashMap<Vec<u64>, Score>,
    file: Option<(PathBuf, File)>,
}

impl Journal {
    /// Reads what a search with this key has written, or begins anew where the file is not there. A last line that a kill cut
    /// short is left out.
    pub fn open(path: Option<&Path>, key: &str) -> Result<Self, Failure> {
        let Some(path) = path else { return Ok(Self { known: HashMap::new(), file: None }) };
        let key = digest(key);
        let text = match fs::read_to_string(path) {
            Ok(text) => text,
            Err(error) if error.kind() == io::ErrorKind::NotFound => String::new(),
            Err(source) => return Err(Failure::Read { path: path.display().to_string(), source }),
        };
        let whole = text.rfind('\n').map_or("", |end| &text[..=end]);
        let refuse = |why: &str| Failure::State { path: path.to_owned(), why: why.to_owned() };
        let mut lines = whole.lines();
        match lines.next() {
            None if text.is_empty() || !whole.is_empty() => {}
            None => return Err(refuse("its first line is not whole")),
            Some(head) => {
                let head: Value = serde_json::from_str(head).map_err(|error| refuse(&error.to_string()))?;
                if head["key"] != key.as_str() {
                    return Err(refuse("it belongs to another case, seed, setting or version"));
                }
            }
        }
        let known = lines.map(|line| read(line).ok_or_else(|| refuse("one of its lines is no evaluation")));
        let known = known.collect::<Result<HashMap<_, _>, _>>()?;
        let write = |source| Failure::Picture { path: path.to_owned(), source };
        let mut file = File::options().create(true).append(true).open(path).map_err(write)?;
        file.set_len(whole.len() as u64).map_err(write)?;
        if whole.is_empty() {
            writeln!(file, "{}", json!({ "key": key })).map_err(write)?;
        }
        Ok(Self { known, file: Some((path.to_owned(), file)) })
    }

    /// What is known of a design.
    pub fn score(&self, variables: &[f64]) -> Option<Score> {
        self.known.get(&bits(variables)).copied()
    }

    /// Writes a score down, unless it is known.
    pub fn add(&mut self, variables: &[f64], score: Score) -> Result<(), Failure> {
        if self.known.insert(bits(variables), score).is_some() {
            return Ok(());
        }
        let Some((path, file)) = &mut self.file else { return Ok(()) };
        let line = json!({ "at": bits(variables), "cost": score.cost.to_bits(), "passes": score.passes });
        writeln!(file, "{line}").map_err(|source| Failure::Picture { path: path.clone(), source })
    }
}

fn bits(variables: &[f64]) -> Vec<u64> {
    variables.iter().map(|value| value.to_bits()).collect()
}

fn read(line: &str) -> Option<(Vec<u64>, Score)> {
    let value: Value = serde_json::from_str(line).ok()?;
    let at = value["at"].as_array()?.iter().map(Value::as_u64).collect::<Option<_>>()?;
    let cost = f64::from_bits(value["cost"].as_u64()?);
    Some((at, Score { cost, passes: value["passes"].as_bool()? }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_written_is_read_but_for_a_line_cut_short() {
        let folder = std::env::temp_dir().join(format!("plan-journal-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        let path = folder.join("journal.jsonl");
        let scores = [
            (vec![0.1, 0.2], Score { cost: 0.1 + 0.2, passes: true }),
            (vec![1.0], Score { cost: 7.0, passes: false }),
        ];
        let mut journal = Journal::open(Some(&path), "a").unwrap();
        for (at, score) in &scores {
            journal.add(at, *score).unwrap();
            journal.add(at, *score).unwrap();
        }
        drop(journal);
        let text = fs::read_to_string(&path).unwrap();
        assert_eq!(text.lines().count(), 3);
        fs::write(&path, &text[..text.len() - 4]).unwrap();
        let journal = Journal::open(Some(&path), "a").unwrap();
        assert_eq!((journal.score(&scores[0].0), journal.score(&scores[1].0)), (Some(scores[0].1), None));
        assert!(matches!(Journal::open(Some(&path), "b"), Err(Failure::State { .. })));
        fs::write(&path, "{\"key\":\nno\n").unwrap();
        assert!(matches!(Journal::open(Some(&path), "a"), Err(Failure::State { .. })));
        fs::remove_dir_all(&folder).unwrap();
    }
}
