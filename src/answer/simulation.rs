//! What a run of a time-stepper returns.

use crate::model::Space;

/// A run of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Simulation<S: Space> {
    /// How it ended.
    pub status: Status,
    /// Time reached (s).
    pub time: f64,
    /// Poses and velocities at that time, a body each.
    pub last: Frame<S>,
    /// Frames by time, the first at the start: what pictures and trajectories show.
    pub frames: Vec<Frame<S>>,
    /// What changed at contacts, by time.
    pub events: Vec<Event>,
    /// Deformation of compliant contacts at the end, along n, t and o (m); also of those that are open and still heal.
    pub deformations: Vec<(ContactName, [f64; 3])>,
    /// Energy at the start, at the end and on the way.
    pub energy: Energy,
    /// Deepest overlap met (m), not negative, and when (s).
    pub penetration: (f64, f64),
    /// What the solver did.
    pub solver: SolverStatistics,
    /// Which model ran, and why.
    pub model: ModelChoice,
    /// Things worth knowing: overlaps at the start, steps subdivided, ambiguity met.
    pub notes: Vec<String>,
}

/// How a run ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Status {
    /// It ran to its end.
    Complete,
    /// It ran to its end, but at some step the contact problem has several motions.
    Ambiguous,
    /// At some step no motion is possible: bodies overlap and are held so.
    Inconsistent,
    /// Stopped before its end.
    Partial,
}

/// All bodies at one time.
#[derive(Debug, Clone, PartialEq)]
pub struct Frame<S: Space> {
    /// Time (s).
    pub time: f64,
    /// A pose a body.
    pub poses: Vec<S::Pose>,
    /// A velocity a body.
    pub velocities: Vec<S::Velocity>,
    /// Contacts that held or gave way in the step that ended here.
    pub touches: Vec<Touch<S>>,
}

/// A contact with an impulse.
#[derive(Debug, Clone, PartialEq)]
pub struct Touch<S: Space> {
    /// Which.
    pub contact: ContactName,
    /// State in the step.
    pub state: ContactState,
    /// Where (m, world).
    pub point: S::Vector,
    /// Unit normal into the body.
    pub normal: S::Vector,
    /// Impulse of the step along n, t and o (N s); with redundant contacts one of many that move the bodies alike.
    pub impulse: [f64; 3],
}

/// State of a contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum ContactState {
    /// No force.
    Open,
    /// Force, no slip.
    Stick,
    /// Force, slip.
    Slip,
}

/// A change of state.
#[derive(Debug, Clone, PartialEq)]
pub struct Event {
    /// When (s).
    pub time: f64,
    /// Which contact.
    pub contact: ContactName,
    /// State before.
    pub from: ContactState,
    /// State after.
    pub to: ContactState,
}

/// A pair of features, named: body and feature, other body or obstacle and feature.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ContactName {
    /// Number of the body.
    pub body: usize,
    /// Its feature.
    pub feature: Feature,
    /// A body after `body`, or the number of bodies plus that of an obstacle.
    pub other: usize,
    /// The other's feature.
    pub other_feature: Feature,
}

/// A feature of an outline.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Feature {
    /// A vertex, by its number in the outline (pieces of a compound one after the other).
    Vertex(u32),
    /// An edge or face in the plane, by its first vertex; an edge of a box, by its axis and place.
    Edge(u32),
    /// The surface of a disc, ball, half plane or half space, by its piece; a face of a box, from 1 on.
    Surface(u32),
}

/// Energy (J): kinetic, potential, and that of local deformation.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Energy {
    /// At the start.
    pub start: f64,
    /// At the end.
    pub end: f64,
    /// Work done by wrenches, moving surfaces and kinematic bodies, and by undoing overlaps.
    pub work: f64,
    /// Dissipated by friction, impacts and damping, including that of the scheme.
    pub dissipated: f64,
    /// Largest gain in one step that no work explains, not negative.
    pub largest_gain: f64,
}

/// What the solver did.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SolverStatistics {
    /// Steps taken, substeps counted.
    pub steps: usize,
    /// Contact problems solved.
    pub problems: usize,
    /// Pivots or Newton iterations.
    pub pivots: usize,
    /// How many problems each rung of the ladder answered, by its name, in the order of the ladder.
    pub rungs: Vec<(&'static str, usize)>,
    /// Largest residual accepted, scaled.
    pub residual: f64,
    /// Impacts located.
    pub impacts: usize,
    /// Largest speed at which features met in an impact (m/s).
    pub fastest_impact: f64,
    /// Steps that had to be repeated smaller.
    pub subdivided: usize,
}

/// Which model ran, and why.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ModelChoice {
    /// Its name: `frictionless`, `st`, `located`, `spk`.
    pub chosen: &'static str,
    /// Step (s).
    pub step: f64,
    /// Reasons, each a computed criterion with its value.
    pub why: Vec<String>,
    /// Estimated error of the final poses (m), from a run at half the step, where one was made.
    pub error: Option<f64>,
}
