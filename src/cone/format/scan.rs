//! Words of a text with their places.

use super::fault::{FormatError, FormatFault};

/// A word and where it stands.
#[derive(Debug, Clone, Copy)]
pub(super) struct Word<'a> {
    pub(super) text: &'a str,
    /// Line, from one.
    pub(super) line: usize,
    /// Column in characters, from one.
    pub(super) column: usize,
    /// Whether it is the first of its line.
    pub(super) is_first: bool,
}

impl Word<'_> {
    pub(super) fn error(&self, fault: FormatFault) -> FormatError {
        FormatError { line: self.line, column: self.column, fault }
    }

    pub(super) fn is(&self, keyword: &str) -> bool {
        self.text.eq_ignore_ascii_case(keyword)
    }

    /// The word for a message, shortened.
    pub(super) fn shown(&self) -> String {
        const LONGEST: usize = 40;
        if self.text.chars().count() <= LONGEST {
            return self.text.to_owned();
        }
        self.text.chars().take(LONGEST).chain(['…']).collect()
    }
}

/// Reads words one after the other, across lines.
#[derive(Debug, Clone)]
pub(super) struct Scanner<'a> {
    rest: &'a str,
    line: usize,
    column: usize,
    is_first: bool,
}

impl<'a> Scanner<'a> {
    pub(super) fn new(text: &'a str) -> Self {
        Self { rest: text.trim_start_matches('\u{feff}'), line: 1, column: 1, is_first: true }
    }

    /// The next word, on this line or a later one.
    pub(super) fn next(&mut self) -> Option<Word<'a>> {
        self.skip_space(false);
        self.word()
    }

    /// The next word of this line.
    pub(super) fn next_here(&mut self) -> Option<Word<'a>> {
        self.skip_space(true);
        if self.rest.starts_with('\n') { None } else { self.word() }
    }

    /// As [`Scanner::next`], past lines that start with `*`.
    pub(super) fn next_past_comments(&mut self) -> Option<Word<'a>> {
        loop {
            match self.next()? {
                word if word.is_first && word.text.starts_with('*') => self.skip_line(),
                word => return Some(word),
            }
        }
    }

    /// Moves to the end of this line.
    pub(super) fn skip_line(&mut self) {
        let end = self.rest.find('\n').unwrap_or(self.rest.len());
        self.advance(end);
    }

    /// The error that something is missing here.
    pub(super) fn error(&self, fault: FormatFault) -> FormatError {
        FormatError { line: self.line, column: self.column, fault }
    }

    fn word(&mut self) -> Option<Word<'a>> {
        let end = self.rest.find(char::is_whitespace).unwrap_or(self.rest.len());
        if end == 0 {
            return None;
        }
        let word = Word { text: &self.rest[..end], line: self.line, column: self.column, is_first: self.is_first };
        self.advance(end);
        self.is_first = false;
        Some(word)
    }

    fn advance(&mut self, end: usize) {
        self.column += self.rest[..end].chars().count();
        self.rest = &self.rest[end..];
    }

    fn skip_space(&mut self, here: bool) {
        while let Some(space) = self.rest.chars().next().filter(|c| c.is_whitespace() && !(here && *c == '\n')) {
            self.rest = &self.rest[space.len_utf8()..];
            if space == '\n' {
                (self.line, self.column, self.is_first) = (self.line + 1, 1, true);
            } else {
                self.column += 1;
            }
        }
    }
}
