//! Heights of pins and how far they may be off, as numbers to be typed.

use crate::exact::{Algebraic, Q, Z, ratio};
use num_traits::{One as _, Signed as _};

/// Rationals between two numbers that lose less than 10⁻¹² of the room there, each either rounded inward or the number
/// itself; `None` if there is no room.
pub(super) fn inside(low: &Algebraic, high: &Algebraic) -> Option<[Q; 2]> {
    if low >= high {
        return None;
    }
    let (mut low, mut high) = (low.clone(), high.clone());
    let mut step = Q::one();
    loop {
        let ([below, from], [to, above]) = (low.bounds(), high.bounds());
        let room = &to - &from;
        let allowed = &room * power_of_ten(-13);
        if room.is_positive() && from.clone() - below <= allowed && above - &to <= allowed {
            return Some([from, to]);
        }
        step = if room.is_positive() { allowed } else { step * ratio(1, 1 << 16) };
        low.refine(&step);
        high.refine(&step);
    }
}

/// A height near the middle of an open interval, and a tolerance that stays inside: the decimals are as few as keep
/// 99 % of the width.
///
/// # Panics
/// If the interval is empty.
pub(super) fn short(low: &Q, high: &Q) -> (Q, Q) {
    assert!(low < high, "an interval that holds a pin is not empty");
    let half = (high - low) * ratio(1, 2);
    let middle = low + &half;
    let room = |height: &Q| (height - low).min(high - height);
    let heights = (0..).map(|decimals| (&middle * power_of_ten(decimals)).round() * power_of_ten(-decimals));
    // the tolerance needs a part of what may be lost
    let enough = &half * ratio(995, 1000);
    let height = first(heights, |height| room(height) >= enough);
    let room = room(&height);
    // the largest multiple below the room
    let multiple = |decimals| ((&room * power_of_ten(decimals)).ceil() - Q::one()) * power_of_ten(-decimals);
    let enough = half * ratio(99, 100);
    let tolerance = first((0..).map(multiple), |tolerance| *tolerance >= enough);
    (height, tolerance)
}

/// Twelve digits of a positive number.
pub(super) fn rounded_down(value: &Q) -> Q {
    let mut decimals = 0;
    while value * power_of_ten(decimals) < power_of_ten(11) {
        decimals += 1;
    }
    (value * power_of_ten(decimals)).floor() * power_of_ten(-decimals)
}

/// How far a tolerance may be from the exact one, with some to spare.
pub(super) fn rounding(tolerance: &Q) -> Q {
    tolerance * power_of_ten(-12)
}

fn first(mut values: impl Iterator<Item = Q>, holds: impl Fn(&Q) -> bool) -> Q {
    values.find(|value| holds(value)).expect("enough decimals come as close as is wanted")
}

fn power_of_ten(exponent: i32) -> Q {
    let power = Q::from(Z::from(10).pow(exponent.unsigned_abs()));
    if exponent < 0 { power.recip() } else { power }
}
