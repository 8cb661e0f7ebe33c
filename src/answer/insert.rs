//! Answers of `plan insert`, `plan stable` and `plan cone`.

use super::{Arc, ArcSet, Cone, CriticalFriction, FingerSet, Interval, NearestChange, Region, Witness};
use crate::exact::{Q, Z};

/// Which wrenches seat the part, and how to apply one.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Insertion {
    /// Wrenches that seat the part from every state, formula (21) of Balkcom & Trinkle for any number of fixels.
    pub goal: Region,
    /// Wrenches under which no sequence of possible transitions between contact sets can go on for ever: the complete
    /// set of guarantees of this kind, which contains `goal`.
    pub acyclic: Region,
    /// Wrenches of `goal` that also hold the seated part still.
    pub hold: Region,
    /// Wrenches for which nothing refutes insertion from rest; contains `acyclic`.
    pub unrefuted: Region,
    /// Why `acyclic` is empty, when it is.
    pub empty_because: Option<EmptyReason>,
    /// Finger places inside `goal`.
    pub goal_fingers: FingerSet,
    /// Finger places inside `acyclic`.
    pub acyclic_fingers: FingerSet,
    /// Tray tilts (directions of gravity in the tray's plane) inside `goal`.
    pub goal_tilt: ArcSet,
    /// Tray tilts inside `acyclic`.
    pub acyclic_tilt: ArcSet,
    /// The push or tilt with the largest margin inside `acyclic`, when there is one.
    pub plan: Option<Recommendation>,
    /// The wrench with the largest relative margin in `goal`, however it may be applied; `None` if there is none or it
    /// was not asked for.
    pub robust: Option<Robust>,
    /// The same for `acyclic`; its radius is at least that of `robust`.
    pub robust_acyclic: Option<Robust>,
    /// How much friction the sets and the plan bear; `None` if it was not asked for.
    pub critical_friction: Option<CriticalFriction>,
    /// What would open `acyclic` where it is empty; `None` if it is not or if critical friction was not asked for.
    pub nearest_change: Option<NearestChange>,
    /// Verdicts on the wrenches that were asked about.
    pub wrenches: Vec<WrenchVerdict>,
    /// Cones of the modes that were asked for, in the order asked.
    pub modes: Vec<(String, Cone)>,
}

/// How the seated part rests under external wrenches.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Stability {
    /// Wrenches that can be balanced with zero acceleration at the least static friction.
    pub weak: Cone,
    /// Whether `weak` is every wrench.
    pub force_closure: bool,
    /// Wrenches under which every solution has zero acceleration, formula (19).
    pub strong: Region,
    /// Contact modes over `s l r n` with a non-empty cone, sorted.
    pub feasible_modes: Vec<String>,
    /// Finger places in the interior of `weak`: a finger there closes the grasp.
    pub closure_fingers: FingerSet,
    /// Finger places inside `weak`.
    pub weak_fingers: FingerSet,
    /// Finger places inside `strong`.
    pub strong_fingers: FingerSet,
    /// Tilts inside `weak`.
    pub weak_tilt: ArcSet,
    /// Tilts inside `strong`.
    pub strong_tilt: ArcSet,
    /// Verdicts on the wrenches that were asked about.
    pub wrenches: Vec<WrenchVerdict>,
    /// Cones of the modes that were asked for, in the order asked.
    pub modes: Vec<(String, Cone)>,
}

/// Which sets contain one wrench.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct WrenchVerdict {
    /// The wrench `[fx, fy, torque]`.
    pub wrench: [Q; 3],
    /// In the weakly stable cone.
    pub weak: bool,
    /// In the strongly stable set.
    pub strong: bool,
    /// In the set of formula (21): every possible transition adds a contact.
    pub goal: bool,
    /// In the complete guaranteed-seating set.
    pub acyclic: bool,
    /// Not refuted.
    pub unrefuted: bool,
    /// Of the modes that were asked for, those whose cone contains the wrench.
    pub modes: Vec<String>,
    /// What shows that the verdict is right.
    pub witness: Witness,
}

/// A push or tilt that seats the part.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Recommendation {
    /// What to do.
    pub action: Action,
    /// The wrench it exerts, up to a positive factor.
    pub wrench: [Q; 3],
    /// Squared relative margin, a certified lower bound: any disturbance `d` with `|d|² < margin2 · |wrench|²` leaves
    /// the wrench in the set, and a finger on an edge is at least ρ times the margin from the edge's ends. Norm: fx² +
    /// fy² + torque² / ρ² with ρ the radius of gyration.
    pub margin2: Q,
}

/// The center of the largest ball of wrenches inside a set, relative to its distance from zero.
///
/// Norm: fx² + fy² + torque² / ρ² with ρ the radius of gyration, up to the mass the norm of the acceleration in the
/// metric of kinetic energy.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Robust {
    /// A wrench within [`Robust::TOLERANCE`] of the best direction's relative radius; coprime integers.
    pub wrench: [Q; 3],
    /// Exact square of the radius of the largest open ball about `wrench` inside the set, over the squared length of
    /// `wrench`; at most 1, for zero is in no set that guarantees anything.
    pub radius2: Q,
    /// Certified upper bound on the relative radius about any wrench.
    pub radius_upper: Q,
}

impl Robust {
    /// What `wrench` may fall short of the best relative radius, unless the search reaches its limit first; then
    /// `radius_upper` is farther above and still holds.
    pub const TOLERANCE: f64 = 1e-6;
}

/// How a wrench is applied.
#[expect(clippy::large_enum_variant, reason = "an answer holds one action")]
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Action {
    /// A frictionless finger pushes on an edge along its inward normal.
    PushEdge {
        /// Edge number.
        edge: usize,
        /// All places around this one that work too.
        interval: Interval,
        /// The place, as a share of the edge.
        s: Q,
        /// The place.
        point: [Q; 2],
        /// Push direction, the inward normal (any length).
        direction: [Q; 2],
    },
    /// A frictionless finger pushes on a circle towards its center.
    PushArc {
        /// All directions around this one that work too; `None` when every direction does.
        arc: Option<Arc>,
        /// Direction from the center to the finger.
        direction: [Z; 2],
    },
    /// The tray is tilted: gravity pulls through the center of mass.
    Tilt {
        /// All directions around this one that work too; `None` when every direction does.
        arc: Option<Arc>,
        /// Direction of the pull in the tray's plane.
        direction: [Z; 2],
    },
    /// Neither finger nor tilt suffices: the wrench itself must be applied (force and torque together).
    Wrench,
}

/// Why no wrench is guaranteed to seat the part.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum EmptyReason {
    /// The normals' wrenches are linearly dependent: whatever the wrench, the part can rest with a fixel free.
    DependentNormals,
    /// Two fixels can jam the part between them whatever the wrench (frictional force closure of the pair).
    PairForceClosure {
        /// The two fixels.
        fixels: [usize; 2],
    },
    /// The listed modes together are consistent with every wrench.
    BlockingModes {
        /// Modes, in the notation of the `insert` letters.
        modes: Vec<String>,
    },
}
