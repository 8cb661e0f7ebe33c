//! What many runs came to so far, in a file that a kill at any moment leaves whole.

use super::{Failure, output};
use partplan::answer::Tally;
use serde_json::{Value, json};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// The runs up to a number, and where they are kept.
pub struct State {
    path: Option<PathBuf>,
    key: String,
    /// What they came to.
    pub tally: Tally,
}

impl State {
    /// Reads the state of the same question, or begins anew where the file is not there; no more than `runs` may be in it.
    pub fn open(path: Option<&Path>, key: &str, runs: u64) -> Result<Self, Failure> {
        let mut state = Self { path: path.map(Path::to_owned), key: digest(key), tally: Tally::default() };
        let Some(path) = path else { return Ok(state) };
        let bytes = match fs::read(path) {
            Ok(bytes) => bytes,
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(state),
            Err(source) => return Err(Failure::Read { path: path.display().to_string(), source }),
        };
        let refuse = |why: &str| Failure::State { path: path.to_owned(), why: why.to_owned() };
        let document: Value = serde_json::from_slice(&bytes).map_err(|error| refuse(&error.to_string()))?;
        if document["key"] != state.key.as_str() {
            return Err(refuse("it belongs to another case, seed, setting or version"));
        }
        state.tally = read(&document["tally"]).ok_or_else(|| refuse("its tally is not whole"))?;
        if state.next() > runs {
            return Err(refuse(&format!("it holds {} runs already, more than asked for", state.next())));
        }
        Ok(state)
    }

    /// Number of the next run.
    pub fn next(&self) -> u64 {
        self.tally.runs()
    }

    /// Adds the next runs and writes them down.
    pub fn add(&mut self, tally: &Tally) -> Result<(), Failure> {
        self.tally.add(tally);
        let Some(path) = &self.path else { return Ok(()) };
        output::picture(path, &json!({ "key": self.key, "tally": written(&self.tally) }).to_string())
    }
}

fn written(tally: &Tally) -> Value {
    let Tally { confirmed, moving, refuted, inconclusive, reasons, margin } = tally;
    let margin = margin.map(|(left, run)| json!([left.to_bits(), run]));
    json!({
        "confirmed": confirmed,
        "moving": moving,
        "refuted": refuted,
        "inconclusive": inconclusive,
        "reasons": reasons,
        "margin": margin,
    })
}

fn read(value: &Value) -> Option<Tally> {
    let pair = |value: &Value| Some((value[0].as_str()?.to_owned(), value[1].as_u64()?));
    let margin = match &value["margin"] {
        Value::Null => None,
        margin => Some((f64::from_bits(margin[0].as_u64()?), margin[1].as_u64()?)),
    };
    Some(Tally {
        confirmed: value["confirmed"].as_u64()?,
        moving: value["moving"].as_u64()?,
        refuted: value["refuted"].as_array()?.iter().map(Value::as_u64).collect::<Option<_>>()?,
        inconclusive: value["inconclusive"].as_u64()?,
        reasons: value["reasons"].as_array()?.iter().map(pair).collect::<Option<_>>()?,
        margin,
    })
}

/// FNV-1a of a text, 64 bits: tells states of different questions apart, not those of an adversary.
pub fn digest(text: &str) -> String {
    let step = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    format!("{:016x}", text.bytes().fold(0xcbf2_9ce4_8422_2325, step))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_is_read_back_and_others_are_refused() {
        let folder = std::env::temp_dir().join(format!("plan-state-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        let path = folder.join("state.json");
        let tally = Tally {
            confirmed: 5,
            moving: 4,
            refuted: vec![2, 7],
            inconclusive: 1,
            reasons: vec![("jams".to_owned(), 2), ("time".to_owned(), 1)],
            margin: Some((0.1 + 0.2, 3)),
        };
        let mut state = State::open(Some(&path), "a", 100).unwrap();
        state.add(&tally).unwrap();
        assert_eq!(State::open(Some(&path), "a", 100).unwrap().tally, tally);
        assert!(matches!(State::open(Some(&path), "b", 100), Err(Failure::State { .. })));
        assert!(matches!(State::open(Some(&path), "a", 7), Err(Failure::State { .. })));
        fs::write(&path, "{\"key\":").unwrap();
        assert!(matches!(State::open(Some(&path), "a", 100), Err(Failure::State { .. })));
        fs::remove_dir_all(&folder).unwrap();
    }
}
