//! Numbers of a scene: read exactly, rounded once to the nearest double.

use super::super::kind::FaultKind;
use super::super::reader::{Fields, Path, Reader, span_of};
use super::super::show;
use crate::exact::{Q, from_float_exact, to_f64};
use crate::model::Entries;
use jsonc_parser::ast::Value;
use num_traits::{Signed as _, Zero as _};

/// Which values make sense.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Bound {
    Any,
    NotNegative,
    Positive,
}

impl Reader {
    /// The double nearest to a number; `name` is what faults call it.
    pub fn double(&mut self, value: &Value, path: &Path, name: &'static str, bound: Bound) -> Option<f64> {
        let exact = self.number(value, path)?;
        let shown = || show::number(&exact);
        let (kind, help) = match bound {
            Bound::Positive if !exact.is_positive() => {
                (FaultKind::NotPositive { name, value: shown() }, "write a number above 0")
            }
            Bound::NotNegative if exact.is_negative() => {
                (FaultKind::Negative { name: named(name), value: shown() }, "write 0 or a number above 0")
            }
            _ => {
                let near = rounded(&exact).filter(|near| bound != Bound::Positive || *near > 0.0);
                if near.is_some() {
                    return near;
                }
                (FaultKind::NotADouble { value: shown() }, "write a number between 1e-300 and 1e300 in size")
            }
        };
        self.fault(kind, span_of(value), path, help);
        None
    }

    /// As [`Reader::double`], for a key: `Some(None)` where it is not given, `None` after a fault.
    pub fn optional_double(
        &mut self,
        fields: &Fields,
        key: &'static str,
        path: &Path,
        bound: Bound,
    ) -> Option<Option<f64>> {
        match fields.get(key) {
            Some(value) => self.double(value, &path.key(key), key, bound).map(Some),
            None => Some(None),
        }
    }

    /// A list of as many numbers as `E` has entries.
    pub fn doubles<E: Entries>(&mut self, value: &Value, path: &Path, help: &str) -> Option<E> {
        let mut entries = E::default();
        let elements = &self.array(value, path, help)?.elements;
        let expected = entries.as_ref().len();
        if elements.len() != expected {
            let kind = FaultKind::WrongLength { expected, found: elements.len() };
            self.fault(kind, span_of(value), path, help);
            return None;
        }
        let mut is_whole = true;
        for (index, (element, entry)) in elements.iter().zip(entries.as_mut()).enumerate() {
            match self.double(element, &path.index(index), "a coordinate", Bound::Any) {
                Some(number) => *entry = number,
                None => is_whole = false,
            }
        }
        is_whole.then_some(entries)
    }

    /// As [`Reader::doubles`], for a key: `Some(None)` where it is not given, `None` after a fault.
    pub fn optional_doubles<E: Entries>(
        &mut self,
        fields: &Fields,
        key: &'static str,
        path: &Path,
        help: &str,
    ) -> Option<Option<E>> {
        match fields.get(key) {
            Some(value) => self.doubles(value, &path.key(key), help).map(Some),
            None => Some(None),
        }
    }

    /// A vector of length one along the one written.
    pub fn direction<E: Entries>(&mut self, value: &Value, path: &Path, help: &str) -> Option<E> {
        let vector = self.doubles::<E>(value, path, help)?;
        let unit = normalized(vector.as_ref()).map(|(unit, _)| unit);
        let Some(unit) = unit else {
            self.fault(FaultKind::ZeroNormal, span_of(value), path, help);
            return None;
        };
        let mut entries = E::default();
        entries.as_mut().copy_from_slice(&unit);
        Some(entries)
    }
}

/// The vector with length one, and its length; `None` if it is zero.
pub fn normalized(vector: &[f64]) -> Option<(Vec<f64>, f64)> {
    let largest = vector.iter().fold(0.0, |largest: f64, entry| largest.max(entry.abs()));
    if largest == 0.0 {
        return None;
    }
    let scaled: Vec<f64> = vector.iter().map(|entry| entry / largest).collect();
    let length = scaled.iter().map(|entry| entry * entry).sum::<f64>().sqrt();
    Some((scaled.iter().map(|entry| entry / length).collect(), largest * length))
}

/// The nearest double; `None` beyond the largest.
pub fn rounded(value: &Q) -> Option<f64> {
    let near = to_f64(value);
    let is_beyond = near.abs() == f64::MAX && from_float_exact(f64::MAX).is_some_and(|largest| value.abs() > largest);
    if is_beyond {
        return None;
    }
    // a sum of zero and what is too small for doubles is zero without a sign
    Some(if near.is_zero() { 0.0 } else { near })
}

/// A key as faults on negative values spell it.
fn named(name: &'static str) -> &'static str {
    match name {
        "margin" => "`margin`",
        "damping" => "`damping`",
        "gamma" => "`gamma`",
        "from" => "a time",
        other => other,
    }
}
