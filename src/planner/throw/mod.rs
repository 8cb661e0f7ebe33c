//! Throws from an arm that bring a part into one motion pattern, and the sensor that reads it.

mod carry;
mod design;
mod graph;
mod grasp;
mod hybrid;
mod limit;
mod orbit;
mod pieces;
mod proof;
mod reach;
mod replay;
mod safe;
mod sensor;
mod system;

use crate::answer::{Certificate, Fate, Sensor, Throw, ThrowQuery};
use crate::exact::{FloatInterval, Q, to_f64};
use crate::geometry::{Polygon, difference, dot, symmetry_shift};
use crate::mechanics::throwing::{Branch, BranchEnd, Elsewhere, RestingEdge, Settling};
use crate::model::{Part, Shape, Thrower};
use num_traits::Signed as _;
use system::System;

/// What is asked of [`throw`].
#[derive(Debug, Clone, PartialEq)]
pub struct ThrowQuestion {
    /// Throws to tell: edge and radius.
    pub throws: Vec<(usize, Q)>,
    /// Carries to tell.
    pub carries: Vec<CarryQuestion>,
    /// When a part that rolls is at rest.
    pub settling: Settling,
    /// Starts of orbits on each stable edge.
    pub starts: usize,
    /// Cells over a part radius at which a proof tells bands; without it nothing is proved.
    pub resolution: Option<f64>,
    /// Settings of the arm to try, if any.
    pub sweep: Option<Sweep>,
    /// Whether the motion in time is wanted, for playing.
    pub replay: bool,
}

impl Default for ThrowQuestion {
    fn default() -> Self {
        Self {
            throws: Vec::new(),
            carries: Vec::new(),
            settling: Settling::Full,
            starts: 6,
            resolution: Some(proof::RESOLUTION),
            sweep: None,
            replay: false,
        }
    }
}

/// A state of the arm that carries a part.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CarryQuestion {
    /// Edge on the arm.
    pub edge: usize,
    /// Radius R (length).
    pub radius: Q,
    /// Angle of the arm (degrees).
    pub angle_deg: Q,
    /// Angular velocity (rad/s).
    pub rate: Q,
}

/// Settings of the arm to try.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Sweep {
    /// Offsets from and to (length).
    pub offset: [Q; 2],
    /// Release speeds from and to (degrees/s), positive.
    pub release: [Q; 2],
    /// Settings of each of the two where its ends differ.
    pub grid: usize,
    /// Relative margin that a recommended setting is to keep.
    pub margin: Q,
}

/// Where the planner of throws is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ThrowProgress {
    /// What it does.
    pub stage: ThrowStage,
    /// How much of it is done.
    pub done: usize,
    /// How much there is at most.
    pub of: usize,
}

/// What the planner of throws does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ThrowStage {
    /// It follows orbits.
    Orbits,
    /// It refines cells of a proof.
    Proof,
    /// It tries settings of the arm.
    Sweep,
}

/// Why throws cannot be planned for a part.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ThrowError {
    /// A disc rolls.
    #[error("a disc has no edges to rest on")]
    Disc,
    /// An edge that is asked about is not there.
    #[error("the hull has edges 0 to {last}, not {edge}")]
    NoSuchEdge {
        /// The edge.
        edge: usize,
        /// The last one.
        last: usize,
    },
    /// The center of mass is not known well enough to say where the part rests.
    #[error(
        "whether the part rests on edge {edge} of its hull depends on where in its tolerance the center of mass is"
    )]
    UncertainRest {
        /// The edge.
        edge: usize,
    },
    /// A carry is asked about, and how the part slips is not known.
    #[error("a carry needs the friction between part and arm; write \"friction\": 0.4 in the throw section")]
    NoFriction,
    /// A throw is asked about from so far out that doubles do not tell how the part lands.
    #[error(
        "a throw from edge {edge} is asked about more than a million times as far out as the arm throws the part; write a \
         smaller radius"
    )]
    TooFar {
        /// The edge.
        edge: usize,
    },
    /// The numbers of the case are beyond those of doubles.
    #[error("the part's size and the arm's speed and gravity are too far apart for throws to be computed in doubles")]
    OutOfRange,
}

