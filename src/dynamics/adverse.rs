//! All motions that a step allows one free body in the plane.

use super::contact::{Contact, add_scaled, dot};
use super::mechanics::Mechanics;
use super::options::ModelKind;
use crate::model::World;

/// Velocities of the body; with these it presses by at most as many independent friction edges.
const FREEDOMS: usize = 3;

/// What counts as zero, relative to the largest speed of the problem.
const ZERO: f64 = 1e-9;

/// A pivot, relative to the largest of its system, that counts as zero.
const SINGULAR: f64 = 1e-9;

/// Whether the motions of a world are found: one free body in the plane, nothing that restitutes, a rigid model.
pub(super) fn is_known_for<S: Mechanics>(world: &World<S>, model: ModelKind) -> bool {
    let n_free = world.bodies.iter().filter(|body| !body.is_kinematic).count();
    let is_plastic = world.materials.iter().all(|material| material.restitution.coefficient() == 0.0);
    let is_rigid = matches!(model, ModelKind::Auto | ModelKind::StewartTrinkle);
    S::TANGENTS == 1 && n_free == 1 && is_plastic && is_rigid
}

/// The contact problem of a step, equations (10)-(13).
#[derive(Debug)]
pub(super) struct Problem<'a, S: Mechanics> {
    pub world: &'a World<S>,
    pub poses: &'a [S::Pose],
    pub contacts: &'a [Contact<S>],
    /// φ/h, a contact each (m/s).
    pub offsets: &'a [f64],
    /// Velocities without contacts, a body each.
    pub free: &'a [S::Velocity],
}

/// A solution: velocities of all bodies, and the impulses along n, t and o of the contacts (N s).
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Motion<S: Mechanics> {
    pub velocities: Vec<S::Velocity>,
    pub impulses: Vec<[f64; 3]>,
}

/// A contact as the free body sees it.
#[derive(Debug, Clone, Copy)]
struct Side<S: Mechanics> {
    body: usize,
    /// Rows of W_n and W_t.
    rows: [S::Velocity; 2],
    /// φ/h + W_nᵀ ν and W_tᵀ ν without contacts (m/s): what impulses must make admissible.
    free: [f64; 2],
    /// Size of what was added up for them.
    size: f64,
}

/// An edge of the friction cone of a contact.
#[derive(Debug, Clone, Copy)]
struct Edge<S: Mechanics> {
    contact: usize,
    /// Tangential impulse for each unit of the normal one: ±μ.
    tangential: f64,
    /// Velocity that a unit of it gives.
    change: S::Velocity,
}

/// Everything known of a problem before impulses are tried.
struct Search<S: Mechanics> {
    sides: Vec<Side<S>>,
    edges: Vec<Edge<S>>,
    /// Changes of the velocity found, with the edges that bear impulses.
    found: Vec<Found<S>>,
}

struct Found<S: Mechanics> {
    change: S::Velocity,
    borne: Vec<(Edge<S>, f64)>,
}

impl<S: Mechanics> Problem<'_, S> {
    /// The sum of all gaps after the step, over its length (m/s).
    pub fn opening(&self, velocities: &[S::Velocity]) -> f64 {
        self.contacts.iter().zip(self.offsets).map(|(contact, offset)| contact.velocity(0, velocities) + offset).sum()
    }

    /// Every solution with another velocity, but for continua of them.
    ///
    /// Of the edges of friction cones that bear an impulse at most three are needed (Carathéodory). Two edges of one
    /// contact say that it sticks; one says that it keeps contact and does not slip towards the edge; each set of edges has
    /// as many equations as unknowns, and its answer is a solution if all inequalities hold.
    pub fn motions(&self) -> Vec<Motion<S>> {
        let sides: Vec<Side<S>> = self.contacts.iter().zip(self.offsets).map(|pair| self.side(pair)).collect();
        let edges = (0..sides.len()).flat_map(|contact| self.edges(contact, &sides[contact])).collect();
        let mut search = Search { sides, edges, found: Vec::new() };
        search.extend(0, &mut Vec::with_capacity(FREEDOMS));
        let motion = |found: &Found<S>| {
            let (mut velocities, mut impulses) = (self.free.to_vec(), vec![[0.0; 3]; self.contacts.len()]);
            if let Some(side) = search.sides.first() {
                add_scaled(&mut velocities[side.body], 1.0, &found.change);
            }
            for (edge, strength) in &found.borne {
                impulses[edge.contact][0] += strength;
                impulses[edge.contact][1] += strength * edge.tangential;
            }
            Motion { velocities, impulses }
        };
        search.found.iter().map(motion).collect()
    }

    fn side(&self, (contact, offset): (&Contact<S>, &f64)) -> Side<S> {
        let is_free = |body: usize| !self.world.bodies[body].is_kinematic;
        let (body, rows) = contact.sides().find(|(body, _)| is_free(*body)).expect("one side of a contact is free");
        let rows = [0, 1].map(|row| rows.as_ref()[row]);
        let size = |row: &S::Velocity| -> f64 {
            row.as_ref().iter().zip(self.free[body].as_ref()).map(|(a, b)| (a * b).abs()).sum()
        };
        Side {
            body,
            rows,
            free: [contact.velocity(0, self.free) + offset, contact.velocity(1, self.free)],
            size: size(&rows[0]).max(size(&rows[1])).max(offset.abs()),
        }
    }

    /// Both edges of a friction cone, or the one of a frictionless contact.
    fn edges(&self, contact: usize, side: &Side<S>) -> impl Iterator<Item = Edge<S>> + use<'_, S> {
        let mu = self.contacts[contact].material.friction;
        let [first, second] = if mu == 0.0 { [Some(0.0), None] } else { [Some(mu), Some(-mu)] };
        let Side { body, rows, .. } = *side;
        let edge = move |tangential: f64| {
            let mut along = rows[0];
            add_scaled(&mut along, tangential, &rows[1]);
            Edge { contact, tangential, change: S::weighed(&self.world.bodies[body], &self.poses[body], &along) }
        };
        first.into_iter().chain(second).map(edge)
    }
}

