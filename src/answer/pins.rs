//! Answer of `plan pins`.

use super::Limit;
use crate::exact::{Algebraic, Q};
use crate::model::Range;
use std::cmp::Ordering;
use std::collections::BTreeMap;

/// What pins over a conveyor do to a part, and the pins that turn it into one orientation.
///
/// Edges are those of the hull, edge `i` from corner `i` to the next; an orientation is named by the edge on the belt.
/// Heights are above the belt, in the unit of the part.
#[derive(Debug, Clone)]
pub struct Pins {
    /// Corners of the convex hull, counter-clockwise.
    pub hull: Vec<[Q; 2]>,
    /// Edges on which the part rests stably, ascending.
    pub stable: Vec<usize>,
    /// Which of them look the same.
    pub symmetry: Symmetry,
    /// The toppling graph: one entry for each stable edge, in their order.
    pub orientations: Vec<Orientation>,
    /// The pins, or why there are none.
    pub plan: PinPlan,
    /// What pins of given heights do.
    pub queries: Vec<HeightQuery>,
    /// How signs were decided.
    pub decisions: Decisions,
}

/// Turns of the hull about its center of mass that leave no difference.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Symmetry {
    /// The least number of edges by which the hull may be turned onto itself; that of all edges if there is no such turn.
    pub shift: usize,
    /// The stable edges that cannot be told apart, ascending by their first.
    pub classes: Vec<Vec<usize>>,
}

/// What pins do to a part that rests on one edge.
#[derive(Debug, Clone)]
pub struct Orientation {
    /// The edge on the belt.
    pub edge: usize,
    /// The stable edge onto which the part topples.
    pub next: usize,
    /// The corners about which it turns on the way, in order; more than one where an unstable edge lands flat.
    pub pivots: Vec<usize>,
    /// Turn until the center of mass is over the pivot, in degrees, to nearest.
    pub theta_t_deg: f64,
    /// Turn until the next stable edge is flat, in degrees, to nearest.
    pub theta_1_deg: f64,
    /// Height of the part.
    pub height: Algebraic,
    /// What a pin does, for all heights above zero in order.
    pub intervals: Vec<ActionInterval>,
    /// The heights that topple the part, by the edge that the pin touches first.
    pub topple: Vec<ToppleInterval>,
    /// Heights between the lowest to which the part ducks while it settles and its height after that: whether those of
    /// them that are called [`PinAction::Repeat`] meet the part again depends on how fast it falls. `None` if none is.
    pub repeat_over_dip: Option<[Algebraic; 2]>,
    /// The curves of the toppling graph while the part turns from here to the next stable edge, if they were asked for;
    /// for pictures only.
    pub curves: Vec<Curve>,
}

/// A curve of the toppling graph.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// What it says.
    pub kind: CurveKind,
    /// Points (turn in degrees, height), the turn ascending.
    pub points: Vec<[f64; 2]>,
}

/// What a curve of the toppling graph says about a turn of the part.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CurveKind {
    /// Height R of the center of mass.
    Radius,
    /// Height V of this corner, while a pin can touch one of its edges.
    Vertex(usize),
    /// Height H that a pin on this edge needs to roll the part.
    Rolling(usize),
    /// Height J up to which a pin on this edge may jam the part while it settles.
    Jamming(usize),
}

/// Heights at which a pin does the same.
///
/// What happens at an end shared by two intervals [`Orientation::action_at`] says. A single height that jams has an interval of
/// its own.
#[derive(Debug, Clone)]
pub struct ActionInterval {
    /// The lower end; zero is not a height.
    pub from: Algebraic,
    /// The upper end; `None` where there is no end.
    pub to: Option<Algebraic>,
    /// What the pin does; `None` where it depends on what is uncertain in the case. A jam is one at the corners of what is
    /// uncertain: in between the part may come through.
    pub action: Option<PinAction>,
}

/// What a pin does to a part that meets it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum PinAction {
    /// The part passes under the pin.
    PassUnder,
    /// The part is lifted, loses the pin and falls back.
    FallBack,
    /// The part is stuck.
    Jam,
    /// The part topples and meets the pin again.
    Repeat,
    /// The part topples and leaves the pin behind.
    Pass,
}

impl PinAction {
    /// The name in documents.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::PassUnder => "pass-under",
            Self::FallBack => "fall-back",
            Self::Jam => "jam",
            Self::Repeat => "repeat",
            Self::Pass => "pass",
        }
    }
}

/// Heights that topple the part by one edge.
#[derive(Debug, Clone)]
pub struct ToppleInterval {
    /// The edge that the pin touches first.
    pub edge: usize,
    /// The lower end.
    pub from: Algebraic,
    /// The upper end.
    pub to: Algebraic,
}

/// A sequence of pins, or the proof that there is none.
#[derive(Debug, Clone, Default)]
pub struct PinPlan {
    /// The fewest pins after which all stable orientations are one, and among the fewest those with the widest least
    /// tolerance; `None` if there are none, or a limit came first.
    pub sequence: Option<Vec<Pin>>,
    /// The stable edges, which look the same, on which the part ends.
    pub end: Vec<usize>,
    /// One least tolerance for each number of pins that improves on fewer pins; asked for by the user.
    pub pareto: Vec<Tradeoff>,
    /// The fewest pins of any sequence, where that is more than were allowed.
    pub needs: Option<usize>,
    /// How far what the case states may be off; asked for by the user.
    pub margins: Option<Margins>,
    /// Why there is no sequence.
    pub obstacle: Option<Obstacle>,
    /// How much was searched.
    pub searched: PinSearch,
    /// The limit that ended the search.
    pub limit: Option<Limit>,
}

