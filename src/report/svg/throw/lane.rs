//! Stable edges, a lane each.

use super::mark::Hue;
use super::pose::Pose;
use crate::answer::{EdgeReach, Throw};
use crate::exact::Q;
use crate::report::Toss;

/// So many edges are drawn.
pub(super) const MOST: usize = 12;

/// A stable edge.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Lane<'a> {
    pub(super) edge: usize,
    pub(super) hue: Hue,
    pub(super) pose: Option<Pose>,
    pub(super) reach: Option<&'a EdgeReach>,
    /// Where the ends of the edge are from the center of mass.
    pub(super) ends: [f64; 2],
}

/// The stable edges, by number; of very many those that orbits visit, then the first.
pub(super) fn lanes<'a>(toss: &Toss, answer: &'a Throw, size: &Q) -> Vec<Lane<'a>> {
    let is_visited = |edge: usize| answer.limit.sets.iter().any(|set| set.bands.contains_key(&edge));
    let mut edges = answer.stable.clone();
    edges.sort_by_key(|edge| (!is_visited(*edge), *edge));
    edges.truncate(MOST);
    edges.sort_unstable();
    let lane = |(number, edge): (usize, usize)| Lane {
        edge,
        hue: Hue::of(number),
        pose: Pose::new(&answer.hull, &toss.part.center_of_mass, size, edge),
        reach: answer.reach.edges.iter().find(|reach| reach.edge == edge),
        ends: (answer.edges.iter().find(|other| other.edge == edge))
            .map_or([0.0, 0.0], |edge| [edge.u_left.to_f64(), edge.u_right.to_f64()]),
    };
    edges.into_iter().enumerate().map(lane).collect()
}
