//! Faults as text for a terminal, in the look of the Rust compiler.

use super::fault::{Fault, position};
use annotate_snippets::renderer::DecorStyle;
use annotate_snippets::{AnnotationKind, Element, Group, Level, Origin, Renderer, Snippet};
use std::fmt::Write as _;
use std::ops::Range;

/// Faults that are shown; the rest are counted.
const MAX_SHOWN: usize = 20;

/// Bytes of a line shown before and after the start of a fault.
const BEFORE: usize = 60;
const AFTER: usize = 100;

/// The report on `faults`, which were found in `text`, the contents of the file `file_name`.
///
/// Shows the first twenty, each with one line of the file cut to the width of a terminal, whatever the file's size.
#[must_use]
pub fn render(faults: &[Fault], file_name: &str, text: &[u8], color: bool) -> String {
    let renderer = if color { Renderer::styled() } else { Renderer::plain() };
    let renderer = renderer.decor_style(DecorStyle::Ascii);
    let mut report = String::new();
    for fault in faults.iter().take(MAX_SHOWN) {
        let excerpts = Excerpts::new(fault, text);
        let rendered = renderer.render(&[group(fault, file_name, text, &excerpts)]);
        for line in rendered.lines().filter(|line| !is_bare_separator(line)) {
            report.push_str(line);
            report.push('\n');
        }
        report.push('\n');
    }
    if let Some(more) = faults.len().checked_sub(MAX_SHOWN).filter(|more| *more > 0) {
        let _ = writeln!(report, "... and {more} more");
    }
    report
}

/// Whether a line is `:::` alone, which the renderer puts before a snippet whose origin is an element of its own.
///
/// Origins are elements because the renderer would count columns from the start of a cut line.
fn is_bare_separator(line: &str) -> bool {
    let mut plain = String::new();
    let mut in_escape = false;
    for c in line.chars() {
        match c {
            '\u{1b}' => in_escape = true,
            'm' if in_escape => in_escape = false,
            _ if in_escape => {}
            _ => plain.push(c),
        }
    }
    plain.trim() == ":::"
}

/// The lines that a fault shows.
struct Excerpts {
    primary: Option<Excerpt>,
    related: Option<Excerpt>,
}

impl Excerpts {
    fn new(fault: &Fault, text: &[u8]) -> Self {
        let primary = fault.span().map(|span| Excerpt::new(text, &span));
        let related = fault.related_place().map(|related| Excerpt::new(text, &related.span));
        Self { primary, related }
    }
}

/// A line, or a part of a long one, and where in it the fault is.
struct Excerpt {
    line: String,
    span: Range<usize>,
    bytes: Range<usize>,
    prefix: usize,
    number: usize,
}

impl Excerpt {
    fn new(text: &[u8], span: &Range<usize>) -> Self {
        let start = span.start.min(text.len());
        let line_start = text[..start].iter().rposition(|b| *b == b'\n').map_or(0, |at| at + 1);
        let line_end = text[start..].iter().position(|b| *b == b'\n').map_or(text.len(), |at| start + at);
        let from = boundary(text, start.saturating_sub(BEFORE).max(line_start)).min(start);
        let to = boundary(text, (start + AFTER).min(line_end)).max(start);
        let end = span.end.clamp(start, to);
        let shown = |range: Range<usize>| String::from_utf8_lossy(&text[range]).into_owned();
        let mut line = if from > line_start { String::from("…") } else { String::new() };
        let prefix = line.len();
        line.push_str(&shown(from..start));
        let marked = line.len();
        line.push_str(&shown(start..end));
        let marked = marked..line.len();
        line.push_str(&shown(end..to));
        if to < line_end {
            line.push('…');
        }
        Self { line, span: marked, bytes: from..to, prefix, number: position(text, start).0 }
    }
}

/// The next position from `at` on that does not split a character of valid UTF-8.
fn boundary(text: &[u8], at: usize) -> usize {
    let is_continuation = |at: &usize| text.get(*at).is_some_and(|b| b & 0xc0 == 0x80);
    (at..at + 4).find(|at| !is_continuation(at)).unwrap_or(at).min(text.len())
}

fn group<'a>(fault: &'a Fault, file_name: &'a str, text: &[u8], excerpts: &'a Excerpts) -> Group<'a> {
    let mut elements: Vec<Element> = Vec::new();
    let origin = |offset: usize| {
        let (line, column) = position(text, offset);
        Origin::path(file_name).line(line).char_column(column)
    };
    let mut related = fault.related_place().zip(excerpts.related.as_ref());
    match (fault.span(), &excerpts.primary) {
        (Some(span), Some(excerpt)) => {
            let mut annotations = vec![AnnotationKind::Primary.span(excerpt.span.clone()).label(fault.path())];
            if let Some((place, _)) = related
                && excerpt.bytes.start <= place.span.start
                && place.span.end <= excerpt.bytes.end
                && (place.span.end <= span.start || span.end <= place.span.start)
            {
                // only texts that are not UTF-8 differ from their view, and their faults speak about one place
                let shift = |at: usize| at - excerpt.bytes.start + excerpt.prefix;
                let within = shift(place.span.start)..shift(place.span.end);
                annotations.push(AnnotationKind::Context.span(within).label(place.label.as_str()));
                related = None;
            }
            elements.push(origin(span.start).into());
            let snippet = Snippet::source(excerpt.line.as_str()).line_start(excerpt.number);
            elements.push(snippet.annotations(annotations).into());
        }
        _ => elements.push(Origin::path(file_name).into()),
    }
    if let Some((place, excerpt)) = related {
        elements.push(origin(place.span.start).into());
        let annotation = AnnotationKind::Context.span(excerpt.span.clone()).label(place.label.as_str());
        let snippet = Snippet::source(excerpt.line.as_str()).line_start(excerpt.number);
        elements.push(snippet.annotation(annotation).into());
    }
    if let Some(help) = fault.help_text() {
        elements.push(Level::HELP.message(help).into());
    }
    let title = Level::ERROR.primary_title(fault.message()).id(fault.code());
    Group::with_title(title).elements(elements)
}