/// Half width of the radii about a throw that is asked for, in part radii: breaks of the map so near are told.
const DOUBT: f64 = 1e-9;

/// The throw map of a part on an arm: where it is defined, its pieces, what orbits do in the long run, what of it is proved,
/// and the sensor that reads it.
///
/// Grasps are exact; flights are computed in doubles, and enclosed by outward rounding where something is proved.
///
/// # Source
/// Lynch, Northrop & Pan (2002), Stable limit sets in a dynamic parts feeder.
///
/// # Errors
/// [`ThrowError`] if the part or the question is not one that throws can be planned for.
pub fn throw(
    part: &Part,
    thrower: &Thrower,
    question: &ThrowQuestion,
    watch: &mut dyn FnMut(ThrowProgress) -> bool,
) -> Result<Throw, ThrowError> {
    let Shape::Polygon(outline) = &part.shape else { return Err(ThrowError::Disc) };
    let hull: Vec<[Q; 2]> = outline.hull().into_iter().map(|k| outline.vertices()[k].clone()).collect();
    let asked = question.throws.iter().map(|(edge, _)| *edge).chain(question.carries.iter().map(|carry| carry.edge));
    if let Some(edge) = asked.into_iter().find(|edge| *edge >= hull.len()) {
        return Err(ThrowError::NoSuchEdge { edge, last: hull.len() - 1 });
    }
    check_rest(part, &hull)?;
    let rho2 = part.gyration2();
    let resting = RestingEdge::all(&hull, &part.center_of_mass, &rho2);
    let carries = carry::carries(&resting, &rho2, thrower, &question.carries)?;
    let (system, edges) = System::new(&hull, &part.center_of_mass, &rho2, thrower, question.settling);
    if !system.is_in_range() {
        return Err(ThrowError::OutOfRange);
    }
    let is_far = |(_, radius): &&(usize, Q)| to_f64(radius) > 1e6 * system.lambda();
    if let Some((edge, _)) = question.throws.iter().find(is_far) {
        return Err(ThrowError::TooFar { edge: *edge });
    }
    let grasp = grasp::common(&edges, &thrower.offset).ok_or(ThrowError::OutOfRange)?;
    let mut is_stopped = false;
    let mut watch = |stage: ThrowStage, done: usize, of: usize| {
        is_stopped = is_stopped || !watch(ThrowProgress { stage, done, of });
        !is_stopped
    };
    let reach = reach::reach(&system);
    let hybrid = hybrid::hybrid(&system, &reach.edges);
    let orbits = &mut |done, of| watch(ThrowStage::Orbits, done, of);
    let limit = limit::limit_sets(&system, &reach, question.starts, limit::LONG, orbits);
    let certificate = match question.resolution {
        Some(resolution) => {
            proof::certify(&system, &reach, resolution, &mut |done, of| watch(ThrowStage::Proof, done, of))
        }
        None => Certificate::default(),
    };
    let classes = classes(outline, &part.center_of_mass, &system.stable);
    let starts = if certificate.is_unique { certificate.starts.clone() } else { reach::ranges(&reach) };
    let sensors: Vec<Sensor> = (limit.sets.iter().enumerate())
        .map(|(number, set)| sensor::sensor(number, set, &system, &classes, &starts, &certificate))
        .collect();
    let replay = match limit.sets.first() {
        Some(set) if question.replay => replay::replay(&system, set),
        _ => Vec::new(),
    };
    let tried = design::Thrown {
        hull: &hull,
        center_of_mass: &part.center_of_mass,
        tolerance: &part.center_of_mass_tolerance,
        rho2: &rho2,
        classes: &classes,
        thrower,
        settling: question.settling,
    };
    let settings = &mut |done, of| watch(ThrowStage::Sweep, done, of);
    let design = question.sweep.as_ref().map(|sweep| design::design(&tried, sweep, settings));
    Ok(Throw {
        hull,
        stable: system.stable.clone(),
        classes,
        edges,
        grasp,
        lambda: system.lambda(),
        part_radius: system.part_radius,
        concave: system.near().is_concave(),
        reach,
        hybrid,
        limit,
        sensors,
        certificate,
        throws: question.throws.iter().map(|(edge, radius)| query(&system, *edge, radius)).collect(),
        carries,
        replay,
        design,
        is_stopped,
    })
}

