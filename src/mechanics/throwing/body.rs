//! A hull over an arm, in the numbers of the throw map.

use super::grasp::RestingEdge;
use super::real::Real;
use crate::exact::Q;
use crate::geometry::{difference, dot};

/// Corners and edges about the center of mass; time is the angle that the part turns in flight, so that speeds are in units
/// of the release speed w, and energies a unit of mass in units of w².
#[derive(Debug, Clone)]
pub struct Body<N> {
    /// Offset h of the arm (length).
    pub(super) offset: N,
    /// λ = |g| / w² (length).
    pub(super) lambda: N,
    /// Release speed w (rad/s).
    pub(super) rate: N,
    /// ρ² (length²).
    pub(super) rho2: N,
    pub(super) corners: Vec<Corner<N>>,
    pub(super) sides: Vec<Side<N>>,
}

/// A corner of the hull; it is the left end of the side with its number.
#[derive(Debug, Clone, Copy)]
pub(super) struct Corner<N> {
    /// From the center of mass, in the part's frame.
    pub(super) at: [N; 2],
    /// Distance from the center of mass.
    pub(super) radius: N,
    /// ρ² plus its square.
    pub(super) inertia: N,
}

/// A side of the hull.
#[derive(Debug, Clone, Copy)]
pub(super) struct Side<N> {
    /// Cosine and sine of its direction, in the part's frame.
    pub(super) direction: [N; 2],
    pub(super) length: N,
    /// u_l and u_r.
    pub(super) ends: [N; 2],
    /// d.
    pub(super) height: N,
    /// κ.
    pub(super) energy_kept: N,
    /// u_l < 0, u_r > 0, exactly.
    pub(super) is_inside: [bool; 2],
}

impl<N: Real> Body<N> {
    /// The hull with these corners, counter-clockwise, and this center of mass, for an arm with `offset`, gravity `gravity`
    /// and release speed `release` (degrees/s); `rho2` is ρ², `edges` are those of the hull.
    #[must_use]
    pub fn new(
        corners: &[[Q; 2]],
        center_of_mass: &[Q; 2],
        rho2: &Q,
        edges: &[RestingEdge],
        [offset, gravity, release]: [&Q; 3],
    ) -> Self {
        let arms: Vec<[Q; 2]> = corners.iter().map(|corner| difference(center_of_mass, corner)).collect();
        let rate = N::of(release) * N::pi() / N::double(180.0);
        let side = |edge: usize| side(&arms[edge], &arms[(edge + 1) % arms.len()], &edges[edge]);
        Self {
            offset: N::of(offset),
            lambda: N::of(gravity) / (rate * rate),
            rate,
            rho2: N::of(rho2),
            corners: arms.iter().map(|arm| corner(arm, rho2)).collect(),
            sides: (0..arms.len()).map(side).collect(),
        }
    }

    /// Number of corners.
    #[must_use]
    pub fn n_corners(&self) -> usize {
        self.corners.len()
    }

    /// Offset h of the arm (length).
    #[must_use]
    pub fn offset(&self) -> N {
        self.offset
    }

    /// λ = |g| / w² (length).
    #[must_use]
    pub fn lambda(&self) -> N {
        self.lambda
    }

    /// Release speed w (rad/s).
    #[must_use]
    pub fn rate(&self) -> N {
        self.rate
    }

    /// u_l and u_r of an edge (length).
    #[must_use]
    pub fn ends(&self, edge: usize) -> [N; 2] {
        self.sides[edge].ends
    }

    /// Height d of the center of mass over an edge (length).
    #[must_use]
    pub fn height(&self, edge: usize) -> N {
        self.sides[edge].height
    }

    /// Whether the part rests stably on an edge.
    #[must_use]
    pub fn is_stable(&self, edge: usize) -> bool {
        self.sides[edge].is_inside == [true, true]
    }

    pub(super) fn next(&self, index: usize) -> usize {
        if index + 1 == self.corners.len() { 0 } else { index + 1 }
    }

    pub(super) fn previous(&self, index: usize) -> usize {
        if index == 0 { self.corners.len() - 1 } else { index - 1 }
    }
}

fn corner<N: Real>(arm: &[Q; 2], rho2: &Q) -> Corner<N> {
    let radius2 = dot(arm, arm);
    Corner { at: arm.each_ref().map(N::of), radius: N::of(&radius2).sqrt(), inertia: N::of(&(rho2 + radius2)) }
}

fn side<N: Real>(start: &[Q; 2], end: &[Q; 2], edge: &RestingEdge) -> Side<N> {
    let length = N::of(&edge.length2).sqrt();
    Side {
        direction: difference(start, end).each_ref().map(|part| N::of(part) / length),
        length,
        ends: [N::of_surd(&edge.u_left), N::of_surd(&edge.u_right)],
        height: N::of_surd(&edge.d),
        energy_kept: N::of(&edge.energy_kept),
        is_inside: [edge.u_left.sign().is_lt(), edge.u_right.sign().is_gt()],
    }
}