impl<S: Mechanics> Search<S> {
    fn extend(&mut self, from: usize, chosen: &mut Vec<Edge<S>>) {
        if let Some(found) = self.solution(chosen)
            && self.found.iter().all(|known| !self.is_same(&known.change, &found.change))
        {
            self.found.push(found);
        }
        if chosen.len() == FREEDOMS {
            return;
        }
        for index in from..self.edges.len() {
            chosen.push(self.edges[index]);
            self.extend(index + 1, chosen);
            chosen.pop();
        }
    }

    /// The motion in which just these edges bear impulses, if it is a solution.
    fn solution(&self, chosen: &[Edge<S>]) -> Option<Found<S>> {
        let mut system = [[0.0; FREEDOMS + 1]; FREEDOMS];
        for (index, edge) in chosen.iter().enumerate() {
            // of two edges of a contact the first gives the normal velocity, the second the tangential one
            let direction = usize::from(chosen[..index].iter().any(|other| other.contact == edge.contact));
            let side = &self.sides[edge.contact];
            for (entry, edge) in system[index].iter_mut().zip(chosen) {
                *entry = dot(&side.rows[direction], &edge.change);
            }
            system[index][FREEDOMS] = -side.free[direction];
        }
        let strengths = solve(&mut system, chosen.len())?;
        let strengths = &strengths[..chosen.len()];
        let largest = strengths.iter().copied().fold(0.0, f64::max);
        if strengths.iter().any(|strength| strength.is_nan() || *strength < -ZERO * largest) {
            return None;
        }
        let mut change = S::Velocity::default();
        chosen.iter().zip(strengths).for_each(|(edge, strength)| add_scaled(&mut change, *strength, &edge.change));
        let zero = ZERO * self.speed(&change);
        let velocity = |side: &Side<S>, direction: usize| side.free[direction] + dot(&side.rows[direction], &change);
        let is_admissible = self.sides.iter().all(|side| velocity(side, 0) >= -zero);
        let opposes = |edge: &Edge<S>| {
            let is_alone = chosen.iter().filter(|other| other.contact == edge.contact).count() == 1;
            edge.tangential == 0.0
                || !is_alone
                || velocity(&self.sides[edge.contact], 1) * edge.tangential.signum() <= zero
        };
        (is_admissible && chosen.iter().all(opposes))
            .then(|| Found { change, borne: chosen.iter().copied().zip(strengths.iter().copied()).collect() })
    }

    fn is_same(&self, a: &S::Velocity, b: &S::Velocity) -> bool {
        let zero = 1e3 * ZERO * self.speed(a).max(self.speed(b));
        let same = |row: &S::Velocity| (dot(row, a) - dot(row, b)).abs() <= zero;
        self.sides.iter().all(|side| side.rows.iter().all(same))
    }

    /// A bound of what was added up for the speeds at the contacts (m/s).
    fn speed(&self, change: &S::Velocity) -> f64 {
        let size =
            |row: &S::Velocity| -> f64 { row.as_ref().iter().zip(change.as_ref()).map(|(a, b)| (a * b).abs()).sum() };
        self.sides.iter().map(|side| side.size.max(size(&side.rows[0])).max(size(&side.rows[1]))).fold(0.0, f64::max)
    }
}

/// Solves the first `n` rows and columns of a system whose last column is the right side; `None` if it is singular.
fn solve(system: &mut [[f64; FREEDOMS + 1]; FREEDOMS], n: usize) -> Option<[f64; FREEDOMS]> {
    let largest = system[..n].iter().flat_map(|row| &row[..n]).fold(0.0, |largest: f64, x| largest.max(x.abs()));
    for column in 0..n {
        let pivot = (column..n).max_by(|a, b| system[*a][column].abs().total_cmp(&system[*b][column].abs()))?;
        system.swap(column, pivot);
        let pivot_row = system[column];
        if pivot_row[column].abs() <= SINGULAR * largest {
            return None;
        }
        for (_, row) in system[..n].iter_mut().enumerate().filter(|(row, _)| *row != column) {
            let factor = row[column] / pivot_row[column];
            row.iter_mut().zip(pivot_row).for_each(|(entry, pivot)| *entry -= factor * pivot);
        }
    }
    let mut solution = [0.0; FREEDOMS];
    (0..n).for_each(|i| solution[i] = system[i][FREEDOMS] / system[i][i]);
    Some(solution)
}
