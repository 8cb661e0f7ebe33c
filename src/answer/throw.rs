//! What the planner of throws returns.

use crate::exact::{Q, Surd};
use std::collections::BTreeMap;

/// The throw map of a part on an arm, and what becomes of the part when it is thrown again and again.
///
/// A state is `(edge, R)`: the edge of the hull on the arm and the x of the center of mass (length). Exact where a number is
/// a [`Q`] or [`Surd`]; what flies is transcendental and given in doubles, proved where [`Certificate`] says so.
#[derive(Debug, Clone, PartialEq)]
pub struct Throw {
    /// Corners of the hull, counter-clockwise.
    pub hull: Vec<[Q; 2]>,
    /// Edges on which the part rests stably.
    pub stable: Vec<usize>,
    /// Stable edges that look alike, each class sorted.
    pub classes: Vec<Vec<usize>>,
    /// Every edge of the hull.
    pub edges: Vec<GraspEdge>,
    /// What holds for all stable edges.
    pub grasp: CommonGrasp,
    /// λ = |g| / w², w the release speed (rad/s): all that the throw map depends on besides the geometry (length).
    pub lambda: f64,
    /// Largest distance of a corner from the center of mass (length).
    pub part_radius: f64,
    /// Whether no vertex can graze the arm and fly on: w² times the part radius is below |g|.
    pub concave: bool,
    /// Ranges of Proposition IV.4, and where the map breaks.
    pub reach: Reach,
    /// The approximated system of Theorem IV.6.
    pub hybrid: Hybrid,
    /// What orbits do in the long run.
    pub limit: LimitSets,
    /// A one-bit sensor for each limit set.
    pub sensors: Vec<Sensor>,
    /// What is proved.
    pub certificate: Certificate,
    /// Throws that were asked for.
    pub throws: Vec<ThrowQuery>,
    /// Carries that were asked for.
    pub carries: Vec<Carry>,
    /// Motion of the part over some throws of the first limit set, for playing; empty where it was not asked for.
    pub replay: Vec<Pose>,
    /// The arm settings tried, where a sweep was asked for.
    pub design: Option<Design>,
    /// Whether it was stopped before its end.
    pub is_stopped: bool,
}

impl Throw {
    /// `plan` if it is proved that all throws from the starts of the certificate come to one pattern, and a sensor reads it;
    /// `no-plan` if there are no such starts and it is proved that throws from Z do not come to one; `undecided` else.
    #[must_use]
    pub fn status(&self) -> &'static str {
        let proof = &self.certificate;
        let is_alone = |class: &Vec<usize>| class.len() == 1;
        let n_patterns = proof.components.iter().filter(|component| component.is_terminal).count();
        if self.is_stopped {
            "undecided"
        } else if proof.is_unique && self.window().is_some() {
            "plan"
        } else if proof.counterexample.as_ref().is_some_and(|example| example.leaves_domain)
            // patterns on edges that look alike may be one for who looks at the part
            || (proof.is_invariant && n_patterns > 1 && self.classes.iter().all(is_alone))
        {
            "no-plan"
        } else {
            "undecided"
        }
    }

    /// The recommended window of a sensor: the widest one that is proved.
    #[must_use]
    pub fn window(&self) -> Option<&SensorWindow> {
        self.sensors.iter().flat_map(|sensor| &sensor.windows).find(|window| window.proved.is_some())
    }
}

/// An edge of the hull as a place to be thrown from.
#[derive(Debug, Clone, PartialEq)]
pub struct GraspEdge {
    /// Its number.
    pub edge: usize,
    /// Whether the part rests stably on it: u_l < 0 < u_r.
    pub is_stable: bool,
    /// Squared length.
    pub length2: Q,
    /// u_l of its left vertex from the center of mass (length).
    pub u_left: Surd,
    /// u_r of its right vertex (length).
    pub u_right: Surd,
    /// Height d of the center of mass (length).
    pub d: Surd,
    /// κ: the part of the energy that an impact flat on this edge leaves; zero for a dead stop.
    pub energy_kept: Q,
    /// For stable edges.
    pub grasp: Option<EdgeGrasp>,
}

