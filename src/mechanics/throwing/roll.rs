//! What a part does between its first impact and rest: it rolls about vertices that stick, and loses energy where it lands
//! flat.

use super::Settling;
use super::body::Body;
use super::real::Real;
use smallvec::{SmallVec, smallvec};

/// Landings after which a part that still rolls is given up.
const MOST_LANDINGS: usize = 100_000;
/// Branches that are followed at once.
const MOST_BRANCHES: usize = 256;

/// The part on a vertex that has just met the arm.
#[derive(Debug, Clone, Copy)]
pub(super) struct Impact<N> {
    pub(super) vertex: usize,
    /// Edges passed in flight: `vertex` is the left end of the one that was flat last.
    pub(super) steps: i64,
    /// Where (length).
    pub(super) x: N,
    /// From the center of mass to the vertex, x.
    pub(super) lever: N,
    /// Angular velocity after the impact.
    pub(super) omega: N,
    /// Energy after the impact, zero on the arm.
    pub(super) energy: N,
}

/// A landing flat on an edge, or where else it ends.
#[derive(Debug, Clone, Copy)]
pub(super) enum End<N> {
    /// At rest on an edge after so many steps, the center of mass so far right of the first impact.
    Rest { edge: usize, steps: i64, beyond: N },
    /// A vertex meets the line of the arm left of the pivot.
    OffArm { vertex: usize, x: N },
    /// Upright on a vertex, or still rolling.
    Balanced { vertex: usize },
    /// Too many branches.
    Unknown,
}

/// About to land flat on an edge.
#[derive(Debug, Clone, Copy)]
pub(super) struct Landing<N> {
    pub(super) edge: usize,
    pub(super) steps: i64,
    /// Whether it turns counter-clockwise.
    pub(super) is_ccw: bool,
    /// Kinetic energy.
    pub(super) energy: N,
    /// From the first impact to the edge's left end (length).
    pub(super) left: N,
}

/// Ways of one decision: one of them, or both where it cannot be told.
fn ways(decision: Option<bool>) -> impl Iterator<Item = bool> {
    [true, false].into_iter().filter(move |way| decision.is_none_or(|known| known == *way))
}

/// Follows every way on which the part may roll, and tells each end, and each landing on the way.
pub(super) fn roll<N: Real>(
    body: &Body<N>,
    impact: &Impact<N>,
    settling: Settling,
    mut visit: impl FnMut(&Landing<N>),
    mut end: impl FnMut(End<N>),
) {
    let mut open: SmallVec<[Landing<N>; 8]> = smallvec![];
    for is_right in ways((-impact.x).is_positive().map(|is_left| !is_left)) {
        if is_right {
            start(body, impact, &mut open, &mut end)
        } else {
            end(End::OffArm { vertex: impact.vertex, x: impact.x })
        }
    }
    let mut n_landings = 0;
    while let Some(landing) = open.pop() {
        n_landings += 1;
        if n_landings > MOST_LANDINGS {
            return end(End::Balanced { vertex: landing.edge });
        }
        if open.len() > MOST_BRANCHES {
            return end(End::Unknown);
        }
        visit(&landing);
        if landing.is_ccw {
            let x = impact.x + landing.left;
            let is_off = (-x).is_positive();
            if is_off != Some(false) {
                end(End::OffArm { vertex: landing.edge, x });
            }
            if is_off == Some(true) {
                continue;
            }
        }
        land(body, landing, settling, &mut open, &mut end);
    }
}

