//! From bytes to a syntax tree: strict JSON, bounded in size and depth.

use super::fault::Fault;
use super::kind::{FaultKind, SyntaxFault};
use super::show::clipped;
use jsonc_parser::ast::Value;
use jsonc_parser::errors::{ParseError, ParseErrorKind};
use jsonc_parser::{CollectOptions, ParseOptions, ParseStringErrorKind, parse_to_ast};

/// Deepest nesting of brackets; a case needs seven levels.
const MAX_DEPTH: usize = 64;

/// The smallest case, shown where there is none.
pub(super) const SMALLEST_CASE: &str = r#"{"part": {"shape": {"polygon": [[0, 0], [1, 0], [0, 1]]}}}"#;

/// The file as text, if it is not too large, UTF-8 and not empty.
pub(super) fn decode(bytes: &[u8], limit: usize) -> Result<&str, Fault> {
    if bytes.len() > limit {
        let fault = Fault::new(FaultKind::FileTooLarge { bytes: bytes.len(), limit });
        return Err(fault.help("raise the limit with --max-bytes"));
    }
    let text = std::str::from_utf8(bytes).map_err(|error| {
        let offset = error.valid_up_to();
        let fault = Fault::new(FaultKind::NotUtf8 { byte: bytes[offset], offset });
        fault.at(offset..offset + 1).help("save the file as UTF-8")
    })?;
    if text.bytes().all(|b| matches!(b, b' ' | b'\t' | b'\n' | b'\r')) {
        return Err(Fault::new(FaultKind::Empty).help(format!("the smallest case is {SMALLEST_CASE}")));
    }
    if text.starts_with('\u{feff}') {
        let fault = Fault::new(FaultKind::Syntax(SyntaxFault::ByteOrderMark));
        return Err(fault.at(0..3).help("save the file as UTF-8 without a byte order mark"));
    }
    Ok(text)
}

/// The syntax tree of `text`, which must be one JSON value and nothing else.
pub(super) fn parse(text: &str) -> Result<Value<'_>, Fault> {
    scan(text)?;
    let options = ParseOptions {
        allow_comments: false,
        allow_loose_object_property_names: false,
        allow_trailing_commas: false,
        allow_missing_commas: false,
        allow_single_quoted_strings: false,
        allow_hexadecimal_numbers: false,
        allow_unary_plus_numbers: false,
        allow_bare_decimal_point_numbers: false,
        allow_non_finite_numbers: false,
        allow_extended_string_escapes: false,
    };
    let tree = parse_to_ast(text, &CollectOptions::default(), &options).map_err(|error| syntax(text, &error))?;
    tree.value.ok_or_else(|| Fault::new(FaultKind::Empty))
}

/// Bounds the depth before anything recurses, and rejects what the parser is lenient about.
///
/// Stops without a verdict at the first character that no JSON text has there: the parser stops there too.
fn scan(text: &str) -> Result<(), Fault> {
    let (mut depth, mut in_string, mut is_escaped) = (0_usize, false, false);
    for (at, byte) in text.bytes().enumerate() {
        if in_string {
            match byte {
                _ if byte < 0x20 => {
                    let fault = SyntaxFault::ControlCharacter { code: byte.into() };
                    let help = "close the string with \", or write the character as an escape like \\n";
                    return Err(Fault::new(FaultKind::Syntax(fault)).at(at..at + 1).help(help));
                }
                _ if is_escaped => is_escaped = false,
                b'\\' => is_escaped = true,
                b'"' => in_string = false,
                _ => {}
            }
            continue;
        }
        match byte {
            b'"' => in_string = true,
            b'[' | b'{' if depth == MAX_DEPTH => {
                let fault = Fault::new(FaultKind::TooDeep { limit: MAX_DEPTH });
                return Err(fault.at(at..at + 1).help("a case needs seven levels"));
            }
            b'[' | b'{' => depth += 1,
            b']' | b'}' => depth = depth.saturating_sub(1),
            b'/' | b'\'' => return Ok(()),
            b' ' | b'\t' | b'\n' | b'\r' | 0x21..=0x7e => {}
            _ => {
                let character = text[at..].chars().next().map_or(String::new(), |c| c.escape_debug().to_string());
                let span = at..at + text[at..].chars().next().map_or(1, char::len_utf8);
                let fault = FaultKind::Syntax(SyntaxFault::Unexpected { text: character });
                return Err(Fault::new(fault).at(span).help("outside of strings JSON is plain ASCII"));
            }
        }
    }
    Ok(())
}

