//! The kinds of faults and their stable codes.

use crate::exact::LiteralError;
use crate::geometry::PolygonFault;

/// The kinds of faults; each has a code that never changes its meaning.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum FaultKind {
    /// The file is longer than the limit.
    #[error("the file has {bytes} bytes, more than the limit of {limit}")]
    FileTooLarge {
        /// Bytes of the file.
        bytes: usize,
        /// The limit.
        limit: usize,
    },
    /// Not UTF-8.
    #[error("byte 0x{byte:02x} at offset {offset} is not valid UTF-8")]
    NotUtf8 {
        /// The first bad byte.
        byte: u8,
        /// Its offset in the file.
        offset: usize,
    },
    /// Nothing but white space.
    #[error("the file is empty")]
    Empty,
    /// Brackets nested too deeply.
    #[error("brackets are nested more than {limit} deep")]
    TooDeep {
        /// The limit.
        limit: usize,
    },
    /// Not JSON.
    #[error("{0}")]
    Syntax(SyntaxFault),
    /// NaN or an infinity.
    #[error("`{text}` is not a finite number")]
    NotFinite {
        /// As written.
        text: String,
    },
    /// The same key twice in one object.
    #[error("the key `{key}` is given twice")]
    DuplicateKey {
        /// The key.
        key: String,
    },
    /// A key without meaning.
    #[error("unknown key `{key}`")]
    UnknownKey {
        /// The key.
        key: String,
    },
    /// A value of the wrong JSON type.
    #[error("expected {expected}, found {found}")]
    WrongType {
        /// What belongs here.
        expected: &'static str,
        /// What is here.
        found: &'static str,
    },
    /// A list of the wrong length.
    #[error("expected {expected} numbers, found {found}")]
    WrongLength {
        /// How many belong here.
        expected: usize,
        /// How many are here.
        found: usize,
    },
    /// A required key is missing.
    #[error("`{key}` is missing")]
    MissingKey {
        /// The key.
        key: &'static str,
    },
    /// Two keys that exclude each other.
    #[error("`{first}` and `{second}` exclude each other")]
    ExclusiveKeys {
        /// One key.
        first: String,
        /// The other.
        second: String,
    },
    /// A text that is not one of the known words.
    #[error("unknown {what} `{text}`")]
    UnknownWord {
        /// What the word should name.
        what: &'static str,
        /// As written.
        text: String,
    },
    /// A section that a task needs is missing.
    #[error("the section `{section}` is missing")]
    MissingSection {
        /// Its key.
        section: &'static str,
    },
    /// A number that cannot be read.
    #[error("`{text}`: {reason}")]
    Literal {
        /// As written, possibly shortened.
        text: String,
        /// Why not.
        reason: LiteralError,
    },
    /// A number, or all numbers together, with too many digits.
    #[error("{what} {digits} digits, more than the limit of {limit}")]
    TooManyDigits {
        /// One number or all so far, with its verb.
        what: &'static str,
        /// Digits and decimal places of exponents.
        digits: usize,
        /// The limit.
        limit: usize,
    },
    /// A number that must be positive.
    #[error("`{name}` must be positive, not {value}")]
    NotPositive {
        /// The key.
        name: &'static str,
        /// The value, possibly shortened.
        value: String,
    },
    /// A number that must not be negative.
    #[error("{name} must not be negative, not {value}")]
    Negative {
        /// What it is.
        name: &'static str,
        /// The value, possibly shortened.
        value: String,
    },
    /// A number outside of its range.
    #[error("{name} must be {range}, not {value}")]
    OutOfRange {
        /// What it is.
        name: &'static str,
        /// The values allowed.
        range: String,
        /// The value, possibly shortened.
        value: String,
    },
    /// A range that ends before it begins.
    #[error("min {min} is above max {max}")]
    EmptyRange {
        /// Lower end, possibly shortened.
        min: String,
        /// Upper end, possibly shortened.
        max: String,
    },
    /// A polygon that is not simple.
    #[error("{0}")]
    Polygon(Box<PolygonFault>),
    /// More vertices than the limit.
    #[error("{vertices} vertices, more than the limit of {limit}")]
    TooManyVertices {
        /// How many there are.
        vertices: usize,
        /// The limit.
        limit: usize,
    },
    /// The center of mass, or a point of its box, is not strictly inside the convex hull.
    #[error("the center of mass {point} is not strictly inside the part's {outline}")]
    CenterOfMassOutside {
        /// The center, possibly shortened, with its tolerance.
        point: String,
        /// `convex hull` or `circle`.
        outline: &'static str,
    },
    /// A fixture without fixels.
    #[error("there are no fixels")]
    NoFixels,
    /// More fixels than the limit.
    #[error("{fixels} fixels, more than the limit of {limit}")]
    TooManyFixels {
        /// How many there are.
        fixels: usize,
        /// The limit.
        limit: usize,
    },
    /// A fixel that does not touch the part.
    #[error("the fixel at {at} does not touch the part: the nearest boundary point is {nearest}, {distance} away")]
    OffTheBoundary {
        /// Where the file puts it.
        at: String,
        /// The nearest boundary point.
        nearest: String,
        /// Distance between the two.
        distance: String,
    },
    /// No such edge.
    #[error("there is no edge {edge}: the polygon has edges 0 to {last}")]
    NoSuchEdge {
        /// As written, possibly shortened.
        edge: String,
        /// The last edge.
        last: usize,
    },
    /// Edges are a polygon's.
    #[error("a circle has no edges")]
    EdgeOfCircle,
    /// A fixel at a vertex without a normal.
    #[error("a fixel at vertex {vertex} needs `normal`")]
    VertexNeedsNormal {
        /// The vertex.
        vertex: usize,
    },
    /// A normal of length zero.
    #[error("the normal is zero")]
    ZeroNormal,
    /// A normal at a vertex that no contact there can have.
    #[error("the normal {normal} is outside of the normal cone of vertex {vertex}")]
    NormalOutsideCone {
        /// The normal, possibly shortened.
        normal: String,
        /// The vertex.
        vertex: usize,
    },
    /// A normal that differs from the outline's.
    #[error("the normal {normal} does not point along the inward normal {inward}")]
    NormalNotInward {
        /// The normal, possibly shortened.
        normal: String,
        /// The outline's, possibly shortened.
        inward: String,
    },
    /// Kinetic friction that can exceed static friction.
    #[error("kinetic friction above static: {kinetic} > {static_}")]
    KineticAboveStatic {
        /// Kinetic coefficient, possibly shortened.
        kinetic: String,
        /// Static coefficient, possibly shortened.
        static_: String,
    },
    /// A static or kinetic coefficient where there is only one.
    #[error("friction here is one coefficient or range, without `{key}`")]
    FrictionPair {
        /// `static` or `kinetic`.
        key: &'static str,
    },
    /// A range or a pair of coefficients where a simulation needs one.
    #[error("a simulation needs one coefficient of friction")]
    SeveralFrictions,
    /// A number beyond doubles.
    #[error("{value} is beyond the range of floating-point numbers")]
    NotADouble {
        /// The value, possibly shortened.
        value: String,
    },
    /// A scene in which nothing moves.
    #[error("there are no bodies")]
    NoBodies,
    /// More bodies, or fixed things, than the limit.
    #[error("{bodies} {what}, more than the limit of {limit}")]
    TooManyBodies {
        /// How many there are.
        bodies: usize,
        /// `bodies` or `fixed`.
        what: &'static str,
        /// The limit.
        limit: usize,
    },
    /// Two things of the same name.
    #[error("the name `{name}` is taken")]
    RepeatedName {
        /// The name, possibly shortened.
        name: String,
    },
    /// A name of nothing in the scene.
    #[error("nothing in the scene is named `{name}`")]
    NoSuchName {
        /// The name, possibly shortened.
        name: String,
    },
    /// A pair that does not interact, or is given twice.
    #[error("{0}")]
    Pair(PairFault),
    /// A shape that a moving body cannot have.
    #[error("a body cannot be a `{shape}`: only what is fixed can")]
    FixedOnly {
        /// Its key.
        shape: &'static str,
    },
    /// A compound without pieces, or of compounds.
    #[error("a compound has one piece or more, none of them compound")]
    Compound,
    /// A polygon whose corners coincide or cross when rounded to doubles.
    #[error("rounded to floating-point numbers the polygon is not simple any more")]
    RoundedPolygon,
    /// Euler parameters of length zero.
    #[error("the Euler parameters e0, ex, ey, ez are all zero")]
    NoOrientation,
    /// Times that do not increase.
    #[error("times increase, but {time} follows {previous}")]
    TimeOrder {
        /// The time before.
        previous: String,
        /// The time that is not later.
        time: String,
    },
    /// A key that makes sense for kinematic bodies only, or for free ones only.
    #[error("`{key}` is for {what} bodies only")]
    WrongMotion {
        /// The key.
        key: &'static str,
        /// `kinematic` or `free`.
        what: &'static str,
    },
    /// Two bodies of which nothing says how they touch.
    #[error("no friction is given between `{first}` and `{second}`{others}")]
    NoFriction {
        /// One of the two, possibly shortened.
        first: String,
        /// The other, possibly shortened.
        second: String,
        /// How many pairs more; empty if none.
        others: String,
    },
    /// Two bodies that disagree on what happens where they touch.
    #[error("`{first}` and `{second}` disagree on {key}")]
    Disagreement {
        /// `friction`, `restitution` or `contact`.
        key: &'static str,
        /// One of the two, possibly shortened.
        first: String,
        /// The other, possibly shortened.
        second: String,
    },
    /// A push from a direction, on a part with edges.
    #[error("a polygon is pushed on one of its edges")]
    FromOnPolygon,
    /// A push of length zero.
    #[error("a push of length zero does nothing")]
    ZeroPush,
    /// A text that is no expression.
    #[error("`{text}` is no expression: {why}")]
    Expression {
        /// The text, possibly shortened.
        text: String,
        /// What is wrong.
        why: String,
    },
    /// A name in an expression that stands for nothing.
    #[error("nothing is named `{name}`")]
    UnknownName {
        /// The name, possibly shortened.
        name: String,
    },
    /// A name that expressions cannot use.
    #[error("`{name}` cannot be a name in expressions")]
    BadName {
        /// The name, possibly shortened.
        name: String,
    },
    /// An expression without a finite value where the search starts.
    #[error("`{text}` has no finite value where the search starts")]
    NoValue {
        /// The text, possibly shortened.
        text: String,
    },
}

