//! A part on a conveyor, with all that is uncertain of it.

use super::PinsError;
use super::graph::{actions, overlay};
use super::outcome::{Actions, bands};
use super::search::{Wanted, plan};
use crate::answer::{Decisions, PinPlan, Symmetry};
use crate::exact::Q;
use crate::geometry::{Polygon, symmetry_shift};
use crate::mechanics::toppling::{Signs, Toppled, Turn};
use crate::model::{Conveyor, Part, Range, Shape};
use num_traits::Zero as _;
use std::collections::BTreeMap;

/// The hull on the belt, at every corner of what is uncertain.
pub(super) struct Conveyed<'a> {
    part: &'a Part,
    pub(super) outline: &'a Polygon,
    pub(super) corners: Vec<[Q; 2]>,
    choices: Vec<Choice>,
    /// The edges on which it rests stably, whatever is uncertain.
    pub(super) stable: Vec<usize>,
    signs: Signs,
}

impl<'a> Conveyed<'a> {
    /// # Errors
    /// [`PinsError`] if the part is a disc, or if it is uncertain where it rests.
    pub(super) fn of(part: &'a Part, conveyor: &Conveyor) -> Result<Self, PinsError> {
        let Shape::Polygon(outline) = &part.shape else { return Err(PinsError::Disc) };
        let corners: Vec<[Q; 2]> =
            outline.hull().into_iter().map(|corner| outline.vertices()[corner].clone()).collect();
        let choices = corners_of_box(part, conveyor);
        let stable = stable_edges(&corners, &choices)?;
        Ok(Self { part, outline, corners, choices, stable, signs: Signs::default() })
    }

    /// Whether the center of mass is inside of the hull wherever it may be.
    pub(super) fn holds_its_center(&self) -> bool {
        let centers: Vec<[Q; 2]> = self.choices.iter().map(|choice| choice.center_of_mass.clone()).collect();
        self.outline.hull_contains_all(&centers)
    }

    /// Which stable edges look the same; none where it is uncertain.
    pub(super) fn symmetry(&self) -> Symmetry {
        let shift = if self.part.center_of_mass_tolerance.is_zero() {
            symmetry_shift(self.outline, &self.part.center_of_mass)
        } else {
            self.corners.len()
        };
        let mut classes: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        for edge in &self.stable {
            classes.entry(edge % shift).or_default().push(*edge);
        }
        let mut classes: Vec<Vec<usize>> = classes.into_values().collect();
        classes.sort();
        Symmetry { shift, classes }
    }

    /// The turns from a stable edge, one for each choice of what is uncertain; all end on the same edge.
    pub(super) fn turns(&self, edge: usize, is_drawn: bool) -> Vec<Turn> {
        let turn = |choice: &Choice| choice.toppled(&self.corners).turn(edge, is_drawn, &self.signs);
        self.choices.iter().map(turn).collect()
    }

    /// What pins do to these turns, all of them.
    pub(super) fn actions(&self, turns: &[Turn]) -> Actions {
        let next = self.stable.iter().position(|edge| *edge == turns[0].next).expect("turns end on stable edges");
        Actions { next, stretches: overlay(&turns.iter().map(actions).collect::<Vec<_>>()) }
    }

    /// [`Conveyed::actions`] for each stable edge.
    pub(super) fn edges(&self) -> Vec<Actions> {
        self.stable.iter().map(|edge| self.actions(&self.turns(*edge, false))).collect()
    }

    /// The sequence of pins for what they do to each stable edge.
    pub(super) fn plan(&self, symmetry: &Symmetry, edges: &[Actions], wanted: &Wanted) -> PinPlan {
        plan(&self.stable, symmetry, &bands(edges), wanted, &mut || false)
    }

    /// How the signs were decided so far.
    pub(super) fn decisions(&self) -> Decisions {
        let Signs { counter, filter } = &self.signs;
        Decisions { filtered: counter.n_filtered() + filter.n_settled(), exact: counter.n_exact() + filter.n_exact() }
    }
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