fn syntax(text: &str, error: &ParseError) -> Fault {
    let (mut start, mut end) = (error.range().start, error.range().end);
    let word = word_at(text, start);
    if is_not_finite(word) {
        let fault = Fault::new(FaultKind::NotFinite { text: clipped(word) });
        return fault.at(start..start + word.len()).help(NUMBER_HELP);
    }
    let unexpected =
        || SyntaxFault::Unexpected { text: clipped(if word.is_empty() { &text[start..end] } else { word }) };
    let mut related = None;
    let (fault, help) = match error.kind() {
        ParseErrorKind::CommentsNotAllowed | ParseErrorKind::UnterminatedCommentBlock => {
            (SyntaxFault::Comment, "remove the comment")
        }
        ParseErrorKind::TrailingCommasNotAllowed => (SyntaxFault::TrailingComma, "remove the comma"),
        ParseErrorKind::ExpectedComma => (SyntaxFault::MissingComma, "write a comma here"),
        ParseErrorKind::UnexpectedComma => (SyntaxFault::MissingValue, "write a value, or remove the comma"),
        ParseErrorKind::ExpectedColonAfterObjectKey => (SyntaxFault::MissingColon, "write `\"key\": value`"),
        ParseErrorKind::SingleQuotedStringsNotAllowed => (SyntaxFault::SingleQuotes, "write \"...\""),
        ParseErrorKind::ExpectedStringObjectProperty => (SyntaxFault::UnquotedKey, "write \"key\": value"),
        ParseErrorKind::BareDecimalPointNumbersNotAllowed
        | ParseErrorKind::ExpectedDigit
        | ParseErrorKind::ExpectedDigitFollowingNegativeSign
        | ParseErrorKind::ExpectedPlusMinusOrDigitInNumberLiteral
        | ParseErrorKind::HexadecimalNumbersNotAllowed
        | ParseErrorKind::UnaryPlusNumbersNotAllowed => (SyntaxFault::Number, NUMBER_HELP),
        ParseErrorKind::String(ParseStringErrorKind::UnterminatedStringLiteral) => {
            (SyntaxFault::OpenString, "close the string with \"")
        }
        ParseErrorKind::String(_) => (SyntaxFault::Escape, "JSON knows \\\" \\\\ \\/ \\b \\f \\n \\r \\t and \\u0000"),
        ParseErrorKind::UnterminatedArray | ParseErrorKind::UnterminatedObject => {
            let what = if text[start..].starts_with('{') { "object" } else { "list" };
            related = Some((start..start + 1, "opened here"));
            end = text.trim_ascii_end().len();
            start = end.saturating_sub(1);
            (SyntaxFault::OpenBracket { what }, "is the file complete?")
        }
        ParseErrorKind::MultipleRootJsonValues => (SyntaxFault::SecondValue, "a case is one JSON object"),
        ParseErrorKind::ExpectedObjectValue => (unexpected(), "write `\"key\": value`"),
        _ => (unexpected(), "here JSON needs a value, a comma or a closing bracket"),
    };
    let fault = Fault::new(FaultKind::Syntax(fault)).at(start..end.max(start)).help(help);
    match related {
        Some((span, label)) => fault.related(span, label),
        None => fault,
    }
}

/// How numbers are written.
pub(super) const NUMBER_HELP: &str = "write 0.125, 1e-3 or \"1/3\"";

/// The run of word characters at byte `start`.
fn word_at(text: &str, start: usize) -> &str {
    let rest = &text[start..];
    let is_word = |c: char| c.is_alphanumeric() || matches!(c, '+' | '-' | '_' | '.' | '$');
    &rest[..rest.find(|c| !is_word(c)).unwrap_or(rest.len())]
}

/// Whether `word` is a usual spelling of NaN or an infinity.
pub(super) fn is_not_finite(word: &str) -> bool {
    let bare = word.strip_prefix(['+', '-']).unwrap_or(word);
    ["nan", "inf", "infinity"].iter().any(|name| bare.eq_ignore_ascii_case(name))
}
