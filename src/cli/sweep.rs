//! Reading which settings of an arm to try.

use num_traits::{One as _, Signed as _};
use partplan::exact::{LiteralError, Q, parse_literal};
use partplan::model::Thrower;
use partplan::planner::Sweep;

/// Values of the controls, from and to; `None` where the case's is kept.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Controls {
    offset: Option<[Q; 2]>,
    release: Option<[Q; 2]>,
}

impl Controls {
    /// The settings to try, about the arm of a case.
    pub fn sweep(&self, thrower: &Thrower, grid: usize, margin: &Q) -> Sweep {
        let or = |range: &Option<[Q; 2]>, value: &Q| range.clone().unwrap_or_else(|| [value.clone(), value.clone()]);
        Sweep {
            offset: or(&self.offset, &thrower.offset),
            release: or(&self.release, &thrower.release_deg_per_s),
            grid,
            margin: margin.clone(),
        }
    }
}

/// Reads `offset=a..b,release=c..d`, one of them or both, each a range or one value.
pub fn controls(text: &str) -> Result<Controls, SweepError> {
    let mut controls = Controls { offset: None, release: None };
    for item in text.split(',') {
        let (name, values) =
            item.split_once('=').ok_or_else(|| SweepError::NoValue { text: item.trim().to_owned() })?;
        let (name, control) = match name.trim() {
            "offset" => ("offset", &mut controls.offset),
            "release" => ("release", &mut controls.release),
            other => return Err(SweepError::Unknown { name: other.to_owned() }),
        };
        let range = range(name, values)?;
        if name == "release" && !range[0].is_positive() {
            return Err(SweepError::NotPositive);
        }
        if control.replace(range).is_some() {
            return Err(SweepError::Twice { name });
        }
    }
    Ok(controls)
}

/// Reads `a..b`, or `a` for `a..a`.
fn range(name: &'static str, text: &str) -> Result<[Q; 2], SweepError> {
    let (from, to) = text.split_once("..").unwrap_or((text, text));
    let number = |text: &str| {
        let text = text.trim();
        parse_literal(text).map_err(|reason| SweepError::Number { name, text: text.to_owned(), reason })
    };
    let range = [number(from)?, number(to)?];
    if range[0] > range[1] { Err(SweepError::Descends { name }) } else { Ok(range) }
}

/// Reads a relative margin.
pub fn margin(text: &str) -> Result<Q, MarginError> {
    let margin = parse_literal(text.trim())?;
    if margin.is_negative() || margin >= Q::one() { Err(MarginError::Outside) } else { Ok(margin) }
}

/// Why a text does not say which settings to try.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum SweepError {
    #[error("\"{text}\" has no value; write offset=-1..0.5 or release=200..400")]
    NoValue { text: String },
    #[error("there is no control \"{name}\"; write offset=-1..0.5 or release=200..400")]
    Unknown { name: String },
    #[error("{name} is given twice; write it once")]
    Twice { name: &'static str },
    #[error("{name} is \"{text}\": {reason}; write 0.125, 1e-3 or 1/3, and a range as 0.5..2")]
    Number { name: &'static str, text: String, reason: LiteralError },
    #[error("the range of {name} descends; write the smaller end first")]
    Descends { name: &'static str },
    #[error("release speeds are positive; write degrees per second above 0")]
    NotPositive,
}

/// Why a text is not a relative margin.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum MarginError {
    #[error("{0}; write 0.05 or 1/20")]
    Number(#[from] LiteralError),
    #[error("a relative margin is at least 0 and below 1; write 0.05 for five percent")]
    Outside,
}

#[cfg(test)]
mod tests {
    use super::*;
    use partplan::exact::ratio;

    #[test]
    fn controls_are_ranges_single_values_or_left_out() {
        let both = controls("offset=-1..1/2, release=200..400.5").unwrap();
        assert_eq!(both.offset, Some([ratio(-1, 1), ratio(1, 2)]));
        assert_eq!(both.release, Some([ratio(200, 1), ratio(801, 2)]));
        let thrower =
            Thrower { offset: ratio(-1, 2), release_deg_per_s: ratio(320, 1), gravity: ratio(981, 1), friction: None };
        let one = controls("release=300").unwrap().sweep(&thrower, 5, &ratio(1, 20));
        assert_eq!((one.offset, one.release), ([ratio(-1, 2), ratio(-1, 2)], [ratio(300, 1), ratio(300, 1)]));
        assert_eq!((one.grid, one.margin), (5, ratio(1, 20)));
    }

    #[test]
    fn bad_controls_are_told_with_what_to_write() {
        let message = |text| controls(text).unwrap_err().to_string();
        assert!(message("").starts_with("\"\" has no value; write offset="));
        assert!(message("offset").starts_with("\"offset\" has no value"));
        assert!(message("speed=1..2").starts_with("there is no control \"speed\""));
        assert_eq!(message("offset=1,offset=2"), "offset is given twice; write it once");
        assert!(message("offset=1..x").starts_with("offset is \"x\": expected a decimal number"));
        assert!(message("offset=..1").starts_with("offset is \"\""));
        assert_eq!(message("offset=2..1"), "the range of offset descends; write the smaller end first");
        assert!(message("release=0..5").starts_with("release speeds are positive"));
    }

    #[test]
    fn margins_are_shares() {
        assert_eq!((margin("0.05"), margin("0")), (Ok(ratio(1, 20)), Ok(ratio(0, 1))));
        assert_eq!((margin("-0.1"), margin("1")), (Err(MarginError::Outside), Err(MarginError::Outside)));
        assert!(margin("much").unwrap_err().to_string().ends_with("write 0.05 or 1/20"));
    }
}