/// Why an entry of `pairs` names no pair.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum PairFault {
    /// One name twice.
    #[error("a pair has two different names")]
    Same,
    /// Two fixed things.
    #[error("neither of the two moves, so that they never touch")]
    Fixed,
    /// The pair has an entry already.
    #[error("the pair is given twice")]
    Twice,
}

impl FaultKind {
    /// The stable code, e.g. `C021`.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::FileTooLarge { .. } => "C001",
            Self::NotUtf8 { .. } => "C002",
            Self::Empty => "C003",
            Self::TooDeep { .. } => "C004",
            Self::Syntax(_) => "C005",
            Self::NotFinite { .. } => "C006",
            Self::DuplicateKey { .. } => "C010",
            Self::UnknownKey { .. } => "C011",
            Self::WrongType { .. } => "C012",
            Self::WrongLength { .. } => "C013",
            Self::MissingKey { .. } => "C014",
            Self::ExclusiveKeys { .. } => "C015",
            Self::UnknownWord { .. } => "C016",
            Self::MissingSection { .. } => "C017",
            Self::Literal { .. } => "C020",
            Self::TooManyDigits { .. } => "C021",
            Self::NotPositive { .. } => "C022",
            Self::Negative { .. } => "C023",
            Self::OutOfRange { .. } => "C024",
            Self::EmptyRange { .. } => "C025",
            Self::Polygon(fault) => polygon_code(fault),
            Self::TooManyVertices { .. } => "C036",
            Self::CenterOfMassOutside { .. } => "C040",
            Self::NoFixels => "C050",
            Self::TooManyFixels { .. } => "C051",
            Self::OffTheBoundary { .. } => "C052",
            Self::NoSuchEdge { .. } => "C053",
            Self::EdgeOfCircle => "C054",
            Self::VertexNeedsNormal { .. } => "C055",
            Self::ZeroNormal => "C056",
            Self::NormalOutsideCone { .. } => "C057",
            Self::NormalNotInward { .. } => "C058",
            Self::KineticAboveStatic { .. } => "C060",
            Self::FrictionPair { .. } => "C061",
            Self::SeveralFrictions => "C062",
            Self::NotADouble { .. } => "C070",
            Self::NoBodies => "C071",
            Self::TooManyBodies { .. } => "C072",
            Self::RepeatedName { .. } => "C073",
            Self::NoSuchName { .. } => "C074",
            Self::Pair(_) => "C075",
            Self::FixedOnly { .. } => "C076",
            Self::Compound => "C077",
            Self::RoundedPolygon => "C078",
            Self::NoOrientation => "C079",
            Self::TimeOrder { .. } => "C080",
            Self::WrongMotion { .. } => "C081",
            Self::NoFriction { .. } => "C082",
            Self::Disagreement { .. } => "C083",
            Self::FromOnPolygon => "C084",
            Self::ZeroPush => "C085",
            Self::Expression { .. } => "C086",
            Self::UnknownName { .. } => "C087",
            Self::BadName { .. } => "C088",
            Self::NoValue { .. } => "C089",
        }
    }
}