/// Where a throw from a stable edge is defined.
#[derive(Debug, Clone, PartialEq)]
pub struct EdgeGrasp {
    /// The larger of the right sides of (1) and (3) (length).
    pub r_geom: Surd,
    /// The least radius of a dynamic grasp: that, or |h + d| / μ if more (length).
    pub r_grasp: Surd,
    /// Radius above which all of the part is right of the pivot (length).
    pub r_clear: Surd,
    /// The least friction for which `r_grasp` is `r_geom`; `None` if none is enough.
    pub mu_edge: Option<Surd>,
}

/// One grasp for all stable edges.
#[derive(Debug, Clone, PartialEq)]
pub struct CommonGrasp {
    /// Largest `r_geom`, and its edge.
    pub r_common: (usize, Surd),
    /// Friction with which every edge is grasped from `r_common` on, and the edge that needs it; `None` if none does.
    pub mu_common: Option<(usize, SurdRatio)>,
    /// Friction for which no edge needs more than its own `r_geom`, and the edge that needs it; `None` if none does.
    pub mu_edgewise: Option<(usize, Surd)>,
}

/// A quotient of two numbers that may be of different fields.
#[derive(Debug, Clone, PartialEq)]
pub enum SurdRatio {
    /// Of one field.
    Number(Surd),
    /// Of two.
    Quotient(Surd, Surd),
}

/// What a throw from a radius does.
#[derive(Debug, Clone, PartialEq)]
pub struct ThrowQuery {
    /// Edge on the arm.
    pub edge: usize,
    /// Radius R (length).
    pub radius: Q,
    /// What happens, and what else happens at radii less than `within` away where the map breaks.
    pub fates: Vec<Fate>,
    /// Whether it is proved that the first of them happens at all radii less than `within` away.
    pub is_certain: bool,
    /// (length)
    pub within: f64,
}

/// How a throw ends.
#[derive(Debug, Clone, PartialEq)]
pub enum Fate {
    /// The part comes to rest on the arm.
    Caught(Caught),
    /// The edge is not stable: the part does not wait there to be thrown.
    UnstableEdge,
    /// R is below `r_grasp`: the part slips or rolls while it is carried.
    NoGrasp,
    /// Some of the part is left of the pivot.
    Overhang,
    /// The part meets the line of the arm where there is none.
    OffArm {
        /// The vertex.
        vertex: usize,
        /// Its x (length), negative.
        x: f64,
    },
    /// The part is caught upright on a vertex, or did not settle within the impacts allowed.
    Balanced {
        /// The vertex.
        vertex: usize,
    },
}

/// A catch.
#[derive(Debug, Clone, PartialEq)]
pub struct Caught {
    /// Edge on which the part comes to rest.
    pub edge: usize,
    /// Where (length).
    pub radius: f64,
    /// Edges that it was turned over, counter-clockwise, net.
    pub steps: i64,
    /// Time of flight (s).
    pub flight_time: f64,
    /// Turn in flight (rad).
    pub flight_rotation: f64,
    /// The vertex that meets the arm first.
    pub impact_vertex: usize,
    /// Where (length).
    pub impact_x: f64,
    /// Angular velocity after that (rad/s).
    pub omega_after: f64,
    /// d(radius)/dR.
    pub slope: f64,
    /// Whether it may be thrown again: the edge is stable, grasped there, and right of the pivot.
    pub in_domain: bool,
}

impl Caught {
    /// Whether the part is as it was: no net turn.
    #[must_use]
    pub fn is_jog(&self) -> bool {
        self.steps == 0
    }
}

