//! The wrenches that are certain to seat the part, and the best simple way to apply one.

use super::fingers::{Pushes, arc_set, finger_set, tilt_plane};
use super::recommend::{Margins, recommend};
use super::transitions::{Transitions, Verdict};
use crate::answer::{ArcSet, FingerSet, Recommendation};
use crate::cone::{Cone, complement};
use crate::exact::{Int, Overflow};
use crate::model::Part;

/// What a plan of insertion is made of.
pub(super) struct Seating<T> {
    /// Disjoint cells of the wrenches under which no sequence of possible transitions goes on for ever.
    pub(super) acyclic: Vec<Cone<T>>,
    /// Cells with a cycle; together with the loops they cover the rest.
    pub(super) cyclic: Vec<Cone<T>>,
    /// Finger places inside `acyclic`.
    pub(super) fingers: FingerSet,
    /// Tilts inside `acyclic`.
    pub(super) tilt: ArcSet,
    /// The push or tilt with the largest margin, if there is one.
    pub(super) plan: Option<Recommendation>,
}

impl<T: Int> Seating<T> {
    /// Of a part with these `pushes` and `transitions`, the latter `None` if some unseated state can always persist.
    pub(super) fn of(part: &Part, pushes: &Pushes, transitions: Option<&Transitions<T>>) -> Result<Self, Overflow> {
        let Verdict { acyclic, cyclic } = match transitions {
            Some(transitions) => transitions.verdict(complement(3, &transitions.loops)?)?,
            None => Verdict { acyclic: Vec::new(), cyclic: Vec::new() },
        };
        let loops = transitions.into_iter().flat_map(|transitions| &transitions.loops);
        let margins = Margins::of(&loops.chain(&cyclic).collect::<Vec<_>>(), part.gyration2());
        let fingers = finger_set(part, pushes, &acyclic)?;
        let tilt = arc_set(&tilt_plane(), &acyclic)?;
        let inner = acyclic.iter().map(Cone::inner_point).collect::<Result<Vec<_>, _>>()?;
        let plan = recommend(part, pushes, &fingers, &tilt, &inner, &margins);
        Ok(Self { acyclic, cyclic, fingers, tilt, plan })
    }
}
