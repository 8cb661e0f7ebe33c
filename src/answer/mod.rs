//! What the planners return: data only, exact, ready to be checked and reported.

mod chart;
mod critical;
mod feeder;
mod insert;
mod limit;
mod pins;
mod polyhedron;
mod region;
mod simulation;
mod suggest;
mod throw;
mod verification;
mod witness;

pub use chart::{Chart, ChartFamily, ChartMap, ChartPoint, ChartTile};
pub use critical::{CriticalFactor, CriticalFriction, End, FrictionLimit, NearestChange};
pub use feeder::{DesignCheck, EntryFate, EntryRun, Evaluation, FeederDesign, FeederPlan, Film, Robustness};
pub use insert::{Action, EmptyReason, Insertion, Recommendation, Robust, Stability, WrenchVerdict};
pub use limit::Limit;
pub use pins::{
    ActionInterval, Curve, CurveKind, Decisions, HeightQuery, Margins, Obstacle, Orientation, OtherFriction, Pin,
    PinAction, PinPlan, PinSearch, Pins, Symmetry, ToppleInterval, Tradeoff, Wiper,
};
pub use polyhedron::{Polyhedron, RowFates};
pub use region::{Arc, ArcSet, CanonicalCone, Cone, EdgeFingers, Excluded, Face, FingerSet, Interval, Region};
pub use simulation::{
    ContactName, ContactState, Energy, Event, Feature, Frame, ModelChoice, Simulation, SolverStatistics, Status, Touch,
};
pub use suggest::{Proposal, Searched, Suggestion};
pub use throw::{
    BestSetting, Carry, Caught, Certificate, CommonGrasp, Component, CounterExample, Design, EdgeGrasp, EdgeReach,
    EndedOrbit, Fate, GraspEdge, Hybrid, LimitSet, LimitSets, Piece, Pose, ProofLimit, Reach, Sensor, SensorWindow,
    Setting, SettingKind, Slide, SurdRatio, Throw, ThrowQuery,
};
pub use verification::{Quantity, Refutation, Replay, Tally, Verdict, Verification, wilson};
pub use witness::{ContactMotion, Motion, StateModes, Step, Witness};