/// Whether the part rests on the same edges wherever in its tolerance the center of mass is.
fn check_rest(part: &Part, hull: &[[Q; 2]]) -> Result<(), ThrowError> {
    let tolerance = &part.center_of_mass_tolerance;
    let [x, y] = part.center_of_mass.each_ref().map(|center| [center - tolerance, center + tolerance]);
    let corners = [0, 1, 2, 3].map(|corner: usize| [x[corner % 2].clone(), y[corner / 2].clone()]);
    for (edge, start) in hull.iter().enumerate() {
        let end = &hull[(edge + 1) % hull.len()];
        let along = difference(start, end);
        let is_over = |from: &[Q; 2], to: &[Q; 2]| dot(&difference(from, to), &along).is_positive();
        // the strip over the edge meets a box whose corners are on both sides of it, too
        let sides = corners.each_ref().map(|corner| [is_over(start, corner), is_over(corner, end)]);
        if sides.iter().any(|side| *side != sides[0]) {
            return Err(ThrowError::UncertainRest { edge });
        }
    }
    Ok(())
}

/// Stable edges that a turn about the center of mass takes to each other.
fn classes(outline: &Polygon, center_of_mass: &[Q; 2], stable: &[usize]) -> Vec<Vec<usize>> {
    let shift = symmetry_shift(outline, center_of_mass);
    let mut classes: Vec<Vec<usize>> = Vec::new();
    for edge in stable {
        match classes.iter_mut().find(|class| class[0] % shift == edge % shift) {
            Some(class) => class.push(*edge),
            None => classes.push(vec![*edge]),
        }
    }
    classes
}

/// A throw that was asked for, with what a break of the map nearby may make of it.
fn query(system: &System, edge: usize, radius: &Q) -> ThrowQuery {
    /// Radii on each side at which a break may show another branch.
    const TRIED: i32 = 4;
    let [low, high] = FloatInterval::of_rational(radius).ends();
    let (within, middle) = (DOUBT * system.part_radius, 0.5 * (low + high));
    let mut fates = vec![system.fate((edge, middle))];
    let least = system.low(edge);
    let mut is_certain = true;
    if middle >= least {
        let radii = FloatInterval::from_ends((low - within).max(least), high + within);
        let branches = system.branches(edge, radii);
        is_certain =
            matches!(&branches[..], [Branch { end: BranchEnd::Rest { .. } | BranchEnd::Other(Elsewhere::OffArm), .. }]);
        if !is_certain {
            let tried = (-TRIED..=TRIED).map(|k| middle + within * f64::from(k) / f64::from(TRIED));
            for other in tried.filter(|radius| *radius >= least).map(|radius| system.fate((edge, radius))) {
                if fates.iter().all(|known| !is_alike(known, &other)) {
                    fates.push(other);
                }
            }
        }
    }
    ThrowQuery { edge, radius: radius.clone(), fates, is_certain, within }
}

/// Whether two throws end in the same way, at radii that may differ.
fn is_alike(a: &Fate, b: &Fate) -> bool {
    match (a, b) {
        (Fate::Caught(a), Fate::Caught(b)) => (a.edge, a.steps, a.impact_vertex) == (b.edge, b.steps, b.impact_vertex),
        _ => std::mem::discriminant(a) == std::mem::discriminant(b),
    }
}
