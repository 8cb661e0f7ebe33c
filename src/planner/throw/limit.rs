//! Limit sets: what orbits from a grid of starts have in common after their transients.

use super::orbit::Orbit;
use super::system::{State, System};
use crate::answer::{LimitSet, LimitSets, Reach};
use crate::mechanics::throwing::Catch;
use std::collections::{BTreeMap, BTreeSet};

/// How long orbits are followed.
#[derive(Debug, Clone, Copy)]
pub(super) struct Length {
    /// Throws before an orbit is taken to have settled.
    pub(super) transient: usize,
    /// Throws after that.
    pub(super) followed: usize,
    /// Throws that are timed.
    pub(super) timed: usize,
}

/// As long as bands need to be known to some thousandths of the part radius.
pub(super) const LONG: Length = Length { transient: 400, followed: 5_000, timed: DRAWN };

/// Longest period looked for.
const LONGEST_PERIOD: usize = 256;
/// Bins over a part radius, by which orbits are compared.
const BINS: f64 = 32.0;
/// Share of the smaller orbit's bins that two orbits of one set have in common.
const ALIKE: f64 = 0.5;
/// Throws kept for drawing.
const DRAWN: usize = 400;
/// Throws of each start kept for drawing.
const DRAWN_START: usize = 60;

/// Follows orbits from `starts` radii on each stable edge within the ranges, and from two beyond.
pub(super) fn limit_sets(
    system: &System,
    reach: &Reach,
    starts: usize,
    length: Length,
    watch: &mut dyn FnMut(usize, usize) -> bool,
) -> LimitSets {
    let count = reach.edges.len().saturating_mul(starts.saturating_add(2));
    let (mut sets, mut ended, mut orbits): (Vec<Found>, Vec<_>, Vec<_>) = (Vec::new(), Vec::new(), Vec::new());
    let mut is_unique_in_reach = true;
    let mut first_in_reach = None;
    for (number, (start, is_in_reach)) in grid(system, reach, starts).enumerate() {
        if !watch(number, count) {
            break;
        }
        let place = match Orbit::follow(system, start, length.transient + length.followed) {
            Ok(orbit) => {
                orbits.push(orbit.throws.iter().take(DRAWN_START).map(|(at, _)| *at).collect());
                let place = sort(system, &mut sets, orbit, length);
                sets[place].from_reach += usize::from(is_in_reach);
                Some(place)
            }
            Err(end) => {
                ended.push(end);
                None
            }
        };
        if is_in_reach {
            is_unique_in_reach &= place.is_some() && *first_in_reach.get_or_insert(place) == place;
        }
    }
    let is_unique = sets.len() == 1 && ended.is_empty();
    is_unique_in_reach &= first_in_reach.is_some();
    sets.sort_by_key(|found| std::cmp::Reverse((found.from_reach, found.orbits.len())));
    let sets = sets.iter().map(|found| found.describe(system, length)).collect();
    LimitSets { sets, ended, is_unique, is_unique_in_reach, orbits }
}

/// Starts, and whether they are within the ranges.
fn grid(system: &System, reach: &Reach, count: usize) -> impl Iterator<Item = (State, bool)> {
    let scan = system.scan_to();
    let followed = reach.edges.iter().filter(|edge| edge.r_low <= system.far());
    followed.flat_map(move |edge| {
        let low = edge.r_low;
        let most = edge.r_max.max(low);
        // neither on the ends, one of which is a fixed point, nor at round places
        let place = move |k: usize| low + (most - low) * (k as f64 + 0.37) / count as f64;
        let within = (0..count).map(move |k| ((edge.edge, place(k)), true));
        let beyond = [scan, 2.0 * scan].into_iter().filter(move |far| *far > most);
        within.chain(beyond.map(|far| ((edge.edge, far), false)))
    })
}

/// Orbits that were found alike.
struct Found {
    orbits: Vec<Orbit>,
    bins: BTreeSet<(usize, i64)>,
    /// How many of them start within the ranges.
    from_reach: usize,
}

/// Puts an orbit to those that are alike; the place of their set.
fn sort(system: &System, sets: &mut Vec<Found>, orbit: Orbit, length: Length) -> usize {
    let bin = |at: &State| (at.0, (at.1 / system.part_radius * BINS).floor() as i64);
    let bins: BTreeSet<(usize, i64)> = orbit.throws[length.transient..].iter().map(|(at, _)| bin(at)).collect();
    let is_alike = |found: &Found| {
        let common = found.bins.intersection(&bins).count() as f64;
        common >= ALIKE * found.bins.len().min(bins.len()) as f64
    };
    if let Some(place) = sets.iter().position(is_alike) {
        sets[place].orbits.push(orbit);
        sets[place].bins.extend(bins);
        return place;
    }
    sets.push(Found { orbits: vec![orbit], bins, from_reach: 0 });
    sets.len() - 1
}

