//! What a one-bit sensor in the arm can tell: it is covered, or not.

use super::system::{State, System};
use crate::answer::{Certificate, LimitSet, Sensor, SensorWindow};
use crate::exact::FloatInterval;
use std::collections::BTreeMap;

/// Throws after the transient until a part is told, at most.
const MOST_WAITED: usize = 300;

/// Finds all radii at which "covered" means one edge of the limit set with this number, or edges that look alike, and which of
/// them are proved; `z` is what parts start from.
pub(super) fn sensor(
    number: usize,
    set: &LimitSet,
    system: &System,
    classes: &[Vec<usize>],
    z: &BTreeMap<usize, Vec<[f64; 2]>>,
    certificate: &Certificate,
) -> Sensor {
    let ends = |edge: usize| system.near().ends(edge);
    let is_in_z =
        |at: &State| z.get(&at.0).is_some_and(|ranges| ranges.iter().any(|[from, to]| *from <= at.1 && at.1 <= *to));
    let is_inside = set.orbit.iter().all(is_in_z);
    let component = certificate.components.first().filter(|_| is_inside && certificate.is_unique);
    let from: Vec<State> = set.starts.iter().copied().filter(|at| !is_inside || is_in_z(at)).collect();
    let orbits: Vec<Vec<State>> = from.iter().map(|start| system.orbit(*start, set.transient + MOST_WAITED)).collect();
    let visited: Vec<State> =
        set.orbit.first().map_or_else(Vec::new, |start| system.orbit(*start, set.throws / set.starts.len()));
    let starts = z.iter().flat_map(|(edge, ranges)| ranges.iter().map(|range| (*edge, *range)));
    let footprint = |(edge, [low, high]): (&usize, &[f64; 2])| (*edge, [low + ends(*edge)[0], high + ends(*edge)[1]]);
    let footprints: BTreeMap<usize, [f64; 2]> = set.bands.iter().map(footprint).collect();
    let covers = |at: &State, sensor: f64| {
        let [left, right] = ends(at.0);
        at.1 + left <= sensor && sensor <= at.1 + right
    };
    let window = |edges: Vec<usize>, range, proved, settle: usize, is_seen: &dyn Fn(&State, f64) -> bool, at: f64| {
        let seen = visited.iter().filter(|state| is_seen(state, at)).count();
        let from_start = |orbit: &Vec<State>| {
            orbit.iter().skip(settle).position(|state| is_seen(state, at)).map(|place| place + settle)
        };
        let first: Vec<usize> = orbits.iter().filter_map(from_start).collect();
        SensorWindow {
            edges,
            range,
            proved,
            at,
            throws_per_part: visited.len() as f64 / seen as f64,
            throws_from_start: first.iter().sum::<usize>() as f64 / first.len() as f64,
            settle_throws: settle,
        }
    };
    let mut windows = Vec::new();
    for class in classes {
        for [low, high] in alone(&footprints, class) {
            let edges = class.iter().copied().filter(|edge| footprints.contains_key(edge)).collect();
            let recurrent = component.map(|component| {
                component.bands.iter().flat_map(|(edge, bands)| bands.iter().map(|band| (*edge, *band)))
            });
            let proved = recurrent.and_then(|recurrent| free(system, recurrent, class, [low, high]));
            // where it is so from every start on, nobody has to wait for the transient
            let place = proved.unwrap_or([low, high]);
            let at_once = free(system, starts.clone(), class, place).filter(|_| is_inside);
            let settle = if at_once.is_some() { 0 } else { set.transient };
            let at = most_often(&visited, at_once.unwrap_or(place), &covers);
            windows.push(window(edges, [low, high], proved, settle, &covers, at));
        }
    }
    windows.sort_by(|a, b| (b.range[1] - b.range[0]).total_cmp(&(a.range[1] - a.range[0])));
    let beyond = classes.iter().find_map(|class| {
        let top = |is_in: bool| {
            let edges = set.bands.iter().filter(|(edge, _)| class.contains(edge) == is_in);
            edges.map(|(_, band)| band[1]).fold(f64::NEG_INFINITY, f64::max)
        };
        let (others, own) =
            (top(false).max(set.bands.values().map(|band| band[0]).fold(f64::INFINITY, f64::min)), top(true));
        let edges = class.iter().copied().filter(|edge| set.bands.contains_key(edge)).collect();
        let is_seen = |state: &State, at: f64| state.1 > at;
        let proved = || {
            let (edge, radius) = certificate.beyond.filter(|_| component.is_some())?;
            (class.contains(&edge) && radius < own).then_some([radius.max(others), own])
        };
        (own > others).then(|| {
            let proved = proved();
            window(edges, [others, own], proved, set.transient, &is_seen, proved.map_or(others, |[from, _]| from))
        })
    });
    Sensor { set: number, footprints, windows, beyond }
}

/// The widest part of a window that no edge but those of the class covers at any of these radii.
fn free(
    system: &System,
    radii: impl Iterator<Item = (usize, [f64; 2])>,
    class: &[usize],
    window: [f64; 2],
) -> Option<[f64; 2]> {
    let mut free = vec![window];
    for (edge, [low, high]) in radii.filter(|(edge, _)| !class.contains(edge)) {
        let [left, right] = system.enclosed_ends(edge);
        let from = (FloatInterval::of_double(low) + left).ends()[0];
        let to = (FloatInterval::of_double(high) + right).ends()[1];
        let apart = |[low, high]: [f64; 2]| [[low, high.min(from.next_down())], [low.max(to.next_up()), high]];
        free = free.into_iter().flat_map(apart).filter(|[low, high]| low < high).collect();
    }
    free.into_iter().max_by(|a, b| (a[1] - a[0]).total_cmp(&(b[1] - b[0])))
}

/// Where in a window a part is seen most often, as near its middle as may be.
fn most_often(visited: &[State], [low, high]: [f64; 2], covers: &dyn Fn(&State, f64) -> bool) -> f64 {
    const PLACES: usize = 64;
    let middle = 0.5 * (low + high);
    let place = |k: usize| low + (high - low) * (k as f64 + 0.5) / PLACES as f64;
    let seen = |at: f64| visited.iter().filter(|state| covers(state, at)).count();
    // a tenth of the window stays free on both sides
    let places = (0..PLACES).map(place).filter(|at| (at - middle).abs() <= 0.4 * (high - low));
    places
        .max_by(|a, b| seen(*a).cmp(&seen(*b)).then((b - middle).abs().total_cmp(&(a - middle).abs())))
        .unwrap_or(middle)
}

/// The parts of the line that footprints of this class cover, and those of no other.
fn alone(footprints: &BTreeMap<usize, [f64; 2]>, class: &[usize]) -> Vec<[f64; 2]> {
    let mut ends: Vec<f64> = footprints.values().flatten().copied().collect();
    ends.sort_by(f64::total_cmp);
    ends.dedup();
    let covered_by = |middle: f64, is_in: bool| {
        footprints.iter().any(|(edge, [low, high])| class.contains(edge) == is_in && *low < middle && middle < *high)
    };
    let mut windows: Vec<[f64; 2]> = Vec::new();
    for pair in ends.windows(2) {
        let middle = 0.5 * (pair[0] + pair[1]);
        if covered_by(middle, true) && !covered_by(middle, false) {
            match windows.last_mut() {
                Some(last) if last[1] == pair[0] => last[1] = pair[1],
                _ => windows.push([pair[0], pair[1]]),
            }
        }
    }
    windows
}
