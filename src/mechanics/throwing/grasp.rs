//! When a part that is thrown stays put on the arm until it is released.

use crate::exact::{Q, Surd};
use crate::geometry::{cross, difference, dot};
use num_traits::{Signed as _, Zero as _};

/// An edge of the hull on the arm, in the frame F^i of the paper: exact numbers in Q(√n), n the squared length.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RestingEdge {
    /// Squared length n.
    pub length2: Q,
    /// u_l (length).
    pub u_left: Surd,
    /// u_r (length).
    pub u_right: Surd,
    /// d (length).
    pub d: Surd,
    /// κ: what an impact flat on the edge leaves of the energy; zero for a dead stop.
    pub energy_kept: Q,
    /// Largest -u of all corners: the radius at which the part reaches over the pivot (length).
    pub r_clear: Surd,
}

impl RestingEdge {
    /// All edges of the hull with these corners, counter-clockwise; `rho2` is ρ².
    #[must_use]
    pub fn all(corners: &[[Q; 2]], center_of_mass: &[Q; 2], rho2: &Q) -> Vec<Self> {
        (0..corners.len()).map(|edge| Self::new(corners, center_of_mass, rho2, edge)).collect()
    }

    fn new(corners: &[[Q; 2]], center_of_mass: &[Q; 2], rho2: &Q, edge: usize) -> Self {
        let [start, end] = [edge, (edge + 1) % corners.len()].map(|k| difference(center_of_mass, &corners[k]));
        let along = difference(&start, &end);
        let length2 = dot(&along, &along);
        // lengths over √n, as multiples of it
        let over_root = |product: Q| Surd::new(Q::zero(), product / &length2, length2.clone());
        let (left, right, over) = (dot(&start, &along), dot(&end, &along), cross(&start, &along));
        let clear = corners.iter().map(|corner| -dot(&difference(center_of_mass, corner), &along)).max();
        let q = rho2 + (&over * &over + &left * &right) / &length2;
        let inertia = |end: &[Q; 2]| rho2 + dot(end, end);
        let energy_kept = if q.is_positive() { &q * &q / (inertia(&start) * inertia(&end)) } else { Q::zero() };
        Self {
            u_left: over_root(left),
            u_right: over_root(right),
            d: over_root(over),
            energy_kept,
            r_clear: over_root(clear.unwrap_or_else(Q::zero)),
            length2,
        }
    }

    /// u_l < 0 < u_r.
    #[must_use]
    pub fn is_stable(&self) -> bool {
        self.u_left.sign().is_lt() && self.u_right.sign().is_gt()
    }

    /// |h + d| (length).
    #[must_use]
    pub fn height_over_pivot(&self, offset: &Q) -> Surd {
        (&Surd::from(offset.clone()) + &self.d).abs()
    }

    /// The larger of the right sides of (1) and (3), with v_l = v_r = -d (length); the edge is stable.
    #[must_use]
    pub fn r_geom(&self, offset: &Q, rho2: &Q) -> Surd {
        let level = &Surd::from(offset.clone()) + &self.d;
        let moment = &Surd::from(rho2.clone()) + &(&self.d * &level);
        (&moment / &self.u_left).max(&moment / &self.u_right)
    }
}