/// Where the map is made of what.
#[derive(Debug, Clone, PartialEq)]
pub struct Reach {
    /// Radii up to here were looked at: 1.6 λ, about half a turn in flight, or 6 λ if vertices may meet the arm at once.
    pub scan_to: f64,
    /// The stable edges.
    pub edges: Vec<EdgeReach>,
    /// Whether the ranges `[r_low, r_max]` map into themselves, by the pieces.
    pub is_invariant: bool,
    /// Whether Proposition IV.4 holds as stated: jogs outward below `r_flip`, flips above, into the ranges.
    pub proposition: bool,
    /// Why not, and what else is worth knowing.
    pub problems: Vec<String>,
}

/// The radii of one stable edge.
#[derive(Debug, Clone, PartialEq)]
pub struct EdgeReach {
    /// The edge.
    pub edge: usize,
    /// Least radius of the domain: the larger of `r_grasp` and `r_clear`.
    pub r_low: f64,
    /// From here on throws are no jogs; `None` if no throw up to the end of the scan is a flip.
    pub r_flip: Option<f64>,
    /// No throw from the ranges lands beyond.
    pub r_max: f64,
    /// Least radius at which a throw from the ranges lands on this edge.
    pub lowest_image: Option<f64>,
    /// Pieces of the map by radius, proved single-branched up to their ends.
    pub pieces: Vec<Piece>,
}

/// Radii from which throws do alike.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Piece {
    /// From (length).
    pub from: f64,
    /// To (length).
    pub to: f64,
    /// Vertex of the first impact.
    pub impact_vertex: usize,
    /// Edge on which the part comes to rest, and net steps; `None` beside the arm.
    pub landing: Option<(usize, i64)>,
}

/// The approximated system: jogs are a continuous slide outward, flips happen at `r_flip`.
#[derive(Debug, Clone, PartialEq)]
pub struct Hybrid {
    /// For each stable edge on which the part slides.
    pub slides: Vec<Slide>,
    /// Its cycles, each by its edges of sliding.
    pub cycles: Vec<Vec<usize>>,
}

/// What follows a slide on an edge.
#[derive(Debug, Clone, PartialEq)]
pub struct Slide {
    /// The edge.
    pub edge: usize,
    /// Flips in a row from its `r_flip` on: edge, radius and steps of each landing.
    pub flips: Vec<(usize, f64, i64)>,
    /// Edge on which the part slides next; `None` if it is lost.
    pub next: Option<usize>,
}

/// What orbits do in the long run.
#[derive(Debug, Clone, PartialEq)]
pub struct LimitSets {
    /// The sets met, the one with most starts within the ranges of [`Reach`] first.
    pub sets: Vec<LimitSet>,
    /// Orbits that ended.
    pub ended: Vec<EndedOrbit>,
    /// Whether every start came to the same set.
    pub is_unique: bool,
    /// Whether every start within the ranges of [`Reach`] did.
    pub is_unique_in_reach: bool,
    /// Some orbits, for drawing: the states one after the other.
    pub orbits: Vec<Vec<(usize, f64)>>,
}

/// A recurrent pattern.
#[derive(Debug, Clone, PartialEq)]
pub struct LimitSet {
    /// Throws after which it repeats, where an attracting periodic orbit was found.
    pub period: Option<usize>,
    /// Mean growth of a small distance by a throw, its logarithm; positive where the set is chaotic.
    pub lyapunov: f64,
    /// Radii visited on each edge, from and to.
    pub bands: BTreeMap<usize, [f64; 2]>,
    /// Share of throws from each edge.
    pub share: BTreeMap<usize, f64>,
    /// Edges that follow each other.
    pub transitions: Vec<[usize; 2]>,
    /// Fewest and most jogs in a row on each edge.
    pub jogs: BTreeMap<usize, [usize; 2]>,
    /// Edge with the largest share.
    pub main_edge: usize,
    /// Mean throws from one arrival on the main edge to the next.
    pub throws_per_cycle: f64,
    /// Edges from one arrival on the main edge to the next, the most frequent order.
    pub pattern: Vec<usize>,
    /// Mean time from a throw to rest (s).
    pub seconds_per_throw: f64,
    /// Throws followed.
    pub throws: usize,
    /// Most throws until an orbit stayed within the bands.
    pub transient: usize,
    /// Starts that came here.
    pub starts: Vec<(usize, f64)>,
    /// States of one orbit in the set, some hundred throws.
    pub orbit: Vec<(usize, f64)>,
}

