//! The long run of a throw: orbits followed from more and more starts, and proofs of finer and finer cells.

use super::measure::{Curve, Measure, Outcome};
use crate::answer::{ChartFamily, Throw};
use crate::exact::ratio;
use crate::geometry::Polygon;
use crate::model::{LengthUnit, Part, Shape, Thrower};
use crate::planner::{ThrowQuestion, throw};
use std::collections::BTreeMap;

/// Starts of orbits on each edge.
const STARTS: [usize; 4] = [1, 4, 16, 64];

/// Cells over a part radius.
const QUICK: [f64; 3] = [64.0, 256.0, 1024.0];
const WHOLE: [f64; 5] = [64.0, 256.0, 1024.0, 4096.0, 16384.0];

/// Cells over a part radius of the proof that all others are compared with.
const FINEST: [f64; 2] = [4096.0, 65536.0];

/// Least and largest radius on each edge.
type Bands = BTreeMap<usize, [f64; 2]>;

pub(super) fn measure(measure: &mut Measure) {
    if !measure.wants_family(ChartFamily::Throw) {
        return;
    }
    let Some((part, thrower)) = triangle() else { return };
    let answer = |starts: usize, resolution: Option<f64>| {
        throw(&part, &thrower, &ThrowQuestion { starts, resolution, ..ThrowQuestion::default() }, &mut |_| true).ok()
    };
    let Some(finest) = answer(0, Some(measure.pick(FINEST[0], FINEST[1]))) else { return };
    let (size, wanted) = (finest.part_radius, proved(&finest));
    let outcome = |found: Option<Bands>| {
        let error = found.filter(|found| !found.is_empty()).map(|found| apart(&found, &wanted) / size);
        Outcome { error, failed: u64::from(error.is_none()), of: 1 }
    };
    let curve = |method| Curve { family: ChartFamily::Throw, work: "triangle with sides 6, 8 and 10", method };
    for starts in STARTS {
        measure.point(curve("orbits of points"), &format!("{starts} starts an edge"), 1, |_| {
            outcome(answer(starts, None).map(|answer| visited(&answer)))
        });
    }
    for cells in measure.pick(QUICK.to_vec(), WHOLE.to_vec()) {
        measure.point(curve("proof by intervals"), &format!("{cells} cells a radius"), 1, |_| {
            outcome(answer(0, Some(cells)).map(|answer| proved(&answer)))
        });
    }
}

/// The right triangle of `cases/throw_triangle.json`, in cm.
fn triangle() -> Option<(Part, Thrower)> {
    let corners = [[6, 0], [6, 8], [0, 0]].map(|corner| corner.map(|x| ratio(x, 1)));
    let outline = Polygon::new(corners.to_vec()).ok()?;
    let center_of_mass = [ratio(4, 1), ratio(8, 3)];
    let part = Part {
        unit: LengthUnit::Centimetre,
        center_of_mass_tolerance: ratio(0, 1),
        mass: ratio(1, 1),
        inertia: ratio(50, 9),
        shape: Shape::Polygon(outline),
        center_of_mass,
    };
    let thrower =
        Thrower { offset: ratio(-1, 2), release_deg_per_s: ratio(320, 1), gravity: ratio(966, 1), friction: None };
    Some((part, thrower))
}

/// The radii that orbits visit.
fn visited(answer: &Throw) -> Bands {
    let mut bands = Bands::new();
    for set in &answer.limit.sets {
        set.bands.iter().for_each(|(edge, band)| widen(&mut bands, *edge, *band));
    }
    bands
}

/// The radii that a proof leaves.
fn proved(answer: &Throw) -> Bands {
    let mut bands = Bands::new();
    for component in &answer.certificate.components {
        for (edge, all) in &component.bands {
            all.iter().for_each(|band| widen(&mut bands, *edge, *band));
        }
    }
    bands
}

fn widen(bands: &mut Bands, edge: usize, [low, high]: [f64; 2]) {
    let band = bands.entry(edge).or_insert([low, high]);
    *band = [band[0].min(low), band[1].max(high)];
}

/// The largest distance between ends of bands; a band that the other does not have counts with its width.
fn apart(found: &Bands, wanted: &Bands) -> f64 {
    let edges = found.keys().chain(wanted.keys());
    let of = |edge: &usize| match (found.get(edge), wanted.get(edge)) {
        (Some(a), Some(b)) => (a[0] - b[0]).abs().max((a[1] - b[1]).abs()),
        (Some(one), None) | (None, Some(one)) => one[1] - one[0],
        (None, None) => 0.0,
    };
    edges.map(of).fold(0.0, f64::max)
}