/// How far what a case states may be off before the pins fail, each by itself and all else as stated.
///
/// What is inside of these limits works; what is outside was not shown to, within a step of the search.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Margins {
    /// Friction between part and belt.
    pub belt_friction: Range,
    /// Friction between part and pin.
    pub pin_friction: Range,
    /// Greater multiples of the friction stated were not tried.
    pub friction_tried: Q,
    /// Half-width of the square in which the center of mass may lie; an eighth of the part was not exceeded.
    pub center_of_mass: Q,
}

/// One pin.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Pin {
    /// Where to put it: in the middle of a rational interval inside of the ends.
    pub height: Q,
    /// The lower end of the heights that do the same; not one of them.
    pub low: Algebraic,
    /// The upper end.
    pub high: Algebraic,
    /// How far the height may be off, rounded down.
    pub tolerance: Q,
    /// Where each edge that the part may rest on before this pin goes.
    pub outcome: BTreeMap<usize, usize>,
    /// The edges that the part may rest on after it.
    pub after: Vec<usize>,
}

/// More pins for a wider tolerance.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Tradeoff {
    /// How many pins.
    pub pins: usize,
    /// The widest least tolerance that so many pins can have, rounded down to twelve digits.
    pub tolerance: Q,
}

/// Why no sequence of pins turns all orientations into one; each part of it is a set of stable edges.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Obstacle {
    /// The smallest sets of orientations that pins can reach from all of them.
    pub smallest_sets: Vec<Vec<usize>>,
    /// Pairs of orientations that no sequence of pins brings together.
    pub inseparable_pairs: Vec<[usize; 2]>,
    /// Orientations that no pin moves that may be used on any of the sets that pins can reach.
    pub never_moved: Vec<usize>,
    /// What would help: orientations to be taken off the belt.
    pub wiper: Option<Wiper>,
    /// What would help: other friction.
    pub friction: Option<OtherFriction>,
}

/// Friction for which there is a sequence of pins.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OtherFriction {
    /// Between part and belt.
    pub belt_friction: Range,
    /// Between part and pin; zero for pins that roll freely.
    pub pin_friction: Range,
    /// How many pins are then needed.
    pub pins: usize,
}

/// A wiper that takes orientations off the belt.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Wiper {
    /// The pins before it.
    pub pins: Vec<Pin>,
    /// The orientations that are to be discarded after the pins, those that look the same once.
    pub discarded: Vec<usize>,
    /// The orientation that is left.
    pub kept: usize,
    /// How many of the stable orientations the pins bring to the one that is left.
    pub yielding: usize,
}

/// How much was searched.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct PinSearch {
    /// Bands of heights between neighbouring critical ones.
    pub height_classes: usize,
    /// Different outcomes of these, not counting that nothing moves.
    pub distinct_outcome_maps: usize,
    /// Those of them that jam no orientation.
    pub usable_first_pins: usize,
    /// Sets of orientations met, that of all included; not all that can be reached where the search did not need them.
    pub reachable_sets: usize,
    /// Whether no pin that is of use jams any orientation, so that the number of pins is known from arcs of the cyclic
    /// order of orientations (Eppstein 1990).
    pub by_arcs: bool,
}

/// What a pin of one height does to every orientation.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct HeightQuery {
    /// The height.
    pub height: Q,
    /// The action on each stable edge; `None` where it depends on what is uncertain in the case.
    pub actions: BTreeMap<usize, Option<PinAction>>,
    /// The edge on which each stable edge ends; `None` where the part jams or it is uncertain.
    pub outcomes: BTreeMap<usize, Option<usize>>,
    /// The stable edges for which the height is exactly critical.
    pub critical_for: Vec<usize>,
}

/// How signs were decided.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Decisions {
    /// By intervals of doubles.
    pub filtered: u64,
    /// By exact arithmetic.
    pub exact: u64,
}

impl PinPlan {
    /// Whether it is known if there is a sequence: there is one, or more pins would be needed than are allowed, or none
    /// exists.
    #[must_use]
    pub fn is_decided(&self) -> bool {
        self.sequence.is_some() || self.needs.is_some() || self.obstacle.is_some()
    }
}

impl Orientation {
    /// What a pin does at `height`, above zero, and whether that is exactly a critical height.
    ///
    /// A part as high as the pin passes under it. Otherwise a critical height jams if one of its sides does, since the
    /// heights that jam are a closed set, and does what heights above it do if none does.
    #[must_use]
    pub fn action_at(&self, height: &Q) -> (Option<PinAction>, bool) {
        let height = Algebraic::from(height.clone());
        let above = |interval: &ActionInterval| interval.to.as_ref().is_none_or(|to| height.cmp(to) == Ordering::Less);
        let at = self.intervals.iter().position(above).expect("the last interval has no end");
        let here = &self.intervals[at];
        if at == 0 || height > here.from {
            return (here.action, false);
        }
        let below = self.intervals[at - 1].action;
        let action = match (below, here.action) {
            (_, Some(PinAction::PassUnder)) => here.action,
            (Some(PinAction::Jam), _) | (_, Some(PinAction::Jam)) => Some(PinAction::Jam),
            (below, action) => below.and(action),
        };
        (action, true)
    }
}
