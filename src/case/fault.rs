//! One fault of a case file: what is wrong, where, and what would be right.

use super::kind::FaultKind;
use std::ops::Range;

/// One thing that is wrong with a case file.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{kind}")]
pub struct Fault {
    kind: Box<FaultKind>,
    span: Option<Range<usize>>,
    path: String,
    help: Option<String>,
    related: Option<Box<Related>>,
}

/// A second place that a fault speaks about.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Related {
    /// Bytes of the file.
    pub span: Range<usize>,
    /// What is there.
    pub label: String,
}

impl Fault {
    pub(super) fn new(kind: FaultKind) -> Self {
        Self { kind: Box::new(kind), span: None, path: String::new(), help: None, related: None }
    }

    pub(super) fn at(mut self, span: Range<usize>) -> Self {
        self.span = Some(span);
        self
    }

    pub(super) fn on(mut self, path: String) -> Self {
        self.path = path;
        self
    }

    pub(super) fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }

    pub(super) fn related(mut self, span: Range<usize>, label: impl Into<String>) -> Self {
        self.related = Some(Box::new(Related { span, label: label.into() }));
        self
    }

    /// What is wrong.
    #[must_use]
    pub fn kind(&self) -> &FaultKind {
        &self.kind
    }

    /// The stable code of the kind, e.g. `C021`.
    #[must_use]
    pub fn code(&self) -> &'static str {
        self.kind.code()
    }

    /// The message: lower case, no full stop.
    #[must_use]
    pub fn message(&self) -> String {
        self.kind.to_string()
    }

    /// The bytes of the file that the fault is about; `None` if it is about the file as a whole.
    #[must_use]
    pub fn span(&self) -> Option<Range<usize>> {
        self.span.clone()
    }

    /// JSON path, like `insert.fixels[1].friction.static`; empty for the document itself.
    #[must_use]
    pub fn path(&self) -> &str {
        &self.path
    }

    /// What would be right.
    #[must_use]
    pub fn help_text(&self) -> Option<&str> {
        self.help.as_deref()
    }

    /// A second place that the fault speaks about.
    #[must_use]
    pub fn related_place(&self) -> Option<&Related> {
        self.related.as_deref()
    }

    /// Line and column in `text`, both from 1; columns count characters.
    #[must_use]
    pub fn position(&self, text: &[u8]) -> (usize, usize) {
        position(text, self.span.as_ref().map_or(0, |span| span.start))
    }

    /// Line in `text`, from 1.
    #[must_use]
    pub fn line(&self, text: &[u8]) -> usize {
        self.position(text).0
    }

    /// Column in `text`, from 1, in characters.
    #[must_use]
    pub fn column(&self, text: &[u8]) -> usize {
        self.position(text).1
    }
}

/// Line and column of byte `offset`, both from 1; columns count characters.
pub(super) fn position(text: &[u8], offset: usize) -> (usize, usize) {
    let before = &text[..offset.min(text.len())];
    let line_start = before.iter().rposition(|b| *b == b'\n').map_or(0, |at| at + 1);
    let lines = before.iter().filter(|b| **b == b'\n').count();
    (lines + 1, String::from_utf8_lossy(&before[line_start..]).chars().count() + 1)
}
