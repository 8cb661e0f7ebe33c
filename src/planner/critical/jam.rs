//! Pairs of fixels that jam the part between them.

use crate::exact::Q;
use crate::geometry::{cross, difference, dot};
use crate::model::{Fixel, Fixture};
use num_traits::{Signed as _, Zero as _};

/// Above which factor on all coefficients a pair of fixels balances every wrench, and the pair with the least such factor:
/// each then lies strictly inside the other's friction cone. `None` if no pair ever does.
pub(super) fn first_jam(fixture: &Fixture) -> Option<(Q, [usize; 2])> {
    jams(fixture).into_iter().min_by(|a, b| a.0.cmp(&b.0))
}

/// The pair that jams the part above exactly `factor`.
pub(super) fn jam_at(fixture: &Fixture, factor: &Q) -> Option<[usize; 2]> {
    jams(fixture).into_iter().find(|(above, _)| above == factor).map(|(_, pair)| pair)
}

fn jams(fixture: &Fixture) -> Vec<(Q, [usize; 2])> {
    let fixels = &fixture.fixels;
    let pairs = (0..fixels.len()).flat_map(|second| (0..second).map(move |first| [first, second]));
    let jam = |[first, second]: [usize; 2]| {
        let way = difference(&fixels[first].point, &fixels[second].point);
        let back = [-&way[0], -&way[1]];
        Some((sees_above(&fixels[first], &way)?.max(sees_above(&fixels[second], &back)?), [first, second]))
    };
    pairs.filter_map(jam).collect()
}

/// The factor above which `way` points strictly into the friction cone of the fixel.
fn sees_above(fixel: &Fixel, way: &[Q; 2]) -> Option<Q> {
    let along = dot(&fixel.normal, way);
    let bearing = &fixel.friction.static_.max * &along;
    (along.is_positive() && !bearing.is_zero()).then(|| cross(&fixel.normal, way).abs() / bearing)
}
