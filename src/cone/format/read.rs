//! Reading polyhedron files.

use super::fault::{FormatError, FormatFault};
use super::scan::{Scanner, Word};
use crate::cone::{Polyhedron, Representation};
use crate::exact::{LiteralError, Q, parse_literal};
use num_traits::{One as _, Zero as _};

/// Most columns accepted: the first basis of a conversion has a row and a column for each.
pub const MAX_COLUMNS: usize = 1_000;

/// Largest power of ten of an entry; a short text must not become a long number. Doubles end at 308.
pub const MAX_DECIMAL_EXPONENT: u32 = 400;

/// More warnings than this are counted only.
const MAX_WARNINGS: usize = 10;

/// Lines that list rows to be taken as linear.
const ROW_LISTS: [&str; 3] = ["linearity", "equality", "partial_enumeration"];

/// Options that make another polyhedron of the rows.
const REFUSED: [(&str, &str); 2] = [
    ("strict_inequality", "only closed polyhedra can be converted; leave the line out to take the closure"),
    ("nonnegative", "write the rows x_i >= 0 themselves"),
];

/// Options of cddlib and lrslib that ask for other output or steer the search, and change no polyhedron.
const WITHOUT_EFFECT: &str = "\
adjacency allbases bound cache cutoff debug digits dualperturb dynout_off dynout_on estimates facet_listing \
find_interior geometric givelabels hull incidence initbasis_at_bottom input_adjacency input_incidence largest \
lexmax lexmin lineshelling log_off log_on logfile_on lponly maxcutoff maxdepth maximize maximise maxindex \
maxoutput mincutoff mindepth minimize minimise minindex mixcutoff nondegenerate nonredundant output_reordering \
postanalysis preprojection printcobasis printslack project random redund redund_list restart row_decomposition \
seed startingcobasis stdout_off stdout_on testredundancy threads tope_listing truncate verbose verifyinput \
volume voronoi zero_tolerance";

/// A polyhedron and what its reader has to say about the file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Document {
    /// The polyhedron.
    pub polyhedron: Polyhedron,
    /// Lines that were ignored, and assumptions that were made.
    pub warnings: Vec<String>,
}

/// Reads a polyhedron file; declared sizes are checked, never trusted.
///
/// Numbers are read digit by digit whatever the declared kind: `0.1` is one tenth. Rows may wrap over lines; their
/// count may be `*****`. `linearity`, `equality` and `partial_enumeration` lines may stand before, in or after the
/// matrix. Lines that start with `*` are comments, and the first other line may be a name.
///
/// # Errors
/// [`FormatError`] says what is wrong and where.
///
/// # Examples
/// ```
/// use partplan::cone::format::read;
/// let square = read(b"begin\n4 3 real\n1 1 0 1 -1 0 1 0 1 1 0 -1\nend").unwrap();
/// assert_eq!(square.polyhedron.rows().len(), 4);
/// let fault = read(b"V-representation\nbegin\n1 2 integer\n2 7\nend").unwrap_err();
/// assert_eq!((fault.line, fault.column), (4, 1));
/// ```
pub fn read(bytes: &[u8]) -> Result<Document, FormatError> {
    let text = String::from_utf8_lossy(bytes);
    let mut reader = Reader {
        scanner: Scanner::new(&text),
        representation: None,
        is_named: false,
        linear: Vec::new(),
        warnings: Vec::new(),
        unsaid: 0,
    };
    reader.head()?;
    let size = reader.size()?;
    let rows = reader.rows(&size)?;
    reader.tail()?;
    reader.finish(size.columns, rows)
}

struct Reader<'a> {
    scanner: Scanner<'a>,
    representation: Option<Representation>,
    is_named: bool,
    /// Numbers of linear rows, to be judged when it is known how many rows there are.
    linear: Vec<Word<'a>>,
    warnings: Vec<String>,
    unsaid: usize,
}

struct Size {
    /// `None` if the file leaves it open.
    rows: Option<usize>,
    columns: usize,
}

impl<'a> Reader<'a> {
    fn head(&mut self) -> Result<(), FormatError> {
        while let Some(word) = self.scanner.next_past_comments() {
            if word.is("begin") {
                return Ok(());
            }
            if self.option(word)? {
                continue;
            }
            if std::mem::replace(&mut self.is_named, true) {
                self.warn(format!("line {}: \"{}\" is not understood and ignored", word.line, word.shown()));
            }
            self.scanner.skip_line();
        }
        Err(self.scanner.error(FormatFault::NoBegin))
    }

