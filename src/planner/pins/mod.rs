//! Pins over a conveyor that turn every orientation of a part into one.

mod graph;
mod margins;
mod outcome;
mod search;
mod to_answer;

use crate::answer::{Decisions, HeightQuery, Orientation, OtherFriction, PinAction, Pins, Symmetry};
use crate::exact::{Q, ratio};
use crate::geometry::symmetry_shift;
use crate::mechanics::toppling::{Signs, Toppled, Turn};
use crate::model::{Conveyor, Part, Range, Shape};
use graph::{actions, overlay};
use margins::Planned;
use num_traits::Zero as _;
use outcome::{Actions, bands, followed};
use search::{Wanted, plan};
use std::collections::BTreeMap;

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
    let mut answer = planned(part, conveyor, question)?;
    if let Some(obstacle) = &mut answer.plan.obstacle {
        obstacle.friction = other_friction(part, conveyor, question)?;
    }
    Ok(answer)
}

/// Pins that roll freely, or with such pins ten times the friction on the belt, if there is a sequence then.
fn other_friction(part: &Part, given: &Conveyor, question: &PinQuestion) -> Result<Option<OtherFriction>, PinsError> {
    let free = Range::exactly(Q::zero());
    let Conveyor { belt_friction, pin_friction } = given;
    let belt_friction =
        if *pin_friction == free { Range::exactly(&belt_friction.min * ratio(10, 1)) } else { belt_friction.clone() };
    let conveyor = Conveyor { belt_friction, pin_friction: free };
    let question = PinQuestion { end: question.end, ..PinQuestion::default() };
    let sequence = planned(part, &conveyor, &question)?.plan.sequence;
    let Conveyor { belt_friction, pin_friction } = conveyor;
    Ok(sequence.map(|sequence| OtherFriction { belt_friction, pin_friction, pins: sequence.len() }))
}

fn planned(part: &Part, conveyor: &Conveyor, question: &PinQuestion) -> Result<Pins, PinsError> {
    let Shape::Polygon(outline) = &part.shape else { return Err(PinsError::Disc) };
    let corners: Vec<[Q; 2]> = outline.hull().into_iter().map(|corner| outline.vertices()[corner].clone()).collect();
    let cases = corners_of_box(part, conveyor);
    let stable = stable_edges(&corners, &cases)?;
    if let Some(edge) = question.end.filter(|edge| !stable.contains(edge)) {
        return Err(PinsError::UnstableEnd { edge, stable });
    }
    let shift = if part.center_of_mass_tolerance > Q::default() {
        corners.len()
    } else {
        symmetry_shift(outline, &part.center_of_mass)
    };
    let symmetry = Symmetry { shift, classes: classes(&stable, shift) };
    let signs = Signs::default();
    let place = |edge: usize| stable.iter().position(|other| *other == edge).expect("turns end on stable edges");
    let mut orientations = Vec::new();
    let mut edges = Vec::new();
    for edge in stable.iter().copied() {
        let turns: Vec<Turn> =
            cases.iter().map(|case| case.toppled(&corners).turn(edge, question.curves, &signs)).collect();
        let next = place(turns[0].next);
        let stretches = overlay(&turns.iter().map(actions).collect::<Vec<_>>());
        orientations.push(to_answer::orientation(edge, &turns, &stretches));
        edges.push(Actions { next, stretches });
    }
    let wanted = Wanted { end: question.end, max_pins: question.max_pins, pareto: question.pareto };
    let mut plan = plan(&stable, &symmetry, &bands(&edges), &wanted, &mut || false);
    if let Some(sequence) = plan.sequence.as_ref().filter(|_| question.margins) {
        let planned = Planned { part, conveyor, outline, corners: &corners, stable: &stable, sequence };
        plan.margins = Some(planned.margins());
    }
    let queries = question.heights.iter().map(|height| query(height, &orientations, &edges, &stable)).collect();
    let decisions = Decisions {
        filtered: signs.counter.n_filtered() + signs.filter.n_settled(),
        exact: signs.counter.n_exact() + signs.filter.n_exact(),
    };
    Ok(Pins { hull: corners, stable, symmetry, orientations, plan, queries, decisions })
}

/// One choice of what is uncertain.
struct Choice {
    center_of_mass: [Q; 2],
    belt_friction: Q,
    pin_friction: [Q; 2],
}

impl Choice {
    fn toppled<'a>(&'a self, corners: &'a [[Q; 2]]) -> Toppled<'a> {
        Toppled {
            corners,
            center_of_mass: &self.center_of_mass,
            belt_friction: &self.belt_friction,
            pin_friction: self.pin_friction.each_ref(),
        }
    }
}

/// The choices at the corners of the box of what is uncertain; what is known has one value. With both ends of the friction at
/// the pin comes the mixture of them that [`Toppled::pin_friction`] explains.
fn corners_of_box(part: &Part, conveyor: &Conveyor) -> Vec<Choice> {
    let ends = |range: &Range| {
        let mut ends = vec![range.min.clone(), range.max.clone()];
        ends.dedup();
        ends
    };
    let [x, y] = [0, 1].map(|axis| {
        let (center, tolerance) = (&part.center_of_mass[axis], &part.center_of_mass_tolerance);
        ends(&Range { min: center - tolerance, max: center + tolerance })
    });
    let Range { min, max } = &conveyor.pin_friction;
    let mut pin_frictions = vec![[min, max], [max, max], [min, min]];
    pin_frictions.dedup();
    let mut choices = Vec::new();
    for belt_friction in ends(&conveyor.belt_friction) {
        for pin_friction in &pin_frictions {
            for center_of_mass in x.iter().flat_map(|x| y.iter().map(|y| [x.clone(), y.clone()])) {
                let pin_friction = pin_friction.map(Q::clone);
                choices.push(Choice { center_of_mass, belt_friction: belt_friction.clone(), pin_friction });
            }
        }
    }
    choices
}

/// The edges on which the part rests stably, whatever is uncertain.
fn stable_edges(corners: &[[Q; 2]], choices: &[Choice]) -> Result<Vec<usize>, PinsError> {
    let mut stable = Vec::new();
    for edge in 0..corners.len() {
        let rests = choices.iter().filter(|choice| choice.toppled(corners).is_stable(edge)).count();
        if rests == choices.len() {
            stable.push(edge);
        } else if rests > 0 {
            return Err(PinsError::UncertainRest { edge });
        }
    }
    Ok(stable)
}

/// Stable edges that a turn by `shift` edges takes to each other.
fn classes(stable: &[usize], shift: usize) -> Vec<Vec<usize>> {
    let mut classes: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for edge in stable {
        classes.entry(edge % shift).or_default().push(*edge);
    }
    let mut classes: Vec<Vec<usize>> = classes.into_values().collect();
    classes.sort();
    classes
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
