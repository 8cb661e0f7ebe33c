//! The toppling graph in the form of the answer.

use super::graph::Stretch;
use crate::answer::{ActionInterval, Curve, CurveKind, Orientation, PinAction, ToppleInterval};
use crate::exact::Algebraic;
use crate::mechanics::toppling::{Height, Turn};

/// What is said of one stable edge; `turns` are those at the corners of what is uncertain.
pub(super) fn orientation(edge: usize, turns: &[Turn], stretches: &[Stretch<Option<PinAction>>]) -> Orientation {
    let turn = &turns[0];
    let intervals = stretches.iter().map(|stretch| ActionInterval {
        from: stretch.from.exact().clone(),
        to: stretch.to.as_ref().map(|to| to.exact().clone()),
        action: stretch.action,
    });
    let [height, last] = &turn.heights;
    let dip = turns.iter().map(|turn| &turn.least_settling).min().expect("there is a turn");
    let repeating = stretches.iter().filter(|stretch| stretch.action == Some(PinAction::Repeat));
    let mut over_dip = repeating.filter_map(|stretch| common([&stretch.from, stretch.to.as_ref()?], [dip, last]));
    let over_dip = over_dip.next().map(|_| [dip, last].map(|height| height.exact().clone()));
    Orientation {
        edge,
        next: turn.next,
        pivots: turn.pivots.clone(),
        theta_t_deg: turn.theta_t_deg,
        theta_1_deg: turn.theta_1_deg,
        height: height.exact().clone(),
        intervals: intervals.collect(),
        topple: topple(turn, stretches),
        repeat_over_dip: over_dip,
        curves: curves(turn),
    }
}

/// The heights that topple the part, by the edge they touch first.
fn topple(turn: &Turn, stretches: &[Stretch<Option<PinAction>>]) -> Vec<ToppleInterval> {
    let is_toppling = |action| matches!(action, Some(PinAction::Repeat | PinAction::Pass));
    let mut united: Vec<[&Height; 2]> = Vec::new();
    for stretch in stretches.iter().filter(|stretch| is_toppling(stretch.action)) {
        let Some(to) = &stretch.to else { continue };
        match united.last_mut() {
            Some([_, end]) if **end == stretch.from => *end = to,
            _ => united.push([&stretch.from, to]),
        }
    }
    let exact = |height: &Height| -> Algebraic { height.exact().clone() };
    let mut topple = Vec::new();
    for (edge, [low, high]) in &turn.side {
        let touched = united.iter().filter_map(|range| common(*range, [low, high]));
        topple.extend(touched.map(|[from, to]| ToppleInterval { edge: *edge, from: exact(from), to: exact(to) }));
    }
    topple
}

/// What two open intervals have in common.
fn common<'a>(one: [&'a Height; 2], other: [&'a Height; 2]) -> Option<[&'a Height; 2]> {
    let (from, to) = (one[0].max(other[0]), one[1].min(other[1]));
    (from < to).then_some([from, to])
}

fn curves(turn: &Turn) -> Vec<Curve> {
    let named = |curves: &[(usize, Vec<[f64; 2]>)], kind: fn(usize) -> CurveKind| {
        curves.iter().map(|(name, points)| Curve { kind: kind(*name), points: points.clone() }).collect::<Vec<_>>()
    };
    let mut curves = vec![Curve { kind: CurveKind::Radius, points: turn.sketch.radius.clone() }];
    curves.extend(named(&turn.sketch.corners, CurveKind::Vertex));
    curves.extend(named(&turn.sketch.rolling, CurveKind::Rolling));
    curves.extend(named(&turn.sketch.jamming, CurveKind::Jamming));
    curves
}