    fn tail(&mut self) -> Result<(), FormatError> {
        let mut follows_option = false;
        while let Some(word) = self.scanner.next_past_comments() {
            if word.is("begin") {
                return Err(word.error(FormatFault::SecondBegin));
            }
            if self.option(word)? {
                follows_option = true;
                continue;
            }
            // the arguments of an option may wrap
            if !(follows_option && number(word.text).is_ok()) {
                follows_option = false;
                self.warn(format!("line {}: \"{}\" is not understood and ignored", word.line, word.shown()));
            }
            self.scanner.skip_line();
        }
        Ok(())
    }

    /// Whether `word` begins a line that may stand outside of the matrix, which is then read.
    fn option(&mut self, word: Word<'a>) -> Result<bool, FormatError> {
        let stated = [Representation::Inequalities, Representation::Generators]
            .into_iter()
            .find(|stated| word.is(&format!("{}-representation", stated.letter())));
        if stated.is_some() {
            if self.representation.is_some_and(|earlier| Some(earlier) != stated) {
                return Err(word.error(FormatFault::TwoRepresentations));
            }
            self.representation = stated;
            self.scanner.skip_line();
            return Ok(true);
        }
        if ROW_LISTS.iter().any(|keyword| word.is(keyword)) {
            self.row_list(word)?;
            return Ok(true);
        }
        if let Some((option, instead)) = REFUSED.iter().find(|(option, _)| word.is(option)) {
            return Err(word.error(FormatFault::Option { option: (*option).to_owned(), instead }));
        }
        if WITHOUT_EFFECT.split(' ').any(|option| word.is(option)) {
            self.warn(format!("line {}: option \"{}\" has no effect", word.line, word.text));
            self.scanner.skip_line();
            return Ok(true);
        }
        Ok(false)
    }

    fn row_list(&mut self, keyword: Word<'a>) -> Result<(), FormatError> {
        let fault = |word: &Word, expected| {
            let keyword = keyword.text.to_ascii_lowercase();
            word.error(FormatFault::RowList { keyword, found: word.shown(), expected })
        };
        let Some(word) = self.scanner.next() else {
            return Err(self.scanner.error(FormatFault::Ends { expected: "the number of rows in the list" }));
        };
        let count: usize = word.text.parse().map_err(|_| fault(&word, "the number of rows in the list"))?;
        for _ in 0..count {
            let Some(word) = self.scanner.next() else {
                return Err(self.scanner.error(FormatFault::Ends { expected: "a row number" }));
            };
            if !word.text.bytes().all(|byte| byte.is_ascii_digit()) {
                return Err(fault(&word, "a row number"));
            }
            self.linear.push(word);
        }
        match self.scanner.next_here() {
            Some(word) if !word.text.starts_with('*') => Err(fault(&word, "the end of the line")),
            _ => {
                self.scanner.skip_line();
                Ok(())
            }
        }
    }

    fn size(&mut self) -> Result<Size, FormatError> {
        loop {
            let word = self.expect("the number of rows")?;
            let rows = if word.text.starts_with('*') {
                let mut ahead = self.scanner.clone();
                let is_open = word.text.bytes().all(|byte| byte == b'*')
                    && ahead.next_here().is_some_and(|word| word.text.parse::<usize>().is_ok())
                    && ahead.next_here().is_some_and(|word| is_number_kind(&word));
                if !is_open {
                    self.scanner.skip_line();
                    continue;
                }
                None
            } else if self.option(word)? {
                continue;
            } else {
                let fault = || word.error(FormatFault::Size { found: word.shown(), what: "number of rows" });
                Some(word.text.parse::<usize>().map_err(|_| fault())?)
            };
            let word = self.expect("the number of columns")?;
            let columns = columns(&word)?;
            let word = self.expect("integer, rational or real")?;
            if !is_number_kind(&word) {
                return Err(word.error(FormatFault::NumberKind { found: word.shown() }));
            }
            return Ok(Size { rows, columns });
        }
    }

    fn rows(&mut self, size: &Size) -> Result<Vec<Vec<Q>>, FormatError> {
        let mut rows = Vec::new();
        loop {
            let Some(word) = self.scanner.next_past_comments() else {
                return Err(self.scanner.error(FormatFault::Ends { expected: "a row or \"end\"" }));
            };
            if word.is("end") {
                return match size.rows {
                    Some(announced) if rows.len() < announced => {
                        Err(word.error(FormatFault::FewRows { found: rows.len(), announced }))
                    }
                    _ => Ok(rows),
                };
            }
            if ROW_LISTS.iter().any(|keyword| word.is(keyword)) {
                self.row_list(word)?;
                continue;
            }
            if let Some(announced) = size.rows.filter(|announced| rows.len() == *announced) {
                let columns = size.columns;
                return Err(word.error(FormatFault::ManyRows { found: word.shown(), announced, columns }));
            }
            let row = self.row(word, rows.len() + 1, size)?;
            rows.push(row);
        }
    }