/// An orbit that left what the map is defined for.
#[derive(Debug, Clone, PartialEq)]
pub struct EndedOrbit {
    /// Start.
    pub start: (usize, f64),
    /// Throws before the last.
    pub after: usize,
    /// Where the last throw was made.
    pub at: (usize, f64),
    /// How it ended: a landing outside of the domain, one in it but too far out to be followed, or what is no landing.
    pub fate: Fate,
}

/// What a one-bit sensor can tell of a limit set.
#[derive(Debug, Clone, PartialEq)]
pub struct Sensor {
    /// Number of the limit set.
    pub set: usize,
    /// From and to of the footprints of each edge: what a part that rests there covers over the whole band.
    pub footprints: BTreeMap<usize, [f64; 2]>,
    /// Radii at which "covered" means one edge, or edges that look alike, the widest first.
    pub windows: Vec<SensorWindow>,
    /// Radii beyond which the center of mass lies for one edge only, if there are any.
    pub beyond: Option<SensorWindow>,
}

/// Radii for a sensor.
#[derive(Debug, Clone, PartialEq)]
pub struct SensorWindow {
    /// The edge that it tells, or several that look alike.
    pub edges: Vec<usize>,
    /// From and to (length).
    pub range: [f64; 2],
    /// The part of it in which "covered" means these edges for all that is recurrent, as the certificate proves.
    pub proved: Option<[f64; 2]>,
    /// Where in it to put the sensor (length).
    pub at: f64,
    /// Mean throws between detections in the limit set.
    pub throws_per_part: f64,
    /// Mean throws of a new part until it is detected, over the starts, once it had `settle_throws`.
    pub throws_from_start: f64,
    /// Throws after which "covered" means these edges: none where it does so all over Z, else those after which every start is
    /// in the set.
    pub settle_throws: usize,
}

/// What interval arithmetic proves.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Certificate {
    /// The set Z, from and to on each stable edge.
    pub z: BTreeMap<usize, [f64; 2]>,
    /// Whether f maps Z into itself.
    pub is_invariant: bool,
    /// A part of Z that provably leaves it or the domain.
    pub counterexample: Option<CounterExample>,
    /// Radii on each edge that f maps into each other: all of Z if it is invariant, else what was found of Z or of all radii.
    pub starts: BTreeMap<usize, Vec<[f64; 2]>>,
    /// Recurrent components of the graph of their cells.
    pub components: Vec<Component>,
    /// Whether there is one, so that all throws from `starts` come to one pattern.
    pub is_unique: bool,
    /// Radius s above which a part in the component, settled, rests on this edge only.
    pub beyond: Option<(usize, f64)>,
    /// Cells of the last graph.
    pub cells: usize,
    /// Width of the narrowest cell (length).
    pub width: f64,
    /// Images of cells computed in all.
    pub images: usize,
    /// Why it is not complete, if it is not.
    pub limit: Option<ProofLimit>,
}

/// Why a proof is not complete.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ProofLimit {
    /// It was stopped.
    Stopped,
    /// Cells as narrow as doubles allow, or as many as allowed, prove no more.
    Resolution,
}

/// A recurrent component.
#[derive(Debug, Clone, PartialEq)]
pub struct Component {
    /// Cells in it.
    pub cells: usize,
    /// Whether it is proved that no throw leads out of it.
    pub is_terminal: bool,
    /// Outer bands: the radii of its cells on each edge.
    pub bands: BTreeMap<usize, Vec<[f64; 2]>>,
}

