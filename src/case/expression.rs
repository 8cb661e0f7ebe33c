//! Arithmetic in named numbers, as a case may write it where a number is expected.

use exmex::{BinOp, Express as _, FlatEx, MakeOperators, MatchLiteral, Operator};
use std::f64::consts::PI;
use std::ops::Range;

/// An expression whose names are places in a list of values.
#[derive(Debug, Clone)]
pub(super) struct Expression {
    tree: FlatEx<f64, Functions, Numbers>,
    values: Vec<usize>,
    /// Its text.
    pub text: String,
    /// Where that is in the file.
    pub span: Range<usize>,
    /// Where it is in the document.
    pub path: String,
}

/// Why a text is no expression.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum NoExpression {
    /// It cannot be read.
    Syntax(String),
    /// A name that is not known.
    Name(String),
}

impl Expression {
    /// Reads `text`, with the names that values are given for.
    pub fn new(text: &str, names: &[String], span: Range<usize>, path: String) -> Result<Self, NoExpression> {
        let tree = FlatEx::parse(text).map_err(|error| NoExpression::Syntax(error.to_string()))?;
        let place = |name: &String| names.iter().position(|known| known == name);
        let value = |name| place(name).ok_or_else(|| NoExpression::Name(name.clone()));
        let values = tree.var_names().iter().map(value).collect::<Result<_, _>>()?;
        Ok(Self { tree, values, text: text.to_owned(), span, path })
    }

    /// Its value; not a number where it has none.
    pub fn value(&self, values: &[f64]) -> f64 {
        let own: Vec<f64> = self.values.iter().map(|place| values[*place]).collect();
        self.tree.eval(&own).unwrap_or(f64::NAN)
    }
}

/// Names that stand for functions and constants.
pub(super) const RESERVED: [&str; 15] =
    ["sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sqrt", "abs", "exp", "ln", "min", "max", "PI", "TAU"];

/// What expressions may use; the same on every machine.
#[derive(Debug, Clone)]
struct Functions;

impl MakeOperators<f64> for Functions {
    fn make<'a>() -> Vec<Operator<'a, f64>> {
        let binary = |apply, prio, is_commutative| BinOp { apply, prio, is_commutative };
        vec![
            Operator::make_bin("^", binary(libm::pow, 4, false)),
            Operator::make_bin("*", binary(|a, b| a * b, 2, true)),
            Operator::make_bin("/", binary(|a, b| a / b, 3, false)),
            Operator::make_bin_unary("+", binary(|a, b| a + b, 0, true), |a| a),
            Operator::make_bin_unary("-", binary(|a, b| a - b, 1, false), |a| -a),
            Operator::make_bin("atan2", binary(libm::atan2, 0, false)),
            Operator::make_bin("min", binary(f64::min, 0, true)),
            Operator::make_bin("max", binary(f64::max, 0, true)),
            Operator::make_unary("sin", libm::sin),
            Operator::make_unary("cos", libm::cos),
            Operator::make_unary("tan", libm::tan),
            Operator::make_unary("asin", libm::asin),
            Operator::make_unary("acos", libm::acos),
            Operator::make_unary("atan", libm::atan),
            Operator::make_unary("sqrt", libm::sqrt),
            Operator::make_unary("abs", f64::abs),
            Operator::make_unary("exp", libm::exp),
            Operator::make_unary("ln", libm::log),
            Operator::make_constant("PI", PI),
            Operator::make_constant("TAU", 2.0 * PI),
        ]
    }
}

/// Numbers as JSON has them, without a sign.
#[derive(Debug, Clone)]
struct Numbers;

impl MatchLiteral for Numbers {
    fn is_literal(text: &str) -> Option<&str> {
        let digits = |from: usize| text[from..].bytes().take_while(u8::is_ascii_digit).count();
        let mut end = digits(0);
        if end == 0 {
            return None;
        }
        if text[end..].starts_with('.') {
            end += 1 + digits(end + 1);
        }
        if text[end..].starts_with(['e', 'E']) {
            let sign = usize::from(text[end + 1..].starts_with(['+', '-']));
            let exponent = digits(end + 1 + sign);
            end += if exponent > 0 { 1 + sign + exponent } else { 0 };
        }
        Some(&text[..end])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(text: &str) -> f64 {
        Expression::new(text, &["e".to_owned(), "th".to_owned()], 0..0, String::new()).unwrap().value(&[2.0, 0.5])
    }

    #[test]
    fn expressions_have_the_values_of_arithmetic() {
        assert_eq!(value("1/3"), 1.0 / 3.0);
        assert_eq!(value("-e + 3*th - 1"), -1.5);
        assert_eq!(value("e - 1 - 1 + 2 - 3"), -1.0);
        assert_eq!(value("12/e/3*5"), 10.0);
        assert_eq!(value("2*e^2/4"), 2.0);
        assert_eq!(value("(1 + e)*cos(th) - sin(th)"), 3.0 * libm::cos(0.5) - libm::sin(0.5));
        assert_eq!(value("max(e, 7)*min(th, 1)"), 3.5);
        assert_eq!(value("atan2(1, 1)"), PI / 4.0);
        assert_eq!(value("1.5e-3*2"), 3e-3);
        assert!(value("1/(e - 2)").is_infinite());
    }

    #[test]
    fn what_is_none_says_why() {
        let names = ["e".to_owned()];
        assert_eq!(
            Expression::new("2*f", &names, 0..0, String::new()).unwrap_err(),
            NoExpression::Name("f".to_owned())
        );
        for text in ["", "1 +", "(e", "e e", "2 ** e", "foo(e)", "e;"] {
            assert!(Expression::new(text, &names, 0..0, String::new()).is_err(), "{text}");
        }
    }
}
