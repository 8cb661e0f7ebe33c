/// What ended a run before its answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Limit {
    /// The time was over.
    Time,
    /// Too much memory was in use.
    Memory,
}

impl Limit {
    /// The limit's name in documents.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Time => "time",
            Self::Memory => "memory",
        }
    }
}