fn polygon_code(fault: &PolygonFault) -> &'static str {
    match fault {
        PolygonFault::TooFewVertices { .. } => "C030",
        PolygonFault::RepeatedVertex { .. } => "C031",
        PolygonFault::ZeroArea => "C032",
        PolygonFault::Spike { .. } => "C033",
        PolygonFault::Crossing { .. } => "C034",
        PolygonFault::TooManyDigits { .. } => "C035",
    }
}

/// Why a text is not JSON.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SyntaxFault {
    /// A byte order mark at the start.
    #[error("the file starts with a byte order mark")]
    ByteOrderMark,
    /// `//` or `/* */`.
    #[error("comments are not allowed in JSON")]
    Comment,
    /// A comma before a closing bracket.
    #[error("trailing commas are not allowed in JSON")]
    TrailingComma,
    /// Two values without a comma between them.
    #[error("a comma is missing")]
    MissingComma,
    /// A comma where a value belongs.
    #[error("a value is missing before this comma")]
    MissingValue,
    /// A key without a colon.
    #[error("a colon is missing after the key")]
    MissingColon,
    /// A string in single quotes.
    #[error("strings need double quotes")]
    SingleQuotes,
    /// A key without quotes.
    #[error("keys need double quotes")]
    UnquotedKey,
    /// A number that JSON spells otherwise.
    #[error("this is not how JSON writes a number")]
    Number,
    /// Bad escape in a string.
    #[error("the string holds a bad escape")]
    Escape,
    /// A string without its closing quote.
    #[error("the string is not closed")]
    OpenString,
    /// A control character in a string.
    #[error("the string holds an unescaped control character U+{code:04X}")]
    ControlCharacter {
        /// Its code point.
        code: u32,
    },
    /// The text ends inside an object or list.
    #[error("the file ends before this {what} is closed")]
    OpenBracket {
        /// `object` or `list`.
        what: &'static str,
    },
    /// A second value after the first.
    #[error("the file holds more than one value")]
    SecondValue,
    /// Anything else.
    #[error("unexpected `{text}`")]
    Unexpected {
        /// As written, possibly shortened.
        text: String,
    },
}
