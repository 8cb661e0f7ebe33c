//! Case files: JSON text read exactly, every fault reported at once.

use crate::model::{Fixture, Part};

/// What a case file says.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Case {
    /// Its name, if given.
    pub name: Option<String>,
    /// The part.
    pub part: Part,
    /// The `insert` section, if present.
    pub fixture: Option<Fixture>,
    /// Things worth knowing that are not errors: points moved onto the outline, an inertia taken about another point.
    pub warnings: Vec<String>,
}

/// Bounds on what a case may hold, so that reading and planning end in bounded time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Limits {
    /// Largest file, in bytes.
    pub bytes: usize,
    /// Most vertices of the part.
    pub vertices: usize,
    /// Most fixels.
    pub fixels: usize,
}

impl Default for Limits {
    fn default() -> Self {
        Self { bytes: 16 << 20, vertices: 10_000, fixels: 64 }
    }
}

/// Reads a case file.
///
/// # Errors
/// Every fault of the file at once.
pub fn read(bytes: &[u8], limits: &Limits) -> Result<Case, Vec<Fault>> {
    let _ = (bytes, limits);
    todo!()
}

/// One thing that is wrong with a case file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fault {}
