//! Which offset and release speed of the arm feed most parts, with room to err.
//!
//! Settings are compared in doubles, by short orbits; only of the best ones the pattern is proved.

use super::limit::{self, Length};
use super::reach::{ranges, reach};
use super::sensor::sensor;
use super::system::System;
use super::{Sweep, proof};
use crate::answer::{BestSetting, Certificate, Design, LimitSet, SensorWindow, Setting, SettingKind};
use crate::exact::{Q, Z, from_float_exact, to_f64};
use crate::geometry::difference;
use crate::mechanics::throwing::Settling;
use crate::model::Thrower;
use num_traits::Zero as _;
use rayon::prelude::*;
use std::collections::BTreeMap;

/// How long orbits are followed at each setting.
const SHORT: Length = Length { transient: 200, followed: 600, timed: 40 };
/// Starts on each stable edge.
const STARTS: usize = 2;
/// Settings computed between two looks at the watch.
const AT_ONCE: usize = 32;
/// Settings whose margins are looked at.
const MOST_CANDIDATES: usize = 200;
/// Settings for which a proof is tried.
const MOST_PROOFS: usize = 8;

/// The part that is thrown, and how.
pub(super) struct Thrown<'a> {
    pub(super) hull: &'a [[Q; 2]],
    pub(super) center_of_mass: &'a [Q; 2],
    pub(super) tolerance: &'a Q,
    pub(super) rho2: &'a Q,
    pub(super) classes: &'a [Vec<usize>],
    pub(super) thrower: &'a Thrower,
    pub(super) settling: Settling,
}

/// Tries all settings, and looks for the one with most parts a second that keeps the margin.
pub(super) fn design(thrown: &Thrown, sweep: &Sweep, watch: &mut dyn FnMut(usize, usize) -> bool) -> Design {
    let (offsets, releases) = (values(&sweep.offset, sweep.grid), values(&sweep.release, sweep.grid));
    let places: Vec<usize> = (0..offsets.len() * releases.len()).collect();
    let control = |place: usize| [&offsets[place / releases.len()], &releases[place % releases.len()]];
    let mut tried: Vec<Tried> = Vec::new();
    for some in places.chunks(AT_ONCE) {
        if !watch(tried.len(), places.len()) {
            break;
        }
        let more = some.par_iter().map(|place| thrown.tried(control(*place), thrown.center_of_mass));
        tried.extend(more.collect::<Vec<_>>());
    }
    let margin = to_f64(&sweep.margin);
    let (best, why_none) = match tried.len() == places.len() {
        true => thrown.best(&tried, control, &sweep.margin, watch),
        false => (None, Some("the sweep was stopped".to_owned())),
    };
    let mut settings: Vec<Setting> = tried.into_iter().map(|tried| tried.setting).collect();
    settings.resize(places.len(), untried());
    let [offsets, releases] = [&offsets, &releases].map(|values| values.iter().map(to_f64).collect());
    Design { offsets, releases, settings, margin, best, why_none }
}

/// Values from one end of a range to the other.
fn values([from, to]: &[Q; 2], count: usize) -> Vec<Q> {
    let last = count.max(2) - 1;
    let share = |k: usize| Q::new(Z::from(k), Z::from(last));
    if from == to { vec![from.clone()] } else { (0..=last).map(|k| from + (to - from) * share(k)).collect() }
}

/// A setting that was tried, with all windows of the sensor by edge.
struct Tried {
    setting: Setting,
    windows: Vec<(usize, [f64; 2])>,
}

impl From<Setting> for Tried {
    fn from(setting: Setting) -> Self {
        Self { setting, windows: Vec::new() }
    }
}

fn untried() -> Setting {
    Setting {
        kind: SettingKind::Open,
        parts_per_throw: 0.0,
        seconds_per_throw: f64::INFINITY,
        edge: None,
        window: None,
        grasp_margin: 0.0,
        friction: f64::INFINITY,
    }
}