/// From the impact to the first landings.
fn start<N: Real>(
    body: &Body<N>,
    impact: &Impact<N>,
    open: &mut SmallVec<[Landing<N>; 8]>,
    end: &mut impl FnMut(End<N>),
) {
    let vertex = impact.vertex;
    let onto = |is_ccw: bool| {
        let (edge, steps) = if is_ccw { (body.previous(vertex), impact.steps + 1) } else { (vertex, impact.steps) };
        let side = &body.sides[edge];
        Landing {
            edge,
            steps,
            is_ccw,
            energy: impact.energy - body.lambda * side.height,
            left: if is_ccw { -side.length } else { N::double(0.0) },
        }
    };
    let is_over = |is_ccw: bool| {
        let from = if is_ccw { vertex } else { body.previous(vertex) };
        impact.energy.exceeds(barrier(body, from, is_ccw))
    };
    // the center of mass is right of the vertex, left of it, or above
    let right = (-impact.lever).sign();
    let turns = impact.omega.sign();
    let mut to = [false; 2];
    let mut is_balanced = false;
    for (turn, side) in pairs(turns, right) {
        match (turn, side) {
            (0, 0) => is_balanced = true,
            (0, side) => to[usize::from(side < 0)] = true,
            // the turn goes on downward
            (turn, side) if turn * side <= 0 => to[usize::from(turn > 0)] = true,
            (turn, _) => ways(is_over(turn > 0)).for_each(|is_over| to[usize::from((turn > 0) == is_over)] = true),
        }
    }
    if is_balanced {
        end(End::Balanced { vertex });
    }
    (0..2).filter(|is_ccw| to[*is_ccw]).for_each(|is_ccw| open.push(onto(is_ccw == 1)));
}

/// The signs that both may have.
fn pairs(a: Option<std::cmp::Ordering>, b: Option<std::cmp::Ordering>) -> impl Iterator<Item = (i32, i32)> {
    let signs =
        |sign: Option<std::cmp::Ordering>| [-1, 0, 1].into_iter().filter(move |s| sign.is_none_or(|k| k as i32 == *s));
    signs(a).flat_map(move |a| signs(b).map(move |b| (a, b)))
}

/// An impact flat on an edge: on over its far end, back over the other after one more, or rest.
fn land<N: Real>(
    body: &Body<N>,
    landing: Landing<N>,
    settling: Settling,
    open: &mut SmallVec<[Landing<N>; 8]>,
    end: &mut impl FnMut(End<N>),
) {
    let Landing { edge, steps, is_ccw, left, .. } = landing;
    let side = &body.sides[edge];
    let rest = |end: &mut dyn FnMut(End<N>)| end(End::Rest { edge, steps, beyond: left - side.ends[0] });
    if settling == Settling::First && body.is_stable(edge) {
        return rest(end);
    }
    let once = side.energy_kept * landing.energy;
    let on = leaves(body, edge, is_ccw, once);
    if on != Some(false) {
        open.push(next(body, &landing, is_ccw, once));
    }
    if on == Some(true) {
        return;
    }
    let twice = side.energy_kept * once;
    let back = leaves(body, edge, !is_ccw, twice);
    if back != Some(false) {
        open.push(next(body, &landing, !is_ccw, twice));
    }
    if back != Some(true) {
        rest(end);
    }
}

/// Whether a part that turns away from an edge with this kinetic energy comes to lie on the next one.
fn leaves<N: Real>(body: &Body<N>, edge: usize, is_ccw: bool, energy: N) -> Option<bool> {
    let side = &body.sides[edge];
    let is_uphill = if is_ccw { side.is_inside[0] } else { side.is_inside[1] };
    if is_uphill { (energy + body.lambda * side.height).exceeds(barrier(body, edge, is_ccw)) } else { Some(true) }
}

/// Energy of the top between an edge and the next: upright on the vertex between them, or flat on the next where the
/// center of mass does not come to be above the vertex before.
fn barrier<N: Real>(body: &Body<N>, edge: usize, is_ccw: bool) -> N {
    let (next, vertex) = if is_ccw { (body.previous(edge), edge) } else { (body.next(edge), body.next(edge)) };
    let is_over_vertex = body.sides[next].is_inside[usize::from(is_ccw)];
    body.lambda * if is_over_vertex { body.corners[vertex].radius } else { body.sides[next].height }
}

/// The landing that follows on the next edge.
fn next<N: Real>(body: &Body<N>, from: &Landing<N>, is_ccw: bool, energy: N) -> Landing<N> {
    let side = &body.sides[from.edge];
    let edge = if is_ccw { body.previous(from.edge) } else { body.next(from.edge) };
    Landing {
        edge,
        steps: from.steps + if is_ccw { 1 } else { -1 },
        is_ccw,
        energy: energy + body.lambda * (side.height - body.sides[edge].height),
        left: if is_ccw { from.left - body.sides[edge].length } else { from.left + side.length },
    }
}