/// A cell whose image is outside.
#[derive(Debug, Clone, PartialEq)]
pub struct CounterExample {
    /// Edge of the cell.
    pub edge: usize,
    /// Its radii.
    pub radii: [f64; 2],
    /// Edge where it lands, and the radii; `None` where it does not land on the arm.
    pub landing: Option<(usize, [f64; 2])>,
    /// Whether there is no next throw from there.
    pub leaves_domain: bool,
}

/// Accelerations of the arm that keep the part from moving on it.
#[derive(Debug, Clone, PartialEq)]
pub struct Carry {
    /// Edge on the arm.
    pub edge: usize,
    /// Radius R (length).
    pub radius: Q,
    /// Angle of the arm (degrees).
    pub angle_deg: Q,
    /// Angular velocity of the arm (rad/s).
    pub rate: Q,
    /// Friction assumed.
    pub friction: Q,
    /// Angular accelerations (rad/s²) from and to, each end between two rationals; `None` if none keeps it. An end that is
    /// absent is infinite.
    pub accelerations: Option<[Option<[Q; 2]>; 2]>,
}

/// Where the part is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pose {
    /// Time since the first throw (s).
    pub time: f64,
    /// Center of mass (length).
    pub x: f64,
    /// Center of mass (length).
    pub y: f64,
    /// Turn of the outline as given, counter-clockwise (rad).
    pub angle: f64,
    /// Number of the throw.
    pub throw: usize,
}

/// Settings of the arm that were tried.
#[derive(Debug, Clone, PartialEq)]
pub struct Design {
    /// Offsets (length), ascending.
    pub offsets: Vec<f64>,
    /// Release speeds (degrees/s), ascending.
    pub releases: Vec<f64>,
    /// A setting each, by offset, then by release speed.
    pub settings: Vec<Setting>,
    /// Relative margin that the recommended setting keeps.
    pub margin: f64,
    /// The recommended one.
    pub best: Option<BestSetting>,
    /// Why none is.
    pub why_none: Option<String>,
}

/// The setting with most parts a second that keeps the margin.
#[derive(Debug, Clone, PartialEq)]
pub struct BestSetting {
    /// Its place in `settings`.
    pub place: usize,
    /// Radii at which the sensor tells the same edge at all settings within the margin (length).
    pub window: [f64; 2],
    /// Whether a certificate at this setting proves it to be a plan, and that the sensor tells the edge at all these radii there.
    pub is_proved: bool,
}

/// What becomes of the part at one setting.
#[derive(Debug, Clone, PartialEq)]
pub struct Setting {
    /// Type of its limit sets.
    pub kind: SettingKind,
    /// Delivered parts a throw with the sensor window that delivers most; zero without one.
    pub parts_per_throw: f64,
    /// Mean time from a throw to rest (s).
    pub seconds_per_throw: f64,
    /// Edge that the sensor tells.
    pub edge: Option<usize>,
    /// That window (length).
    pub window: Option<[f64; 2]>,
    /// Least ratio of a radius in the limit set to its least radius of a grasp.
    pub grasp_margin: f64,
    /// Least friction with which the limit set is grasped.
    pub friction: f64,
}

impl Setting {
    /// Delivered parts a second.
    #[must_use]
    pub fn rate(&self) -> f64 {
        if self.parts_per_throw > 0.0 { self.parts_per_throw / self.seconds_per_throw } else { 0.0 }
    }
}

impl SettingKind {
    /// Its name in results.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Feeder => "feeder",
            Self::Blind => "blind",
            Self::Several => "several",
            Self::Lost => "lost",
            Self::Open => "open",
        }
    }
}

/// Type of the limit sets of a setting.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SettingKind {
    /// One, which a sensor reads.
    Feeder,
    /// One that no sensor reads.
    Blind,
    /// Several.
    Several,
    /// Some or all orbits end.
    Lost,
    /// Not tried.
    Open,
}