    fn row(&mut self, first: Word<'a>, row: usize, size: &Size) -> Result<Vec<Q>, FormatError> {
        let mut values = vec![entry(&first, row, 1)?];
        if self.representation == Some(Representation::Generators) && !(values[0].is_zero() || values[0].is_one()) {
            return Err(first.error(FormatFault::Generator { found: first.shown(), row }));
        }
        while values.len() < size.columns {
            let Some(word) = self.scanner.next_past_comments() else {
                return Err(self.scanner.error(FormatFault::Ends { expected: "the rest of a row" }));
            };
            if word.is("end") {
                let announced = size.rows.map_or_else(|| "*****".to_owned(), |rows| rows.to_string());
                let (found, columns) = (values.len(), size.columns);
                return Err(word.error(FormatFault::ShortRow { row, found, columns, announced }));
            }
            values.push(entry(&word, row, values.len() + 1)?);
        }
        Ok(values)
    }

    fn finish(mut self, columns: usize, rows: Vec<Vec<Q>>) -> Result<Document, FormatError> {
        let representation = self.representation.unwrap_or_else(|| {
            self.warn("no line says H-representation or V-representation: read as H-representation".to_owned());
            Representation::Inequalities
        });
        let mut linear = Vec::new();
        for word in &self.linear {
            let number = word.shown();
            let row = match word.text.parse::<usize>() {
                _ if rows.is_empty() => return Err(word.error(FormatFault::NoRows { number })),
                Ok(row) if (1..=rows.len()).contains(&row) => row,
                _ => return Err(word.error(FormatFault::RowNumber { number, rows: rows.len() })),
            };
            if representation == Representation::Generators && !rows[row - 1][0].is_zero() {
                return Err(word.error(FormatFault::PointAsLine { row }));
            }
            linear.push(row - 1);
        }
        if self.unsaid > 0 {
            self.warnings.push(format!("{} more lines are ignored", self.unsaid));
        }
        Ok(Document { polyhedron: Polyhedron::new(representation, columns, rows, &linear), warnings: self.warnings })
    }

    fn expect(&mut self, expected: &'static str) -> Result<Word<'a>, FormatError> {
        self.scanner.next().ok_or_else(|| self.scanner.error(FormatFault::Ends { expected }))
    }

    fn warn(&mut self, warning: String) {
        if self.warnings.len() < MAX_WARNINGS {
            self.warnings.push(warning);
        } else {
            self.unsaid += 1;
        }
    }
}

fn columns(word: &Word) -> Result<usize, FormatError> {
    if word.text.is_empty() || !word.text.bytes().all(|byte| byte.is_ascii_digit()) {
        return Err(word.error(FormatFault::Size { found: word.shown(), what: "number of columns" }));
    }
    match word.text.parse() {
        Ok(0) => Err(word.error(FormatFault::NoColumns)),
        Ok(columns) if columns <= MAX_COLUMNS => Ok(columns),
        _ => Err(word.error(FormatFault::TooManyColumns { columns: word.shown() })),
    }
}

fn is_number_kind(word: &Word) -> bool {
    ["integer", "rational", "real"].iter().any(|kind| word.is(kind))
}

fn entry(word: &Word, row: usize, entry: usize) -> Result<Q, FormatError> {
    number(word.text).map_err(|reason| {
        let found = word.shown();
        word.error(match reason {
            LiteralError::ZeroDenominator => FormatFault::ZeroDenominator { found, row, entry },
            LiteralError::ExponentTooLarge => FormatFault::Exponent { found, row, entry },
            _ => FormatFault::Number { found, row, entry },
        })
    })
}

/// As [`parse_literal`], and the forms that C programs print besides: `+1`, `.5`, `1.`.
fn number(text: &str) -> Result<Q, LiteralError> {
    let text = text.strip_prefix('+').unwrap_or(text);
    let (mantissa, exponent) = text.find(['e', 'E']).map_or((text, ""), |at| text.split_at(at));
    if let Some(digits) = exponent.get(1..) {
        let digits = digits.trim_start_matches(['+', '-']);
        let is_large = digits.parse().map_or(digits.len() > 3, |power: u32| power > MAX_DECIMAL_EXPONENT);
        if is_large && digits.bytes().all(|byte| byte.is_ascii_digit()) {
            return Err(LiteralError::ExponentTooLarge);
        }
    }
    let (sign, digits) = mantissa.strip_prefix('-').map_or(("", mantissa), |digits| ("-", digits));
    if digits.len() > 1 && (digits.starts_with('.') || digits.ends_with('.')) {
        let (whole, fraction) = digits.split_once('.').unwrap_or((digits, "0"));
        let or_zero = |digits: &str| if digits.is_empty() { "0".to_owned() } else { digits.to_owned() };
        return parse_literal(&format!("{sign}{}.{}{exponent}", or_zero(whole), or_zero(fraction)));
    }
    parse_literal(text)
}
