//! Pins over a conveyor that turn every orientation of a part into one.

mod conveyed;
mod graph;
mod margins;
mod outcome;
mod search;
mod to_answer;

use crate::answer::{HeightQuery, Orientation, OtherFriction, PinAction, Pins};
use crate::exact::{Q, ratio};
use crate::model::{Conveyor, Part, Range};
use conveyed::Conveyed;
use margins::Planned;
use num_traits::Zero as _;
use outcome::{Actions, followed};
use search::Wanted;

/// What is asked of [`pins`].
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct PinQuestion {
    /// Heights whose actions are wanted, positive.
    pub heights: Vec<Q>,
    /// A stable edge that the part, or one that looks the same, is to end on.
    pub end: Option<usize>,
    /// Most pins of a sequence.
    pub max_pins: Option<usize>,
    /// Whether longer sequences with wider tolerances are wanted.
    pub pareto: bool,
    /// Whether it is wanted how far what the case states may be off.
    pub margins: bool,
    /// Whether the curves of the toppling graph are wanted, for drawing.
    pub curves: bool,
}

/// Why pins cannot be planned for a part.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum PinsError {
    /// A disc rolls.
    #[error("a disc has no edges to rest on")]
    Disc,
    /// The part does not rest on the edge that is wanted at the end.
    #[error(
        "the part does not rest stably on edge {edge} of its hull; the edges on which it does are {}",
        list(stable)
    )]
    UnstableEnd {
        /// The edge.
        edge: usize,
        /// Those on which it rests.
        stable: Vec<usize>,
    },
    /// The center of mass is not known well enough to say where the part rests.
    #[error(
        "whether the part rests on edge {edge} of its hull depends on where in its tolerance the center of mass is"
    )]
    UncertainRest {
        /// The edge.
        edge: usize,
    },
}

fn list(edges: &[usize]) -> String {
    edges.iter().map(usize::to_string).collect::<Vec<_>>().join(", ")
}

/// The toppling graph of a part on a conveyor, and the shortest sequence of pins that leaves one orientation.
///
/// What is said of a height holds for all coefficients of friction and places of the center of mass that the case allows,
/// but for jams: it is what happens at every corner of their box, while the part rests on the same edges throughout. If
/// moments stop the part at some point of the box, at some turn and height, they do so at a corner: each is linear in each
/// coefficient, and in the lever of the center of mass about the pivot, with the same value for both where that is zero.
///
/// # Source
/// Zhang, Goldberg, Smith, Berretty & Overmars (2001), Pin design for part feeding.
///
/// # Cost
/// O(n²) curves for n stable edges, sorted by height; the search for a sequence is exponential in the worst case.
///
/// # Errors
/// [`PinsError`] if the part or the question is not one that pins can be planned for.
pub fn pins(part: &Part, conveyor: &Conveyor, question: &PinQuestion) -> Result<Pins, PinsError> {
    let conveyed = Conveyed::of(part, conveyor)?;
    let stable = &conveyed.stable;
    if let Some(edge) = question.end.filter(|edge| !stable.contains(edge)) {
        return Err(PinsError::UnstableEnd { edge, stable: conveyed.stable });
    }
    let (orientations, edges): (Vec<Orientation>, Vec<Actions>) = stable
        .iter()
        .map(|edge| {
            let turns = conveyed.turns(*edge, question.curves);
            let actions = conveyed.actions(&turns);
            (to_answer::orientation(*edge, &turns, &actions.stretches), actions)
        })
        .unzip();
    let wanted = Wanted { end: question.end, max_pins: question.max_pins, pareto: question.pareto };
    let symmetry = conveyed.symmetry();
    let mut plan = conveyed.plan(&symmetry, &edges, &wanted);
    if let Some(sequence) = plan.sequence.as_ref().filter(|_| question.margins) {
        plan.margins = Some(Planned { part, conveyor, outline: conveyed.outline, stable, sequence }.margins());
    }
    if let Some(obstacle) = &mut plan.obstacle {
        obstacle.friction = other_friction(part, conveyor, question.end)?;
    }
    let queries = question.heights.iter().map(|height| query(height, &orientations, &edges, stable)).collect();
    let decisions = conveyed.decisions();
    let Conveyed { corners, stable, .. } = conveyed;
    Ok(Pins { hull: corners, stable, symmetry, orientations, plan, queries, decisions })
}

/// Pins that roll freely, or with such pins ten times the friction on the belt, if there is a sequence then.
fn other_friction(part: &Part, given: &Conveyor, end: Option<usize>) -> Result<Option<OtherFriction>, PinsError> {
    let pin_friction = Range::exactly(Q::zero());
    let belt_friction = if given.pin_friction == pin_friction {
        Range::exactly(&given.belt_friction.min * ratio(10, 1))
    } else {
        given.belt_friction.clone()
    };
    let conveyor = Conveyor { belt_friction, pin_friction };
    let conveyed = Conveyed::of(part, &conveyor)?;
    let wanted = Wanted { end, ..Wanted::default() };
    let sequence = conveyed.plan(&conveyed.symmetry(), &conveyed.edges(), &wanted).sequence;
    let Conveyor { belt_friction, pin_friction } = conveyor;
    Ok(sequence.map(|sequence| OtherFriction { belt_friction, pin_friction, pins: sequence.len() }))
}

fn query(height: &Q, orientations: &[Orientation], edges: &[Actions], stable: &[usize]) -> HeightQuery {
    let found: Vec<(Option<PinAction>, bool)> = orientations.iter().map(|edge| edge.action_at(height)).collect();
    let actions: Vec<Option<PinAction>> = found.iter().map(|(action, _)| *action).collect();
    let end = |place: usize| followed(edges, &actions, place).map(|end| stable[end]);
    HeightQuery {
        height: height.clone(),
        actions: stable.iter().copied().zip(actions.iter().copied()).collect(),
        outcomes: stable.iter().copied().enumerate().map(|(place, edge)| (edge, end(place))).collect(),
        critical_for: stable
            .iter()
            .zip(&found)
            .filter(|(_, (_, is_critical))| *is_critical)
            .map(|(edge, _)| *edge)
            .collect(),
    }
}