impl Thrown<'_> {
    /// What becomes of the part with this offset and release speed.
    fn tried(&self, control: [&Q; 2], center_of_mass: &[Q; 2]) -> Tried {
        let system = self.system(control, center_of_mass);
        if !system.is_in_range() || system.stable.is_empty() {
            return Setting { kind: SettingKind::Lost, ..untried() }.into();
        }
        let reach = reach(&system);
        let found = limit::limit_sets(&system, &reach, STARTS, SHORT, &mut |_, _| true);
        let z = ranges(&reach);
        let Some(set) = found.sets.first().filter(|_| found.is_unique_in_reach) else {
            let is_lost = found.sets.is_empty() || found.ended.iter().any(|end| is_in(&z, end.start));
            return Setting { kind: if is_lost { SettingKind::Lost } else { SettingKind::Several }, ..untried() }
                .into();
        };
        let windows = sensor(0, set, &system, self.classes, &z, &Certificate::default()).windows;
        let best = windows.iter().max_by(|a, b| rate(a).total_cmp(&rate(b))).filter(|best| rate(best) > 0.0);
        let setting = Setting {
            kind: if best.is_some() { SettingKind::Feeder } else { SettingKind::Blind },
            parts_per_throw: best.map_or(0.0, rate),
            seconds_per_throw: set.seconds_per_throw,
            edge: best.map(|best| best.edges[0]),
            window: best.map(|best| best.range),
            grasp_margin: grasp_margin(&system, set),
            friction: friction(&system, set),
        };
        Tried { setting, windows: windows.iter().map(|window| (window.edges[0], window.range)).collect() }
    }

    fn system(&self, [offset, release]: [&Q; 2], center_of_mass: &[Q; 2]) -> System {
        let thrower = Thrower { offset: offset.clone(), release_deg_per_s: release.clone(), ..self.thrower.clone() };
        System::new(self.hull, center_of_mass, self.rho2, &thrower, self.settling).0
    }

    /// The best setting that keeps the margin, one that is proved before others; else why there is none.
    fn best<'q>(
        &self,
        tried: &[Tried],
        control: impl Fn(usize) -> [&'q Q; 2],
        margin: &Q,
        watch: &mut dyn FnMut(usize, usize) -> bool,
    ) -> (Option<BestSetting>, Option<String>) {
        let none = |why: &str| (None, Some(why.to_owned()));
        let is_feeder = |place: &usize| tried[*place].setting.kind == SettingKind::Feeder;
        let feeders: Vec<usize> = (0..tried.len()).filter(is_feeder).collect();
        if feeders.is_empty() {
            return none("at no setting all starts that were tried come to one pattern that a sensor reads");
        }
        let is_held = |place: &usize| self.is_held(&tried[*place].setting, to_f64(margin));
        let mut held: Vec<usize> = feeders.into_iter().filter(is_held).collect();
        if held.is_empty() {
            return none("no setting that feeds keeps the margin in the radius of a grasp and in friction");
        }
        held.sort_by(|a, b| tried[*b].setting.rate().total_cmp(&tried[*a].setting.rate()));
        let controls: Vec<[f64; 2]> = (0..tried.len()).map(|place| control(place).map(to_f64)).collect();
        let (size, share) = (to_f64(&self.size()), to_f64(margin));
        let is_near = |place: usize, other: usize| {
            let ([offset, release], [across, along]) = (controls[place], controls[other]);
            (offset - across).abs() <= size * share && (release - along).abs() <= release * share
        };
        let (mut unproved, mut proofs, mut candidates) = (None, 0, 0);
        for (number, &place) in held.iter().enumerate() {
            if candidates >= MOST_CANDIDATES || !watch(number, held.len()) {
                break;
            }
            let about = tried.iter().enumerate().filter(|(other, _)| is_near(place, *other)).map(|(_, tried)| tried);
            let Some(window) = self.common_window(&tried[place].setting, about) else { continue };
            candidates += 1;
            let others: Vec<Tried> = self
                .about(control(place), margin)
                .par_iter()
                .map(|([offset, release], center)| self.tried([offset, release], center))
                .collect();
            let within = Setting { window: Some(window), ..tried[place].setting.clone() };
            let Some(window) = self.common_window(&within, others.iter()) else { continue };
            if proofs < MOST_PROOFS {
                proofs += 1;
                let told = Setting { window: Some(window), ..within };
                let mut goes_on = || watch(number, held.len());
                if let Some(window) = self.proved_window(control(place), &told, &mut goes_on) {
                    return (Some(BestSetting { place, window, is_proved: true }), None);
                }
            }
            unproved = unproved.or(Some(BestSetting { place, window, is_proved: false }));
        }
        match unproved {
            Some(best) => (Some(best), None),
            None => none("no setting that feeds does so all over the margin about it, with one place of the sensor"),
        }
    }

    /// Whether the pattern stays away from slipping.
    fn is_held(&self, setting: &Setting, margin: f64) -> bool {
        let friction = self.thrower.friction.as_ref().map_or(f64::INFINITY, |friction| to_f64(&friction.min));
        setting.grasp_margin >= 1.0 + margin && setting.friction * (1.0 + margin) <= friction
    }

    /// The part of a setting's window that is proved to tell its edge; `None` if there is none, or the pattern is not proved.
    fn proved_window(
        &self,
        control: [&Q; 2],
        setting: &Setting,
        goes_on: &mut dyn FnMut() -> bool,
    ) -> Option<[f64; 2]> {
        let system = self.system(control, self.center_of_mass);
        let reach = reach(&system);
        let proof = proof::certify(&system, &reach, proof::RESOLUTION, &mut |_, _| goes_on());
        let found = limit::limit_sets(&system, &reach, STARTS, SHORT, &mut |_, _| true);
        let set = found.sets.first().filter(|_| proof.is_unique)?;
        let windows = sensor(0, set, &system, self.classes, &proof.starts, &proof).windows;
        let windows = windows.iter().filter_map(|window| Some((window.edges[0], window.proved?))).collect();
        self.common_window(setting, std::iter::once(&Tried { setting: setting.clone(), windows }))
    }

    /// Settings at the ends of the margin about one, and that one with the center of mass at the ends of its tolerance. The
    /// release speed is off by the share `margin`, the offset by that of the part radius.
    fn about(&self, [offset, release]: [&Q; 2], margin: &Q) -> Vec<([Q; 2], [Q; 2])> {
        let mut about = Vec::new();
        let signs = [-1, 0, 1].map(|sign| Q::from(Z::from(sign)));
        for across in &signs {
            for along in &signs {
                let controls = [offset + self.size() * margin * across, release + release * margin * along];
                let is_other = !across.is_zero() || !along.is_zero();
                if is_other && !margin.is_zero() {
                    about.push((controls, self.center_of_mass.clone()));
                }
                if !self.tolerance.is_zero() && !across.is_zero() && !along.is_zero() {
                    let [x, y] = self.center_of_mass;
                    let moved = [x + self.tolerance * across, y + self.tolerance * along];
                    about.push(([offset.clone(), release.clone()], moved));
                }
            }
        }
        about
    }

    /// Radii at which a sensor tells the edge of a setting there and at all others.
    fn common_window<'t>(&self, setting: &Setting, others: impl Iterator<Item = &'t Tried>) -> Option<[f64; 2]> {
        let class = |edge: usize| self.classes.iter().position(|class| class.contains(&edge));
        let own = class(setting.edge?);
        let mut common = setting.window?;
        for other in others {
            let same = other.windows.iter().filter(|(edge, _)| class(*edge) == own);
            let shared = same.map(|(_, [low, high])| [common[0].max(*low), common[1].min(*high)]);
            common = shared.max_by(|a, b| (a[1] - a[0]).total_cmp(&(b[1] - b[0])))?;
        }
        Some(common).filter(|[low, high]| low < high)
    }

    /// Part radius, to double precision.
    fn size(&self) -> Q {
        let distance2 = |corner: &[Q; 2]| {
            let [x, y] = difference(self.center_of_mass, corner);
            to_f64(&(&x * &x + &y * &y))
        };
        let radius = self.hull.iter().map(distance2).fold(0.0, f64::max).sqrt();
        from_float_exact(radius).unwrap_or_else(Q::zero)
    }
}

/// Delivered parts a throw: each comes to the arm anew, and is told once the sensor may be trusted.
fn rate(window: &SensorWindow) -> f64 {
    // the throw that brings the part to the sensor counts, too
    let rate = 1.0 / (window.throws_from_start + 1.0);
    if rate.is_finite() { rate } else { 0.0 }
}

/// Least ratio of a radius in the set to the least radius of a grasp.
fn grasp_margin(system: &System, set: &LimitSet) -> f64 {
    let margin = |(edge, [low, _]): (&usize, &[f64; 2])| Some(low / system.lows(*edge)?[0]);
    set.bands.iter().filter_map(margin).fold(f64::INFINITY, f64::min)
}

/// Least friction with which all of the set is grasped, (2) and (4).
fn friction(system: &System, set: &LimitSet) -> f64 {
    let needed = |(edge, [low, _]): (&usize, &[f64; 2])| system.over_pivot(*edge) / low;
    set.bands.iter().map(needed).fold(0.0, f64::max)
}

fn is_in(z: &BTreeMap<usize, Vec<[f64; 2]>>, (edge, radius): (usize, f64)) -> bool {
    z.get(&edge).is_some_and(|ranges| ranges.iter().any(|[from, to]| *from <= radius && radius <= *to))
}