impl Found {
    fn describe(&self, system: &System, length: Length) -> LimitSet {
        let settled = |orbit: &Orbit| orbit.throws[length.transient..].to_vec();
        let all: Vec<(State, Catch)> = self.orbits.iter().flat_map(settled).collect();
        let bands = bands(&all);
        let count = all.len() as f64;
        let mut share: BTreeMap<usize, f64> = BTreeMap::new();
        all.iter().for_each(|((edge, _), _)| *share.entry(*edge).or_default() += 1.0 / count);
        let main_edge = share.iter().max_by(|a, b| a.1.total_cmp(b.1)).map_or(0, |(edge, _)| *edge);
        let transitions: BTreeSet<[usize; 2]> = all.iter().map(|((edge, _), catch)| [*edge, catch.edge]).collect();
        let arrivals: Vec<Vec<usize>> =
            self.orbits.iter().map(|orbit| arrivals(&orbit.throws[length.transient..], main_edge)).collect();
        let cycles: usize = arrivals.iter().map(|places| places.len().saturating_sub(1)).sum();
        let throws: usize = arrivals.iter().filter_map(|places| Some(places.last()? - places.first()?)).sum();
        let first = &self.orbits[0].throws[length.transient..];
        LimitSet {
            period: period(first, system.part_radius),
            lyapunov: all.iter().map(|(_, catch)| libm::log(catch.slope.abs())).sum::<f64>() / count,
            share,
            transitions: transitions.into_iter().collect(),
            jogs: self.jogs(length),
            main_edge,
            throws_per_cycle: if cycles > 0 { throws as f64 / cycles as f64 } else { f64::INFINITY },
            pattern: pattern(first, &arrivals[0]),
            seconds_per_throw: system.mean_seconds(first.iter().map(|(at, _)| *at).take(length.timed)),
            throws: all.len(),
            transient: self.orbits.iter().map(|orbit| transient(orbit, &bands, system.part_radius)).max().unwrap_or(0),
            starts: self.orbits.iter().map(|orbit| orbit.start).collect(),
            orbit: first.iter().map(|(at, _)| *at).take(DRAWN).collect(),
            bands,
        }
    }

    /// Fewest and most jogs in a row on each edge, between flips.
    fn jogs(&self, length: Length) -> BTreeMap<usize, [usize; 2]> {
        let mut jogs: BTreeMap<usize, [usize; 2]> = BTreeMap::new();
        for orbit in &self.orbits {
            let mut row = None;
            for (at, catch) in &orbit.throws[length.transient..] {
                if catch.steps == 0 {
                    row = row.map(|row| row + 1);
                } else {
                    // the first row was not seen from its beginning
                    if let Some(row) = row {
                        let [least, most] = jogs.entry(at.0).or_insert([row, row]);
                        (*least, *most) = ((*least).min(row), (*most).max(row));
                    }
                    row = Some(0_usize);
                }
            }
        }
        jogs
    }
}

/// Radii visited on each edge.
fn bands(throws: &[(State, Catch)]) -> BTreeMap<usize, [f64; 2]> {
    let mut bands: BTreeMap<usize, [f64; 2]> = BTreeMap::new();
    for ((edge, radius), _) in throws {
        let [low, high] = bands.entry(*edge).or_insert([*radius, *radius]);
        (*low, *high) = (low.min(*radius), high.max(*radius));
    }
    bands
}

/// Places in an orbit that a flip onto the edge leads to.
fn arrivals(throws: &[(State, Catch)], edge: usize) -> Vec<usize> {
    let is_arrival = |(_, catch): &(State, Catch)| catch.edge == edge && catch.steps != 0;
    throws.iter().enumerate().filter(|(_, throw)| is_arrival(throw)).map(|(place, _)| place + 1).collect()
}

/// The most frequent order of edges from one arrival to the next.
fn pattern(throws: &[(State, Catch)], arrivals: &[usize]) -> Vec<usize> {
    let mut orders: BTreeMap<Vec<usize>, usize> = BTreeMap::new();
    for pair in arrivals.windows(2) {
        let flips = throws[pair[0]..pair[1]].iter().filter(|(_, catch)| catch.steps != 0);
        *orders.entry(flips.map(|(at, _)| at.0).collect()).or_default() += 1;
    }
    orders
        .into_iter()
        .max_by_key(|(order, count)| (*count, std::cmp::Reverse(order.len())))
        .map_or(Vec::new(), |(order, _)| order)
}

/// Throws until an orbit stays within the bands, a hundredth of the part radius added.
fn transient(orbit: &Orbit, bands: &BTreeMap<usize, [f64; 2]>, part_radius: f64) -> usize {
    let slack = 0.01 * part_radius;
    let is_outside = |((edge, radius), _): &(State, Catch)| {
        bands.get(edge).is_none_or(|[low, high]| *radius < low - slack || *radius > high + slack)
    };
    orbit.throws.iter().rposition(is_outside).map_or(0, |last| last + 1)
}

/// The period of an orbit that has come to repeat itself.
fn period(throws: &[(State, Catch)], part_radius: f64) -> Option<usize> {
    let is_same = |a: &State, b: &State| a.0 == b.0 && (a.1 - b.1).abs() <= 1e-9 * part_radius;
    let last = throws.len() - 1;
    let repeats = |period: usize| (0..2 * period).all(|k| is_same(&throws[last - k].0, &throws[last - k - period].0));
    (1..=LONGEST_PERIOD.min(last / 3)).find(|period| repeats(*period))
}
