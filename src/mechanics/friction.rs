//! Cones of static friction as functions of a factor on their coefficients.

use super::frame::Frame;
use crate::exact::{Q, Z, make_primitive, primitive_row};
use crate::model::{Fixture, Part};
use num_traits::{One as _, Zero as _};

/// The edges of a contact's cone of static friction while its coefficient grows: `base + k slope` for the factor `k` on the
/// coefficient, in the order and with the sign of [`ContactRows::static_forces`](super::ContactRows::static_forces).
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FrictionEdges {
    /// `-J n`, each on a common factor with its slope.
    pub base: [Vec<Z>; 2],
    /// `± μ J t` for the largest static coefficient `μ` of the case.
    pub slope: [Vec<Z>; 2],
}

impl FrictionEdges {
    /// Those of all fixels, in file order.
    #[must_use]
    pub fn of(part: &Part, fixture: &Fixture) -> Vec<Self> {
        let edges = |frame: &Frame| {
            let tangents = frame.tangent.iter().map(|t| t * &frame.friction.static_.max);
            let both = primitive_row(&frame.normal.iter().map(|n| -n).chain(tangents).collect::<Vec<_>>());
            let (base, slope) = (both[..3].to_vec(), both[3..].to_vec());
            Self { base: [base.clone(), base], slope: [slope.clone(), slope.iter().map(|entry| -entry).collect()] }
        };
        Frame::of(part, fixture).iter().map(edges).collect()
    }

    /// The same edges at factor 1, whatever the factor.
    #[must_use]
    pub fn held(&self) -> Self {
        Self { base: self.at(&Q::one()), slope: [vec![Z::zero(); 3], vec![Z::zero(); 3]] }
    }

    /// Whether the factor is without effect: the coefficient is zero, or the edges are held.
    #[must_use]
    pub fn is_constant(&self) -> bool {
        self.slope.iter().flatten().all(Z::is_zero)
    }

    /// The edges at one factor.
    #[must_use]
    pub fn at(&self, factor: &Q) -> [Vec<Z>; 2] {
        [0, 1].map(|side| {
            let entry = |(base, slope): (&Z, &Z)| base * factor.denom() + slope * factor.numer();
            let mut edge: Vec<Z> = self.base[side].iter().zip(&self.slope[side]).map(entry).collect();
            make_primitive(&mut edge);
            edge
        })
    }
}
